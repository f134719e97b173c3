/*
 * Facets: the same triangles of vertices that no two triangles end in, and
 * normals against those of doubles.
 */
#include "app/scene/instance/batch/facets.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
	AROUND = 24,
	DOWN = 20,
	RANDOM_VERTICES = 300,
	RANDOM_TRIANGLES = 900,
	INDICES = 3 *
		(2 * AROUND * DOWN > RANDOM_TRIANGLES ? 2 * AROUND * DOWN
						      : RANDOM_TRIANGLES),
	ROUNDS = 4000,
};

/* A closed surface, whose upper and lower ends are joined. */
static struct model_primitive make_torus(uint32_t index[INDICES])
{
	int count = 0;

	for (int j = 0; j < DOWN; j++) {
		for (int i = 0; i < AROUND; i++) {
			uint32_t a = (uint32_t)(j * AROUND + i);
			uint32_t b = (uint32_t)(j * AROUND + (i + 1) % AROUND);
			uint32_t below = (uint32_t)((j + 1) % DOWN * AROUND);
			uint32_t c = below + (uint32_t)i;
			uint32_t d = below + (uint32_t)((i + 1) % AROUND);
			const uint32_t two[6] = {a, b, c, c, b, d};

			memcpy(index + count, two, sizeof(two));
			count += 6;
		}
	}
	return (struct model_primitive){.vertex_count = AROUND * DOWN,
		.index = index,
		.index_count = count};
}

/* Some vertices are in no triangle, some triangles have one twice. */
static struct model_primitive make_random(uint32_t seed, uint32_t index[INDICES])
{
	for (int i = 0; i < 3 * RANDOM_TRIANGLES; i++) {
		index[i] = next_random(&seed) % (RANDOM_VERTICES - 20);
	}
	return (struct model_primitive){.vertex_count = RANDOM_VERTICES,
		.index = index,
		.index_count = 3 * RANDOM_TRIANGLES};
}

/* The same for each corner that the triangle may begin with. */
static uint64_t name_of(uint32_t a, uint32_t b, uint32_t c)
{
	const uint64_t names[3] = {(uint64_t)a << 40 | (uint64_t)b << 20 | c,
		(uint64_t)b << 40 | (uint64_t)c << 20 | a,
		(uint64_t)c << 40 | (uint64_t)a << 20 | b};
	uint64_t least = names[0] < names[1] ? names[0] : names[1];

	return least < names[2] ? least : names[2];
}

static int compare_names(const void *left, const void *right)
{
	const uint64_t *a = left, *b = right;

	return *a < *b ? -1 : *a > *b;
}

static void expect_facets(const struct model_primitive *primitive)
{
	static uint64_t given[INDICES / 3], made[INDICES / 3];
	struct arena arena = arena_empty();
	int triangles = primitive->index_count / 3;
	struct facets facets;
	uint8_t *ends;

	assert_int_equal(facets_make(primitive, &arena, &facets), 0);
	ends = calloc((size_t)facets.vertex_count, 1);
	assert_non_null(ends);
	for (int v = 0; v < primitive->vertex_count; v++) {
		uint32_t at = facets.inverse_order[v];

		assert_in_range(at, 0, facets.vertex_count - 1);
		assert_int_equal(facets.source[at], v);
	}
	for (int i = 0; i < triangles; i++) {
		const uint32_t *from = primitive->index + 3 * i;
		const uint16_t *to = facets.index + 3 * i;

		given[i] = name_of(from[0], from[1], from[2]);
		made[i] = name_of(facets.source[to[0]], facets.source[to[1]],
			facets.source[to[2]]);
		assert_in_range(to[2], 0, facets.vertex_count - 1);
		assert_false(ends[to[2]]);
		ends[to[2]] = 1;
	}
	qsort(given, (size_t)triangles, sizeof(*given), compare_names);
	qsort(made, (size_t)triangles, sizeof(*made), compare_names);
	assert_memory_equal(given, made, (size_t)triangles * sizeof(*given));
	free(ends);
	arena_release(&arena);
}

