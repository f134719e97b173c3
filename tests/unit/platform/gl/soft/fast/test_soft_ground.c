/* Level ground of the soft driver: rectangles, and what is blended into a sky. */
#include "platform/base/fixed.h"
#include "platform/gl/gl_context.h"
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/vertex/draw.h"
#include "tests/support/gl/soft_scene.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	WIDTH = 240,
	HEIGHT = 200,
	PIXELS = WIDTH * HEIGHT,
	TILE = 64, /* texels */
};

struct ground {
	struct gl_context *context;
	struct soft *soft;
	struct pixels picture;
	uint16_t pixel[PIXELS];
};

/* Tiles with joints, in all levels. */
static void make_tiles(const struct gl *gl)
{
	uint8_t texel[TILE * TILE];
	GLuint name;

	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->TexParameterx(
		GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	for (int level = 0, side = TILE; side; level++, side /= 2) {
		for (int i = 0; i < side * side; i++) {
			int x = i % side, y = i / side, half = side / 2;

			int luminance = (x < half) != (y < half) ? 230 : 252;

			if (half == 0) {
				luminance = 235;
			} else if (side > 4 && (x % half == 0 || y % half == 0)) {
				luminance = 192 + 10 * level;
			}
			texel[i] = (uint8_t)luminance;
		}
		gl->TexImage2D(GL_TEXTURE_2D, level, GL_LUMINANCE, side, side,
			0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texel);
	}
}

static struct ground *open_ground(void)
{
	struct log log = log_to_stderr(LOG_WARNING);
	struct ground *ground = calloc(1, sizeof(*ground));
	const struct gl *gl;

	assert_non_null(ground);
	assert_int_equal(gl_open("soft",
				 &(struct gl_request){
					 .format = PIXELS_RGB565, .log = &log},
				 &ground->context),
		0);
	ground->soft = (struct soft *)(void *)ground->context;
	ground->picture = (struct pixels){.data = (uint8_t *)ground->pixel,
		.width = WIDTH,
		.height = HEIGHT,
		.stride_bytes = WIDTH * 2,
		.format = PIXELS_RGB565};
	assert_int_equal(ground->context->driver->begin_frame(
				 ground->context, &ground->picture),
		0);
	gl = &ground->context->gl;
	make_tiles(gl);
	gl->Viewport(0, 0, WIDTH, HEIGHT);
	gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	gl->MatrixMode(GL_PROJECTION);
	gl->Frustumx(-FX16_ONE / 16, FX16_ONE / 16, -FX16_ONE / 16,
		FX16_ONE / 16, FX16_ONE / 8, FX16_ONE * 40);
	gl->Enable(GL_DEPTH_TEST);
	gl->DepthFunc(GL_ALWAYS);
	gl->Enable(GL_TEXTURE_2D);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	return ground;
}

static void close_ground(struct ground *ground)
{
	ground->context->driver->end_frame(ground->context);
	ground->context->driver->destroy(ground->context);
	free(ground);
}

/*
 * A strip of ground below the eye, from depth to depth, as wide as the picture.
 * slant moves one corner so that it is no rectangle any more.
 */
struct strip {
	float near, far, turn, slant;
	uint8_t alpha[2];
	bool apart; /* as two triangles without anything in common */
};

static void draw_strip(const struct ground *ground, const struct strip *strip)
{
	static const uint16_t list[6] = {0, 1, 2, 2, 1, 3};
	const struct gl *gl = &ground->context->gl;
	float position[4][3], texcoord[4][2];
	uint8_t color[4][4];

	for (int i = 0; i < 4; i++) {
		float depth = i < 2 ? strip->near : strip->far;
		float x = (i % 2 ? 0.497f : -0.497f) * depth;

		x += i == 3 ? strip->slant * depth : 0.0f;
		position[i][0] = x;
		position[i][1] = -0.6f;
		position[i][2] = -depth;
		texcoord[i][0] = x + strip->turn * depth;
		texcoord[i][1] = depth - strip->turn * x;
		memset(color[i], 208, 3);
		color[i][3] = strip->alpha[i / 2];
	}
	gl->VertexPointer(3, GL_FLOAT, 0, position);
	gl->TexCoordPointer(2, GL_FLOAT, 0, texcoord);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, color);
	if (strip->apart) {
		gl->DrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_SHORT, list);
	} else {
		gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
	}
}

static struct strip random_strip(uint32_t *seed)
{
	float near = (float)random_between(seed, 125, 170) / 100.0f;

	return (struct strip){.near = near,
		.far = near * (float)random_between(seed, 120, 900) / 100.0f,
		.turn = (float)random_within(seed, 1000) / 1000.0f,
		.slant = random_between(seed, 0, 3)
			? 0.0f
			: (float)random_between(seed, -200, -20) / 1000.0f,
		.alpha = {255, (uint8_t)random_between(seed, 0, 255)}};
}

/* Depth and coverage are the same, colours but on a line that is a bit aside. */
static void compare(const struct ground *a, const struct ground *b)
{
	int covered = 0, other = 0, far = 0;

	for (int i = 0; i < PIXELS; i++) {
		int depth = a->soft->buffers.depth[i];

		assert_true(abs(depth - b->soft->buffers.depth[i]) <= 1);
		assert_int_equal(a->pixel[i] == 0, b->pixel[i] == 0);
		covered += a->pixel[i] != 0;
		other += soft_scene_steps(a->pixel[i], b->pixel[i]) > 1;
		far += soft_scene_steps(a->pixel[i], b->pixel[i]) > 3;
	}
	assert_true(covered > 2000);
	assert_true(other * 25 < covered);
	assert_true(far * 200 < covered);
}

