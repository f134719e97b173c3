/* A camera's picture behind the scene: rows that are copied. */
#include "platform/gl/soft/span/spans.h"
#include "tests/support/gl/gl_checks.h"
#include "tests/support/random.h"
#include "tests/support/soft/reference.h"

#include <string.h>

enum {
	SIDE = 32, /* texels */
	ROW = 200,
	PIXELS = GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT,
};

struct corner {
	float position[2], texcoord[2];
	uint8_t color[4];
};

static void test_copies_are_the_nearest_texels(void **state)
{
	static uint32_t drawn[ROW], expected[ROW];
	static uint16_t texels[1024];
	uint32_t seed = 4;

	(void)state;
	for (int i = 0; i < 1024; i++) {
		texels[i] = (uint16_t)next_random(&seed);
	}
	for (int round = 0; round < 3000; round++) {
		int at = random_between(&seed, 0, 5);
		int count = random_between(&seed, 0, ROW * 2 - 10);
		uint32_t from = next_random(&seed) % (1024u << 16);
		uint32_t to = next_random(&seed) << 4 & ((1024u << 16) - 1);
		uint32_t step = count > 1
			? (uint32_t)(((int32_t)to - (int32_t)from) / (count - 1))
			: 0;

		memset(drawn, 0x5A, sizeof(drawn));
		memset(expected, 0x5A, sizeof(expected));
		for (int i = 0; i < count; i++) {
			uint32_t texel = (from + step * (uint32_t)i) >> 16;

			((uint16_t *)expected)[at + i] = texels[texel];
		}
		soft_copy_texels(
			(uint16_t *)drawn + at, texels, count, from, step);
		assert_memory_equal(drawn, expected, sizeof(drawn));
	}
}

static void set_up(struct gl *gl)
{
	static uint16_t texels[SIDE * SIDE];
	uint32_t seed = 1;
	GLuint name;

	for (int i = 0; i < SIDE * SIDE; i++) {
		texels[i] = (uint16_t)next_random(&seed);
	}
	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
	gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, SIDE, SIDE, 0, GL_RGB,
		GL_UNSIGNED_SHORT_5_6_5, texels);
	gl->Enable(GL_TEXTURE_2D);
	gl->Disable(GL_DEPTH_TEST);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
}

/* Upright mostly; white mostly; within the texture mostly. */
static void make_strip(uint32_t *seed, struct corner corner[4])
{
	float x = (float)random_between(seed, -150, 50) / 100.0f;
	float y = (float)random_between(seed, -150, 50) / 100.0f;
	float w = (float)random_between(seed, 20, 250) / 100.0f;
	float h = (float)random_between(seed, 20, 250) / 100.0f;
	float s[2], t[2];
	int kind = random_between(seed, 0, 9);

	for (int i = 0; i < 2; i++) {
		s[i] = (float)random_between(seed, 5, 250) / 256.0f;
		t[i] = (float)random_between(seed, 5, 250) / 256.0f;
	}
	s[1] += kind == 0 ? 1.0f : 0.0f;
	t[0] -= kind == 1 ? 1.0f : 0.0f;
	for (int i = 0; i < 4; i++) {
		corner[i] = (struct corner){
			.position = {x + (i & 1 ? w : 0.0f),
				y + (i & 2 ? h : 0.0f)},
			.texcoord = {s[i & 1], t[i >> 1]},
		};
		memset(corner[i].color, kind == 2 ? 200 : 255, 4);
	}
	if (kind == 3) {
		corner[0].position[0] += 0.3f;
		corner[0].position[1] += 0.2f;
	}
}

/* The long way is that of soft/reference.h, for all fragments. */
static void draw(const struct gl_canvas *canvas, const struct corner *corner,
	bool long_way, uint16_t out[PIXELS])
{
	const struct gl *gl = canvas->gl;
	const GLsizei stride = sizeof(*corner);

	reference_use((struct soft *)canvas->context, long_way);
	gl->Clear(GL_COLOR_BUFFER_BIT);
	gl->VertexPointer(2, GL_FLOAT, stride, corner->position);
	gl->TexCoordPointer(2, GL_FLOAT, stride, corner->texcoord);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, stride, corner->color);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
	memcpy(out, canvas->pixels.data, PIXELS * sizeof(*out));
}

static int differ_most(uint16_t a, uint16_t b)
{
	int most = 0;

	for (int shift = 0; shift < 16; shift += shift == 5 ? 6 : 5) {
		int mask = shift == 5 ? 63 : 31;
		int off = (a >> shift & mask) - (b >> shift & mask);

		most = off > most ? off : -off > most ? -off : most;
	}
	return most;
}

static void test_pictures_are_those_of_the_long_way(void **state)
{
	static uint16_t fast_setup[PIXELS], slow[PIXELS];
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	uint32_t seed = 6;
	int seen = 0, other = 0;

	(void)state;
	assert_int_equal(canvas.pixels.stride_bytes, GL_CANVAS_WIDTH * 2);
	set_up(canvas.gl);
	for (int round = 0; round < 1000; round++) {
		struct corner corner[4];

		make_strip(&seed, corner);
		canvas.gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
			round % 3 ? GL_MODULATE : GL_REPLACE);
		draw(&canvas, corner, false, fast_setup);
		draw(&canvas, corner, true, slow);
		for (int i = 0; i < PIXELS; i++) {
			seen += slow[i] != 0;
			other += differ_most(fast_setup[i], slow[i]) > 2;
		}
	}
	assert_true(seen > 100000);
	assert_true(other * 2000 < seen);
	gl_canvas_end_and_close(&canvas);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_copies_are_the_nearest_texels),
		cmocka_unit_test(test_pictures_are_those_of_the_long_way),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
