/* Sections, lines and words of character files, and the files of a character. */
#define _GNU_SOURCE /* fopencookie() */
#include "app/character/text/character_split.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct bench {
	struct arena arena;
	struct log_capture capture;
	struct log log;
	struct character_text text;
	struct test_path folder;
};

static int begin(void **state)
{
	struct bench *bench = calloc(1, sizeof(*bench));

	assert_non_null(bench);
	bench->arena = arena_empty();
	bench->log = log_capture_begin(&bench->capture);
	bench->folder = temp_dir_make();
	*state = bench;
	return 0;
}

static int end(void **state)
{
	struct bench *bench = *state;

	arena_release(&bench->arena);
	temp_dir_remove(&bench->folder);
	free(bench);
	return 0;
}

/* Reads a text that may not include others. */
static int read_text(struct bench *bench, const char *text)
{
	FILE *file = fmemopen((void *)text, strlen(text), "r");
	int error;

	assert_non_null(file);
	bench->log = log_capture_begin(&bench->capture);
	error = character_text_read(
		&bench->text, &bench->arena, file, "a", false, &bench->log);
	fclose(file);
	return error;
}

static void expect_refusal(struct bench *bench, int error, const char *sentence)
{
	assert_true(error < 0);
	assert_int_equal(bench->capture.count, 1);
	assert_int_equal(bench->capture.level[0], LOG_ERROR);
	assert_contains(bench->capture.sentence[0], sentence);
}

static void put(struct bench *bench, const char *name, const char *text)
{
	file_write(path_join(&bench->folder, name).text, text, strlen(text));
}

/* Reads the file "own" of the folder. */
static int load(struct bench *bench)
{
	struct test_path own = path_join(&bench->folder, "own");

	bench->log = log_capture_begin(&bench->capture);
	return character_text_load(
		&bench->text, &bench->arena, own.text, &bench->log);
}

/* The value of a line, whose words are joined by a stroke. */
static void test_a_value_is_divided_at_blanks_and_commas(void **state)
{
	static const struct {
		const char *value, *words;
		const char *quoted; /* a letter for each word */
	} rows[] = {{"", "", ""}, {" \t", "", ""}, {"a", "a|", "-"},
		{"a bc  d\t", "a|bc|d|", "---"}, {"a,b", "a|,|b|", "---"},
		{",", ",|", "-"}, {"\"a, b\" c", "a, b|c|", "q-"},
		{"a\"b\"c", "a|b|c|", "-q-"}, {"\"\"", "|", "q"}};
	struct bench *bench = *state;

	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct character_word word[CHARACTER_WORDS_MAX];
		char all[64] = "", quoted[8] = "";
		int count = character_split(rows[i].value, &bench->arena, word);

		assert_int_equal(count, (int)strlen(rows[i].quoted));
		for (int k = 0; k < count; k++) {
			strcat(strcat(all, word[k].text), "|");
			strcat(quoted, word[k].quoted ? "q" : "-");
		}
		assert_string_equal(all, rows[i].words);
		assert_string_equal(quoted, rows[i].quoted);
	}
}

/* What stands before them in memory is none of them. */
static void test_a_value_may_begin_with_blanks(void **state)
{
	static const char text[] = "b,  a";
	struct bench *bench = *state;
	struct character_word word[CHARACTER_WORDS_MAX];

	assert_int_equal(character_split(text + 2, &bench->arena, word), 1);
	assert_string_equal(word[0].text, "a");
}

static void test_a_value_has_at_most_64_words(void **state)
{
	struct bench *bench = *state;
	struct character_word word[CHARACTER_WORDS_MAX];
	char value[] = ",,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,"
		       ",,,,,,,,,,,,,,,,,,,,,,,,,,,,,,,, ";

	assert_int_equal(character_split(value, &bench->arena, word), 64);
	value[64] = ',';
	assert_int_equal(character_split(value, &bench->arena, word), -EFBIG);
	assert_int_equal(character_split("a \"b", &bench->arena, word), -EINVAL);
}

static void test_a_section_has_a_kind_and_up_to_two_names(void **state)
{
	static const struct {
		const char *text, *kind, *name, *other;
	} rows[] = {{"[a]", "a", "", ""}, {"[ a \"b c\" ]", "a", "b c", ""},
		{"[a b c]", "a", "b", "c"}};
	static const char *const wrong[] = {
		"[]\n", "[ ]\n", "[a b c d]\n", "[a b c d e]\nf = 1\n"};
	struct bench *bench = *state;

	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		const struct character_section *section;

		assert_int_equal(read_text(bench, rows[i].text), 0);
		section = bench->text.first;
		assert_string_equal(section->kind, rows[i].kind);
		assert_string_equal(section->name, rows[i].name);
		assert_string_equal(section->other, rows[i].other);
		assert_null(section->next);
	}
	for (size_t i = 0; i < ARRAY_COUNT(wrong); i++) {
		expect_refusal(bench, read_text(bench, wrong[i]),
			"a:1: this is no section: write [KIND], [KIND NAME] or [KIND NAME OTHER]");
	}
}

