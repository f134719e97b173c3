/* Which models are known to pose their vertices in the same way. */
#include "app/compare/optimize/optimize_known.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

static void test_equal_models_have_the_same_stamp(void **state)
{
	struct model *a = model_fixture("gltf/clip/cubic.gltf", NULL);
	struct model *b = model_fixture("gltf/clip/cubic.gltf", NULL);

	(void)state;
	for (int clip = -1; clip < a->clip_count; clip++) {
		assert_true(optimize_known_stamp(a, clip) ==
			optimize_known_stamp(b, clip));
	}
	assert_true(optimize_known_stamp(a, -1) != optimize_known_stamp(a, 0));
	model_destroy(a);
	model_destroy(b);
}

/* Each change is undone before the next one. */
static void test_whatever_poses_vertices_changes_the_stamp(void **state)
{
	struct model *model = model_fixture("gltf/clip/cubic.gltf", NULL);
	struct model_channel *channel = &model->clip[0].channel[0];
	float *last_time = (float *)channel->time_s + channel->key_count - 1;
	float *last_value = (float *)channel->value +
		3 * channel->width * channel->key_count - 1;
	float *const number[] = {&model->node[0].rest.translation[0],
		&model->clip[0].duration_s, last_time, last_value};
	uint64_t stamp = optimize_known_stamp(model, 0);

	(void)state;
	assert_int_equal(channel->interpolation, MODEL_CUBICSPLINE);
	for (size_t i = 0; i < ARRAY_COUNT(number); i++) {
		float kept = *number[i];

		*number[i] += 1.0f;
		assert_true(optimize_known_stamp(model, 0) != stamp);
		*number[i] = kept;
	}
	channel->constant = !channel->constant;
	assert_true(optimize_known_stamp(model, 0) != stamp);
	channel->constant = !channel->constant;
	channel->node++;
	assert_true(optimize_known_stamp(model, 0) != stamp);
	channel->node--;
	assert_true(optimize_known_stamp(model, 0) == stamp);
	model_destroy(model);
}

enum {
	KEYS = 3,
	WIDTH = 4
};

/* A model of one node and one channel, whose arrays are longer than it. */
struct moving {
	struct model model;
	struct model_node node;
	struct model_clip clip;
	struct model_channel channel;
	mat4 matrix;
	float time_s[KEYS + 1], value[(3 * KEYS + 3) * WIDTH];
	int16_t packed[KEYS + 1][4];
};

static void begin(struct moving *moving, enum model_interpolation interpolation,
	bool packed, bool matrix)
{
	*moving = (struct moving){
		.model = {.node_count = 1,
			.node = &moving->node,
			.clip_count = 1,
			.clip = &moving->clip},
		.clip = {.channel_count = 1, .channel = &moving->channel},
		.channel = {.path = MODEL_ROTATION,
			.interpolation = interpolation,
			.width = WIDTH,
			.key_count = KEYS,
			.time_s = moving->time_s,
			.value = packed ? NULL : moving->value,
			.packed = packed ? moving->packed : NULL},
	};
	if (matrix) {
		moving->node.matrix = (void *)&moving->matrix;
	}
}

/* Whether the stamp is another one after a byte has changed. */
static bool counts(struct moving *moving, void *number, size_t size)
{
	uint64_t stamp = optimize_known_stamp(&moving->model, 0);
	uint8_t *last = (uint8_t *)number + size - 1;
	bool other;

	*last ^= 0x40;
	other = optimize_known_stamp(&moving->model, 0) != stamp;
	*last ^= 0x40;
	assert_true(optimize_known_stamp(&moving->model, 0) == stamp);
	return other;
}

/* A spline has three values a key. */
static void test_the_stamp_covers_the_keys_and_nothing_behind_them(void **state)
{
	static const enum model_interpolation kinds[] = {
		MODEL_STEP, MODEL_LINEAR, MODEL_CUBICSPLINE};
	struct moving moving;

	(void)state;
	for (int i = 0; i < 3; i++) {
		int values =
			KEYS * WIDTH * (kinds[i] == MODEL_CUBICSPLINE ? 3 : 1);

		begin(&moving, kinds[i], false, false);
		for (int k = 0; k <= KEYS; k++) {
			assert_int_equal(counts(&moving, &moving.time_s[k],
						 sizeof(float)),
				k < KEYS);
		}
		for (int v = 0; v < values + 2; v++) {
			assert_int_equal(
				counts(&moving, &moving.value[v], sizeof(float)),
				v < values);
		}
	}
	begin(&moving, MODEL_LINEAR, true, false);
	for (int v = 0; v < 4 * KEYS + 1; v++) {
		assert_int_equal(counts(&moving, &moving.packed[v / 4][v % 4],
					 sizeof(int16_t)),
			v < 4 * KEYS);
	}
}

/* A node has a matrix or none. */
static void test_the_stamp_covers_all_numbers_of_a_matrix(void **state)
{
	struct moving moving;

	(void)state;
	for (int matrix = 0; matrix < 2; matrix++) {
		begin(&moving, MODEL_LINEAR, false, matrix);
		for (int i = 0; i < 16; i++) {
			assert_int_equal(
				counts(&moving, &moving.matrix[i / 4][i % 4],
					sizeof(float)),
				matrix);
		}
	}
}

static void test_errors_are_found_by_their_stamp(void **state)
{
	struct optimize_known known = {.count = 0};
	float px = -1.0f;

	(void)state;
	assert_false(optimize_known_find(&known, 5, &px));
	for (int i = 0; i < OPTIMIZE_KNOWN_MAX + 3; i++) {
		optimize_known_add(&known, (uint64_t)i, (float)i);
	}
	assert_true(optimize_known_find(&known, 5, &px));
	assert_near(px, 5, 0);
	for (int i = 0; i < OPTIMIZE_KNOWN_MAX - 1; i++) {
		assert_true(optimize_known_find(&known, (uint64_t)i, &px));
		assert_near(px, i, 0);
	}
	/* The last one is replaced when the list is full. */
	assert_true(optimize_known_find(&known, OPTIMIZE_KNOWN_MAX + 2, &px));
	assert_near(px, OPTIMIZE_KNOWN_MAX + 2, 0);
	assert_false(optimize_known_find(&known, OPTIMIZE_KNOWN_MAX + 1, &px));
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_equal_models_have_the_same_stamp),
		cmocka_unit_test(test_whatever_poses_vertices_changes_the_stamp),
		cmocka_unit_test(
			test_the_stamp_covers_the_keys_and_nothing_behind_them),
		cmocka_unit_test(test_the_stamp_covers_all_numbers_of_a_matrix),
		cmocka_unit_test(test_errors_are_found_by_their_stamp),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
