/*
 * The channels of one animation: read, reduced to the keys that suffice, and
 * written.
 */
#ifndef APP_COMPARE_OPTIMIZE_BUILD_OPTIMIZE_KEYS_H
#define APP_COMPARE_OPTIMIZE_BUILD_OPTIMIZE_KEYS_H

#include "app/compare/optimize/build/optimize_build.h"
#include "app/compare/optimize/build/optimize_track.h"

struct optimize_channel {
	json_t *target; /* of the file's channel; not owned */
	struct optimize_track track;
	struct gltf_document_array output;
	float *time_s, *value; /* of the track */
	float unit;            /* what stands for 1 in the file */
	int group;             /* of channels with equal times */
	bool constant, dropped;
	int *kept; /* [kept_count]: numbers of keys */
	int kept_count;
	int times, values; /* new accessors */
	int number;        /* in the file */
};

/* One animation. */
struct optimize_keys {
	struct optimize_build *build;
	json_t *json;
	float bound_px;
	int count;
	struct optimize_channel *channel;
	float end_s;
};

/* By enum model_path and enum model_interpolation: glTF's names. */
extern const char *const optimize_path_name[4];
extern const char *const optimize_interpolation_name[3];

/*
 * Reads the animation of this number. Returns 0, or -errno after logging an
 * error; the caller calls optimize_keys_release() in either case.
 */
int optimize_keys_read(struct optimize_build *build, json_t *animation,
	size_t index, struct optimize_keys *keys);

void optimize_keys_release(struct optimize_keys *keys);

/*
 * Marks in moved, [nodes][4] by path, what the animation moves away from rest.
 * Only what none does is left out of all, as animations may be mixed.
 */
void optimize_keys_find_moved(const struct optimize_keys *keys, bool *moved);

/* Chooses the keys to write. Returns 0 or -ENOMEM. */
int optimize_keys_choose(struct optimize_keys *keys, const bool *moved);

/* Chooses all keys. Returns 0 or -ENOMEM. */
int optimize_keys_keep_all(struct optimize_keys *keys);

#endif
