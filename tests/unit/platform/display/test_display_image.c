#include "tests/support/files.h"
#include "tests/support/gl/image_scene.h"
#include "tests/support/test.h"

#include <errno.h>
#include <png.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

static bool is_there(const struct image_scene *scene, const char *name)
{
	struct test_path path = path_join(&scene->directory, name);
	struct stat status;

	return stat(path.text, &status) == 0;
}

static void expect_png(
	const struct image_scene *scene, const char *name, int frame)
{
	struct test_path path = path_join(&scene->directory, name);
	static uint8_t rgba[IMAGE_SCENE_HEIGHT][IMAGE_SCENE_WIDTH][4];
	png_image image = {.version = PNG_IMAGE_VERSION};

	assert_true(png_image_begin_read_from_file(&image, path.text));
	assert_int_equal(image.width, IMAGE_SCENE_WIDTH);
	assert_int_equal(image.height, IMAGE_SCENE_HEIGHT);
	assert_int_equal(image.format & PNG_FORMAT_FLAG_ALPHA, 0);
	image.format = PNG_FORMAT_RGBA;
	assert_true(png_image_finish_read(&image, NULL, rgba, 0, NULL));
	for (int y = 0; y < IMAGE_SCENE_HEIGHT; y++) {
		for (int x = 0; x < IMAGE_SCENE_WIDTH; x++) {
			uint8_t expected[4] = {0, 0, 0, 255};

			image_scene_color(frame, x, y, expected);
			assert_memory_equal(rgba[y][x], expected, 4);
		}
	}
}

static void test_one_png_has_the_files_name(void **state)
{
	struct image_scene scene;

	(void)state;
	image_scene_open(&scene, "one.png", 1, 30);
	image_scene_draw_all(&scene, 1);
	expect_png(&scene, "one.png", 0);
	assert_int_equal(temp_dir_count(&scene.directory), 1);
	image_scene_close(&scene);
}

static void test_several_pngs_are_numbered(void **state)
{
	struct image_scene scene;

	(void)state;
	image_scene_open(&scene, "walk.PNG", 3, 30);
	image_scene_draw_all(&scene, 3);
	expect_png(&scene, "walk-0001.png", 0);
	expect_png(&scene, "walk-0002.png", 1);
	expect_png(&scene, "walk-0003.png", 2);
	assert_false(is_there(&scene, "walk.PNG"));
	assert_false(is_there(&scene, "walk-0004.png"));
	image_scene_close(&scene);
}

static void test_an_unknown_number_of_pngs_is_numbered(void **state)
{
	struct image_scene scene;

	(void)state;
	image_scene_open(&scene, "x.png", 0, 30);
	image_scene_draw_all(&scene, 1);
	expect_png(&scene, "x-0001.png", 0);
	image_scene_close(&scene);
}

static void test_a_y4m_holds_header_and_planes(void **state)
{
	static const char header[] =
		"YUV4MPEG2 W37 H21 F30:1 Ip A1:1 C420jpeg XYSCSS=420JPEG XCOLORRANGE=LIMITED\n";
	size_t frame_size = 6 + 37 * 21 + 2 * 19 * 11;
	struct image_scene scene;
	size_t size;
	char *bytes;
	const uint8_t *luma, *cb, *cr;

	(void)state;
	image_scene_open(&scene, "walk.y4m", 3, 30);
	image_scene_draw_all(&scene, 3);
	bytes = file_read(scene.path.text, &size);
	assert_int_equal(size, strlen(header) + 3 * frame_size);
	assert_memory_equal(bytes, header, strlen(header));
	assert_memory_equal(
		bytes + strlen(header) + 2 * frame_size, "FRAME\n", 6);
	/* Rows 7 and 8 of the first frame begin with the square. */
	luma = (const uint8_t *)bytes + strlen(header) + 6;
	cb = luma + 37 * 21 + 19 * 3;
	cr = cb + 19 * 11;
	/* BT.601 of (250, 10, 20): 87.2, 93.9 and 232.7. */
	assert_int_equal(luma[37 * 7], 87);
	assert_int_equal(cb[0], 97);
	assert_int_equal(cr[0], 233);
	free(bytes);
	image_scene_close(&scene);
}

/* Limited range; 16 to 235, and 16 to 240 around 128. */
static void expect_bt601(
	double red, double green, double blue, int luma, int cb, int cr)
{
	/* The coefficients have 16 bits, so that a sum is off by 0.01. */
	const double near = 0.51;

	if (luma >= 0) {
		assert_near(luma,
			16 + (65.481 * red + 128.553 * green + 24.966 * blue) / 255,
			near);
	}
	if (cb >= 0) {
		assert_near(cb,
			128 + (-37.797 * red - 74.203 * green + 112 * blue) / 255,
			near);
		assert_near(cr,
			128 + (112 * red - 93.786 * green - 18.214 * blue) / 255,
			near);
	}
}

