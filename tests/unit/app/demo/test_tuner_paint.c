/* A chain of bones in the demo tuner: its colours, and how far it swings. */
#include "app/demo/actor.h"
#include "app/demo/demo.h"
#include "app/scene/overlay/overlay_heat.h"
#include "tests/support/files.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/model/triangle_file.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	LEVELS =
		16, /* of which each has a colour of its own; others share it */
	BONES = 20
};

/* Each bone is a triangle and the parent of the next one, 1 above it. */
static void write_chain(const char *path, int bones, double scale)
{
	char nodes[3072];
	size_t used = 0;

	for (int i = 0; i + 1 < bones; i++) {
		used += (size_t)snprintf(nodes + used, sizeof(nodes) - used,
			"{\"mesh\":0,\"translation\":[0,1,0],"
			"\"scale\":[%g,%g,%g],\"children\":[%d]},",
			i ? 1.0 : scale, i ? 1.0 : scale, i ? 1.0 : scale,
			i + 1);
	}
	snprintf(nodes + used, sizeof(nodes) - used,
		"{\"mesh\":0,\"translation\":[0,1,0]}");
	triangle_file_write(path, nodes);
}

static struct demo *begin(const char *path, const struct log *log, struct gl *gl)
{
	const struct demo_env env = {
		.log = log,
		.gl = gl,
		.target = PIXELS_RGBA8888,
		.kernel = kernel_find("float"),
		.width = 480,
		.height = 640,
		.model_path = path,
		.character = "none",
		.speed = 1.0f,
	};
	struct demo *demo;

	assert_int_equal(demo_create(demo_find("tuner"), &env, &demo), 0);
	return demo;
}

/* The presets add a tenth to 1 at each level. */
static void expect_colors(const struct demo *demo, int bones)
{
	const struct demo_base *base = (const void *)demo;
	const struct instance *instance = base->actor.instance;
	int deepest = bones - 1 < LEVELS ? bones - 1 : LEVELS;

	assert_int_equal(instance->drawable_count, bones);
	for (int d = 0; d < bones; d++) {
		const struct drawable *drawable = &instance->drawable[d];
		int level = drawable->node < LEVELS ? drawable->node : LEVELS;
		uint8_t rgb[3];

		overlay_heat_ramp((1.0f + 0.1f * (float)level) /
				(1.0f + 0.1f * (float)deepest),
			rgb);
		for (int k = 0; k < 9; k++) {
			const uint8_t *shown = drawable->batch[0].color[k / 3];

			assert_near(shown[k % 3], rgb[k % 3], 1.0);
		}
	}
}

static void test_each_level_has_its_colour(void **state)
{
	static const char presets[] = "[grows]\nattenuation = 0.1\n";
	struct test_path folder = temp_dir_make();
	struct test_path model = path_join(&folder, "chain.gltf");
	struct test_path file = path_join(&folder, "presets.ini");
	struct log log = log_to_stderr(LOG_WARNING);

	(void)state;
	file_write(file.text, presets, strlen(presets));
	assert_int_equal(setenv("LIMBER_ASSETS", folder.text, 1), 0);
	for (int bones = 1; bones <= BONES; bones++) {
		struct gl gl = gl_recorder_begin();
		struct demo *demo;

		write_chain(model.text, bones, 1.0);
		demo = begin(model.text, &log, &gl);
		expect_colors(demo, bones);
		demo_destroy(demo_find("tuner"), demo);
	}
	temp_dir_remove(&folder);
	unsetenv("LIMBER_ASSETS");
}

/*
 * Presets suit a person of 1.72 m; figures of 0.5 to 4 m take them as they are.
 * The first bone's scale is the length of the second one's unit.
 */
