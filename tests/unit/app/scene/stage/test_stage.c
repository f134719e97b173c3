/* The stage's background, and the shadows on its floor and on other surfaces. */
#include "app/scene/stage/light.h"
#include "app/scene/stage/stage.h"
#include "platform/base/compiler.h"
#include "tests/support/gl/gl_checks.h"
#include "tests/support/gl/gl_expect.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/gl/gl_state.h"
#include "tests/support/test.h"

#include <string.h>

static const struct bounds figure = {{-0.5f, 0.0f, -0.5f}, {0.5f, 1.0f, 0.5f}};
static struct stage stage;
static GLint stencil_bits;

static void tell_stencil_bits(GLenum name, GLint *value)
{
	assert_int_equal(name, GL_STENCIL_BITS);
	*value = stencil_bits;
}

static void set_up(const struct gl *gl, float pitch_rad)
{
	struct log log = log_to_stderr(LOG_WARNING);
	const struct camera_framing framing = {
		.aspect = (float)GL_CANVAS_WIDTH / GL_CANVAS_HEIGHT,
		.margin = 1.1f,
		.pitch_rad = pitch_rad,
	};

	assert_int_equal(stage_init(&stage, gl, &figure, 1.0f, &framing,
				 PIXELS_RGBA8888, &log),
		0);
}

static void test_a_stencil_is_used_where_there_is_one(void **state)
{
	(void)state;
	for (stencil_bits = 0; stencil_bits < 9; stencil_bits++) {
		struct gl gl = gl_state_begin(false);

		gl.GetIntegerv = tell_stencil_bits;
		set_up(&gl, 0.2f);
		assert_int_equal(stage.has_stencil, stencil_bits > 0);
		stage_finish(&stage, &gl);
	}
}

/* Seen from far below, there is no ground. */
static void test_the_background_is_a_gradient_that_hides_nothing(void **state)
{
	static const double red[4] = {1.0, 0.0, 0.0, 1.0};
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	(void)state;
	set_up(gl, -0.8f);
	/* What the last frame has left. */
	gl->Enable(GL_DEPTH_TEST);
	gl_canvas_draw_rectangle(gl, -1.0f, -1.0f, 1.0f, 1.0f, -0.9f);
	stage_begin(&stage, gl, GL_CANVAS_WIDTH, GL_CANVAS_HEIGHT);
	gl->DisableClientState(GL_COLOR_ARRAY);
	gl->MatrixMode(GL_PROJECTION);
	gl->LoadIdentity();
	gl->MatrixMode(GL_MODELVIEW);
	gl->LoadIdentity();
	gl_set_color(gl, red);
	gl_canvas_draw_rectangle(gl, 0.8f, -1.0f, 1.0f, 1.0f, 0.99f);
	gl_canvas_end_frame(&canvas);
	for (int x = 0; x < GL_CANVAS_WIDTH; x++) {
		if (x >= GL_CANVAS_WIDTH - 3) {
			gl_canvas_expect(&canvas, x, 3, 255, 0, 0, 2);
			continue;
		}
		gl_canvas_expect(&canvas, x, 0, 62, 72, 88, 3);
		gl_canvas_expect(&canvas, x, 6, 106, 116, 131, 3);
		gl_canvas_expect(&canvas, x, 11, 143, 155, 169, 3);
		gl_canvas_expect(&canvas, x, 12, 142, 154, 169, 3);
		gl_canvas_expect(&canvas, x, 14, 120, 131, 145, 6);
		gl_canvas_expect(&canvas, x, 17, 104, 114, 128, 3);
		gl_canvas_expect(
			&canvas, x, GL_CANVAS_HEIGHT - 1, 104, 114, 128, 3);
	}
	stage_finish(&stage, gl);
	gl_canvas_close(&canvas);
}

