/* Each long computation of a start gives up when limber is asked to end. */
#include "app/demo/demo.h"
#include "app/model/image/image.h"
#include "app/model/levels/levels.h"
#include "app/scene/draw/texture.h"
#include "app/scene/instance/bounds.h"
#include "platform/base/file.h"
#include "platform/process/stop.h"
#include "tests/support/files.h"
#include "tests/support/gl/texture_sent.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>

static const char walker[] = "assets/walker.glb";

static void ask(void)
{
	signal(SIGTERM, SIG_DFL);
	stop_catch();
	raise(SIGTERM);
}

static struct model *load(const char *path)
{
	struct log log = log_to_nowhere();
	struct model *model;

	assert_int_equal(model_load(path, &log, &model), 0);
	return model;
}

static void test_loading_gives_up_and_says_nothing(void **state)
{
	static const char *const paths[] = {walker,
		"tests/fixtures/xfile/tower_text.x",
		"tests/fixtures/xfile/tower_binary.x"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(paths); i++) {
		struct log_capture capture;
		struct log log = log_capture_begin(&capture);
		struct model *model;

		ask();
		assert_int_equal(model_load(paths[i], &log, &model), -EINTR);
		stop_release();
		assert_null(model);
		assert_int_equal(capture.count, 0);
	}
}

static void test_decoding_gives_up_and_says_nothing(void **state)
{
	static const char *const names[] = {"gray.png", "red and blue.jpg"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(names); i++) {
		struct log_capture capture;
		struct log log = log_capture_begin(&capture);
		struct arena arena = arena_empty();
		struct model_image image;
		char path[64];
		static uint8_t data[65536];
		FILE *file;
		size_t size;

		snprintf(path, sizeof(path), "tests/fixtures/pictures/%s",
			names[i]);
		file = file_open(path);
		assert_non_null(file);
		size = fread(data, 1, sizeof(data), file);
		fclose(file);
		ask();
		assert_int_equal(
			image_decode(data, size, "HERE", &log, &arena, &image),
			-EINTR);
		stop_release();
		assert_int_equal(capture.count, 0);
		arena_release(&arena);
	}
}

static void test_levels_give_up(void **state)
{
	struct model *model = load(walker);

	(void)state;
	ask();
	assert_int_equal(levels_make(model), -EINTR);
	stop_release();
	model_destroy(model);
}

static void test_textures_give_up(void **state)
{
	struct model *model = load("tests/fixtures/gltf/material/textures.gltf");
	struct log log = log_to_nowhere();
	struct gl gl = texture_sent_begin();
	struct texture_set set;

	(void)state;
	ask();
	assert_int_equal(
		texture_set_create(&set, model, &gl, PIXELS_RGB565, &log),
		-EINTR);
	stop_release();
	model_destroy(model);
}

static void test_instances_give_up(void **state)
{
	struct model *model = load(walker);
	struct log log = log_to_nowhere();
	struct instance *instance;

	(void)state;
	ask();
	assert_int_not_equal(
		instance_create(model, kernel_find("fixed"), &log, &instance),
		0);
	stop_release();
	model_destroy(model);
}

/* The box is not used. */
static void test_the_samples_of_a_clip_give_up(void **state)
{
	struct model *model = load(walker);
	struct log log = log_to_nowhere();
	struct instance *instance;
	struct bounds box;

	(void)state;
	assert_int_equal(
		instance_create(model, kernel_find("fixed"), &log, &instance),
		0);
	ask();
	box = bounds_of_clip(instance, 0);
	stop_release();
	assert_true(bounds_is_empty(&box));
	instance_destroy(instance);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_loading_gives_up_and_says_nothing),
		cmocka_unit_test(test_decoding_gives_up_and_says_nothing),
		cmocka_unit_test(test_levels_give_up),
		cmocka_unit_test(test_textures_give_up),
		cmocka_unit_test(test_instances_give_up),
		cmocka_unit_test(test_the_samples_of_a_clip_give_up),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
