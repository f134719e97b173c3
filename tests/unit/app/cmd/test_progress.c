#define _XOPEN_SOURCE 700 /* posix_openpt() */

#include "app/cmd/progress.h"
#include "platform/process/clock.h"
#include "tests/support/test.h"

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <termios.h>
#include <unistd.h>

/* A terminal, of which the test reads what is written to out. */
struct terminal {
	int reader;
	FILE *out;
	char text[256];
};

static struct terminal terminal_open(void)
{
	struct terminal terminal = {.reader = posix_openpt(O_RDWR | O_NOCTTY)};
	struct termios modes;
	int fd;

	assert_true(terminal.reader >= 0);
	assert_int_equal(grantpt(terminal.reader), 0);
	assert_int_equal(unlockpt(terminal.reader), 0);
	fd = open(ptsname(terminal.reader), O_RDWR | O_NOCTTY);
	assert_true(fd >= 0);
	assert_int_equal(tcgetattr(fd, &modes), 0);
	modes.c_oflag &= (tcflag_t)~OPOST;
	assert_int_equal(tcsetattr(fd, TCSANOW, &modes), 0);
	terminal.out = fdopen(fd, "w");
	assert_non_null(terminal.out);
	return terminal;
}

static void terminal_close(struct terminal *terminal)
{
	fclose(terminal->out);
	close(terminal->reader);
}

/* What was written since the last call. */
static const char *terminal_text(struct terminal *terminal)
{
	struct pollfd ready = {.fd = terminal->reader, .events = POLLIN};
	ssize_t length = 0;

	if (poll(&ready, 1, 50) == 1) {
		length = read(terminal->reader, terminal->text,
			sizeof(terminal->text) - 1);
	}
	terminal->text[length > 0 ? length : 0] = '\0';
	return terminal->text;
}

static int64_t now_ms = 70000;

/* The clock of the test, in place of the machine's. */
int64_t clock_monotonic_ms(void)
{
	return now_ms;
}

static void test_the_bar_appears_after_a_second(void **state)
{
	struct terminal terminal = terminal_open();
	struct progress progress = progress_begin(8, "frames", terminal.out);

	(void)state;
	progress_step(&progress, 1);
	assert_string_equal(terminal_text(&terminal), "");
	now_ms += 999;
	progress_step(&progress, 1);
	assert_string_equal(terminal_text(&terminal), "");
	now_ms++;
	progress_step(&progress, 2);
	assert_string_equal(terminal_text(&terminal),
		"\r[##########------------------------------] 2/8 frames");
	progress_end(&progress);
	terminal_close(&terminal);
}

static void test_the_bar_is_drawn_ten_times_a_second(void **state)
{
	struct terminal terminal = terminal_open();
	struct progress progress = progress_begin(2, "poses", terminal.out);

	(void)state;
	now_ms += 5000;
	progress_step(&progress, 1);
	assert_contains(terminal_text(&terminal), "] 1/2 poses");
	now_ms += 99;
	progress_step(&progress, 2);
	assert_string_equal(terminal_text(&terminal), "");
	now_ms++;
	progress_step(&progress, 2);
	assert_string_equal(terminal_text(&terminal),
		"\r[########################################] 2/2 poses");
	progress_end(&progress);
	terminal_close(&terminal);
}

static void test_the_end_erases_the_bar(void **state)
{
	struct terminal terminal = terminal_open();
	struct progress progress = progress_begin(3, "frames", terminal.out);
	const char *erased;

	(void)state;
	progress_end(&progress);
	assert_string_equal(terminal_text(&terminal), "");
	now_ms += 1000;
	progress_step(&progress, 3);
	assert_contains(terminal_text(&terminal), "3/3 frames");
	progress_end(&progress);
	erased = terminal_text(&terminal);
	assert_true(strlen(erased) > 60);
	assert_int_equal(strspn(erased, "\r "), strlen(erased));
	progress_end(&progress);
	assert_string_equal(terminal_text(&terminal), "");
	terminal_close(&terminal);
}

static void test_there_is_no_bar_without_a_terminal_or_for_one_step(void **state)
{
	struct terminal terminal = terminal_open();
	struct progress single = progress_begin(1, "frames", terminal.out);
	FILE *file = tmpfile();
	struct progress to_file;

	(void)state;
	assert_non_null(file);
	to_file = progress_begin(8, "frames", file);
	now_ms += 2000;
	progress_step(&single, 1);
	progress_step(&to_file, 4);
	progress_end(&single);
	progress_end(&to_file);
	assert_string_equal(terminal_text(&terminal), "");
	assert_int_equal(ftell(file), 0);
	fclose(file);
	terminal_close(&terminal);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_bar_appears_after_a_second),
		cmocka_unit_test(test_the_bar_is_drawn_ten_times_a_second),
		cmocka_unit_test(test_the_end_erases_the_bar),
		cmocka_unit_test(
			test_there_is_no_bar_without_a_terminal_or_for_one_step),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