static void test_each_triangle_ends_in_a_vertex_of_its_own(void **state)
{
	static uint32_t index[INDICES];
	struct model_primitive primitive = make_torus(index);

	(void)state;
	expect_facets(&primitive);
	for (uint32_t seed = 1; seed <= 20; seed++) {
		primitive = make_random(seed, index);
		expect_facets(&primitive);
	}
	primitive.index_count = 0;
	expect_facets(&primitive);
}

static void test_closed_surfaces_need_about_a_vertex_a_triangle(void **state)
{
	static uint32_t index[INDICES];
	struct model_primitive primitive = make_torus(index);
	struct arena arena = arena_empty();
	struct facets facets;

	(void)state;
	assert_int_equal(facets_make(&primitive, &arena, &facets), 0);
	assert_in_range(facets.vertex_count, primitive.index_count / 3,
		primitive.index_count / 3 * 11 / 10);
	arena_release(&arena);
}

static void test_more_vertices_than_indices_can_name_are_refused(void **state)
{
	const int triangles = 70000;
	uint32_t *index = calloc((size_t)triangles * 3, sizeof(*index));
	struct model_primitive primitive = {
		.vertex_count = 40000, .index = index};
	struct arena arena = arena_empty();
	struct facets facets;

	(void)state;
	assert_non_null(index);
	for (int i = 0; i < triangles * 3; i++) {
		index[i] = (uint32_t)i % 40000;
	}
	primitive.index_count = 65536 * 3;
	assert_int_equal(facets_make(&primitive, &arena, &facets), 0);
	primitive.index_count = 65537 * 3;
	assert_int_equal(facets_make(&primitive, &arena, &facets), -ERANGE);
	primitive.vertex_count = 65537;
	primitive.index_count = 3;
	assert_int_equal(facets_make(&primitive, &arena, &facets), -ERANGE);
	arena_release(&arena);
	free(index);
}

/* The last vertex of indices of 16 bits is a vertex like others. */
static void test_all_vertices_that_indices_can_name_are_kept(void **state)
{
	enum {
		ALL = 65536
	};
	uint32_t *index = calloc(ALL + 2, sizeof(*index));
	const struct model_primitive primitive = {
		.vertex_count = ALL, .index = index, .index_count = ALL + 2};
	struct arena arena = arena_empty();
	struct facets facets;

	(void)state;
	assert_non_null(index);
	for (uint32_t i = 0; i < ALL; i++) {
		index[i] = i;
	}
	assert_int_equal(facets_make(&primitive, &arena, &facets), 0);
	assert_int_equal(facets.vertex_count, ALL);
	arena_release(&arena);
	free(index);
}

static void make_corner(uint32_t *seed, int reach, struct fixed_vector *out)
{
	*out = (struct fixed_vector){
		.x = (int16_t)random_within(seed, reach),
		.y = (int16_t)random_within(seed, reach),
		.z = (int16_t)random_within(seed, reach),
	};
}

/* The normal of doubles, not of unit length; and its length. */
static double find_normal(const struct fixed_vector corner[3], double out[3])
{
	double u[3] = {corner[1].x - corner[0].x, corner[1].y - corner[0].y,
		corner[1].z - corner[0].z};
	double v[3] = {corner[2].x - corner[0].x, corner[2].y - corner[0].y,
		corner[2].z - corner[0].z};

	out[0] = u[1] * v[2] - u[2] * v[1];
	out[1] = u[2] * v[0] - u[0] * v[2];
	out[2] = u[0] * v[1] - u[1] * v[0];
	return sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
}

/* Within 0.02 degrees, or 1 part of 2^14 of a side where the sides are long. */
static void expect_fixed_normal(
	const struct fixed_vector corner[3], const struct fixed_vector *got)
{
	double normal[3], length = find_normal(corner, normal), dot, size;

	size = sqrt((double)got->x * got->x + (double)got->y * got->y +
		(double)got->z * got->z);
	if (length == 0.0) {
		assert_true(size == 0.0);
		return;
	}
	dot = (normal[0] * got->x + normal[1] * got->y + normal[2] * got->z);
	assert_true(size >= 16383.0);
	assert_true(dot / length / size > 0.9999999);
}

