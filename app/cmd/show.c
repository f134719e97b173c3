#include "app/cmd/show.h"

#include "app/cmd/kernel_choice.h"
#include "app/cmd/progress.h"
#include "platform/base/file.h"
#include "platform/buttons/buttons.h"
#include "platform/display/display.h"
#include "platform/gl/gl_context.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static const double real_frame_s = 1.0 / 60.0;

/* All that a run has open. */
struct show {
	const struct show_plan *plan;
	const struct log *log;
	const struct display_driver *display_driver;
	struct display *display;
	struct gl_context *gl;
	struct buttons buttons;
	struct demo *demo;
	struct hud *hud;
	bool labelled;
	struct clock clock;
	int frames; /* 0: until closed */
	bool closed;
};

static int say_unknown_demo(const char *name, const struct log *log)
{
	const char *names[16];
	const char *closest;
	int count = 0;

	for (; demo_registry[count] && count < 15; count++) {
		names[count] = demo_registry[count]->name;
	}
	names[count] = NULL;
	closest = options_closest(name, names);
	log_error(log, "--demo %s: no such demo: %s%s%s", name,
		closest ? "did you mean " : "choose walker, arm or face",
		closest ? closest : "", closest ? "?" : "");
	return -EINVAL;
}

/* Names of drivers are wrong usage, whatever the machine has. */
static int check_names(const struct options *options, const struct log *log)
{
	if (options->display && !display_choose(options->display, log)) {
		return -EINVAL;
	}
	if (options->gl && !gl_is_known(options->gl, log)) {
		return -EINVAL;
	}
	return kernel_choose(options->kernel, log) ? 0 : -EINVAL;
}

int show_choose(const struct options *options, const struct log *log,
	struct show_plan *plan, char *path, size_t size)
{
	int error = check_names(options, log);

	if (error) {
		return error;
	}
	if (options->demo && options->model_path) {
		log_error(log,
			"%s: a demo brings its own model: give --demo "
			"or a file, not both",
			options->model_path);
		return -EINVAL;
	}
	if (options->model_path) {
		plan->demo = &demo_driver_viewer;
		plan->model_path = options->model_path;
		return 0;
	}
	if (options->clip) {
		log_error(log,
			"--clip %s: a demo chooses its own clips: name "
			"a model file instead",
			options->clip);
		return -EINVAL;
	}
	plan->demo = options->demo ? demo_find(options->demo) : demo_registry[0];
	if (!plan->demo) {
		return say_unknown_demo(options->demo, log);
	}
	plan->model_path = path;
	return file_find_asset(plan->demo->asset, log, path, size);
}

static int open_display(struct show *show, const struct options *options)
{
	const struct display_options wanted = {
		.width = options->width,
		.height = options->height,
		.title = "limber",
		.output = options->output,
		.frame_count = show->frames,
		.rate_hz = show->clock.fixed ? show->clock.rate_hz : 30.0,
		.log = show->log,
	};

	return show->display_driver->create(&wanted, &show->display);
}

static int open_buttons(struct show *show, const struct options *options)
{
	int error = buttons_open(&show->buttons, options->buttons, show->log);

	if (!error && options->script) {
		error = buttons_add(
			&show->buttons, "script", options->script, show->log);
		if (error) {
			buttons_close(&show->buttons);
		}
	}
	return error;
}

static int open_demo(struct show *show, const struct options *options)
{
	const struct demo_env env = {
		.log = show->log,
		.gl = &show->gl->gl,
		.target = PIXELS_RGBA8888,
		.kernel = kernel_choose(options->kernel, show->log),
		.width = options->width,
		.height = options->height,
		.model_path = show->plan->model_path,
		.clip = options->clip,
		.interpolation = options->interpolation,
		.repeat = options->repeat,
		.speed = options->speed,
		.lod = options->lod,
		.unattended = show->plan->unattended,
	};

	return demo_create(show->plan->demo, &env, &show->demo);
}

static int open_hud(struct show *show)
{
	int error;

	show->hud = calloc(1, sizeof(*show->hud));
	if (!show->hud) {
		log_error(show->log, "labels: not enough memory");
		return -ENOMEM;
	}
	error = hud_init(show->hud, &show->gl->gl, show->log);
	if (error) {
		free(show->hud);
	}
	return error;
}

static void close_hud(struct show *show)
{
	hud_finish(show->hud, &show->gl->gl);
	free(show->hud);
}

