#include "app/anim/clip.h"
#include "app/anim/math/transform.h"
#include "app/anim/pose_blend.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

/* Two nodes; the second has two morph weights after one of the first. */
struct fixture {
	struct model_node node[2];
	float weights[3];
	struct model_channel channel[3];
	struct model_clip clip;
	struct model model;
	struct arena arena;
	struct pose pose;
	struct clip_cursor cursor;
};

static const float TIMES[3] = {0.5f, 1, 3};
static const float POINTS[9] = {1, 2, 3, 11, 12, 13, 11, 22, 33};
static const float SPIN[8] = {0, 0, 0, 1, 0, 0, 1, 0};
static const float FADE[4] = {0, 1, 1, 0};
static const float SECONDS[2] = {0, 1};

static void set_up(struct fixture *f)
{
	*f = (struct fixture){.weights = {0.1f, 0.2f, 0.3f}};
	for (int i = 0; i < 2; i++) {
		f->node[i] = (struct model_node){.name = "",
			.parent = -1,
			.rest = transform_identity(),
			.mesh = -1,
			.skin = -1,
			.camera = -1};
	}
	f->node[0].rest.scale[1] = 4;
	f->node[1].weight_offset = 1;
	f->channel[0] = (struct model_channel){.path = MODEL_TRANSLATION,
		.interpolation = MODEL_LINEAR,
		.width = 3,
		.key_count = 3,
		.time_s = TIMES,
		.value = POINTS};
	f->channel[1] = (struct model_channel){.node = 0,
		.path = MODEL_ROTATION,
		.interpolation = MODEL_STEP,
		.width = 4,
		.key_count = 2,
		.time_s = SECONDS,
		.value = SPIN};
	f->channel[2] = (struct model_channel){.node = 1,
		.path = MODEL_WEIGHTS,
		.interpolation = MODEL_LINEAR,
		.width = 2,
		.key_count = 2,
		.time_s = SECONDS,
		.value = FADE};
	f->clip = (struct model_clip){.name = "",
		.duration_s = 3,
		.channel_count = 3,
		.channel = f->channel};
	f->model = (struct model){.node_count = 2,
		.node = f->node,
		.clip_count = 1,
		.clip = &f->clip,
		.weight_count = 3,
		.rest_weights = f->weights};
	assert_int_equal(pose_init(&f->pose, &f->model, &f->arena), 0);
	assert_int_equal(clip_cursor_init(&f->cursor, &f->model, &f->arena), 0);
}

static void test_pitfall_4_channels_interpolate_each_their_own_way(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	clip_sample(&f.clip, 0.75f, &f.cursor, &f.pose);
	assert_near(f.pose.local[0].translation[0], 6, 1e-6);
	assert_true(f.pose.local[0].rotation[3] == 1);
	assert_near(f.pose.weight[1], 0.75, 1e-6);
	assert_near(f.pose.weight[2], 0.25, 1e-6);
	clip_sample(&f.clip, 1, &f.cursor, &f.pose);
	assert_true(f.pose.local[0].rotation[2] == 1);
	assert_true(f.pose.weight[1] == 1);
	arena_release(&f.arena);
}

static void test_what_a_clip_has_no_channel_for_stays(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	clip_sample(&f.clip, 2, &f.cursor, &f.pose);
	assert_true(f.pose.local[0].scale[1] == 4);
	assert_true(f.pose.weight[0] == 0.1f);
	assert_true(f.pose.local[1].translation[0] == 0);
	assert_true(f.pose.animated[0]);
	assert_false(f.pose.animated[1]);
	arena_release(&f.arena);
}

static void test_pitfall_8_another_clip_starts_from_rest(void **state)
{
	struct fixture f;
	struct model_clip other;

	(void)state;
	set_up(&f);
	other = f.clip;
	other.channel = &f.channel[2];
	other.channel_count = 1;
	clip_sample(&f.clip, 2, &f.cursor, &f.pose);
	pose_rest(&f.pose, &f.model);
	clip_sample(&other, 0.5f, &f.cursor, &f.pose);
	assert_memory_equal(
		&f.pose.local[0], &f.node[0].rest, sizeof(struct transform));
	assert_false(f.pose.animated[0]);
	assert_near(f.pose.weight[1], 0.5, 1e-6);
	arena_release(&f.arena);
}

static void assert_same_pose(const struct pose *a, const struct pose *b)
{
	size_t nodes = (size_t)a->node_count;

	assert_memory_equal(a->local, b->local, nodes * sizeof(*a->local));
	assert_memory_equal(
		a->animated, b->animated, nodes * sizeof(*a->animated));
	assert_memory_equal(a->weight, b->weight,
		(size_t)a->weight_count * sizeof(*a->weight));
}

