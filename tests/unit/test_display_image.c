#include "platform/display/display.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <gif_lib.h>
#include <png.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
	WIDTH = 37,
	HEIGHT = 21
};

/* A display that writes to a file in a folder of its own. */
struct scene {
	const struct display_driver *driver;
	struct display *display;
	struct test_path directory, path;
	struct log_capture capture;
	struct log log;
};

static int open_at(
	struct scene *scene, const char *path, int frame_count, double rate_hz)
{
	const struct display_options options = {
		.width = WIDTH,
		.height = HEIGHT,
		.output = path,
		.frame_count = frame_count,
		.rate_hz = rate_hz,
		.log = &scene->log,
	};

	scene->driver = display_find("image");
	assert_non_null(scene->driver);
	scene->display = NULL;
	return scene->driver->create(&options, &scene->display);
}

static void scene_open(
	struct scene *scene, const char *name, int frame_count, double rate_hz)
{
	scene->directory = temp_dir_make();
	scene->path = path_join(&scene->directory, name);
	scene->log = log_capture_begin(&scene->capture);
	assert_int_equal(
		open_at(scene, scene->path.text, frame_count, rate_hz), 0);
}

static void scene_close(struct scene *scene)
{
	scene->driver->destroy(scene->display);
	temp_dir_remove(&scene->directory);
}

/* What frame f shows at (x, y): a gradient, and a square that walks. */
static void color_at(int frame, int x, int y, uint8_t rgb[3])
{
	bool square = x >= 2 * frame && x < 2 * frame + 5 && y >= 5 && y < 10;

	rgb[0] = square ? 250 : (uint8_t)(6 * x);
	rgb[1] = square ? 10 : (uint8_t)(12 * y);
	rgb[2] = square ? 20 : 60;
}

static int draw(struct scene *scene, int frame)
{
	struct pixels pixels;

	assert_int_equal(scene->driver->begin_frame(scene->display, &pixels), 0);
	assert_int_equal(pixels.format, PIXELS_RGBA8888);
	assert_int_equal(pixels.width, WIDTH);
	assert_int_equal(pixels.height, HEIGHT);
	for (int y = 0; y < HEIGHT; y++) {
		for (int x = 0; x < WIDTH; x++) {
			uint8_t *pixel =
				pixels.data + y * pixels.stride_bytes + 4 * x;

			color_at(frame, x, y, pixel);
			/* What is in alpha does not matter. */
			pixel[3] = (uint8_t)(x + frame);
		}
	}
	return scene->driver->end_frame(scene->display);
}

static void draw_all(struct scene *scene, int count)
{
	for (int i = 0; i < count; i++) {
		assert_int_equal(draw(scene, i), 0);
	}
	assert_int_equal(scene->driver->finish(scene->display), 0);
	assert_int_equal(scene->capture.count, 0);
}

static bool is_there(const struct scene *scene, const char *name)
{
	struct test_path path = path_join(&scene->directory, name);
	struct stat status;

	return stat(path.text, &status) == 0;
}

static void expect_png(const struct scene *scene, const char *name, int frame)
{
	struct test_path path = path_join(&scene->directory, name);
	static uint8_t rgba[HEIGHT][WIDTH][4];
	png_image image = {.version = PNG_IMAGE_VERSION};

	assert_true(png_image_begin_read_from_file(&image, path.text));
	assert_int_equal(image.width, WIDTH);
	assert_int_equal(image.height, HEIGHT);
	assert_int_equal(image.format & PNG_FORMAT_FLAG_ALPHA, 0);
	image.format = PNG_FORMAT_RGBA;
	assert_true(png_image_finish_read(&image, NULL, rgba, 0, NULL));
	for (int y = 0; y < HEIGHT; y++) {
		for (int x = 0; x < WIDTH; x++) {
			uint8_t expected[4] = {0, 0, 0, 255};

			color_at(frame, x, y, expected);
			assert_memory_equal(rgba[y][x], expected, 4);
		}
	}
}

static void test_one_png_has_the_files_name(void **state)
{
	struct scene scene;

	(void)state;
	scene_open(&scene, "one.png", 1, 30);
	draw_all(&scene, 1);
	expect_png(&scene, "one.png", 0);
	assert_false(is_there(&scene, "one.png.part"));
	scene_close(&scene);
}