static void press_buttons(struct show *show, int64_t now_ms)
{
	struct button_event event;

	buttons_poll(&show->buttons, now_ms);
	while (button_queue_pop(&show->buttons.queue, &event)) {
		demo_press(show->plan->demo, show->demo, &event);
	}
}

static int draw_frame(struct show *show)
{
	struct pixels pixels;
	int error = show->display_driver->begin_frame(show->display, &pixels);

	if (!error) {
		error = show->gl->driver->begin_frame(show->gl, &pixels);
	}
	if (error) {
		return error;
	}
	show->plan->demo->draw(show->demo, pixels.width, pixels.height);
	if (show->labelled) {
		hud_begin(show->hud, pixels.width, pixels.height);
		show->plan->demo->label(show->demo, show->hud);
		hud_end(show->hud, &show->gl->gl);
	}
	error = show->gl->driver->end_frame(show->gl);
	return error ? error : show->display_driver->end_frame(show->display);
}

static void poll_display(struct show *show, int64_t now_ms)
{
	struct display_events events = {0};

	if (show->display_driver->poll) {
		show->display_driver->poll(
			show->display, now_ms, &show->buttons.queue, &events);
		show->closed = show->closed || events.close;
	}
}

/* Up to the moment of the first frame, in the steps of the clock. */
static void run_up(struct show *show)
{
	double step_s =
		show->clock.fixed ? 1.0 / show->clock.rate_hz : real_frame_s;

	for (double at = 0.0; at < show->plan->begin_s; at += step_s) {
		press_buttons(show, (int64_t)(at * 1000.0));
		show->plan->demo->update(show->demo, at);
	}
}

/* A window need not show more than a screen can. */
static void wait_for_next_frame(const struct show *show, double frame_s)
{
	struct clock clock = show->clock;
	double spent_s = clock_tick(&clock) - frame_s;

	if (!show->clock.fixed && spent_s < real_frame_s) {
		struct timespec left = {
			.tv_nsec = (long)((real_frame_s - spent_s) * 1e9),
		};

		nanosleep(&left, NULL);
	}
}

static int run_frames(struct show *show)
{
	struct progress progress =
		progress_begin(show->plan->progress ? show->frames : 0, stderr);
	int error = 0;

	for (int done = 0; !show->closed; done++) {
		double now_s;

		if (show->frames && done >= show->frames) {
			break;
		}
		now_s = clock_tick(&show->clock);
		poll_display(show, (int64_t)(now_s * 1000.0));
		press_buttons(show, (int64_t)(now_s * 1000.0));
		show->plan->demo->update(show->demo, now_s);
		error = draw_frame(show);
		if (error) {
			break;
		}
		progress_step(&progress, done + 1);
		wait_for_next_frame(show, now_s);
	}
	progress_end(&progress);
	return error;
}

static int finish(struct show *show)
{
	return show->display_driver->finish
		? show->display_driver->finish(show->display)
		: 0;
}

/* How many frames one period of the demo is. */
static int period_frames(const struct show *show)
{
	double period_s = show->plan->demo->period_s(show->demo);
	double rate_hz = show->clock.fixed ? show->clock.rate_hz : 30.0;
	int frames = (int)(period_s * rate_hz + 0.5);

	return frames < 1 ? 1 : frames;
}

int show_run(const struct show_plan *plan, const struct options *options,
	const struct log *log)
{
	struct show show = {.plan = plan,
		.log = log,
		.clock = plan->clock,
		.frames = plan->frames,
		.labelled = !options->no_labels};
	int error = -ENOENT;

	show.display_driver = display_choose(plan->display, log);
	if (!show.display_driver) {
		return error;
	}
	error = open_buttons(&show, options);
	if (error) {
		return error;
	}
	error = gl_open(options->gl, PIXELS_RGBA8888, log, &show.gl);
	if (error) {
		goto out_buttons;
	}
	error = open_hud(&show);
	if (error) {
		goto out_gl;
	}
	error = open_demo(&show, options);
	if (error) {
		goto out_hud;
	}
	if (show.frames < 0) {
		show.frames = period_frames(&show);
	}
	error = open_display(&show, options);
	if (error) {
		goto out_demo;
	}
	if (plan->opened) {
		plan->opened(plan->demo);
	}
	run_up(&show);
	error = run_frames(&show);
	if (!error) {
		error = finish(&show);
	}
	show.display_driver->destroy(show.display);
out_demo:
	demo_destroy(show.demo);
out_hud:
	close_hud(&show);
out_gl:
	show.gl->driver->destroy(show.gl);
out_buttons:
	buttons_close(&show.buttons);
	return error;
}
