/* What stands on the stage, as it reaches GL: state, places and colours. */
#include "app/anim/math/vec.h"
#include "app/scene/stage/ball.h"
#include "app/scene/stage/light.h"
#include "platform/base/compiler.h"
#include "tests/support/gl/gl_checks.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/gl/gl_state.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

static struct stage stage;
static struct ball ball;

/* A camera above ground that is level, or has waves. */
static void set_up(float wave_height)
{
	memset(&stage, 0, sizeof(stage));
	stage.camera = camera_default();
	stage.floor.radius = 10.0f;
	stage.floor.tile = 1.0f;
	stage.floor.y = 0.25f;
	floor_set_wave_height(&stage.floor, wave_height);
	ball_init(&ball);
}

/* Where the line from the eye through a point meets the ground. */
static void find_ground(const float eye[3], const float point[3], float out[3])
{
	float near = 0.0f, far = 4.0f;

	for (int i = 0; i < 40; i++) {
		float middle = 0.5f * (near + far);

		vec_mix(eye, point, middle, out);
		if (out[1] > floor_height(&stage.floor, out[0], out[2])) {
			near = middle;
		} else {
			far = middle;
		}
	}
}

/*
 * The shadow's corners lie on the ground, lifted a little towards the eye, and
 * along the light they are the corners of a regular polygon around the ball.
 */
static void expect_shadow(const float center[3], float radius, float tolerance)
{
	const struct gl_state_draw *draw = gl_state_last();
	float eye[3], light[3], spoke[16][3], turn[3];

	camera_eye(&stage.camera, eye);
	light_direction(light);
	assert_int_equal(draw->mode, GL_TRIANGLE_FAN);
	assert_int_equal(draw->count, 16);
	for (int i = 0; i < 16; i++) {
		float on_ground[3], from[3], lift[3], sight[3];

		find_ground(eye, draw->vertex[i], on_ground);
		vec_subtract(draw->vertex[i], on_ground, lift);
		vec_subtract(eye, on_ground, sight);
		assert_true(vec_length(lift) < 0.11f * vec_length(sight));
		vec_subtract(on_ground, center, from);
		vec_add_scaled(from, light,
			-vec_dot(from, light) / vec_dot(light, light), spoke[i]);
		assert_near(vec_length(spoke[i]), radius, tolerance);
	}
	for (int i = 0; i < 16; i++) {
		const float *next = spoke[(i + 1) % 16];

		assert_near(vec_dot(spoke[i], next) / (radius * radius),
			cos(3.14159265 / 8.0), 4.0f * tolerance / radius);
		vec_cross(spoke[i], next, turn);
		assert_true(vec_dot(turn, light) > 0.0f);
	}
}

static void test_a_balls_shadow_is_its_outline_along_the_light(void **state)
{
	static const float places[][3] = {
		{0.0f, 0.75f, 0.0f}, {1.0f, 1.5f, -2.0f}, {-1.3f, 0.5f, 0.7f}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(places); i++) {
		struct gl gl = gl_state_begin(false);

		set_up(0.0f);
		ball_draw_shadow(&gl, places[i], 0.3f, &stage);
		expect_shadow(places[i], 0.3f, 0.001f);
		set_up(0.05f);
		ball_draw_shadow(&gl, places[i], 0.3f, &stage);
		expect_shadow(places[i], 0.3f, 0.003f);
	}
}

/* Whatever was on before. */
static void test_a_balls_shadow_darkens_and_writes_no_depth(void **state)
{
	static const GLenum on[] = {GL_BLEND, GL_VERTEX_ARRAY, 0};
	static const GLenum off[] = {GL_LIGHTING, GL_TEXTURE_2D, GL_CULL_FACE,
		GL_NORMAL_ARRAY, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY,
		GL_STATE_DEPTH_WRITES, 0};
	static const float center[3] = {0.0f, 1.0f, 0.0f};

	(void)state;
	for (int before = 0; before < 2; before++) {
		struct gl gl = gl_state_begin(before);
		const struct gl_state_draw *draw;

		set_up(0.0f);
		ball_draw_shadow(&gl, center, 0.3f, &stage);
		draw = gl_state_last();
		gl_state_expect_on(draw, on);
		gl_state_expect_off(draw, off);
		assert_true(gl_state_has(NULL, GL_STATE_DEPTH_WRITES));
		assert_false(gl_state_has(NULL, GL_BLEND));
		for (int i = 0; i < 3; i++) {
			assert_true(draw->color[i] < 0.1);
		}
		assert_near(draw->color[3], 0.375, 1e-4);
	}
}