static void test_several_pngs_are_numbered(void **state)
{
	struct scene scene;

	(void)state;
	scene_open(&scene, "walk.PNG", 3, 30);
	draw_all(&scene, 3);
	expect_png(&scene, "walk-0001.png", 0);
	expect_png(&scene, "walk-0002.png", 1);
	expect_png(&scene, "walk-0003.png", 2);
	assert_false(is_there(&scene, "walk.PNG"));
	assert_false(is_there(&scene, "walk-0004.png"));
	scene_close(&scene);
}

static void test_an_unknown_number_of_pngs_is_numbered(void **state)
{
	struct scene scene;

	(void)state;
	scene_open(&scene, "x.png", 0, 30);
	draw_all(&scene, 1);
	expect_png(&scene, "x-0001.png", 0);
	scene_close(&scene);
}

/* One picture of a GIF as it is shown, and its delay. */
struct shown {
	uint8_t rgb[HEIGHT][WIDTH][3];
	int delay_cs;
};

static void paste(const GifFileType *gif, int number, struct shown *shown)
{
	const SavedImage *image = &gif->SavedImages[number];
	const GifImageDesc *place = &image->ImageDesc;
	const ColorMapObject *map =
		place->ColorMap ? place->ColorMap : gif->SColorMap;
	GraphicsControlBlock control;

	assert_int_equal(DGifSavedExtensionToGCB((GifFileType *)(uintptr_t)gif,
				 number, &control),
		GIF_OK);
	assert_int_equal(control.DisposalMode, DISPOSE_DO_NOT);
	shown->delay_cs = control.DelayTime;
	for (int i = 0; i < place->Width * place->Height; i++) {
		int index = image->RasterBits[i];
		int x = place->Left + i % place->Width;
		int y = place->Top + i / place->Width;

		if (index != control.TransparentColor) {
			assert_in_range(index, 0, map->ColorCount - 1);
			shown->rgb[y][x][0] = map->Colors[index].Red;
			shown->rgb[y][x][1] = map->Colors[index].Green;
			shown->rgb[y][x][2] = map->Colors[index].Blue;
		}
	}
}

static GifFileType *read_gif(const struct scene *scene)
{
	int error;
	GifFileType *gif = DGifOpenFileName(scene->path.text, &error);

	assert_non_null(gif);
	assert_int_equal(DGifSlurp(gif), GIF_OK);
	assert_int_equal(gif->SWidth, WIDTH);
	assert_int_equal(gif->SHeight, HEIGHT);
	return gif;
}

static void test_a_gif_shows_every_frame(void **state)
{
	struct scene scene;
	struct shown shown = {0};
	GifFileType *gif;
	int error;

	(void)state;
	scene_open(&scene, "walk.gif", 12, 25);
	draw_all(&scene, 12);
	gif = read_gif(&scene);
	assert_int_equal(gif->ImageCount, 12);
	for (int frame = 0; frame < 12; frame++) {
		long difference = 0;

		paste(gif, frame, &shown);
		for (int y = 0; y < HEIGHT; y++) {
			for (int x = 0; x < WIDTH; x++) {
				uint8_t expected[3];
				bool square;

				color_at(frame, x, y, expected);
				square = expected[0] == 250;
				for (int i = 0; i < 3; i++) {
					int away = abs(shown.rgb[y][x][i] -
						expected[i]);

					difference += away;
					assert_in_range(
						away, 0, square ? 24 : 60);
				}
			}
		}
		assert_true(difference < 5 * WIDTH * HEIGHT * 3);
		assert_int_equal(shown.delay_cs, 4);
	}
	DGifCloseFile(gif, &error);
	scene_close(&scene);
}

