#include "app/anim/clip_join.h"
#include "app/anim/ease.h"
#include "app/anim/pose_blend.h"
#include "tests/support/model/bones.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

static const float ROOT_HALF = 0.70710678f;

/*
 * Four nodes: 1 and 3 are children of 0, 2 is a child of 1. Node 2 has a mesh
 * with two morph targets.
 */
struct fixture {
	struct bones bones;
	struct pose a, b, out;
};

static void set_up(struct fixture *f)
{
	struct bones *bones = &f->bones;

	bones_begin(bones);
	bones_add(bones, -1, 0, 0, 0);
	bones_add(bones, 0, 1, 0, 0);
	bones_add(bones, 1, 1, 0, 0);
	bones_add(bones, 0, 0, 1, 0);
	bones->node[2].mesh = 0;
	bones->mesh[0].target_count = 2;
	bones->model.weight_count = 2;
	bones_pose(bones);
	pose_init(&f->a, &bones->model, &bones->model.arena);
	pose_init(&f->b, &bones->model, &bones->model.arena);
	pose_init(&f->out, &bones->model, &bones->model.arena);
	f->b.local[2].translation[1] = 4;
	f->b.local[2].scale[0] = 3;
	f->b.local[2].rotation[2] = ROOT_HALF; /* a quarter about z */
	f->b.local[2].rotation[3] = ROOT_HALF;
	f->b.weight[1] = 0.5f;
	f->b.animated[2] = true;
}

static void tear_down(struct fixture *f)
{
	bones_end(&f->bones);
}

static void assert_same_pose(const struct pose *a, const struct pose *b)
{
	assert_memory_equal(
		a->local, b->local, (size_t)a->node_count * sizeof(*a->local));
	assert_memory_equal(a->weight, b->weight,
		(size_t)a->weight_count * sizeof(*a->weight));
}

static void test_easing_begins_and_ends_exactly(void **state)
{
	(void)state;
	for (int e = EASE_LINEAR; e <= EASE_CUBIC; e++) {
		enum ease ease = (enum ease)e;

		assert_true(ease_at(ease, 0) == 0);
		assert_true(ease_at(ease, 1) == 1);
		assert_true(ease_at(ease, -1) == 0);
		assert_true(ease_at(ease, 7) == 1);
		assert_true(ease_at(ease, NAN) == 0);
		assert_near(ease_at(ease, 0.5f), 0.5, 1e-6);
	}
	assert_near(ease_at(EASE_LINEAR, 0.25f), 0.25, 1e-6);
	assert_near(ease_at(EASE_CUBIC, 0.25f), 0.15625, 1e-6);
}

static void test_a_mix_is_exact_at_both_ends(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	pose_mix(&f.a, &f.b, 0, NULL, &f.out);
	assert_same_pose(&f.out, &f.a);
	assert_false(f.out.animated[2]);
	pose_mix(&f.a, &f.b, 1, NULL, &f.out);
	assert_same_pose(&f.out, &f.b);
	assert_true(f.out.animated[2]);
	tear_down(&f);
}

static void test_a_mix_goes_part_of_the_way(void **state)
{
	struct fixture f;
	double eighth = acos(-1) / 8;

	(void)state;
	set_up(&f);
	pose_mix(&f.a, &f.b, 0.5f, NULL, &f.out);
	assert_near(f.out.local[2].translation[0], 1, 1e-6);
	assert_near(f.out.local[2].translation[1], 2, 1e-6);
	assert_near(f.out.local[2].scale[0], 2, 1e-6);
	assert_near(f.out.local[2].rotation[2], sin(eighth), 2e-6);
	assert_near(f.out.local[2].rotation[3], cos(eighth), 2e-6);
	assert_near(f.out.weight[1], 0.25, 1e-6);
	assert_true(f.out.animated[2]);
	assert_false(f.out.animated[1]);
	pose_mix(&f.a, &f.b, 0.5f, NULL, &f.a);
	assert_same_pose(&f.out, &f.a);
	tear_down(&f);
}

static void test_a_mask_weighs_nodes_and_their_morph_weights(void **state)
{
	struct fixture f;
	static const float mask[4] = {0, 0.5f, 0.5f, 0};

	(void)state;
	set_up(&f);
	f.b.local[3].translation[1] = 9;
	pose_mix(&f.a, &f.b, 1, mask, &f.out);
	assert_near(f.out.local[2].translation[1], 2, 1e-6);
	assert_near(f.out.weight[1], 0.25, 1e-6);
	assert_true(f.out.local[3].translation[1] == 1);
	tear_down(&f);
}

