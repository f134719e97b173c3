/* Letters and panels: rectangles that are drawn as one, and their loops. */
#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/raster/pixel.h"
#include "tests/support/gl/gl_checks.h"
#include "tests/support/random.h"

#include <stdlib.h>
#include <string.h>

enum {
	SIDE = 40,
	ATLAS = 64, /* texels a side */
	PIXELS = GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT,
};

struct corner {
	float position[2];
	float texcoord[2];
	uint8_t color[4];
};

static void test_panels_are_mixed_pixel_by_pixel(void **state)
{
	static uint32_t drawn[SIDE], expected[SIDE];
	uint32_t seed = 3;

	(void)state;
	for (int round = 0; round < 4000; round++) {
		uint32_t alpha = (uint32_t)random_between(&seed, 0, 32);
		uint32_t color = next_random(&seed) & 0xFFFF;
		int at = random_between(&seed, 0, 5);
		int count = random_between(&seed, 0, SIDE * 2 - 10);

		for (int i = 0; i < SIDE; i++) {
			drawn[i] = expected[i] =
				next_random(&seed) << 12 ^ next_random(&seed);
		}
		for (int i = 0; i < count; i++) {
			uint16_t *pixel = (uint16_t *)expected + at + i;

			*pixel = narrow(
				(widen(*pixel) * (32 - alpha) +
					widen(color) * alpha + WIDE_ROUND) >>
					5 &
				WIDE_MASK);
		}
		soft_mix_color(
			(uint16_t *)drawn + at, (uint16_t)color, count, alpha);
		assert_memory_equal(drawn, expected, sizeof(drawn));
	}
}

/* Pixels from the top left corner, as the corners of a picture are -1 and 1. */
static void set_corner(struct corner *corner, float x, float y, float s, float t)
{
	corner->position[0] = x * 2.0f / GL_CANVAS_WIDTH - 1.0f;
	corner->position[1] = 1.0f - y * 2.0f / GL_CANVAS_HEIGHT;
	corner->texcoord[0] = s / ATLAS;
	corner->texcoord[1] = t / ATLAS;
}

static void make_rectangle(uint32_t *seed, struct corner corner[4])
{
	/* Off by up to a fifth of a pixel, as hud.c's may be. */
	float x = (float)random_between(seed, -3, 30) +
		(float)random_between(seed, -20, 20) / 100.0f;
	float y = (float)random_between(seed, -3, 22) +
		(float)random_between(seed, -20, 20) / 100.0f;
	int kind = random_between(seed, 0, 15);
	float w = (float)random_between(seed, 1, 20);
	float h = (float)random_between(seed, 1, 20);
	float s = (float)random_between(seed, 0, 40);
	float t = (float)random_between(seed, 0, 40);
	float across = kind < 3 ? 0.0f : kind == 3 ? 2.0f * w : w;
	float down = kind < 3 ? 0.0f : kind == 4 ? 0.5f * h : h;
	uint32_t color = next_random(seed) << 8 ^ next_random(seed);

	/* Also mirrored, outside of the texture, and aslant. */
	across = kind == 5 ? -across : across;
	s = kind == 6 ? s + 40.0f : s;
	set_corner(&corner[0], x, y, s, t);
	set_corner(&corner[1], kind == 7 ? x + 3.0f : x, y + h, s, t + down);
	set_corner(&corner[2], x + w, y, s + across, t);
	set_corner(&corner[3], x + w, y + h, s + across, t + down);
	for (int i = 0; i < 4; i++) {
		memcpy(corner[i].color, &color, sizeof(color));
		if (random_between(seed, 0, 3) == 0) {
			corner[i].color[3] = 255;
		}
		memcpy(corner[i].color, corner[0].color, 4);
	}
	if (random_between(seed, 0, 4) == 0) {
		corner[random_between(seed, 0, 3)]
			.color[random_between(seed, 0, 3)] ^= 0xFF;
	}
	if (random_between(seed, 0, 4) == 0) {
		corner[random_between(seed, 0, 3)]
			.texcoord[random_between(seed, 0, 1)] += 5.0f / ATLAS;
	}
}

static void set_up(struct gl *gl)
{
	static uint8_t atlas[ATLAS * ATLAS];
	GLuint name;
	uint32_t seed = 1;

	for (int i = 0; i < ATLAS * ATLAS; i++) {
		atlas[i] = random_between(&seed, 0, 2)
			? (uint8_t)next_random(&seed)
			: 0;
	}
	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
	gl->TexImage2D(GL_TEXTURE_2D, 0, GL_ALPHA, ATLAS, ATLAS, 0, GL_ALPHA,
		GL_UNSIGNED_BYTE, atlas);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
	gl->Enable(GL_TEXTURE_2D);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
}

