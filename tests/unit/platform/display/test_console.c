#include "platform/base/compiler.h"
#include "platform/display/console.h"
#include "platform/process/stop.h"
#include "tests/support/fake/fbdev_scene.h"
#include "tests/support/test.h"

#include <errno.h>
#include <linux/kd.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

static void test_the_console_is_in_graphics_mode_meanwhile(void **state)
{
	struct fbdev_scene scene = {0};

	(void)state;
	fbdev_scene_begin_565(1);
	fake_fb.has_console = true;
	assert_int_equal(fbdev_scene_open(&scene), 0);
	assert_int_equal(fake_fb.console_mode, KD_GRAPHICS);
	fbdev_scene_draw(&scene);
	fbdev_scene_close(&scene);

	/* As a killed program leaves it. */
	fake_fb.console_mode = KD_GRAPHICS;
	assert_false(console_is_in_use(&fake_fb_calls));
	assert_int_equal(fbdev_scene_open(&scene), 0);
	fbdev_scene_close(&scene);
	assert_int_equal(log_capture_count(&scene.capture, LOG_WARNING), 0);
}

static void test_another_programs_console_is_not_changed(void **state)
{
	struct fbdev_scene scene = {0};

	(void)state;
	fbdev_scene_begin_565(1);
	assert_false(console_is_in_use(&fake_fb_calls));
	fake_fb.has_console = true;
	fake_fb.console_watched = true;
	assert_false(console_is_in_use(&fake_fb_calls));
	fake_fb.console_mode = KD_GRAPHICS;
	assert_true(console_is_in_use(&fake_fb_calls));
	assert_int_equal(fbdev_scene_open(&scene), 0);
	assert_true(log_capture_has(&scene.capture, LOG_WARNING, "another"));
	fbdev_scene_draw(&scene);
	scene.driver->destroy(scene.display);
	assert_int_equal(fake_fb.console_mode, KD_GRAPHICS);
	assert_int_equal(fake_fb.open_count, 0);
}

static void test_a_console_is_released_once(void **state)
{
	static const struct pixel_layout any = {
		.bits = 16, .red = {11, 5}, .green = {5, 6}, .blue = {0, 5}};
	struct log log = log_to_nowhere();
	struct console console;

	(void)state;
	fake_fb_begin(8, 8, 8, 8, 16, any);
	for (int has = 0; has <= 1; has++) {
		fake_fb.has_console = has;
		console_acquire(&console, &fake_fb_calls, &log);
		assert_int_equal(fake_fb.open_count, has);
		for (int i = 0; i < 3; i++) {
			console_release(&console);
			assert_int_equal(fake_fb.open_count, 0);
			assert_int_equal(fake_fb.console_mode,
				i == 0 ? KD_TEXT : KD_GRAPHICS);
			/* Another program takes it meanwhile. */
			fake_fb.console_mode = KD_GRAPHICS;
		}
		fake_fb.console_mode = KD_TEXT;
		/* The keys that were pressed are not for the shell. */
		assert_int_equal(fake_fb.console_flushes, has);
	}
}

static int refusal; /* errno of opening a console */

static int refuse(const char *path, int flags)
{
	(void)path;
	(void)flags;
	errno = refusal;
	return -1;
}

/* A board without a console needs no note. */
static void test_a_console_without_permission_is_noted(void **state)
{
	static const struct {
		int error, notes;
	} cases[] = {{EACCES, 2}, {EPERM, 2}, {ENOENT, 0}};
	const struct device_calls calls = {.open = refuse};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct log_capture capture;
		struct log log = log_capture_begin(&capture);
		struct console console;

		refusal = cases[i].error;
		console_acquire(&console, &calls, &log);
		assert_int_equal(capture.count, cases[i].notes);
		if (cases[i].notes) {
			assert_contains(capture.sentence[0],
				"/dev/tty0: no permission");
			assert_contains(
				capture.sentence[1], "/dev/tty: no permission");
		}
		console_release(&console);
	}
}

/* Ends this process by a signal while the console is acquired. */
static void end_by(int number, int report_fd)
{
	const struct rlimit none = {0, 0};
	struct fbdev_scene scene = {0};

	setrlimit(RLIMIT_CORE, &none);
	signal(number, SIG_DFL);
	fbdev_scene_begin_565(1);
	fake_fb.has_console = true;
	fake_fb.report_fd = report_fd;
	if (fbdev_scene_open(&scene) == 0) {
		raise(number);
	}
	_exit(99);
}

/* Starts a child that calls a function with a signal and a pipe, and exits. */
static pid_t begin_child(
	void (*call)(int number, int report_fd), int number, int *report_fd)
{
	int ends[2];
	pid_t child;

	assert_int_equal(pipe(ends), 0);
	child = fork();
	assert_true(child >= 0);
	if (child == 0) {
		call(number, ends[1]);
		_exit(0);
	}
	close(ends[1]);
	*report_fd = ends[0];
	return child;
}

static void test_a_fatal_signal_restores_text_mode(void **state)
{
	const int signals[] = {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGSYS,
		SIGTRAP, SIGQUIT, SIGTERM, SIGINT, SIGHUP, SIGPIPE, SIGALRM,
		SIGUSR1, SIGUSR2, SIGXCPU, SIGXFSZ, SIGVTALRM, SIGPROF, SIGPOLL,
		SIGRTMIN, SIGRTMIN + 9};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(signals); i++) {
		char modes[4] = {0};
		int status, report_fd;
		pid_t child = begin_child(end_by, signals[i], &report_fd);

		assert_int_equal(waitpid(child, &status, 0), child);
		assert_true(WIFSIGNALED(status));
		assert_int_equal(WTERMSIG(status), signals[i]);
		assert_int_equal(read(report_fd, modes, sizeof(modes)), 2);
		assert_int_equal(modes[0], KD_GRAPHICS);
		assert_int_equal(modes[1], KD_TEXT);
		close(report_fd);
	}
}

