#include "tests/support/files.h"
#include "tests/support/gl/image_scene.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <gif_lib.h>
#include <stdlib.h>
#include <string.h>

/* A picture of a GIF as a player shows it, and its delay. */
struct shown {
	uint8_t rgb[IMAGE_SCENE_HEIGHT][IMAGE_SCENE_WIDTH][3];
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

static GifFileType *read_gif(const struct image_scene *scene)
{
	int error;
	GifFileType *gif = DGifOpenFileName(scene->path.text, &error);

	assert_non_null(gif);
	assert_int_equal(DGifSlurp(gif), GIF_OK);
	assert_int_equal(gif->SWidth, IMAGE_SCENE_WIDTH);
	assert_int_equal(gif->SHeight, IMAGE_SCENE_HEIGHT);
	return gif;
}

static void test_a_gif_shows_every_frame(void **state)
{
	struct image_scene scene;
	struct shown shown = {0};
	GifFileType *gif;
	int error;

	(void)state;
	image_scene_open(&scene, "walk.gif", 12, 25);
	image_scene_draw_all(&scene, 12);
	gif = read_gif(&scene);
	assert_int_equal(gif->ImageCount, 12);
	for (int frame = 0; frame < 12; frame++) {
		long difference = 0;

		paste(gif, frame, &shown);
		for (int y = 0; y < IMAGE_SCENE_HEIGHT; y++) {
			for (int x = 0; x < IMAGE_SCENE_WIDTH; x++) {
				uint8_t expected[3];
				bool square;

				image_scene_color(frame, x, y, expected);
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
		assert_true(difference <
			5 * IMAGE_SCENE_WIDTH * IMAGE_SCENE_HEIGHT * 3);
		assert_int_equal(shown.delay_cs, 4);
	}
	DGifCloseFile(gif, &error);
	image_scene_close(&scene);
}

static void test_a_gif_stores_only_what_changes(void **state)
{
	struct image_scene scene;
	GifFileType *gif;
	int error;

	(void)state;
	image_scene_open(&scene, "walk.gif", 3, 25);
	assert_int_equal(image_scene_draw(&scene, 0), 0);
	assert_int_equal(image_scene_draw(&scene, 1), 0);
	assert_int_equal(image_scene_draw(&scene, 1), 0);
	assert_int_equal(scene.driver->finish(scene.display), 0);
	gif = read_gif(&scene);
	assert_int_equal(gif->SavedImages[0].ImageDesc.Width, IMAGE_SCENE_WIDTH);
	assert_int_equal(gif->SavedImages[1].ImageDesc.Left, 0);
	assert_int_equal(gif->SavedImages[1].ImageDesc.Width, 7);
	assert_int_equal(gif->SavedImages[1].ImageDesc.Top, 5);
	assert_int_equal(gif->SavedImages[1].ImageDesc.Height, 5);
	assert_int_equal(gif->SavedImages[2].ImageDesc.Width, 1);
	assert_int_equal(gif->SavedImages[2].ImageDesc.Height, 1);
	DGifCloseFile(gif, &error);
	image_scene_close(&scene);
}

/* Draws a grey picture in which a rectangle and one pixel are white. */
static void draw_white(struct image_scene *scene, const GifImageDesc *box)
{
	struct pixels pixels;

	assert_int_equal(scene->driver->begin_frame(scene->display, &pixels), 0);
	for (int y = 0; y < IMAGE_SCENE_HEIGHT; y++) {
		for (int x = 0; x < IMAGE_SCENE_WIDTH; x++) {
			bool white = x >= box->Left && y >= box->Top &&
				x < box->Left + box->Width &&
				y < box->Top + box->Height;

			white = white || (x == 20 && y == 10);

			memset(pixels.data + y * pixels.stride_bytes + 4 * x,
				white ? 255 : 100, 4);
		}
	}
	assert_int_equal(scene->driver->end_frame(scene->display), 0);
}

/* Also a single one in a corner: it is no empty picture. */
static void test_a_gif_stores_every_pixel_that_changes(void **state)
{
	enum {
		RIGHT = IMAGE_SCENE_WIDTH - 1,
		BOTTOM = IMAGE_SCENE_HEIGHT - 1
	};
	static const GifImageDesc boxes[] = {
		{.Left = 0, .Top = 0, .Width = 1, .Height = 1},
		{.Left = 0, .Top = 3, .Width = 1, .Height = 9},
		{.Left = 4, .Top = 0, .Width = 9, .Height = 1},
		{.Left = RIGHT, .Top = 2, .Width = 1, .Height = 5},
		{.Left = 2, .Top = BOTTOM, .Width = 7, .Height = 1},
		{.Left = RIGHT, .Top = BOTTOM, .Width = 1, .Height = 1},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(boxes) / sizeof(boxes[0]); i++) {
		const GifImageDesc *box = &boxes[i], none = {.Width = 0};
		struct shown shown = {0};
		struct image_scene scene;
		GifFileType *gif;
		int error;

		image_scene_open(&scene, "x.gif", 2, 25);
		draw_white(&scene, &none);
		draw_white(&scene, box);
		assert_int_equal(scene.driver->finish(scene.display), 0);
		gif = read_gif(&scene);
		for (int frame = 0; frame < 2; frame++) {
			paste(gif, frame, &shown);
		}
		assert_int_equal(gif->SavedImages[1].ImageDesc.Left, box->Left);
		assert_int_equal(gif->SavedImages[1].ImageDesc.Top, box->Top);
		assert_int_equal(
			gif->SavedImages[1].ImageDesc.Width, box->Width);
		assert_int_equal(
			gif->SavedImages[1].ImageDesc.Height, box->Height);
		assert_in_range(shown.rgb[box->Top][box->Left][0], 230, 255);
		DGifCloseFile(gif, &error);
		image_scene_close(&scene);
	}
}

static void test_a_gif_repeats_for_ever(void **state)
{
	static const char loop[] = "\x21\xff\x0bNETSCAPE2.0\x03\x01\x00\x00";
	struct image_scene scene;
	size_t size;
	char *bytes;
	bool found = false;

	(void)state;
	image_scene_open(&scene, "x.gif", 2, 25);
	image_scene_draw_all(&scene, 2);
	bytes = file_read(scene.path.text, &size);
	assert_memory_equal(bytes, "GIF89a", 6);
	for (size_t i = 0; i + sizeof(loop) <= size; i++) {
		found |= memcmp(bytes + i, loop, sizeof(loop)) == 0;
	}
	assert_true(found);
	free(bytes);
	image_scene_close(&scene);
}

/* The delays of count frames at a rate; returns how many frames there are. */
static int read_delays(double rate_hz, int count, int *out)
{
	struct image_scene scene;
	struct shown shown;
	GifFileType *gif;
	int kept, error;

	image_scene_open(&scene, "x.gif", count, rate_hz);
	image_scene_draw_all(&scene, count);
	gif = read_gif(&scene);
	kept = gif->ImageCount;
	for (int i = 0; i < kept; i++) {
		paste(gif, i, &shown);
		out[i] = shown.delay_cs;
	}
	DGifCloseFile(gif, &error);
	image_scene_close(&scene);
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
		/* Within half a hundredth of a second of the true time. */
		assert_near(sum, (i + 1) * 100.0 / 30, 0.5 + 1e-9);
	}
	assert_int_equal(sum, 200);
}

/* The format keeps 16 bits of a delay. */
static void test_a_gif_shows_a_frame_for_655_seconds_at_most(void **state)
{
	static const double times_s[] = {655.34, 655.35, 655.36, 1e5};
	static const int most_cs[] = {65534, 65535, 65535, 65535};

	(void)state;
	for (int i = 0; i < 4; i++) {
		int delays[2] = {0, 0};

		assert_int_equal(read_delays(1.0 / times_s[i], 2, delays), 2);
		assert_int_equal(delays[0], most_cs[i]);
		assert_int_equal(delays[1], most_cs[i]);
	}
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

static void test_a_gif_gets_a_new_palette_for_a_new_scene(void **state)
{
	struct image_scene scene;
	struct shown shown = {0};
	struct pixels pixels;
	GifFileType *gif;
	int error;

	(void)state;
	image_scene_open(&scene, "cut.gif", 3, 25);
	for (int frame = 0; frame < 3; frame++) {
		scene.driver->begin_frame(scene.display, &pixels);
		for (int i = 0; i < IMAGE_SCENE_WIDTH * IMAGE_SCENE_HEIGHT; i++) {
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
	for (int i = 0; i < IMAGE_SCENE_WIDTH * IMAGE_SCENE_HEIGHT; i++) {
		const uint8_t *rgb =
			shown.rgb[i / IMAGE_SCENE_WIDTH][i % IMAGE_SCENE_WIDTH];

		assert_in_range(rgb[0], 0, 2);
		assert_in_range(abs(rgb[2] - i % 256), 0, 4);
	}
	DGifCloseFile(gif, &error);
	image_scene_close(&scene);
}

/* By how well eyes see red, green and blue. */
static int weighted_distance(const uint8_t *a, const int *b)
{
	static const int weight[3] = {2, 4, 3};
	int sum = 0;

	for (int i = 0; i < 3; i++) {
		sum += weight[i] * (a[i] - b[i]) * (a[i] - b[i]);
	}
	return sum;
}

/* The distance of the closest colour of the palette. */
static int least_distance(const ColorMapObject *map, const int *wanted)
{
	int least = 9 * 256 * 256;

	/* The last index is transparent. */
	for (int i = 0; i + 1 < map->ColorCount; i++) {
		const uint8_t rgb[3] = {map->Colors[i].Red,
			map->Colors[i].Green, map->Colors[i].Blue};
		int distance = weighted_distance(rgb, wanted);

		least = distance < least ? distance : least;
	}
	return least;
}

/*
 * Walks the rows to the right and to the left in turn, hands each pixel's error
 * on in sixteenths as Floyd and Steinberg do, and asks for the closest colour
 * to the centre of each pixel's cell.
 */
static void expect_diffused(const struct shown *shown,
	const ColorMapObject *map, uint8_t source[][IMAGE_SCENE_WIDTH][3])
{
	enum {
		W = IMAGE_SCENE_WIDTH,
		H = IMAGE_SCENE_HEIGHT
	};
	static int error[H + 1][W + 2][3]; /* from column -1 on */

	memset(error, 0, sizeof(error));
	for (int i = 0; i < W * H; i++) {
		int y = i / W, step = y % 2 ? -1 : 1;
		int x = y % 2 ? W - 1 - i % W : i % W;
		int wanted[3];

		for (int c = 0; c < 3; c++) {
			int sum = source[y][x][c] +
				((error[y][x + 1][c] + 8) >> 4);
			int left;

			wanted[c] = sum < 0 ? 0 : sum > 255 ? 255 : sum;
			left = wanted[c] - shown->rgb[y][x][c];
			error[y][x + 1 + step][c] += 7 * left;
			error[y + 1][x + 1 - step][c] += 3 * left;
			error[y + 1][x + 1][c] += 5 * left;
			error[y + 1][x + 1 + step][c] += left;
			wanted[c] = (wanted[c] & ~3) + 2;
		}
		assert_int_equal(weighted_distance(shown->rgb[y][x], wanted),
			least_distance(map, wanted));
	}
}

/* Draws random colours of low to low + range - 1. */
static void draw_noise(struct image_scene *scene, uint32_t *seed, int low,
	int range, uint8_t source[][IMAGE_SCENE_WIDTH][3])
{
	struct pixels pixels;

	assert_int_equal(scene->driver->begin_frame(scene->display, &pixels), 0);
	for (int y = 0; y < IMAGE_SCENE_HEIGHT; y++) {
		for (int x = 0; x < IMAGE_SCENE_WIDTH; x++) {
			uint8_t *at =
				pixels.data + y * pixels.stride_bytes + 4 * x;

			for (int c = 0; c < 3; c++) {
				source[y][x][c] = at[c] = (uint8_t)(low +
					(uint8_t)next_random(seed) % range);
			}
		}
	}
	assert_int_equal(scene->driver->end_frame(scene->display), 0);
}

/* And none to the next frame. */
static void test_a_gif_hands_the_error_of_each_pixel_on(void **state)
{
	enum {
		FRAMES = 8
	};
	static uint8_t source[FRAMES][IMAGE_SCENE_HEIGHT][IMAGE_SCENE_WIDTH][3];
	struct image_scene scene;
	struct shown shown = {0};
	uint32_t seed = 1;
	GifFileType *gif;
	int error;

	(void)state;
	image_scene_open(&scene, "noise.gif", FRAMES, 25);
	for (int frame = 0; frame < FRAMES; frame++) {
		draw_noise(&scene, &seed, 0, 256, source[frame]);
	}
	assert_int_equal(scene.driver->finish(scene.display), 0);
	gif = read_gif(&scene);
	assert_int_equal(gif->ImageCount, FRAMES);
	for (int frame = 0; frame < FRAMES; frame++) {
		const ColorMapObject *map =
			gif->SavedImages[frame].ImageDesc.ColorMap;

		paste(gif, frame, &shown);
		expect_diffused(
			&shown, map ? map : gif->SColorMap, source[frame]);
	}
	DGifCloseFile(gif, &error);
	image_scene_close(&scene);
}

/* The errors that pixels hand on are rounded up as often as down. */
static void test_a_gif_is_as_bright_as_its_source(void **state)
{
	static uint8_t source[IMAGE_SCENE_HEIGHT][IMAGE_SCENE_WIDTH][3];
	struct image_scene scene;
	struct shown shown = {0};
	uint32_t seed = 1;
	GifFileType *gif;
	double excess = 0.0;
	int error;

	(void)state;
	image_scene_open(&scene, "gray.gif", 1, 25);
	draw_noise(&scene, &seed, 96, 64, source);
	assert_int_equal(scene.driver->finish(scene.display), 0);
	gif = read_gif(&scene);
	paste(gif, 0, &shown);
	for (int y = 0; y < IMAGE_SCENE_HEIGHT; y++) {
		for (int x = 0; x < IMAGE_SCENE_WIDTH; x++) {
			for (int c = 0; c < 3; c++) {
				excess += shown.rgb[y][x][c] - source[y][x][c];
			}
		}
	}
	assert_near(excess / (IMAGE_SCENE_HEIGHT * IMAGE_SCENE_WIDTH * 3), 0.0,
		0.1);
	DGifCloseFile(gif, &error);
	image_scene_close(&scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_gif_shows_every_frame),
		cmocka_unit_test(test_a_gif_stores_only_what_changes),
		cmocka_unit_test(test_a_gif_stores_every_pixel_that_changes),
		cmocka_unit_test(test_a_gif_repeats_for_ever),
		cmocka_unit_test(test_gif_delays_do_not_drift),
		cmocka_unit_test(
			test_a_gif_shows_a_frame_for_655_seconds_at_most),
		cmocka_unit_test(
			test_a_gif_leaves_out_what_players_would_slow_down),
		cmocka_unit_test(test_a_gif_is_as_bright_as_its_source),
		cmocka_unit_test(test_a_gif_hands_the_error_of_each_pixel_on),
		cmocka_unit_test(test_a_gif_gets_a_new_palette_for_a_new_scene),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
