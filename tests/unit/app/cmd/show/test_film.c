/* Which pictures a film gets, and when. */
#include "app/cmd/show/film.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum {
	WIDTH = 4,
	HEIGHT = 2,
	PLANES = WIDTH * HEIGHT + 2 * (WIDTH / 2) * (HEIGHT / 2)
};

/* A film of 10 pictures a second in a folder of its own. */
struct scene {
	struct test_path folder, path;
	struct log_capture logged;
	struct log log;
	struct film film;
	uint8_t data[WIDTH * HEIGHT * 4];
	struct pixels picture;
};

static int setup(void **state)
{
	struct scene *scene = calloc(1, sizeof(*scene));

	assert_non_null(scene);
	scene->folder = temp_dir_make();
	scene->path = path_join(&scene->folder, "film.y4m");
	scene->log = log_capture_begin(&scene->logged);
	scene->picture = (struct pixels){.data = scene->data,
		.width = WIDTH,
		.height = HEIGHT,
		.stride_bytes = WIDTH * 4,
		.format = PIXELS_RGBA8888};
	assert_int_equal(film_open(&scene->film, scene->path.text,
				 &scene->picture, 10.0, 0, &scene->log),
		0);
	*state = scene;
	return 0;
}

static int teardown(void **state)
{
	struct scene *scene = *state;

	temp_dir_remove(&scene->folder);
	free(scene);
	return 0;
}

/* Adds a gray picture of that brightness. */
static void add(struct scene *scene, uint8_t gray, double now_s)
{
	memset(scene->data, gray, sizeof(scene->data));
	assert_int_equal(film_add(&scene->film, &scene->picture, now_s), 0);
}

/* Fails the test unless the film's pictures are of these brightnesses. */
static void expect_film(struct scene *scene, const char *grays)
{
	size_t size, count = 0;
	char *text, *at, *end;
	int last = -1;

	assert_int_equal(film_close(&scene->film), 0);
	assert_null(scene->film.display);
	text = file_read(scene->path.text, &size);
	end = text + size;
	at = memchr(text, '\n', size);
	assert_non_null(at);
	for (at++; at < end; at += 6 + PLANES) {
		assert_memory_equal(at, "FRAME\n", 6);
		assert_true(count < strlen(grays));
		/* A digit is the number of the picture. */
		if (count > 0) {
			assert_int_equal((uint8_t)at[6] > last,
				grays[count] > grays[count - 1]);
		}
		last = (uint8_t)at[6];
		count++;
	}
	assert_int_equal(count, strlen(grays));
	free(text);
}

static void test_frames_at_the_films_rate_are_all_taken(void **state)
{
	struct scene *scene = *state;

	for (int i = 0; i < 5; i++) {
		add(scene, (uint8_t)(50 + 40 * i), 7.0 + i / 10.0);
	}
	expect_film(scene, "12345");
	assert_int_equal(scene->logged.count, 0);
}

static void test_fast_frames_are_left_out(void **state)
{
	struct scene *scene = *state;

	add(scene, 50, 0.0);
	add(scene, 100, 0.04);
	add(scene, 150, 0.08);
	add(scene, 200, 0.1);
	add(scene, 250, 0.19);
	expect_film(scene, "14");
}

static void test_slow_frames_are_repeated(void **state)
{
	struct scene *scene = *state;

	add(scene, 50, 0.0);
	add(scene, 100, 0.35);
	expect_film(scene, "1222");
}

static void test_a_frame_may_be_a_thousandth_early(void **state)
{
	struct scene *scene = *state;

	add(scene, 50, 0.0);
	add(scene, 100, 0.0998);
	add(scene, 150, 0.09995);
	expect_film(scene, "13");
}

static void test_a_long_pause_is_cut_out(void **state)
{
	struct scene *scene = *state;

	add(scene, 50, 0.0);
	add(scene, 100, 5.2);
	add(scene, 150, 5.3);
	expect_film(scene, "123");
}

static void test_a_pause_of_five_seconds_is_filled(void **state)
{
	struct scene *scene = *state;
	char grays[53] = "1";

	memset(grays + 1, '2', 50);
	add(scene, 50, 0.0);
	add(scene, 100, 5.04);
	expect_film(scene, grays);
}

static void test_pictures_of_another_size_are_left_out(void **state)
{
	struct scene *scene = *state;

	add(scene, 50, 0.0);
	scene->picture.width = WIDTH - 1;
	add(scene, 100, 0.1);
	/* Of many such pictures, the first is warned about. */
	assert_int_equal(scene->logged.count, 1);
	scene->picture.width = WIDTH;
	scene->picture.height = HEIGHT - 1;
	add(scene, 100, 0.2);
	assert_int_equal(scene->logged.count, 1);
	assert_contains(scene->logged.sentence[0], "size of the pictures");
	scene->picture.height = HEIGHT;
	add(scene, 150, 0.3);
	expect_film(scene, "1222");
}

static void test_a_film_without_pictures_leaves_the_old_file(void **state)
{
	struct scene *scene = *state;
	char *text;

	file_write(scene->path.text, "old", 3);
	assert_int_equal(film_close(&scene->film), 0);
	text = file_read(scene->path.text, NULL);
	assert_string_equal(text, "old");
	free(text);
	assert_int_equal(temp_dir_count(&scene->folder), 1);
}

static void test_without_a_film_nothing_is_done(void **state)
{
	struct scene *scene = *state;
	struct film none = {.display = NULL};

	assert_int_equal(film_add(&none, &scene->picture, 0.0), 0);
	assert_int_equal(film_close(&none), 0);
	assert_int_equal(film_close(&scene->film), 0);
	assert_int_equal(film_close(&scene->film), 0);
}

static void test_a_film_that_cannot_be_written_is_an_error(void **state)
{
	struct scene *scene = *state;
	struct test_path nowhere = path_join(&scene->folder, "none/film.gif");
	struct film film;

	assert_int_equal(film_close(&scene->film), 0);
	assert_int_equal(film_open(&film, nowhere.text, &scene->picture, 10.0,
				 0, &scene->log),
		-ENOENT);
	assert_int_equal(scene->logged.count, 1);
	assert_contains(scene->logged.sentence[0], nowhere.text);
}

int main(void)
{
#define CASE(name) cmocka_unit_test_setup_teardown(name, setup, teardown)
	const struct CMUnitTest tests[] = {
		CASE(test_frames_at_the_films_rate_are_all_taken),
		CASE(test_fast_frames_are_left_out),
		CASE(test_slow_frames_are_repeated),
		CASE(test_a_frame_may_be_a_thousandth_early),
		CASE(test_a_long_pause_is_cut_out),
		CASE(test_a_pause_of_five_seconds_is_filled),
		CASE(test_pictures_of_another_size_are_left_out),
		CASE(test_a_film_without_pictures_leaves_the_old_file),
		CASE(test_without_a_film_nothing_is_done),
		CASE(test_a_film_that_cannot_be_written_is_an_error),
	};
#undef CASE

	return cmocka_run_group_tests(tests, NULL, NULL);
}
