/* What the buttons of the demo tuner do; test_preset_file.c tests what it saves. */
#include "app/character/presets/preset_file.h"
#include "app/demo/actor.h"
#include "tests/support/files.h"
#include "tests/support/model/demo_run.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

static const char presets[] =
	"[first]\nspeed = 7\n\n[second]\nspeed = 9\nattenuation = -0.5\n";

struct tuner {
	struct demo_run run;
	struct test_path folder, path;
};

static int begin(void **state)
{
	struct tuner *tuner = calloc(1, sizeof(*tuner));

	assert_non_null(tuner);
	tuner->folder = temp_dir_make();
	tuner->path = path_join(&tuner->folder, "presets.ini");
	file_write(tuner->path.text, presets, strlen(presets));
	assert_int_equal(setenv("LIMBER_ASSETS", tuner->folder.text, 1), 0);
	demo_run_begin_saving(&tuner->run, "tuner");
	*state = tuner;
	return 0;
}

static int end(void **state)
{
	struct tuner *tuner = *state;

	demo_run_end(&tuner->run);
	temp_dir_remove(&tuner->folder);
	unsetenv("LIMBER_ASSETS");
	free(tuner);
	return 0;
}

static void press(struct tuner *tuner, enum button button)
{
	const struct demo_press now = {tuner->run.now_s, button};

	demo_run_to(&tuner->run, tuner->run.now_s + 0.5, 20, &now, 1);
}

static void hold(struct tuner *tuner, enum button button, double time_s)
{
	struct button_event event = {.button = button, .down = true};

	demo_press(tuner->run.driver, tuner->run.demo, &event);
	demo_run_to(&tuner->run, tuner->run.now_s + time_s, 50, NULL, 0);
	event.down = false;
	demo_press(tuner->run.driver, tuner->run.demo, &event);
}

static struct overlay_motion motion_of(const struct tuner *tuner)
{
	struct overlay_motion motion = overlay_motion_none();

	tuner->run.driver->get_motion(tuner->run.demo, &motion);
	return motion;
}

/* Saves the chosen preset, and reads the presets of the file. */
static void read_saved(struct tuner *tuner, struct preset_file *file)
{
	press(tuner, BUTTON_ENTER);
	assert_int_equal(preset_file_find(file, &tuner->run.log), 0);
	assert_int_equal(file->count, 2);
}

static void test_f10_holds_the_bones_still(void **state)
{
	struct tuner *tuner = *state;

	demo_run_to(&tuner->run, 0.5, 20, NULL, 0);
	assert_near(motion_of(tuner).layer[0].weight, 1.0, 0.0);
	press(tuner, BUTTON_F10);
	assert_near(motion_of(tuner).layer[0].weight, 0.0, 0.0);
	press(tuner, BUTTON_F10);
	assert_near(motion_of(tuner).layer[0].weight, 1.0, 0.0);
}

static void test_the_first_row_chooses_the_bone(void **state)
{
	struct tuner *tuner = *state;
	struct overlay_motion before = motion_of(tuner), after;

	for (int i = 0; i < 3; i++) {
		press(tuner, BUTTON_UP);
	}
	press(tuner, BUTTON_RIGHT);
	after = motion_of(tuner);
	assert_int_equal(after.layer_count, 1);
	assert_string_not_equal(after.layer[0].name, before.layer[0].name);
	press(tuner, BUTTON_LEFT);
	after = motion_of(tuner);
	assert_int_equal(after.layer_count, before.layer_count);
	assert_string_equal(after.layer[0].name, before.layer[0].name);
}

static void test_f8_paints_the_bones_or_not(void **state)
{
	struct tuner *tuner = *state;
	const struct demo_base *base = (const void *)tuner->run.demo;
	const struct drawable *drawable = &base->actor.instance->drawable[0];
	const void *painted = drawable->batch[0].color;

	press(tuner, BUTTON_F8);
	assert_ptr_not_equal(drawable->batch[0].color, painted);
	press(tuner, BUTTON_F8);
	assert_ptr_equal(drawable->batch[0].color, painted);
}

static void test_f6_chooses_the_next_preset(void **state)
{
	struct tuner *tuner = *state;
	struct preset_file file;

	press(tuner, BUTTON_F6);
	press(tuner, BUTTON_RIGHT);
	read_saved(tuner, &file);
	assert_near(file.preset[0].attenuation,
		procedural_preset_default().attenuation, 0.0);
	assert_near(file.preset[1].attenuation, -0.45, 1e-6);
	press(tuner, BUTTON_F6);
	hold(tuner, BUTTON_LEFT, 0.1);
	read_saved(tuner, &file);
	assert_true(file.preset[0].attenuation <
		procedural_preset_default().attenuation);
	assert_near(file.preset[1].attenuation, -0.45, 1e-6);
}

