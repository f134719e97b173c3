/* How the floor is made, and how it reaches GL. */
#include "app/scene/stage/floor.h"
#include "platform/base/compiler.h"
#include "tests/support/gl/gl_state.h"
#include "tests/support/gl/texture_sent.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

static struct floor ground;
static struct floor_sight sight;

static struct bounds cube(float side)
{
	return (struct bounds){{-0.5f * side, 0.25f, -0.5f * side},
		{0.5f * side, 0.25f + side, 0.5f * side}};
}

static void make_floor(float side, float unit, float min_radius)
{
	struct gl gl = texture_sent_begin();
	struct log log = log_to_stderr(LOG_WARNING);
	struct bounds bounds = side > 0.0f ? cube(side) : bounds_empty();

	assert_int_equal(floor_init(&ground, &gl, &bounds, unit, min_radius,
				 PIXELS_RGB565, &log),
		0);
}

/* The largest 1, 2 or 5 of its decade that is 1% above half the box at most. */
static void test_tiles_are_a_round_number_of_units_wide(void **state)
{
	static const struct {
		float side, tile;
	} cases[] = {{0.0f, 0.5f}, {0.019f, 0.005f}, {0.02f, 0.01f},
		{1.0f, 0.5f}, {1.97f, 0.5f}, {1.99f, 1.0f}, {2.0f, 1.0f},
		{3.9f, 1.0f}, {3.98f, 2.0f}, {4.0f, 2.0f}, {9.8f, 2.0f},
		{9.92f, 5.0f}, {10.0f, 5.0f}, {19.0f, 5.0f}, {19.9f, 10.0f},
		{25.0f, 10.0f}, {1000.0f, 500.0f}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		float tile = cases[i].tile, side = cases[i].side;

		make_floor(side, 1.0f, 0.0f);
		assert_near(ground.tile, tile, 1e-4f * tile);
		if (side > 0.0f) {
			make_floor(0.25f * side, 0.25f, 0.0f);
			assert_near(ground.tile, 0.25f * tile, 1e-4f * tile);
		}
	}
}

static void test_the_floor_lies_below_its_box_and_around_it(void **state)
{
	(void)state;
	make_floor(2.0f, 1.0f, 1.0f);
	assert_near(ground.y, 0.25, 1e-6);
	assert_near(ground.radius, 4.4, 1e-5);
	make_floor(2.0f, 1.0f, 7.0f);
	assert_near(ground.radius, 7.0, 0.0);
	make_floor(0.0f, 1.0f, 1.0f);
	assert_near(ground.radius, 2.2, 1e-5);
}

/* Two shades of a quarter each, twice, between darker joints. */
static void test_a_tile_shows_four_squares_and_joints(void **state)
{
	const struct texture_sent_level *level = &texture_sent.level[0];

	(void)state;
	make_floor(2.0f, 1.0f, 1.0f);
	assert_int_equal(level->width, 64);
	assert_int_equal(level->height, 64);
	assert_int_equal(level->format, GL_LUMINANCE);
	assert_int_equal(texture_sent.wrap_s, GL_REPEAT);
	assert_int_equal(texture_sent.wrap_t, GL_REPEAT);
	assert_true(texture_sent.level_count > 4);
	for (int i = 0; i < 64 * 64; i++) {
		int x = i % 64, y = i / 64;
		bool joint = x % 32 == 0 || y % 32 == 0;
		bool dark = (x < 32) != (y < 32);

		assert_int_equal(level->data[i],
			joint          ? 192
				: dark ? 233
				       : 252);
	}
}

static void test_a_floor_is_released_once(void **state)
{
	struct gl gl;

	(void)state;
	make_floor(2.0f, 1.0f, 1.0f);
	gl = texture_sent_begin();
	texture_sent.deleted = 0;
	floor_finish(&ground, &gl);
	floor_finish(&ground, &gl);
	assert_int_equal(texture_sent.deleted, 1);
}