static void test_a_gif_stores_only_what_changes(void **state)
{
	struct scene scene;
	GifFileType *gif;
	int error;

	(void)state;
	scene_open(&scene, "walk.gif", 3, 25);
	assert_int_equal(draw(&scene, 0), 0);
	assert_int_equal(draw(&scene, 1), 0);
	assert_int_equal(draw(&scene, 1), 0);
	assert_int_equal(scene.driver->finish(scene.display), 0);
	gif = read_gif(&scene);
	assert_int_equal(gif->SavedImages[0].ImageDesc.Width, WIDTH);
	assert_int_equal(gif->SavedImages[1].ImageDesc.Left, 0);
	assert_int_equal(gif->SavedImages[1].ImageDesc.Width, 7);
	assert_int_equal(gif->SavedImages[1].ImageDesc.Top, 5);
	assert_int_equal(gif->SavedImages[1].ImageDesc.Height, 5);
	assert_int_equal(gif->SavedImages[2].ImageDesc.Width, 1);
	assert_int_equal(gif->SavedImages[2].ImageDesc.Height, 1);
	DGifCloseFile(gif, &error);
	scene_close(&scene);
}

static void test_a_gif_repeats_for_ever(void **state)
{
	static const char loop[] = "\x21\xff\x0bNETSCAPE2.0\x03\x01\x00\x00";
	struct scene scene;
	size_t size;
	char *bytes;
	bool found = false;

	(void)state;
	scene_open(&scene, "x.gif", 2, 25);
	draw_all(&scene, 2);
	bytes = file_read(scene.path.text, &size);
	assert_memory_equal(bytes, "GIF89a", 6);
	for (size_t i = 0; i + sizeof(loop) <= size; i++) {
		found |= memcmp(bytes + i, loop, sizeof(loop)) == 0;
	}
	assert_true(found);
	free(bytes);
	scene_close(&scene);
}

/* The delays of count frames at a rate; returns how many frames there are. */
static int read_delays(double rate_hz, int count, int *out)
{
	struct scene scene;
	struct shown shown;
	GifFileType *gif;
	int kept, error;

	scene_open(&scene, "x.gif", count, rate_hz);
	draw_all(&scene, count);
	gif = read_gif(&scene);
	kept = gif->ImageCount;
	for (int i = 0; i < kept; i++) {
		paste(gif, i, &shown);
		out[i] = shown.delay_cs;
	}
	DGifCloseFile(gif, &error);
	scene_close(&scene);
	return kept;
}

static void test_gif_delays_do_not_drift(void **state)
{
	int delays[60];
	int sum = 0;

	(void)state;
	assert_int_equal(read_delays(30, 60, delays), 60);
	for (int i = 0; i < 60; i++) {
		assert_in_range(delays[i], 3, 4);
		sum += delays[i];
		/* Within half a hundredth of the true time. */
		assert_near(sum, (i + 1) * 100.0 / 30, 0.5 + 1e-9);
	}
	assert_int_equal(sum, 200);
}

static void test_a_gif_leaves_out_what_players_would_slow_down(void **state)
{
	int delays[60];
	int sum = 0;
	int count;

	(void)state;
	count = read_delays(60, 60, delays);
	assert_in_range(count, 40, 50);
	for (int i = 0; i < count; i++) {
		assert_true(delays[i] >= 2);
		sum += delays[i];
	}
	assert_near(sum, 100, 1);
}

static void test_a_gif_takes_new_colours_for_a_new_scene(void **state)
{
	struct scene scene;
	struct shown shown = {0};
	struct pixels pixels;
	GifFileType *gif;
	int error;

	(void)state;
	scene_open(&scene, "cut.gif", 3, 25);
	for (int frame = 0; frame < 3; frame++) {
		scene.driver->begin_frame(scene.display, &pixels);
		for (int i = 0; i < WIDTH * HEIGHT; i++) {
			uint8_t *pixel = pixels.data + 4 * i;

			/* Shades of red, then of blue. */
			memset(pixel, 0, 3);
			pixel[frame ? 2 : 0] = (uint8_t)(i % 256);
		}
		assert_int_equal(scene.driver->end_frame(scene.display), 0);
	}
	assert_int_equal(scene.driver->finish(scene.display), 0);
	gif = read_gif(&scene);
	assert_null(gif->SavedImages[0].ImageDesc.ColorMap);
	assert_non_null(gif->SavedImages[1].ImageDesc.ColorMap);
	paste(gif, 0, &shown);
	paste(gif, 1, &shown);
	paste(gif, 2, &shown);
	for (int i = 0; i < WIDTH * HEIGHT; i++) {
		const uint8_t *rgb = shown.rgb[i / WIDTH][i % WIDTH];

		assert_in_range(rgb[0], 0, 2);
		assert_in_range(abs(rgb[2] - i % 256), 0, 4);
	}
	DGifCloseFile(gif, &error);
	scene_close(&scene);
}

