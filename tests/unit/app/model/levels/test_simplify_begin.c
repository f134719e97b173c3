/* What a simplification begins with, in numbers worked out by hand. */
#include "app/model/levels/simplify.h"

#include "tests/support/test.h"

#include <string.h>

enum {
	VERTICES = 5,
	INDICES = 15
};

/* The vertices 0 and 3 are at one place. */
static float position[VERTICES][3] = {
	{10, 20, 30}, {13, 24, 30}, {10, 24, 30}, {10, 20, 30}, {10, 24, 42}};
static float texcoord[VERTICES][2] = {
	{0, 0}, {0.3f, 0.4f}, {0.3f, 0}, {5, 5}, {7, 7}};
static float normal[VERTICES][3];

/* Of five triangles three have two corners at one place. */
static const uint32_t list[INDICES] = {
	0, 1, 2, 0, 3, 1, 1, 0, 3, 3, 1, 0, 1, 2, 3};
static const bool shared[VERTICES];

static void begin(struct simplify *simplify, bool textured, bool shape_only)
{
	static struct model_primitive primitive;
	const struct simplify_input input = {
		.primitive = &primitive,
		.index = list,
		.index_count = INDICES,
		.extent = 2.0f,
		.shared = shared,
		.shape_only = shape_only,
	};

	primitive = (struct model_primitive){.vertex_count = VERTICES,
		.position = position,
		.normal = normal,
		.texcoord = textured ? texcoord : NULL};
	assert_int_equal(simplify_begin(simplify, &input, NULL), 0);
	assert_int_equal(simplify->index_count, 6);
	for (uint32_t v = 0; v < VERTICES; v++) {
		assert_int_equal(simplify->to[v], v);
		assert_int_equal(simplify->known[v], SIMPLIFY_NOTHING);
		assert_false(simplify->locked[v]);
	}
}

static void test_positions_are_parts_of_the_extent(void **state)
{
	static const float expected[VERTICES][3] = {
		{0, 0, 0}, {1.5f, 2, 0}, {0, 2, 0}, {0, 0, 0}, {0, 2, 6}};
	struct simplify simplify;

	(void)state;
	begin(&simplify, false, false);
	assert_all_near(simplify.position, expected, 3 * VERTICES, 0);
	simplify_end(&simplify);
}

static void test_triangles_of_two_places_are_left_out(void **state)
{
	static const uint32_t whole[6] = {0, 1, 2, 1, 2, 3};
	static const uint32_t shape[6] = {0, 1, 2, 1, 2, 0};
	struct simplify simplify;

	(void)state;
	begin(&simplify, false, false);
	assert_memory_equal(simplify.index, whole, sizeof(whole));
	simplify_end(&simplify);
	/* A shape needs one vertex a place. */
	begin(&simplify, false, true);
	assert_memory_equal(simplify.index, shape, sizeof(shape));
	assert_false(simplify.divided);
	simplify_end(&simplify);
}

/* Edges of 5 and 3, of an extent of 2, cover 0.5 and 0.4 of the picture. */
static void test_the_texture_has_the_scale_of_the_first_edges(void **state)
{
	struct simplify simplify;

	(void)state;
	begin(&simplify, true, false);
	assert_near(simplify.texture_scale, 4 / 0.9, 1e-5);
	simplify_end(&simplify);
	begin(&simplify, false, false);
	assert_near(simplify.texture_scale, 0, 0);
	simplify_end(&simplify);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_positions_are_parts_of_the_extent),
		cmocka_unit_test(test_triangles_of_two_places_are_left_out),
		cmocka_unit_test(
			test_the_texture_has_the_scale_of_the_first_edges),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
