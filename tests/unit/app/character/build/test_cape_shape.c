/* The shape in which a cape begins, and what its cloth is like. */
#include "app/character/run/effects.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

enum {
	COLUMNS = 13,
	ROWS = 10
};

/* Two nodes above each other; a skeleton of 1.65 m has metres for units. */
static const struct character_cape *begin(
	struct acting *acting, double height, const char *text)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "two.gltf");
	char json[256];

	snprintf(json, sizeof(json),
		"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
		"\"scenes\":[{\"nodes\":[0,1]}],\"nodes\":[{\"name\":\"A\"},"
		"{\"name\":\"B\",\"translation\":[0,%g,0]}]}",
		height);
	file_write(path.text, json, strlen(json));
	acting_begin(acting, path.text);
	temp_dir_remove(&folder);
	acting_expect(acting, text);
	return &acting->character->cape[0];
}

/*
 * Three pleats on each side. Counted from the wearer's left; the ends of the
 * edge lie 0.04 lower and 0.06 farther ahead, the latter by half as much at the
 * hem, which hangs back by 6% of the length.
 */
static void test_a_cape_begins_with_flare_pleats_and_shoulders(void **state)
{
	static const struct {
		int column, row;
		float at[3];
	} points[] = {
		{0, 0, {0.2f, 1.41f, -0.072f}},
		{3, 0, {0.1f, 1.44f, -0.105f}},
		{6, 0, {0, 1.45f, -0.108f}},
		{12, 0, {-0.2f, 1.41f, -0.072f}},
		{0, 3, {0.2666667f, 1.11f, -0.1293333f}},
		{6, 3, {0, 1.15f, -0.0966667f}},
		{0, 9, {0.4f, 0.51f, -0.244f}},
		{3, 9, {0.2f, 0.54f, -0.1665f}},
		{6, 9, {0, 0.55f, -0.074f}},
		{12, 9, {-0.4f, 0.51f, -0.244f}},
	};
	const struct character_cape *cape;
	struct acting acting;

	(void)state;
	cape = begin(&acting, 1.65,
		"[cape c]\nbone = A\nplace = 0 1.45 -0.12\nwidth = 0.4\n"
		"length = 0.9\nflare = 2\npleat = 0.1\n"
		"shoulders = 0.04 0.06\nradius = 0.07\n");
	assert_int_equal(cape->cloth.count, COLUMNS * ROWS);
	assert_int_equal(cape->cloth.settings.columns, COLUMNS);
	assert_int_equal(cape->cloth.settings.rows, ROWS);
	assert_near(cape->cloth.settings.radius, 0.07, 1e-6);
	for (size_t i = 0; i < ARRAY_COUNT(points); i++) {
		int at = points[i].row * COLUMNS + points[i].column;

		/* The bone is where the model's origin is. */
		assert_all_near(cape->cloth.offset[at], points[i].at, 3, 1e-5);
	}
	for (int i = 0; i < COLUMNS; i++) {
		assert_int_equal(cape->cloth.pin[i], 0);
	}
	acting_end(&acting);
}

static void test_two_triangles_fill_each_cell_of_a_cape(void **state)
{
	bool used[COLUMNS * ROWS] = {false};
	const struct character_cape *cape;
	struct acting acting;

	(void)state;
	cape = begin(&acting, 1.65, "[cape c]\nbone = A\n");
	assert_int_equal(cape->index_count, 2 * 3 * (COLUMNS - 1) * (ROWS - 1));
	for (int i = 0; i < cape->index_count; i++) {
		assert_true(cape->index[i] < COLUMNS * ROWS);
		used[cape->index[i]] = true;
	}
	for (int i = 0; i < COLUMNS * ROWS; i++) {
		assert_true(used[i]);
	}
	acting_end(&acting);
}

/* A skeleton in another unit has a cape, gravity and speeds in that unit. */
static void test_a_cape_has_the_models_unit(void **state)
{
	static const double units[] = {1, 100};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(units); i++) {
		double unit = units[i];
		const struct character_cape *cape;
		struct cloth_settings usual = cloth_settings_default();
		struct acting acting;

		cape = begin(&acting, 1.65 * unit, "[cape c]\nbone = A\n");
		assert_near(cape->width, 0.33 * unit, 1e-4);
		assert_near(cape->length, 0.8 * unit, 1e-4);
		assert_near(cape->flare, 1.35, 1e-6);
		assert_near(cape->pleat, 0.034 * unit, 1e-4);
		assert_near(cape->radius, 0.02 * unit, 1e-4);
		assert_near(cape->cloth.settings.radius, 0.02 * unit, 1e-4);
		assert_near(cape->cloth.settings.bend, 0.45, 1e-6);
		assert_near(cape->cloth.settings.gravity[1],
			(double)usual.gravity[1] * unit, 1e-2);
		assert_near(cape->cloth.settings.fastest,
			(double)usual.fastest * unit, 1e-2);
		acting_end(&acting);
	}
}

static void read_capes(struct acting *acting, int capes, int bodies)
{
	char text[2048] = "";

	for (int i = 0; i < capes; i++) {
		size_t used = strlen(text);

		snprintf(text + used, sizeof(text) - used,
			"[cape c%d]\nbone = A\n", i);
	}
	for (int i = 0; i < bodies; i++) {
		strcat(text, "body = A B 0.1\n");
	}
	acting_read(acting, text);
}

static void test_a_character_has_so_many_capes_with_so_many_bodies(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, 1.65, "[cape c]\nbone = A\n");
	read_capes(&acting, CHARACTER_CAPES_MAX, CHARACTER_CAPE_BODIES);
	assert_int_equal(acting.error, 0);
	assert_int_equal(acting.character->cape_count, CHARACTER_CAPES_MAX);
	read_capes(&acting, CHARACTER_CAPES_MAX + 1, 0);
	assert_contains(acting.logged.sentence[0], "a character has at most");
	read_capes(&acting, 1, CHARACTER_CAPE_BODIES + 1);
	assert_contains(acting.logged.sentence[0], "there are at most");
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_cape_begins_with_flare_pleats_and_shoulders),
		cmocka_unit_test(test_two_triangles_fill_each_cell_of_a_cape),
		cmocka_unit_test(test_a_cape_has_the_models_unit),
		cmocka_unit_test(
			test_a_character_has_so_many_capes_with_so_many_bodies),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
