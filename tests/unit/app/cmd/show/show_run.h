/*
 * Whole runs of play and render with a demo that notes what it is asked to do.
 */
#ifndef TESTS_UNIT_APP_CMD_SHOW_SHOW_RUN_H
#define TESTS_UNIT_APP_CMD_SHOW_SHOW_RUN_H

#include "app/cmd/command.h"
#include "app/cmd/show/show.h"
#include "platform/process/confine.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <signal.h>
#include <string.h>

enum {
	NOTED_MAX = 64
};

/* What the demo below was asked to do; its functions carry no context. */
static struct {
	double updated_s[NOTED_MAX];
	int updates;
	struct button_event pressed[NOTED_MAX];
	int presses;
	double period_s;
	const struct log *log;
	int error_at, signal_at; /* the update that causes it; -1: none */
	bool signal_first;       /* comes while the demo is prepared */
	bool connects, writes_anywhere;
} noted;

/* Replaces limber's: tests go on after a run, and the leak check needs rights. */
struct confinement confine_process(
	const struct confine_request *request, const struct log *log)
{
	(void)log;
	noted.connects = request->connects;
	noted.writes_anywhere = request->writes_anywhere;
	return (struct confinement){false, false};
}

static int note_prepare(struct demo *demo, const struct demo_env *env)
{
	noted.log = env->log;
	if (noted.signal_first) {
		raise(SIGTERM);
		log_error(env->log, "a made-up error of what was cut short");
	}
	return demo_driver_viewer.prepare(demo, env);
}

static void note_update(struct demo *demo, double time_s)
{
	assert_true(noted.updates < NOTED_MAX);
	if (noted.updates == noted.error_at) {
		log_error(noted.log, "a made-up error");
	}
	if (noted.updates == noted.signal_at) {
		raise(SIGTERM);
	}
	noted.updated_s[noted.updates++] = time_s;
	demo_driver_viewer.update(demo, time_s);
}

static void note_press(struct demo *demo, const struct button_event *event)
{
	(void)demo;
	assert_true(noted.presses < NOTED_MAX);
	noted.pressed[noted.presses++] = *event;
}

static double noted_period_s(const struct demo *demo)
{
	(void)demo;
	return noted.period_s;
}

/* A run that shows a model on nothing; each test changes what it is about. */
struct run {
	struct demo_driver demo;
	struct test_path model, folder;
	struct show_plan plan;
	struct options options;
	struct log_capture said;
};

static int begin(void **state)
{
	static struct run run;

	memset(&noted, 0, sizeof(noted));
	noted.error_at = noted.signal_at = -1;
	run = (struct run){
		.demo = demo_driver_viewer,
		.model = fixture_path("gltf/clip/cubic.gltf"),
		.folder = temp_dir_make(),
		.options = options_default(),
	};
	run.demo.prepare = note_prepare;
	run.demo.update = note_update;
	run.demo.press = note_press;
	run.demo.period_s = noted_period_s;
	run.plan = (struct show_plan){
		.demo = &run.demo,
		.model_path = run.model.text,
		.display = "null",
		.clock = clock_fixed(10.0, 0.0),
		.frames = 1,
	};
	run.options.screen.size.width = 40;
	run.options.screen.size.height = 30;
	run.options.screen.gl = "soft";
	*state = &run;
	return 0;
}

static int end(void **state)
{
	struct run *run = *state;

	temp_dir_remove(&run->folder);
	return 0;
}

static int shown(struct run *run)
{
	const struct log log = log_capture_begin(&run->said);

	return show_run(&run->plan, &run->options, &log);
}

/* The script's presses before the begin reach the demo, too. */
static void press_by_script(struct run *run)
{
	static const char script[] =
		"50 UP down\n150 UP up\n220 F6 down\n260 F6 up\n";
	static struct test_path path;

	path = path_join(&run->folder, "script.txt");
	file_write(path.text, script, sizeof(script) - 1);
	run->options.input.script = path.text;
	run->plan.begin_s = 0.2;
	run->plan.frames = 3;
}

/* Several test functions share begin() and end(). */
#define SHOW_TEST(name) cmocka_unit_test_setup_teardown(name, begin, end)

#endif
