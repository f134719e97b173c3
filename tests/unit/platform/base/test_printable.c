#include "platform/base/printable.h"

#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <string.h>

static const struct {
	const char *text, *printable;
} samples[] = {
	{"", ""}, {"Arm_01 left", "Arm_01 left"},
	{"gr\xc3\xbc\xc3\x9f \xe2\x82\xac \xf0\x9f\xa6\xb4",
		"gr\xc3\xbc\xc3\x9f \xe2\x82\xac \xf0\x9f\xa6\xb4"},
	{"a\x1b[31mb\r\n\tc\x7f", "a?[31mb???c?"},
	{"\xc2\x9b"
	 "31m",
		"??31m"}, /* C1 */
	{"a\xe2\x80\xae"
	 "b",
		"a???b"}, /* right-to-left override */
	{"a\xe2\x81\xa6"
	 "b",
		"a???b"},                    /* isolate */
	{"\xc0\xaf \xed\xa0\x80", "?? ???"}, /* overlong, surrogate */
	{"\xff\xc3", "??"},                  /* cut off */
	{"\xf4\x90\x80\x80", "????"},        /* beyond U+10FFFF */
};

static void print(void (*put)(const char *, FILE *), const char *text,
	char *out, size_t size)
{
	FILE *file = tmpfile();
	size_t length;

	assert_non_null(file);
	put(text, file);
	rewind(file);
	length = fread(out, 1, size - 1, file);
	out[length] = '\0';
	fclose(file);
}

static void test_replaces_what_a_terminal_executes(void **state)
{
	(void)state;
	for (size_t i = 0; i < sizeof(samples) / sizeof(samples[0]); i++) {
		char text[64], printed[64];

		strcpy(text, samples[i].text);
		printable_make(text);
		assert_string_equal(text, samples[i].printable);
		print(printable_put, samples[i].text, printed, sizeof(printed));
		assert_string_equal(printed, samples[i].printable);
	}
}

static void test_a_comment_cannot_be_ended(void **state)
{
	char printed[64];

	(void)state;
	print(printable_put_comment, "*/ x; /*/ **//", printed, sizeof(printed));
	assert_string_equal(printed, "*? x; /?/ **?/");
	assert_null(strstr(printed, "*/"));
	print(printable_put, "*/", printed, sizeof(printed));
	assert_string_equal(printed, "*/");
}

static void test_log_messages_are_printable(void **state)
{
	struct log_capture heard;
	struct log log = log_capture_begin(&heard);

	(void)state;
	log_error(&log, "%s: bad", "a\x1b[2J\nb");
	assert_string_equal(heard.sentence[0], "a?[2J?b: bad");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_replaces_what_a_terminal_executes),
		cmocka_unit_test(test_a_comment_cannot_be_ended),
		cmocka_unit_test(test_log_messages_are_printable),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
