/* The shapes, colours and moments of which overlays are made. */
#include "app/anim/math/vec.h"
#include "app/scene/overlay/overlay_ghost.h"
#include "app/scene/overlay/overlay_heat.h"
#include "app/scene/overlay/overlay_sketch.h"
#include "app/scene/stage/light.h"
#include "platform/base/compiler.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/gl/gl_state.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

static const uint8_t color[4] = {200, 100, 40, 128};

static struct overlay_sketch sketch;
static struct gl gl;

static void begin(GLenum mode)
{
	gl = gl_recorder_begin();
	overlay_sketch_begin(&sketch, &gl, mode);
}

static const float *corner(int number)
{
	return sketch.vertex[number].position;
}

/* Of a face, which is counter-clockwise seen from outside. */
static void normal_of(int face, float out[3])
{
	float ab[3], ac[3], length;

	vec_subtract(corner(3 * face + 1), corner(3 * face), ab);
	vec_subtract(corner(3 * face + 2), corner(3 * face), ac);
	vec_cross(ab, ac, out);
	length = vec_length(out);
	assert_true(length > 0);
	for (int i = 0; i < 3; i++) {
		out[i] /= length;
	}
}

/* Brightest towards the light, and 0.36 of that away from it. */
static void check_shade(int face, const float normal[3])
{
	float light[3], share;

	light_direction(light);
	share = 0.68f + 0.32f * vec_dot(normal, light);
	for (int k = 3 * face; k < 3 * face + 3; k++) {
		for (int i = 0; i < 3; i++) {
			assert_near(sketch.vertex[k].color[i],
				share * color[i] - 0.5f, 0.51);
		}
		assert_int_equal(sketch.vertex[k].color[3], 128);
	}
}

/* Each face has a tip and two corners of the base. */
static void check_spindle(
	const float a[3], const float b[3], float bulge, float radius)
{
	float axis[3], middle[3], sum[3] = {0};
	int tips[2] = {0, 0};

	vec_subtract(b, a, axis);
	vec_add_scaled(a, axis, bulge, middle);
	assert_int_equal(sketch.count, 24);
	for (int face = 0; face < 8; face++) {
		float normal[3], out[3];

		normal_of(face, normal);
		vec_subtract(corner(3 * face + 1), middle, out);
		assert_true(vec_dot(normal, out) > 0);
		check_shade(face, normal);
		for (int k = 3 * face; k < 3 * face + 3; k++) {
			float from[3];

			if (memcmp(corner(k), a, sizeof(from)) == 0 ||
				memcmp(corner(k), b, sizeof(from)) == 0) {
				tips[memcmp(corner(k), b, sizeof(from)) == 0]++;
				continue;
			}
			vec_subtract(corner(k), middle, from);
			assert_near(vec_length(from), radius, 1e-5);
			assert_near(vec_dot(from, axis), 0, 1e-5);
			vec_add_scaled(sum, from, 1, sum);
		}
	}
	assert_int_equal(tips[0], 4);
	assert_int_equal(tips[1], 4);
	assert_near(vec_length(sum), 0, 1e-4);
}

/* The sides of a face at its base are those of a square. */
static void check_square(float radius)
{
	for (int face = 0; face < 8; face++) {
		float side[3];

		vec_subtract(corner(3 * face + 1), corner(3 * face + 2), side);
		assert_near(vec_length(side), radius * sqrtf(2), 1e-5);
	}
}

static void test_a_spindle_is_a_square_between_two_tips(void **state)
{
	static const float from[3] = {0.5f, -1, 2};
	static const float ways[][3] = {{1, 0, 0}, {-2, 0, 0}, {0, 1, 0},
		{0, -0.5f, 0}, {0, 0, 3}, {0, 0, -1}, {1, 1, 0},
		{1, -0.9f, 0.3f}, {0.4f, 1, -1}, {1e-3f, 2e-3f, 0}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(ways); i++) {
		float to[3];

		vec_add_scaled(from, ways[i], 1, to);
		begin(GL_TRIANGLES);
		overlay_sketch_spindle(&sketch, from, to, 0.2f, 0.1f, color);
		check_spindle(from, to, 0.2f, 0.1f);
		check_square(0.1f);
		overlay_sketch_end(&sketch);
		assert_int_equal(sketch.count, 0);
	}
}

static void test_a_spindle_without_a_length_is_not_drawn(void **state)
{
	static const float from[3] = {0, 0, 0};

	(void)state;
	begin(GL_TRIANGLES);
	overlay_sketch_spindle(&sketch, from, from, 0.2f, 0.1f, color);
	overlay_sketch_spindle(&sketch, from, (const float[]){0, 0.9e-7f, 0},
		0.2f, 0.1f, color);
	assert_int_equal(sketch.count, 0);
	overlay_sketch_spindle(&sketch, from, (const float[]){0, 1.1e-7f, 0},
		0.2f, 0.1f, color);
	assert_int_equal(sketch.count, 24);
	overlay_sketch_end(&sketch);
}

static void test_an_octahedron_has_six_equal_arms(void **state)
{
	static const float center[3] = {1, 2, -3};

	(void)state;
	begin(GL_TRIANGLES);
	overlay_sketch_octahedron(&sketch, center, 0.5f, color);
	check_spindle((const float[]){1, 1.5f, -3},
		(const float[]){1, 2.5f, -3}, 0.5f, 0.5f);
	check_square(0.5f);
	overlay_sketch_end(&sketch);
}

