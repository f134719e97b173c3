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

/* The bytes of the character with which the text begins; 0: not to be printed. */
static int decoded_length(const unsigned char *text)
{
	static const uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
	int length = text[0] < 0x80  ? 1
		: text[0] >> 5 == 6  ? 2
		: text[0] >> 4 == 14 ? 3
		: text[0] >> 3 == 30 ? 4
				     : 0;
	uint32_t code = length > 1 ? text[0] & (0x7Fu >> length) : text[0];

	for (int i = 1; i < length; i++) {
		if (text[i] >> 6 != 2) {
			return 0;
		}
		code = code << 6 | (text[i] & 0x3F);
	}
	if (length == 0 || code < least[length] || code > 0x10FFFF ||
		(code >= 0xD800 && code <= 0xDFFF)) {
		return 0;
	}
	/* Controls, separators of lines, and what turns the direction. */
	return code < 0x20 || (code >= 0x7F && code < 0xA0) ||
			(code >= 0x2028 && code <= 0x202E) ||
			(code >= 0x2066 && code <= 0x2069)
		? 0
		: length;
}

static void test_each_character_is_kept_or_replaced(void **state)
{
	static const unsigned char last[] = {0x41, 0x7F, 0x80, 0xA5, 0xA6, 0xA7,
		0xA8, 0xA9, 0xAA, 0xAE, 0xAF, 0xBF, 0xC0};

	(void)state;
	for (size_t i = 0; i < 255 * 255 * sizeof(last) * 3; i++) {
		unsigned char text[5] = {(unsigned char)(1 + i % 255),
			(unsigned char)(1 + i / 255 % 255),
			last[i / (255 * 255) % sizeof(last)],
			last[5 * (i / (255 * 255 * sizeof(last)))]};
		unsigned char made[5];
		int length = decoded_length(text);

		memcpy(made, text, sizeof(made));
		printable_make((char *)made);
		if (length == 0 ? made[0] != '?'
				: memcmp(made, text, (size_t)length) != 0) {
			fail_msg("%02x %02x %02x %02x: %d bytes", text[0],
				text[1], text[2], text[3], length);
		}
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
		cmocka_unit_test(test_each_character_is_kept_or_replaced),
		cmocka_unit_test(test_a_comment_cannot_be_ended),
		cmocka_unit_test(test_log_messages_are_printable),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