/* Only if all its words are the same it goes on. */
static void test_a_section_may_go_on_further_down(void **state)
{
	static const char text[] = "[a b]\nk = 1\n[a c]\n[a b d]\n[e b]\n"
				   "[a b]\nl = 2\n[a c]\n";
	static const char *const headings[] = {"a b", "a c", "a b d", "e b"};
	struct bench *bench = *state;
	const struct character_section *section;

	assert_int_equal(read_text(bench, text), 0);
	section = bench->text.first;
	for (size_t i = 0; i < ARRAY_COUNT(headings); i++) {
		assert_string_equal(section->heading, headings[i]);
		assert_int_equal(section->number, i == 0 ? 1 : (int)i + 2);
		section = section->next;
	}
	assert_null(section);
	section = bench->text.first;
	assert_string_equal(section->first->key, "k");
	assert_int_equal(section->first->number, 2);
	assert_ptr_equal(section->first->next, section->last);
	assert_string_equal(section->last->key, "l");
	assert_int_equal(section->last->number, 7);
	assert_int_equal(character_text_count(&bench->text, "a"), 3);
	assert_int_equal(character_text_count(&bench->text, "e"), 1);
	assert_int_equal(character_text_count(&bench->text, "b"), 0);
}

static void test_a_heading_has_at_most_49_characters(void **state)
{
	struct bench *bench = *state;
	char text[64];

	snprintf(text, sizeof(text), "[%049d]\n", 7);
	assert_int_equal(read_text(bench, text), 0);
	assert_int_equal((int)strlen(bench->text.first->kind), 49);
	snprintf(text, sizeof(text), "[%050d]\n", 7);
	expect_refusal(bench, read_text(bench, text),
		"a:1: the name of this section has more than 49 characters");
}

static void test_lines_that_say_nothing_are_refused(void **state)
{
	static const struct {
		const char *text, *sentence;
	} rows[] = {
		{"\nk = 1\n", "a:2: this line comes before any [section]"},
		{"[a]\nk = \"1\n", "a:2: a quotation mark is missing"},
		{"[a]\n\nodd\n", "a:3: this line is not valid: write [SECTION]"},
		/* What is like a value stands in a comment. */
		{"[a]\nodd ; = 1\n", "a:2: this line is not valid"},
		{"[a]\n; b\nodd ; = 1\nk = 2\n", "a:3: this line is not valid"},
		{"[a\n", "a:1: a ] is missing"},
		{"[a] b\n", "a:1: a section ends with its ]"},
		{"include = b\n",
			"a:1: include: a file is needed to include another"},
	};
	struct bench *bench = *state;

	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		expect_refusal(bench, read_text(bench, rows[i].text),
			rows[i].sentence);
	}
}

/* In any other section it may be a key. */
static void test_include_is_a_word_of_the_character(void **state)
{
	struct bench *bench = *state;

	assert_int_equal(read_text(bench, "[names]\ninclude = b\n"), 0);
	assert_string_equal(bench->text.first->first->key, "include");
	assert_string_equal(bench->text.first->first->section, "names");
	expect_refusal(bench, read_text(bench, "[character]\ninclude = b\n"),
		"a:2: include: a file is needed");
}

static void test_a_name_with_blanks_may_stand_in_quotes(void **state)
{
	static const struct {
		const char *own;
		bool found;
	} rows[] = {{"include = b c", true}, {"include = \"b c\"", true},
		{"include = \"b c\" d", false}, {"include = b", false}};
	struct bench *bench = *state;

	put(bench, "b c", "[inner]\n");
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		put(bench, "own", rows[i].own);
		if (rows[i].found) {
			assert_int_equal(load(bench), 0);
			assert_string_equal(bench->text.first->kind, "inner");
			assert_int_equal(bench->text.file_count, 2);
			assert_true(bench->text.is_file);
		} else {
			assert_int_equal(load(bench), -ENOENT);
			expect_refusal(bench, -ENOENT,
				" cannot be read: No such file or directory");
			assert_contains(bench->capture.sentence[0],
				"/own:1: include: ");
		}
	}
}

static void test_a_missing_file_is_named(void **state)
{
	struct bench *bench = *state;

	assert_int_equal(load(bench), -ENOENT);
	expect_refusal(bench, -ENOENT, "/own: cannot be read: No such file");
}