static void test_a_swing_is_as_long_as_the_figure(void **state)
{
	static const char presets[] =
		"[stays]\nspeed = 0\namplitude = 1\nattenuation = 0\n"
		"translation = 0 0.5 0\nrotation = 0 0 0\n";
	static const struct {
		int bones;
		double scale, factor;
	} chains[] = {{2, 0.25, 0.5 / 1.72}, {2, 0.26, 1}, {3, 1, 1},
		{4, 0.99, 1}, {4, 1, 4 / 1.72}, {10, 1, 10 / 1.72},
		{3, 1000, 3000 / 1.72}};
	struct test_path folder = temp_dir_make();
	struct test_path model = path_join(&folder, "chain.gltf");
	struct test_path file = path_join(&folder, "presets.ini");
	struct log log = log_to_stderr(LOG_WARNING);
	const struct demo_driver *tuner = demo_find("tuner");

	(void)state;
	file_write(file.text, presets, strlen(presets));
	assert_int_equal(setenv("LIMBER_ASSETS", folder.text, 1), 0);
	for (size_t i = 0; i < ARRAY_COUNT(chains); i++) {
		struct gl gl = gl_recorder_begin();
		const struct pose *pose;
		struct demo *demo;

		write_chain(model.text, chains[i].bones, chains[i].scale);
		demo = begin(model.text, &log, &gl);
		pose = &((const struct demo_base *)demo)->actor.instance->pose;
		/* Frames do not add up. */
		for (double time_s = 1.0; time_s < 4.0; time_s += 1.0) {
			tuner->update(demo, time_s);
			assert_near(pose->local[1].translation[1],
				1.0 + 0.5 * chains[i].factor / chains[i].scale,
				1e-5);
		}
		demo_destroy(tuner, demo);
	}
	temp_dir_remove(&folder);
	unsetenv("LIMBER_ASSETS");
}

static void press(struct demo *demo, enum button button)
{
	struct button_event event = {.button = button, .down = true};

	demo_press(demo_find("tuner"), demo, &event);
	event.down = false;
	demo_press(demo_find("tuner"), demo, &event);
}

/* How far the second bone is shifted, and the colour of the last one. */
static void expect_shift(struct demo *demo, double shift, double fraction)
{
	const struct instance *instance =
		((const struct demo_base *)demo)->actor.instance;
	const uint8_t *shown = instance->drawable[2].batch[0].color[0];
	static double now_s;
	uint8_t rgb[3];

	demo_find("tuner")->update(demo, now_s += 1.0);
	assert_near(instance->pose.local[1].translation[1], 1.0 + shift, 1e-5);
	overlay_heat_ramp((float)fraction, rgb);
	for (int c = 0; c < 3; c++) {
		assert_near(shown[c], rgb[c], 1.0);
	}
}

/* Attenuations reach the second level below the first bone. */
static void test_a_preset_acts_as_soon_as_it_is_chosen_or_changed(void **state)
{
#define PRESET(name, attenuation)                                          \
	"[" name "]\nspeed = 0\namplitude = 1\nattenuation = " attenuation \
	"\ntranslation = 0 1 0\nrotation = 0 0 0\n"
	static const char presets[] = PRESET("a", "0") PRESET("b", "-0.25");
	static const char saved[] = PRESET("a", "0") PRESET("b", "-0.1");
	struct test_path folder = temp_dir_make();
	struct test_path model = path_join(&folder, "chain.gltf");
	struct test_path file = path_join(&folder, "presets.ini");
	struct log log = log_to_stderr(LOG_WARNING);
	struct gl gl = gl_recorder_begin();
	struct demo *demo;

	(void)state;
	file_write(file.text, presets, strlen(presets));
	assert_int_equal(setenv("LIMBER_ASSETS", folder.text, 1), 0);
	write_chain(model.text, 3, 1.0);
	demo = begin(model.text, &log, &gl);
	expect_shift(demo, 1.0, 1.0);
	press(demo, BUTTON_F6);
	expect_shift(demo, 0.75, 0.5);
	press(demo, BUTTON_RIGHT);
	expect_shift(demo, 0.8, 0.6);
	file_write(file.text, saved, strlen(saved));
	press(demo, BUTTON_F9);
	expect_shift(demo, 0.9, 0.8);
	press(demo, BUTTON_F6);
	expect_shift(demo, 1.0, 1.0);
	demo_destroy(demo_find("tuner"), demo);
	temp_dir_remove(&folder);
	unsetenv("LIMBER_ASSETS");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_level_has_its_colour),
		cmocka_unit_test(test_a_swing_is_as_long_as_the_figure),
		cmocka_unit_test(
			test_a_preset_acts_as_soon_as_it_is_chosen_or_changed),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