static void test_a_ball_is_lit_at_its_place(void **state)
{
	static const GLenum on[] = {GL_LIGHTING, GL_COLOR_MATERIAL,
		GL_NORMALIZE, GL_CULL_FACE, GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, 0};
	static const GLenum off[] = {GL_TEXTURE_2D, GL_BLEND, GL_COLOR_ARRAY,
		GL_TEXTURE_COORD_ARRAY, 0};
	static const float center[3] = {1.0f, 2.0f, -3.0f};
	static const float color[3] = {0.25f, 0.5f, 0.75f};
	static const double place[16] = {0.5, 0.0, 0.0, 0.0, 0.0, 0.5, 0.0, 0.0,
		0.0, 0.0, 0.5, 0.0, 1.0, 2.0, -3.0, 1.0};

	(void)state;
	for (int before = 0; before < 2; before++) {
		struct gl gl = gl_state_begin(before);
		const struct gl_recording *recording = gl_recorder_result();
		const struct gl_state_draw *draw;

		set_up(0.0f);
		ball_draw(&ball, &gl, center, 0.5f, color);
		draw = gl_state_last();
		gl_state_expect_on(draw, on);
		gl_state_expect_off(draw, off);
		assert_int_equal(draw->mode, GL_TRIANGLES);
		assert_int_equal(draw->count, BALL_INDICES);
		assert_all_near(
			draw->vertex[0], ball.normal[ball.index[0]], 3, 0.0);
		for (int i = 0; i < 3; i++) {
			assert_near(draw->color[i], color[i], 1e-4);
		}
		assert_near(draw->color[3], 1.0, 0.0);
		for (int i = 0; i < 16; i++) {
			assert_near(
				recording->draw[0].matrix[i], place[i], 1e-4);
		}
		assert_int_equal(recording->depth, 0);
	}
}

/* An image of four quarters: of black and bright ones, upside to downside. */
static void make_picture(struct live_texture *texture, const struct gl *gl,
	const struct log *log)
{
	enum {
		SIDE = 64
	};
	static uint8_t data[SIDE * SIDE * 2];
	struct camera_layout layout =
		camera_layout_of(CAMERA_UYVY, SIDE, SIDE, 0);
	struct camera_image image;

	for (int i = 0; i < SIDE * SIDE; i++) {
		bool right = i % SIDE >= SIDE / 2, low = i / SIDE >= SIDE / 2;

		data[2 * i] = 128;
		data[2 * i + 1] = (uint8_t)(16 + 73 * (2 * low + right));
	}
	image = camera_image_at(CAMERA_UYVY, SIDE, SIDE, &layout, data);
	assert_int_equal(live_texture_init(texture, gl, false, log), 0);
	live_texture_update(texture, gl, &image, 1, 1);
}

/* Upper left, upper right, lower left and lower right. */
static void expect_quarters(const struct gl_canvas *canvas, const int gray[4])
{
	for (int i = 0; i < 4; i++) {
		int x = i % 2 ? GL_CANVAS_WIDTH - 1 : 0;
		int y = i / 2 ? GL_CANVAS_HEIGHT - 1 : 0;
		int half_x = GL_CANVAS_WIDTH / 2 - 1 + i % 2;
		int half_y = GL_CANVAS_HEIGHT / 2 - 1 + i / 2;

		gl_canvas_expect(canvas, x, y, gray[i], gray[i], gray[i], 18);
		gl_canvas_expect(
			canvas, half_x, half_y, gray[i], gray[i], gray[i], 18);
	}
}

/* Arrays that a drawing does not set must be off in it. */
static void leave_state_behind(const struct gl *gl)
{
	static const uint8_t red[1][4] = {{255, 0, 0, 255}};
	static const float far[16] = {0.0f};

	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, red);
	gl->TexCoordPointer(2, GL_FLOAT, 0, far);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
	gl->Color4x(0, 0, 65536, 65536);
	gl->MatrixMode(GL_PROJECTION);
	gl->Scalex(32768, 32768, 65536);
	gl->MatrixMode(GL_MODELVIEW);
	gl->Scalex(32768, 32768, 65536);
}

