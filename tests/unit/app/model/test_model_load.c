/* model_load.c: formats, memory that a load gives back, warnings about pixels. */
#include "app/model/examine/examine.h"
#include "app/model/model.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void ignore(void *context, const char *finding)
{
	(void)context;
	(void)finding;
}

static const struct examiner nobody = {ignore, NULL};

/* Each way to read a file refuses it with the same sentence. */
static void expect_refused(
	const char *text, size_t size, int code, const char *reason)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "a.glb");

	file_write(path.text, text, size);
	for (int way = 0; way < 3; way++) {
		struct log_capture logged;
		struct log log = log_capture_begin(&logged);
		struct model *model = NULL;
		int error = way == 0 ? model_load(path.text, &log, &model)
			: way == 1
			? model_examine(
				  path.text, MODEL_MEMORY_BYTES, &nobody, &log)
			: model_load_memory(text, size, "a.glb", &log, &model);

		assert_int_equal(error, code);
		assert_null(model);
		assert_int_equal(logged.count, 1);
		assert_int_equal(logged.level[0], LOG_ERROR);
		assert_contains(logged.sentence[0], "a.glb: ");
		assert_contains(logged.sentence[0], reason);
	}
	temp_dir_remove(&folder);
}

static void test_files_of_no_format_are_refused(void **state)
{
	(void)state;
	expect_refused(
		"", 0, -EINVAL, "the file is empty: export or copy it again");
	expect_refused("solid", 5, -ENOTSUP,
		"the format is unknown; limber reads .gltf, .glb and .x: export the model as .glb");
	expect_refused("[]", 2, -ENOTSUP, "the format is unknown");
}

static void test_a_missing_file_is_one_error(void **state)
{
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct model *model = NULL;

	(void)state;
	assert_int_equal(
		model_load("/nonexistent/a.glb", &log, &model), -ENOENT);
	assert_null(model);
	assert_int_equal(logged.count, 1);
	assert_int_equal(model_examine("/nonexistent/a.glb", MODEL_MEMORY_BYTES,
				 &nobody, &log),
		-ENOENT);
	assert_int_equal(logged.count, 2);
}

/* The file's own bytes are no longer held when it is loaded. */
static void test_the_bytes_of_the_file_are_given_back(void **state)
{
	static char text[60000] = "{'asset':{'version':'2.0'},'nodes':[{}]}";
	size_t used[2];

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct log_capture logged;
		struct model *model;

		if (i == 1) { /* with blanks at its end */
			memset(text + strlen(text), ' ',
				sizeof(text) - strlen(text) - 1);
		}
		assert_int_equal(model_from_text(text, &logged, &model), 0);
		used[i] = model->budget->used_bytes;
		model_destroy(model);
	}
	assert_int_equal(used[0], used[1]);
}

static void test_clips_are_prepared_by_a_load(void **state)
{
	struct model *model = model_fixture("gltf/clip/frame_one.gltf", NULL);

	(void)state;
	assert_true(model->clip[0].lead_s > 0.0f);
	model_destroy(model);
}

/* Writes a black picture of one bit a pixel. */
static void write_png(const char *path, int width, int height)
{
	png_structp png = png_create_write_struct(
		PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
	png_infop info = png_create_info_struct(png);
	FILE *file = fopen(path, "wb");
	static uint8_t row[4096 / 8];

	assert_non_null(file);
	png_init_io(png, file);
	png_set_compression_level(png, 1);
	png_set_IHDR(png, info, (png_uint_32)width, (png_uint_32)height, 1,
		PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
		PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
	png_write_info(png, info);
	for (int i = 0; i < height; i++) {
		png_write_row(png, row);
	}
	png_write_end(png, NULL);
	png_destroy_write_struct(&png, &info);
	fclose(file);
}

/* Loads a model of so many pictures, the first one of this height. */
static size_t load_pictures(int count, int height, struct log_capture *logged)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "a.gltf");
	struct test_path first = path_join(&folder, "first.png");
	struct test_path other = path_join(&folder, "other.png");
	char text[2000] = "{\"asset\":{\"version\":\"2.0\"},\"images\":[";
	struct log log = log_capture_begin(logged);
	struct model *model;
	size_t used;

	write_png(first.text, height == 1024 ? 1024 : 4096, height);
	write_png(other.text, 4096, 4096);
	for (int i = 0; i < 3 * count; i++) {
		static const char *const heads[] = {
			"", "],\"textures\":[", "],\"materials\":["};
		size_t length = strlen(text);
		char part[200];

		if (i < count) {
			snprintf(part, sizeof(part), "{\"uri\":\"%s.png\"}",
				i == 0 ? "first" : "other");
		} else {
			snprintf(part, sizeof(part),
				i < 2 * count
					? "{\"source\":%d}"
					: "{\"pbrMetallicRoughness\":{\"baseColorTexture\":{\"index\":%d}}}",
				i % count);
		}
		snprintf(text + length, sizeof(text) - length, "%s%s%s",
			i % count == 0 ? heads[i / count] : "",
			i % count == 0 ? "" : ",", part);
	}
	snprintf(text + strlen(text), sizeof(text) - strlen(text), "]}");
	file_write(path.text, text, strlen(text));
	assert_int_equal(model_load(path.text, &log, &model), 0);
	assert_int_equal(model->image_count, count);
	used = model->budget->used_bytes;
	model_destroy(model);
	temp_dir_remove(&folder);
	return used;
}

