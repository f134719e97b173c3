/* How many moments and frames of clips a comparison looks at. */
#include "app/compare/measure/sampling.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <limits.h>

static void test_ordinary_clips_are_compared_as_a_whole(void **state)
{
	struct sampling sampling = sampling_choose(5000, 5, 1200.0);

	(void)state;
	assert_near(sampling.share, 1.0, 0.0);
	assert_int_equal(sampling.normal_moments, SAMPLING_NORMALS_MAX);
	assert_int_equal(sampling.timed_frames, SAMPLING_TIMED_MAX);
	assert_int_equal(sampling.drawn_frames, 6);
	/* Half a minute of a large model, and a quarter of an hour of a cube. */
	assert_near(sampling_choose(65000, 1, 1800.0).share, 1.0, 0.0);
	assert_near(sampling_choose(8, 1, 54000.0).share, 1.0, 0.0);
	assert_near(sampling_choose(0, 1, 54000.0).share, 1.0, 0.0);
	/* exactly as many moments as may be compared */
	assert_int_equal(sampling_choose(5000, 20, 6000.0).normal_moments,
		SAMPLING_NORMALS_MAX);
	assert_int_equal(sampling_choose(5000, 20, 6000.1).normal_moments, 100);
}

static void test_an_hour_is_compared_in_part(void **state)
{
	(void)state;
	assert_near(
		sampling_choose(5000, 1, 216000.0).share, 6000.0 / 216e3, 1e-9);
	assert_near(
		sampling_choose(8, 1, 216000.0).share, 60000.0 / 216e3, 1e-9);
	assert_near(sampling_choose(65000, 1, 216000.0).share, 2000.0 / 216e3,
		1e-9);
	assert_near(sampling_choose(64000, 1, 216000.0).share, 2000.0 / 216e3,
		1e-9);
	assert_int_equal(sampling_choose(5000, 1, 216000.0).normal_moments,
		SAMPLING_NORMALS_MAX);
}

/* So many vertices that even a few seconds would take minutes. */
static void test_a_huge_model_is_compared_in_part(void **state)
{
	struct sampling sampling = sampling_choose(360000, 3, 900.0);

	(void)state;
	assert_near(sampling.share, 361.0 / 900.0, 1e-9);
	assert_int_equal(sampling.normal_moments, 37);
	assert_near(
		sampling_choose(2000000000, 3, 900.0).share, 1.0 / 900.0, 1e-9);
	assert_int_equal(
		sampling_choose(2000000000, 3, 900.0).normal_moments, 1);
	assert_int_equal(
		sampling_choose(2000000000, 1, 900.0).normal_moments, 1);
}

static void test_many_clips_share_the_frames(void **state)
{
	struct sampling sampling = sampling_choose(5000, 300, 32000.0);

	(void)state;
	assert_near(sampling.share, 6000.0 / 32e3, 1e-9);
	assert_int_equal(sampling.normal_moments, 6);
	assert_int_equal(sampling.timed_frames, 6);
	assert_int_equal(sampling.drawn_frames, 1);
	sampling = sampling_choose(5000, 41, 4000.0);
	assert_int_equal(sampling.timed_frames, 46);
	assert_int_equal(sampling.drawn_frames, 5);
	/* normals of 2000 moments together, however few vertices there are */
	assert_int_equal(sampling_choose(8, 5, 1e7).normal_moments, 400);
	assert_int_equal(sampling_choose(8, 667, 1e7).normal_moments, 2);
	assert_int_equal(sampling_choose(8, 100000, 1e7).normal_moments, 1);
	sampling = sampling_choose(5000, 40, 4000.0);
	assert_int_equal(sampling.timed_frames, SAMPLING_TIMED_MAX);
	assert_int_equal(sampling.drawn_frames, 6);
	assert_int_equal(sampling_choose(8, 100000, 1e7).timed_frames, 1);
}

/* Each node that shows a mesh poses its vertices, outside of the scene none. */
static void test_a_shared_mesh_counts_for_each_node(void **state)
{
	struct model *model = small_model_grid(4, 2, 1, true);
	struct model_node *one = model->node;
	struct model_node nodes[4] = {*one, *one, *one, *one};

	(void)state;
	assert_int_equal(sampling_vertices(model), 15);
	nodes[2].mesh = -1;
	nodes[3].in_scene = false;
	model->node = nodes;
	model->node_count = 4;
	assert_int_equal(sampling_vertices(model), 30);
	model->mesh->primitive->vertex_count = 2000000000;
	assert_int_equal(sampling_vertices(model), INT_MAX);
	model->mesh->primitive->vertex_count = 0;
	assert_int_equal(sampling_vertices(model), 0);
	model->mesh->primitive->vertex_count = 15;
	model->node = one;
	model->node_count = 1;
	model_destroy(model);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_ordinary_clips_are_compared_as_a_whole),
		cmocka_unit_test(test_an_hour_is_compared_in_part),
		cmocka_unit_test(test_a_huge_model_is_compared_in_part),
		cmocka_unit_test(test_many_clips_share_the_frames),
		cmocka_unit_test(test_a_shared_mesh_counts_for_each_node),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
