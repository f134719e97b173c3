/* The panel of the demo tuner: its rows, its messages and how long they last. */
#include "app/character/presets/preset_file.h"
#include "app/demo/actor.h"
#include "app/scene/hud/hud_group.h"
#include "tests/support/files.h"
#include "tests/support/model/demo_run.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
	ROWS = 1 + PRESET_FIELDS, /* that of the bone is first */
	ATTENUATION = 2
};

static const char presets[] =
	"[first]\nspeed = 7\namplitude = 0.3\nattenuation = 0.1\n"
	"translation = 1 2 3\nrotation = 0.1 0.2 0.3\nmodifier = 0.5\n"
	"[second]\nattenuation = -0.5\n";

struct tuner {
	struct demo_run run;
	struct test_path folder, path;
	float value[PRESET_FIELDS]; /* that the panel shows */
	char bone[32];
};

static struct tuner *begin(bool may_save)
{
	static const float first[] = {
		7, 0.3f, 0.1f, 0.5f, 1, 2, 3, 0.1f, 0.2f, 0.3f};
	struct tuner *tuner = calloc(1, sizeof(*tuner));

	assert_non_null(tuner);
	tuner->folder = temp_dir_make();
	tuner->path = path_join(&tuner->folder, "presets.ini");
	file_write(tuner->path.text, presets, strlen(presets));
	assert_int_equal(setenv("LIMBER_ASSETS", tuner->folder.text, 1), 0);
	if (may_save) {
		demo_run_begin_saving(&tuner->run, "tuner");
	} else {
		demo_run_begin(&tuner->run, "tuner");
	}
	memcpy(tuner->value, first, sizeof(first));
	snprintf(tuner->bone, sizeof(tuner->bone), "shoulder.L +1");
	return tuner;
}

static void end(struct tuner *tuner)
{
	demo_run_end(&tuner->run);
	temp_dir_remove(&tuner->folder);
	unsetenv("LIMBER_ASSETS");
	free(tuner);
}

static void put(struct tuner *tuner, enum button button, bool down)
{
	const struct button_event event = {.button = button, .down = down};

	demo_press(tuner->run.driver, tuner->run.demo, &event);
}

static void press(struct tuner *tuner, enum button button)
{
	put(tuner, button, true);
	put(tuner, button, false);
}

static void run_for(struct tuner *tuner, double time_s)
{
	tuner->run.now_s += time_s;
	tuner->run.driver->update(tuner->run.demo, tuner->run.now_s);
}

static void want_row(const struct tuner *tuner, struct hud_group *group,
	int row, bool chosen)
{
	const char *name = "bone";
	char value[32];

	snprintf(value, sizeof(value), "%s", tuner->bone);
	if (row > 0) {
		name = preset_fields[row - 1].name;
		snprintf(value, sizeof(value), "%.2f",
			(double)tuner->value[row - 1]);
	}
	if (chosen) {
		hud_group_mark(group, name, value, hud_color_amber);
	} else {
		hud_group_text(group, name, value);
	}
}

/* The rows from first on, in a picture of this size. */
static void expect_rows(struct tuner *tuner, const char *title, int chosen,
	int first, const int size[2])
{
	static struct hud shown, wanted;
	struct hud *const both[] = {&shown, &wanted};
	struct hud_group group;

	for (int i = 0; i < 2; i++) {
		both[i]->font = &font_default;
		hud_begin(both[i], size[0], size[1]);
	}
	tuner->run.driver->label(tuner->run.demo, &shown);
	group = hud_group_begin(&wanted, HUD_TOP_LEFT, title);
	for (int row = first; row < ROWS; row++) {
		want_row(tuner, &group, row, row == chosen);
	}
	hud_group_end(&group);
	assert_int_equal(shown.quad_count, wanted.quad_count);
	assert_memory_equal(shown.vertex, wanted.vertex,
		(size_t)shown.quad_count * 4 * sizeof(shown.vertex[0]));
}

static const int usual[2] = {480, 640};

static void expect(struct tuner *tuner, const char *title)
{
	expect_rows(tuner, title, 1 + ATTENUATION, 0, usual);
}

/* For two seconds, in place of the preset's name. */
static void expect_message(struct tuner *tuner, const char *message)
{
	expect(tuner, message);
	run_for(tuner, 1.9);
	expect(tuner, message);
	run_for(tuner, 0.2);
	expect(tuner, "first");
}

static void test_the_panel_shows_each_number_of_the_preset(void **state)
{
	struct tuner *tuner = begin(false);

	(void)state;
	expect(tuner, "first");
	for (int i = 0; i < ROWS; i++) {
		press(tuner, BUTTON_DOWN);
		expect_rows(
			tuner, "first", (2 + ATTENUATION + i) % ROWS, 0, usual);
	}
	for (int i = 1; i <= ROWS; i++) {
		press(tuner, BUTTON_UP);
		expect_rows(tuner, "first", (1 + ATTENUATION + ROWS - i) % ROWS,
			0, usual);
	}
	assert_near(tuner->run.driver->period_s(tuner->run.demo), 6.0, 0.0);
	end(tuner);
}

/* Where some rows have no room, the chosen one has one before it. */
static void test_the_chosen_row_is_shown_in_small_pictures(void **state)
{
	struct tuner *tuner = begin(false);
	int seen = 0;

	(void)state;
	press(tuner, BUTTON_UP);
	press(tuner, BUTTON_UP);
	press(tuner, BUTTON_UP);
	for (int row = 0; row < ROWS; row++) {
		for (int k = 0; k < 70; k++) {
			const int size[2] = {
				k % 2 ? 480 : 160, 40 + 12 * (k / 2)};
			int most = hud_group_rows_max(size[0], size[1]);
			int first = most >= ROWS || row == 0 ? 0
				: most > 1                   ? row - 1
							     : row;

			expect_rows(tuner, "first", row, first, size);
			seen |= most >= ROWS ? 1 : most > 1 ? 2 : most << 2;
		}
		press(tuner, BUTTON_DOWN);
	}
	assert_int_equal(seen, 7);
	end(tuner);
}

