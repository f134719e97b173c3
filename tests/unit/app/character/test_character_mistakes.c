/*
 * What limber says of mistakes in character files: each line of some files is
 * changed in four ways, and the answers are compared with a reference.
 */
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	LINE_BYTES = 256,
	SPOILED_BYTES = LINE_BYTES + 8,
	ANSWER_BYTES = 120 /* of longer answers the beginning is compared */
};

static const char reference[] = "tests/golden/mistakes.txt";

static const struct sample {
	const char *model, *character;
} samples[] = {
	{"assets/walker.glb", "tests/golden/characters/states.character"},
	{"assets/walker.glb", "tests/golden/characters/effects.character"},
	{"assets/arm.glb", "tests/golden/characters/parts.character"},
	{"assets/face.glb", "tests/golden/characters/curves.character"},
};

enum mistake {
	WITHOUT_LAST_WORD,
	ANOTHER_LAST_WORD,
	ANOTHER_WORD_BEFORE,
	A_WORD_MORE,
	MISTAKES
};

/* The length of the line up to the blank before its last word; 0: none. */
static int before_last_word(const char *line, int length)
{
	while (length > 0 && line[length] != ' ') {
		length--;
	}
	return length;
}

/* Writes the line with the mistake; false if it has no word to change. */
static bool spoil(const char *line, enum mistake mistake, char *out)
{
	int last = before_last_word(line, (int)strlen(line));
	int before = last ? before_last_word(line, last - 1) : 0;

	if (line[0] == ';' || line[0] == '\0') {
		return false;
	}
	switch (mistake) {
	case A_WORD_MORE:
		snprintf(out, SPOILED_BYTES, "%s more", line);
		return true;
	case ANOTHER_WORD_BEFORE:
		snprintf(out, SPOILED_BYTES, "%.*s odd%s", before, line,
			line + last);
		return before > 0 && line[last - 1] != '=';
	default:
		snprintf(out, SPOILED_BYTES, "%.*s%s", last, line,
			mistake == ANOTHER_LAST_WORD ? " -99" : "");
		return last > 0;
	}
}

/* Prints what limber says of the text. */
static void print_answer(const struct sample *sample, struct acting *acting,
	const char *text, FILE *out)
{
	const char *name = sample->character, *said = "right";
	FILE *file = fmemopen((void *)text, strlen(text), "r");
	struct log log = log_capture_begin(&acting->logged);

	assert_non_null(file);
	if (character_read(
		    file, name, acting->instance, &log, &acting->character)) {
		assert_int_equal(
			log_capture_count(&acting->logged, LOG_ERROR), 1);
		said = acting->logged.sentence[0];
		said += strncmp(said, name, strlen(name)) == 0 ? strlen(name)
							       : 0;
	}
	fclose(file);
	fprintf(out, "\t%.*s\n", ANSWER_BYTES, said);
	character_destroy(acting->character);
	acting->character = NULL;
}

static void try_mistakes(const struct sample *sample, FILE *out)
{
	struct acting acting;
	char *text = file_read(sample->character, NULL);
	size_t size = strlen(text) + SPOILED_BYTES;
	char *changed = malloc(size);
	int number = 0;

	assert_non_null(changed);
	acting_begin(&acting, sample->model);
	for (const char *begin = text, *end; *begin; begin = end + 1) {
		char line[LINE_BYTES], spoiled[SPOILED_BYTES];

		end = strchr(begin, '\n');
		number++;
		snprintf(line, sizeof(line), "%.*s", (int)(end - begin), begin);
		for (int m = 0; m < MISTAKES; m++) {
			if (spoil(line, (enum mistake)m, spoiled)) {
				snprintf(changed, size, "%.*s%s%s",
					(int)(begin - text), text, spoiled, end);
				fprintf(out, "%d: %s\n", number, spoiled);
				print_answer(sample, &acting, changed, out);
			}
		}
	}
	acting_end(&acting);
	free(changed);
	free(text);
}

/* Fails with the first line that differs, if there is one. */
static void expect_lines(const char *wanted, const char *found)
{
	while (*wanted || *found) {
		size_t a = strcspn(wanted, "\n"), b = strcspn(found, "\n");

		if (a != b || strncmp(wanted, found, a) != 0) {
			fail_msg("%s has:\n%.*s\nlimber says:\n%.*s", reference,
				(int)a, wanted, (int)b, found);
		}
		wanted += a + (wanted[a] != '\0');
		found += b + (found[b] != '\0');
	}
}

/* `make golden` writes the reference, with GOLDEN_WRITE in the environment. */
static void test_each_mistake_has_its_answer(void **state)
{
	char *found = NULL, *wanted;
	size_t size;
	FILE *out = open_memstream(&found, &size);

	(void)state;
	assert_non_null(out);
	for (size_t i = 0; i < ARRAY_COUNT(samples); i++) {
		fprintf(out, "%s\n", samples[i].character);
		try_mistakes(&samples[i], out);
	}
	assert_int_equal(fclose(out), 0);
	if (getenv("GOLDEN_WRITE")) {
		FILE *file = fopen(reference, "w");

		assert_non_null(file);
		assert_int_equal(fwrite(found, 1, size, file), size);
		assert_int_equal(fclose(file), 0);
	}
	wanted = file_read(reference, NULL);
	expect_lines(wanted, found);
	free(wanted);
	free(found);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_mistake_has_its_answer),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
