/* Lines of INI files as libinih gets them. */
#include "app/character/text/ini_lines.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	SIZE = 16
};

/* A buffer between bytes that have to stay. */
struct buffer {
	char before[8], line[SIZE], behind[32];
};

static const struct buffer fresh = {"1234567",
	{'x', 'x', 'x', 'x', 'x', 'x', 'x', 'x', 'x', 'x', 'x', 'x', 'x', 'x',
		'x', 'x'},
	"abcdefghijklmnopqrstuvwxyz"};

/* A file of at most three lines, whose keys end with = or :. */
static struct ini_lines lines_of(const char *text, size_t size)
{
	struct ini_lines lines = {.file = fmemopen((void *)text, size, "r"),
		.separators = "=:",
		.most = 3};

	assert_non_null(lines.file);
	return lines;
}

/* Asks for the next line; NULL: it is the end, or refused for this reason. */
static void expect_line(
	struct ini_lines *lines, const char *wanted, const char *refusal)
{
	struct buffer buffer = fresh;
	char *found = ini_lines_next(lines, buffer.line, SIZE);

	assert_memory_equal(buffer.before, fresh.before, sizeof(fresh.before));
	assert_memory_equal(buffer.behind, fresh.behind, sizeof(fresh.behind));
	if (wanted) {
		assert_ptr_equal(found, buffer.line);
		assert_string_equal(found, wanted);
	} else {
		assert_null(found);
	}
	assert_string_equal(lines->refusal, refusal);
}

/* The first line of a text. */
static void expect_first(
	const char *text, const char *wanted, const char *refusal)
{
	struct ini_lines lines = lines_of(text, strlen(text));

	expect_line(&lines, wanted, refusal);
	assert_int_equal(lines.number, 1);
	fclose(lines.file);
}

static void test_lines_come_without_indentation_and_mark(void **state)
{
	static const struct {
		const char *text, *line;
	} rows[] = {{"a = b\n", "a = b\n"}, {" \ta:b", "a:b"},
		{"\xEF\xBB\xBF[a]\n", "[a]\n"},
		{"\xEF\xBB\xBF \t a=b\n", "a=b\n"},
		/* As long as it may be. */
		{"  a=3456789012\n", "a=3456789012\n"},
		{"  a=3456789012", "a=3456789012"},
		{"\xEF\xBB\xBF a=56789012", "a=56789012"},
		/* No keys. */
		{"; b\n", "; b\n"}, {"# b\n", "# b\n"}, {" \n", "\n"},
		{"\r\n", "\r\n"}, {" ", ""}, {"[a] \t\r\n", "[a] \t\r\n"},
		{"[a b];c\n", "[a b];c\n"}, {"[a]", "[a]"}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		expect_first(rows[i].text, rows[i].line, "");
	}
}

static void test_lines_that_are_none_are_refused(void **state)
{
	static const char utf_16[] =
		"this text is in UTF-16: save the file as UTF-8";
	static const char behind[] =
		"a section ends with its ]: begin a line below, or a comment with ;";
	static const char long_line[] =
		"this line has more than 14 characters or is no text: make it shorter";
	static const struct {
		const char *text, *refusal;
	} rows[] = {{"\xFF\xFE[", utf_16}, {"\xFE\xFF[", utf_16},
		{"\xFF\xFE", utf_16}, {"\xFE\xFF", utf_16},
		/* Only both bytes are such a mark, and three are another one. */
		{"\xFF[", INI_LINES_INVALID}, {"\xFE[", INI_LINES_INVALID},
		{"\xEF\xBBx[a]", INI_LINES_INVALID},
		{"\xEF[a]", INI_LINES_INVALID},
		{"\xBB\xBF[a]", INI_LINES_INVALID},
		{"a b\n", INI_LINES_INVALID}, {" a", INI_LINES_INVALID},
		{"]\n", INI_LINES_INVALID}, {"[a\n", "a ] is missing"},
		{"[a] b\n", behind}, {"[a] = b\n", behind}, {"[a]#b\n", behind},
		{"[a]]\n", behind}, {"a=34567890123456\nb=1\n", long_line}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		expect_first(rows[i].text, NULL, rows[i].refusal);
	}
}

/* The marks of a file stand at its beginning. */
static void test_only_the_first_line_may_have_a_mark(void **state)
{
	static const char *const texts[] = {
		"\n\xEF\xBB\xBF[a]\n", "\n\xFF\xFE[a]\n", "\n\xFE\xFF[a]\n"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(texts); i++) {
		struct ini_lines lines = lines_of(texts[i], strlen(texts[i]));

		expect_line(&lines, "\n", "");
		expect_line(&lines, NULL, INI_LINES_INVALID);
		assert_int_equal(lines.number, 2);
		fclose(lines.file);
	}
}

/* A refusal holds for one line. */
static void test_lines_can_be_read_behind_a_refused_one(void **state)
{
	static const char text[] = "a\nb=1\n";
	struct ini_lines lines = lines_of(text, strlen(text));

	(void)state;
	expect_line(&lines, NULL, INI_LINES_INVALID);
	expect_line(&lines, "b=1\n", "");
	expect_line(&lines, NULL, "");
	assert_int_equal(lines.number, 2);
	fclose(lines.file);
}

static void test_a_file_has_so_many_lines(void **state)
{
	static const char text[] = "a=1\nb=1\nc=1\nd=1\n";
	struct ini_lines lines = lines_of(text, strlen(text));

	(void)state;
	expect_line(&lines, "a=1\n", "");
	expect_line(&lines, "b=1\n", "");
	expect_line(&lines, "c=1\n", "");
	expect_line(&lines, NULL, "the file has more than 3 lines");
	assert_int_equal(lines.number, 4);
	fclose(lines.file);
}

/* A byte of zero seems to end the line, also as its first one. */
static void test_bytes_of_zero_are_no_text(void **state)
{
	static const struct {
		char text[8];
		size_t size;
	} rows[] = {{"a=\0b\nc=1", 8}, {"\0a=b\nc=1", 8}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct ini_lines lines = lines_of(rows[i].text, rows[i].size);

		expect_line(&lines, NULL,
			"this line has more than 14 characters or is no text: make it shorter");
		fclose(lines.file);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_lines_come_without_indentation_and_mark),
		cmocka_unit_test(test_lines_that_are_none_are_refused),
		cmocka_unit_test(test_only_the_first_line_may_have_a_mark),
		cmocka_unit_test(test_lines_can_be_read_behind_a_refused_one),
		cmocka_unit_test(test_a_file_has_so_many_lines),
		cmocka_unit_test(test_bytes_of_zero_are_no_text),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
