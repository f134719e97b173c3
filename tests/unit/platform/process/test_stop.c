/* Ending in order. Tests that a signal may end are processes of their own. */
#include "platform/base/interrupt.h"
#include "platform/process/stop.h"
#include "tests/support/test.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

static const int caught[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU};

enum {
	CAUGHT = sizeof(caught) / sizeof(caught[0])
};

/* How a child that runs the function ended. */
static int in_child(void (*run)(void))
{
	pid_t child = fork();
	int status = 0;

	if (child == 0) {
		run();
		_exit(0);
	}
	assert_int_equal(waitpid(child, &status, 0), child);
	return status;
}

/* What was written to a pipe so far. */
static int bytes_in(int end, char *text, size_t size)
{
	assert_int_equal(fcntl(end, F_SETFL, O_NONBLOCK), 0);
	return (int)read(end, text, size);
}

static void test_without_a_watchdog_nothing_is_written(void **state)
{
	int kept = dup(0), ends[2];
	char text[4];

	(void)state;
	assert_int_equal(pipe(ends), 0);
	assert_int_equal(dup2(ends[1], 0), 0);
	stop_catch();
	raise(SIGTERM);
	stop_release();
	assert_int_equal(dup2(kept, 0), 0);
	assert_int_equal(bytes_in(ends[0], text, sizeof(text)), -1);
	close(kept);
	close(ends[0]);
	close(ends[1]);
}

static void test_each_signal_asks_for_the_end(void **state)
{
	(void)state;
	for (int i = 0; i < CAUGHT; i++) {
		/* nohup and a shell's "&" start programs that ignore some. */
		signal(caught[i], SIG_DFL);
		stop_catch();
		assert_false(stop_requested());
		assert_false(interrupt_pending());
		raise(caught[i]);
		assert_true(stop_requested());
		assert_true(stop_requested());
		stop_catch();
		assert_false(stop_requested());
		stop_release();
	}
}

static void test_only_lost_output_and_a_limit_are_failures(void **state)
{
	static const char *const words[CAUGHT] = {
		NULL, NULL, NULL, "SIGPIPE", "SIGXCPU"};

	(void)state;
	for (int i = 0; i < CAUGHT * CAUGHT; i++) {
		int first = i / CAUGHT, second = i % CAUGHT;

		signal(caught[first], SIG_DFL);
		signal(caught[second], SIG_DFL);
		stop_catch();
		assert_null(stop_failure());
		/* Whoever asked for the end before gets it. */
		raise(caught[first]);
		raise(caught[second]);
		assert_true(stop_requested());
		if (words[first]) {
			assert_contains(stop_failure(), words[first]);
		} else {
			assert_null(stop_failure());
		}
		stop_release();
	}
}

static void note(int number)
{
	(void)number;
}

static void test_the_handlers_of_before_return(void **state)
{
	struct sigaction now;

	(void)state;
	for (int i = 0; i < CAUGHT; i++) {
		signal(caught[i], note);
	}
	stop_catch();
	for (int i = 0; i < CAUGHT; i++) {
		assert_int_equal(sigaction(caught[i], NULL, &now), 0);
		assert_true(now.sa_handler != note);
	}
	stop_release();
	for (int i = 0; i < CAUGHT; i++) {
		assert_int_equal(sigaction(caught[i], NULL, &now), 0);
		assert_true(now.sa_handler == note);
		signal(caught[i], SIG_DFL);
	}
}

static void test_what_was_asked_for_before_is_forgotten(void **state)
{
	(void)state;
	stop_catch();
	raise(SIGTERM);
	assert_true(interrupt_pending());
	stop_release();
	assert_false(interrupt_pending());
	assert_int_equal(interrupt_signal(), 0);
}

static void test_what_is_ignored_stays_ignored(void **state)
{
	struct sigaction after;

	(void)state;
	signal(SIGHUP, SIG_IGN);
	stop_catch();
	raise(SIGHUP);
	assert_false(stop_requested());
	stop_release();
	assert_int_equal(sigaction(SIGHUP, NULL, &after), 0);
	assert_true(after.sa_handler == SIG_IGN);
	signal(SIGHUP, SIG_DFL);
}

/*
 * The seconds that are left after a signal. On a busy machine they may have
 * passed already; then it is tried again.
 */
static unsigned seconds_after_a_signal(void)
{
	unsigned left = 0;

	for (int i = 0; i < 20 && left == 0; i++) {
		stop_catch();
		raise(SIGTERM);
		left = alarm(30);
	}
	return left;
}

static void test_the_end_must_come_within_a_second_of_the_signal(void **state)
{
	(void)state;
	assert_int_equal(seconds_after_a_signal(), 1);
	/* A second signal gives no more time. */
	raise(SIGTERM);
	assert_in_range(alarm(30), 20, 30);
	/* What gives up must still do so in time. */
	assert_true(interrupt_pending());
	assert_in_range(alarm(30), 20, 30);
	assert_true(stop_requested());
	assert_int_equal(alarm(30), 0);
	stop_release();
	assert_int_equal(alarm(0), 0);
}

static void hang_after_a_signal(void)
{
	signal(SIGALRM, SIG_DFL);
	stop_catch();
	raise(SIGTERM);
	sleep(20);
}

static void hang_where_signals_were_blocked(void)
{
	sigset_t all;

	signal(SIGALRM, SIG_IGN);
	sigfillset(&all);
	sigprocmask(SIG_BLOCK, &all, NULL);
	stop_unblock();
	stop_catch();
	for (int i = 0; i < CAUGHT; i++) {
		raise(caught[i]);
		if (!stop_requested()) {
			_exit(1);
		}
	}
	alarm(1);
	sleep(20);
}