/* With a channel that is marked as constant and a linear rotation. */
static void set_up_whole(struct fixture *f)
{
	static const float still[6] = {1, 2, 3, 1, 2, 3};

	set_up(f);
	f->channel[0].constant = true;
	f->channel[0].key_count = 2;
	f->channel[0].time_s = SECONDS;
	f->channel[0].value = still;
	f->channel[1].interpolation = MODEL_LINEAR;
}

static void test_a_whole_pose_is_the_rest_and_the_samples(void **state)
{
	/* At eighths, mixing equal keys does not round. */
	static const float times[] = {0, 0.5f, 0.25f, 0.875f, -1, 7, 1, 0.125f};
	struct fixture f;
	struct pose want;

	(void)state;
	set_up_whole(&f);
	assert_int_equal(pose_init(&want, &f.model, &f.arena), 0);
	for (int kind = CLIP_AUTO; kind <= CLIP_CUBIC; kind++) {
		for (size_t i = 0; i < ARRAY_COUNT(times); i++) {
			struct clip_cursor none = {0};
			enum clip_interpolation as =
				(enum clip_interpolation)kind;

			pose_rest(&want, &f.model);
			clip_sample_as(&f.clip, times[i], as, &none, &want);
			memset(f.pose.local, 0x55, sizeof(*f.pose.local) * 2);
			clip_pose(&f.clip, times[i], as, &f.cursor, &f.pose);
			assert_same_pose(&f.pose, &want);
			memset(f.pose.weight, 0x55, sizeof(float) * 3);
			clip_pose(&f.clip, times[i], as, &none, &f.pose);
			assert_same_pose(&f.pose, &want);
		}
	}
	arena_release(&f.arena);
}

static void test_a_whole_pose_follows_a_change_of_clips(void **state)
{
	struct fixture f;
	struct model_clip other;

	(void)state;
	set_up_whole(&f);
	other = f.clip;
	other.channel = &f.channel[2];
	other.channel_count = 1;
	clip_pose(&f.clip, 0.5f, CLIP_AUTO, &f.cursor, &f.pose);
	assert_true(f.pose.local[0].translation[2] == 3);
	clip_pose(&other, 0.5f, CLIP_AUTO, &f.cursor, &f.pose);
	assert_memory_equal(
		&f.pose.local[0], &f.node[0].rest, sizeof(struct transform));
	assert_false(f.pose.animated[0]);
	assert_near(f.pose.weight[1], 0.5, 1e-6);
	clip_pose(&f.clip, 0, CLIP_AUTO, &f.cursor, &f.pose);
	assert_true(f.pose.local[0].translation[2] == 3);
	arena_release(&f.arena);
}

/* Half of the way by clip_mix() and, through another pose, by pose_mix(). */
static void check_mix(struct fixture *f, enum clip_interpolation as,
	const float *only, float time_s)
{
	static const float around_x[4] = {0.6f, 0, 0, 0.8f};
	struct pose clip, want;

	assert_int_equal(pose_init(&clip, &f->model, &f->arena), 0);
	assert_int_equal(pose_init(&want, &f->model, &f->arena), 0);
	assert_int_equal(clip_cursor_init(&f->cursor, &f->model, &f->arena), 0);
	pose_rest(&f->pose, &f->model);
	memcpy(f->pose.local[0].rotation, around_x, sizeof(around_x));
	f->pose.local[1].translation[0] = 4;
	pose_copy(&want, &f->pose);
	clip_pose(&f->clip, time_s, as, &f->cursor, &clip);
	pose_mix(&want, &clip, 0.5f, only, &want);
	assert_int_equal(clip_cursor_init(&f->cursor, &f->model, &f->arena), 0);
	f->cursor.only = only;
	clip_mix(&f->clip, time_s, as, 0.5f, &f->cursor, &f->pose);
	for (int n = 0; n < 2; n++) {
		const float *a = (const float *)&f->pose.local[n];

		assert_all_near(a, (const float *)&want.local[n], 10, 1e-6);
	}
	assert_all_near(f->pose.weight, want.weight, 3, 1e-6);
}

static void test_mixing_a_clip_is_mixing_its_pose(void **state)
{
	static const float first[2] = {1, 0}, second[2] = {0, 1};
	struct model_mesh mesh = {.target_count = 2};
	struct fixture f;

	(void)state;
	set_up_whole(&f);
	f.model.mesh_count = 1;
	f.model.mesh = &mesh;
	f.node[1].mesh = 0;
	for (int i = 0; i <= 2 * CLIP_CUBIC + 1; i++) {
		enum clip_interpolation as = (enum clip_interpolation)(i / 2);

		f.channel[1].unit = i % 2;
		check_mix(&f, as, NULL, 0.5f);
		check_mix(&f, as, first, 0.25f);
		check_mix(&f, as, second, 7);
		check_mix(&f, as, NULL, -1);
	}
	arena_release(&f.arena);
}

