#include "app/cmd/command.h"
#include "app/cmd/options/options_kernel.h"
#include "app/cmd/show/show_state.h"
#include "platform/base/interrupt.h"
#include "platform/process/confine.h"
#include "platform/process/stop.h"
#include "platform/process/user.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static const int first_picture_ms = 3000;
static const double film_rate_hz = 25.0; /* for --record on the real clock */

/*
 * Returns 0, or -EINVAL if the value of --camera is wrong. A camera that fails
 * does not end the run.
 */
static int open_camera(struct show *show)
{
	struct camera_feed *camera = &show->camera;
	const char *spec = show->options->input.camera;
	int error = spec ? camera_feed_open(spec, show->log, camera) : 0;

	/*
	 * A fixed clock does not wait, so the first frames would have no camera
	 * pictures.
	 */
	if (!error && camera->driver && show->clock.fixed &&
		camera->driver->await) {
		camera->driver->await(camera->source, first_picture_ms);
	}
	show->keys.has_camera = camera->driver != NULL;
	return error == -EINVAL ? error : 0;
}

static int open_screen(struct show *show)
{
	double rate_hz = show->clock.fixed ? show->clock.rate_hz : 30.0;
	int frames = show->frames > 0 ? show->frames : 0;

	return show_screen_open(&show->screen, show->options,
		show->plan->display, frames, rate_hz, show->log);
}

