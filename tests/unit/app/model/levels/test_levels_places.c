/* What levels of detail depend on: sizes, places in common, lists there are. */
#include "app/model/levels/levels.h"
#include "tests/unit/app/model/levels/levels_net.h"

#include <math.h>

/* Turns the nets, which lie in x and y, so that those become other axes. */
static void turn(struct net *net, int primitives, int by)
{
	for (int i = 0; i < primitives * COUNT; i++) {
		struct model_primitive *primitive = &net->primitive[i / COUNT];
		float *vectors[] = {primitive->position[i % COUNT],
			primitive->normal[i % COUNT]};

		for (int k = 0; k < 2; k++) {
			float old[3];

			memcpy(old, vectors[k], sizeof(old));
			for (int axis = 0; axis < 3; axis++) {
				vectors[k][(axis + by) % 3] = old[axis];
			}
		}
	}
}

/* Whether all levels of a net have all vertices of a side: 0 to 3. */
static bool has_side(const struct model_primitive *primitive, int side)
{
	assert_true(primitive->lod_count > 0);
	for (int l = 0; l < primitive->lod_count; l++) {
		for (uint32_t i = 0; i < ROW; i++) {
			uint32_t at = side == 0 ? i * ROW
				: side == 1     ? i * ROW + SIDE
				: side == 2     ? i
						: SIDE * ROW + i;

			if (!has_vertex(&primitive->lod[l], at)) {
				return false;
			}
		}
	}
	return true;
}

/* Nets touch at a side, or lie on each other without touching. */
static void test_vertices_are_common_where_all_axes_agree(void **state)
{
	(void)state;
	for (int i = 0; i < 9; i++) {
		int by = i / 3, way = i % 3;
		struct net net = make_net(shape_flat, 2);

		for (int v = 0; v < COUNT; v++) {
			float *at = net.primitive[1].position[v];

			memcpy(at, net.primitive[0].position[v],
				sizeof(float[3]));
			at[way] += 1;
		}
		turn(&net, 2, by);
		assert_int_equal(levels_make(net.model), 0);
		for (int side = 0; side < 4; side++) {
			assert_int_equal(has_side(&net.primitive[0], side),
				way < 2 && side == 2 * way + 1);
			assert_int_equal(has_side(&net.primitive[1], side),
				way < 2 && side == 2 * way);
		}
		free_net(&net);
	}
}

/* One vertex alone may make the model long, on any axis and to either end. */
static void test_errors_are_shares_of_the_longest_side(void **state)
{
	float one;
	struct net plain = make_net(shape_flat, 1);

	(void)state;
	assert_int_equal(levels_make(plain.model), 0);
	one = plain.primitive->lod[0].error_m;
	free_net(&plain);
	for (int i = 0; i < 12; i++) {
		int axis = i % 3, vertex = i / 6 ? COUNT - 1 : 0;
		struct net net = make_net(shape_flat, 1);
		float *at = net.primitive->position[vertex];

		for (int v = 0; v < COUNT; v++) {
			net.primitive->position[v][axis] += 7;
		}
		at[axis] = i / 3 % 2 ? 11 : 4;
		assert_int_equal(levels_make(net.model), 0);
		/* From 4 to 8, or from 7 to 11; flat ones end or begin at 7. */
		assert_near(net.primitive->lod[0].error_m,
			one * (axis < 2 || i / 3 % 2 ? 4 : 3), 1e-6);
		free_net(&net);
	}
}

/* Levels are for 150 triangles or more. */
static void test_the_least_number_of_triangles_is_150(void **state)
{
	(void)state;
	for (int count = 149; count <= 150; count++) {
		struct net net = make_net(shape_flat, 1);

		net.primitive->index_count = 3 * count;
		assert_int_equal(levels_make(net.model), 0);
		assert_int_equal(net.primitive->lod_count > 0, count == 150);
		free_net(&net);
	}
}

static void shape_bowl(
	float u, float v, float position[3], float normal[3], uint8_t color[4])
{
	float x = 2 * u - 1, y = 2 * v - 1;
	float length = sqrtf(0.36f * (x * x + y * y) + 1);

	position[0] = x;
	position[1] = y;
	position[2] = 0.3f * (x * x + y * y);
	normal[0] = -0.6f * x / length;
	normal[1] = -0.6f * y / length;
	normal[2] = 1 / length;
	memset(color, 255, 4);
}

/* From one level to the next, errors grow to about the double. */
static void test_levels_follow_each_other_closely(void **state)
{
	struct net net = make_net(shape_bowl, 1);
	const struct model_primitive *primitive = net.primitive;
	int shadows = 0;

	(void)state;
	assert_int_equal(levels_make(net.model), 0);
	for (int i = 0; i < primitive->lod_count; i++) {
		const struct model_lod *lod = &primitive->lod[i];

		shadows += lod->shadow_only;
		/* Of sides that are 2 long. */
		assert_true(lod->error_m <=
			2 * (lod->shadow_only ? 0.081f : 0.031f));
		if (i > 0 && lod[-1].shadow_only == lod->shadow_only) {
			assert_in_range(1000 * lod->error_m / lod[-1].error_m,
				1500, 2200);
		}
	}
	assert_int_equal(shadows, 5);
	assert_int_equal(primitive->lod_count - shadows, 7);
	free_net(&net);
}

/* A list for shadows in the file is where further ones begin. */
static void test_further_shadows_begin_with_the_files_coarsest(void **state)
{
	(void)state;
	for (int i = 0; i < 2; i++) {
		struct net net = make_net(shape_flat, 1);
		struct model_primitive *primitive = net.primitive;
		/* The second list is that of the lower half. */
		struct model_lod own[] = {
			{.error_m = 0.001f,
				.index_count = INDICES,
				.index = primitive->index},
			{.error_m = 0.002f,
				.shadow_only = i == 1,
				.index_count = INDICES / 2,
				.index = primitive->index},
		};
		int last;

		primitive->lod = own;
		primitive->lod_count = 2;
		assert_int_equal(levels_make(net.model), 0);
		last = primitive->lod_count - 1;
		assert_true(last > 1);
		assert_true(primitive->lod[last].shadow_only);
		/* The corner at the upper end. */
		assert_int_equal(
			has_vertex(&primitive->lod[last], COUNT - 1), i == 0);
		assert_memory_equal(primitive->lod, own, sizeof(own));
		free_net(&net);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_vertices_are_common_where_all_axes_agree),
		cmocka_unit_test(test_errors_are_shares_of_the_longest_side),
		cmocka_unit_test(test_the_least_number_of_triangles_is_150),
		cmocka_unit_test(test_levels_follow_each_other_closely),
		cmocka_unit_test(
			test_further_shadows_begin_with_the_files_coarsest),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
