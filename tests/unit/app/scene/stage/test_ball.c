/* The ball: a closed surface that faces outward. */
#include "app/scene/stage/ball.h"

#include "app/anim/math/vec.h"
#include "app/scene/stage/light.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/gl/gl_state.h"
#include "tests/support/test.h"

#include <math.h>

static struct ball ball;

static void test_every_vertex_lies_on_the_ball(void **state)
{
	(void)state;
	ball_init(&ball);
	for (int v = 0; v < BALL_VERTICES; v++) {
		assert_near(vec_length(ball.normal[v]), 1.0, 1e-5);
	}
	assert_near(ball.normal[0][1], 1.0, 1e-6);
	assert_near(ball.normal[BALL_VERTICES - 1][1], -1.0, 1e-6);
}

/* Of the whole surface: a triangle too few, or a wrong one, would show. */
static void test_triangles_face_outward_and_leave_no_hole(void **state)
{
	double area = 0.0, expected = 0.0;

	(void)state;
	ball_init(&ball);
	for (int i = 0; i < BALL_INDICES; i += 3) {
		const float *a = ball.normal[ball.index[i]];
		float b[3], c[3], cross[3];

		assert_in_range(ball.index[i], 0, BALL_VERTICES - 1);
		vec_subtract(ball.normal[ball.index[i + 1]], a, b);
		vec_subtract(ball.normal[ball.index[i + 2]], a, c);
		vec_cross(b, c, cross);
		assert_true(vec_dot(cross, a) > -1e-6f);
		area += 0.5 * (double)vec_length(cross);
	}
	/* Rings of trapezoids between circles of the ball. */
	for (int ring = 0; ring < BALL_RINGS; ring++) {
		double step = 3.14159265358979 / BALL_RINGS;
		double half = 3.14159265358979 / BALL_SPOKES;
		double upper = sin(ring * step), lower = sin((ring + 1) * step);
		double fall = cos(ring * step) - cos((ring + 1) * step);
		double out = (lower - upper) * cos(half);

		expected += BALL_SPOKES * sin(half) * (upper + lower) *
			sqrt(fall * fall + out * out);
	}
	assert_near(area, expected, 1e-4);
}

/* Where the line from the eye through a point meets the ground beyond it. */
static void find_ground(const struct floor *floor, const float eye[3],
	const float through[3], float out[3])
{
	float low = 1, high = 2, way[3];

	vec_subtract(through, eye, way);
	for (int i = 0; i < 40; i++) {
		float middle = 0.5f * (low + high);

		vec_add_scaled(eye, way, middle, out);
		*(out[1] > floor_height(floor, out[0], out[2]) ? &low : &high) =
			middle;
	}
}

/* Seen from the light, its corners are at the radius from the ball's centre. */
static void check_outline(const struct stage *stage, const float center[3],
	float radius, float tolerance)
{
	const struct gl_state_draw *drawn = gl_state_last();
	float light[3], eye[3], last[3], sum[3] = {0, 0, 0};

	light_direction(light);
	camera_eye(&stage->camera, eye);
	assert_int_equal(drawn->mode, GL_TRIANGLE_FAN);
	assert_int_equal(drawn->count, 16);
	for (int i = 0; i <= 16; i++) {
		float ground[3], from[3], step[3];

		find_ground(&stage->floor, eye, drawn->vertex[i % 16], ground);
		vec_subtract(ground, center, from);
		vec_add_scaled(from, light,
			-vec_dot(from, light) / vec_dot(light, light), from);
		assert_near(vec_length(from), radius, tolerance);
		if (i > 0) {
			vec_subtract(from, last, step);
			assert_near(vec_length(step),
				2 * radius * sinf(3.1415927f / 16), tolerance);
			vec_add_scaled(sum, from, 1, sum);
		}
		for (int k = 0; k < 3; k++) {
			last[k] = from[k];
		}
	}
	assert_near(vec_length(sum) / 16, 0, tolerance);
}

static void test_the_shadow_is_the_balls_outline_along_the_light(void **state)
{
	static const GLenum on[] = {GL_BLEND, GL_VERTEX_ARRAY, 0};
	static const GLenum off[] = {GL_LIGHTING, GL_TEXTURE_2D, GL_CULL_FACE,
		GL_COLOR_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY,
		GL_STATE_DEPTH_WRITES, 0};
	static const float center[3] = {0.5f, 1, -0.25f};
	static struct stage stage;

	(void)state;
	for (int i = 0; i < 4; i++) {
		struct gl gl = gl_state_begin(i % 2);

		stage.camera = camera_default();
		stage.floor = (struct floor){.y = -0.5f,
			.tile = 1,
			.radius = 9,
			.wave_height = i / 2 ? 0.1f : 0};
		ball_draw_shadow(&gl, center, 0.3f, &stage);
		gl_state_expect_on(gl_state_last(), on);
		gl_state_expect_off(gl_state_last(), off);
		assert_near(gl_state_last()->color[3], 0.375, 1e-4);
		assert_false(gl_state_has(NULL, GL_BLEND));
		assert_true(gl_state_has(NULL, GL_STATE_DEPTH_WRITES));
		check_outline(&stage, center, 0.3f, i / 2 ? 0.01f : 1e-4f);
	}
}

static void test_a_ball_is_drawn_at_its_place_in_its_size(void **state)
{
	static const float center[3] = {0.5f, 1, -0.25f}, red[3] = {1, 0, 0};
	struct gl gl = gl_recorder_begin();
	const struct gl_recording *drawn = gl_recorder_result();

	(void)state;
	ball_init(&ball);
	ball_draw(&ball, &gl, center, 0.3f, red);
	assert_int_equal(drawn->draw_count, 1);
	assert_int_equal(drawn->draw[0].count, BALL_INDICES);
	for (int i = 0; i < 3; i++) {
		assert_near(drawn->draw[0].matrix[5 * i], 0.3, 1e-4);
		assert_near(drawn->draw[0].matrix[12 + i], center[i], 1e-4);
	}
	assert_int_equal(drawn->depth, 0);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_every_vertex_lies_on_the_ball),
		cmocka_unit_test(test_triangles_face_outward_and_leave_no_hole),
		cmocka_unit_test(
			test_the_shadow_is_the_balls_outline_along_the_light),
		cmocka_unit_test(test_a_ball_is_drawn_at_its_place_in_its_size),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