static void test_a_y4m_rounds_each_pixel_to_the_nearest(void **state)
{
	enum {
		WIDTH = IMAGE_SCENE_WIDTH,
		HEIGHT = IMAGE_SCENE_HEIGHT,
		HALF_WIDTH = (WIDTH + 1) / 2,
		HALF = HALF_WIDTH * ((HEIGHT + 1) / 2)
	};
	struct image_scene scene;
	const uint8_t *plane;
	char *bytes;

	(void)state;
	image_scene_open(&scene, "one.y4m", 1, 30);
	image_scene_draw_all(&scene, 1);
	bytes = file_read(scene.path.text, NULL);
	plane = (const uint8_t *)strstr(bytes, "FRAME\n") + 6;
	for (int i = 0; i < WIDTH * HEIGHT; i++) {
		uint8_t rgb[3];

		image_scene_color(0, i % WIDTH, i / WIDTH, rgb);
		expect_bt601(rgb[0], rgb[1], rgb[2], plane[i], -1, -1);
	}
	plane += WIDTH * HEIGHT;
	for (int i = 0; i < HALF; i++) {
		double mean[3] = {0, 0, 0};

		for (int k = 0; k < 4; k++) {
			int x = i % HALF_WIDTH * 2 + k % 2;
			int y = i / HALF_WIDTH * 2 + k / 2;
			uint8_t rgb[3];

			/* The last column and row count twice. */
			image_scene_color(0, x < WIDTH ? x : WIDTH - 1,
				y < HEIGHT ? y : HEIGHT - 1, rgb);
			for (int c = 0; c < 3; c++) {
				mean[c] += rgb[c] / 4.0;
			}
		}
		expect_bt601(mean[0], mean[1], mean[2], -1, plane[i],
			plane[HALF + i]);
	}
	free(bytes);
	image_scene_close(&scene);
}

static void expect_rate(double rate_hz, const char *expected)
{
	struct image_scene scene;
	char *bytes;

	image_scene_open(&scene, "x.y4m", 1, rate_hz);
	image_scene_draw_all(&scene, 1);
	bytes = file_read(scene.path.text, NULL);
	*strchr(bytes, '\n') = '\0';
	assert_contains(bytes, expected);
	free(bytes);
	image_scene_close(&scene);
}

static void test_a_y4m_states_its_rate_as_a_fraction(void **state)
{
	(void)state;
	expect_rate(25, " F25:1 ");
	expect_rate(29.97, " F30000:1001 ");
	expect_rate(12.5, " F12500:1000 ");
	expect_rate(60, " F60:1 ");
	expect_rate(1000, " F1000:1 ");
	expect_rate(0.001, " F1:1000 ");
	expect_rate(0.005, " F5:1000 ");
	expect_rate(24.001, " F24001:1000 ");
	expect_rate(1.005, " F1005:1000 ");
	expect_rate(5.99, " F5990:1000 ");
	expect_rate(9.99, " F10000:1001 ");
	/* NTSC's rates are taken as such within a hundredth. */
	expect_rate(23.976, " F24000:1001 ");
	expect_rate(23.98, " F24000:1001 ");
	expect_rate(23.967, " F24000:1001 ");
	expect_rate(23.965, " F23965:1000 ");
	expect_rate(23.987, " F23987:1000 ");
}

static void test_an_unknown_extension_lists_the_known_ones(void **state)
{
	static const char *const names[] = {
		"/tmp/x.jpg", "/tmp/png", "/tmp/x.png.gz", ".png"};
	struct image_scene scene;

	(void)state;
	for (size_t i = 0; i < sizeof(names) / sizeof(names[0]); i++) {
		scene.log = log_capture_begin(&scene.capture);
		assert_int_equal(
			image_scene_open_at(&scene, names[i], 1, 30), -EINVAL);
		assert_int_equal(scene.capture.count, 1);
		assert_contains(scene.capture.sentence[0], names[i]);
		assert_contains(scene.capture.sentence[0], ".png, .gif, .y4m");
	}
}

static void test_a_missing_file_name_is_refused(void **state)
{
	struct image_scene scene;

	(void)state;
	scene.log = log_capture_begin(&scene.capture);
	assert_int_equal(image_scene_open_at(&scene, NULL, 1, 30), -EINVAL);
	assert_int_equal(image_scene_open_at(&scene, "", 1, 30), -EINVAL);
	assert_int_equal(scene.capture.count, 2);
	assert_contains(scene.capture.sentence[0], "-o FILE");
}

