/*
 * An animation of three channels for tests of the choice of keys.
 */
#ifndef TESTS_UNIT_APP_COMPARE_OPTIMIZE_BUILD_KEYS_BENCH_H
#define TESTS_UNIT_APP_COMPARE_OPTIMIZE_BUILD_KEYS_BENCH_H

#include "app/compare/optimize/build/optimize_keys.h"
#include "tests/support/test.h"

#include <stdlib.h>

enum {
	KEYS = 40,
	CHANNELS = 3
};

static const struct optimize_reach_node reach = {
	.move_px = 100.0f, .turn_px = 50.0f, .scale_px = 20.0f};

/* Channels of translations, of which each moves a node of its own. */
struct fixture {
	struct optimize_build build;
	struct optimize_keys keys;
	struct optimize_channel channel[CHANNELS];
	float time_s[CHANNELS][KEYS], value[CHANNELS][KEYS][3];
	bool moved[CHANNELS][4];
};

static inline void begin(struct fixture *f)
{
	*f = (struct fixture){.keys = {.build = &f->build,
				      .count = CHANNELS,
				      .channel = f->channel}};
	f->build.root = json_pack("{s:[{},{},{}]}", "nodes");
	assert_non_null(f->build.root);
	for (int c = 0; c < CHANNELS; c++) {
		f->moved[c][MODEL_TRANSLATION] = true;
		for (int k = 0; k < KEYS; k++) {
			f->time_s[c][k] = 0.5f * (float)(k + c);
		}
		f->channel[c] = (struct optimize_channel){
			.target = json_pack("{s:i}", "node", c),
			.track = {.path = MODEL_TRANSLATION,
				.interpolation = MODEL_LINEAR,
				.width = 3,
				.key_count = KEYS,
				.time_s = f->time_s[c],
				.value = f->value[c][0],
				.reach = &reach},
			.time_s = f->time_s[c],
			.value = f->value[c][0]};
		assert_non_null(f->channel[c].target);
	}
	f->keys.end_s = f->time_s[CHANNELS - 1][KEYS - 1];
}

/* Lets a channel go up and down, with a bend at these keys. */
static inline void bend(struct fixture *f, int channel, int first, int second)
{
	float height = 0.0f;

	for (int k = 0; k < KEYS; k++) {
		f->value[channel][k][1] = height;
		height += k < first || k >= second ? 1.0f : -1.0f;
	}
}

static inline void choose(struct fixture *f)
{
	assert_int_equal(optimize_keys_choose(&f->keys, f->moved[0]), 0);
}

static inline void end(struct fixture *f)
{
	for (int c = 0; c < CHANNELS; c++) {
		free(f->channel[c].kept);
		json_decref(f->channel[c].target);
	}
	json_decref(f->build.root);
}

static inline void expect_kept(
	const struct fixture *f, int channel, const int *kept, int count)
{
	assert_int_equal(f->channel[channel].kept_count, count);
	for (int k = 0; k < count; k++) {
		assert_int_equal(f->channel[channel].kept[k], kept[k]);
	}
}

#endif