static void test_a_layer_adds_its_difference(void **state)
{
	struct fixture f;
	struct transform *bone;

	(void)state;
	set_up(&f);
	/* The pose: 90 degrees about y, scale 2, any translation. */
	bone = &f.out.local[2];
	bone->translation[1] = 10;
	bone->scale[0] = 2;
	bone->rotation[1] = ROOT_HALF;
	bone->rotation[3] = ROOT_HALF;
	f.out.weight[1] = 0.25f;
	pose_add(&f.out, &f.b, &f.a, 1, NULL);
	assert_near(bone->translation[0], 1, 1e-6);
	assert_near(bone->translation[1], 14, 1e-6);
	assert_near(bone->scale[0], 6, 1e-6);
	assert_near(f.out.weight[1], 0.75, 1e-6);
	/* 90 degrees about y times 90 about z: all elements are halves. */
	assert_near(bone->rotation[0], 0.5, 1e-6);
	assert_near(bone->rotation[1], 0.5, 1e-6);
	assert_near(bone->rotation[2], 0.5, 1e-6);
	assert_near(bone->rotation[3], 0.5, 1e-6);
	assert_true(f.out.animated[2]);
	tear_down(&f);
}

static void test_a_layer_like_its_reference_changes_nothing(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	pose_copy(&f.out, &f.b);
	pose_add(&f.out, &f.b, &f.b, 1, NULL);
	assert_all_near(f.out.local, f.b.local, 40, 1e-6);
	pose_add(&f.out, &f.b, &f.a, 0, NULL);
	assert_all_near(f.out.local, f.b.local, 40, 1e-6);
	tear_down(&f);
}

static void test_a_layer_weighs_half(void **state)
{
	struct fixture f;
	double eighth = acos(-1) / 8;

	(void)state;
	set_up(&f);
	pose_add(&f.out, &f.b, &f.a, 0.5f, NULL);
	assert_near(f.out.local[2].translation[1], 2, 1e-6);
	assert_near(f.out.local[2].scale[0], 2, 1e-6);
	assert_near(f.out.local[2].rotation[2], sin(eighth), 2e-6);
	tear_down(&f);
}

static void test_a_zero_scale_in_the_reference_is_survived(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	f.a.local[2].scale[0] = 0;
	pose_add(&f.out, &f.b, &f.a, 1, NULL);
	assert_true(f.out.local[2].scale[0] == 1);
	tear_down(&f);
}

/* Two clips with one channel each: x from 0 to 1 in 1 s, from 5 to 7 in 2 s. */
static const float FRAMES[11] = {
	0, 0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f, 0.7f, 0.8f, 0.9f, 1};
static const float TWO_SECONDS[2] = {0, 2};
static float RISE[33];
static const float SLIDE[6] = {5, 0, 0, 7, 0, 0};

static void make_clips(
	struct model_channel channel[2], struct model_clip clip[2])
{
	for (int i = 0; i < 11; i++) {
		RISE[3 * i] = FRAMES[i];
	}
	channel[0] = (struct model_channel){.node = 1,
		.path = MODEL_TRANSLATION,
		.interpolation = MODEL_LINEAR,
		.width = 3,
		.key_count = 11,
		.time_s = FRAMES,
		.value = RISE};
	channel[1] = channel[0];
	channel[1].key_count = 2;
	channel[1].time_s = TWO_SECONDS;
	channel[1].value = SLIDE;
	for (int i = 0; i < 2; i++) {
		clip[i] = (struct model_clip){.name = "",
			.channel_count = 1,
			.duration_s = (float)i + 1,
			.channel = &channel[i]};
	}
}

static float joined(
	struct fixture *f, const struct clip_join *join, float time_s)
{
	int key[2] = {0, 0};
	struct clip_cursor from = {.channel_count = 1, .key = &key[0]};
	struct clip_cursor to = {.channel_count = 1, .key = &key[1]};

	f->out.local[3].translation[1] = 77; /* has to return to rest */
	clip_join_sample(join, time_s, &from, &to, &f->a, &f->out);
	assert_true(f->out.local[3].translation[1] == 1);
	return f->out.local[1].translation[0];
}

static void test_joined_clips_lose_the_overlap(void **state)
{
	struct fixture f;
	struct model_channel channel[2];
	struct model_clip clip[2];
	struct clip_join join;

	(void)state;
	set_up(&f);
	make_clips(channel, clip);
	assert_near(clip_join_frame_s(&clip[0]), 0.1, 1e-6);
	join = clip_join_frames(&clip[0], &clip[1], CLIP_JOIN_FRAMES);
	assert_near(join.overlap_s, 0.4, 1e-6);
	assert_near(joined(&f, &join, 0), 0, 1e-6);
	assert_near(joined(&f, &join, 0.5f), 0.5, 1e-6);
	/* At both ends of the overlap only one clip counts. */
	assert_near(joined(&f, &join, 0.6f), 0.6, 1e-5);
	assert_near(joined(&f, &join, 1), 5.4, 1e-5);
	assert_near(joined(&f, &join, 2.6f), 7, 1e-5);
	assert_near(joined(&f, &join, 99), 7, 1e-5);
	tear_down(&f);
}

