#include "app/cmd/show/show.h"

#include "app/cmd/options/options_kernel.h"
#include "app/cmd/progress.h"
#include "app/cmd/show/button_record.h"
#include "app/cmd/show/film.h"
#include "app/cmd/show/frame_stats.h"
#include "app/cmd/show/frame_watch.h"
#include "app/cmd/show/pace.h"
#include "app/cmd/show/program_keys.h"
#include "app/cmd/show/show_screen.h"
#include "app/demo/governor.h"
#include "platform/buttons/buttons.h"
#include "platform/process/stop.h"
#include "platform/watchdog/watchdog.h"

#include <errno.h>
#include <stdlib.h>

static const int first_picture_ms = 3000;
static const double film_rate_hz = 25.0; /* of what is recorded as it comes */

/* All that a run has open. */
struct show {
	const struct show_plan *plan;
	const struct log *log;
	struct screen screen;
	struct buttons buttons;
	const enum button *action; /* whose action a button does */
	struct button_record record;
	struct watchdog watchdog;
	struct camera_feed camera;
	struct demo *demo;
	struct hud *hud;
	bool labelled;
	struct program_keys keys;
	struct frame_watch watch;
	struct governor governor;
	struct film film;
	int film_error;      /* the film has ended early by it */
	bool picture_wanted; /* in a file, of the frame under way */
	struct snapshot snapshot;
	struct pixels looked; /* what is read back from a surface */
	struct clock clock;
	struct pace pace;
	double now_s;
	struct frame_stats stats;
	int frames; /* 0: until closed */
	bool closed;
};

static int open_buttons(struct show *show, const struct options *options)
{
	int error =
		buttons_open(&show->buttons, options->input.buttons, show->log);

	if (!error && options->input.script) {
		error = buttons_add(&show->buttons, "script",
			options->input.script, show->log);
	}
	if (!error && options->input.record_buttons) {
		error = button_record_open(&show->record,
			options->input.record_buttons, show->log);
	}
	if (error) {
		buttons_close(&show->buttons);
	}
	return error;
}

static int open_demo(struct show *show, const struct options *options)
{
	const struct demo_env env = {
		.log = show->log,
		.gl = &show->screen.gl->gl,
		.target = show->screen.info.format,
		.kernel = options_kernel(&options->vertices, show->log),
		.width = show->screen.info.width,
		.height = show->screen.info.height,
		.model_path = show->plan->model_path,
		.clip = options->motion.clip,
		.interpolation = options->motion.interpolation,
		.repeat = options->motion.repeat,
		.speed = options->motion.speed,
		.influence_cap = options->vertices.influences,
		.lod = options->vertices.lod,
		.walkers = options->show.walkers,
		.follow_file = show->plan->follow_file,
		.now_ns = show->clock.fixed ? NULL : clock_monotonic_ns,
		.unattended = show->plan->unattended,
		.camera = &show->camera,
		.camera_use = options->input.camera_use,
		.smooth = show->screen.gl->accelerated ||
			show->screen.info.format != PIXELS_RGB565,
	};

	return demo_create(show->plan->demo, &env, &show->demo);
}

/* What is wrong in SPEC ends the program; a camera that fails does not. */
static int open_camera(struct show *show, const struct options *options)
{
	struct camera_feed *camera = &show->camera;
	int error;

	if (!options->input.camera) {
		return 0;
	}
	error = camera_feed_open(options->input.camera, show->log, camera);
	/* A picture in a file cannot show what comes later. */
	if (!error && show->clock.fixed && camera->driver->await) {
		camera->driver->await(camera->source, first_picture_ms);
	}
	return error == -EINVAL ? error : 0;
}

static int open_hud(struct show *show)
{
	int error;

	show->hud = calloc(1, sizeof(*show->hud));
	if (!show->hud) {
		log_error(show->log, "labels: not enough memory");
		return -ENOMEM;
	}
	error = hud_init(show->hud, &show->screen.gl->gl, show->log);
	if (error) {
		free(show->hud);
	}
	return error;
}

static void close_hud(struct show *show)
{
	hud_finish(show->hud, &show->screen.gl->gl);
	free(show->hud);
}

static void fulfil(struct show *show, enum program_wish wish)
{
	if (wish == WISH_GRAPH) {
		show->watch.shown = !show->watch.shown;
	}
	if (wish == WISH_PICTURE) {
		show->picture_wanted = true;
	}
}

