/* The presets of a shake's file, and the units in which they shift a bone. */
#include "app/character/character_data.h"
#include "app/character/run/effects.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

static const char model[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[0]}],\"nodes\":["
	"{\"name\":\"A\",\"children\":[1],\"scale\":[%g,%g,%g]},"
	"{\"name\":\"B\",\"translation\":[0,1,0]}]}";

static const char presets[] = "[soft]\nspeed = 3\nunit = 0.5\n"
			      "[hard]\nspeed = 5\nunit = 0.25\n"
			      "[wild]\nspeed = 9\nunit = 2\n";

struct bench {
	struct test_path folder;
	struct acting acting;
};

static const struct character_shake *begin(
	struct bench *bench, double scale, const char *line)
{
	struct test_path path;
	char text[sizeof(model) + 64];
	const struct character *character;

	bench->folder = temp_dir_make();
	path = path_join(&bench->folder, "model.gltf");
	snprintf(text, sizeof(text), model, scale, scale, scale);
	file_write(path.text, text, strlen(text));
	acting_begin(&bench->acting, path.text);
	path = path_join(&bench->folder, "p.ini");
	file_write(path.text, presets, strlen(presets));
	path = path_join(&bench->folder, "model.character");
	snprintf(text, sizeof(text), "[shake s]\nbone = B\n%s\n", line);
	file_write(path.text, text, strlen(text));
	acting_load(&bench->acting, path.text);
	character = bench->acting.character;
	assert_non_null(character);
	for (int i = 0; i < character->op_count; i++) {
		if (character->op[i].run == character_shake_run) {
			return character->op[i].what;
		}
	}
	fail_msg("no shake");
	return NULL;
}

static void end(struct bench *bench)
{
	acting_end(&bench->acting);
	temp_dir_remove(&bench->folder);
}

/* Units of the bone: those of the model are as many times larger as its scale. */
static void test_a_file_gives_all_presets_of_a_shake(void **state)
{
	static const int scales[] = {1, 3, 500};
	static const struct {
		const char *name;
		double speed, unit_m;
	} rows[] = {{"soft", 3, 0.5}, {"hard", 5, 0.25}, {"wild", 9, 2}};

	(void)state;
	for (size_t k = 0; k < ARRAY_COUNT(scales); k++) {
		struct bench bench;
		const struct character_shake *shake =
			begin(&bench, scales[k], "presets = p.ini");
		double metre = (double)bench.acting.character->metre / scales[k];

		assert_true((bench.acting.character->metre > 1) ==
			(scales[k] == 500));
		assert_int_equal(shake->preset_count, 3);
		assert_string_equal(shake->swing.preset.name, "soft");
		assert_near(shake->swing.preset.speed, 3, 0);
		assert_near(shake->swing.preset.unit, 0.5 * metre, 1e-6);
		for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
			const struct procedural_preset *preset =
				&shake->preset[i];

			assert_string_equal(preset->name, rows[i].name);
			assert_near(preset->speed, rows[i].speed, 0);
			assert_near(preset->unit, rows[i].unit_m * metre, 1e-6);
		}
		end(&bench);
	}
}

/* A scale of 0 leaves them as they are. */
static void test_a_shake_without_a_file_has_units_of_its_bone(void **state)
{
	static const double cases[][2] = {{3, 0.02}, {0.5, 0.12}, {0, 0.06}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct bench bench;
		const struct character_shake *shake =
			begin(&bench, cases[i][0], "unit = 0.06");

		assert_int_equal(shake->preset_count, 0);
		assert_near(shake->swing.preset.unit, cases[i][1], 1e-7);
		end(&bench);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_file_gives_all_presets_of_a_shake),
		cmocka_unit_test(
			test_a_shake_without_a_file_has_units_of_its_bone),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
