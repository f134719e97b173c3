/* Key frames: where they are between two of them, and what they take. */
#include "app/anim/kernel/run/fixed_lerp.h"
#include "app/compare/candidate/candidate_morph.h"
#include "app/compare/cost/board_cost.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	VERTICES = 9, /* of a grid of 2 x 2 quads: an odd number */
	KEYS = 4
};

static float key_time_s[KEYS] = {0.0f, 0.25f, 0.5f, 1.0f};

/* A grid that goes from its place to (3, 1, 0) and turns over on its way. */
struct bench {
	struct log log;
	struct model *model;
	struct model_clip clip;
	struct model_channel channel[2];
	struct reference *reference;
	struct fixed_placement placement;
	struct candidate candidate;
};

static const float times[5] = {0.0f, 0.25f, 0.5f, 0.75f, 1.0f};
static const float places[5][3] = {
	{0, 0, 0}, {1, 0, 0}, {2, 2, 0}, {2, 2, 0}, {3, 1, 0}};
static const float turns[5][4] = {{0, 0, 0, 1}, {0.36f, 0.48f, 0, 0.8f},
	{0.48f, 0.64f, 0, 0.6f}, {0.48f, 0.64f, 0, 0.6f}, {0.6f, 0.8f, 0, 0}};

static void begin(struct bench *bench, int key_count, size_t keep_bytes)
{
	static const struct bounds box = {{-1, -1, -1}, {4, 3, 1}};
	struct fit_keys keys = {key_count, key_time_s};

	*bench = (struct bench){.log = log_to_stderr(LOG_WARNING),
		.model = small_model_grid(2, 2, 1.0f, true)};
	bench->channel[0] = (struct model_channel){.path = MODEL_TRANSLATION,
		.interpolation = MODEL_LINEAR,
		.width = 3,
		.key_count = 5,
		.time_s = times,
		.value = places[0]};
	bench->channel[1] = (struct model_channel){.path = MODEL_ROTATION,
		.interpolation = MODEL_LINEAR,
		.width = 4,
		.key_count = 5,
		.time_s = times,
		.value = turns[0]};
	bench->clip = (struct model_clip){.name = "go",
		.duration_s = 1.0f,
		.channel_count = 2,
		.channel = bench->channel};
	bench->model->clip = &bench->clip;
	bench->model->clip_count = 1;
	assert_int_equal(reference_create(bench->model, 0, &bench->log,
				 &bench->reference),
		0);
	assert_int_equal(bench->reference->vertex_count, VERTICES);
	bench->placement = candidate_morph_placement(&box);
	assert_int_equal(candidate_morph(&bench->candidate, bench->reference,
				 kernel_find("fixed"), &bench->placement, &keys,
				 keep_bytes, &bench->log),
		0);
}

static void end(struct bench *bench)
{
	candidate_destroy(&bench->candidate);
	reference_destroy(bench->reference);
	bench->model->clip = NULL;
	bench->model->clip_count = 0;
	model_destroy(bench->model);
}

static void pose_of_key(
	struct bench *bench, int key, float (*position)[3], float (*normal)[3])
{
	reference_pose(bench->reference, key_time_s[key], true);
	memcpy(position, bench->reference->position,
		VERTICES * sizeof(*position));
	memcpy(normal, bench->reference->normal, VERTICES * sizeof(*normal));
}

/* Fails unless the pose is so far from this key on the way to the next one. */
static void expect_between(
	struct bench *bench, float time_s, int key, float omega)
{
	float shown[VERTICES][3], normal[VERTICES][3];
	float from[2][VERTICES][3], to[2][VERTICES][3];

	bench->candidate.positions_only = false;
	candidate_pose(&bench->candidate, time_s);
	bench->candidate.take(&bench->candidate, shown, normal);
	pose_of_key(bench, key, from[0], from[1]);
	pose_of_key(bench, key + 1, to[0], to[1]);
	for (int v = 0; v < VERTICES; v++) {
		float length = 0.0f;

		for (int axis = 0; axis < 3; axis++) {
			float *a = from[0][v], *n = from[1][v];

			a[axis] += omega * (to[0][v][axis] - a[axis]);
			n[axis] += omega * (to[1][v][axis] - n[axis]);
			length += n[axis] * n[axis];
		}
		assert_all_near(shown[v], from[0][v], 3, 4e-4);
		for (int axis = 0; axis < 3 && length > 0.1f; axis++) {
			assert_near(normal[v][axis],
				from[1][v][axis] / sqrtf(length), 0.03);
		}
	}
}

