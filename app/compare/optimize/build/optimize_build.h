/*
 * Writes a glTF document again with the precision of a plan.
 */
#ifndef APP_COMPARE_OPTIMIZE_BUILD_OPTIMIZE_BUILD_H
#define APP_COMPARE_OPTIMIZE_BUILD_OPTIMIZE_BUILD_H

#include "app/compare/optimize/build/optimize_output.h"
#include "app/compare/optimize/optimize_order.h"
#include "app/compare/optimize/optimize_reach.h"
#include "app/compare/optimize/optimize_scale.h"

/*
 * The precision of the file. Where a member is false, numbers stay as they are.
 */
struct optimize_plan {
	bool directions;   /* 8 bits, joints too; coordinates, colours 16 */
	bool weights;      /* of joints: in 16 bits */
	bool byte_weights; /* of joints: in 8 bits if weights is set */
	bool positions;    /* in 16 bits */
	bool rotations;    /* and weights of targets: in 16 bits */
	/*
	 * [clips]: the largest error of a key, in pixels at the node's farthest
	 * vertex. 0 keeps every key that is not exactly between its neighbours.
	 */
	const float *key_px;
	/* The value of asset.extras.limber_error_px; below 0: not written. */
	float stated_px;
};

struct optimize_build {
	const struct gltf_document *document;
	const struct optimize_order *order;
	const struct optimize_scale *scale;
	const struct optimize_reach *reach; /* NULL keeps all keys */
	const struct optimize_plan *plan;
	json_t *root; /* of the new file; refers to old accessors until rebuilt */
	struct optimize_output output;
};

/*
 * Makes the file in *data, which the caller frees. Returns 0, or -errno after
 * logging an error that names path.
 */
int optimize_build(struct optimize_build *build, const char *path,
	const struct log *log, uint8_t **data, size_t *size);

/* The steps of optimize_build(), each for one array of the root object. */

/* Replace the accessors of meshes, and the matrices of skins. 0 or -errno. */
int optimize_build_meshes(struct optimize_build *build);
int optimize_build_skins(struct optimize_build *build);

/* Replaces samplers and channels. Returns 0 or -errno. */
int optimize_build_animations(struct optimize_build *build);

/* optimize_build_member.c */

/* The index of the accessor that a member refers to, or -1. */
int optimize_build_member(const struct optimize_build *build,
	const json_t *object, const char *key);

/* Sets a member to the index of a new accessor, unless that is -1. */
void optimize_build_set(struct optimize_build *build, json_t *object,
	const char *key, int accessor);

/* *unit, or 0 if positions stay as they are in this plan. */
float optimize_build_unit(const struct optimize_build *build, const float *unit);

#endif
