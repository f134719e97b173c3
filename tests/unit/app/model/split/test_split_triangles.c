/* Triangles are divided into parts of few vertices. */
#include "app/model/split/split_triangles.h"
#include "tests/unit/app/model/split/split_grid.h"

static uint64_t corner_hash(uint64_t a, uint64_t b, uint64_t c)
{
	return (a * 1000003 + b) * 1000003 + c;
}

static uint64_t hash_of(const uint32_t *index, int count, const uint32_t *name)
{
	uint64_t sum = 0;

	for (int i = 0; i < count; i += 3) {
		sum += corner_hash(name ? name[index[i]] : index[i],
			name ? name[index[i + 1]] : index[i + 1],
			name ? name[index[i + 2]] : index[i + 2]);
	}
	return sum;
}

/* Marks the part's vertices in seen, and compares them with earlier parts'. */
static void expect_vertices(const struct split_part *part, int most, bool *seen)
{
	assert_in_range(part->vertex_count, 1, most);
	for (int v = 0; v < part->vertex_count; v++) {
		assert_int_equal(
			seen[part->vertex[v]], v < part->repeated_count);
	}
	for (int v = 0; v < part->vertex_count; v++) {
		seen[part->vertex[v]] = true;
	}
	for (int i = 0; i < part->index_count; i++) {
		assert_in_range(part->index[i], 0, part->vertex_count - 1);
	}
}

/* A part has its triangles in the file's order. */
static void expect_order(
	const struct split_part *part, const struct model_primitive *whole)
{
	int at = 0;

	for (int i = 0; i < part->index_count; i += 3) {
		const uint32_t *own = part->index + i;

		while (at < whole->index_count &&
			(part->vertex[own[0]] != whole->index[at] ||
				part->vertex[own[1]] != whole->index[at + 1] ||
				part->vertex[own[2]] != whole->index[at + 2])) {
			at += 3;
		}
		assert_true(at < whole->index_count);
		at += 3;
	}
}

/* Returns the number of parts. */
static int expect_partition(struct grid *grid, int most)
{
	const struct model_primitive *primitive = &grid->primitive;
	bool *seen = ARENA_ARRAY(&grid->arena, bool, primitive->vertex_count);
	struct split_part *first;
	uint64_t hash = 0;
	int parts = 0, fresh = 0, indices = 0;

	assert_int_equal(
		split_triangles(primitive, most, &grid->arena, &first), 0);
	for (const struct split_part *part = first; part; part = part->next) {
		parts++;
		expect_vertices(part, most, seen);
		expect_order(part, primitive);
		fresh += part->vertex_count - part->repeated_count;
		indices += part->index_count;
		hash += hash_of(part->index, part->index_count, part->vertex);
	}
	assert_int_equal(fresh, primitive->vertex_count);
	assert_int_equal(indices, primitive->index_count);
	assert_true(hash ==
		hash_of(primitive->index, primitive->index_count, NULL));
	return parts;
}

static void test_parts_have_each_triangle_once_and_few_vertices(void **state)
{
	struct grid grid;

	(void)state;
	grid_begin(&grid, 40, 30, 30);
	for (int most = 3; most < 1300; most += most < 20 ? 1 : 97) {
		int parts = expect_partition(&grid, most);

		/* Two triangles a vertex: a part of 3 has but one of them. */
		assert_in_range(parts, 1200 / most, 1 + 8 * 1200 / most);
	}
	assert_int_equal(expect_partition(&grid, 1200), 1);
	assert_int_equal(expect_partition(&grid, 1199), 2);
	arena_release(&grid.arena);
}

static void test_vertices_without_triangles_are_kept(void **state)
{
	struct grid grid;

	(void)state;
	grid_begin(&grid, 40, 30, 7);
	assert_int_equal(expect_partition(&grid, 300), 1 + 4);
	arena_release(&grid.arena);
	grid_begin(&grid, 40, 30, 0);
	assert_int_equal(expect_partition(&grid, 300), 4);
	arena_release(&grid.arena);
}