static void test_a_backdrop_fills_the_frame_behind_everything(void **state)
{
	static const int gray[4] = {0, 85, 170, 255};
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	struct log log = log_to_stderr(LOG_WARNING);
	struct live_texture texture;
	struct gl *gl = canvas.gl;

	(void)state;
	make_picture(&texture, gl, &log);
	gl->Enable(GL_DEPTH_TEST);
	gl->Clear(GL_DEPTH_BUFFER_BIT);
	gl_canvas_draw_rectangle(gl, -1.0f, -0.5f, 1.0f, 0.5f, -0.5f);
	leave_state_behind(gl);
	backdrop_draw(&texture, gl);
	/* Hidden by the first rectangle; then one at the very back. */
	gl->Color4x(0, 65536, 0, 65536);
	gl_canvas_draw_rectangle(gl, -0.2f, -0.2f, 0.2f, 0.2f, 0.0f);
	gl_canvas_draw_rectangle(gl, -0.2f, 0.7f, 0.2f, 0.9f, 0.99f);
	gl_canvas_end_frame(&canvas);
	expect_quarters(&canvas, gray);
	gl_canvas_expect(&canvas, GL_CANVAS_WIDTH / 2, 2, 0, 255, 0, 8);
	live_texture_finish(&texture, gl);
	gl_canvas_close(&canvas);
}

static void test_a_backdrop_leaves_no_arrays_and_no_texture(void **state)
{
	static const GLenum on[] = {
		GL_TEXTURE_2D, GL_VERTEX_ARRAY, GL_TEXTURE_COORD_ARRAY, 0};
	static const GLenum off[] = {
		GL_DEPTH_TEST, GL_NORMAL_ARRAY, GL_COLOR_ARRAY, 0};
	static const GLenum after[] = {
		GL_TEXTURE_2D, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, 0};
	static const struct live_texture texture = {.name = 1};

	(void)state;
	for (int before = 0; before < 2; before++) {
		struct gl gl = gl_state_begin(before);

		backdrop_draw(&texture, &gl);
		gl_state_expect_on(gl_state_last(), on);
		gl_state_expect_off(gl_state_last(), off);
		gl_state_expect_off(NULL, after);
		assert_true(gl_state_has(NULL, GL_DEPTH_TEST));
	}
}

/* A matrix that is pushed then is one of the model-view stack. */
static void test_a_live_texture_leaves_the_model_view_mode(void **state)
{
	static const struct live_texture texture = {.name = 1};
	struct gl gl = gl_recorder_begin();

	(void)state;
	live_texture_bind(&texture, &gl);
	gl.PushMatrix();
	assert_int_equal(gl_recorder_result()->depth, 1);
	live_texture_unbind(&gl);
	gl.PopMatrix();
	assert_int_equal(gl_recorder_result()->depth, 0);
}

/* Draws a monitor whose screen fills the frame, seen from the front. */
static void draw_screen(
	struct gl_canvas *canvas, const struct live_texture *picture)
{
	static struct monitor monitor;
	struct gl *gl = canvas->gl;

	monitor_init(&monitor);
	monitor.scale = 1.0f;
	monitor.yaw_rad = 0.0f;
	memset(monitor.origin, 0, sizeof(monitor.origin));
	leave_state_behind(gl);
	gl->MatrixMode(GL_PROJECTION);
	gl->LoadIdentity();
	gl->Orthox(-43690, 43690, 36045, 101581, -2 * 65536, 2 * 65536);
	gl->MatrixMode(GL_MODELVIEW);
	gl->LoadIdentity();
	gl->Enable(GL_DEPTH_TEST);
	gl->Clear(GL_DEPTH_BUFFER_BIT);
	monitor_draw(&monitor, picture, gl);
	gl_canvas_end_frame(canvas);
}