static int open_hud(struct show *show)
{
	int error;

	show->hud = calloc(1, sizeof(*show->hud));
	if (!show->hud) {
		log_error(show->log, "labels: there is not enough memory");
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

static int open_demo(struct show *show)
{
	const struct options *options = show->options;
	const struct demo_env env = {
		.log = show->log,
		.gl = &show->screen.gl->gl,
		.target = show->screen.info.format,
		.kernel = options_kernel(&options->vertices, show->log),
		.width = show->screen.info.width,
		.height = show->screen.info.height,
		.no_labels = options->show.no_labels,
		.frame_times = options->show.hud,
		.model_path = show->plan->model_path,
		.memory_bytes = options->common.memory_bytes,
		.character = options->show.character,
		.clip = options->motion.clip,
		.interpolation = options->motion.interpolation,
		.repeat = options->motion.repeat,
		.all_loop = options->motion.all_loop,
		.speed = options->motion.speed,
		.influence_cap = options->vertices.influences,
		.lod = options->vertices.lod,
		.walkers = options->show.walkers,
		.follow_file = show->plan->follow_file,
		.may_save = show->plan->may_save,
		.now_ns = show->clock.fixed ? NULL : clock_monotonic_ns,
		.unattended = show->plan->unattended,
		.camera = &show->camera,
		.camera_use = options->input.camera_use,
		.smooth = show->screen.gl->accelerated ||
			show->screen.info.format != PIXELS_RGB565,
		.overlays = options->show.overlays,
	};

	int error;

	atomic_store(&show->opening, true);
	error = demo_create(show->plan->demo, &env, &show->demo);
	atomic_store(&show->opening, false);
	return error;
}

static int open_film(struct show *show)
{
	const struct display_info *info = &show->screen.info;
	const struct pixels size = {
		.width = info->width,
		.height = info->height,
		.format = show->screen.driver->get_surface ? PIXELS_RGBA8888
							   : info->format,
	};
	const char *path = show->options->show.record;

	if (!path) {
		return 0;
	}
	return film_open(&show->film, path, &size,
		show->clock.fixed ? show->clock.rate_hz : film_rate_hz, 0,
		show->log);
}

/*
 * Completes a display that is a file. A signal ends play in an orderly way, but
 * would leave render's file incomplete.
 */
static int complete_output(struct show *show)
{
	const struct show_screen *screen = &show->screen;

	if (!screen->driver->finish) {
		return 0;
	}
	if (stop_requested()) {
		log_error(show->log,
			"render: a signal stopped limber before the file was complete: run it again");
		return -EINTR;
	}
	return atomic_load(&show->heard_error)
		? -EIO
		: screen->driver->finish(screen->display);
}

/*
 * Becomes --user and confines the process. Everything but the model and the
 * films is open. Windows of a desktop open sockets later, and the user may save
 * pictures in any folder.
 */
static int confine(const struct show *show)
{
	const char *user = show->options->show.user;
	int error = user ? user_become(user, show->log) : 0;

	const struct confine_request request = {
		.writes_anywhere = true,
		.connects = show->screen.driver->get_surface ||
			strcmp(show->screen.driver->name, "window") == 0,
	};

	if (!error) {
		(void)confine_process(&request, show->log);
	}
	return error;
}

/* Writes the file of --stats, unless the run failed. */
static int close_stats(
	const struct show *show, struct output_file *file, int run_error)
{
	if (!file || run_error) {
		output_file_discard(file);
		return 0;
	}
	frame_stats_write(&show->stats, output_file_stream(file));
	return output_file_commit(file);
}

/* Runs all frames and completes the files. */
static int play(struct show *show)
{
	int error = open_film(show);
	int film_error;

	if (error) {
		return error;
	}
	if (show->plan->print_keys) {
		program_keys_print(stdout, show->plan->demo, show->demo,
			show->keys.has_camera);
	}
	atomic_store(&show->heard_error, false);
	error = show_loop_run(show);
	snapshot_finish(&show->snapshot);
	film_error = film_close(&show->film);
	if (!error) {
		error = show->film_error ? show->film_error : film_error;
	}
	return error ? error : complete_output(show);
}

/* Opens the file of --stats before a long run, plays, and writes the file. */
static int run(struct show *show)
{
	const char *path = show->options->show.stats;
	struct output_file *stats = NULL;
	int error = path
		? output_file_create_for("--stats", path, show->log, &stats)
		: 0;
	int stats_error;

	if (error) {
		return error;
	}
	error = play(show);
	stats_error = close_stats(show, stats, error);
	return error ? error : stats_error;
}

static int open_and_run(struct show *show)
{
	int error = show_input_open(show);
	int input_error;

	if (error) {
		return error;
	}
	error = open_screen(show);
	if (error) {
		goto out_input;
	}
	error = show_input_add_keyboards(show);
	if (!error) {
		error = open_hud(show);
	}
	if (error) {
		goto out_screen;
	}
	error = confine(show);
	if (!error) {
		error = open_demo(show);
	}
	if (error) {
		if (error == -EINTR && stop_requested()) {
			error = complete_output(show);
		}
		goto out_hud;
	}
	error = run(show);
	demo_destroy(show->plan->demo, show->demo);
out_hud:
	close_hud(show);
out_screen:
	show_screen_close(&show->screen);
out_input:
	input_error = show_input_close(show, error);
	return error ? error : input_error;
}

/* Some signals end play in order and are failures nevertheless. */
static int judge_end(int status, const struct log *log)
{
	const char *failure = stop_failure();

	if (status == EXIT_OK && failure) {
		log_error(log, "play: ended early: %s", failure);
		return EXIT_FAILED;
	}
	return status;
}

/* Nobody who asks for the end while a model loads wants to hear what it lacks. */
static void hear(void *user, enum log_level level, const char *message)
{
	struct show *show = user;

	if (atomic_load(&show->opening) && interrupt_pending()) {
		return;
	}
	if (level == LOG_ERROR) {
		atomic_store(&show->heard_error, true);
	}
	show->caller_log->write(show->caller_log->user, level, message);
}

int show_run(const struct show_plan *plan, const struct options *options,
	const struct log *log)
{
	struct show show;
	const struct log heard = {
		.write = hear, .user = &show, .threshold = log->threshold};
	const char *watchdog = options->show.watchdog;
	int status = EXIT_USAGE;

	show = (struct show){
		.plan = plan,
		.options = options,
		.log = &heard,
		.caller_log = log,
		.clock = plan->clock,
		.frames = plan->frames,
		.watch.shown = options->show.hud,
		.governor = governor_begin(options->show.budget_ms),
		.watchdog = watchdog_none(),
	};
	stop_catch();
	if (open_camera(&show) == 0) {
		if (watchdog) {
			/*
			 * If this fails, it logs a warning and limber goes on.
			 */
			(void)watchdog_open(&show.watchdog, watchdog,
				&device_calls_system, log);
			stop_set_watchdog(show.watchdog.fd);
		}
		status = command_exit_code(open_and_run(&show));
		stop_set_watchdog(-1);
		watchdog_close(&show.watchdog);
	}
	camera_feed_close(&show.camera);
	status = judge_end(status, log);
	stop_release();
	return status;
}
