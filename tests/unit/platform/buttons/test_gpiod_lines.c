/* How many lines --buttons gpiod takes, and how long each may be. */
#include "platform/buttons/buttons.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

extern const struct button_driver button_driver_gpiod;

enum {
	LINES = 16,
	LINE_BYTES = 255,
	ITEM_BYTES = 511 /* beyond which nothing looks at a line */
};

static int check(const char *argument, struct log_capture *heard)
{
	struct log log = log_capture_begin(heard);

	return button_driver_gpiod.check(argument, &log);
}

/* "UP=c/0,UP=c/1..." */
static const char *lines(int count)
{
	static char text[1024];
	size_t used = 0;

	text[0] = '\0';
	for (int i = 0; i < count; i++) {
		used += (size_t)snprintf(text + used, sizeof(text) - used,
			"%sUP=c/%d", i ? "," : "", i);
	}
	return text;
}

static void test_there_are_1_to_16_lines(void **state)
{
	struct log_capture heard;

	(void)state;
	for (int count = 1; count <= LINES; count++) {
		assert_int_equal(check(lines(count), &heard), 0);
		assert_int_equal(heard.count, 0);
	}
	assert_int_equal(check(lines(LINES + 1), &heard), -EINVAL);
	assert_contains(heard.sentence[0], "at most 16 lines");
	assert_int_equal(check("", &heard), -EINVAL);
	assert_contains(heard.sentence[0], "the lines are missing");
	assert_int_equal(check(NULL, &heard), -EINVAL);
	assert_contains(heard.sentence[0], "the lines are missing");
}

/* A line of so many characters, of which most are blanks before its name. */
static const char *long_line(size_t length)
{
	static char text[ITEM_BYTES + 8];

	memset(text, ' ', sizeof(text));
	memcpy(text, "UP=c", 4);
	memcpy(text + length - 3, "a/b", 4);
	return text;
}

static void test_a_line_has_up_to_255_characters(void **state)
{
	char text[2 * ITEM_BYTES];
	struct log_capture heard;

	(void)state;
	assert_int_equal(check(long_line(LINE_BYTES), &heard), 0);
	snprintf(text, sizeof(text), "%s,UP=c/2", long_line(LINE_BYTES));
	assert_int_equal(check(text, &heard), 0);
	assert_int_equal(check(long_line(LINE_BYTES + 1), &heard), -EINVAL);
	assert_contains(heard.sentence[0], "at most 255 characters");
	assert_int_equal(check(long_line(ITEM_BYTES), &heard), -EINVAL);
	assert_contains(heard.sentence[0], "at most 255 characters");
	assert_int_equal(check(long_line(ITEM_BYTES + 1), &heard), -EINVAL);
	assert_contains(heard.sentence[0], "lines of at most 511 characters");
}

static void test_each_line_is_checked(void **state)
{
	struct log_capture heard;

	(void)state;
	assert_int_equal(check("UP=c/1,DOWN=5", &heard), -EINVAL);
	assert_contains(heard.sentence[0], "a number needs its chip");
	assert_int_equal(check("UP=c/1,,DOWN=c/2", &heard), -EINVAL);
	assert_int_equal(check("UP=c/1,DOWN=c/2,", &heard), 0);
	assert_int_equal(heard.count, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_there_are_1_to_16_lines),
		cmocka_unit_test(test_a_line_has_up_to_255_characters),
		cmocka_unit_test(test_each_line_is_checked),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