static void test_f9_takes_back_what_was_not_saved(void **state)
{
	struct tuner *tuner = *state;
	struct preset_file file;

	press(tuner, BUTTON_F6);
	press(tuner, BUTTON_RIGHT);
	press(tuner, BUTTON_RIGHT);
	press(tuner, BUTTON_F9);
	read_saved(tuner, &file);
	assert_near(file.preset[1].attenuation, -0.5, 1e-6);
}

/* Once at once, and every 60 ms after 400 ms. */
static void test_a_held_button_goes_on_changing(void **state)
{
	struct tuner *tuner = *state;
	struct preset_file file;

	press(tuner, BUTTON_F6);
	hold(tuner, BUTTON_RIGHT, 0.35);
	demo_run_to(&tuner->run, tuner->run.now_s + 1.0, 20, NULL, 0);
	read_saved(tuner, &file);
	assert_near(file.preset[1].attenuation, -0.45, 1e-6);
	hold(tuner, BUTTON_RIGHT, 0.99);
	read_saved(tuner, &file);
	assert_near(file.preset[1].attenuation, -0.45 + 11 * 0.05, 0.051);
	hold(tuner, BUTTON_RIGHT, 10.0);
	read_saved(tuner, &file);
	assert_near(file.preset[1].attenuation, 2.0, 1e-6);
}

static void test_a_suspended_machine_does_not_go_on_changing(void **state)
{
	struct tuner *tuner = *state;
	struct button_event event = {.button = BUTTON_RIGHT, .down = true};
	struct preset_file file;

	press(tuner, BUTTON_F6);
	demo_press(tuner->run.driver, tuner->run.demo, &event);
	demo_run_to(
		&tuner->run, tuner->run.now_s + 3600.0, 1.0 / 3600.0, NULL, 0);
	event.down = false;
	demo_press(tuner->run.driver, tuner->run.demo, &event);
	read_saved(tuner, &file);
	assert_near(file.preset[1].attenuation, -0.5 + 2 * 0.05, 1e-6);
}

/* Below the row of the bone there is one for each number, then the bone again. */
static void test_each_row_changes_its_number_by_a_step(void **state)
{
	struct tuner *tuner = *state;
	struct preset_file before, after;

	press(tuner, BUTTON_UP);
	press(tuner, BUTTON_UP);
	read_saved(tuner, &before);
	for (int i = 0; i < PRESET_FIELDS; i++) {
		press(tuner, BUTTON_RIGHT);
		press(tuner, BUTTON_DOWN);
	}
	read_saved(tuner, &after);
	for (int i = 0; i < PRESET_FIELDS; i++) {
		const struct preset_field *field = &preset_fields[i];

		assert_near(*preset_value(&after.preset[0], field),
			*preset_value(&before.preset[0], field) + field->step,
			1e-5);
	}
	press(tuner, BUTTON_DOWN);
	press(tuner, BUTTON_LEFT);
	read_saved(tuner, &after);
	assert_near(*preset_value(&after.preset[0], &preset_fields[0]),
		*preset_value(&before.preset[0], &preset_fields[0]), 1e-5);
	for (int i = 0; i < 2; i++) {
		press(tuner, BUTTON_UP);
	}
	press(tuner, BUTTON_LEFT);
	read_saved(tuner, &after);
	assert_near(*preset_value(&after.preset[0],
			    &preset_fields[PRESET_FIELDS - 1]),
		*preset_value(
			&before.preset[0], &preset_fields[PRESET_FIELDS - 1]),
		1e-5);
}

#define TUNER_TEST(test) cmocka_unit_test_setup_teardown(test, begin, end)

int main(void)
{
	const struct CMUnitTest tests[] = {
		TUNER_TEST(test_f10_holds_the_bones_still),
		TUNER_TEST(test_the_first_row_chooses_the_bone),
		TUNER_TEST(test_f8_paints_the_bones_or_not),
		TUNER_TEST(test_f6_chooses_the_next_preset),
		TUNER_TEST(test_f9_takes_back_what_was_not_saved),
		TUNER_TEST(test_each_row_changes_its_number_by_a_step),
		TUNER_TEST(test_a_held_button_goes_on_changing),
		TUNER_TEST(test_a_suspended_machine_does_not_go_on_changing),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