/* Its lower edge is a little darker. */
static void test_a_monitor_shows_the_picture_on_its_screen(void **state)
{
	static const int gray[4] = {0, 85, 160, 235};
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	struct log log = log_to_stderr(LOG_WARNING);
	struct live_texture texture;

	(void)state;
	make_picture(&texture, canvas.gl, &log);
	draw_screen(&canvas, &texture);
	expect_quarters(&canvas, gray);
	live_texture_finish(&texture, canvas.gl);
	gl_canvas_close(&canvas);
}

/* Darker to the right, and at its lower edge. */
static void test_a_monitor_without_a_picture_is_dark(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	int right = GL_CANVAS_WIDTH - 1, low = GL_CANVAS_HEIGHT - 1;

	(void)state;
	draw_screen(&canvas, NULL);
	/* Half a pixel from corners of (52, 60, 74), (24, 28, 36)... */
	gl_canvas_expect(&canvas, 0, 0, 51, 59, 73, 0);
	gl_canvas_expect(&canvas, 0, low, 24, 28, 37, 0);
	gl_canvas_expect(&canvas, right, 0, 38, 45, 57, 0);
	gl_canvas_expect(&canvas, right, low, 19, 22, 29, 0);
	gl_canvas_close(&canvas);
}

static void test_a_monitor_leaves_no_arrays_and_no_light(void **state)
{
	static const GLenum body_on[] = {
		GL_LIGHTING, GL_CULL_FACE, GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, 0};
	static const GLenum body_off[] = {
		GL_TEXTURE_2D, GL_COLOR_ARRAY, GL_TEXTURE_COORD_ARRAY, 0};
	static const GLenum on[] = {GL_VERTEX_ARRAY, GL_COLOR_ARRAY, 0};
	static const GLenum off[] = {GL_LIGHTING, GL_TEXTURE_2D,
		GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, 0};
	static const GLenum after[] = {GL_LIGHTING, GL_TEXTURE_2D, GL_CULL_FACE,
		GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, 0};
	static const struct live_texture texture = {.name = 1};
	static struct monitor monitor;

	(void)state;
	monitor_init(&monitor);
	for (int before = 0; before < 2; before++) {
		struct gl gl = gl_state_begin(before);

		monitor_draw(&monitor, NULL, &gl);
		gl_state_expect_on(gl_state_drawn(0), body_on);
		gl_state_expect_off(gl_state_drawn(0), body_off);
		assert_int_equal(gl_state_drawn(0)->count, MONITOR_INDICES);
		for (int i = 0; i < 36; i++) {
			assert_all_near(gl_state_drawn(0)->vertex[i],
				monitor.position[monitor.index[i]], 3, 0.0);
		}
		for (int i = 0; i < 3; i++) {
			assert_true(gl_state_drawn(0)->color[i] < 0.3);
		}
		gl_state_expect_on(gl_state_last(), on);
		gl_state_expect_off(gl_state_last(), off);
		gl_state_expect_off(NULL, after);
		monitor_draw(&monitor, &texture, &gl);
		assert_true(gl_state_has(gl_state_last(), GL_TEXTURE_2D));
		gl_state_expect_off(NULL, after);
		assert_int_equal(gl_recorder_result()->depth, 0);
	}
}

/*
 * Of what is seen where it stands, it takes 46% of the width, but at most 42%
 * of the height, beside a margin of 3%.
 */
static void test_a_monitor_stands_left_of_the_figure(void **state)
{
	static const float aspects[] = {0.75f, 1.6f};
	static struct monitor monitor;

	(void)state;
	for (size_t i = 0; i < 2 * ARRAY_COUNT(aspects); i++) {
		float aspect = aspects[i / 2], half, share, back[2], offset[2];
		struct camera camera = camera_default();

		camera.yaw_rad = i % 2 ? 0.0f : 1.2f;
		camera.shift_x = 0.25f * (float)i;
		monitor_init(&monitor);
		monitor_place(&monitor, &camera, aspect, 0.125f);
		assert_near(monitor.origin[1], 0.125, 0.0);
		assert_near(monitor.yaw_rad, camera.yaw_rad + 0.14f, 1e-5);
		back[0] = sinf(camera.yaw_rad);
		back[1] = cosf(camera.yaw_rad);
		offset[0] = monitor.origin[0] - camera.target[0];
		offset[1] = monitor.origin[2] - camera.target[2];
		assert_near(offset[0] * back[0] + offset[1] * back[1],
			-0.55f * camera.radius, 1e-4);
		half = aspect * (camera.distance + 0.55f * camera.radius) *
			camera_tan_half(camera.yfov_rad);
		share = fminf(0.46f, 0.42f / aspect);
		assert_near(monitor.scale * 2.0f * (2.0f / 3.0f + 0.055f),
			share * 2.0f * half, 1e-4);
		assert_near(offset[0] * back[1] - offset[1] * back[0],
			-(0.94f + camera.shift_x - share) * half, 1e-4);
	}
}

