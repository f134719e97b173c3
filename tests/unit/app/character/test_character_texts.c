/*
 * What buttons are called, targets that are counted from a node, marks of
 * clips, files that include others, the letters that editors write, and how
 * long lines and files may be.
 */
#include "app/character/character_data.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The list of all buttons; the caller frees it. */
static char *buttons_of(const struct acting *acting)
{
	char *text = NULL;
	size_t size;
	FILE *file = open_memstream(&text, &size);

	assert_non_null(file);
	character_print_buttons(acting->character, file);
	fclose(file);
	return text;
}

static void test_a_button_without_a_label_is_called_as_it_acts(void **state)
{
	struct acting acting;
	char *text;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter side]\n[state a]\nclip = walk\n[state b]\nclip = run\n"
		"[buttons]\nUP = go a\nDOWN = set side 0.5,  go b\n");
	text = buttons_of(&acting);
	assert_string_equal(
		text, "  UP     go a\n  DOWN   set side 0.5, go b\n");
	free(text);
	acting_end(&acting);
}

/* As of arrows that move the camera beside each of some parts. */
static void test_what_a_button_does_under_many_conditions_is_listed_once(
	void **state)
{
	struct acting acting;
	char *text;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter part]\nchoices = a b c\n"
		"[buttons a]\nwhen = part is a\nUP = pause \"wait\"\n"
		"DOWN = pause \"wait\"\n"
		"[buttons b]\nwhen = part is b\nUP = tour \"wait\"\n"
		"[buttons c]\nwhen = part is c\nUP = pause \"rest\"\n");
	text = buttons_of(&acting);
	assert_string_equal(
		text, "  UP     wait\n  DOWN   wait\n  UP     rest\n");
	free(text);
	acting_end(&acting);
}

/* A line has up to 199 bytes. */
static void test_a_label_holds_the_words_of_a_long_line(void **state)
{
	char file[512] = "[parameter side]\n[buttons]\nUP = set side 0.5";
	struct acting acting;
	const char *wanted = strstr(file, "set");

	(void)state;
	for (int i = 0; i < 11; i++) {
		strcat(file, ", set side 0.25");
	}
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting, file);
	assert_true(strlen(wanted) > 170);
	assert_string_equal(acting.character->binding->label, wanted);
	acting_end(&acting);
}

/* Also from node 0, which is a root. */
static void test_a_target_is_counted_from_any_node(void **state)
{
	static const int nodes[] = {0, 1, 5};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (size_t i = 0; i < ARRAY_COUNT(nodes); i++) {
		const char *name = acting.model->node[nodes[i]].name;
		const struct character_target *target;
		char file[256];
		float at[3];

		snprintf(file, sizeof(file),
			"[state a]\nclip = walk\n[target ball]\n"
			"place = 0.25 0.5 0.125\nnode = %s\nradius = 0.1\n",
			name);
		acting_expect(&acting, file);
		for (int axis = 0; axis < 3; axis++) {
			acting.model->node[0].rest.translation[axis] =
				1.0f + (float)axis;
		}
		acting_run_to(&acting, acting.now_s + 0.5, 20.0);
		acting_place(&acting, name, at);
		target = &acting.character->target[0];
		assert_near(target->point[0], at[0] + 0.25f, 1e-5);
		assert_near(target->point[1], at[1] + 0.5f, 1e-5);
		assert_near(target->point[2], at[2] + 0.125f, 1e-5);
	}
	acting_end(&acting);
}

/* Between two marks time has to pass, also from the last one to the first. */
static void test_no_marks_are_at_the_same_moment_of_a_round(void **state)
{
	struct acting acting;
	const struct model_clip *clip;
	char text[128];

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	clip = &acting.model->clip[model_find_clip(acting.model, "walk")];
	snprintf(text, sizeof(text), "[clip walk]\nmarks = 0 0.5 %.9g\n",
		(double)clip->duration_s);
	acting_read(&acting, text);
	assert_null(acting.character);
	assert_contains(acting.logged.sentence[0], "the same moment");
	acting_read(&acting, "[clip rest]\nmarks = 0\n");
	assert_null(acting.character);
	acting_expect(&acting, "[clip walk]\nmarks = 0.5\n");
	acting_run_to(&acting, 3.0, 20.0);
	acting_end(&acting);
}

static void load_both(struct acting *acting, const char *base, const char *own)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "own.character");

	file_write(path_join(&folder, "the base.character").text, base,
		strlen(base));
	file_write(path.text, own, strlen(own));
	acting_load(acting, path.text);
	temp_dir_remove(&folder);
	if (acting->error) {
		fail_msg("%s", acting->logged.sentence[0]);
	}
}

/* Nothing is left of what an included file says by the same key. */
static void test_a_line_replaces_the_whole_line_of_an_included_file(void **state)
{
	const struct character_parameter *parameter;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	load_both(&acting,
		"[names]\nmove = walk\n[state a]\nclip = move\n"
		"[parameter p]\nrange = 0 9\nstops = 1 2 3\n"
		"[parameter t]\nsource = time 2 0.25\n"
		"[part hips]\nheading = p\n",
		"include = \"the base.character\"\n[names]\nmove = run\n"
		"[parameter p]\nstops = 4 5\n[parameter t]\nsource = sine 4\n"
		"[part hips]\nheading = 10 -60 60\n");
	assert_string_equal(
		acting.character->machine.state[0].entry[0].of->clip->name,
		"run");
	parameter = acting.character->parameter;
	assert_int_equal(parameter[0].stop_count, 2);
	assert_near(parameter[0].stop[0], 4.0, 0.0);
	assert_near(parameter[1].offset, 0.0, 0.0);
	acting_run_to(&acting, 0.1, 20.0);
	assert_near(acting.character->part[0].freedom[0].value, 10.0, 0.0);
	acting_end(&acting);
}