static void test_the_message_names_a_missing_folder(void **state)
{
	static const char *const names[] = {
		"/nowhere/at/all/x.gif", "/nowhere/at/all/x.y4m"};
	struct image_scene scene;

	(void)state;
	for (int i = 0; i < 2; i++) {
		scene.log = log_capture_begin(&scene.capture);
		assert_int_equal(
			image_scene_open_at(&scene, names[i], 1, 30), -ENOENT);
		assert_int_equal(scene.capture.count, 1);
		assert_contains(scene.capture.sentence[0], names[i]);
	}
	scene.log = log_capture_begin(&scene.capture);
	assert_int_equal(
		image_scene_open_at(&scene, "/nowhere/at/all/x.png", 1, 30), 0);
	assert_int_equal(image_scene_draw(&scene, 0), -ENOENT);
	assert_int_equal(scene.capture.count, 1);
	assert_contains(scene.capture.sentence[0], "/nowhere/at/all/x.png");
	scene.driver->destroy(scene.display);
}

static void test_a_folder_of_that_name_is_refused(void **state)
{
	struct test_path directory = temp_dir_make();
	struct test_path path = path_join(&directory, "x.gif");
	struct image_scene scene;

	(void)state;
	assert_int_equal(mkdir(path.text, 0700), 0);
	scene.log = log_capture_begin(&scene.capture);
	assert_int_equal(image_scene_open_at(&scene, path.text, 1, 30), -EISDIR);
	assert_contains(scene.capture.sentence[0], "directory");
	temp_dir_remove(&directory);
}

/* Checks that only the old file is left. */
static void expect_untouched(const struct image_scene *scene)
{
	size_t size;
	char *bytes = file_read(scene->path.text, &size);

	assert_int_equal(size, 3);
	assert_memory_equal(bytes, "old", 3);
	free(bytes);
	assert_int_equal(temp_dir_count(&scene->directory), 1);
}

static void test_an_unfinished_file_leaves_the_old_one(void **state)
{
	static const char *const names[] = {"x.gif", "x.y4m"};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct image_scene scene;

		image_scene_open(&scene, names[i], 5, 30);
		file_write(scene.path.text, "old", 3);
		assert_int_equal(image_scene_draw(&scene, 0), 0);
		scene.driver->destroy(scene.display);
		expect_untouched(&scene);
		temp_dir_remove(&scene.directory);
	}
}

static int draw_until_failure(struct image_scene *scene)
{
	int error = 0;

	for (int i = 0; i < 200 && !error; i++) {
		error = image_scene_draw(scene, i % 15);
	}
	return error ? error : scene->driver->finish(scene->display);
}

static void test_a_full_disk_is_reported_once_and_leaves_the_old_file(
	void **state)
{
	static const char *const names[] = {"x.png", "x.gif", "x.y4m"};
	/* Limits the size of files, which acts like a full disk. */
	struct rlimit small, usual;

	(void)state;
	assert_int_equal(getrlimit(RLIMIT_FSIZE, &usual), 0);
	small = (struct rlimit){60, usual.rlim_max};
	signal(SIGXFSZ, SIG_IGN);
	for (int i = 0; i < 3; i++) {
		struct image_scene scene;
		int error;

		image_scene_open(&scene, names[i], 1, 30);
		file_write(scene.path.text, "old", 3);
		assert_int_equal(setrlimit(RLIMIT_FSIZE, &small), 0);
		error = draw_until_failure(&scene);
		assert_int_equal(setrlimit(RLIMIT_FSIZE, &usual), 0);
		assert_int_equal(error, -EFBIG);
		assert_int_equal(scene.capture.count, 1);
		assert_contains(scene.capture.sentence[0], names[i]);
		scene.driver->destroy(scene.display);
		expect_untouched(&scene);
		temp_dir_remove(&scene.directory);
	}
}

static void test_an_animation_without_frames_makes_no_file(void **state)
{
	struct image_scene scene;

	(void)state;
	image_scene_open(&scene, "x.gif", 0, 30);
	assert_int_equal(scene.driver->finish(scene.display), -EIO);
	assert_int_equal(scene.capture.count, 1);
	assert_false(is_there(&scene, "x.gif"));
	image_scene_close(&scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_one_png_has_the_files_name),
		cmocka_unit_test(test_several_pngs_are_numbered),
		cmocka_unit_test(test_an_unknown_number_of_pngs_is_numbered),
		cmocka_unit_test(test_a_y4m_holds_header_and_planes),
		cmocka_unit_test(test_a_y4m_rounds_each_pixel_to_the_nearest),
		cmocka_unit_test(test_a_y4m_states_its_rate_as_a_fraction),
		cmocka_unit_test(test_an_unknown_extension_lists_the_known_ones),
		cmocka_unit_test(test_a_missing_file_name_is_refused),
		cmocka_unit_test(test_the_message_names_a_missing_folder),
		cmocka_unit_test(test_a_folder_of_that_name_is_refused),
		cmocka_unit_test(test_an_unfinished_file_leaves_the_old_one),
		cmocka_unit_test(
			test_a_full_disk_is_reported_once_and_leaves_the_old_file),
		cmocka_unit_test(test_an_animation_without_frames_makes_no_file),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
