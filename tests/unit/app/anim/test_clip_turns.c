/*
 * clip_pose(), clip_mix() and clip_add_paths() with rotations of both kinds of
 * keys next to all other channels.
 */
#include "app/anim/clip.h"
#include "app/anim/math/transform.h"
#include "app/anim/pose_blend.h"
#include "app/anim/turns.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	NODES = 4,
	CHANNELS = 8
};

/* Each channel has one key less than there are, which must not show. */
static const float EARLY_S[4] = {0.25f, 0.75f, 1.75f, 3};
static const float LATE_S[4] = {0.5f, 1, 2, 4};
static const float POINTS[12] = {1, 2, 3, 4, 6, 8, -5, 7, -9, 90, 91, 92};
static const float SIZES[12] = {1, 2, 3, 2, 2, 2, 4, 5, 1, 90, 91, 92};
static const float AROUND_X[16] = {
	0, 0, 0, 1, 0.6f, 0, 0, 0.8f, 0.8f, 0, 0, 0.6f, 1, 0, 0, 0};
static const float AROUND_Y[16] = {
	0, 0.6f, 0, 0.8f, 0, 0, 0, 1, 0, 0.28f, 0, 0.96f, 0, 1, 0, 0};
static const int16_t PACKED_X[4][4] = {{0, 0, 0, 32767}, {9175, 0, 0, 31456},
	{19660, 0, 0, 26214}, {32767, 0, 0, 0}};
static const int16_t PACKED_Z[4][4] = {{0, 0, 9175, 31456}, {0, 0, 0, 32767},
	{0, 0, -9175, 31456}, {0, 0, 32767, 0}};
static const float FADE[4] = {0.125f, 0.5f, 0.75f, 90};
static const float TWO_FADES[8] = {0, 1, 0.5f, 0.25f, 1, 0.125f, 90, 91};
/* Before, at, between and beyond all keys. */
static const float WHEN_S[] = {-1, 0, 0.25f, 0.4f, 0.5f, 0.7f, 0.75f, 0.9f, 1,
	1.5f, 1.75f, 1.9f, 2, 2.5f, 9, 0.1f, NAN, -0.0f};

struct fixture {
	struct model_node node[NODES];
	struct model_mesh mesh[2];
	float weights[4];
	struct model_channel channel[CHANNELS];
	struct model_clip clip;
	struct model model;
	struct arena arena;
	struct pose pose, want;
	struct clip_cursor cursor;
};

static void begin(struct fixture *f)
{
	assert_int_equal(clip_cursor_init(&f->cursor, &f->model, &f->arena), 0);
	pose_rest(&f->pose, &f->model);
	pose_rest(&f->want, &f->model);
}

static void add_nodes_and_keys(struct fixture *f)
{
	for (int i = 0; i < NODES; i++) {
		float at = 0.1f * (float)(i + 1);

		f->node[i] = (struct model_node){.name = "",
			.parent = -1,
			.mesh = i < 2 ? i : -1,
			.weight_offset = i,
			.skin = -1,
			.rest = {{at, 2 * at, 3 * at}, {0, 0, 0.6f, 0.8f},
				{1 + at, 1 - at, 2}}};
	}
	for (int i = 0; i < CHANNELS; i++) {
		static const int widths[] = {3, 4, 3, 1};
		struct model_channel *channel = &f->channel[i];

		channel->interpolation = MODEL_LINEAR;
		channel->key_count = 3;
		channel->width = widths[channel->path];
	}
	f->channel[7].width = 2;
	f->clip.channel = f->channel;
}

/* Turns of float and packed keys take turns, as do their times. */
static void set_up(struct fixture *f)
{
	*f = (struct fixture){
		.mesh = {{.target_count = 1}, {.target_count = 2}},
		.weights = {0.5f, 0.25f, 0.125f, 0.0625f},
		.channel = {{.node = 0,
				    .path = MODEL_ROTATION,
				    .unit = true,
				    .time_s = EARLY_S,
				    .packed = PACKED_X},
			{.node = 1,
				.path = MODEL_ROTATION,
				.unit = true,
				.time_s = LATE_S,
				.value = AROUND_X},
			{.node = 2,
				.path = MODEL_ROTATION,
				.unit = true,
				.time_s = EARLY_S,
				.value = AROUND_Y},
			{.node = 3,
				.path = MODEL_ROTATION,
				.unit = true,
				.time_s = LATE_S,
				.packed = PACKED_Z},
			{.node = 1,
				.path = MODEL_TRANSLATION,
				.time_s = LATE_S,
				.value = POINTS},
			{.node = 2,
				.path = MODEL_SCALE,
				.time_s = EARLY_S,
				.value = SIZES},
			{.node = 0,
				.path = MODEL_WEIGHTS,
				.time_s = LATE_S,
				.value = FADE},
			{.node = 1,
				.path = MODEL_WEIGHTS,
				.time_s = EARLY_S,
				.value = TWO_FADES}},
		.clip = {.duration_s = 2, .channel_count = CHANNELS},
	};
	add_nodes_and_keys(f);
	f->model = (struct model){.node_count = NODES,
		.node = f->node,
		.mesh_count = 2,
		.mesh = f->mesh,
		.clip_count = 1,
		.clip = &f->clip,
		.weight_count = 4,
		.rest_weights = f->weights};
	assert_int_equal(pose_init(&f->pose, &f->model, &f->arena), 0);
	assert_int_equal(pose_init(&f->want, &f->model, &f->arena), 0);
	begin(f);
}

