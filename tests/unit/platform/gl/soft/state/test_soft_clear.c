/* Clearing under each mask, of boxes at any place, against what GL says. */
#include "tests/support/gl/gl_expect.h"
#include "tests/support/random.h"
#include "tests/support/soft/span_scene.h"
#include "tests/support/test.h"

#include <limits.h>
#include <string.h>

static const GLfixed color[4] = {65536, 65536 / 3, 40000, 20000};

static bool is_in_box(int i, const int box[4])
{
	int x = i % SPAN_WIDTH, y = SPAN_HEIGHT - 1 - i / SPAN_WIDTH;

	return x >= box[0] && y >= box[1] && x < box[0] + box[2] &&
		y < box[1] + box[3];
}

/* The bits of a pixel that a colour mask lets through. */
static uint32_t find_bits(enum pixel_format format, int mask)
{
	static const uint32_t bits[2][4] = {{0xF800, 0x07E0, 0x001F, 0},
		{0xFF, 0xFF00, 0xFF0000, 0xFF000000}};
	uint32_t all = 0;

	for (int i = 0; i < 4; i++) {
		all |= mask >> i & 1 ? bits[format != PIXELS_RGB565][i] : 0;
	}
	return all;
}

static uint32_t load(const struct span_scene *scene, int i)
{
	const int bytes = pixel_bytes(scene->picture.format);
	uint32_t value = 0;

	memcpy(&value, scene->bytes + i * bytes, (size_t)bytes);
	return value;
}

static void check(enum pixel_format format, int mask, uint32_t *seed)
{
	struct span_scene *old = span_scene_begin(format, false);
	struct span_scene *scene = span_scene_begin(format, false);
	const struct gl *gl = scene->gl;
	const int box[4] = {random_between(seed, 0, 9),
		random_between(seed, 0, 9), random_between(seed, 1, 40),
		random_between(seed, 1, 40)};
	const uint32_t bits = find_bits(format, mask);
	const uint32_t wanted = format == PIXELS_RGB565 ? 0xFAB3 : 0x4E9C55FFu;
	const uint8_t stencil_mask = mask & 1 ? 0xFF : 0x3C;

	for (int i = 0; i < SPAN_PIXELS; i++) {
		scene->soft->buffers.stencil[i] = (uint8_t)(i * 7);
	}
	gl->Enable(GL_SCISSOR_TEST);
	gl->Scissor(box[0], box[1], box[2], box[3]);
	gl->ClearColorx(color[0], color[1], color[2], color[3]);
	gl->ColorMask(mask & 1, mask >> 1 & 1, mask >> 2 & 1, mask >> 3 & 1);
	gl->ClearStencil(0xA5);
	gl->StencilMask(stencil_mask);
	gl->Clear(GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
	for (int i = 0; i < SPAN_PIXELS; i++) {
		const bool in = is_in_box(i, box);
		const uint32_t keep = in ? ~bits : UINT32_MAX;
		const uint8_t kept = in ? (uint8_t)~stencil_mask : 0xFF;

		assert_int_equal(load(scene, i),
			(load(old, i) & keep) | (wanted & ~keep));
		assert_int_equal(scene->soft->buffers.stencil[i],
			((uint8_t)(i * 7) & kept) | (0xA5 & ~kept));
	}
	span_scene_close(old);
	span_scene_close(scene);
}

static void test_masks_keep_their_bits(void **state)
{
	uint32_t seed = 5;

	(void)state;
	for (int i = 0; i < 2 * 16 * 4; i++) {
		check(i & 1 ? PIXELS_RGB565 : PIXELS_RGBA8888, i / 2 % 16,
			&seed);
	}
}

/* What lies outside of the picture is left as it was. */
static void check_read(const struct gl_canvas *canvas, int x, int y)
{
	enum {
		WIDE = 37,
		HIGH = 5
	};
	uint8_t read[HIGH][WIDE + 1][4];

	memset(read, 99, sizeof(read));
	canvas->gl->ReadPixels(
		x, y, WIDE, HIGH, GL_RGBA, GL_UNSIGNED_BYTE, read);
	for (int i = 0; i < WIDE * HIGH; i++) {
		/* rows have no gaps: the last ones stay */
		const uint8_t *got = read[0][0] + 4 * i;
		int64_t column = (int64_t)x + i % WIDE;
		int64_t row = GL_CANVAS_HEIGHT - 1 - ((int64_t)y + i / WIDE);
		uint8_t wanted[4] = {99, 99, 99, 99};

		if (column >= 0 && column < GL_CANVAS_WIDTH && row >= 0 &&
			row < GL_CANVAS_HEIGHT) {
			gl_expect_read(canvas, (int)column, (int)row, wanted);
		}
		assert_memory_equal(got, wanted, 4);
	}
	assert_int_equal(read[HIGH - 1][WIDE][3], 99);
}

static void test_a_part_of_the_picture_is_read(void **state)
{
	static const int places[] = {
		INT_MIN, -40, -36, -3, -1, 0, 2, 21, 31, 32, 40, INT_MAX - 40};
	const int count = sizeof(places) / sizeof(places[0]);

	(void)state;
	for (int i = 0; i < 2 * count * count; i++) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i % 2]);

		for (int j = 0; j < 20 * GL_CANVAS_WIDTH; j++) {
			canvas.pixels.data[j] = (uint8_t)(j * 37);
		}
		check_read(
			&canvas, places[i / 2 % count], places[i / 2 / count]);
		gl_canvas_end_and_close(&canvas);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_part_of_the_picture_is_read),
		cmocka_unit_test(test_masks_keep_their_bits),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
