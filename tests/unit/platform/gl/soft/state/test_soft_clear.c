/* Clearing under each mask, of boxes at any place, against what GL says. */
#include "tests/support/random.h"
#include "tests/support/soft/span_scene.h"
#include "tests/support/test.h"

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

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_masks_keep_their_bits),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
