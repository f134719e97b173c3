/* How words and numbers of text files end, also where the file does. */
#include "app/model/xfile/xfile_reader.h"
#include "tests/support/test.h"

#include <string.h>

/* Scans the first token of a text that ends, in memory, before `behind`. */
static struct xfile_token scan(const char *text, const char *behind)
{
	static char memory[128];
	struct xfile_reader reader = {.line = 1};
	struct xfile_token token;

	assert_true(strlen(text) + strlen(behind) < sizeof(memory));
	memcpy(memory, text, strlen(text));
	strcpy(memory + strlen(text), behind);
	reader.at = (const uint8_t *)memory;
	reader.end = reader.at + strlen(text);
	assert_int_equal(xfile_scan_text(&reader, &token), 0);
	return token;
}

static void test_numbers_end_where_the_file_ends(void **state)
{
	static const struct {
		const char *text;
		double number;
	} cases[] = {
		{"12", 12},
		{"-12", -12},
		{"+3.", 3},
		{"3.25", 3.25},
		{".5", 0.5},
		{"1e2", 100},
		{"1E+2", 100},
		{"1e-2", 0.01},
		{"123456789012345678901", 123456789012345678901.0},
		{"0.000000000000000000001", 1e-21},
		{"123456789012345678e-318", 1.23456789012345678e-301},
		{"123456789012345678e-310", 1.23456789012345678e-293},
		{"1e-299", 1e-299},
		{"1e-301", 1e-301},
		{"1e300", 1e300},
		{"7e-1000", 0},
		{"0e1000", 0},
		{"1.#IND", 0},
		{"-1.#INF", 0},
	};
	static const char *const behind[] = {
		"", "0", "5", ".", ".5", "e1", "#", "-", "+1", "/"};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(*cases); i++) {
		for (size_t k = 0; k < sizeof(behind) / sizeof(*behind); k++) {
			struct xfile_token token =
				scan(cases[i].text, behind[k]);
			double number = cases[i].number;

			assert_int_equal(token.kind, XFILE_NUMBER);
			assert_int_equal(token.length, strlen(cases[i].text));
			/* Few units in the last place, of any magnitude. */
			assert_near(number == 0.0 ? token.number + 1
						  : token.number / number,
				1, 1e-13);
		}
	}
}

static void test_what_is_no_number_is_a_word(void **state)
{
	static const char *const words[] = {"e5", ".", "-", "+", "-.", "1e",
		"1e+", "1e-", "1x", "1.5x", "1e5x", "--1", ".#IND", "1..2",
		"1e1e1"};

	(void)state;
	for (size_t i = 0; i < sizeof(words) / sizeof(*words); i++) {
		assert_int_equal(scan(words[i], "").kind, XFILE_WORD);
		assert_int_equal(scan(words[i], "1").kind, XFILE_WORD);
	}
}

/* Two slashes begin a comment; one is a character like others. */
static void test_only_two_slashes_begin_a_comment(void **state)
{
	static const struct {
		const char *text, *behind, *word;
	} cases[] = {
		{"a/b//c", "", "a/b"},
		{"a/", "/", "a/"},
		{"a//", "", "a"},
		{"/", "/", "/"},
		{"/b", "", "/b"},
		{"//c\n/b", "", "/b"},
		{"/ /", "", "/"},
		{"# /c\nd", "", "d"},
		{"//", "a", ""},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(*cases); i++) {
		struct xfile_token token = scan(cases[i].text, cases[i].behind);

		assert_int_equal(
			token.kind, cases[i].word[0] ? XFILE_WORD : XFILE_END);
		assert_int_equal(token.length, strlen(cases[i].word));
		assert_memory_equal(token.length ? token.text : "",
			cases[i].word, token.length);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_numbers_end_where_the_file_ends),
		cmocka_unit_test(test_what_is_no_number_is_a_word),
		cmocka_unit_test(test_only_two_slashes_begin_a_comment),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