static void test_a_monitor_is_drawn_where_it_stands(void **state)
{
	static const double place[16] = {0.0, 0.0, -2.0, 0.0, 0.0, 2.0, 0.0,
		0.0, 2.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 1.0};
	static struct monitor monitor = {.origin = {1.0f, 2.0f, 3.0f},
		.yaw_rad = 1.5707963f,
		.scale = 2.0f};

	(void)state;
	for (int draw = 0; draw < 2; draw++) {
		struct gl gl = gl_state_begin(false);

		monitor_init(&monitor);
		monitor_draw(&monitor, NULL, &gl);
		for (int i = 0; i < 16; i++) {
			assert_near(gl_recorder_result()->draw[draw].matrix[i],
				place[i], 1e-3);
		}
	}
}

/* Each box of a monitor is closed and faces outward, which its volume shows. */
static void test_a_monitor_is_made_of_boxes_on_the_floor(void **state)
{
	static struct monitor monitor;

	(void)state;
	monitor_init(&monitor);
	for (int box = 0; box < MONITOR_BOXES; box++) {
		float low[3] = {9.0f, 9.0f, 9.0f},
		      high[3] = {-9.0f, -9.0f, -9.0f};
		double volume = 0.0;

		for (int i = box * 36; i < box * 36 + 36; i += 3) {
			const uint16_t *at = monitor.index + i;
			const float *a = monitor.position[at[0]];
			const int8_t *normal = monitor.normal[at[0]];
			float b[3], c[3], cross[3], length;

			vec_cross(monitor.position[at[1]],
				monitor.position[at[2]], cross);
			volume += (double)vec_dot(a, cross) / 6.0;
			vec_subtract(monitor.position[at[1]], a, b);
			vec_subtract(monitor.position[at[2]], a, c);
			vec_cross(b, c, cross);
			length = vec_length(cross);
			for (int axis = 0; axis < 3; axis++) {
				assert_near(normal[axis] / 127.0,
					cross[axis] / length, 1e-5);
				low[axis] = fminf(low[axis], a[axis]);
				high[axis] = fmaxf(high[axis], a[axis]);
			}
		}
		assert_near(volume,
			(high[0] - low[0]) * (high[1] - low[1]) *
				(high[2] - low[2]),
			1e-5);
		/* Not wider than the screen's frame, and behind the screen. */
		assert_near(low[0], -high[0], 1e-6);
		assert_in_range((int)(1000.0f * high[0]), 50, 722);
		assert_true(low[1] >= 0.0f && high[1] < 1.61f);
		assert_true(low[2] > -0.31f && high[2] < 0.17f);
		assert_true(box == 3 ? low[1] == 0.0f : high[2] <= 0.0f);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_balls_shadow_is_its_outline_along_the_light),
		cmocka_unit_test(test_a_balls_shadow_darkens_and_writes_no_depth),
		cmocka_unit_test(test_a_ball_is_lit_at_its_place),
		cmocka_unit_test(
			test_a_backdrop_fills_the_frame_behind_everything),
		cmocka_unit_test(test_a_backdrop_leaves_no_arrays_and_no_texture),
		cmocka_unit_test(test_a_live_texture_leaves_the_model_view_mode),
		cmocka_unit_test(test_a_monitor_shows_the_picture_on_its_screen),
		cmocka_unit_test(test_a_monitor_without_a_picture_is_dark),
		cmocka_unit_test(test_a_monitor_leaves_no_arrays_and_no_light),
		cmocka_unit_test(test_a_monitor_stands_left_of_the_figure),
		cmocka_unit_test(test_a_monitor_is_drawn_where_it_stands),
		cmocka_unit_test(test_a_monitor_is_made_of_boxes_on_the_floor),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
