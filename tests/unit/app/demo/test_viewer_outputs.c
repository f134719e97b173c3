/* The viewer holds the GPIO lines of the character that it shows. */
#include "app/demo/demo.h"
#include "platform/buttons/gpio_output.h"
#include "tests/support/files.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

/* The functions below replace those of the GPIO chips; there is one line. */
struct gpio_output {
	int opened, open, on, checked;
};

static struct gpio_output led;

int gpio_output_check(const char *line, const struct log *log)
{
	(void)line;
	(void)log;
	return 0;
}

struct gpio_output *gpio_output_open(const char *where, const char *name,
	const char *line, const struct log *log)
{
	(void)where;
	(void)line;
	(void)log;
	assert_string_equal(name, "led");
	/* No program can open a line that is in use. */
	assert_false(led.open);
	led.open = 1;
	led.opened++;
	return &led;
}

void gpio_output_set(struct gpio_output *output, bool on)
{
	if (output) {
		assert_true(output->open);
		output->on = on;
	}
}

void gpio_output_check_all(struct gpio_output *const *outputs, int count)
{
	assert_true(count > 0 && outputs[0] == &led && led.open);
	led.checked++;
}

void gpio_output_close(struct gpio_output *output)
{
	if (output) {
		assert_true(output->open);
		output->open = output->on = 0;
	}
}

static void put(const struct test_path *path, const char *clip)
{
	char text[200];
	int length = snprintf(text, sizeof(text),
		"[state a]\nclip = %s\n[output led]\nline = gpiochip0/1\n"
		"[buttons]\nUP = output led on\n",
		clip);

	file_write(path->text, text, (size_t)length);
}

static void press_up(struct demo *demo)
{
	struct button_event event = {.button = BUTTON_UP, .down = true};

	demo_press(&demo_driver_viewer, demo, &event);
	event.down = false;
	demo_press(&demo_driver_viewer, demo, &event);
}

/* A new character begins with them off; a broken one leaves them as they were. */
static void test_the_lines_stay_open_while_files_change(void **state)
{
	static const struct {
		const char *clip;
		int opened;
		bool on;
	} changes[] = {
		{"idle", 2, false}, {"none", 3, true}, {"walk", 4, false}};
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "leds.character");
	struct log log = log_to_nowhere();
	struct gl gl = gl_recorder_begin();
	const struct demo_env env = {.log = &log,
		.gl = &gl,
		.target = PIXELS_RGBA8888,
		.kernel = &kernel_float,
		.width = 240,
		.height = 320,
		.model_path = "assets/walker.glb",
		.character = path.text,
		.repeat = CLIP_LOOP,
		.speed = 1.0f,
		.follow_file = true};
	struct demo *demo;
	double now_s = 0.0;

	(void)state;
	put(&path, "rest");
	assert_int_equal(demo_create(&demo_driver_viewer, &env, &demo), 0);
	assert_int_equal(led.opened, 1);
	for (size_t i = 0; i < ARRAY_COUNT(changes); i++) {
		put(&path, changes[i].clip);
		for (int k = 0; k < 3; k++) {
			demo_driver_viewer.update(demo, now_s += 1.1);
		}
		assert_int_equal(led.opened, changes[i].opened);
		assert_true(led.open);
		assert_int_equal(led.on, changes[i].on);
		press_up(demo);
		demo_driver_viewer.update(demo, now_s);
		assert_true(led.on);
	}
	assert_true(led.checked > 0);
	demo_destroy(&demo_driver_viewer, demo);
	assert_false(led.open || led.on);
	temp_dir_remove(&folder);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_lines_stay_open_while_files_change),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
