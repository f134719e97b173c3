/*
 * The soft driver's short cuts for uneven ground and what is drawn through a
 * stencil on it, against the long way.
 */
#include "platform/base/fixed.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/vertex/draw.h"
#include "tests/support/gl/soft_scene.h"
#include "tests/support/random.h"
#include "tests/support/soft/reference.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	TRIANGLES = 24,
	CORNERS = TRIANGLES * 3,
	HULLS = 5,
	HILLS = 12, /* a side */
	TILE = 64,  /* texels */
};

static void make_triangles(struct soft_corner *corner, uint32_t *seed, int size)
{
	soft_scene_scatter(corner, TRIANGLES, seed, 1100, size, 3.3f);
}

static void draw_corners(const struct gl *gl, const struct soft_corner *corner)
{
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, sizeof(*corner), corner->position);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(*corner), corner->color);
	gl->DrawArrays(GL_TRIANGLES, 0, CORNERS);
}

/* Something to be hidden by, a hull's sides as told, and the sheet over all. */
static void cast_shadow(struct soft_scene *scene, bool long_way,
	const struct soft_corner *ground, const struct soft_corner *hull)
{
	static const int16_t sheet[4][2] = {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
	static const GLenum hidden[HULLS] = {
		GL_INCR, GL_INCR, GL_DECR, GL_KEEP, GL_KEEP};
	static const GLenum seen[HULLS] = {
		GL_KEEP, GL_KEEP, GL_KEEP, GL_INCR, GL_DECR};
	const struct gl *gl = scene->gl;

	soft_scene_use(scene, long_way);
	gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT |
		GL_STENCIL_BUFFER_BIT);
	gl->Enable(GL_DEPTH_TEST);
	gl->EnableClientState(GL_COLOR_ARRAY);
	draw_corners(gl, ground);
	gl->DisableClientState(GL_COLOR_ARRAY);
	gl->DepthMask(GL_FALSE);
	gl->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
	gl->Enable(GL_STENCIL_TEST);
	gl->StencilFunc(GL_ALWAYS, 0, 255);
	for (int i = 0; i < HULLS; i++) {
		gl->StencilOp(GL_KEEP, hidden[i], seen[i]);
		draw_corners(gl, hull + i * CORNERS);
	}
	gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
	gl->StencilFunc(GL_NOTEQUAL, 0, 255);
	gl->StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
	gl->Disable(GL_DEPTH_TEST);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	gl->Color4x(FX16_ONE / 16, FX16_ONE, FX16_ONE / 12, FX16_ONE * 3 / 8);
	gl->VertexPointer(2, GL_SHORT, 0, sheet);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
	gl->Disable(GL_BLEND);
	gl->Disable(GL_STENCIL_TEST);
	gl->DepthMask(GL_TRUE);
}

/* Coverage, depth and stencil are the same, colours within a step. */
static void compare(const struct soft_scene *a, const struct soft_scene *b)
{
	const struct buffers *left = &a->soft->buffers;
	const struct buffers *right = &b->soft->buffers;

	assert_memory_equal(left->depth, right->depth, SOFT_SCENE_PIXELS * 2);
	if (left->stencil) {
		assert_memory_equal(
			left->stencil, right->stencil, SOFT_SCENE_PIXELS);
	}
	for (int i = 0; i < SOFT_SCENE_PIXELS; i++) {
		if (soft_scene_steps(a->pixel[i], b->pixel[i]) > 1) {
			fail_msg("pixel %d,%d is %04x, the long way %04x",
				i % SOFT_SCENE_WIDTH, i / SOFT_SCENE_WIDTH,
				a->pixel[i], b->pixel[i]);
		}
	}
}