/* As the kernel does if a program in the background changes its terminal. */
static int stop_background(int fd, unsigned long request, void *argument)
{
	if (request == TCFLSH) {
		raise(SIGTTOU);
	}
	return fake_fb_calls.ioctl(fd, request, argument);
}

/* What Ctrl-Z would do to this process while it has the console, and after. */
static void stop_by(int number, int report_fd)
{
	struct device_calls calls = fake_fb_calls;
	struct log log = log_to_nowhere();
	struct console console;

	signal(number, SIG_DFL);
	signal(SIGTTOU, SIG_DFL);
	fbdev_scene_begin_565(1);
	fake_fb.has_console = true;
	fake_fb.report_fd = report_fd;
	calls.ioctl = stop_background;
	console_acquire(&console, &calls, &log);
	raise(number);
	console_release(&console);
	/* That does nothing in an orphaned process. */
	raise(number);
}

static void test_a_terminal_stops_only_a_program_without_the_console(
	void **state)
{
	static const int signals[] = {SIGTSTP, SIGTTIN, SIGTTOU};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(signals); i++) {
		char modes[4] = {0};
		int status, report_fd;
		pid_t child = begin_child(stop_by, signals[i], &report_fd);

		assert_int_equal(waitpid(child, &status, WUNTRACED), child);
		/* It is in order when it stops. */
		assert_int_equal(read(report_fd, modes, sizeof(modes)), 2);
		assert_int_equal(modes[1], KD_TEXT);
		if (WIFSTOPPED(status)) {
			kill(child, SIGKILL);
			assert_int_equal(waitpid(child, &status, 0), child);
		}
		close(report_fd);
	}
}

static void test_a_stop_signal_is_left_to_the_frame_loop(void **state)
{
	struct fbdev_scene scene = {0};

	(void)state;
	signal(SIGTERM, SIG_DFL);
	stop_catch();
	fbdev_scene_begin_565(1);
	fake_fb.has_console = true;
	assert_int_equal(fbdev_scene_open(&scene), 0);
	assert_false(stop_requested());
	raise(SIGTERM);
	assert_true(stop_requested());
	assert_int_equal(fake_fb.console_mode, KD_GRAPHICS);
	fbdev_scene_close(&scene);
	stop_release();
}

static void ignore(int number)
{
	(void)number;
}

static void (*handler_of(int number))(int)
{
	struct sigaction action;

	assert_int_equal(sigaction(number, NULL, &action), 0);
	return action.sa_handler;
}

/* Faults are caught unless they are ignored, other signals if nobody does. */
static void test_each_signal_is_handled_as_before_afterwards(void **state)
{
	static const int signals[] = {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT,
		SIGSYS, SIGQUIT, SIGPIPE, SIGALRM, SIGINT, SIGTERM, SIGHUP,
		SIGXCPU, SIGXFSZ, SIGUSR1, SIGTSTP, SIGTTIN, SIGTTOU};
	void (*const kept[])(int) = {SIG_DFL, SIG_IGN, ignore};
	void (*former[ARRAY_COUNT(signals)])(int);
	const int faults = 6;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(signals); i++) {
		former[i] = handler_of(signals[i]);
	}
	for (int turn = 0; turn < 6; turn++) {
		struct fbdev_scene scene = {0};
		bool has_mode = turn < 3;

		for (size_t i = 0; i < ARRAY_COUNT(signals); i++) {
			signal(signals[i], kept[(i + (size_t)turn) % 3]);
		}
		fbdev_scene_begin_565(1);
		fake_fb.has_console = true;
		fake_fb.fail_request = has_mode ? 0 : KDSETMODE;
		fake_fb.fail_error = EINVAL;
		assert_int_equal(fbdev_scene_open(&scene), 0);
		for (int i = 0; i < (int)ARRAY_COUNT(signals); i++) {
			void (*before)(int) = kept[(i + turn) % 3];
			bool caught = has_mode &&
				(before == SIG_DFL ||
					(before == ignore && i < faults));

			assert_int_equal(
				handler_of(signals[i]) != before, caught);
		}
		fake_fb.fail_request = 0;
		scene.driver->destroy(scene.display);
		for (size_t i = 0; i < ARRAY_COUNT(signals); i++) {
			assert_true(handler_of(signals[i]) ==
				kept[(i + (size_t)turn) % 3]);
		}
	}
	for (size_t i = 0; i < ARRAY_COUNT(signals); i++) {
		signal(signals[i], former[i]);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_console_is_in_graphics_mode_meanwhile),
		cmocka_unit_test(test_another_programs_console_is_not_changed),
		cmocka_unit_test(test_a_console_is_released_once),
		cmocka_unit_test(test_a_console_without_permission_is_noted),
		cmocka_unit_test(test_a_fatal_signal_restores_text_mode),
		cmocka_unit_test(
			test_each_signal_is_handled_as_before_afterwards),
		cmocka_unit_test(
			test_a_terminal_stops_only_a_program_without_the_console),
		cmocka_unit_test(test_a_stop_signal_is_left_to_the_frame_loop),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