static int counted;

static void count_fill(struct draw *draw, struct setup *setup)
{
	counted++;
	soft_fill_luminance(draw, setup);
}

static void test_a_rectangle_is_its_two_triangles(void **state)
{
	uint32_t seed = 3;

	(void)state;
	for (int round = 0; round < 200; round++) {
		struct ground *one = open_ground(), *two = NULL;
		struct strip strip = random_strip(&seed);

		strip.alpha[1] = 255;
		draw_strip(one, &strip);
		assert_ptr_equal(one->soft->draw->fill, soft_fill_luminance);
		assert_null(one->soft->draw->fourth);
		two = open_ground();
		strip.apart = true;
		draw_strip(two, &strip);
		compare(one, two);
		close_ground(two);
		close_ground(one);
	}
}

/* The path counts calls if the strip is drawn through it, triangle by triangle. */
static void test_what_is_no_rectangle_stays_two_triangles(void **state)
{
	const struct strip strip = {
		.near = 1.4f, .far = 6.0f, .slant = -0.1f, .alpha = {255, 255}};
	struct ground *ground = open_ground();

	(void)state;
	ground->soft->fill = count_fill;
	ground->soft->changed = GROUP_ALL;
	counted = 0;
	draw_strip(ground, &strip);
	assert_int_equal(counted, 2);
	close_ground(ground);
}

/* A pixel of another colour in each row takes the row the long way. */
static void test_a_row_of_one_color_is_blended_as_others_are(void **state)
{
	uint32_t seed = 5;

	(void)state;
	for (int round = 0; round < 100; round++) {
		struct strip strip = random_strip(&seed);
		uint16_t sky = (uint16_t)next_random(&seed);
		struct ground *ground[2];
		int at = random_between(&seed, 0, WIDTH - 1);

		for (int i = 0; i < 2; i++) {
			ground[i] = open_ground();
			for (int j = 0; j < PIXELS; j++) {
				ground[i]->pixel[j] =
					(uint16_t)(sky + j / WIDTH);
			}
			for (int y = 0; i && y < HEIGHT; y++) {
				ground[i]->pixel[y * WIDTH + at] ^= 0x8410;
			}
			ground[i]->context->gl.Enable(GL_BLEND);
			ground[i]->context->gl.BlendFunc(
				GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
			draw_strip(ground[i], &strip);
		}
		for (int i = 0; i < PIXELS; i++) {
			if (i % WIDTH != at) {
				assert_int_equal(ground[0]->pixel[i],
					ground[1]->pixel[i]);
			}
		}
		close_ground(ground[1]);
		close_ground(ground[0]);
	}
}

/* At each level of the tiles, after a strip that can be seen. */
static void test_ground_that_cannot_be_seen_leaves_the_sky(void **state)
{
	struct ground *ground = open_ground();
	const struct gl *gl = &ground->context->gl;

	(void)state;
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	for (int depth = 12; depth < 120; depth++) {
		float near = (float)depth / 10.0f;
		struct strip strip = {
			.near = near, .far = 1.05f * near, .alpha = {128, 128}};
		uint16_t sky = depth % 2 ? 0x0000 : 0x8410;

		draw_strip(ground, &strip);
		for (int i = 0; i < PIXELS; i++) {
			ground->pixel[i] = sky;
		}
		strip.alpha[0] = strip.alpha[1] = 0;
		draw_strip(ground, &strip);
		for (int i = 0; i < PIXELS; i++) {
			assert_int_equal(ground->pixel[i], sky);
		}
	}
	close_ground(ground);
}

/* Ground that leans to a side, by degrees in 16.16. */
static struct ground *open_leaning(GLfixed degrees)
{
	struct ground *ground = open_ground();

	ground->context->gl.MatrixMode(GL_MODELVIEW);
	ground->context->gl.Rotatex(degrees, 0, 0, FX16_ONE);
	return ground;
}

static void test_depths_of_leaning_ground_follow_its_plane(void **state)
{
	static const GLfixed degrees[] = {0, 16, 100, 700, -3000, 20000,
		-FX16_ONE, 4 * FX16_ONE, 20 * FX16_ONE};
	const struct strip strip = {
		.near = 1.4f, .far = 6.0f, .alpha = {255, 255}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(degrees); i++) {
		struct ground *one = open_leaning(degrees[i]), *other = NULL;

		draw_strip(one, &strip);
		assert_ptr_equal(one->soft->draw->fill, soft_fill_luminance);
		other = open_leaning(degrees[i]);
		other->soft->fill = soft_rows_fill;
		other->soft->changed = GROUP_ALL;
		draw_strip(other, &strip);
		compare(one, other);
		close_ground(other);
		close_ground(one);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_rectangle_is_its_two_triangles),
		cmocka_unit_test(test_what_is_no_rectangle_stays_two_triangles),
		cmocka_unit_test(
			test_a_row_of_one_color_is_blended_as_others_are),
		cmocka_unit_test(test_ground_that_cannot_be_seen_leaves_the_sky),
		cmocka_unit_test(test_depths_of_leaning_ground_follow_its_plane),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