static void test_stencils_shade_what_the_long_way_does(void **state)
{
	static const int sizes[] = {40, 200, 700, 3000};
	struct soft_corner ground[CORNERS], hull[HULLS * CORNERS];
	int counted = 0;

	(void)state;
	for (uint32_t round = 0; round < 60; round++) {
		struct soft_scene *fast_setup = soft_scene_open(),
				  *slow = soft_scene_open();
		uint32_t seed = round + 1;

		make_triangles(ground, &seed, 900);
		for (int i = 0; i < HULLS; i++) {
			make_triangles(
				hull + i * CORNERS, &seed, sizes[round % 4]);
		}
		cast_shadow(fast_setup, false, ground, hull);
		cast_shadow(slow, true, ground, hull);
		compare(fast_setup, slow);
		for (int i = 0; i < SOFT_SCENE_PIXELS; i++) {
			counted += fast_setup->soft->buffers.stencil[i];
		}
		soft_scene_close(fast_setup);
		soft_scene_close(slow);
	}
	assert_true(counted > 10000);
}

/* Fields of one shade and lines between them, in all levels; low ones are flat. */
static void make_tiles(const struct gl *gl, bool low)
{
	uint8_t texel[TILE * TILE];
	GLuint name;

	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->TexParameterx(
		GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	for (int level = 0, side = TILE; side; level++, side /= 2) {
		int height = low && side > 1 ? side / 2 : side;

		for (int i = 0; i < side * height; i++) {
			int x = i % side, y = i / side;

			texel[i] = x % 8 == 0 || y % 8 == 0 ? 190
				: (x ^ y) & 8               ? 230
							    : 255;
		}
		gl->TexImage2D(GL_TEXTURE_2D, level, GL_LUMINANCE, side, height,
			0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texel);
	}
}

/* A field of hills, seen in perspective, that goes on beyond the picture. */
static void make_hills(struct soft_corner *corner, uint32_t *seed)
{
	static const int part[6][2] = {
		{0, 0}, {1, 0}, {0, 1}, {0, 1}, {1, 0}, {1, 1}};
	enum {
		ROW = HILLS + 1
	};
	float height[ROW * ROW];
	uint8_t gray[ROW * ROW], alpha[ROW * ROW];

	for (int i = 0; i < ROW * ROW; i++) {
		height[i] = (float)random_between(seed, -300, 300) / 1000.0f;
		gray[i] = (uint8_t)random_between(seed, 90, 255);
		alpha[i] = (uint8_t)random_between(seed, 0, 255);
	}
	for (int i = 0; i < HILLS * HILLS * 6; i++) {
		int x = i / 6 % HILLS + part[i % 6][0];
		int z = i / 6 / HILLS + part[i % 6][1];
		int at = z * ROW + x;

		corner[i] = (struct soft_corner){
			.position = {(float)(x - HILLS / 2), height[at] - 0.7f,
				(float)-z - 0.2f},
			.texcoord = {(float)x / 16, (float)z / 16},
			.color = {gray[at], gray[at], gray[at], alpha[at]},
		};
	}
}

static void draw_hills(struct soft_scene *scene,
	const struct soft_corner *corner, uint32_t round, bool long_way)
{
	const struct gl *gl = scene->gl;
	const GLsizei stride = sizeof(*corner);

	soft_scene_use(scene, long_way);
	make_tiles(gl, round % 3 == 2);
	gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	gl->MatrixMode(GL_PROJECTION);
	gl->LoadIdentity();
	gl->Frustumx(-FX16_ONE / 16, FX16_ONE / 16, -FX16_ONE / 16,
		FX16_ONE / 16, FX16_ONE / 8, FX16_ONE * 40);
	gl->Enable(GL_DEPTH_TEST);
	gl->DepthFunc(GL_ALWAYS);
	gl->Enable(GL_TEXTURE_2D);
	(round % 2 ? gl->Enable : gl->Disable)(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, stride, corner->position);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, stride, corner->color);
	gl->TexCoordPointer(2, GL_FLOAT, stride, corner->texcoord);
	gl->DrawArrays(GL_TRIANGLES, 0, HILLS * HILLS * 6);
}