/* A camera near the ground sees no dark strip between it and the sky. */
static void test_the_sky_is_lightest_where_ground_ends_low(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	int above;

	(void)state;
	set_up(canvas.gl, 0.16f);
	stage.camera.shift_y = -0.2f;
	stage_begin(&stage, canvas.gl, GL_CANVAS_WIDTH, GL_CANVAS_HEIGHT);
	gl_canvas_end_frame(&canvas);
	above = GL_CANVAS_HEIGHT - 2 - stage.sight.strips.end_px;
	assert_in_range(above, GL_CANVAS_HEIGHT / 2 + 1, GL_CANVAS_HEIGHT - 4);
	gl_canvas_expect(&canvas, 5, above, 137, 149, 163, 3);
	/* From the middle on, it would be darker again. */
	gl_canvas_expect(&canvas, 5, GL_CANVAS_HEIGHT / 2, 132, 144, 159, 4);
	stage_finish(&stage, canvas.gl);
	gl_canvas_close(&canvas);
}

/* The state that drawing something lit or plain begins with. */
static void test_a_stage_leaves_depths_and_lights_on(void **state)
{
	static const GLenum on[] = {GL_DEPTH_TEST, GL_STATE_DEPTH_WRITES,
		GL_LIGHT0, GL_LIGHT1, GL_VERTEX_ARRAY, GL_COLOR_ARRAY, 0};
	static const GLenum off[] = {GL_LIGHTING, GL_TEXTURE_2D, GL_ALPHA_TEST,
		GL_BLEND, GL_CULL_FACE, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY,
		0};
	static const GLenum background_off[] = {GL_LIGHTING, GL_TEXTURE_2D,
		GL_ALPHA_TEST, GL_BLEND, GL_CULL_FACE, GL_NORMAL_ARRAY,
		GL_TEXTURE_COORD_ARRAY, GL_DEPTH_TEST, 0};

	(void)state;
	for (int before = 0; before < 2; before++) {
		struct gl gl = gl_state_begin(before);

		set_up(&gl, 0.3f);
		stage_begin(&stage, &gl, 48, 64);
		gl_state_expect_off(gl_state_drawn(0), background_off);
		assert_true(gl_state_has(gl_state_drawn(0), GL_COLOR_ARRAY));
		assert_int_equal(gl_state_drawn(0)->mode, GL_TRIANGLE_STRIP);
		assert_int_equal(gl_state_drawn(0)->count, 8);
		gl_state_expect_on(NULL, on);
		gl_state_expect_off(NULL, off);
		stage_finish(&stage, &gl);
	}
}

static const GLenum shadow_off[] = {GL_LIGHTING, GL_TEXTURE_2D, GL_CULL_FACE,
	GL_ALPHA_TEST, GL_DEPTH_TEST, GL_COLOR_ARRAY, GL_NORMAL_ARRAY,
	GL_TEXTURE_COORD_ARRAY, GL_STATE_DEPTH_WRITES, 0};
static const GLenum off_after_shadow[] = {GL_BLEND, GL_STENCIL_TEST, 0};

/* A point that is drawn lands where the light through it meets the height. */
static void expect_shadow_at(const double *matrix, float y)
{
	static const float points[][3] = {
		{0.0f, 1.0f, 0.0f}, {1.0f, 2.0f, -0.5f}, {-3.0f, 0.25f, 2.0f}};
	float light[3];

	light_direction(light);
	for (size_t i = 0; i < ARRAY_COUNT(points); i++) {
		const float *p = points[i];
		float fall = (p[1] - y) / light[1];

		for (int k = 0; k < 3; k++) {
			double is = matrix[12 + k];

			for (int axis = 0; axis < 3; axis++) {
				is += matrix[4 * axis + k] * (double)p[axis];
			}
			assert_near(is, p[k] - light[k] * fall, 1e-3);
		}
	}
}

static void draw_something(const struct gl *gl)
{
	static const float corners[3][3] = {
		{0.0f, 0.5f, 0.0f}, {1.0f, 0.5f, 0.0f}, {0.0f, 0.5f, 1.0f}};

	gl->VertexPointer(3, GL_FLOAT, 0, corners);
	gl->DrawArrays(GL_TRIANGLES, 0, 3);
}

static void expect_shadow(int number, float y, bool stencil)
{
	const struct gl_state_draw *draw = gl_state_drawn(number);

	gl_state_expect_off(draw, shadow_off);
	assert_true(gl_state_has(draw, GL_BLEND));
	assert_int_equal(gl_state_has(draw, GL_STENCIL_TEST), stencil);
	assert_near(draw->color[3], 0.375, 1e-4);
	expect_shadow_at(gl_recorder_result()->draw[number].matrix, y);
}