/* Packed rotations are 1 long to within 4e-5. */
static void assert_like(const struct pose *pose, const struct pose *want)
{
	for (int n = 0; n < NODES; n++) {
		assert_all_near((const float *)&pose->local[n],
			(const float *)&want->local[n], 10, 5e-5);
		assert_int_equal(pose->animated[n], want->animated[n]);
	}
	assert_all_near(pose->weight, want->weight, want->weight_count, 1e-6);
}

static void check_whole_pose(struct fixture *f)
{
	for (size_t i = 0; i < ARRAY_COUNT(WHEN_S); i++) {
		struct clip_cursor none = {0};

		pose_rest(&f->want, &f->model);
		clip_sample(&f->clip, WHEN_S[i], &none, &f->want);
		memset(f->pose.local, 0x55, sizeof(f->want.local[0]));
		clip_pose(&f->clip, WHEN_S[i], CLIP_AUTO, &f->cursor, &f->pose);
		assert_like(&f->pose, &f->want);
	}
}

static void test_a_whole_pose_has_turns_of_both_kinds(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	check_whole_pose(&f);
	f.channel[0].interpolation = MODEL_STEP;
	f.channel[2].interpolation = MODEL_STEP;
	begin(&f);
	check_whole_pose(&f);
	arena_release(&f.arena);
}

static void test_rotations_of_one_kind_are_enough(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	f.clip.channel = f.channel + 3;
	f.clip.channel_count = 1;
	check_whole_pose(&f);
	begin(&f);
	f.clip.channel = f.channel + 2;
	check_whole_pose(&f);
	arena_release(&f.arena);
}

static void test_rotations_may_begin_before_0(void **state)
{
	static const float before_s[4] = {-0.5f, 0.75f, 1.75f, 3};
	struct fixture f;

	(void)state;
	set_up(&f);
	f.channel[0].time_s = f.channel[2].time_s = before_s;
	clip_pose(&f.clip, -0.25f, CLIP_AUTO, &f.cursor, &f.pose);
	clip_sample(&f.clip, -0.25f, &f.cursor, &f.want);
	assert_like(&f.pose, &f.want);
	assert_true(f.pose.local[0].rotation[0] > 0.01f);
	arena_release(&f.arena);
}

/* Of those of one kind, as neighbours with the same times search once. */
static void test_turns_with_the_same_times_are_neighbours(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	for (int i = 0; i < CHANNELS; i++) {
		int at = i % 4;

		f.channel[i] = f.channel[at];
		f.channel[i].node = i % NODES;
		f.channel[i].value = AROUND_X;
		f.channel[i].packed = i < 5 ? NULL : PACKED_X;
		f.channel[i].time_s = i % 2 ? EARLY_S : LATE_S;
	}
	f.channel[6].time_s = f.channel[7].time_s = EARLY_S;
	f.channel[5].time_s = LATE_S;
	clip_pose(&f.clip, 1, CLIP_AUTO, &f.cursor, &f.pose);
	assert_true(f.cursor.begun);
	assert_int_equal(f.cursor.turn_count, CHANNELS);
	assert_int_equal(f.cursor.float_turn_count, 5);
	for (int i = 1, changes = 0; i < CHANNELS; i++) {
		const struct turn *turn = f.cursor.turn + i;
		bool changed = turn->time_s != turn[-1].time_s;

		changes = i == 5 ? 0 : changes + changed;
		assert_in_range(changes, 0, 1);
	}
	arena_release(&f.arena);
}

static void test_a_change_of_clips_drops_the_turns_before(void **state)
{
	struct fixture f;
	struct model_clip other;

	(void)state;
	set_up(&f);
	other = f.clip;
	other.channel = f.channel + 4;
	other.channel_count = 4;
	clip_pose(&f.clip, 1, CLIP_AUTO, &f.cursor, &f.pose);
	clip_pose(&other, 1, CLIP_AUTO, &f.cursor, &f.pose);
	clip_sample(&other, 1, &f.cursor, &f.want);
	assert_like(&f.pose, &f.want);
	clip_mix(&other, 1, CLIP_AUTO, 1, &f.cursor, &f.pose);
	assert_like(&f.pose, &f.want);
	clip_mix(NULL, 1, CLIP_STEP, 1, &f.cursor, &f.pose);
	for (int n = 0; n < NODES; n++) {
		assert_all_near((const float *)&f.pose.local[n],
			(const float *)&f.node[n].rest, 10, 1e-6);
	}
	arena_release(&f.arena);
}