/* From 50 million on: 4096 x (2 * 4096 + 4016). */
static void test_pixels_that_are_not_used_are_told(void **state)
{
	struct log_capture logged;

	(void)state;
	load_pictures(3, 4015, &logged);
	assert_int_equal(logged.count, 0);
	load_pictures(3, 4016, &logged);
	assert_int_equal(logged.count, 1);
	assert_contains(logged.sentence[0],
		"its images have 50 million pixels, of which limber uses 6 million: reading them takes a board about 10 s at each start: scale them to 1024x1024");
}

/* What bounds the time of decoding is no memory of the model. */
static void test_memory_held_for_images_is_given_back(void **state)
{
	struct log_capture logged;

	(void)state;
	assert_int_equal(load_pictures(1, 4096, &logged),
		load_pictures(1, 1024, &logged));
	assert_int_equal(load_pictures(2, 4096, &logged),
		load_pictures(2, 1024, &logged));
}

/*
 * A note for a mesh of nine bones, then a warning for each animation without a
 * frame, and one for their set.
 */
static void test_eight_warnings_are_told_and_notes_do_not_count(void **state)
{
	(void)state;
	for (int warnings = 8; warnings <= 10; warnings++) {
		char text[6000] =
			"xof 0303txt 0032\nMesh M { 3; 0;0;0;, 1;0;0;, "
			"0;1;0;; 1; 3;0,1,2;; ";
		struct log_capture logged;
		struct log log = log_capture_begin(&logged);
		struct model *model;

		for (int bone = 0; bone < 9; bone++) {
			strcat(text,
				"SkinWeights { \"B\"; 1; 0; 1; 1,0,0,0, "
				"0,1,0,0, 0,0,1,0, 0,0,0,1;; } ");
		}
		strcat(text, "} Frame B { } AnimationSet S { ");
		for (int i = 1; i < warnings; i++) {
			strcat(text,
				"Animation { AnimationKey { 2; 1; "
				"0;3;1,2,3;;; } } ");
		}
		strcat(text, "}");
		assert_int_equal(model_load_memory(text, strlen(text), "a.x",
					 &log, &model),
			0);
		assert_int_equal(log_capture_count(&logged, LOG_NOTE), 1);
		assert_int_equal(log_capture_count(&logged, LOG_WARNING),
			warnings == 8 ? 8 : 9);
		assert_int_equal(
			log_capture_has(&logged, LOG_WARNING,
				warnings == 9 ? "leaves out 1 more warnings"
					      : "leaves out 2 more warnings"),
			warnings > 8);
		model_destroy(model);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_eight_warnings_are_told_and_notes_do_not_count),
		cmocka_unit_test(test_files_of_no_format_are_refused),
		cmocka_unit_test(test_a_missing_file_is_one_error),
		cmocka_unit_test(test_the_bytes_of_the_file_are_given_back),
		cmocka_unit_test(test_clips_are_prepared_by_a_load),
		cmocka_unit_test(test_pixels_that_are_not_used_are_told),
		cmocka_unit_test(test_memory_held_for_images_is_given_back),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
