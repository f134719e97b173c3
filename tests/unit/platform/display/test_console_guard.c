/* Consoles whatever way limber ends, also if it gives up its rights. */
#define _GNU_SOURCE /* MAP_ANONYMOUS */

#include "platform/display/console.h"
#include "tests/support/fake/fake_fb.h"
#include "tests/support/fake/fbdev_scene.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/kd.h>
#include <linux/vt.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* A console that several processes see. */
static struct shared {
	int mode, switching, answers, last_answer;
	pid_t dropped; /* the process that has given up its rights */
	pid_t guard;   /* the one that has used its own instead */
} * shared;

static int open_console(const char *path, int flags)
{
	(void)flags;
	return fake_fb_calls.open(path, flags);
}

/* As the kernel: whoever lacks rights may read the mode, but change nothing. */
static int control(int fd, unsigned long request, void *argument)
{
	bool changes = request == KDSETMODE || request == VT_SETMODE ||
		request == VT_RELDISP;
	int result;

	if (changes && getpid() == shared->dropped) {
		errno = EPERM;
		return -1;
	}
	if (changes && shared->dropped) {
		shared->guard = getpid();
	}
	result = fake_fb_calls.ioctl(fd, request, argument);
	if (request == VT_RELDISP) {
		shared->answers++;
		shared->last_answer = fake_fb.console_answer;
	}
	shared->switching = fake_fb.console_switching.mode;
	if (request == KDSETMODE) {
		shared->mode = fake_fb.console_mode;
	}
	return result;
}

static int close_console(int fd)
{
	return fake_fb_calls.close(fd);
}

static const struct device_calls calls = {
	.open = open_console, .close = close_console, .ioctl = control};

static int share(void **state)
{
	(void)state;
	shared = mmap(NULL, sizeof(*shared), PROT_READ | PROT_WRITE,
		MAP_SHARED | MAP_ANONYMOUS, -1, 0);
	assert_true(shared != MAP_FAILED);
	fbdev_scene_begin_565(1);
	fake_fb.has_console = true;
	return 0;
}

static int unshare_all(void **state)
{
	(void)state;
	return munmap(shared, sizeof(*shared));
}

static void begin(struct console *console, const struct log *log)
{
	console_acquire(console, &calls, log);
	assert_int_equal(shared->mode, KD_GRAPHICS);
	assert_int_equal(shared->switching, VT_PROCESS);
	shared->dropped = getpid();
}

static void expect_text(void)
{
	const struct timespec pause = {.tv_nsec = 1000000};

	for (int i = 0; i < 5000; i++) {
		if (shared->mode == KD_TEXT && shared->switching == VT_AUTO) {
			return;
		}
		nanosleep(&pause, NULL);
	}
	assert_int_equal(shared->mode, KD_TEXT);
	assert_int_equal(shared->switching, VT_AUTO);
}

static void test_a_console_without_rights_is_released(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct console console;

	(void)state;
	begin(&console, &log);
	console_release(&console);
	assert_int_equal(shared->mode, KD_TEXT);
	assert_int_equal(shared->switching, VT_AUTO);
	assert_int_equal(waitpid(-1, NULL, WNOHANG), -1);
	assert_int_equal(errno, ECHILD);
	assert_int_equal(capture.count, 0);
}

static void end_by(int number, bool drops_rights)
{
	const struct rlimit none = {0, 0};
	struct log log = log_to_nowhere();
	struct console console;

	setrlimit(RLIMIT_CORE, &none);
	if (number) {
		signal(number, SIG_DFL);
	}
	begin(&console, &log);
	if (!drops_rights) {
		shared->dropped = 0;
	}
	if (number) {
		kill(getpid(), number);
	}
	_exit(0);
}

/* Also where no handler can run, and where the whole group is killed. */
static void test_any_end_restores_a_console_without_rights(void **state)
{
	static const int signals[] = {0, SIGKILL, SIGSEGV, SIGTERM, SIGALRM};

	(void)state;
	for (size_t i = 0; i < sizeof(signals) / sizeof(signals[0]); i++) {
		int status;
		pid_t child = fork();

		assert_true(child >= 0);
		if (child == 0) {
			setpgid(0, 0);
			end_by(signals[i], true);
		}
		assert_int_equal(waitpid(child, &status, 0), child);
		assert_int_equal(
			WIFSIGNALED(status) ? WTERMSIG(status) : 0, signals[i]);
		expect_text();
		assert_int_not_equal(shared->guard, child);
		*shared = (struct shared){0};
	}
}

static void test_killing_restores_a_console_with_rights(void **state)
{
	int status;
	pid_t child = fork();

	(void)state;
	assert_true(child >= 0);
	if (child == 0) {
		end_by(SIGKILL, false);
	}
	assert_int_equal(waitpid(child, &status, 0), child);
	assert_true(WIFSIGNALED(status));
	expect_text();
}

