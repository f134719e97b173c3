/*
 * The soft driver's short cuts for uneven ground and the shadow volumes on it:
 * against the long way, and those in assembly against the same in C.
 */
#include "platform/base/fixed.h"
#include "platform/gl/soft/band.h"
#include "platform/gl/soft/count.h"
#include "platform/gl/soft/draw.h"
#include "platform/gl/soft/pixel.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	WIDTH = 96,
	HEIGHT = 80,
	TRIANGLES = 24,
	CORNERS = TRIANGLES * 3,
	SIDE = 64, /* of what the functions in assembly draw in */
};

static uint32_t next_random(uint32_t *seed)
{
	*seed = *seed * 1664525u + 1013904223u;
	return *seed >> 8;
}

static int random_between(uint32_t *seed, int low, int high)
{
	return low + (int)(next_random(seed) % (uint32_t)(high - low + 1));
}

struct scene {
	struct gl_context *context;
	const struct gl *gl;
	struct soft *soft;
	uint16_t pixel[WIDTH * HEIGHT];
	struct pixels picture;
};

static struct scene *open_scene(void)
{
	const struct log log = {0};
	struct scene *scene = calloc(1, sizeof(*scene));

	assert_non_null(scene);
	scene->picture = (struct pixels){
		.width = WIDTH,
		.height = HEIGHT,
		.stride_bytes = WIDTH * 2,
		.format = PIXELS_RGB565,
		.data = (uint8_t *)scene->pixel,
	};
	assert_int_equal(
		gl_open("soft", PIXELS_RGB565, &log, &scene->context), 0);
	scene->gl = &scene->context->gl;
	scene->soft = (struct soft *)scene->context;
	return scene;
}

/* Calls of GL go to the context whose frame began last. */
static void use(struct scene *scene, bool long_way)
{
	assert_int_equal(scene->context->driver->begin_frame(
				 scene->context, &scene->picture),
		0);
	/* The alpha test that all pass sends fragments the long way. */
	(long_way ? scene->gl->Enable : scene->gl->Disable)(GL_ALPHA_TEST);
	scene->gl->AlphaFuncx(GL_ALWAYS, 0);
}

static void close_scene(struct scene *scene)
{
	scene->context->driver->end_frame(scene->context);
	scene->context->driver->destroy(scene->context);
	free(scene);
}

struct corner {
	float position[3];
	uint8_t color[4];
};

static void make_triangles(struct corner *corner, uint32_t *seed, int size)
{
	for (int i = 0; i < CORNERS; i++) {
		const struct corner *first = &corner[i / 3 * 3];
		int range = i % 3 ? size : 1100;

		for (int axis = 0; axis < 3; axis++) {
			float around = i % 3 && axis < 2 ? first->position[axis]
							 : 0.0f;

			corner[i].position[axis] = around +
				(float)random_between(seed, -range, range) /
					(axis < 2 ? 1000.0f : 3300.0f);
			corner[i].color[axis] =
				(uint8_t)random_between(seed, 0, 255);
		}
		corner[i].color[3] = 255;
	}
}

static void draw_corners(const struct gl *gl, const struct corner *corner)
{
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, sizeof(*corner), corner->position);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(*corner), corner->color);
	gl->DrawArrays(GL_TRIANGLES, 0, CORNERS);
}