/* What editors of other systems write, and names with odd letters. */
static void test_texts_of_all_editors_are_read(void **state)
{
	static const char *const texts[] = {
		"\xEF\xBB\xBF[state a]\r\nclip = walk\r\n",
		"\xEF\xBB\xBF; comment\n[state a]\nclip = walk",
		"  [state a]  ; comment\n\tclip=walk ; comment\n# comment\n",
		"[names]\nhips = mixamorig:Hips\n"
		"[state a]\nclip = \"walk\"\nenter = line \"a = b, c: d\"\n",
	};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (size_t i = 0; i < ARRAY_COUNT(texts); i++) {
		acting_expect(&acting, texts[i]);
		assert_string_equal(acting_state(&acting), "a");
	}
	acting_end(&acting);
}

static void test_a_text_in_utf_16_is_named(void **state)
{
	static const char *const texts[] = {"\xFF\xFE[", "\xFE\xFF"};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (size_t i = 0; i < ARRAY_COUNT(texts); i++) {
		acting_read(&acting, texts[i]);
		assert_int_not_equal(acting.error, 0);
		assert_int_equal(
			log_capture_count(&acting.logged, LOG_ERROR), 1);
		assert_contains(acting.logged.sentence[0],
			"test.character:1: this text is in UTF-16: save the file as UTF-8");
	}
	acting_end(&acting);
}

/* A comment may be in Latin-1; of a name nothing tells what is meant. */
static void test_a_name_in_latin_1_is_told_from_a_wrong_one(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting, "; f\xFCr\n[state a]\nclip = walk\n");
	acting_read(&acting, "[state a]\nclip = gr\xFCn\n");
	assert_int_not_equal(acting.error, 0);
	assert_contains(acting.logged.sentence[0],
		"clip: there is no clip named gr?n: if this file is not in UTF-8, save it as UTF-8");
	acting_read(&acting, "[state a]\nclip = gr\xC3\xBCn\n");
	assert_contains(acting.logged.sentence[0], "gr\xC3\xBCn: there are ");
	acting_end(&acting);
}

/* Reads a state, a comment of so many letters, and what is wrong below it. */
static void read_comment(struct acting *acting, int letters, const char *end)
{
	char text[400], comment[300];

	memset(comment, 'x', sizeof(comment));
	comment[0] = ';';
	(void)snprintf(text, sizeof(text), "[state a]\nclip = walk\n%.*s%s",
		letters, comment, end);
	acting_read(acting, text);
}

static void test_a_line_has_at_most_198_characters(void **state)
{
	static const char *const ends[] = {"", "\n", "\nodd\n"};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	for (size_t i = 0; i < ARRAY_COUNT(ends); i++) {
		read_comment(&acting, 198, ends[i]);
		assert_int_equal(acting.error != 0, i == 2);
		read_comment(&acting, 199, ends[i]);
		assert_int_not_equal(acting.error, 0);
		assert_int_equal(
			log_capture_count(&acting.logged, LOG_ERROR), 1);
		assert_contains(acting.logged.sentence[0],
			"test.character:3: this line has more than 198 characters");
	}
	acting_end(&acting);
}

static void test_a_file_has_at_most_8000_lines(void **state)
{
	static const char begin[] = "[state a]\nclip = walk\n";
	struct acting acting;
	char text[sizeof(begin) + 7999];

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	memset(text, '\n', sizeof(text));
	memcpy(text, begin, sizeof(begin) - 1);
	text[sizeof(begin) - 1 + 7998] = '\0';
	acting_expect(&acting, text);
	text[sizeof(begin) - 1 + 7998] = '\n';
	text[sizeof(text) - 1] = '\0';
	acting_read(&acting, text);
	assert_int_not_equal(acting.error, 0);
	assert_contains(acting.logged.sentence[0],
		"test.character:8001: the file has more than 8000 lines");
	acting_end(&acting);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_button_without_a_label_is_called_as_it_acts),
		cmocka_unit_test(
			test_what_a_button_does_under_many_conditions_is_listed_once),
		cmocka_unit_test(test_a_label_holds_the_words_of_a_long_line),
		cmocka_unit_test(test_a_target_is_counted_from_any_node),
		cmocka_unit_test(test_no_marks_are_at_the_same_moment_of_a_round),
		cmocka_unit_test(
			test_a_line_replaces_the_whole_line_of_an_included_file),
		cmocka_unit_test(test_texts_of_all_editors_are_read),
		cmocka_unit_test(test_a_text_in_utf_16_is_named),
		cmocka_unit_test(test_a_name_in_latin_1_is_told_from_a_wrong_one),
		cmocka_unit_test(test_a_line_has_at_most_198_characters),
		cmocka_unit_test(test_a_file_has_at_most_8000_lines),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