static void test_mixing_touches_only_the_paths_asked_for(void **state)
{
	uint8_t paths[2] = {0, 0};
	struct fixture f;
	struct pose before;

	(void)state;
	set_up_whole(&f);
	assert_int_equal(pose_init(&before, &f.model, &f.arena), 0);
	clip_add_paths(&f.clip, &f.model, paths);
	assert_int_equal(paths[0], 1 << MODEL_TRANSLATION | 1 << MODEL_ROTATION);
	assert_int_equal(paths[1], 1 << MODEL_WEIGHTS);
	f.pose.local[0].scale[1] = before.local[0].scale[1] = 9;
	f.cursor.paths = paths;
	clip_mix(&f.clip, 1, CLIP_AUTO, 1, &f.cursor, &f.pose);
	assert_true(f.pose.local[0].scale[1] == 9);
	assert_true(f.pose.local[0].translation[2] == 3);
	/* Without a clip the rest pose is mixed in. */
	before.animated[0] = true;
	clip_mix(NULL, 0, CLIP_AUTO, 1, &f.cursor, &f.pose);
	assert_same_pose(&f.pose, &before);
	arena_release(&f.arena);
}

static void test_a_cursor_with_less_room_still_works(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	f.cursor.channel_count = 1;
	clip_sample(&f.clip, 0.75f, &f.cursor, &f.pose);
	assert_near(f.pose.weight[1], 0.75, 1e-6);
	arena_release(&f.arena);
}

static void test_once_stays_at_the_end(void **state)
{
	(void)state;
	assert_true(clip_time(-1, 2.5f, CLIP_ONCE) == 0);
	assert_true(clip_time(1.25, 2.5f, CLIP_ONCE) == 1.25f);
	assert_true(clip_time(2.5, 2.5f, CLIP_ONCE) == 2.5f);
	assert_true(clip_time(1e12, 2.5f, CLIP_ONCE) == 2.5f);
	assert_true(clip_time((double)NAN, 2.5f, CLIP_ONCE) == 0);
}

static void test_loops_wrap_at_both_ends(void **state)
{
	(void)state;
	assert_true(clip_time(0, 2.5f, CLIP_LOOP) == 0);
	assert_true(clip_time(2.5, 2.5f, CLIP_LOOP) == 0);
	assert_near(clip_time(3, 2.5f, CLIP_LOOP), 0.5, 1e-6);
	assert_near(clip_time(-0.5, 2.5f, CLIP_LOOP), 2, 1e-6);
	assert_near(clip_time(-2.5, 2.5f, CLIP_LOOP), 0, 1e-6);
	assert_true(clip_time((double)INFINITY, 2.5f, CLIP_LOOP) == 0);
	assert_true(clip_time(1e300, 2.5f, CLIP_LOOP) == 0);
	assert_true(clip_time((double)NAN, 2.5f, CLIP_LOOP) == 0);
}

static void test_loops_stay_in_range_and_precise_for_days(void **state)
{
	(void)state;
	for (int i = 0; i < 5000; i++) {
		double time_s = 3 * 86400.0 + i * 0.0167;
		float duration_s = 1.1f;
		float at = clip_time(time_s, duration_s, CLIP_LOOP);

		assert_true(at >= 0 && at < duration_s);
		assert_near(at, fmod(time_s, (double)duration_s), 1e-6);
	}
	assert_true(clip_time(-1e-12, 1.1f, CLIP_LOOP) < 1.1f);
}

static void test_ping_pong_turns_round_at_both_ends(void **state)
{
	static const float want[][2] = {{0, 0}, {1, 1}, {2.5f, 2.5f}, {3, 2},
		{5, 0}, {5.5f, 0.5f}, {7.5f, 2.5f}, {-0.5f, 0.5f}, {-3, 2}};

	(void)state;
	for (size_t i = 0; i < sizeof(want) / sizeof(want[0]); i++) {
		assert_near(clip_time(want[i][0], 2.5f, CLIP_PING_PONG),
			want[i][1], 1e-6);
	}
}

static void test_a_clip_without_length_stays_at_zero(void **state)
{
	(void)state;
	assert_true(clip_time(5, 0, CLIP_LOOP) == 0);
	assert_true(clip_time(5, 0, CLIP_ONCE) == 0);
	assert_true(clip_time(5, NAN, CLIP_LOOP) == 0);
}