/* Rows that are nearly level get one depth. */
static void check_depth(const struct soft *fast_setup, const struct soft *slow)
{
	for (int i = 0; i < SOFT_SCENE_PIXELS; i++) {
		int off = fast_setup->buffers.depth[i] - slow->buffers.depth[i];

		assert_true(abs(off) <= 1);
	}
}

/*
 * Depth is the same, and so is the colour but where runs end elsewhere: half a
 * texel on a line, or a step of 1/32 more of the picture.
 */
static void test_hills_are_nearly_those_of_the_long_way(void **state)
{
	static struct soft_corner corner[HILLS * HILLS * 6];

	(void)state;
	for (uint32_t round = 0; round < 40; round++) {
		struct soft_scene *fast_setup = soft_scene_open(),
				  *slow = soft_scene_open();
		uint32_t seed = round + 1;
		int seen = 0, other = 0, far = 0;

		make_hills(corner, &seed);
		draw_hills(fast_setup, corner, round, false);
		draw_hills(slow, corner, round, true);
		assert_ptr_equal(
			fast_setup->soft->draw->fill, soft_fill_luminance);
		assert_ptr_equal(slow->soft->draw->fill, reference_fill);
		check_depth(fast_setup->soft, slow->soft);
		for (int i = 0; i < SOFT_SCENE_PIXELS; i++) {
			int step = soft_scene_steps(
				fast_setup->pixel[i], slow->pixel[i]);

			seen += slow->soft->buffers.depth[i] < 65535;
			other += step > 1;
			far += step > 3;
		}
		assert_true(seen > 2000);
		assert_true(other * 40 < seen);
		assert_true(far * 200 < seen);
		soft_scene_close(fast_setup);
		soft_scene_close(slow);
	}
}

/* A triangle in varying gray over the whole picture, and others without area. */
static void make_screen(struct soft_corner *corner)
{
	static const float place[3][2] = {{-4, -4}, {12, -4}, {-4, 12}};

	memset(corner, 0, HILLS * HILLS * 6 * sizeof(*corner));
	for (int i = 0; i < 3; i++) {
		const uint8_t gray = (uint8_t)(90 + 80 * i);

		corner[i] = (struct soft_corner){
			.position = {place[i][0], place[i][1], -1},
			.texcoord = {place[i][0], place[i][1]},
			.color = {gray, gray, gray, 128},
		};
	}
}

/*
 * A run that is drawn aside before it is blended begins at the same half of a
 * word as its pixels, so that both are read by words; nothing else is written.
 */
static void test_runs_aside_begin_in_a_word_where_their_pixels_do(void **state)
{
	static struct soft_corner corner[HILLS * HILLS * 6];
	enum {
		UNTOUCHED = 0xA5A5
	};

	(void)state;
	make_screen(corner);
	for (int x = 1; x < 13; x++) {
		struct soft_scene *scene = soft_scene_open();
		struct draw *draw = scene->soft->draw;
		const size_t first = (uintptr_t)(scene->pixel + x) / 2 % 2;

		for (int i = 0; i < LUMINANCE_RUN + 1; i++) {
			draw->shaded[i] = UNTOUCHED;
		}
		scene->gl->Scissor(x, SOFT_SCENE_HEIGHT / 2, 9, 1);
		scene->gl->Enable(GL_SCISSOR_TEST);
		draw_hills(scene, corner, 1, false);
		assert_ptr_equal(draw->fill, soft_fill_luminance);
		for (size_t i = 0; i < LUMINANCE_RUN + 1; i++) {
			assert_int_equal(draw->shaded[i] != UNTOUCHED,
				i >= first && i < first + 9);
		}
		soft_scene_close(scene);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_stencils_shade_what_the_long_way_does),
		cmocka_unit_test(test_hills_are_nearly_those_of_the_long_way),
		cmocka_unit_test(
			test_runs_aside_begin_in_a_word_where_their_pixels_do),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