static void test_joined_clips_mix_in_the_overlap(void **state)
{
	struct fixture f;
	struct model_channel channel[2];
	struct model_clip clip[2];
	struct clip_join join;

	(void)state;
	set_up(&f);
	make_clips(channel, clip);
	join = clip_join_frames(&clip[0], &clip[1], CLIP_JOIN_FRAMES);
	/* At a quarter: 0.7 and 5.1, weight 0.15625 eased, 0.25 linear. */
	assert_near(joined(&f, &join, 0.7f), 0.7 + 4.4 * 0.15625, 1e-5);
	join.ease = EASE_LINEAR;
	assert_near(joined(&f, &join, 0.7f), 0.7 + 4.4 * 0.25, 1e-5);
	assert_near(joined(&f, &join, 0.8f), (0.8 + 5.2) / 2, 1e-5);
	tear_down(&f);
}

static void test_an_overlap_is_no_longer_than_a_clip(void **state)
{
	struct fixture f;
	struct model_channel channel[2];
	struct model_clip clip[2];
	struct clip_join join;

	(void)state;
	set_up(&f);
	make_clips(channel, clip);
	join = clip_join_frames(&clip[0], &clip[1], 1000);
	assert_near(join.overlap_s, 1, 1e-6);
	join = clip_join_frames(&clip[0], &clip[1], -3);
	assert_near(join.overlap_s, 0, 0);
	assert_near(joined(&f, &join, 1), 1, 1e-5);
	assert_near(joined(&f, &join, 1.5f), 5.5, 1e-5);
	channel[0].key_count = 1;
	assert_near(clip_join_frame_s(&clip[0]), 1 / 30.0, 1e-6);
	tear_down(&f);
}

/* Keys that are left, at frames 0, 1, 12 and so on, say nothing of the rate. */
static void test_an_overlap_counts_frames_of_the_clips_rate(void **state)
{
	static const struct {
		float times[5];
		float frame_s;
	} cases[] = {
		{{0, 1 / 30.0f, 12 / 30.0f, 13 / 30.0f, 1.0f}, 1 / 30.0f},
		{{0, 10 / 30.0f, 20 / 30.0f, 25 / 30.0f, 1.0f}, 1 / 30.0f},
		{{0, 5 / 24.0f, 7 / 24.0f, 13 / 24.0f, 1.0f}, 1 / 24.0f},
		{{0, 7 / 60.0f, 9 / 60.0f, 31 / 60.0f, 1.0f}, 1 / 60.0f},
		{{0, 0.5f, 1.0f, 1.5f, 2.0f}, 1 / 30.0f},
		{{0, 0.001f, 0.1234f, 0.4567f, 0.7891f}, 1 / 30.0f},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct model_channel channel = {.path = MODEL_TRANSLATION,
			.key_count = 5,
			.time_s = cases[i].times};
		struct model_clip clip = {.duration_s = 1,
			.channel_count = 1,
			.channel = &channel};

		assert_near(clip_join_frame_s(&clip), cases[i].frame_s, 1e-6);
		assert_near(
			clip_join_frames(&clip, &clip, CLIP_JOIN_FRAMES).overlap_s,
			4 * cases[i].frame_s, 1e-6);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_easing_begins_and_ends_exactly),
		cmocka_unit_test(test_a_mix_is_exact_at_both_ends),
		cmocka_unit_test(test_a_mix_goes_part_of_the_way),
		cmocka_unit_test(
			test_a_mask_weighs_nodes_and_their_morph_weights),
		cmocka_unit_test(test_a_layer_adds_its_difference),
		cmocka_unit_test(test_a_layer_like_its_reference_changes_nothing),
		cmocka_unit_test(test_a_layer_weighs_half),
		cmocka_unit_test(test_a_zero_scale_in_the_reference_is_survived),
		cmocka_unit_test(test_joined_clips_lose_the_overlap),
		cmocka_unit_test(test_joined_clips_mix_in_the_overlap),
		cmocka_unit_test(test_an_overlap_is_no_longer_than_a_clip),
		cmocka_unit_test(test_an_overlap_counts_frames_of_the_clips_rate),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