/* A cursor keeps what it has found out only if the clip fits. */
static void test_a_cursor_begins_clips_that_fit(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	for (int room = CHANNELS - 1; room <= CHANNELS + 1; room++) {
		begin(&f);
		f.cursor.channel_count = room;
		check_whole_pose(&f);
		assert_int_equal(f.cursor.begun, room >= CHANNELS);
	}
	arena_release(&f.arena);
}

/* Nodes 0 and 2 have no weight, though the clip moves them. */
static void test_nodes_without_weight_keep_their_first_key(void **state)
{
	static const float only[NODES] = {0, 1, 0, 0.5f};
	struct fixture f;

	(void)state;
	set_up(&f);
	f.cursor.only = only;
	for (size_t i = 0; i < ARRAY_COUNT(WHEN_S); i++) {
		struct clip_cursor none = {0};

		pose_rest(&f.want, &f.model);
		clip_sample(&f.clip, WHEN_S[i], &none, &f.want);
		for (int c = 0; c < CHANNELS; c++) {
			const struct model_channel *channel = &f.channel[c];
			int node = channel->node, key = 0;
			struct transform *local = &f.want.local[node];

			if (node % 2 == 0) {
				clip_sample_channel(channel, 0, CLIP_AUTO, &key,
					channel->path == MODEL_WEIGHTS
						? f.want.weight + node
						: channel->path == MODEL_SCALE
						? local->scale
						: local->rotation);
			}
		}
		clip_pose(&f.clip, WHEN_S[i], CLIP_AUTO, &f.cursor, &f.pose);
		assert_like(&f.pose, &f.want);
	}
	arena_release(&f.arena);
}

static void check_mix(struct fixture *f, enum clip_interpolation as,
	const float *only, float time_s)
{
	struct pose clip;

	assert_int_equal(pose_init(&clip, &f->model, &f->arena), 0);
	begin(f);
	clip_sample_as(&f->clip, time_s, as, &f->cursor, &clip);
	pose_mix(&f->want, &clip, 0.5f, only, &f->want);
	f->cursor.only = only;
	clip_mix(&f->clip, time_s, as, 0.5f, &f->cursor, &f->pose);
	for (int n = 0; n < NODES; n++) {
		struct transform *local = &f->pose.local[n];

		/* Rotations are mixed straight, which is off by less. */
		assert_all_near(local->rotation, f->want.local[n].rotation, 4,
			only && only[n] == 0 ? 0 : 0.01);
		memcpy(local->rotation, f->want.local[n].rotation,
			sizeof(local->rotation));
	}
	assert_like(&f->pose, &f->want);
}

static void test_mixing_is_mixing_the_pose_also_for_turns(void **state)
{
	static const float only[NODES] = {0, 1, 0.5f, 0.25f};
	static const float others[NODES] = {1, 0, 0.75f, 0};
	struct fixture f;

	(void)state;
	set_up(&f);
	for (size_t i = 0; i < ARRAY_COUNT(WHEN_S); i++) {
		for (int as = CLIP_AUTO; as <= CLIP_CUBIC; as++) {
			enum clip_interpolation way =
				(enum clip_interpolation)as;

			check_mix(&f, way, NULL, WHEN_S[i]);
			check_mix(&f, way, only, WHEN_S[i]);
			check_mix(&f, way, others, WHEN_S[i]);
		}
	}
	arena_release(&f.arena);
}

/* Of the paths in the bits; node 2 has none. */
static void check_paths(struct fixture *f, unsigned bits)
{
	uint8_t paths[NODES];
	struct pose whole;

	assert_int_equal(pose_init(&whole, &f->model, &f->arena), 0);
	begin(f);
	clip_sample(&f->clip, 1.5f, &f->cursor, &whole);
	for (int n = 0; n < NODES; n++) {
		struct transform *to = &f->want.local[n];

		paths[n] = (uint8_t)(n == 2 ? 0 : bits);
		if (n != 2 && bits & 1 << MODEL_TRANSLATION) {
			memcpy(to->translation, whole.local[n].translation, 12);
		}
		if (n != 2 && bits & 1 << MODEL_ROTATION) {
			memcpy(to->rotation, whole.local[n].rotation, 16);
		}
		if (n != 2 && bits & 1 << MODEL_SCALE) {
			memcpy(to->scale, whole.local[n].scale, 12);
		}
		f->want.animated[n] = whole.animated[n] && n != 2 &&
			(bits & 7 || (n < 2 && bits));
	}
	if (bits & 1 << MODEL_WEIGHTS) {
		memcpy(f->want.weight, whole.weight, 4 * sizeof(float));
	}
	f->cursor.paths = paths;
	clip_mix(&f->clip, 1.5f, CLIP_AUTO, 1, &f->cursor, &f->pose);
	assert_like(&f->pose, &f->want);
}