static void test_a_message_says_what_became_of_saving(void **state)
{
	struct tuner *tuner = begin(true);

	(void)state;
	run_for(tuner, 0.1);
	press(tuner, BUTTON_ENTER);
	expect_message(tuner, "saved");
	press(tuner, BUTTON_F9);
	expect_message(tuner, "as in the file");
	tuner->run.log = log_to_nowhere();
	assert_int_equal(unlink(tuner->path.text), 0);
	assert_int_equal(rmdir(tuner->folder.text), 0);
	press(tuner, BUTTON_ENTER);
	expect_message(tuner, "could not be saved");
	assert_int_equal(mkdir(tuner->folder.text, 0700), 0);
	end(tuner);
}

static void test_a_message_says_that_pictures_save_nothing(void **state)
{
	struct tuner *tuner = begin(false);

	(void)state;
	press(tuner, BUTTON_ENTER);
	expect_message(tuner, "render cannot save");
	end(tuner);
}

/* Once at once, then after 0.4 s, and then every 0.06 s until it is released. */
static void test_a_held_button_changes_the_number_at_its_times(void **state)
{
	static const struct {
		double held_s;
		int steps;
	} times[] = {{0.39, 1}, {0.41, 2}, {0.45, 2}, {0.47, 3}, {0.51, 3},
		{0.53, 4}, {0.99, 11}, {1.01, 12}};
	struct tuner *tuner = begin(false);

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(times); i++) {
		put(tuner, BUTTON_RIGHT, true);
		run_for(tuner, times[i].held_s);
		put(tuner, BUTTON_RIGHT, false);
		run_for(tuner, 3.0);
		tuner->value[ATTENUATION] = 0.1f + 0.05f * (float)times[i].steps;
		expect(tuner, "first");
		press(tuner, BUTTON_F9);
		run_for(tuner, 3.0);
	}
	end(tuner);
}

/* Within 0.3 seconds. */
static void test_bones_fade_in_and_out(void **state)
{
	static const double weight[] = {2.0 / 3.0, 1.0 / 3.0, 0.0, 0.0};
	struct tuner *tuner = begin(false);

	(void)state;
	run_for(tuner, 1.0);
	for (size_t i = 0; i < 2 * ARRAY_COUNT(weight); i++) {
		struct overlay_motion motion = overlay_motion_none();

		if (i % ARRAY_COUNT(weight) == 0) {
			press(tuner, BUTTON_F10);
		}
		run_for(tuner, 0.1);
		tuner->run.driver->get_motion(tuner->run.demo, &motion);
		assert_int_equal(motion.layer_count, 2);
		for (int k = 0; k < 2; k++) {
			double faded = weight[i % ARRAY_COUNT(weight)];

			assert_near(motion.layer[k].weight,
				i < ARRAY_COUNT(weight) ? faded : 1.0 - faded,
				1e-3);
		}
	}
	end(tuner);
}

/* Other bones begin as still as those before. */
static void test_bones_that_are_held_still_stay_so(void **state)
{
	struct overlay_motion motion = overlay_motion_none();
	struct tuner *tuner = begin(false);

	(void)state;
	press(tuner, BUTTON_F10);
	for (int i = 0; i <= ATTENUATION; i++) {
		press(tuner, BUTTON_UP);
	}
	for (int i = 0; i < 2; i++) {
		press(tuner, i ? BUTTON_F10 : BUTTON_RIGHT);
		run_for(tuner, 1.0);
		tuner->run.driver->get_motion(tuner->run.demo, &motion);
		assert_int_equal(motion.layer_count, 1);
		assert_near(motion.layer[0].weight, i, 0.0);
	}
	end(tuner);
}

/* From -0.35 to 0.35 and back, in six seconds. */
static void test_an_unattended_tuner_moves_the_attenuation(void **state)
{
	struct tuner *tuner = begin(false);
	const struct demo_env env = {.log = &tuner->run.log,
		.gl = &tuner->run.gl,
		.target = PIXELS_RGBA8888,
		.kernel = kernel_find("float"),
		.width = 480,
		.height = 640,
		.model_path = "assets/walker.glb",
		.speed = 1.0f,
		.unattended = true};

	(void)state;
	demo_destroy(tuner->run.driver, tuner->run.demo);
	assert_int_equal(
		demo_create(tuner->run.driver, &env, &tuner->run.demo), 0);
	for (int i = 0; i < 10; i++) {
		run_for(tuner, 0.8);
		tuner->value[ATTENUATION] = -0.35f *
			cosf((float)(tuner->run.now_s / 6.0 * 2.0 * acos(-1)));
		expect(tuner, "first");
	}
	end(tuner);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_panel_shows_each_number_of_the_preset),
		cmocka_unit_test(test_the_chosen_row_is_shown_in_small_pictures),
		cmocka_unit_test(test_a_message_says_what_became_of_saving),
		cmocka_unit_test(test_a_message_says_that_pictures_save_nothing),
		cmocka_unit_test(
			test_a_held_button_changes_the_number_at_its_times),
		cmocka_unit_test(test_bones_fade_in_and_out),
		cmocka_unit_test(test_bones_that_are_held_still_stay_so),
		cmocka_unit_test(test_an_unattended_tuner_moves_the_attenuation),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