/* Something to be hidden by, a hull's sides as told, and the sheet over all. */
static void cast_shadow(struct scene *scene, bool long_way,
	const struct corner *ground, const struct corner *hull)
{
	static const int16_t sheet[4][2] = {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
	static const GLenum change[3] = {GL_INCR, GL_INCR, GL_DECR};
	const struct gl *gl = scene->gl;

	use(scene, long_way);
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
	for (int i = 0; i < 3; i++) {
		gl->StencilOp(GL_KEEP, change[i], GL_KEEP);
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

static int differ_most(uint16_t a, uint16_t b)
{
	int red = abs((a >> 11) - (b >> 11));
	int green = (abs((a >> 5 & 63) - (b >> 5 & 63)) + 1) / 2;
	int blue = abs((a & 31) - (b & 31));
	int most = red > green ? red : green;

	return most > blue ? most : blue;
}

/* Coverage, depth and stencil are the same, colours within a step. */
static void compare(const struct scene *a, const struct scene *b)
{
	const struct buffers *left = &a->soft->buffers;
	const struct buffers *right = &b->soft->buffers;

	assert_memory_equal(left->depth, right->depth, WIDTH * HEIGHT * 2);
	if (left->stencil) {
		assert_memory_equal(
			left->stencil, right->stencil, WIDTH * HEIGHT);
	}
	for (int i = 0; i < WIDTH * HEIGHT; i++) {
		if (differ_most(a->pixel[i], b->pixel[i]) > 1) {
			fail_msg("pixel %d,%d is %04x, the long way %04x",
				i % WIDTH, i / WIDTH, a->pixel[i], b->pixel[i]);
		}
	}
}

static void test_volumes_shade_what_the_long_way_does(void **state)
{
	static const int sizes[] = {40, 200, 700, 3000};
	struct corner ground[CORNERS], hull[3 * CORNERS];
	int counted = 0;

	(void)state;
	for (uint32_t round = 0; round < 60; round++) {
		struct scene *quick = open_scene(), *slow = open_scene();
		uint32_t seed = round + 1;

		make_triangles(ground, &seed, 900);
		for (int i = 0; i < 3; i++) {
			make_triangles(
				hull + i * CORNERS, &seed, sizes[round % 4]);
		}
		cast_shadow(quick, false, ground, hull);
		cast_shadow(slow, true, ground, hull);
		compare(quick, slow);
		for (int i = 0; i < WIDTH * HEIGHT; i++) {
			counted += quick->soft->buffers.stencil[i];
		}
		close_scene(quick);
		close_scene(slow);
	}
	assert_true(counted > 10000);
}

/* Two sets of buffers that begin alike. */
struct twins {
	uint16_t pixel[2][SIDE * SIDE], depth[2][SIDE * SIDE];
	uint8_t stencil[2][SIDE * SIDE];
};

/* Of the stencil, one in rarely is not 0. */
static struct twins *make_twins(uint32_t *seed, int rarely)
{
	struct twins *twins = calloc(1, sizeof(*twins));

	assert_non_null(twins);
	for (int i = 0; i < SIDE * SIDE; i++) {
		twins->depth[0][i] = (uint16_t)next_random(seed);
		twins->pixel[0][i] = (uint16_t)next_random(seed);
		if (random_between(seed, 1, rarely) == 1) {
			twins->stencil[0][i] = (uint8_t)next_random(seed);
		}
	}
	memcpy(twins->depth[1], twins->depth[0], sizeof(twins->depth[0]));
	memcpy(twins->pixel[1], twins->pixel[0], sizeof(twins->pixel[0]));
	memcpy(twins->stencil[1], twins->stencil[0], sizeof(twins->stencil[0]));
	return twins;
}

static void check_twins(struct twins *twins)
{
	assert_memory_equal(
		twins->depth[0], twins->depth[1], sizeof(twins->depth[0]));
	assert_memory_equal(
		twins->pixel[0], twins->pixel[1], sizeof(twins->pixel[0]));
	assert_memory_equal(twins->stencil[0], twins->stencil[1],
		sizeof(twins->stencil[0]));
	free(twins);
}

/* Anywhere, also crossed and beyond the picture, in 20 rows at most. */
static void make_edges(uint32_t *seed, uint32_t edge[2], uint32_t step[2])
{
	for (int side = 0; side < 2; side++) {
		int from = random_between(seed, -9, SIDE + 9);
		int to = random_between(seed, -9, SIDE + 9);

		edge[side] = (uint32_t)(from * 65536 + 0x7FFF);
		step[side] = (uint32_t)((to - from) * 65536 / 20);
	}
}

static void test_the_count_band_is_as_in_c(void **state)
{
	uint32_t seed = 4;

	(void)state;
	for (int round = 0; round < 500; round++) {
		struct twins *twins = make_twins(&seed, 2);
		struct count_band band = {
			.depth = twins->depth[0] + 20 * SIDE,
			.stencil = twins->stencil[0] + 20 * SIDE,
			.z = next_random(&seed),
			.z_right = (uint32_t)random_between(
				&seed, -1000000, 1000000),
			.z_down = (uint32_t)random_between(
				&seed, -1000000, 1000000),
			.rows = random_between(&seed, 0, 20),
			.width = SIDE,
			.from = random_between(&seed, 0, 40),
			.to = random_between(&seed, 30, SIDE),
			.down = round % 2,
		};
		struct count_band other;

		make_edges(&seed, band.edge, band.edge_step);
		other = band;
		other.depth = twins->depth[1] + 20 * SIDE;
		other.stencil = twins->stencil[1] + 20 * SIDE;
		soft_bands.count(&band);
		count_band_c(&other);
		assert_int_equal(band.edge[0], other.edge[0]);
		assert_int_equal(band.edge[1], other.edge[1]);
		assert_int_equal(band.z, other.z);
		assert_int_equal(band.depth - twins->depth[0],
			other.depth - twins->depth[1]);
		assert_int_equal(band.stencil - twins->stencil[0],
			other.stencil - twins->stencil[1]);
		check_twins(twins);
	}
}

/* Counts stop at their ends. */
static void test_counts_neither_wrap_up_nor_down(void **state)
{
	for (int down = 0; down < 2; down++) {
		uint16_t depth[4] = {0, 0, 0, 65535};
		uint8_t stencil[4] = {0, 255, 7, 7};
		struct count_band band = {
			.depth = depth,
			.stencil = stencil,
			.edge = {0x7FFF, 4 * 65536 + 0x7FFF},
			.z = 5 << 10,
			.rows = 1,
			.width = 4,
			.to = 4,
			.down = down,
		};

		soft_bands.count(&band);
		assert_int_equal(stencil[0], down ? 0 : 1);
		assert_int_equal(stencil[1], down ? 254 : 255);
		assert_int_equal(stencil[2], down ? 6 : 8);
		assert_int_equal(stencil[3], 7);
	}
	(void)state;
}

static void test_the_sheet_is_as_in_c(void **state)
{
	uint32_t seed = 5;

	(void)state;
	for (int round = 0; round < 500; round++) {
		struct twins *twins = make_twins(&seed, round % 3 == 0 ? 2 : 30);
		struct flat_band band = {
			.pixels = (uint8_t *)(twins->pixel[0] + 20 * SIDE),
			.stencil = twins->stencil[0] + 20 * SIDE,
			.stride_bytes = 2 * SIDE,
			.stencil_stride = SIDE,
			.rows = random_between(&seed, 1, 20),
			.from = random_between(&seed, 0, 40),
			.to = random_between(&seed, 30, SIDE),
			.keep = (uint32_t)random_between(&seed, 0, 32),
			.reference = round % 7 ? 0 : 129,
			.unlike = true,
			.opaque = (uint16_t)next_random(&seed),
		};
		struct flat_band other;

		band.own = widen(band.opaque) * (32 - band.keep) + WIDE_ROUND;
		make_edges(&seed, band.edge, band.edge_step);
		other = band;
		other.pixels = (uint8_t *)(twins->pixel[1] + 20 * SIDE);
		other.stencil = twins->stencil[1] + 20 * SIDE;
		soft_bands.flat(&band);
		band_flat_c(&other);
		check_twins(twins);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_volumes_shade_what_the_long_way_does),
		cmocka_unit_test(test_the_count_band_is_as_in_c),
		cmocka_unit_test(test_counts_neither_wrap_up_nor_down),
		cmocka_unit_test(test_the_sheet_is_as_in_c),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
