/* What instances in fixed point draw, compared with the same in float. */
#include "app/scene/draw/draw.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/model/instance_pair.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

/* Both draw the same number of vertices with the same mean in eye space. */
static void assert_drawn_equally(struct instance_pair *pair)
{
	struct instance *both[2] = {pair->exact, pair->fixed};
	struct gl_recording drawn[2];

	for (int i = 0; i < 2; i++) {
		struct gl gl = gl_recorder_begin();
		const struct texture_set none = {0};

		draw_instance(&gl, both[i], &none, DRAW_SHADOW);
		drawn[i] = *gl_recorder_result();
		assert_int_equal(drawn[i].depth, 0);
	}
	assert_int_equal(drawn[0].draw_count, drawn[1].draw_count);
	assert_true(drawn[0].vertex_count > 0);
	assert_true(drawn[0].vertex_count == drawn[1].vertex_count);
	for (int axis = 0; axis < 3; axis++) {
		double count = (double)drawn[0].vertex_count;

		assert_near(drawn[1].sum[axis] / count,
			drawn[0].sum[axis] / count, 1e-4);
	}
}

static void test_the_same_triangles_are_drawn(void **state)
{
	static const char *const paths[] = {
		"assets/walker.glb", "assets/arm.glb", "assets/face.glb"};

	(void)state;
	for (int i = 0; i < 3; i++) {
		struct instance_pair pair;

		instance_pair_load(&pair, paths[i]);
		instance_pair_pose(
			&pair, pair.model->clip_count > 0 ? 0 : -1, 0.4f);
		assert_drawn_equally(&pair);
		instance_pair_end(&pair);
	}
}

/* Vertices have another order, and so must their attributes. */
static void test_attributes_go_with_their_vertices(void **state)
{
	struct instance_pair pair;
	int moved = 0;

	(void)state;
	instance_pair_load(&pair, "assets/walker.glb");
	for (int d = 0; d < pair.fixed->drawable_count; d++) {
		const struct drawable *drawable = &pair.fixed->drawable[d];
		const struct model_primitive *primitive = drawable->primitive;
		const struct batch *batch = drawable->batch;

		for (int i = 0; batch->index && i < batch->index_count; i++) {
			uint32_t from = primitive->index[i];
			uint16_t at = batch->index[i];

			moved += from != at;
			if (batch->texcoord) {
				assert_memory_equal(batch->texcoord[at],
					primitive->texcoord[from],
					sizeof(float[2]));
			}
		}
	}
	assert_true(moved > 1000);
	instance_pair_end(&pair);
}

static void test_huge_and_tiny_models_are_drawn_near_one(void **state)
{
	static const float sizes[] = {5000.0f, 1.0f, 0.001f};

	(void)state;
	for (int i = 0; i < 3; i++) {
		struct instance_pair pair;
		const struct fixed_vector *corner;
		float at[3];

		instance_pair_begin(
			&pair, small_model_grid(2, 2, sizes[i], true));
		assert_near(pair.fixed->unit_scale, pair.exact->unit_scale, 0);
		assert_drawn_equally(&pair);
		instance_world_vertex(
			pair.fixed, &pair.fixed->drawable[0], 8, at);
		assert_near(at[0], sizes[i], sizes[i] * 1e-4);
		corner = &pair.fixed->drawable[0].batch[0].fixed_position[8];
		assert_true(corner->x > 16000);
		instance_pair_end(&pair);
	}
}

static void test_gives_flat_normals_where_the_file_has_none(void **state)
{
	struct instance_pair pair;
	const struct batch *batch;

	(void)state;
	instance_pair_begin(&pair, small_model_grid(2, 1, 1.0f, false));
	batch = &pair.fixed->drawable[0].batch[0];
	assert_int_equal(batch->index_count, 12);
	for (int i = 2; i < batch->index_count; i += 3) {
		const struct fixed_vector *normal =
			&batch->fixed_normal[batch->index[i]];

		assert_int_equal(normal->x, 0);
		assert_int_equal(normal->y, 0);
		assert_true(normal->z >= 16384);
	}
	assert_drawn_equally(&pair);
	instance_pair_end(&pair);
}

static void test_cuts_a_mesh_too_large_for_16_bit_indices(void **state)
{
	struct instance_pair pair;

	(void)state;
	instance_pair_begin(&pair, small_model_grid(300, 300, 1.0f, true));
	assert_true(pair.fixed->drawable[0].batch_count > 1);
	assert_drawn_equally(&pair);
	instance_pair_end(&pair);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_same_triangles_are_drawn),
		cmocka_unit_test(test_attributes_go_with_their_vertices),
		cmocka_unit_test(test_huge_and_tiny_models_are_drawn_near_one),
		cmocka_unit_test(test_gives_flat_normals_where_the_file_has_none),
		cmocka_unit_test(test_cuts_a_mesh_too_large_for_16_bit_indices),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
