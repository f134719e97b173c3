/* What posing takes if only the vertices of a level of detail are posed. */
#include "app/compare/cost/board_cost.h"
#include "app/compare/cost/drawing.h"
#include "app/model/levels/levels.h"
#include "app/scene/instance/instance_play.h"
#include "app/scene/instance/lod.h"
#include "tests/support/test.h"

static struct model *load_walker(void)
{
	struct log log = log_to_nowhere();
	struct model *model;

	assert_int_equal(model_load("assets/walker.glb", &log, &model), 0);
	assert_int_equal(levels_make(model), 0);
	return model;
}

static struct instance *begin(struct model *model)
{
	struct log log = log_to_nowhere();
	struct instance *instance;

	assert_int_equal(instance_create_for_drawing(
				 model, kernel_find("fixed"), &log, &instance),
		0);
	return instance;
}

static struct board_cost left_out_at(struct instance *instance, int level)
{
	struct lod lod = {.kind = LOD_LEVEL, .level = level};
	struct board_cost sum = {0.0, 0.0};

	lod_choose(instance, &lod, 100.0f);
	instance_update(instance);
	for (int i = 0; i < instance->drawable_count; i++) {
		struct board_cost one =
			board_cost_skin_left_out(&instance->drawable[i]);

		board_cost_add(&sum, &one);
	}
	return sum;
}

/* The vertices and runs behind those that the level poses. */
static struct board_cost expected(const struct drawable *drawable)
{
	const struct fixed_skin *skin = &drawable->fixed->skin;
	int posed = fixed_skin_posed_count(skin, drawable->posed_lod);
	int group = fixed_skin_group_count(skin, drawable->posed_lod);
	struct board_cost cost = board_cost_skin_vertices(drawable->primitive,
		skin->order + posed, skin->vertex_count - posed, 0);

	cost.cycles *= 0.88;
	cost.instructions *= 0.96;
	for (; group < skin->group_count; group++) {
		bool one = skin->group[group].influences == 1;
		int runs = skin->group[group].run_count;

		cost.cycles += runs * (one ? 60.0 : 200.0);
		cost.instructions += runs * (one ? 75.0 : 87.0);
	}
	return cost;
}

static void test_a_level_leaves_out_vertices_and_their_runs(void **state)
{
	struct model *model = load_walker();
	struct instance *instance = begin(model);
	double before = 0.0;

	(void)state;
	assert_near(left_out_at(instance, 0).cycles, 0.0, 0.0);
	for (int level = 1; level < 9; level++) {
		struct board_cost cost = left_out_at(instance, level);
		struct board_cost sum = {0.0, 0.0};

		for (int i = 0; i < instance->drawable_count; i++) {
			struct board_cost one = expected(&instance->drawable[i]);

			board_cost_add(&sum, &one);
		}
		assert_near(cost.cycles, sum.cycles, 1e-6);
		assert_near(cost.instructions, sum.instructions, 1e-6);
		assert_true(cost.cycles >= before);
		before = cost.cycles;
	}
	assert_true(before > 0.0);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_vertices_posed_in_float_are_all_posed(void **state)
{
	const struct drawable drawable = {.posed_lod = 3};

	(void)state;
	assert_near(board_cost_skin_left_out(&drawable).cycles, 0.0, 0.0);
	assert_near(board_cost_skin_left_out(&drawable).instructions, 0.0, 0.0);
}

static void test_more_than_8192_vertices_of_a_skin_are_dense(void **state)
{
	struct model *model = load_walker();
	struct model_primitive *primitive = NULL;

	(void)state;
	for (int m = 0; m < model->mesh_count; m++) {
		if (model->mesh[m].primitive[0].influences > 0) {
			primitive = &model->mesh[m].primitive[0];
		}
	}
	assert_non_null(primitive);
	assert_false(instance_is_dense(model));
	primitive->vertex_count = 8192;
	assert_false(instance_is_dense(model));
	primitive->vertex_count = 8193;
	assert_true(instance_is_dense(model));
	primitive->influences = 0;
	assert_false(instance_is_dense(model));
	model_destroy(model);
}

/* Vertices that were left out of the pose are not drawn where they were. */
static void test_a_finer_level_is_posed_before_it_is_drawn(void **state)
{
	struct log log = log_to_nowhere();
	struct model *model = load_walker();
	struct instance *instance = begin(model);
	struct bounds box = bounds_of_clip(instance, -1);
	struct drawing *drawing;

	(void)state;
	assert_int_equal(
		drawing_create(instance, &box, 480, 640, &log, &drawing), 0);
	left_out_at(instance, 99);
	instance->lod_px_per_unit = 0.0f;
	drawing_draw(drawing, instance, drawing_extent(instance));
	assert_true(instance->drawable[0].lod < 8);
	assert_false(instance_is_stale(instance));
	drawing_destroy(drawing);
	instance_destroy(instance);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_level_leaves_out_vertices_and_their_runs),
		cmocka_unit_test(test_vertices_posed_in_float_are_all_posed),
		cmocka_unit_test(
			test_more_than_8192_vertices_of_a_skin_are_dense),
		cmocka_unit_test(test_a_finer_level_is_posed_before_it_is_drawn),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
