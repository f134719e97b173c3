#include "app/anim/procedural/cloth.h"
#include "platform/base/memory_budget.h"
#include "tests/support/test.h"

#include <errno.h>
#include <string.h>

static const mat4 AT_ORIGIN[1] = {
	{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}},
};

/* Three columns and rows at unlike distances. */
static const float UNLIKE[9][3] = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {0, -4, 0},
	{1, -5, 0}, {3, -6, 0}, {0, -9, 0}, {1, -11, 0}, {3, -14, 0}};

static struct cloth_settings grid(int columns, int rows)
{
	struct cloth_settings settings = cloth_settings_default();

	settings.columns = columns;
	settings.rows = rows;
	return settings;
}

static int make(struct cloth *cloth, const struct cloth_settings *settings,
	struct arena *arena)
{
	static const int pin[CLOTH_SIDE_MAX + 1];
	static const float shape[65 * 65][3];

	return cloth_init(cloth, settings,
		settings->columns == 3 ? UNLIKE : shape, pin, AT_ORIGIN, arena);
}

static void test_a_cape_has_these_settings_unless_told(void **state)
{
	static const float gravity[3] = {0, -9.81f, 0};
	static const float wind[3] = {0, 0, 0};
	const struct cloth_settings settings = cloth_settings_default();

	(void)state;
	assert_int_equal(settings.columns, 8);
	assert_int_equal(settings.rows, 10);
	assert_all_near(settings.gravity, gravity, 3, 0);
	assert_all_near(settings.wind, wind, 3, 0);
	assert_near(settings.air, 4, 0);
	assert_near(settings.damping, 0.6, 1e-6);
	assert_near(settings.bend, 0.2, 1e-6);
	assert_near(settings.radius, 0.01, 1e-7);
	assert_near(settings.fastest, 30, 0);
	assert_int_equal(settings.passes, 4);
}

struct want {
	int a, b;
	double length, stiffness;
};

static const struct want LINKS[] = {{0, 1, 1, 1}, {1, 2, 2, 1},
	{3, 4, 1.41421, 1}, {4, 5, 2.23607, 1}, {6, 7, 2.23607, 1},
	{7, 8, 3.60555, 1}, {0, 3, 4, 1}, {1, 4, 5, 1}, {2, 5, 6, 1},
	{3, 6, 5, 1}, {4, 7, 6, 1}, {5, 8, 8, 1}, {0, 4, 5.09902, 0.5},
	{1, 5, 6.32456, 0.5}, {3, 7, 7.07107, 0.5}, {4, 8, 9.21954, 0.5},
	{1, 3, 4.12311, 0.5}, {2, 4, 5.38516, 0.5}, {4, 6, 4.12311, 0.5},
	{5, 7, 5.38516, 0.5}, {0, 2, 3, 0.3}, {3, 5, 3.60555, 0.3},
	{6, 8, 5.83095, 0.3}, {0, 6, 9, 0.3}, {1, 7, 11, 0.3}, {2, 8, 14, 0.3}};

static void assert_linked(const struct cloth *cloth, const struct want *want)
{
	int times = 0;

	for (int l = 0; l < cloth->link_count; l++) {
		const struct cloth_link *link = &cloth->link[l];

		if (link->a == want->a && link->b == want->b) {
			times++;
			assert_near(link->length, want->length, 1e-4);
			assert_near(link->stiffness, want->stiffness, 1e-6);
		}
	}
	assert_int_equal(times, 1);
}

static void test_neighbours_are_linked_by_their_stiffness(void **state)
{
	const int count = (int)(sizeof(LINKS) / sizeof(LINKS[0]));
	struct cloth_settings settings = grid(3, 3);
	struct arena arena = arena_empty();
	struct cloth cloth;

	(void)state;
	settings.bend = 0.3f;
	assert_int_equal(make(&cloth, &settings, &arena), 0);
	assert_int_equal(cloth.link_count, count);
	for (int i = 0; i < count; i++) {
		assert_linked(&cloth, &LINKS[i]);
	}
	arena_release(&arena);
}

static void test_cloth_that_folds_freely_has_fewer_links(void **state)
{
	static const float bends[3] = {0, -1, 1e-3f};
	static const int links[3] = {20, 20, 26};

	(void)state;
	for (int i = 0; i < 3; i++) {
		struct cloth_settings settings = grid(3, 3);
		struct arena arena = arena_empty();
		struct cloth cloth;

		settings.bend = bends[i];
		assert_int_equal(make(&cloth, &settings, &arena), 0);
		assert_int_equal(cloth.link_count, links[i]);
		arena_release(&arena);
	}
}

static void test_each_column_is_measured_from_its_pin(void **state)
{
	static const float hang[9] = {0, 0, 0, 4, 5, 6, 9, 11, 14};
	struct cloth_settings settings = grid(3, 3);
	struct arena arena = arena_empty();
	struct cloth cloth;

	(void)state;
	assert_int_equal(make(&cloth, &settings, &arena), 0);
	assert_int_equal(cloth.count, 9);
	assert_all_near(cloth.hang, hang, 9, 1e-6);
	assert_all_near(cloth.position, UNLIKE, 27, 0);
	arena_release(&arena);
}