static void test_a_y4m_holds_header_and_planes(void **state)
{
	static const char header[] =
		"YUV4MPEG2 W37 H21 F30:1 Ip A1:1 C420jpeg XYSCSS=420JPEG "
		"XCOLORRANGE=LIMITED\n";
	size_t frame_size = 6 + 37 * 21 + 2 * 19 * 11;
	struct scene scene;
	size_t size;
	char *bytes;
	const uint8_t *luma, *cb, *cr;

	(void)state;
	scene_open(&scene, "walk.y4m", 3, 30);
	draw_all(&scene, 3);
	bytes = file_read(scene.path.text, &size);
	assert_int_equal(size, strlen(header) + 3 * frame_size);
	assert_memory_equal(bytes, header, strlen(header));
	assert_memory_equal(
		bytes + strlen(header) + 2 * frame_size, "FRAME\n", 6);
	/* Row 7 and 8 of the first frame begin with the square. */
	luma = (const uint8_t *)bytes + strlen(header) + 6;
	cb = luma + 37 * 21 + 19 * 3;
	cr = cb + 19 * 11;
	/* BT.601 of (250, 10, 20): 87.2, 93.9 and 232.7. */
	assert_int_equal(luma[37 * 7], 87);
	assert_int_equal(cb[0], 97);
	assert_int_equal(cr[0], 233);
	free(bytes);
	scene_close(&scene);
}

static void expect_rate(double rate_hz, const char *expected)
{
	struct scene scene;
	char *bytes;

	scene_open(&scene, "x.y4m", 1, rate_hz);
	draw_all(&scene, 1);
	bytes = file_read(scene.path.text, NULL);
	*strchr(bytes, '\n') = '\0';
	assert_contains(bytes, expected);
	free(bytes);
	scene_close(&scene);
}

static void test_a_y4m_states_its_rate_as_a_fraction(void **state)
{
	(void)state;
	expect_rate(25, " F25:1 ");
	expect_rate(29.97, " F30000:1001 ");
	expect_rate(12.5, " F12500:1000 ");
}

static void test_an_unknown_extension_lists_the_known(void **state)
{
	static const char *const names[] = {
		"/tmp/x.jpg", "/tmp/png", "/tmp/x.png.gz", ".png"};
	struct scene scene;

	(void)state;
	for (size_t i = 0; i < sizeof(names) / sizeof(names[0]); i++) {
		scene.log = log_capture_begin(&scene.capture);
		assert_int_equal(open_at(&scene, names[i], 1, 30), -EINVAL);
		assert_int_equal(scene.capture.count, 1);
		assert_contains(scene.capture.sentence[0], names[i]);
		assert_contains(scene.capture.sentence[0], ".png, .gif, .y4m");
	}
}

static void test_a_missing_file_name_is_asked_for(void **state)
{
	struct scene scene;

	(void)state;
	scene.log = log_capture_begin(&scene.capture);
	assert_int_equal(open_at(&scene, NULL, 1, 30), -EINVAL);
	assert_int_equal(open_at(&scene, "", 1, 30), -EINVAL);
	assert_int_equal(scene.capture.count, 2);
	assert_contains(scene.capture.sentence[0], "-o FILE");
}

static void test_a_folder_that_is_not_there_is_named(void **state)
{
	static const char *const names[] = {
		"/nowhere/at/all/x.gif", "/nowhere/at/all/x.y4m"};
	struct scene scene;

	(void)state;
	for (int i = 0; i < 2; i++) {
		scene.log = log_capture_begin(&scene.capture);
		assert_int_equal(open_at(&scene, names[i], 1, 30), -ENOENT);
		assert_int_equal(scene.capture.count, 1);
		assert_contains(scene.capture.sentence[0], names[i]);
	}
	scene.log = log_capture_begin(&scene.capture);
	assert_int_equal(open_at(&scene, "/nowhere/at/all/x.png", 1, 30), 0);
	assert_int_equal(draw(&scene, 0), -ENOENT);
	assert_int_equal(scene.capture.count, 1);
	assert_contains(scene.capture.sentence[0], "/nowhere/at/all/x.png");
	scene.driver->destroy(scene.display);
}

