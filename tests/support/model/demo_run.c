#include "tests/support/model/demo_run.h"

#include "app/demo/demo_figures.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

static const double press_s = 0.1;

static void begin(struct demo_run *run, const char *name, const char *kernel,
	bool may_save)
{
	const char *asset;
	char path[256];
	struct demo_env env;

	*run = (struct demo_run){.driver = demo_find(name)};
	run->log = log_to_stderr(LOG_WARNING);
	run->gl = gl_recorder_begin();
	asset = run->driver ? run->driver->asset : name;
	if (!run->driver) {
		run->driver = &demo_driver_viewer;
	}
	snprintf(path, sizeof(path), "assets/%s", asset);
	env = (struct demo_env){
		.log = &run->log,
		.gl = &run->gl,
		.target = PIXELS_RGBA8888,
		.kernel = kernel_find(kernel),
		.width = 480,
		.height = 640,
		.model_path = path,
		.character = demo_find(name) ? NULL : "none",
		.repeat = CLIP_LOOP,
		.speed = 1.0f,
		.may_save = may_save,
	};
	assert_int_equal(demo_create(run->driver, &env, &run->demo), 0);
}

void demo_run_begin(struct demo_run *run, const char *name)
{
	begin(run, name, "float", false);
}

void demo_run_begin_by(
	struct demo_run *run, const char *name, const char *kernel)
{
	begin(run, name, kernel, false);
}

void demo_run_begin_saving(struct demo_run *run, const char *name)
{
	begin(run, name, "float", true);
}

static bool is_due(double at_s, double from_s, double to_s)
{
	return at_s >= from_s && at_s < to_s;
}

static void press_due(struct demo_run *run, double to_s,
	const struct demo_press *press, int press_count)
{
	for (int i = 0; i < press_count; i++) {
		struct button_event event = {.button = press[i].button};

		if (is_due(press[i].time_s, run->now_s, to_s)) {
			event.down = true;
			demo_press(run->driver, run->demo, &event);
		}
		if (is_due(press[i].time_s + press_s, run->now_s, to_s)) {
			event.down = false;
			demo_press(run->driver, run->demo, &event);
		}
	}
}

void demo_run_to(struct demo_run *run, double time_s, double rate_hz,
	const struct demo_press *press, int press_count)
{
	while (run->now_s < time_s) {
		double next_s = run->now_s + 1.0 / rate_hz;

		press_due(run, next_s, press, press_count);
		run->now_s = next_s;
		run->driver->update(run->demo, next_s);
	}
}

void demo_run_draw(struct demo_run *run)
{
	gl_recorder_clear();
	demo_draw_stage(run->driver, run->demo, 480, 640);
}

void demo_run_end(struct demo_run *run)
{
	demo_destroy(run->driver, run->demo);
	run->demo = NULL;
}