static void test_what_was_blocked_and_ignored_at_the_start_ends_it(void **state)
{
	int status = in_child(hang_where_signals_were_blocked);

	(void)state;
	assert_true(WIFSIGNALED(status));
	assert_int_equal(WTERMSIG(status), SIGALRM);
}

/* Leaves bits in the memory of the next call's variables. */
static __attribute__((noinline)) void fill_the_stack(void)
{
	volatile unsigned char bytes[4096];

	for (size_t i = 0; i < sizeof(bytes); i++) {
		bytes[i] = 0xFF;
	}
}

static bool ends_limber(int number)
{
	bool found = number == SIGALRM;

	for (int i = 0; i < CAUGHT; i++) {
		found = found || number == caught[i];
	}
	return found;
}

static void unblock_among_all(void)
{
	sigset_t blocked, after;

	sigfillset(&blocked);
	sigprocmask(SIG_BLOCK, &blocked, NULL);
	sigprocmask(SIG_BLOCK, NULL, &blocked);
	fill_the_stack();
	stop_unblock();
	sigprocmask(SIG_BLOCK, NULL, &after);
	for (int number = 1; number <= SIGRTMAX; number++) {
		bool stays = sigismember(&blocked, number) == 1 &&
			!ends_limber(number);

		if ((sigismember(&after, number) == 1) != stays) {
			_exit(number);
		}
	}
}

static void test_signals_that_do_not_end_it_stay_blocked(void **state)
{
	(void)state;
	assert_int_equal(in_child(unblock_among_all), 0);
}

static void test_a_process_that_hangs_ends_by_an_alarm(void **state)
{
	int status = in_child(hang_after_a_signal);

	(void)state;
	assert_true(WIFSIGNALED(status));
	assert_int_equal(WTERMSIG(status), SIGALRM);
}

static void test_a_signal_disables_the_watchdog_at_once(void **state)
{
	char text[4];
	int ends[2];

	(void)state;
	assert_int_equal(pipe(ends), 0);
	stop_catch();
	stop_set_watchdog(ends[1]);
	raise(SIGTERM);
	assert_int_equal(bytes_in(ends[0], text, sizeof(text)), 1);
	assert_int_equal(text[0], 'V');
	stop_set_watchdog(-1);
	raise(SIGTERM);
	assert_int_equal(bytes_in(ends[0], text, sizeof(text)), -1);
	stop_set_watchdog(ends[1]);
	stop_release();
	stop_catch();
	raise(SIGTERM);
	stop_release();
	assert_int_equal(bytes_in(ends[0], text, sizeof(text)), -1);
	close(ends[0]);
	close(ends[1]);
}

static void test_a_watchdog_may_be_descriptor_0(void **state)
{
	int kept = dup(0), ends[2];
	char text[4];

	(void)state;
	assert_int_equal(pipe(ends), 0);
	assert_int_equal(dup2(ends[1], 0), 0);
	stop_catch();
	stop_set_watchdog(0);
	raise(SIGTERM);
	stop_release();
	stop_catch();
	raise(SIGTERM);
	stop_release();
	assert_int_equal(dup2(kept, 0), 0);
	assert_int_equal(bytes_in(ends[0], text, sizeof(text)), 1);
	close(kept);
	close(ends[0]);
	close(ends[1]);
}

static void test_a_watchdog_that_fails_is_left_and_errno_kept(void **state)
{
	int kept = dup(0), ends[2], other[2];
	char text[4];

	(void)state;
	assert_int_equal(pipe(ends), 0);
	assert_int_equal(pipe(other), 0);
	assert_int_equal(dup2(other[1], 0), 0);
	stop_catch();
	/* The end for reading cannot be written. */
	stop_set_watchdog(ends[0]);
	errno = ERANGE;
	raise(SIGTERM);
	assert_int_equal(errno, ERANGE);
	assert_true(stop_requested());
	/* The descriptor is not tried again: by now it may be another file. */
	assert_int_equal(dup2(other[1], ends[0]), ends[0]);
	raise(SIGTERM);
	stop_release();
	assert_int_equal(dup2(kept, 0), 0);
	assert_int_equal(bytes_in(other[0], text, sizeof(text)), -1);
	close(kept);
	close(other[0]);
	close(other[1]);
	close(ends[0]);
	close(ends[1]);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_without_a_watchdog_nothing_is_written),
		cmocka_unit_test(test_each_signal_asks_for_the_end),
		cmocka_unit_test(test_only_lost_output_and_a_limit_are_failures),
		cmocka_unit_test(test_the_handlers_of_before_return),
		cmocka_unit_test(test_what_was_asked_for_before_is_forgotten),
		cmocka_unit_test(test_what_is_ignored_stays_ignored),
		cmocka_unit_test(
			test_the_end_must_come_within_a_second_of_the_signal),
		cmocka_unit_test(test_a_process_that_hangs_ends_by_an_alarm),
		cmocka_unit_test(
			test_what_was_blocked_and_ignored_at_the_start_ends_it),
		cmocka_unit_test(test_signals_that_do_not_end_it_stay_blocked),
		cmocka_unit_test(test_a_signal_disables_the_watchdog_at_once),
		cmocka_unit_test(test_a_watchdog_may_be_descriptor_0),
		cmocka_unit_test(
			test_a_watchdog_that_fails_is_left_and_errno_kept),
	};

	/* A second passes soon on a busy machine. */
	signal(SIGALRM, SIG_IGN);
	return cmocka_run_group_tests(tests, NULL, NULL);
}
