/* Moving a model that is far from the origin. */
#include "app/model/origin/model_origin.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <string.h>

/* A board of one metre, and what is found about it. */
struct found {
	struct model *model;
	struct arena arena;
	bool turned[1];
	bool start_is_set;
	float start[1][3];
	double (*shift)[3];
};

static struct found make(float x, float y, float z)
{
	struct found found = {.model = small_model_grid(1, 1, 1.0f, true)};
	const float at[3] = {x, y, z};

	memcpy(found.model->node[0].rest.translation, at, sizeof(at));
	return found;
}

static void find(struct found *found)
{
	if (!found->start_is_set) {
		memcpy(found->start[0], found->model->node[0].rest.translation,
			sizeof(found->start[0]));
	}
	assert_int_equal(model_origin_find(found->model, found->turned,
				 (const float(*)[3])found->start, &found->arena,
				 &found->shift),
		0);
}

static void release(struct found *found)
{
	arena_release(&found->arena);
	model_destroy(found->model);
}

static void move_vertices(struct model *model, float x, float y, float z)
{
	struct model_primitive *primitive = model->mesh[0].primitive;

	for (int v = 0; v < primitive->vertex_count; v++) {
		primitive->position[v][0] += x;
		primitive->position[v][1] += y;
		primitive->position[v][2] += z;
	}
}

/* Its middle is half a metre from the corner that is at this place. */
static void test_only_a_model_farther_than_128_times_its_size_moves(void **state)
{
	(void)state;
	for (int i = 0; i < 2; i++) {
		struct found found = make(i ? 127.6f : 127.5f, 0, 0);

		find(&found);
		assert_int_equal(found.shift != NULL, i);
		assert_near(found.model->origin[0], i ? 128.0 : 0.0, 0.0);
		assert_near(found.model->node[0].rest.translation[0],
			i ? 127.6 - 128 : 127.5, 1e-5);
		release(&found);
	}
}

/* Nothing of the file's numbers is lost: sums are as exact as they were. */
static void test_a_place_in_the_file_is_kept_to_the_bit(void **state)
{
	struct found found = make(1000000.3125f, 1.1f, -7654321.5f);
	float *at = found.model->node[0].rest.translation;
	double in_file[3];

	(void)state;
	find(&found);
	assert_true(at[0] > -1.5f && at[0] < 1.5f);
	model_origin_to_file(found.model, at, in_file);
	assert_near(in_file[0], 1000000.3125, 0.0);
	assert_near(in_file[1], (double)1.1f, 0.0); /* it is near on this axis */
	assert_near(in_file[2], -7654321.5, 0.0);
	release(&found);
}

/* Its turn and its skew stay, and its parts move with it. */
static void test_a_node_of_a_matrix_moves(void **state)
{
	static const float skewed[4][4] = {{1, 0.5f, 0, 0}, {0, 1, 0.25f, 0},
		{0, 0, 1, 0}, {3000, 0.25f, -2000, 1}};
	struct found found = make(3000, 0.25f, -2000);
	struct model_node *node = found.model->node;
	float(*matrix)[4] = arena_alloc(&found.model->arena, 4, sizeof(*matrix));

	(void)state;
	assert_non_null(matrix);
	memcpy(matrix, skewed, sizeof(skewed));
	node->matrix = (const float(*)[4])matrix;
	find(&found);
	assert_non_null(found.shift);
	for (int axis = 0; axis < 3; axis++) {
		float moved = node->matrix[3][axis];

		assert_near(moved + found.model->origin[axis], skewed[3][axis],
			0.0);
		assert_near(node->rest.translation[axis], moved, 0.0);
		assert_near(moved, 0.0, 2.0);
	}
	assert_memory_equal(node->matrix, skewed, 3 * sizeof(skewed[0]));
	release(&found);
}

static void test_vertices_that_are_far_move_and_their_node_stays(void **state)
{
	struct found found = make(0.25f, 0, 0);
	struct model_node *node = found.model->node;
	double in_file[3];

	(void)state;
	node->rest.scale[0] = 2;
	move_vertices(found.model, 0, 4000000, 0);
	find(&found);
	assert_near(found.model->mesh[0].primitive->position[3][0], 1, 0);
	assert_true(found.model->mesh[0].primitive->position[3][1] <= 2);
	model_origin_to_file(found.model, node->rest.translation, in_file);
	assert_near(in_file[0], 0.25, 0.0);
	assert_near(in_file[1] +
			(double)found.model->mesh[0].primitive->position[3][1],
		4000001.0, 0.0);
	release(&found);
}

/* It would turn around another point. */
static void test_vertices_stay_in_a_node_that_a_clip_turns(void **state)
{
	struct found found = make(0, 0, 0);

	(void)state;
	move_vertices(found.model, 0, 4000000, 0);
	found.turned[0] = true;
	find(&found);
	assert_near(found.model->mesh[0].primitive->position[0][1], 4e6, 0.0);
	assert_near(found.model->node[0].rest.translation[1],
		-found.model->origin[1], 0.0);
	release(&found);
}

static void test_keys_move_but_not_the_tangents_of_splines(void **state)
{
	const double shift[3] = {100, 0, -100};
	float linear[6] = {101, 1, -101, 102, 2, -102};
	float cubic[9] = {1, 2, 3, 101, 1, -101, 4, 5, 6};
	struct model_channel channel = {
		.interpolation = MODEL_LINEAR, .key_count = 2, .width = 3};

	(void)state;
	model_origin_shift_keys(shift, &channel, linear);
	assert_all_near(linear, ((float[]){1, 1, -1, 2, 2, -2}), 6, 0);
	channel.interpolation = MODEL_CUBICSPLINE;
	channel.key_count = 1;
	model_origin_shift_keys(shift, &channel, cubic);
	assert_all_near(cubic, ((float[]){1, 2, 3, 1, 1, -1, 4, 5, 6}), 9, 0);
}

/* As a model whose clips bring it to the origin, where its rest is not. */
static void test_a_model_that_a_clip_begins_elsewhere_stays(void **state)
{
	struct found found = make(1e6f, 0, 0);

	(void)state;
	found.start_is_set = true;
	find(&found);
	assert_null(found.shift);
	assert_near(found.model->node[0].rest.translation[0], 1e6, 0);
	release(&found);
}

static void test_a_model_without_a_size_stays(void **state)
{
	struct found found = make(1e6f, 0, 0);

	(void)state;
	memset(found.model->node[0].rest.scale, 0, sizeof(float[3]));
	find(&found);
	assert_null(found.shift);
	release(&found);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_only_a_model_farther_than_128_times_its_size_moves),
		cmocka_unit_test(test_a_place_in_the_file_is_kept_to_the_bit),
		cmocka_unit_test(test_a_node_of_a_matrix_moves),
		cmocka_unit_test(
			test_vertices_that_are_far_move_and_their_node_stays),
		cmocka_unit_test(test_vertices_stay_in_a_node_that_a_clip_turns),
		cmocka_unit_test(test_keys_move_but_not_the_tangents_of_splines),
		cmocka_unit_test(test_a_model_that_a_clip_begins_elsewhere_stays),
		cmocka_unit_test(test_a_model_without_a_size_stays),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
