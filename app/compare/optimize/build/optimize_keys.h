/*
 * The channels of one animation: reads them, and chooses the keys to keep.
 */
#ifndef APP_COMPARE_OPTIMIZE_BUILD_OPTIMIZE_KEYS_H
#define APP_COMPARE_OPTIMIZE_BUILD_OPTIMIZE_KEYS_H

#include "app/compare/optimize/build/optimize_build.h"
#include "app/compare/optimize/build/optimize_track.h"

struct optimize_channel {
	json_t *target; /* of the channel in the file; not owned */
	struct optimize_track track;
	struct gltf_document_array output;
	float *time_s, *value; /* the arrays of track; owned */
	float unit; /* the integer that stands for 1 in the file, or 1 */
	int group;  /* the first channel with equal times, or -1 */
	bool constant, dropped;
	bool ends; /* a constant channel whose last key is the clip's end */
	int *kept; /* [kept_count]: indices of keys */
	int kept_count;
	int times, values; /* indices of new accessors */
	int sampler;       /* the index of the new sampler */
	int next;          /* the next channel in the same bucket, or -1 */
	int number;        /* the channel's index in the file */
};

/* One animation. */
struct optimize_keys {
	struct optimize_build *build;
	json_t *json;
	float bound_px;
	int count;
	struct optimize_channel *channel;
	/* [count]: channels with a sampler of their own, by values; or -1 */
	int *bucket;
	float end_s;
};

/* glTF's names, by enum model_path and enum model_interpolation. */
extern const char *const optimize_path_name[4];
extern const char *const optimize_interpolation_name[3];

/*
 * Reads the animation with this index. Returns 0, or -errno after logging an
 * error; the caller calls optimize_keys_release() in either case.
 */
int optimize_keys_read(struct optimize_build *build, json_t *animation,
	size_t index, struct optimize_keys *keys);

void optimize_keys_release(struct optimize_keys *keys);

/*
 * Sets moved[4 * node + path] for each path that the animation moves away from
 * rest. A channel is left out only if no animation moves its path, because the
 * player may mix animations.
 */
void optimize_keys_find_moved(const struct optimize_keys *keys, bool *moved);

/* Chooses the keys to write. Returns 0 or -ENOMEM. */
int optimize_keys_choose(struct optimize_keys *keys, const bool *moved);

/* Chooses all keys. Returns 0 or -ENOMEM. */
int optimize_keys_keep_all(struct optimize_keys *keys);

#endif