static void expect_after_shadow(void)
{
	gl_state_expect_off(NULL, off_after_shadow);
	assert_true(gl_state_has(NULL, GL_DEPTH_TEST));
	assert_true(gl_state_has(NULL, GL_STATE_DEPTH_WRITES));
	assert_int_equal(gl_recorder_result()->depth, 0);
}

static void test_shadows_fall_along_the_light_onto_the_floor(void **state)
{
	(void)state;
	for (int i = 0; i < 4; i++) {
		struct gl gl = gl_state_begin(i % 2);

		gl.Disable(GL_STENCIL_TEST);
		set_up(&gl, 0.3f);
		stage.has_stencil = i / 2;
		stage.floor.y = 0.25f;
		stage_shadow_begin(&stage, &gl);
		draw_something(&gl);
		stage_shadow_end(&stage, &gl);
		expect_shadow(0, 0.25f, i / 2);
		expect_after_shadow();
		stage_finish(&stage, &gl);
	}
}

static void test_shadows_fall_onto_level_rectangles_and_ground(void **state)
{
	float corner[4][3] = {{-1.0f, 0.5f, 1.0f}, {1.0f, 0.5f, 1.0f},
		{1.0f, 0.5f, -1.0f}, {-1.0f, 0.5f, -1.0f}};
	float light[3];

	(void)state;
	for (int before = 0; before < 2; before++) {
		struct gl gl = gl_state_begin(before);

		set_up(&gl, 0.3f);
		stage_top_begin(&stage, &gl, corner);
		draw_something(&gl);
		stage_top_end(&gl);
		assert_int_equal(gl_state_drawn(0)->mode, GL_TRIANGLE_FAN);
		assert_int_equal(gl_state_drawn(0)->count, 4);
		assert_true(gl_state_has(gl_state_drawn(0), GL_STENCIL_TEST));
		assert_false(
			gl_state_has(gl_state_drawn(0), GL_STATE_DEPTH_WRITES));
		for (int i = 0; i < 4; i++) {
			const float *is = gl_state_drawn(0)->vertex[i];

			assert_near(is[0], corner[i][0], 0.0);
			assert_near(is[1],
				corner[i][1] + 0.001f * stage.camera.distance,
				1e-5);
			assert_near(is[2], corner[i][2], 0.0);
		}
		expect_shadow(1, 0.5f, true);
		expect_after_shadow();
		light_direction(light);
		stage_ground_begin(&gl);
		assert_true(gl_state_has(NULL, GL_STENCIL_TEST));
		stage_ground_end(&gl, light, -0.75f);
		draw_something(&gl);
		stage_top_end(&gl);
		expect_shadow(2, -0.75f, true);
		expect_after_shadow();
		stage_finish(&stage, &gl);
	}
}

/* What a pixel in the middle shows with so many layers of a shadow. */
static int shade_of(int layers, bool stencil, bool on_top)
{
	float corner[4][3] = {{-1.0f, 0.0f, 1.0f}, {1.0f, 0.0f, 1.0f},
		{1.0f, 0.0f, -1.0f}, {-1.0f, 0.0f, -1.0f}};
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;
	uint8_t rgba[4];

	set_up(gl, 1.2f);
	stage.has_stencil = stencil;
	stage_begin(&stage, gl, GL_CANVAS_WIDTH, GL_CANVAS_HEIGHT);
	if (on_top) {
		stage_top_begin(&stage, gl, corner);
	} else {
		stage_shadow_begin(&stage, gl);
	}
	for (int i = 0; i < layers; i++) {
		static const float all[4][3] = {{-9.0f, 0.1f, 9.0f},
			{9.0f, 0.1f, 9.0f}, {9.0f, 0.1f, -9.0f},
			{-9.0f, 0.1f, -9.0f}};

		gl->VertexPointer(3, GL_FLOAT, 0, all);
		gl->DrawArrays(GL_TRIANGLE_FAN, 0, 4);
	}
	stage_top_end(gl);
	gl_expect_read(&canvas, GL_CANVAS_WIDTH / 2, GL_CANVAS_HEIGHT / 2, rgba);
	stage_finish(&stage, gl);
	gl_canvas_end_and_close(&canvas);
	return rgba[1];
}

