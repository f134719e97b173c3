/*
 * The order of a skinned primitive's vertices, and how many of them a level of
 * detail needs.
 */
#include "app/anim/kernel/layout/fixed_skin.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	VERTICES = 32,
	WIDTH = 3,
	FULL = 96,
	LEVELS_MAX = 8,
	TALL = 3 << 16
};

struct fixture {
	float position[VERTICES][3];
	uint16_t joint[VERTICES][WIDTH];
	float weight[VERTICES][WIDTH];
	uint32_t index[TALL];
	struct model_lod lod[LEVELS_MAX + 1];
	struct model_primitive primitive;
	struct arena arena;
	struct fixed_skin skin;
};

/* Every vertex is at joint 0; the full list uses all of them. */
static void set_up(struct fixture *f)
{
	memset(f, 0, sizeof(*f));
	for (int v = 0; v < VERTICES; v++) {
		f->position[v][0] = (float)v;
		f->weight[v][0] = 1;
	}
	for (int i = 0; i < FULL; i++) {
		f->index[i] = (uint32_t)i % VERTICES;
	}
	f->primitive = (struct model_primitive){.vertex_count = VERTICES,
		.position = f->position,
		.influences = WIDTH,
		.joint = f->joint[0],
		.weight = f->weight[0],
		.index_count = FULL,
		.index = f->index,
		.lod = f->lod};
}

static void lay_out(struct fixture *f, unsigned streams)
{
	assert_int_equal(
		fixed_skin_init(&f->skin, &f->primitive, streams, &f->arena), 0);
}

static struct model_lod *add_level(
	struct fixture *f, uint32_t *index, int index_count)
{
	struct model_lod *lod = &f->lod[f->primitive.lod_count++];

	*lod = (struct model_lod){.index = index, .index_count = index_count};
	return lod;
}

/* Whether a vertex is among those that a level needs. */
static bool is_posed(const struct fixture *f, int level, uint32_t vertex)
{
	return f->skin.inverse_order[vertex] <
		(uint32_t)fixed_skin_posed_count(&f->skin, level);
}

/* A level's groups have the vertices that are counted for it. */
static void assert_groups(const struct fixture *f, int level)
{
	int vertices = 0;

	for (int g = 0; g < fixed_skin_group_count(&f->skin, level); g++) {
		const int32_t *run = f->skin.group[g].run;

		assert_true(f->skin.group[g].run_count > 0);
		for (int r = 0; r < f->skin.group[g].run_count; r++) {
			vertices += run[0];
			run += 1 + f->skin.group[g].influences;
		}
	}
	assert_int_equal(vertices, fixed_skin_posed_count(&f->skin, level));
}

static void assert_counts(
	const struct fixture *f, const int *posed, const int *groups)
{
	for (int level = 0; level <= f->primitive.lod_count; level++) {
		assert_int_equal(
			fixed_skin_posed_count(&f->skin, level), posed[level]);
		assert_int_equal(
			fixed_skin_group_count(&f->skin, level), groups[level]);
		assert_groups(f, level);
	}
}

/* 27 indices are more than a quarter of 96, 24 are one, and so are 6 of 24. */
static void add_levels(struct fixture *f)
{
	static uint32_t first[27], second[24] = {30, 9, 10, 11},
				   third[6] = {9, 17, 9, 17, 9, 17};

	for (int i = 0; i < 27; i++) {
		first[i] = (uint32_t)i;
	}
	for (int i = 4; i < 24; i++) {
		second[i] = 12;
	}
	add_level(f, first, 27);
	add_level(f, second, 24);
	add_level(f, third, 6);
}

static void test_each_quarter_of_the_triangles_begins_a_tier(void **state)
{
	/* 9 and 17; also 10, 11, 12 and 30; all. */
	static const int posed[] = {32, 32, 6, 2}, groups[] = {3, 3, 2, 1};
	static struct fixture f;

	(void)state;
	set_up(&f);
	add_levels(&f);
	/* Behind the last level. */
	f.lod[3] = (struct model_lod){.index = f.index, .index_count = 6};
	lay_out(&f, FIXED_TIERS);
	assert_counts(&f, posed, groups);
	assert_int_equal(f.skin.order[0], 9);
	assert_int_equal(f.skin.order[1], 17);
	assert_int_equal(f.skin.order[2], 10);
	assert_int_equal(f.skin.order[5], 30);
	assert_int_equal(f.skin.order[6], 0);
	arena_release(&f.arena);
}