static void test_a_folder_of_that_name_is_refused(void **state)
{
	struct test_path directory = temp_dir_make();
	struct test_path path = path_join(&directory, "x.gif");
	struct scene scene;

	(void)state;
	assert_int_equal(mkdir(path.text, 0700), 0);
	scene.log = log_capture_begin(&scene.capture);
	assert_int_equal(open_at(&scene, path.text, 1, 30), -EISDIR);
	assert_contains(scene.capture.sentence[0], "directory");
	temp_dir_remove(&directory);
}

/* What an unfinished or failed file leaves: the old one and nothing else. */
static void expect_untouched(const struct scene *scene)
{
	struct test_path part = path_join(&scene->directory, "x.part");
	size_t size;
	char *bytes = file_read(scene->path.text, &size);
	struct stat status;

	assert_int_equal(size, 3);
	assert_memory_equal(bytes, "old", 3);
	free(bytes);
	snprintf(part.text, sizeof(part.text), "%.*s.part", 500,
		scene->path.text);
	assert_int_equal(stat(part.text, &status), -1);
}

static void test_what_is_not_finished_leaves_the_old_file(void **state)
{
	static const char *const names[] = {"x.gif", "x.y4m"};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct scene scene;

		scene_open(&scene, names[i], 5, 30);
		file_write(scene.path.text, "old", 3);
		assert_int_equal(draw(&scene, 0), 0);
		scene.driver->destroy(scene.display);
		expect_untouched(&scene);
		temp_dir_remove(&scene.directory);
	}
}

static int draw_until_failure(struct scene *scene)
{
	int error = 0;

	for (int i = 0; i < 200 && !error; i++) {
		error = draw(scene, i % 15);
	}
	return error ? error : scene->driver->finish(scene->display);
}

static void test_a_full_disk_is_told_once_and_leaves_the_old_file(void **state)
{
	static const char *const names[] = {"x.png", "x.gif", "x.y4m"};
	/* A file may grow to this size: as a full disk, but repeatable. */
	const struct rlimit small = {60, RLIM_INFINITY};
	struct rlimit usual;

	(void)state;
	assert_int_equal(getrlimit(RLIMIT_FSIZE, &usual), 0);
	signal(SIGXFSZ, SIG_IGN);
	for (int i = 0; i < 3; i++) {
		struct scene scene;
		int error;

		scene_open(&scene, names[i], 1, 30);
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

static void test_an_animation_without_frames_is_no_file(void **state)
{
	struct scene scene;

	(void)state;
	scene_open(&scene, "x.gif", 0, 30);
	assert_int_equal(scene.driver->finish(scene.display), -EIO);
	assert_int_equal(scene.capture.count, 1);
	assert_false(is_there(&scene, "x.gif"));
	scene_close(&scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_one_png_has_the_files_name),
		cmocka_unit_test(test_several_pngs_are_numbered),
		cmocka_unit_test(test_an_unknown_number_of_pngs_is_numbered),
		cmocka_unit_test(test_a_gif_shows_every_frame),
		cmocka_unit_test(test_a_gif_stores_only_what_changes),
		cmocka_unit_test(test_a_gif_repeats_for_ever),
		cmocka_unit_test(test_gif_delays_do_not_drift),
		cmocka_unit_test(
			test_a_gif_leaves_out_what_players_would_slow_down),
		cmocka_unit_test(test_a_gif_takes_new_colours_for_a_new_scene),
		cmocka_unit_test(test_a_y4m_holds_header_and_planes),
		cmocka_unit_test(test_a_y4m_states_its_rate_as_a_fraction),
		cmocka_unit_test(test_an_unknown_extension_lists_the_known),
		cmocka_unit_test(test_a_missing_file_name_is_asked_for),
		cmocka_unit_test(test_a_folder_that_is_not_there_is_named),
		cmocka_unit_test(test_a_folder_of_that_name_is_refused),
		cmocka_unit_test(test_what_is_not_finished_leaves_the_old_file),
		cmocka_unit_test(
			test_a_full_disk_is_told_once_and_leaves_the_old_file),
		cmocka_unit_test(test_an_animation_without_frames_is_no_file),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