static void test_overlapping_shadows_darken_once(void **state)
{
	(void)state;
	for (int on_top = 0; on_top < 2; on_top++) {
		int bright = shade_of(0, true, on_top);
		int dark = shade_of(1, true, on_top);

		assert_true(dark < bright * 3 / 4);
		assert_int_equal(shade_of(3, true, on_top), dark);
	}
	assert_true(shade_of(2, false, false) < shade_of(1, false, false));
}

/* It replaces the background and level ground, but not hills. */
static void test_a_backdrop_takes_the_place_of_the_background(void **state)
{
	static const struct live_texture picture = {.name = 1};

	(void)state;
	for (int i = 0; i < 4; i++) {
		struct gl gl = gl_state_begin(false);
		int draws;

		set_up(&gl, 0.3f);
		stage.backdrop = i & 1 ? &picture : NULL;
		floor_set_wave_height(&stage.floor, i & 2 ? 0.05f : 0.0f);
		stage_begin(&stage, &gl, 48, 64);
		draws = gl_recorder_result()->draw_count;
		assert_int_equal(gl_state_drawn(0)->count, i & 1 ? 4 : 8);
		assert_int_equal(
			gl_state_has(gl_state_drawn(0), GL_TEXTURE_2D), i & 1);
		assert_int_equal(draws == 1, i == 1);
		stage_finish(&stage, &gl);
	}
}

/* It is drawn with hills, and after the shadows on level ground. */
static void test_a_monitor_is_drawn_once(void **state)
{
	static struct monitor monitor;

	(void)state;
	for (int uneven = 0; uneven < 2; uneven++) {
		struct gl gl = gl_recorder_begin();
		int draws, body = 0;

		set_up(&gl, 0.3f);
		monitor_init(&monitor);
		monitor_place(&monitor, &stage.camera, 0.75f, 0.0f);
		stage.monitor = &monitor;
		floor_set_wave_height(&stage.floor, uneven ? 0.05f : 0.0f);
		stage_begin(&stage, &gl, 48, 64);
		assert_true(stage_may_hide(&stage, &figure));
		draws = gl_recorder_result()->draw_count;
		stage_draw_monitor(&stage, &gl);
		assert_int_equal(gl_recorder_result()->draw_count - draws,
			uneven ? 0 : 2);
		for (int i = 0; i < gl_recorder_result()->draw_count; i++) {
			body += gl_recorder_result()->draw[i].count ==
				MONITOR_INDICES;
		}
		assert_int_equal(body, 1);
		/* Its shadow is flat. */
		draws = gl_recorder_result()->draw_count;
		stage_shadow_begin(&stage, &gl);
		assert_int_equal(gl_recorder_result()->draw_count - draws, 1);
		stage_top_end(&gl);
		stage.monitor = NULL;
		draws = gl_recorder_result()->draw_count;
		stage_shadow_begin(&stage, &gl);
		stage_shadow_end(&stage, &gl);
		assert_int_equal(gl_recorder_result()->draw_count, draws);
		stage_finish(&stage, &gl);
	}
}

static void test_a_floor_is_lowered_by_a_thousandth(void **state)
{
	struct gl gl = gl_recorder_begin();

	(void)state;
	set_up(&gl, 0.3f);
	stage.floor.y = 0.5f;
	stage_lower_floor(&stage, &figure);
	assert_near(stage.floor.y, 0.499, 1e-6);
	stage_finish(&stage, &gl);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_stencil_is_used_where_there_is_one),
		cmocka_unit_test(
			test_the_background_is_a_gradient_that_hides_nothing),
		cmocka_unit_test(test_the_sky_is_lightest_where_ground_ends_low),
		cmocka_unit_test(test_a_stage_leaves_depths_and_lights_on),
		cmocka_unit_test(
			test_shadows_fall_along_the_light_onto_the_floor),
		cmocka_unit_test(
			test_shadows_fall_onto_level_rectangles_and_ground),
		cmocka_unit_test(test_overlapping_shadows_darken_once),
		cmocka_unit_test(
			test_a_backdrop_takes_the_place_of_the_background),
		cmocka_unit_test(test_a_monitor_is_drawn_once),
		cmocka_unit_test(test_a_floor_is_lowered_by_a_thousandth),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