/* Forwards, backwards, at keys and beyond them; with all keys and with two. */
static void test_poses_are_between_the_keys_around_them(void **state)
{
	static const struct {
		float time_s;
		int key;
		float omega;
	} moments[] = {{0, 0, 0}, {0.0625f, 0, 0.25f}, {0.25f, 1, 0},
		{0.375f, 1, 0.5f}, {0.5f, 2, 0}, {0.625f, 2, 0.25f}, {1, 2, 1},
		{2, 2, 1}, {0.4375f, 1, 0.75f}, {0.9f, 2, 0.8f},
		{0.125f, 0, 0.5f}, {-1, 0, 0}, {0.75f, 2, 0.5f}};

	(void)state;
	for (int all = 0; all < 2; all++) {
		struct bench bench;

		begin(&bench, KEYS, all ? 1 << 20 : 0);
		for (size_t i = 0; i < sizeof(moments) / sizeof(*moments); i++) {
			expect_between(&bench, moments[i].time_s,
				moments[i].key, moments[i].omega);
		}
		end(&bench);
	}
}

/* Where the vertex at the grid's corner is shown; at first it is at 0. */
static void expect_corner(
	struct bench *bench, float time_s, const float place[3])
{
	float position[VERTICES][3];

	candidate_pose(&bench->candidate, time_s);
	bench->candidate.take(&bench->candidate, position, NULL);
	assert_all_near(position[0], place, 3, 4e-4);
}

static const float moved[3] = {1, 1, 0};

static void move_corner(struct bench *bench)
{
	memcpy(bench->model->mesh->primitive->position[0], moved, sizeof(moved));
}

/* Twelve bytes of each of ten vertices. The model changes once keys are made. */
static void test_all_keys_are_kept_if_they_fit(void **state)
{
	(void)state;
	for (int keys = 3; keys <= KEYS; keys++) {
		struct bench bench;

		begin(&bench, keys, (size_t)keys * 120);
		move_corner(&bench);
		expect_corner(&bench, 0.25f, places[1]);
		expect_corner(&bench, 0.5f, places[2]);
		expect_corner(&bench, 0.0f, places[0]);
		end(&bench);
		begin(&bench, keys, (size_t)keys * 120 - 1);
		expect_corner(&bench, 0.25f, places[1]);
		move_corner(&bench);
		expect_corner(&bench, 0.25f, places[1]); /* is kept */
		expect_corner(&bench, 0.0f, moved);
		expect_corner(&bench, 0.25f, places[1]); /* so is this */
		end(&bench);
	}
}

/* Where they are not wanted, they stay those of the pose before. */
static void test_normals_may_be_left_out(void **state)
{
	float position[VERTICES][3], before[VERTICES][3], after[VERTICES][3];
	struct bench bench;

	(void)state;
	begin(&bench, KEYS, 1 << 20);
	candidate_pose(&bench.candidate, 0.0f);
	bench.candidate.take(&bench.candidate, position, before);
	bench.candidate.positions_only = true;
	expect_corner(&bench, 0.5f, places[2]);
	bench.candidate.take(&bench.candidate, position, after);
	assert_all_near(after, before, 3 * VERTICES, 0.0);
	bench.candidate.positions_only = false;
	candidate_pose(&bench.candidate, 0.5f);
	bench.candidate.take(&bench.candidate, position, after);
	assert_true(fabsf(after[0][1] - before[0][1]) > 0.1f);
	end(&bench);
}

/* Numbers are those of the file, and of the player, which makes them even. */
static void test_a_key_has_the_numbers_of_the_file(void **state)
{
	static const float ends[][3] = {{-1, 0.5f, 0}, {4, 0.5f, 0}, {9, -9, 9}};
	static const int16_t wanted[][3] = {
		{-16383, -3277, 0}, {16383, -3277, 0}, {16383, -16383, 16383}};
	static const float normals[][3] = {
		{1, 0, -1}, {0.5f, -0.5f, 0.01f}, {2, -2, 0.0093f}};
	static const int8_t bytes[][3] = {
		{54, 0, -54}, {27, -27, 1}, {54, -54, 1}};
	const struct bounds box = {{-1, -1, -1}, {4, 3, 1}};
	const struct fixed_placement placement = candidate_morph_placement(&box);

	(void)state;
	assert_near(placement.scale, 2.5 / 16383.0, 1e-9);
	assert_all_near(placement.offset, ((float[]){1.5f, 1, 0}), 3, 1e-6);
	for (int i = 0; i < 3; i++) {
		int16_t position[3];
		int8_t normal[3];

		candidate_morph_position(&placement, ends[i], position);
		candidate_morph_normal(normals[i], normal);
		for (int axis = 0; axis < 3; axis++) {
			assert_int_equal(position[axis], wanted[i][axis]);
			assert_int_equal(normal[axis], bytes[i][axis]);
		}
	}
}