/* Offsets and heights repeat after eight tiles. */
static void test_scrolling_repeats(void **state)
{
	static const float steps[][2] = {{3.0f, 3.0f}, {-1.0f, 7.0f},
		{8.0f, 0.0f}, {17.0f, 1.0f}, {1001.0f, 1.0f}, {-7999.0f, 1.0f},
		{-8.0f, 0.0f}, {1e9f, 0.0f}, {-1e9f, 0.0f}, {NAN, 0.0f}};

	(void)state;
	make_floor(2.0f, 1.0f, 1.0f);
	for (size_t i = 0; i < ARRAY_COUNT(steps); i++) {
		ground.offset[0] = ground.offset[1] = 0.0f;
		floor_scroll(&ground, steps[i][0], 0.0f);
		assert_near(ground.offset[0], steps[i][1], 1e-4);
		assert_near(ground.offset[1], 0.0, 0.0);
		floor_scroll(&ground, 0.0f, steps[i][0]);
		assert_near(ground.offset[1], steps[i][1], 1e-4);
	}
	ground.offset[0] = ground.offset[1] = 0.0f;
	floor_set_wave_height(&ground, 0.5f);
	for (int i = 0; i < 40; i++) {
		float x = 0.37f * (float)i, z = 0.71f * (float)i;
		float height = floor_height(&ground, x, z);

		assert_near(floor_height(&ground, x + 8.0f, z), height, 1e-4);
		assert_near(floor_height(&ground, x, z + 8.0f), height, 1e-4);
		floor_scroll(&ground, 0.5f, 0.25f);
		assert_near(floor_height(&ground, x - 0.5f, z - 0.25f), height,
			1e-4);
		floor_scroll(&ground, -0.5f, -0.25f);
	}
}

static void test_waves_are_as_high_as_they_may_be(void **state)
{
	float low = 9.0f, high = -9.0f;

	(void)state;
	make_floor(2.0f, 1.0f, 1.0f);
	floor_set_wave_height(&ground, 0.5f);
	for (int i = 0; i < 80 * 80; i++) {
		float height = floor_height(&ground, 0.1f * (float)(i % 80),
			0.1f * (float)(i / 80));

		low = fminf(low, height);
		high = fmaxf(high, height);
	}
	assert_in_range((int)(1000.0f * (high - 0.25f)), 480, 500);
	assert_in_range((int)(1000.0f * (0.25f - low)), 480, 500);
}

/* By four times how far the mesh may be off, within parts of the distance. */
static void test_what_lies_on_the_ground_is_lifted_towards_the_eye(void **state)
{
	static const float eyes[][3] = {
		{0.0f, 2.0f, 3.0f}, {0.0f, 0.5f, 1.0f}, {40.0f, 3.0f, -30.0f}};
	static const float heights[] = {0.0f, 0.001f, 0.02f, 0.5f};
	int within = 0;

	(void)state;
	make_floor(2.0f, 1.0f, 1.0f);
	for (size_t i = 0; i < ARRAY_COUNT(eyes) * ARRAY_COUNT(heights); i++) {
		const float *eye = eyes[i / ARRAY_COUNT(heights)];
		float from[3] = {0.3f, 0.0f, -0.4f}, at[3], error, share;

		floor_set_wave_height(
			&ground, heights[i % ARRAY_COUNT(heights)]);
		from[1] = floor_height(&ground, from[0], from[2]);
		memcpy(at, from, sizeof(at));
		floor_lift(&ground, eye, at);
		error = floor_mesh_error(&ground, eye, from[0], from[2]);
		share = 4.0f * error / (eye[1] - from[1]);
		within += share > 0.004f && share < 0.1f;
		share = fminf(fmaxf(share, 0.004f), 0.1f);
		for (int axis = 0; axis < 3; axis++) {
			assert_near(at[axis],
				from[axis] + share * (eye[axis] - from[axis]),
				1e-4);
		}
	}
	assert_true(within > 0);
}

static const GLenum always_on[] = {GL_TEXTURE_2D, GL_VERTEX_ARRAY,
	GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY, 0};
static const GLenum always_off[] = {
	GL_LIGHTING, GL_CULL_FACE, GL_NORMAL_ARRAY, 0};
static const GLenum off_after[] = {
	GL_LIGHTING, GL_BLEND, GL_TEXTURE_2D, GL_TEXTURE_COORD_ARRAY, 0};

/* The arrays and the comparison of depths that each draw call found. */
static struct {
	GLenum depth;
	const float (*texcoord)[2];
	const uint8_t (*color)[4];
	void (*draw_arrays)(GLenum mode, GLint first, GLsizei count);
	void (*draw_elements)(
		GLenum mode, GLsizei count, GLenum type, const void *indices);
} sent;

static void keep_depth(GLenum function)
{
	sent.depth = function;
}

