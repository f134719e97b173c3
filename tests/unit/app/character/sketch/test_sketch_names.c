/* Which names of a model a character file holds, and what stands for others. */
#include "app/character/sketch/sketch_names.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	MOST = 25
};

/* Many zeros: zeros + 25 - n is the name of n zeros. */
static const char zeros[] = "0000000000000000000000000";

static void test_usable_names_are_short_and_can_be_shown(void **state)
{
	static const struct {
		const char *name;
		bool usable;
	} rows[] = {{"", false}, {"a", true}, {"a b,c#", true}, {"a\"", false},
		{"a]b", false}, {"a;b", false}, {"a\rb", false},
		{"a\nb", false}, {"a\x1b", false}, {"a\xff", false},
		{"\xc3\xa9", true}, {" ", true}};
	char name[65];

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		assert_int_equal(sketch_is_usable(rows[i].name), rows[i].usable);
	}
	memset(name, 'a', sizeof(name));
	name[64] = '\0';
	assert_false(sketch_is_usable(name));
	assert_true(sketch_is_usable(name + 1));
	assert_false(sketch_fits_heading(name + 22));
	assert_true(sketch_fits_heading(name + 23));
}

/* Of nodes with the same name, the first one in the file. */
static void test_the_first_node_of_a_name_has_it(void **state)
{
	static const struct {
		const char *name;
		bool named;
	} rows[] = {{"b", true}, {"a", true}, {"b", false}, {"a", false},
		{"c]", false}, {"a", false}, {"c", true}, {"b", false},
		{"ba", true}};
	struct model_node node[ARRAY_COUNT(rows)];
	struct model model = {.node = node, .node_count = ARRAY_COUNT(rows)};
	struct arena arena = arena_empty();
	bool *named;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		node[i] = (struct model_node){.name = rows[i].name};
	}
	named = sketch_find_named_nodes(&model, &arena);
	assert_non_null(named);
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		assert_int_equal(named[i], rows[i].named);
	}
	arena_release(&arena);
}

static void expect_text(FILE *out, char **text, const char *wanted)
{
	assert_int_equal(fclose(out), 0);
	assert_string_equal(*text, wanted);
	free(*text);
	*text = NULL;
}

/* What stands for a clip, and for the section about it. */
static void expect_clip(const char *const *name, int count, int which,
	const char *clip, const char *heading)
{
	struct model_clip clips[MOST];
	struct model model = {.clip = clips, .clip_count = count};
	char *text = NULL;
	size_t size = 0;
	FILE *out = open_memstream(&text, &size);

	for (int i = 0; i < count; i++) {
		clips[i] = (struct model_clip){.name = name[i]};
	}
	assert_non_null(out);
	sketch_write_clip(out, &model, which);
	expect_text(out, &text, clip);
	out = open_memstream(&text, &size);
	assert_non_null(out);
	sketch_write_heading(out, &model, which);
	expect_text(out, &text, heading);
}

static void test_numbers_stand_for_clips_without_names(void **state)
{
	static const char long_name[] =
		"012345678901234567890123456789012345678901";
	static const char *const usual[] = {
		"walk", "", "walk", "a b", long_name, "clip 1", "clip 2"};
	static const char *const first[] = {"clip 1", ""};
	static const char *const numbers[] = {"", "0", "clip 0", "00", "2"};

	(void)state;
	expect_clip(usual, 1, 0, "walk", "walk");
	expect_clip(usual, 5, 1, "1", "\"clip 1\"");
	expect_clip(usual, 5, 2, "2", "\"clip 2\"");
	expect_clip(usual, 5, 3, "\"a b\"", "\"a b\"");
	expect_clip(usual, 5, 4, long_name, "\"clip 4\"");
	/* Other clips are called so. */
	expect_clip(usual, 7, 1, "1", "1");
	expect_clip(usual, 7, 2, "2", "2");
	expect_clip(first, 2, 1, "1", "1");
	expect_clip(numbers, 5, 0, "000", "000");
	expect_clip(numbers, 5, 4, "2", "2");
}

/* No more zeros fit, even if a clip or a target is called so. */
static void test_numbers_have_up_to_23_digits(void **state)
{
	for (int count = 23; count <= 24; count++) {
		const char *name[MOST] = {""};
		struct model_mesh mesh = {
			.target_count = count, .target_name = name};
		char *text = NULL;
		size_t size = 0;
		FILE *out = open_memstream(&text, &size);

		(void)state;
		for (int i = 1; i < count; i++) {
			name[i] = zeros + 25 - i;
		}
		name[count] = "clip 0";
		expect_clip(name, count + 1, 0, zeros + 2, zeros + 2);
		assert_non_null(out);
		sketch_write_target(out, &mesh, 0);
		expect_text(out, &text, zeros + 2);
		out = open_memstream(&text, &size);
		assert_non_null(out);
		mesh.target_count = 22;
		sketch_write_target(out, &mesh, 0);
		expect_text(out, &text, zeros + 3);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_usable_names_are_short_and_can_be_shown),
		cmocka_unit_test(test_the_first_node_of_a_name_has_it),
		cmocka_unit_test(test_numbers_stand_for_clips_without_names),
		cmocka_unit_test(test_numbers_have_up_to_23_digits),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