static void test_without_tiers_each_level_needs_all(void **state)
{
	static const int posed[] = {32, 32, 32, 32}, groups[] = {1, 1, 1, 1};
	static struct fixture f;

	(void)state;
	set_up(&f);
	add_levels(&f);
	lay_out(&f, 0);
	assert_counts(&f, posed, groups);
	assert_int_equal(f.skin.tier_count, 1);
	arena_release(&f.arena);
}

/* 12 indices are a quarter of 48, but a tier began at 24. */
static void test_a_quarter_is_one_of_the_tier_before(void **state)
{
	static const int posed[] = {32, 2, 2, 1}, groups[] = {3, 2, 2, 1};
	static uint32_t index[24];
	static struct fixture f;

	(void)state;
	set_up(&f);
	index[23] = 4;
	add_level(&f, index, 24);
	add_level(&f, index, 12);
	add_level(&f, index, 6);
	lay_out(&f, FIXED_TIERS);
	assert_counts(&f, posed, groups);
	arena_release(&f.arena);
}

static void test_a_level_without_triangles_needs_no_vertices(void **state)
{
	static const int posed[] = {32, 1, 0}, groups[] = {2, 1, 0};
	static uint32_t index[24];
	static struct fixture f;

	(void)state;
	set_up(&f);
	add_level(&f, index, 24);
	add_level(&f, index, 0);
	lay_out(&f, FIXED_TIERS);
	assert_counts(&f, posed, groups);
	arena_release(&f.arena);
}

static void test_a_level_may_add_no_vertices(void **state)
{
	static const int posed[] = {32, 2, 2}, groups[] = {2, 1, 1};
	static uint32_t index[24];
	static struct fixture f;

	(void)state;
	set_up(&f);
	for (int i = 0; i < 24; i++) {
		index[i] = i % 2 ? 5 : 31;
	}
	add_level(&f, index, 24);
	add_level(&f, index, 6);
	lay_out(&f, FIXED_TIERS);
	assert_counts(&f, posed, groups);
	arena_release(&f.arena);
}

/* No vertex is outside the coarser level: the last tier has none. */
static void test_the_full_list_may_add_no_vertices(void **state)
{
	static const int posed[] = {32, 32, 1}, groups[] = {2, 2, 1};
	static uint32_t index[FULL / 3 + 1];
	static struct fixture f;

	(void)state;
	set_up(&f);
	for (int i = 0; i < FULL / 3 + 1; i++) {
		index[i] = (uint32_t)i % VERTICES;
	}
	f.primitive.index_count = 4 * (FULL / 3 + 1);
	add_level(&f, index, FULL / 3 + 1);
	add_level(&f, index, 1);
	lay_out(&f, FIXED_TIERS);
	assert_counts(&f, posed, groups);
	arena_release(&f.arena);
}

/* A list for shadows belongs to the coarsest level that is not below it. */
static void test_shadows_need_their_vertices_at_their_level(void **state)
{
	static const struct {
		int index_count;
		int level; /* the coarsest one that needs the list */
	} cases[] = {{48, 1}, {27, 1}, {25, 1}, {24, 2}, {7, 2}, {6, 3}, {3, 3}};
	static uint32_t index[48];

	(void)state;
	for (int i = 0; i < 48; i++) {
		index[i] = 29;
	}
	for (size_t c = 0; c < ARRAY_COUNT(cases); c++) {
		static struct fixture f;

		set_up(&f);
		add_levels(&f);
		add_level(&f, index, cases[c].index_count)->shadow_only = true;
		lay_out(&f, FIXED_TIERS);
		for (int level = 0; level <= 3; level++) {
			assert_int_equal(is_posed(&f, level, 29),
				level <= cases[c].level);
		}
		assert_false(is_posed(&f, 2, 28));
		arena_release(&f.arena);
	}
}

/* The normal of a flat triangle comes from all its corners. */
static void test_corners_bring_their_triangles(void **state)
{
	static uint32_t corner[24];
	static struct fixture f;

	(void)state;
	set_up(&f);
	add_levels(&f);
	for (int i = 0; i < 24; i++) {
		corner[i] = 9;
	}
	corner[0] = 23; /* of 21, 22, 23 */
	corner[23] = 3; /* of 3, 4, 5 */
	f.lod[1].corner = corner;
	lay_out(&f, FIXED_TIERS);
	for (uint32_t v = 0; v < VERTICES; v++) {
		bool of_corner = (v >= 3 && v <= 5) || (v >= 21 && v <= 23);

		assert_int_equal(is_posed(&f, 2, v),
			of_corner || (v >= 9 && v <= 12) || v == 17 || v == 30);
		assert_int_equal(is_posed(&f, 3, v), v == 9 || v == 17);
	}
	arena_release(&f.arena);
}