static void keep_texcoord(
	GLint size, GLenum type, GLsizei stride, const void *pointer)
{
	assert_int_equal(size, 2);
	assert_int_equal(type, GL_FLOAT);
	assert_int_equal(stride, 0);
	sent.texcoord = pointer;
}

static void keep_color(
	GLint size, GLenum type, GLsizei stride, const void *pointer)
{
	assert_int_equal(size, 4);
	assert_int_equal(type, GL_UNSIGNED_BYTE);
	assert_int_equal(stride, 0);
	sent.color = pointer;
}

static void expect_vertex(int i, const float position[3], uint8_t alpha)
{
	for (int k = 0; k < 2; k++) {
		assert_near(sent.texcoord[i][k],
			(position[2 * k] - ground.origin[k]) / ground.tile,
			1e-4);
	}
	for (int k = 0; k < 3; k++) {
		assert_in_range(sent.color[i][k], 90, 255);
		assert_int_equal(sent.color[i][k], sent.color[i][0]);
	}
	assert_int_equal(sent.color[i][3], alpha);
}

static void check_strip(GLenum mode, GLint first, GLsizei count)
{
	assert_int_equal(sent.depth, GL_ALWAYS);
	assert_in_range(first, 0, 2);
	for (int i = 0; i < 6; i++) {
		expect_vertex(
			i, sight.strips.position[i], sight.strips.alpha[i]);
		assert_int_equal(sent.color[i][0], 208);
	}
	sent.draw_arrays(mode, first, count);
}

static void check_mesh(
	GLenum mode, GLsizei count, GLenum type, const void *indices)
{
	assert_int_equal(sent.depth, GL_ALWAYS);
	for (int i = 0; i < FLOOR_VERTICES; i++) {
		expect_vertex(i, sight.mesh.position[i], sight.mesh.alpha[i]);
		assert_int_equal(sent.color[i][0], sight.shade[i]);
	}
	sent.draw_elements(mode, count, type, indices);
}

static struct gl begin(bool enabled)
{
	struct gl gl = gl_state_begin(enabled);

	memset(&sent, 0, sizeof(sent));
	sent.draw_arrays = gl.DrawArrays;
	sent.draw_elements = gl.DrawElements;
	gl.DepthFunc = keep_depth;
	gl.TexCoordPointer = keep_texcoord;
	gl.ColorPointer = keep_color;
	gl.DrawArrays = check_strip;
	gl.DrawElements = check_mesh;
	return gl;
}

static void expect_after(void)
{
	gl_state_expect_off(NULL, off_after);
	assert_true(gl_state_has(NULL, GL_STATE_DEPTH_WRITES));
	assert_int_equal(sent.depth, GL_LESS);
}

static void expect_quad(int number, int first, bool fading)
{
	const struct gl_state_draw *draw = gl_state_drawn(number);

	gl_state_expect_on(draw, always_on);
	gl_state_expect_off(draw, always_off);
	assert_int_equal(draw->mode, GL_TRIANGLE_STRIP);
	assert_int_equal(draw->count, 4);
	assert_int_equal(gl_state_has(draw, GL_BLEND), fading);
	assert_int_equal(gl_state_has(draw, GL_STATE_DEPTH_WRITES), !fading);
	assert_all_near(draw->vertex[0], sight.strips.position[first], 12, 0.0);
}

/* Ground that fades is blended and hides nothing below it. */
static void test_level_ground_is_drawn_in_two_quads(void **state)
{
	static const struct floor_content anything = {.bounded = false};
	struct camera camera = camera_default();

	(void)state;
	make_floor(4.0f, 1.0f, 1.0f); /* tiles of 2 units */
	floor_scroll(&ground, 0.5f, 0.25f);
	floor_find_sight(&ground, &camera, 48, 64, &anything, &sight);
	assert_true(sight.strips.opaque && sight.strips.fading);
	for (int i = 0; i < 6; i++) {
		struct gl gl = begin(i % 2);

		gl.DepthMask(GL_TRUE);
		sight.strips.opaque = i / 2 != 1;
		sight.strips.fading = i / 2 != 2;
		floor_draw(&ground, &sight, &gl);
		if (sight.strips.opaque) {
			expect_quad(0, 0, false);
		}
		if (sight.strips.fading) {
			expect_quad(sight.strips.opaque, 2, true);
		}
		assert_true(sight.strips.fading ==
			gl_state_has(gl_state_last(), GL_BLEND));
		expect_after();
	}
}

