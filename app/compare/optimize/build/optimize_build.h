/*
 * Writes a document anew with the precision of a plan.
 */
#ifndef APP_COMPARE_OPTIMIZE_BUILD_OPTIMIZE_BUILD_H
#define APP_COMPARE_OPTIMIZE_BUILD_OPTIMIZE_BUILD_H

#include "app/compare/optimize/build/optimize_output.h"
#include "app/compare/optimize/optimize_order.h"
#include "app/compare/optimize/optimize_reach.h"
#include "app/compare/optimize/optimize_scale.h"

/* How exact the file shall be. */
struct optimize_plan {
	bool directions;   /* 8 bits; coordinates, colours and joints in 16 */
	bool weights;      /* of joints in 16 bits */
	bool byte_weights; /* in 8 bits */
	bool positions;    /* in 16 bits */
	bool rotations;    /* and weights of targets in 16 bits */
	/*
	 * [clips]: the largest error of a key, in pixels at the node's farthest
	 * vertex. 0 keeps every key that is not exactly between its neighbours.
	 */
	const float *key_px;
	/* What the file says about its error from now on; below 0: nothing. */
	float stated_px;
};

struct optimize_build {
	const struct gltf_document *document;
	const struct optimize_order *order;
	const struct optimize_scale *scale;
	const struct optimize_reach *reach; /* NULL keeps all keys */
	const struct optimize_plan *plan;
	json_t *root; /* of the new file, with the numbers of old accessors */
	struct optimize_output output;
};

/*
 * Returns the file's bytes, which the caller frees. 0, or -errno after logging
 * an error about path.
 */
int optimize_build(struct optimize_build *build, const char *path,
	const struct log *log, uint8_t **data, size_t *size);

/* The parts of optimize_build(), each for one array of the root object. */

/* optimize_vertices.c: replaces the accessors of meshes, skins, and scales. */
int optimize_build_meshes(struct optimize_build *build);
int optimize_build_skins(struct optimize_build *build);

/* optimize_keys.c: replaces samplers and channels. */
int optimize_build_animations(struct optimize_build *build);

/* optimize_build_member.c */

/* The number of an accessor that a member names, or -1. */
int optimize_build_member(const struct optimize_build *build,
	const json_t *object, const char *key);

/* Sets a member to the number of a new accessor. */
void optimize_build_set(struct optimize_build *build, json_t *object,
	const char *key, int accessor);

/* The unit of a mesh's positions in this plan; 0: they stay as they are. */
float optimize_build_unit(const struct optimize_build *build, const float *unit);

#endif
