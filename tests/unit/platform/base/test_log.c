#include "platform/base/log.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

static void test_messages_are_formatted_with_their_level(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);

	(void)state;
	log_error(&log, "%s: %d bytes are missing", "a.glb", 12);
	log_warning(&log, "camera: none");
	log_note(&log, "100%%");
	assert_int_equal(capture.count, 3);
	assert_string_equal(capture.sentence[0], "a.glb: 12 bytes are missing");
	assert_int_equal(capture.level[0], LOG_ERROR);
	assert_string_equal(capture.sentence[1], "camera: none");
	assert_int_equal(capture.level[1], LOG_WARNING);
	assert_string_equal(capture.sentence[2], "100%");
	assert_int_equal(capture.level[2], LOG_NOTE);
}

static void test_levels_above_the_threshold_are_dropped(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);

	(void)state;
	log.threshold = LOG_WARNING;
	log_note(&log, "dropped");
	log_warning(&log, "kept");
	log.threshold = LOG_ERROR;
	log_warning(&log, "dropped");
	log_error(&log, "kept too");
	assert_int_equal(capture.count, 2);
	assert_string_equal(capture.sentence[0], "kept");
	assert_string_equal(capture.sentence[1], "kept too");
}

static void keep_length(void *user, enum log_level level, const char *sentence)
{
	size_t *length = user;

	(void)level;
	*length = strlen(sentence);
}

/* A path of 4,096 bytes and a reason fit. */
static void test_long_messages_are_cut(void **state)
{
	size_t length = 0;
	const struct log log = {keep_length, &length, LOG_NOTE};
	char text[9000];

	(void)state;
	memset(text, 'x', sizeof(text) - 1);
	text[sizeof(text) - 1] = '\0';
	log_error(&log, "%.4200s", text);
	assert_int_equal(length, 4200);
	log_error(&log, "%s", text);
	assert_int_equal(length, 5119);
}

/* Runs write_stderr() with standard error redirected to a file. */
static void say_into(FILE *file, const struct log *log)
{
	int saved;

	fflush(stderr);
	saved = dup(STDERR_FILENO);
	assert_true(saved >= 0);
	assert_true(dup2(fileno(file), STDERR_FILENO) >= 0);
	log_error(log, "%s: %s", "m.glb", "no such file");
	log_note(log, "a note");
	fflush(stderr);
	assert_true(dup2(saved, STDERR_FILENO) >= 0);
	close(saved);
}

static void test_standard_error_gets_whole_lines(void **state)
{
	struct log log = log_to_stderr(LOG_WARNING);
	FILE *file = tmpfile();
	char line[200] = "";

	(void)state;
	assert_non_null(file);
	say_into(file, &log);
	rewind(file);
	assert_non_null(fgets(line, sizeof(line), file));
	assert_string_equal(line, "limber: m.glb: no such file\n");
	assert_null(fgets(line, sizeof(line), file));
	fclose(file);
}

static void test_a_log_to_nowhere_takes_everything(void **state)
{
	struct log log = log_to_nowhere();

	(void)state;
	log_error(&log, "%d", 1);
	log_note(&log, "%d", 2);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_messages_are_formatted_with_their_level),
		cmocka_unit_test(test_levels_above_the_threshold_are_dropped),
		cmocka_unit_test(test_long_messages_are_cut),
		cmocka_unit_test(test_standard_error_gets_whole_lines),
		cmocka_unit_test(test_a_log_to_nowhere_takes_everything),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