/* Twice what the sketch holds, and a line more. */
static void test_any_number_of_lines_is_drawn(void **state)
{
	const struct gl_recording *drawn = gl_recorder_result();

	(void)state;
	begin(GL_LINES);
	for (int i = 0; i <= OVERLAY_SKETCH_VERTICES; i++) {
		overlay_sketch_line(&sketch, (const float[]){(float)i, 0, 1},
			(const float[]){(float)i, 2, 0}, color);
	}
	assert_int_equal(drawn->draw_count, 2);
	overlay_sketch_end(&sketch);
	assert_int_equal(drawn->draw_count, 3);
	for (int i = 0; i < 3; i++) {
		assert_int_equal(drawn->draw[i].count,
			i < 2 ? OVERLAY_SKETCH_VERTICES : 2);
	}
	assert_near(drawn->sum[0],
		(double)OVERLAY_SKETCH_VERTICES * (OVERLAY_SKETCH_VERTICES + 1),
		1);
	assert_near(drawn->sum[1], 2 * (OVERLAY_SKETCH_VERTICES + 1), 1e-3);
	assert_near(drawn->sum[2], OVERLAY_SKETCH_VERTICES + 1, 1e-3);
	/* Nothing is left to draw. */
	overlay_sketch_end(&sketch);
	assert_int_equal(drawn->draw_count, 3);
}

/* Whatever was on before; the depth test stays as it is. */
static void test_a_sketch_sets_all_that_it_depends_on(void **state)
{
	static const GLenum on[] = {
		GL_BLEND, GL_VERTEX_ARRAY, GL_COLOR_ARRAY, 0};
	static const GLenum off[] = {GL_LIGHTING, GL_TEXTURE_2D, GL_ALPHA_TEST,
		GL_CULL_FACE, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, 0};

	(void)state;
	for (int i = 0; i < 2; i++) {
		gl = gl_state_begin(i);
		overlay_sketch_begin(&sketch, &gl, GL_LINES);
		overlay_sketch_line(&sketch, (const float[]){0, 0, 0},
			(const float[]){1, 0, 0}, color);
		overlay_sketch_end(&sketch);
		gl_state_expect_on(gl_state_last(), on);
		gl_state_expect_off(gl_state_last(), off);
		assert_int_equal(gl_state_last()->mode, GL_LINES);
		assert_int_equal(
			gl_state_has(gl_state_last(), GL_DEPTH_TEST), i);
		assert_false(gl_state_has(NULL, GL_BLEND));
	}
}

/* From blue by green and amber to red. */
static void test_the_colours_of_heat_have_four_stops(void **state)
{
	static const struct {
		float sixths;
		uint8_t rgb[3];
	} rows[] = {{-1, {70, 110, 190}}, {0, {70, 110, 190}},
		{1, {70, 150, 155}}, {2, {70, 190, 120}}, {3, {158, 197, 96}},
		{4, {246, 204, 72}}, {5, {241, 132, 64}}, {6, {236, 60, 56}},
		{9, {236, 60, 56}}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		uint8_t rgb[3];

		overlay_heat_ramp(rows[i].sixths / 6, rgb);
		for (int k = 0; k < 3; k++) {
			assert_in_range(
				rgb[k] + 1, rows[i].rgb[k], rows[i].rgb[k] + 2);
		}
	}
}

/* Of all channels, the key that is nearest beyond the gap. */
static void test_a_ghost_stands_at_the_nearest_key_beyond_the_gap(void **state)
{
	static const float first[] = {0, 0.5f, 1, 2}, second[] = {0.25f, 1.75f};
	static struct model_channel channel[3] = {
		{.key_count = 4, .time_s = first},
		{.key_count = 2, .time_s = second}, {.key_count = 0}};
	const struct model_clip clip = {.channel_count = 3, .channel = channel};
	static const struct {
		float time_s, gap_s, expected_s;
	} rows[] = {{0, 0.1f, 0.25f}, {0, 0.25f, 0.25f}, {0, 0.26f, 0.5f},
		{0.5f, 0.5f, 1}, {1, 0.1f, 1.75f}, {1.8f, 0.1f, 2},
		{2, 0.1f, -1}, {2, -0.1f, 1.75f}, {2, -0.3f, 1},
		{1, -0.1f, 0.5f}, {0.5f, -0.1f, 0.25f}, {0.3f, -0.1f, 0},
		{0, -0.1f, -1}, {9, -0.5f, 2}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		assert_near(overlay_ghost_key_time(
				    &clip, rows[i].time_s, rows[i].gap_s),
			rows[i].expected_s, 0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_spindle_is_a_square_between_two_tips),
		cmocka_unit_test(test_a_spindle_without_a_length_is_not_drawn),
		cmocka_unit_test(test_an_octahedron_has_six_equal_arms),
		cmocka_unit_test(test_any_number_of_lines_is_drawn),
		cmocka_unit_test(test_a_sketch_sets_all_that_it_depends_on),
		cmocka_unit_test(test_the_colours_of_heat_have_four_stops),
		cmocka_unit_test(
			test_a_ghost_stands_at_the_nearest_key_beyond_the_gap),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