/* The first key lies at 0.04 s of 2 s, and a round takes 2 s all the same. */
static void test_later_rounds_begin_at_the_first_key(void **state)
{
	const struct model_clip clip = {.duration_s = 2, .lead_s = 0.04f};

	(void)state;
	assert_near(clip_round_time(&clip, 0, CLIP_LOOP), 0, 0);
	assert_near(clip_round_time(&clip, 0.01, CLIP_LOOP), 0.01, 1e-7);
	assert_near(clip_round_time(&clip, 1.99, CLIP_LOOP), 1.99, 1e-6);
	assert_near(clip_round_time(&clip, 2, CLIP_LOOP), 0.04, 1e-7);
	assert_near(clip_round_time(&clip, 3, CLIP_LOOP), 1.02, 1e-6);
	assert_near(clip_round_time(&clip, 7.999, CLIP_LOOP), 1.99902, 1e-5);
	assert_near(clip_round_time(&clip, -0.5, CLIP_LOOP), 1.51, 1e-6);
	assert_near(clip_round_time(&clip, 5, CLIP_ONCE), 2, 0);
	assert_near(clip_round_time(&clip, 4, CLIP_PING_PONG), 0, 1e-6);
}

static void test_without_a_lead_all_rounds_are_the_same(void **state)
{
	const struct model_clip clip = {.duration_s = 2};

	(void)state;
	for (double time_s = -5; time_s < 9; time_s += 0.37) {
		assert_true(clip_round_time(&clip, time_s, CLIP_LOOP) ==
			clip_time(time_s, 2, CLIP_LOOP));
	}
}

static void test_a_share_counts_from_the_first_key(void **state)
{
	const struct model_clip clip = {.duration_s = 2, .lead_s = 0.04f};
	const struct model_clip pose = {.duration_s = 0};

	(void)state;
	assert_near(clip_share(&clip, 0), 0, 0);
	assert_near(clip_share(&clip, 0.04f), 0, 0);
	assert_near(clip_share(&clip, 1.02f), 0.5, 1e-6);
	assert_near(clip_share(&clip, 2), 1, 0);
	assert_near(clip_share(&clip, 3), 1, 0);
	assert_near(clip_share(&pose, 0), 0, 0);
}

/* Less than a second long, and at each limit. */
static void test_short_clips_play_as_long_ones(void **state)
{
	const struct model_clip clip = {.duration_s = 0.5f};

	(void)state;
	for (int repeat = CLIP_ONCE; repeat <= CLIP_PING_PONG; repeat++) {
		enum clip_repeat as = (enum clip_repeat)repeat;

		assert_near(clip_time(0.125, 0.5f, as), 0.125, 0);
		assert_near(clip_time(0, 0.5f, as), 0, 0);
	}
	assert_near(clip_time(0.5, 0.5f, CLIP_PING_PONG), 0.5, 0);
	assert_near(clip_time(1.25, 2.5f, CLIP_PING_PONG), 1.25, 0);
	assert_near(clip_time(0.25, 2.5f, CLIP_ONCE), 0.25, 0);
	/* Below the period as a double, but not as a float. */
	assert_near(clip_time(0.49999999999, 0.5f, CLIP_LOOP), 0, 0);
	assert_near(clip_time(-1e300, 2.5f, CLIP_LOOP), 0, 0);
	assert_near(clip_share(&clip, 0.125f), 0.25, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_pitfall_4_channels_interpolate_each_their_own_way),
		cmocka_unit_test(test_what_a_clip_has_no_channel_for_stays),
		cmocka_unit_test(test_pitfall_8_another_clip_starts_from_rest),
		cmocka_unit_test(test_a_whole_pose_is_the_rest_and_the_samples),
		cmocka_unit_test(test_a_whole_pose_follows_a_change_of_clips),
		cmocka_unit_test(test_mixing_a_clip_is_mixing_its_pose),
		cmocka_unit_test(test_mixing_touches_only_the_paths_asked_for),
		cmocka_unit_test(test_a_cursor_with_less_room_still_works),
		cmocka_unit_test(test_once_stays_at_the_end),
		cmocka_unit_test(test_loops_wrap_at_both_ends),
		cmocka_unit_test(test_loops_stay_in_range_and_precise_for_days),
		cmocka_unit_test(test_ping_pong_turns_round_at_both_ends),
		cmocka_unit_test(test_a_clip_without_length_stays_at_zero),
		cmocka_unit_test(test_later_rounds_begin_at_the_first_key),
		cmocka_unit_test(test_without_a_lead_all_rounds_are_the_same),
		cmocka_unit_test(test_a_share_counts_from_the_first_key),
		cmocka_unit_test(test_short_clips_play_as_long_ones),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