/* Does the action that the button is to have. */
static void press(struct show *show, struct button_event event)
{
	struct button_event passed[PROGRAM_KEYS_PASSED];
	int count;

	event.button = show->action[event.button];
	if (event.button == BUTTON_COUNT) {
		return;
	}
	fulfil(show, program_keys_take(&show->keys, &event, passed, &count));
	for (int i = 0; i < count; i++) {
		demo_press(show->plan->demo, show->demo, &passed[i]);
	}
}

static void press_buttons(struct show *show, int64_t now_ms)
{
	struct button_event event;

	buttons_poll(&show->buttons, now_ms);
	while (button_queue_pop(&show->buttons.queue, &event)) {
		button_record_event(&show->record, &event);
		press(show, event);
		if (!show->clock.fixed) {
			frame_stats_press(&show->stats,
				show->clock.origin_ns + event.time_ms * 1000000);
		}
	}
	fulfil(show, program_keys_wait(&show->keys, now_ms));
}

/* Labels and the graph, whichever are wanted. */
static void draw_hud(struct show *show, int width, int height)
{
	const struct demo_driver *driver = show->plan->demo;
	const struct demo_facts facts = demo_get_facts(driver, show->demo);

	if (!show->labelled && !show->watch.shown) {
		return;
	}
	hud_begin(show->hud, width, height);
	if (show->labelled) {
		demo_label(driver, show->demo, show->hud);
		governor_label(&show->governor, show->hud);
	}
	frame_watch_show(&show->watch, &facts, show->screen.gl->driver->name,
		show->labelled ? NULL : governor_text(&show->governor),
		show->hud);
	hud_end(show->hud, &show->screen.gl->gl);
}

/* Into the files that are wanted; what fails there does not end the run. */
static void keep_frame(struct show *show, int width, int height)
{
	const struct pixels *on = &show->screen.pixels;
	struct pixels picture;

	if (!show->film.display && !show->picture_wanted) {
		return;
	}
	if (film_look(on->data ? on : NULL, &show->screen.gl->gl, width, height,
		    &show->looked, &picture, show->log) != 0) {
		show->picture_wanted = false;
		return;
	}
	if (show->picture_wanted) {
		snapshot_take(&show->snapshot, &picture, show->log);
		show->picture_wanted = false;
	}
	if (!show->film_error) {
		show->film_error = film_add(&show->film, &picture, show->now_s);
	}
}

static int draw_frame(struct show *show)
{
	int width, height;
	int error = screen_begin_frame(&show->screen, &width, &height);

	if (error) {
		return error;
	}
	demo_update_live(show->demo, show->now_s, width, height);
	show->plan->demo->draw(show->demo, width, height);
	draw_hud(show, width, height);
	error = screen_complete_frame(&show->screen);
	frame_watch_stage(&show->watch, HUD_DRAW);
	if (!error) {
		keep_frame(show, width, height);
		error = screen_end_frame(&show->screen);
	}
	frame_watch_stage(&show->watch, HUD_PRESENT);
	return error;
}

static void poll_display(struct show *show, int64_t now_ms)
{
	const struct screen *screen = &show->screen;
	struct display_events events = {0};

	if (screen->driver->poll) {
		screen->driver->poll(
			screen->display, now_ms, &show->buttons.queue, &events);
	}
	show->closed = show->closed || events.close || stop_requested();
	if (events.graph) {
		fulfil(show, WISH_GRAPH);
	}
	if (events.picture) {
		fulfil(show, WISH_PICTURE);
	}
}

static void feed_watchdog(struct show *show)
{
	watchdog_feed(&show->watchdog, clock_monotonic_ns() / 1000000);
}

/* Up to the moment of the first frame, in the steps of the clock. */
static void run_up(struct show *show)
{
	double step_s = 1.0 / (show->clock.fixed ? show->clock.rate_hz : 60.0);

	for (double at = 0.0; at < show->plan->begin_s; at += step_s) {
		feed_watchdog(show);
		press_buttons(show, (int64_t)(at * 1000.0));
		show->plan->demo->update(show->demo, at);
		demo_update_live(show->demo, at, show->screen.info.width,
			show->screen.info.height);
	}
}