static void test_mixing_changes_each_path_alone(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	/* No turns: all channels go through the paths. */
	for (int i = 0; i < 4; i++) {
		f.channel[i].unit = false;
	}
	f.channel[2].node = 0;
	f.channel[2].path = MODEL_SCALE;
	f.channel[2].width = 3;
	f.channel[2].value = SIZES;
	f.channel[5].node = 3;
	for (unsigned bits = 0; bits < 16; bits++) {
		check_paths(&f, bits);
	}
	arena_release(&f.arena);
}

/* Only node 3 is turned, and only the others are listed. */
static void test_a_node_without_weight_is_not_animated(void **state)
{
	static const float only[NODES] = {0, 1, 1, 1};
	struct fixture f;

	(void)state;
	set_up(&f);
	f.clip.channel = f.channel + 3;
	f.clip.channel_count = 1;
	f.cursor.only = only;
	clip_mix(&f.clip, 1, CLIP_AUTO, 1, &f.cursor, &f.pose);
	for (int n = 0; n < NODES; n++) {
		assert_int_equal(f.pose.animated[n], n == 3);
	}
	arena_release(&f.arena);
}

/* The fifth number of each is beyond the value, and beside its rest. */
static void test_constants_at_rest_change_no_path(void **state)
{
	static const int widths[] = {3, 4, 3};
	float value[5];
	struct fixture f;

	(void)state;
	set_up(&f);
	f.clip.channel_count = 1;
	f.channel[0].packed = NULL;
	f.channel[0].value = value;
	f.channel[0].constant = true;
	f.channel[0].key_count = 1;
	for (int path = MODEL_TRANSLATION; path <= MODEL_SCALE; path++) {
		const struct transform *rest = &f.node[0].rest;
		const float *part = path == MODEL_TRANSLATION ? rest->translation
			: path == MODEL_ROTATION              ? rest->rotation
							      : rest->scale;
		int width = widths[path];

		f.channel[0].path = (enum model_path)path;
		f.channel[0].width = width;
		for (int i = -1; i <= width; i++) {
			uint8_t paths[NODES] = {1 << MODEL_WEIGHTS};
			int bit = i >= 0 && i < width ? 1 << path : 0;

			memcpy(value, part, (size_t)width * sizeof(*value));
			value[width] = 90;
			value[i < 0 ? width : i] += 1;
			clip_add_paths(&f.clip, &f.model, paths);
			assert_int_equal(paths[0], 1 << MODEL_WEIGHTS | bit);
		}
	}
	arena_release(&f.arena);
}

static void test_weights_and_moving_channels_may_change_a_path(void **state)
{
	uint8_t paths[NODES] = {0};
	struct fixture f;

	(void)state;
	set_up(&f);
	f.channel[6].constant = f.channel[7].constant = true;
	f.channel[6].value = f.weights;
	clip_add_paths(&f.clip, &f.model, paths);
	assert_int_equal(paths[0], 1 << MODEL_ROTATION | 1 << MODEL_WEIGHTS);
	assert_int_equal(paths[1],
		1 << MODEL_TRANSLATION | 1 << MODEL_ROTATION |
			1 << MODEL_WEIGHTS);
	assert_int_equal(paths[2], 1 << MODEL_ROTATION | 1 << MODEL_SCALE);
	assert_int_equal(paths[3], 1 << MODEL_ROTATION);
	arena_release(&f.arena);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_whole_pose_has_turns_of_both_kinds),
		cmocka_unit_test(test_rotations_of_one_kind_are_enough),
		cmocka_unit_test(test_rotations_may_begin_before_0),
		cmocka_unit_test(test_turns_with_the_same_times_are_neighbours),
		cmocka_unit_test(test_a_change_of_clips_drops_the_turns_before),
		cmocka_unit_test(test_a_cursor_begins_clips_that_fit),
		cmocka_unit_test(test_nodes_without_weight_keep_their_first_key),
		cmocka_unit_test(test_mixing_is_mixing_the_pose_also_for_turns),
		cmocka_unit_test(test_mixing_changes_each_path_alone),
		cmocka_unit_test(test_a_node_without_weight_is_not_animated),
		cmocka_unit_test(test_constants_at_rest_change_no_path),
		cmocka_unit_test(
			test_weights_and_moving_channels_may_change_a_path),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