/* A box without an extent still has a scale, as the file's node needs one. */
static void test_the_placement_of_a_point_has_a_scale(void **state)
{
	const struct bounds box = {{2, 3, 4}, {2, 3, 4}};
	const struct fixed_placement placement = candidate_morph_placement(&box);

	(void)state;
	assert_true(placement.scale > 0.0f && placement.scale < 1e-9f);
	assert_all_near(placement.offset, box.low, 3, 0.0);
}

/* In memory a number of vertices is even, in a file each is aligned to four. */
static void test_what_keys_take(void **state)
{
	const size_t key = 10 * 2 * 6, file = 9 * (8 + 4);
	struct bench bench;
	struct board_cost wanted;

	(void)state;
	for (int keys = 2; keys <= KEYS; keys++) {
		const struct candidate *candidate = &bench.candidate;
		size_t count = (size_t)keys;

		begin(&bench, keys, 1 << 20);
		assert_int_equal(candidate->bytes.shared,
			key + 9 * 2 * sizeof(struct fixed_vector));
		assert_int_equal(candidate->bytes.own, count * (key + 4));
		assert_int_equal(candidate->bytes.shared_file, file);
		assert_int_equal(candidate->bytes.own_file, count * (file + 4));
		wanted = board_cost_sample_keys(keys);
		assert_near(candidate->board.sample.cycles, wanted.cycles, 0.0);
		wanted = board_cost_matrices(1, 1, 0);
		assert_near(
			candidate->board.matrices.cycles, wanted.cycles, 0.0);
		wanted = board_cost_keys(9, true, keys);
		assert_near(
			candidate->board.vertices.cycles, wanted.cycles, 1e-6);
		end(&bench);
	}
}

/* Vertices without normals have one stream. */
static void test_what_keys_without_normals_take(void **state)
{
	struct fit_keys keys = {2, key_time_s};
	struct candidate candidate;
	struct bench bench;

	(void)state;
	begin(&bench, 2, 1 << 20);
	bench.reference->part[0].normals = false;
	assert_int_equal(candidate_morph(&candidate, bench.reference,
				 kernel_find("fixed"), &bench.placement, &keys,
				 0, &bench.log),
		0);
	assert_int_equal(candidate.bytes.shared,
		10 * 6 + 9 * sizeof(struct fixed_vector));
	assert_int_equal(candidate.bytes.own, 2 * (10 * 6 + 4));
	assert_int_equal(candidate.bytes.shared_file, 9 * 8);
	assert_int_equal(candidate.bytes.own_file, 2 * (9 * 8 + 4));
	candidate_destroy(&candidate);
	end(&bench);
}

/* Vertices without normals get none. */
static void test_no_normal_is_none(void **state)
{
	float position[VERTICES][3], normal[VERTICES][3];
	struct bench bench;

	(void)state;
	begin(&bench, 2, 0);
	memset(bench.model->mesh->primitive->normal, 0,
		sizeof(float[VERTICES][3]));
	candidate_pose(&bench.candidate, 0.125f);
	bench.candidate.take(&bench.candidate, position, normal);
	for (int i = 0; i < 3 * VERTICES; i++) {
		assert_near(normal[i / 3][i % 3], 0.0, 0.0);
	}
	end(&bench);
}

/* At a key and beyond the last one, a number is that of the key's position. */
static void test_keys_are_shown_as_the_file_rounds_them(void **state)
{
	(void)state;
	for (int all = 0; all < 2; all++) {
		struct bench bench;

		begin(&bench, KEYS - 1, all ? 1 << 20 : 0);
		for (int k = 0; k < KEYS; k++) {
			float shown[VERTICES][3], normal[VERTICES][3];
			int key = k < KEYS - 1 ? k : KEYS - 2;

			bench.candidate.positions_only = false;
			candidate_pose(&bench.candidate, key_time_s[k]);
			bench.candidate.take(&bench.candidate, shown, normal);
			reference_pose(bench.reference, key_time_s[key], true);
			for (int i = 0; i < 3 * VERTICES; i++) {
				const struct fixed_placement *to =
					&bench.placement;
				float at =
					bench.reference->position[i / 3][i % 3];
				float number = roundf(
					(at - to->offset[i % 3]) / to->scale);

				assert_near(shown[i / 3][i % 3],
					number * to->scale + to->offset[i % 3],
					0.02 * (double)to->scale);
			}
		}
		end(&bench);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_poses_are_between_the_keys_around_them),
		cmocka_unit_test(test_all_keys_are_kept_if_they_fit),
		cmocka_unit_test(test_normals_may_be_left_out),
		cmocka_unit_test(test_no_normal_is_none),
		cmocka_unit_test(test_a_key_has_the_numbers_of_the_file),
		cmocka_unit_test(test_the_placement_of_a_point_has_a_scale),
		cmocka_unit_test(test_what_keys_take),
		cmocka_unit_test(test_what_keys_without_normals_take),
		cmocka_unit_test(test_keys_are_shown_as_the_file_rounds_them),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