static void test_uneven_ground_is_drawn_in_runs(void **state)
{
	static const struct floor_content anything = {.bounded = false};
	struct camera camera = camera_default();

	(void)state;
	make_floor(4.0f, 1.0f, 1.0f);
	floor_set_wave_height(&ground, 0.1f);
	floor_find_sight(&ground, &camera, 48, 64, &anything, &sight);
	assert_true(sight.mesh.seen);
	assert_in_range(sight.order.run_count, 1, GL_STATE_DRAWS);
	sight.order.run[0].with_depth = false;
	for (int before = 0; before < 2; before++) {
		struct gl gl = begin(before);
		int at = 0;

		floor_draw(&ground, &sight, &gl);
		for (int i = 0; i < sight.order.run_count; i++) {
			const struct floor_run *run = &sight.order.run[i];
			const struct gl_state_draw *draw = gl_state_drawn(i);
			uint16_t first = sight.order.index[at];

			gl_state_expect_on(draw, always_on);
			gl_state_expect_off(draw, always_off);
			assert_int_equal(draw->mode, GL_TRIANGLES);
			assert_int_equal(draw->count, run->index_count);
			assert_int_equal(
				gl_state_has(draw, GL_BLEND), run->fading);
			assert_int_equal(
				gl_state_has(draw, GL_STATE_DEPTH_WRITES),
				run->with_depth);
			assert_all_near(draw->vertex[0],
				sight.mesh.position[first], 3, 0.0);
			at += run->index_count;
		}
		expect_after();
	}
	for (int i = 0; i < FLOOR_VERTICES; i++) {
		const float *p = sight.mesh.position[i];

		assert_near(p[1], floor_height(&ground, p[0], p[2]), 1e-5);
	}
}

/*
 * The waves' slope along x and z together, where the light comes from, at a
 * hundredth of a tile along them: between the heights that are compared.
 */
static double slope_at(const struct floor *floor, const float at[3])
{
	double turn = 2 * 3.14159265 / (8 * (double)floor->tile);
	double u = (double)(at[0] + floor->offset[0]) * turn + 0.0078540;
	double v = (double)(at[2] + floor->offset[1]) * turn + 0.0078540;
	double inner = cos(2 * v + sin(u));

	return 0.5 * (double)floor->wave_height * turn *
		(inner * (cos(u) + 2) + cos(u + 0.7));
}

/* By four fifths of the slope, of 208 on level ground, from 90 to 255. */
static void test_slopes_towards_the_light_are_brighter(void **state)
{
	const struct floor_content nothing = {.bounded = true,
		.standing = bounds_empty(),
		.lying = bounds_empty()};
	static struct floor floor = {.radius = 6, .tile = 0.5f};
	struct camera camera = camera_default();
	int clamped = 0;

	(void)state;
	camera.distance = 4;
	camera.target[1] = 1;
	floor_mesh_list(floor.index);
	for (int i = 0; i < 8; i++) {
		floor.wave_height = i % 2 ? 0.5f : 0.1f;
		floor.offset[0] = 0.7f * (float)i;
		camera.yaw_rad = 0.5f * (float)i;
		floor_find_sight(&floor, &camera, 480, 640, &nothing, &sight);
		assert_true(sight.mesh.seen);
		for (int v = 0; v < FLOOR_VERTICES; v++) {
			const float *at = sight.mesh.position[v];
			double shade = 208 * (1 - 0.8 * slope_at(&floor, at));

			clamped += shade < 90 || shade > 255;
			assert_near(sight.shade[v], fmax(90, fmin(shade, 255)),
				1.5);
		}
	}
	assert_in_range(clamped, 30, 300);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_tiles_are_a_round_number_of_units_wide),
		cmocka_unit_test(test_the_floor_lies_below_its_box_and_around_it),
		cmocka_unit_test(test_a_tile_shows_four_squares_and_joints),
		cmocka_unit_test(test_a_floor_is_released_once),
		cmocka_unit_test(test_scrolling_repeats),
		cmocka_unit_test(test_waves_are_as_high_as_they_may_be),
		cmocka_unit_test(
			test_what_lies_on_the_ground_is_lifted_towards_the_eye),
		cmocka_unit_test(test_level_ground_is_drawn_in_two_quads),
		cmocka_unit_test(test_uneven_ground_is_drawn_in_runs),
		cmocka_unit_test(test_slopes_towards_the_light_are_brighter),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