static void test_triangles_in_one_place_are_divided_by_number(void **state)
{
	struct grid grid;

	(void)state;
	grid_begin(&grid, 40, 30, 30);
	memset(grid.primitive.position, 0, 1200 * sizeof(float[3]));
	assert_in_range(expect_partition(&grid, 200), 6, 12);
	arena_release(&grid.arena);
}

enum {
	ROW = 8 /* triangles that share no vertex */
};

/*
 * Triangles in a row against their number, but one of them far to a side. Their
 * corners are as far apart as the row is long, about the same middle.
 */
static void place_row(struct grid *grid, int axis, int far, float distance)
{
	struct model_primitive *primitive = &grid->primitive;

	grid_begin(grid, 3, ROW, 0);
	memset(primitive->position, 0, 3 * ROW * sizeof(float[3]));
	for (int v = 0; v < 3 * ROW; v++) {
		static const float corner[3] = {7, -3, -4};
		float shift = corner[v % 3] * (float)(v / 3 % 3);

		primitive->position[v][axis] =
			(v / 3 == far ? distance : 0.0f) - shift;
		primitive->position[v][(axis + 1) % 3] =
			(float)(ROW - 1 - v / 3) + shift;
		primitive->index[v] = (uint32_t)v;
	}
	primitive->index_count = 3 * ROW;
}

/* The first two of them by the place on that side, then by number. */
static void expect_first(struct grid *grid, int one, int other)
{
	struct split_part *part = NULL;

	assert_int_equal(split_triangles(&grid->primitive, ROW * 3 / 2,
				 &grid->arena, &part),
		0);
	assert_int_equal(part->vertex_count, 6);
	for (int i = 0; i < 6; i++) {
		int triangle = i < 3 ? one : other;

		assert_int_equal(part->vertex[i], 3 * triangle + i % 3);
	}
}

/* The row's first three are divided again, one of which is higher than they are wide. */
static void test_a_group_is_divided_along_its_own_side(void **state)
{
	struct grid grid;
	struct split_part *part = NULL;

	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		place_row(&grid, axis, ROW - 1, 2.5f);
		assert_int_equal(
			split_triangles(&grid.primitive, 3, &grid.arena, &part),
			0);
		assert_int_equal(part->vertex_count, 3);
		assert_int_equal(part->vertex[0], 3 * (ROW - 3));
		arena_release(&grid.arena);
	}
}

static void test_equal_sides_are_divided_along_the_first(void **state)
{
	struct grid grid;

	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		place_row(&grid, axis, 0, ROW - 1);
		expect_first(
			&grid, axis < 2 ? 1 : ROW - 2, axis < 2 ? 2 : ROW - 1);
		arena_release(&grid.arena);
	}
}

static void test_triangles_are_divided_along_the_longest_side(void **state)
{
	struct grid grid;

	(void)state;
	for (int i = 0; i < 3 * ROW; i++) {
		int far = i / 3, first = far == 0;

		place_row(&grid, i % 3, far, (float)ROW);
		expect_first(&grid, first, far <= 1 ? 2 : 1);
		arena_release(&grid.arena);
		place_row(&grid, i % 3, far, (float)-ROW);
		expect_first(&grid, far ? 0 : far, far ? far : 1);
		arena_release(&grid.arena);
		/* A shorter side than that of the row. */
		place_row(&grid, i % 3, far, 6.5f);
		expect_first(&grid, ROW - 2, ROW - 1);
		arena_release(&grid.arena);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_parts_have_each_triangle_once_and_few_vertices),
		cmocka_unit_test(test_vertices_without_triangles_are_kept),
		cmocka_unit_test(
			test_triangles_are_divided_along_the_longest_side),
		cmocka_unit_test(test_a_group_is_divided_along_its_own_side),
		cmocka_unit_test(test_equal_sides_are_divided_along_the_first),
		cmocka_unit_test(
			test_triangles_in_one_place_are_divided_by_number),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