/* Eight levels, each a quarter of the one before: the last two share one. */
static void test_there_are_eight_tiers_at_most(void **state)
{
	static const int posed[] = {9, 8, 7, 6, 5, 4, 3, 2, 2};
	static const int groups[] = {8, 7, 6, 5, 4, 3, 2, 1, 1};
	static struct fixture f;
	int end = 3;

	(void)state;
	set_up(&f);
	for (int i = 0, v = 0; i < TALL; i++) {
		if (i == end) {
			end *= 4;
			v++;
		}
		f.index[i] = (uint32_t)v;
	}
	f.primitive.vertex_count = 9;
	f.primitive.index_count = TALL;
	for (int level = 1; level <= LEVELS_MAX; level++) {
		add_level(&f, f.index, TALL >> 2 * level);
	}
	lay_out(&f, FIXED_TIERS);
	assert_int_equal(f.skin.tier_count, FIXED_SKIN_TIERS_MAX);
	assert_counts(&f, posed, groups);
	arena_release(&f.arena);
}

struct influences {
	float weight[WIDTH];
	uint16_t joint[WIDTH];
};

/* By number, by joints, by joints from the heaviest on, by vertex. */
static void test_vertices_are_sorted_by_influences(void **state)
{
	static const struct influences sorted[] = {
		{{1}, {2}},
		{{1}, {2}},
		{{1}, {6}},
		{{1}, {6}},
		{{0.6f, 0.4f}, {3, 0}},
		{{0.6f, 0.4f}, {1, 2}},
		{{0.7f, 0.3f}, {1, 4}},
		{{0.8f, 0.2f}, {1, 4}},
		{{0.6f, 0.4f}, {4, 1}},
		{{0.5f, 0.3f, 0.2f}, {0, 1, 2}},
		{{0.5f, 0.3f, 0.2f}, {0, 2, 1}},
		{{0.5f, 0.3f, 0.2f}, {2, 0, 1}},
	};
	/* Vertex order[i] has the influences sorted[i]. */
	static const uint32_t order[] = {3, 8, 1, 11, 7, 9, 0, 4, 2, 10, 6, 5};
	static struct fixture f;

	(void)state;
	set_up(&f);
	f.primitive.vertex_count = ARRAY_COUNT(order);
	for (size_t i = 0; i < ARRAY_COUNT(order); i++) {
		memcpy(f.weight[order[i]], sorted[i].weight,
			sizeof(sorted[i].weight));
		memcpy(f.joint[order[i]], sorted[i].joint,
			sizeof(sorted[i].joint));
	}
	lay_out(&f, 0);
	assert_memory_equal(f.skin.order, order, sizeof(order));
	assert_int_equal(f.skin.group_count, 3);
	assert_int_equal(f.skin.group[0].run_count, 2);
	assert_int_equal(f.skin.group[1].run_count, 3);
	assert_int_equal(f.skin.group[2].run_count, 1);
	/* Orders, 23 influences and one more, runs, slots and 6 joints. */
	assert_int_equal(f.arena.used_bytes,
		2 * 12 * 4 + 24 * 8 + 28 * 4 + 16 +
			6 * sizeof(struct fixed_joint));
	/* Joints 2, 6, 3, 1, 4, 0, 2. */
	fixed_skin_set_cap(&f.skin, 1);
	assert_int_equal(f.skin.group_count, 1);
	assert_int_equal(f.skin.group[0].run_count, 7);
	arena_release(&f.arena);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_each_quarter_of_the_triangles_begins_a_tier),
		cmocka_unit_test(test_without_tiers_each_level_needs_all),
		cmocka_unit_test(test_a_quarter_is_one_of_the_tier_before),
		cmocka_unit_test(
			test_a_level_without_triangles_needs_no_vertices),
		cmocka_unit_test(test_a_level_may_add_no_vertices),
		cmocka_unit_test(test_the_full_list_may_add_no_vertices),
		cmocka_unit_test(test_shadows_need_their_vertices_at_their_level),
		cmocka_unit_test(test_corners_bring_their_triangles),
		cmocka_unit_test(test_there_are_eight_tiers_at_most),
		cmocka_unit_test(test_vertices_are_sorted_by_influences),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