/* Work is what the processor does; a screen with a pace waits in between. */
static void keep_budget(struct show *show, double now_s)
{
	const float *stage_ms = show->watch.stage_ms;
	bool waits = show->screen.info.rate_hz > 0.0;
	float work_ms = stage_ms[HUD_ANIMATE] + stage_ms[HUD_DRAW] +
		(waits ? 0.0f : stage_ms[HUD_PRESENT]);

	if (governor_feed(&show->governor, now_s, work_ms)) {
		struct demo_reduction reduction =
			governor_reduction(&show->governor);

		demo_set_reduction(show->demo, &reduction);
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
		now_s = show->now_s = clock_tick(&show->clock);
		frame_stats_begin(&show->stats);
		frame_watch_begin(&show->watch);
		poll_display(show, (int64_t)(now_s * 1000.0));
		press_buttons(show, (int64_t)(now_s * 1000.0));
		if (governor_poses(&show->governor)) {
			show->plan->demo->update(show->demo, now_s);
		}
		frame_watch_stage(&show->watch, HUD_ANIMATE);
		error = draw_frame(show);
		if (error) {
			break;
		}
		frame_stats_end(&show->stats);
		frame_watch_end(&show->watch);
		if (!show->clock.fixed) {
			keep_budget(show, now_s);
			demo_set_rate(
				show->demo, hud_graph_rate(&show->watch.graph));
		}
		feed_watchdog(show);
		progress_step(&progress, done + 1);
		pace_wait(&show->pace);
	}
	progress_end(&progress);
	return error;
}

/* A file that is not all there is none; a person who closes play is done. */
static int finish(struct show *show)
{
	const struct screen *screen = &show->screen;

	if (screen->driver->finish && stop_requested()) {
		log_error(show->log,
			"render: stopped by a signal before the file was "
			"complete: begin again");
		return -EINTR;
	}
	return screen->driver->finish ? screen->driver->finish(screen->display)
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

static int open_film(struct show *show, const char *path)
{
	const struct display_info *info = &show->screen.info;
	const struct pixels size = {
		.width = info->width,
		.height = info->height,
		.format = show->screen.driver->get_surface ? PIXELS_RGBA8888
							   : info->format,
	};

	return film_open(&show->film, path, &size,
		show->clock.fixed ? show->clock.rate_hz : film_rate_hz,
		show->log);
}

/* With everything open. */
static int run(struct show *show, const struct options *options)
{
	int error;
	int filmed;

	error = options->show.record ? open_film(show, options->show.record) : 0;
	if (error) {
		return error;
	}
	if (show->frames < 0) {
		show->frames = period_frames(show);
	}
	if (show->plan->opened) {
		show->plan->opened(
			show->plan->demo, show->camera.driver != NULL);
	}
	run_up(show);
	show->pace = show->clock.fixed
		? pace_none()
		: pace_begin(options->show.fps, show->screen.info.rate_hz);
	error = run_frames(show);
	if (!error && options->show.stats) {
		error = frame_stats_write(
			&show->stats, options->show.stats, show->log);
	}
	snapshot_finish(&show->snapshot);
	filmed = film_close(&show->film);
	if (!error) {
		error = show->film_error ? show->film_error : filmed;
	}
	return error ? error : finish(show);
}

static int open_screen(struct show *show, const struct options *options)
{
	double rate_hz = show->clock.fixed ? show->clock.rate_hz : 30.0;
	int frames = show->frames > 0 ? show->frames : 0;

	return screen_open(&show->screen, options, show->plan->display, frames,
		rate_hz, show->log);
}

static int open_and_run(struct show *show, const struct options *options)
{
	int error = open_buttons(show, options);
	int recorded;

	if (error) {
		return error;
	}
	error = open_screen(show, options);
	if (error) {
		goto out_buttons;
	}
	error = open_hud(show);
	if (error) {
		goto out_screen;
	}
	error = open_camera(show, options);
	if (error) {
		goto out_hud;
	}
	error = open_demo(show, options);
	if (error) {
		goto out_camera;
	}
	error = run(show, options);
	free(show->looked.data);
	demo_destroy(show->plan->demo, show->demo);
out_camera:
	camera_feed_close(&show->camera);
out_hud:
	close_hud(show);
out_screen:
	screen_close(&show->screen);
out_buttons:
	buttons_close(&show->buttons);
	recorded = button_record_close(&show->record, error == 0);
	return error ? error : recorded;
}

int show_run(const struct show_plan *plan, const struct options *options,
	const struct log *log)
{
	struct show show = {
		.plan = plan,
		.log = log,
		.clock = plan->clock,
		.frames = plan->frames,
		.labelled = !options->show.no_labels,
		.action = options->input.action,
		.watch.shown = options->show.hud,
		.governor = governor_begin(options->show.budget_ms),
		.watchdog = watchdog_none(),
	};
	int error;

	stop_catch();
	if (options->show.watchdog) {
		/* Without one it goes on, and has said so. */
		(void)watchdog_open(&show.watchdog, options->show.watchdog,
			&device_calls_system, log);
	}
	error = open_and_run(&show, options);
	watchdog_close(&show.watchdog);
	stop_release();
	return error;
}