static void draw(const struct gl *gl, const struct corner *corner,
	const uint16_t *index, int count, uint16_t *out,
	const struct gl_canvas *canvas)
{
	const GLsizei stride = sizeof(*corner);

	gl->ClearColorx(32768, 16384, 49152, 65536);
	gl->Clear(GL_COLOR_BUFFER_BIT);
	gl->VertexPointer(2, GL_FLOAT, stride, corner->position);
	gl->TexCoordPointer(2, GL_FLOAT, stride, corner->texcoord);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, stride, corner->color);
	gl->DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_SHORT, index);
	for (int y = 0; y < GL_CANVAS_HEIGHT; y++) {
		memcpy(out + y * GL_CANVAS_WIDTH,
			pixel_at(&canvas->pixels, 0, y),
			GL_CANVAS_WIDTH * sizeof(*out));
	}
}

/*
 * Rectangles round the texel's and the colour's alpha to 32nds and cut their
 * product, which is off by up to 1/16; the span functions do not.
 */
static bool is_near(uint16_t a, uint16_t b)
{
	int red = (a >> 11) - (b >> 11), blue = (a & 31) - (b & 31);
	int green = (a >> 5 & 63) - (b >> 5 & 63);

	return abs(red) <= 2 && abs(green) <= 4 && abs(blue) <= 2;
}

static void check_near(const uint16_t *drawn, const uint16_t *expected)
{
	for (int i = 0; i < PIXELS; i++) {
		if (!is_near(drawn[i], expected[i])) {
			fail_msg("column %d, row %d: %04x, expected %04x",
				i % GL_CANVAS_WIDTH, i / GL_CANVAS_WIDTH,
				drawn[i], expected[i]);
		}
	}
}

static void test_rectangles_are_their_two_triangles(void **state)
{
	static const uint16_t paired[12] = {0, 1, 2, 2, 1, 3, 4, 5, 6, 6, 5, 7};
	/* The same triangles, with nothing between. */
	static const uint16_t apart[18] = {
		0, 1, 2, 0, 0, 0, 2, 1, 3, 4, 5, 6, 4, 4, 4, 6, 5, 7};
	static uint16_t fast_setup[PIXELS], slow[PIXELS], none[PIXELS];
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	uint32_t seed = 8;
	int drawn = 0;

	(void)state;
	set_up(canvas.gl);
	for (int round = 0; round < 3000; round++) {
		struct corner corner[8];

		make_rectangle(&seed, corner);
		make_rectangle(&seed, corner + 4);
		(round % 4 ? canvas.gl->Disable : canvas.gl->Enable)(
			GL_SCISSOR_TEST);
		canvas.gl->Scissor(5, 3, 17, 15);
		draw(canvas.gl, corner, paired, 12, fast_setup, &canvas);
		draw(canvas.gl, corner, apart, 18, slow, &canvas);
		draw(canvas.gl, corner, apart, 0, none, &canvas);
		check_near(fast_setup, slow);
		drawn += memcmp(fast_setup, none, sizeof(fast_setup)) != 0;
	}
	assert_true(drawn > 2000);
	gl_canvas_end_and_close(&canvas);
}

static void test_culled_rectangles_are_not_drawn(void **state)
{
	static const uint16_t paired[6] = {0, 1, 2, 2, 1, 3};
	static uint16_t front[PIXELS], back[PIXELS], none[PIXELS];
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	struct corner corner[4];

	(void)state;
	set_up(canvas.gl);
	set_corner(&corner[0], 4, 4, 0, 0);
	set_corner(&corner[1], 4, 12, 0, 0);
	set_corner(&corner[2], 20, 4, 0, 0);
	set_corner(&corner[3], 20, 12, 0, 0);
	for (int i = 0; i < 4; i++) {
		memset(corner[i].color, 255, 4);
		corner[i].texcoord[0] = corner[i].texcoord[1] = 0.5f;
	}
	canvas.gl->Enable(GL_CULL_FACE);
	draw(canvas.gl, corner, paired, 6, front, &canvas);
	canvas.gl->CullFace(GL_FRONT);
	draw(canvas.gl, corner, paired, 6, back, &canvas);
	draw(canvas.gl, corner, paired, 0, none, &canvas);
	assert_memory_equal(back, none, sizeof(back));
	assert_memory_not_equal(front, none, sizeof(front));
	gl_canvas_end_and_close(&canvas);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_panels_are_mixed_pixel_by_pixel),
		cmocka_unit_test(test_rectangles_are_their_two_triangles),
		cmocka_unit_test(test_culled_rectangles_are_not_drawn),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