static void test_killing_the_group_restores_the_console(void **state)
{
	int status;
	pid_t child = fork();

	(void)state;
	assert_true(child >= 0);
	if (child == 0) {
		struct log log = log_to_nowhere();
		struct console console;

		setpgid(0, 0);
		begin(&console, &log);
		kill(0, SIGKILL);
		_exit(0);
	}
	assert_int_equal(waitpid(child, &status, 0), child);
	expect_text();
}

static void do_nothing(struct display *display)
{
	(void)display;
}

static struct console *asked;

static void give(struct display *display)
{
	(void)display;
	assert_int_equal(console_leave(asked), 0);
}

static void take(struct display *display)
{
	(void)display;
	console_return(asked);
}

static void test_consoles_are_switched_without_rights(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct console console;

	(void)state;
	begin(&console, &log);
	asked = &console;
	raise(fake_fb.console_switching.relsig);
	assert_true(console_follow(&console, give, do_nothing, NULL));
	assert_int_equal(shared->answers, 1);
	assert_int_equal(shared->last_answer, 1);
	raise(fake_fb.console_switching.acqsig);
	assert_false(console_follow(&console, do_nothing, take, NULL));
	assert_int_equal(shared->answers, 2);
	assert_int_equal(shared->last_answer, VT_ACKACQ);
	console_refuse(&console);
	assert_int_equal(shared->last_answer, 0);
	console_release(&console);
	assert_int_equal(capture.count, 0);
}

/* A card or a watchdog would stay in use, and a pipe's reader would wait. */
static void test_the_guard_holds_no_other_descriptor(void **state)
{
	struct log log = log_to_nowhere();
	struct console console;
	struct pollfd reader;
	int ends[2];

	(void)state;
	assert_int_equal(pipe(ends), 0);
	begin(&console, &log);
	close(ends[1]);
	reader = (struct pollfd){.fd = ends[0], .events = POLLIN};
	assert_int_equal(poll(&reader, 1, 5000), 1);
	close(ends[0]);
	console_release(&console);
}

/* Nothing can restore the console then, but limber ends as usual. */
static void test_a_guard_that_was_killed_is_no_harm(void **state)
{
	struct log log = log_to_nowhere();
	struct console console;

	(void)state;
	begin(&console, &log);
	assert_int_equal(kill(console.guard.process, SIGKILL), 0);
	assert_int_equal(console_leave(&console), -EPERM);
	console_release(&console);
	assert_int_equal(fake_fb.open_count, 0);
}

static void test_without_a_console_there_is_no_guard(void **state)
{
	struct log log = log_to_nowhere();
	struct console console;

	(void)state;
	fake_fb.has_console = false;
	console_acquire(&console, &calls, &log);
	assert_int_equal(console.guard.process, 0);
	console_release(&console);
}

/* limber may be killed with all rights, and cannot restore anything then. */
static void test_a_display_has_a_guard_while_it_is_open(void **state)
{
	struct fbdev_scene scene = {0};

	(void)state;
	assert_int_equal(fbdev_scene_open(&scene), 0);
	assert_int_equal(waitpid(-1, NULL, WNOHANG), 0);
	fbdev_scene_close(&scene);
	assert_int_equal(waitpid(-1, NULL, WNOHANG), -1);
	assert_int_equal(errno, ECHILD);
}

static void test_too_few_descriptors_for_a_guard_are_a_warning(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct rlimit before, none;
	struct console console;

	(void)state;
	assert_int_equal(getrlimit(RLIMIT_NOFILE, &before), 0);
	none = (struct rlimit){0, before.rlim_max};
	assert_int_equal(setrlimit(RLIMIT_NOFILE, &none), 0);
	console_acquire(&console, &calls, &log);
	assert_int_equal(setrlimit(RLIMIT_NOFILE, &before), 0);
	assert_int_equal(capture.count, 1);
	assert_true(log_capture_has(&capture, LOG_WARNING, "may stay dark"));
	console_release(&console);
	assert_int_equal(shared->mode, KD_TEXT);
}

int main(void)
{
#define CASE(name) cmocka_unit_test_setup_teardown(name, share, unshare_all)
	const struct CMUnitTest tests[] = {
		CASE(test_a_console_without_rights_is_released),
		CASE(test_any_end_restores_a_console_without_rights),
		CASE(test_killing_restores_a_console_with_rights),
		CASE(test_killing_the_group_restores_the_console),
		CASE(test_consoles_are_switched_without_rights),
		CASE(test_the_guard_holds_no_other_descriptor),
		CASE(test_a_guard_that_was_killed_is_no_harm),
		CASE(test_without_a_console_there_is_no_guard),
		CASE(test_a_display_has_a_guard_while_it_is_open),
		CASE(test_too_few_descriptors_for_a_guard_are_a_warning),
	};
#undef CASE

	return cmocka_run_group_tests(tests, NULL, NULL);
}
