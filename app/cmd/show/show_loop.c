#include "app/cmd/show/show_state.h"

#include "app/cmd/progress.h"
#include "platform/base/scalar.h"
#include "platform/process/stop.h"

#include <errno.h>
#include <math.h>
#include <time.h>

enum {
	/* Of a film whose length nobody has given: an hour at 25 a second. */
	PERIOD_FRAMES_MAX = 90000
};

/* The watchdog is fed once a frame only, so that it acts when frames stop. */
static void feed_watchdog(struct show *show)
{
	int64_t now_ms = clock_monotonic_ms();

	watchdog_feed(&show->watchdog, now_ms);
	if (show->plan->failsafe) {
		failsafe_feed(show->plan->failsafe, now_ms);
	}
}

/* Updates the demo without drawing, up to begin_s. */
static void skip_to(struct show *show, double begin_s)
{
	double step_s = 1.0 / (show->clock.fixed ? show->clock.rate_hz : 60.0);

	for (double at = 0.0; at < begin_s && !show->closed; at += step_s) {
		show->closed = stop_requested();
		feed_watchdog(show);
		show_input_poll_buttons(show, (int64_t)(at * 1000.0));
		show->plan->demo->update(show->demo, at);
		demo_update_live(show->demo, at, show->screen.info.width,
			show->screen.info.height);
	}
}

/*
 * Feeds the governor. Presenting counts as work unless it waits for the screen.
 */
static void keep_budget(struct show *show)
{
	const float *stage_ms = show->watch.stage_ms;
	bool waits = show->screen.info.rate_hz > 0.0;
	float work_ms = stage_ms[HUD_ANIMATE] + stage_ms[HUD_DRAW] +
		(waits ? 0.0f : stage_ms[HUD_PRESENT]);

	if (governor_feed(&show->governor, show->now_s, work_ms)) {
		struct demo_reduction reduction =
			governor_reduction(&show->governor);

		demo_set_reduction(show->demo, &reduction);
	}
}

/*
 * Waits while another console is on the screen. The animation waits, too, but a
 * watchdog must not bite.
 */
static void wait_for_console(struct show *show, int64_t now_ms)
{
	const struct timespec while_away = {.tv_nsec = 20000000};

	if (!show->away) {
		return;
	}
	while (show->away && !show->closed) {
		(void)nanosleep(&while_away, NULL);
		show_input_poll_display(show, now_ms);
		show_input_ignore_buttons(show, now_ms);
		feed_watchdog(show);
	}
	clock_begin(&show->clock, show->now_s);
	frame_stats_begin(&show->stats);
	frame_watch_begin(&show->watch);
}

static int run_frame(struct show *show)
{
	int64_t now_ms;
	int error;

	show->now_s = clock_tick(&show->clock);
	now_ms = (int64_t)(show->now_s * 1000.0);
	frame_stats_begin(&show->stats);
	frame_watch_begin(&show->watch);
	show_input_poll_display(show, now_ms);
	wait_for_console(show, now_ms);
	if (show->away) {
		return 0;
	}
	show_input_poll_buttons(show, now_ms);
	if (governor_poses(&show->governor)) {
		show->plan->demo->update(show->demo, show->now_s);
	}
	frame_watch_stage(&show->watch, HUD_ANIMATE);
	/* After an error, no incomplete picture may go into a file. */
	if (show->screen.driver->finish && atomic_load(&show->heard_error)) {
		return -EIO;
	}
	error = show_frame_draw(show);
	if (error) {
		return error;
	}
	frame_stats_end(&show->stats);
	frame_watch_end(&show->watch);
	if (!show->clock.fixed) {
		keep_budget(show);
		demo_set_rate(show->demo, hud_graph_rate(&show->watch.graph));
	}
	feed_watchdog(show);
	return 0;
}

/*
 * Sets the number of frames to those of a period. Returns 0, or -E2BIG after
 * logging an error: a mistyped --speed may ask for years of film.
 */
static int choose_frames(struct show *show)
{
	double period_s = show->plan->demo->period_s(show->demo);
	double frames = floor(period_s * show->clock.rate_hz + 0.5);

	if (frames > PERIOD_FRAMES_MAX) {
		log_error(show->log,
			"%s: the animation takes %.0f frames, which are more than %d: say with --frames how many to write, or choose another --speed or --clock",
			show->options->screen.output, frames, PERIOD_FRAMES_MAX);
		return -E2BIG;
	}
	show->frames = scalar_to_int(frames, 1, PERIOD_FRAMES_MAX);
	return 0;
}

/*
 * Returns when the first frame is. A film of one period, which will be shown
 * again and again, begins where the next one would be the same.
 */
static double choose_begin(const struct show *show)
{
	const struct show_plan *plan = show->plan;
	bool whole = plan->frames < 0 && plan->unattended && plan->begin_s <= 0;

	return whole && plan->demo->settled_s ? plan->demo->settled_s(show->demo)
					      : plan->begin_s;
}

int show_loop_run(struct show *show)
{
	double begin_s = choose_begin(show);
	struct progress progress;
	int error = 0;

	if (show->frames < 0) {
		error = choose_frames(show);
	}
	if (error) {
		return error;
	}
	skip_to(show, begin_s);
	/* Loading has taken time, which the first frame must not show. */
	clock_begin(&show->clock, begin_s);
	show->pace = show->clock.fixed
		? pace_none()
		: pace_begin(show->options->show.fps, show->screen.info.rate_hz);
	progress = progress_begin(
		show->plan->progress ? show->frames : 0, "frames", stderr);
	for (int done = 0; !error && !show->closed; done++) {
		if (show->frames && done >= show->frames) {
			break;
		}
		error = run_frame(show);
		if (!error) {
			progress_step(&progress, done + 1);
			pace_wait(&show->pace);
		}
	}
	progress_end(&progress);
	return error;
}