static void test_fixed_normals_are_those_of_doubles(void **state)
{
	static const int reaches[] = {3, 40, 500, 8000, 16000};
	static const uint16_t index[] = {2, 0, 1};
	uint32_t seed = 1;

	(void)state;
	for (int round = 0; round < ROUNDS; round++) {
		struct fixed_vector corner[3], normal[3] = {{0}};

		for (int i = 0; i < 3; i++) {
			make_corner(&seed, reaches[round % 5], &corner[i]);
		}
		facets_find_fixed_normals(NULL, 3, corner, normal);
		for (int i = 0; i < 3; i++) {
			expect_fixed_normal(corner, &normal[i]);
		}
		memset(normal, 0, sizeof(normal));
		facets_find_fixed_normals(index, 3, corner, normal);
		expect_fixed_normal(corner, &normal[1]);
		assert_int_equal(normal[0].x | normal[2].x, 0);
	}
}

static void test_normals_of_the_largest_triangles_are_right(void **state)
{
	static const int16_t ends[] = {INT16_MIN, -1, 0, 1, INT16_MAX};
	uint32_t seed = 5;

	(void)state;
	for (int round = 0; round < ROUNDS; round++) {
		struct fixed_vector corner[3], normal[3] = {{0}};
		double exact[3], length, dot, size;

		for (int i = 0; i < 3; i++) {
			corner[i] = (struct fixed_vector){
				.x = ends[next_random(&seed) % 5],
				.y = ends[next_random(&seed) % 5],
				.z = ends[next_random(&seed) % 5]};
		}
		length = find_normal(corner, exact);
		facets_find_fixed_normals(NULL, 3, corner, normal);
		size = sqrt((double)normal->x * normal->x +
			(double)normal->y * normal->y +
			(double)normal->z * normal->z);
		/* Slivers are as wide as what is rounded off. */
		if (length > 1e6) {
			dot = exact[0] * normal->x + exact[1] * normal->y +
				exact[2] * normal->z;
			assert_true(dot / length / size > 0.9999);
		}
	}
}

/* With and without indices; a sliver without area has none. */
static void test_normals_of_floats_have_the_length_1_or_0(void **state)
{
	static const uint16_t index[] = {3, 0, 1, 1, 2, 0};
	static const float position[6][3] = {{0, 0, 0}, {0, 0, 2}, {0, 0, 5},
		{3, 0, 0}, {4, 4, 4}, {4, 4, 4}};
	float normal[6][3] = {{9, 9, 9}};

	(void)state;
	facets_find_normals(index, 6, position, normal);
	assert_all_near(normal[1], ((const float[]){0, 1, 0}), 3, 1e-6);
	assert_all_near(normal[0], ((const float[]){0, 0, 0}), 3, 0);
	facets_find_normals(NULL, 6, position, normal);
	for (int v = 0; v < 3; v++) {
		assert_all_near(normal[v], ((const float[]){0, 0, 0}), 3, 0);
	}
	assert_all_near(normal[3], normal[5], 3, 0);
	assert_all_near(normal[4], ((const float[]){0, 0, 0}), 3, 0);
}

static void test_turned_normals_point_the_other_way(void **state)
{
	float normal[2][3] = {{0.5f, -0.25f, 0.75f}, {-1, 2, -3}};
	const float turned[2][3] = {{-0.5f, 0.25f, -0.75f}, {1, -2, 3}};
	struct fixed_vector fixed[2] = {{0, 5, -6, 7}, {0, -8, 9, -10}};

	(void)state;
	facets_turn_normals(2, normal);
	assert_all_near(normal, turned, 6, 0);
	facets_turn_fixed_normals(1, fixed);
	assert_int_equal(fixed[0].x, -5);
	assert_int_equal(fixed[0].y, 6);
	assert_int_equal(fixed[0].z, -7);
	assert_int_equal(fixed[1].x, -8);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_triangle_ends_in_a_vertex_of_its_own),
		cmocka_unit_test(
			test_closed_surfaces_need_about_a_vertex_a_triangle),
		cmocka_unit_test(
			test_more_vertices_than_indices_can_name_are_refused),
		cmocka_unit_test(
			test_all_vertices_that_indices_can_name_are_kept),
		cmocka_unit_test(test_fixed_normals_are_those_of_doubles),
		cmocka_unit_test(test_normals_of_the_largest_triangles_are_right),
		cmocka_unit_test(test_normals_of_floats_have_the_length_1_or_0),
		cmocka_unit_test(test_turned_normals_point_the_other_way),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