static void test_sides_are_allowed_up_to_their_limits(void **state)
{
	static const struct {
		int columns, rows, error;
	} cases[] = {{2, 2, 0}, {2, 64, 0}, {64, 2, 0}, {64, 64, 0},
		{1, 2, -EINVAL}, {2, 1, -EINVAL}, {65, 2, -EINVAL},
		{2, 65, -EINVAL}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		const struct cloth_settings settings =
			grid(cases[i].columns, cases[i].rows);
		struct arena arena = arena_empty();
		struct cloth cloth;

		assert_int_equal(
			make(&cloth, &settings, &arena), cases[i].error);
		arena_release(&arena);
	}
}

static bool is_filled(const void *memory, size_t bytes, int with)
{
	const unsigned char *byte = memory;

	for (size_t i = 0; i < bytes; i++) {
		if (byte[i] != with) {
			return false;
		}
	}
	return true;
}

static void assert_apart(const struct cloth *cloth)
{
	const struct {
		void *memory;
		size_t bytes;
	} array[] = {{cloth->position, 448 * 12}, {cloth->normal, 448 * 12},
		{cloth->velocity, 448 * 12}, {cloth->before, 448 * 12},
		{cloth->offset, 448 * 12}, {cloth->hang, 448 * 4},
		{cloth->pin, 7 * 4}, {cloth->pin_from, 7 * 12},
		{cloth->pin_to, 7 * 12},
		{cloth->link, (size_t)cloth->link_count * sizeof(*cloth->link)}};

	for (int i = 0; i < 10; i++) {
		memset(array[i].memory, i + 1, array[i].bytes);
	}
	for (int i = 0; i < 10; i++) {
		assert_true(is_filled(array[i].memory, array[i].bytes, i + 1));
	}
}

static void test_arrays_have_room_for_all_particles(void **state)
{
	const struct cloth_settings settings = grid(7, 64);
	struct arena arena = arena_empty();
	struct cloth cloth;

	(void)state;
	assert_int_equal(make(&cloth, &settings, &arena), 0);
	assert_apart(&cloth);
	arena_release(&arena);
}

/* Whatever the memory is short for. */
static void test_short_memory_is_told(void **state)
{
	const struct cloth_settings settings = grid(64, 64);
	int refused = 0;
	int error = -ENOMEM;

	(void)state;
	for (size_t limit = 0; error; limit += 8192) {
		struct memory_budget budget = {.limit_bytes = limit};
		struct arena arena = arena_within(&budget);
		struct cloth cloth;

		assert_true(limit < 4 << 20);
		error = make(&cloth, &settings, &arena);
		assert_int_equal(error, budget.exceeded ? -ENOMEM : 0);
		refused += error != 0;
		arena_release(&arena);
	}
	assert_true(refused > 30);
}

/* Turned by 90 degrees about z and three times as large, or flattened. */
static void test_shapes_are_kept_in_the_nodes_axes(void **state)
{
	static const mat4 world[2] = {
		{{0, 3, 0, 0}, {-3, 0, 0, 0}, {0, 0, 3, 0}, {10, 20, 30, 1}},
		{{0, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {1, 2, 3, 1}},
	};
	static const float shape[4][3] = {
		{13, 26, 39}, {1, 2, 3}, {10, 20, 27}, {7, 8, 9}};
	static const float want[4][3] = {
		{2, -1, 3}, {0, 0, 0}, {0, 0, -1}, {0, 0, 0}};
	static const int pin[2] = {0, 1};
	const struct cloth_settings settings = grid(2, 2);
	struct arena arena = arena_empty();
	struct cloth cloth;

	(void)state;
	assert_int_equal(
		cloth_init(&cloth, &settings, shape, pin, world, &arena), 0);
	assert_all_near(cloth.offset, want, 12, 1e-5);
	assert_int_equal(cloth.pin[0], 0);
	assert_int_equal(cloth.pin[1], 1);
	arena_release(&arena);
}

static void test_each_square_has_two_triangles(void **state)
{
	static const uint16_t want[24] = {0, 3, 1, 1, 3, 4, 1, 4, 2, 2, 4, 5, 3,
		6, 4, 4, 6, 7, 4, 7, 5, 5, 7, 8};
	const struct cloth_settings settings = grid(3, 3);
	uint16_t index[25];

	(void)state;
	index[24] = 99;
	assert_int_equal(cloth_triangles(&settings, index), 24);
	assert_memory_equal(index, want, sizeof(want));
	assert_int_equal(index[24], 99);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_cape_has_these_settings_unless_told),
		cmocka_unit_test(test_neighbours_are_linked_by_their_stiffness),
		cmocka_unit_test(test_cloth_that_folds_freely_has_fewer_links),
		cmocka_unit_test(test_each_column_is_measured_from_its_pin),
		cmocka_unit_test(test_sides_are_allowed_up_to_their_limits),
		cmocka_unit_test(test_arrays_have_room_for_all_particles),
		cmocka_unit_test(test_short_memory_is_told),
		cmocka_unit_test(test_shapes_are_kept_in_the_nodes_axes),
		cmocka_unit_test(test_each_square_has_two_triangles),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
