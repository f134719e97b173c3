/* Which character file is opened, and what stands in for one. */
#include "app/character/character_open.h"
#include "app/character/sketch/character_sketch.h"
#include "platform/base/file.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char walker[] = "assets/walker.glb";

static void test_a_file_that_is_named_is_taken(void **state)
{
	static const struct {
		const char *file;
		size_t size;
		bool found;
	} rows[] = {{"abc", 4, true}, {"abc", 3, false}, {"none", 16, false},
		{"nones", 16, true}, {"", 1, true}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		const struct character_request request = {.model_path = walker,
			.file = rows[i].file,
			.clip = i % 2 ? "walk" : NULL};
		char path[16];

		assert_int_equal(
			character_open_path(&request, path, rows[i].size),
			rows[i].found);
		if (rows[i].found) {
			assert_string_equal(path, rows[i].file);
		}
	}
}

/* If there is one, and no clip is asked for. */
static void test_else_the_file_beside_the_model_is(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path model = path_join(&folder, "m.glb");
	struct test_path beside = path_join(&folder, "m.character");
	struct character_request request = {.model_path = model.text};
	char path[sizeof(beside.text)];

	(void)state;
	assert_false(character_open_path(&request, path, sizeof(path)));
	file_write(beside.text, "", 0);
	assert_true(character_open_path(&request, path, sizeof(path)));
	assert_string_equal(path, beside.text);
	assert_false(character_open_path(&request, path, strlen(beside.text)));
	request.clip = "walk";
	assert_false(character_open_path(&request, path, sizeof(path)));
	temp_dir_remove(&folder);
}

struct opened {
	struct acting acting; /* the model and its instance */
	struct log log;
	int error;
	struct character *character;
};

static void begin(struct opened *opened)
{
	acting_begin(&opened->acting, walker);
	opened->log = log_capture_begin(&opened->acting.logged);
	opened->character = NULL;
}

static void open_as(
	struct opened *opened, const struct character_request *request)
{
	static char nothing;

	character_destroy(opened->character);
	opened->character = (struct character *)(void *)&nothing;
	opened->error = character_open(request, opened->acting.instance,
		&opened->log, &opened->character);
}

static void end(struct opened *opened)
{
	character_destroy(opened->character);
	acting_end(&opened->acting);
}

/* It begins with the first clip, or with that one. */
static void test_without_a_file_a_sketch_plays_the_clips(void **state)
{
	static const struct {
		const char *clip;
		int index;
	} rows[] = {{NULL, 0}, {"0", 0}, {"walk", 3}, {"4", 4}};
	struct opened opened;

	(void)state;
	begin(&opened);
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		const struct character_request request = {.model_path = walker,
			.file = "none",
			.clip = rows[i].clip,
			.rate = 1,
			.repeat = CLIP_LOOP};
		const struct character_machine *machine;

		open_as(&opened, &request);
		assert_int_equal(opened.error, 0);
		assert_int_equal(opened.acting.logged.count, 0);
		machine = &opened.character->machine;
		assert_ptr_equal(
			machine->state[machine->current].entry[0].of->clip,
			&opened.acting.model->clip[rows[i].index]);
		assert_int_equal(
			character_open_stamp(&request, opened.character), 0);
	}
	end(&opened);
}

static void test_what_cannot_be_opened_is_none(void **state)
{
	static const struct character_request rows[] = {
		{.model_path = walker, .file = "none", .clip = "fly"},
		{.model_path = walker, .file = "no/such.character"}};
	struct opened opened;

	(void)state;
	begin(&opened);
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		open_as(&opened, &rows[i]);
		assert_true(opened.error < 0);
		assert_null(opened.character);
		assert_int_equal(opened.acting.logged.count, i + 1);
	}
	end(&opened);
}

/* A file that changes, and one that comes to be where there was none. */
static void test_the_stamp_is_that_of_the_file(void **state)
{
	static const char text[] = "[state a]\nclip = walk\n";
	struct test_path folder = temp_dir_make();
	struct test_path model = path_join(&folder, "m.glb");
	struct test_path beside = path_join(&folder, "m.character");
	const struct character_request request = {
		.model_path = model.text, .rate = 1};
	struct opened opened;

	(void)state;
	begin(&opened);
	open_as(&opened, &request);
	assert_int_equal(opened.error, 0);
	assert_false(opened.character->text.is_file);
	assert_int_equal(character_open_stamp(&request, opened.character), 0);
	file_write(beside.text, text, strlen(text));
	assert_true(character_open_stamp(&request, opened.character) ==
		file_stamp(beside.text));
	assert_true(file_stamp(beside.text) != 0);
	open_as(&opened, &request);
	assert_int_equal(opened.error, 0);
	assert_true(opened.character->text.is_file);
	assert_true(character_open_stamp(&request, opened.character) ==
		character_stamp(opened.character));
	end(&opened);
	temp_dir_remove(&folder);
}

/* A thousand, of which no button reaches the others. */
static void test_clips_beyond_the_buttons_are_reported(void **state)
{
	static struct model_clip clips[CHARACTER_SKETCH_CLIPS + 1];
	static char name[CHARACTER_SKETCH_CLIPS + 1][8];
	const struct character_request request = {.model_path = walker,
		.file = "none",
		.rate = 1,
		.repeat = CLIP_LOOP};
	struct opened opened;

	(void)state;
	for (int more = 0; more < 2; more++) {
		int count = CHARACTER_SKETCH_CLIPS + more, own;
		struct model_clip *clip;

		begin(&opened);
		clip = opened.acting.model->clip;
		own = opened.acting.model->clip_count;
		for (int i = 0; i < count; i++) {
			snprintf(name[i], sizeof(name[i]), "c%d", i);
			clips[i] = clip[i % own];
			clips[i].name = name[i];
		}
		opened.acting.model->clip = clips;
		opened.acting.model->clip_count = count;
		open_as(&opened, &request);
		assert_int_equal(
			log_capture_has(&opened.acting.logged, LOG_WARNING,
				"buttons reach 1000 of the "),
			more);
		opened.acting.model->clip = clip;
		opened.acting.model->clip_count = own;
		end(&opened);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_file_that_is_named_is_taken),
		cmocka_unit_test(test_else_the_file_beside_the_model_is),
		cmocka_unit_test(test_without_a_file_a_sketch_plays_the_clips),
		cmocka_unit_test(test_what_cannot_be_opened_is_none),
		cmocka_unit_test(test_the_stamp_is_that_of_the_file),
		cmocka_unit_test(test_clips_beyond_the_buttons_are_reported),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