/* The first file, and seven that include one another. */
static void test_a_character_has_at_most_8_files(void **state)
{
	struct bench *bench = *state;

	put(bench, "own", "include = 2");
	for (int i = 2; i <= 8; i++) {
		char name[2] = {(char)('0' + i)}, text[] = "include = ?";

		text[sizeof(text) - 2] = (char)('0' + i + 1);
		put(bench, name, i < 8 ? text : "[a]\n");
	}
	assert_int_equal(load(bench), 0);
	assert_int_equal(bench->text.file_count, 8);
	assert_contains(bench->text.file[7], "/8");
	put(bench, "8", "include = 8");
	expect_refusal(bench, load(bench),
		"/8:1: include: a character may have at most 8 files, and none may include itself");
}

/* Of all its files together. */
static void test_a_character_has_at_most_8000_lines(void **state)
{
	static char text[4 * 4002 + 32];
	struct bench *bench = *state;
	size_t length = strlen(strcpy(text, "include = b\n[a]\n"));

	for (int i = 0; i < 4001; i++) {
		memcpy(text + length + 4 * (size_t)i, "k=1\n", 5);
	}
	put(bench, "b", text + strlen("include = b\n"));
	text[length + 4 * 3999] = '\0';
	put(bench, "own", text);
	assert_int_equal(load(bench), 0);
	assert_int_equal(bench->text.line_count, 8000);
	text[length + 4 * 3999] = 'k';
	text[length + 4 * 4000] = '\0';
	put(bench, "own", text);
	expect_refusal(bench, load(bench),
		"/own:4002: the character has more than 8000 lines");
}

static ssize_t read_nothing(void *cookie, char *to, size_t size)
{
	(void)cookie;
	(void)to;
	(void)size;
	errno = EIO;
	return -1;
}

static void test_a_file_that_cannot_be_read_is_named(void **state)
{
	struct bench *bench = *state;
	FILE *file = fopencookie(
		NULL, "r", (cookie_io_functions_t){.read = read_nothing});

	assert_non_null(file);
	assert_int_equal(character_text_read(&bench->text, &bench->arena, file,
				 "a", false, &bench->log),
		-EIO);
	expect_refusal(bench, -EIO, "a: cannot be read");
	fclose(file);
}

static void test_only_files_of_the_same_folder_are_near(void **state)
{
	static const struct {
		const char *file, *name, *path;
	} rows[] = {{"own", "b", "b"}, {"d/e/own", "b c", "d/e/b c"},
		{"/own", "b", "/b"}, {"d/own", "", NULL}, {"own", "", NULL},
		{"own", "d/b", NULL}, {"own", "/b", NULL}, {"own", "d\\b", NULL},
		{"own", ".", NULL}, {"own", "..", NULL}, {"own", ".b", NULL}};
	char path[16];

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		assert_int_equal(character_text_path_near(rows[i].file,
					 rows[i].name, path, sizeof(path)),
			rows[i].path != NULL);
		if (rows[i].path) {
			assert_string_equal(path, rows[i].path);
		}
	}
	assert_true(character_text_path_near("d/own", "1234567", path, 10));
	assert_string_equal(path, "d/1234567");
	assert_false(character_text_path_near("d/own", "12345678", path, 10));
}

static void test_a_character_lies_beside_its_model(void **state)
{
	static const struct {
		const char *model, *path;
	} rows[] = {{"robot.glb", "robot.character"},
		{"d.e/robot.v2.glb", "d.e/robot.v2.character"},
		{"d.e/robot", "d.e/robot.character"},
		{"robot", "robot.character"}};
	char path[32];

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		size_t length = strlen(rows[i].path);

		assert_true(character_text_path_beside(
			rows[i].model, path, length + 1));
		assert_string_equal(path, rows[i].path);
		assert_false(
			character_text_path_beside(rows[i].model, path, length));
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
#define TEST(name) cmocka_unit_test_setup_teardown(name, begin, end)
		TEST(test_a_value_is_divided_at_blanks_and_commas),
		TEST(test_a_value_may_begin_with_blanks),
		TEST(test_a_value_has_at_most_64_words),
		TEST(test_a_section_has_a_kind_and_up_to_two_names),
		TEST(test_a_section_may_go_on_further_down),
		TEST(test_a_heading_has_at_most_49_characters),
		TEST(test_lines_that_say_nothing_are_refused),
		TEST(test_include_is_a_word_of_the_character),
		TEST(test_a_name_with_blanks_may_stand_in_quotes),
		TEST(test_a_missing_file_is_named),
		TEST(test_a_character_has_at_most_8_files),
		TEST(test_a_character_has_at_most_8000_lines),
		TEST(test_a_file_that_cannot_be_read_is_named),
		cmocka_unit_test(test_only_files_of_the_same_folder_are_near),
		cmocka_unit_test(test_a_character_lies_beside_its_model),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
