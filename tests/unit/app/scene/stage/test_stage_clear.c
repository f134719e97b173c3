/* What a frame clears before it is drawn, and the sky's gradient. */
#include "app/scene/stage/stage.h"
#include "platform/base/compiler.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	WIDTH = 480,
	HEIGHT = 640
};

/* GL's calls carry no context argument. */
static struct {
	bool scissoring;
	int rectangle[4];
	int depth[4], stencil[4]; /* what was cleared */
	int depths, stencils;
	GLint stencil_value;
	GLenum type;
	const void *position;
	uint8_t color[8][4];
	double row[4]; /* of the gradient, 3 at the upper edge */
} told;

static void enable(GLenum capability)
{
	told.scissoring = told.scissoring || capability == GL_SCISSOR_TEST;
}

static void disable(GLenum capability)
{
	told.scissoring = told.scissoring && capability != GL_SCISSOR_TEST;
}

static void scissor(GLint x, GLint y, GLsizei width, GLsizei height)
{
	const int rectangle[4] = {x, y, width, height};

	memcpy(told.rectangle, rectangle, sizeof(rectangle));
}

static void clear_stencil(GLint value)
{
	told.stencil_value = value;
}

static void clear(GLbitfield buffers)
{
	assert_true(told.scissoring);
	if (buffers & GL_DEPTH_BUFFER_BIT) {
		memcpy(told.depth, told.rectangle, sizeof(told.depth));
		told.depths++;
	}
	if (buffers & GL_STENCIL_BUFFER_BIT) {
		memcpy(told.stencil, told.rectangle, sizeof(told.stencil));
		told.stencils++;
	}
}

static void keep_position(
	GLint size, GLenum type, GLsizei stride, const void *pointer)
{
	(void)size;
	(void)stride;
	told.type = type;
	told.position = pointer;
}

static void keep_color(
	GLint size, GLenum type, GLsizei stride, const void *pointer)
{
	(void)size;
	(void)type;
	(void)stride;
	/* Those of the gradient come first. */
	if (told.row[0] == 0) {
		memcpy(told.color, pointer, sizeof(told.color));
	}
}

/* The gradient is the first strip of eight vertices. */
static void draw_arrays(GLenum mode, GLint first, GLsizei count)
{
	(void)mode;
	(void)first;
	if (count != 8 || told.row[0] != 0) {
		return;
	}
	assert_true(told.scissoring);
	for (int i = 0; i < 8; i++) {
		const int16_t *whole =
			(const int16_t *)told.position + (size_t)i * 2;
		const int32_t *fixed =
			(const int32_t *)told.position + (size_t)i * 2;
		bool is_whole = told.type == GL_SHORT;
		double x = is_whole ? whole[0] : fixed[0] / 65536.0;

		told.row[i / 2] = is_whole ? whole[1] : fixed[1] / 65536.0;
		assert_near(x, i % 2 ? 1 : -1, 0);
	}
}

static void begin(
	struct stage *stage, float pitch_rad, float shift_y, bool has_stencil)
{
	struct gl gl = gl_recorder_begin();

	memset(&told, 0, sizeof(told));
	told.stencil_value = 9;
	gl.Enable = enable;
	gl.Disable = disable;
	gl.Scissor = scissor;
	gl.ClearStencil = clear_stencil;
	gl.Clear = clear;
	gl.VertexPointer = keep_position;
	gl.ColorPointer = keep_color;
	gl.DrawArrays = draw_arrays;
	*stage = (struct stage){
		.camera = camera_default(), .has_stencil = has_stencil};
	stage->camera.pitch_rad = pitch_rad;
	stage->camera.shift_y = shift_y;
	stage->floor.radius = 10;
	stage->floor.tile = 1;
	stage_begin(stage, &gl, WIDTH, HEIGHT);
	assert_false(told.scissoring);
}

static void expect_rows(const int rectangle[4], int from, int count)
{
	assert_int_equal(rectangle[0], 0);
	assert_int_equal(rectangle[1], from);
	assert_int_equal(rectangle[2], WIDTH);
	assert_int_equal(rectangle[3], count);
}

/* Depths where no opaque ground will be, marks of shadows where it may be. */
static void test_rows_are_cleared_that_are_not_drawn_over(void **state)
{
	static struct stage stage;

	(void)state;
	for (int i = 0; i < 12; i++) {
		const struct floor_strips *strips = &stage.sight.strips;

		begin(&stage, 0.1f * (float)i, 0, i % 2);
		assert_int_equal(told.depths, 1);
		expect_rows(told.depth, strips->covered_px,
			HEIGHT - strips->covered_px);
		assert_int_equal(told.stencils, i % 2);
		if (i % 2) {
			assert_int_equal(told.stencil_value, 0);
			expect_rows(told.stencil, 0, strips->horizon_px);
		}
	}
}

/*
 * The gradient is lightest in the middle of the picture, and lower where ground
 * ends more than a twelfth of the half height below it: twice as far as that,
 * up to the ground's end.
 */
static void test_the_sky_goes_down_to_low_ground(void **state)
{
	static const uint8_t sky[3] = {58, 68, 84};
	static const uint8_t middle_sky[3] = {146, 158, 172};
	static const uint8_t ground[3] = {104, 114, 128};
	static struct stage stage;
	int usual = 0, between = 0, low = 0;

	(void)state;
	for (int i = 0; i < 60; i++) {
		double end, middle;

		begin(&stage, 0.16f, 0.3f - 0.02f * (float)i, false);
		end = 6.0 * stage.sight.strips.end_px / HEIGHT - 3;
		middle = end > -0.25 ? 0 : end > -0.5 ? 2 * end + 0.5 : end;
		usual += end > -0.25;
		between += end <= -0.25 && end > -0.5;
		low += end <= -0.5;
		assert_near(told.row[0], 3, 1e-4);
		assert_near(told.row[1], middle, 1e-3);
		assert_near(told.row[2], middle - 1, 1e-3);
		assert_near(told.row[3], middle - 3, 1e-3);
		for (int k = 0; k < 8; k++) {
			assert_int_equal(told.color[k][3], 255);
			assert_memory_equal(told.color[k], told.color[k ^ 1], 4);
		}
		/* The middle is lighter than the sky, and than the ground. */
		assert_memory_equal(told.color[0], sky, 3);
		assert_memory_equal(told.color[2], middle_sky, 3);
		assert_memory_equal(told.color[4], ground, 3);
		assert_memory_equal(told.color[4], told.color[6], 4);
	}
	assert_true(usual > 0 && between > 0 && low > 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_rows_are_cleared_that_are_not_drawn_over),
		cmocka_unit_test(test_the_sky_goes_down_to_low_ground),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
