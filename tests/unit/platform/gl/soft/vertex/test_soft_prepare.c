/*
 * What the soft driver derives from the state: scales with which no digits are
 * lost and no product overflows, and what a draw call can leave out.
 */
#include "platform/base/fixed.h"
#include "platform/gl/soft/vertex/draw.h"
#include "tests/support/gl/gl_checks.h"

#include <math.h>
#include <stdlib.h>

enum {
	ONE = FX16_ONE
};

struct prepared {
	struct gl_canvas canvas;
	const struct gl *gl;
	const struct draw *draw;
};

static struct prepared begin(void)
{
	struct prepared prepared = {
		.canvas = gl_canvas_open("soft", PIXELS_RGB565)};
	const struct soft *soft = (struct soft *)prepared.canvas.context;

	prepared.gl = prepared.canvas.gl;
	prepared.draw = soft->draw;
	return prepared;
}

/* Loads a matrix of the one element at a place, and 1 at another unless below 0. */
static void load_alone(const struct gl *gl, int place, GLfixed value, int one)
{
	GLfixed m[16] = {0};

	if (one >= 0) {
		m[one] = ONE;
	}
	m[place] = value;
	gl->LoadMatrixx(m);
}

/* Coordinates of a texture are found by products with these. */
static void test_a_texture_matrix_keeps_the_digits_of_its_largest_element(
	void **state)
{
	static const int column[3] = {0, 4, 12};

	(void)state;
	for (int i = 0; i < 6; i++) {
		for (int power = -10; power <= 10; power++) {
			struct prepared prepared = begin();
			const struct texture_input *input =
				&prepared.draw->texture[0];
			const GLfixed value = (GLfixed)(ldexp(ONE, power) * 1.5);
			GLfixed found;

			gl_canvas_make_texture(prepared.canvas.gl);
			prepared.gl->MatrixMode(GL_TEXTURE);
			load_alone(
				prepared.gl, column[i / 2] + i % 2, value, -1);
			gl_canvas_draw_all(prepared.canvas.gl);
			found = input->matrix[i % 2][i / 2];
			assert_in_range(found, 1 << 29, INT32_MAX / 2);
			assert_near(ldexp(found, -input->matrix_q) * ONE, value,
				1e-6);
			gl_canvas_end_and_close(&prepared.canvas);
		}
	}
}

/* The largest sum of a row's products with positions below 2^30. */
static int64_t find_most(const struct view *view)
{
	const int32_t *rows[4] = {
		view->row_x, view->row_y, view->row_z, view->row_w};
	const int32_t moved[4] = {
		view->moved_x, view->moved_y, view->moved_z, view->moved_w};
	int64_t most = 0;

	for (int row = 0; row < 4; row++) {
		int64_t sum = llabs(moved[row]);

		for (int i = 0; i < 3; i++) {
			sum += llabs(rows[row][i]) / 4;
		}
		most = sum > most ? sum : most;
	}
	return most;
}

/* Of a power of two the largest is one, too. */
static void test_clip_coordinates_fill_28_bits_whichever_element_is_large(
	void **state)
{
	(void)state;
	for (int place = 0; place < 16; place++) {
		for (GLfixed value = ONE / 64; value < 4096 * ONE; value *= 8) {
			struct prepared prepared = begin();

			prepared.gl->MatrixMode(GL_PROJECTION);
			load_alone(prepared.gl, place, value, -1);
			gl_canvas_draw_all(prepared.canvas.gl);
			assert_in_range(find_most(&prepared.draw->view),
				(1 << 27) - 4, (1 << 27) + 4);
			gl_canvas_end_and_close(&prepared.canvas);
		}
	}
}

static void test_any_coordinate_that_changes_w_gives_perspective(void **state)
{
	(void)state;
	for (int place = 0; place < 16; place++) {
		struct prepared prepared = begin();

		prepared.gl->MatrixMode(GL_PROJECTION);
		load_alone(prepared.gl, place, ONE / 2, 15);
		gl_canvas_draw_all(prepared.canvas.gl);
		assert_int_equal(prepared.draw->perspective,
			place == 3 || place == 7 || place == 11);
		gl_canvas_end_and_close(&prepared.canvas);
	}
}

static void test_the_scale_of_fog_has_29_bits_whatever_its_range(void **state)
{
	static const GLfixed range[] = {0, 1, 77, ONE / 3, ONE, 40 * ONE,
		INT32_MAX, -ONE / 5, -9 * ONE};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(range); i++) {
		struct prepared prepared = begin();
		const struct draw *draw = prepared.draw;
		const double scale =
			range[i] ? 65536.0 / (double)range[i] : 32768.0;

		prepared.gl->Fogx(GL_FOG_MODE, GL_LINEAR);
		prepared.gl->Fogx(GL_FOG_START, 0);
		prepared.gl->Fogx(GL_FOG_END, range[i]);
		prepared.gl->Enable(GL_FOG);
		gl_canvas_draw_all(prepared.canvas.gl);
		assert_in_range(llabs(draw->fog_scale), 1 << 28, 1 << 29);
		assert_near(ldexp(draw->fog_scale, -draw->fog_scale_q) / scale,
			1.0, 1e-6);
		gl_canvas_end_and_close(&prepared.canvas);
	}
}

/* A row of the eye's coordinates that cannot be scaled is 0, the others stay. */
static void test_rows_of_numbers_beyond_all_scales_become_0(void **state)
{
	static const GLfixed moved[] = {
		0, 8 * ONE, 16 * ONE, 32 * ONE, 64 * ONE, 512 * ONE};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(moved); i++) {
		struct prepared prepared = begin();
		const struct draw *draw = prepared.draw;

		prepared.gl->Enable(GL_FOG);
		prepared.gl->MatrixMode(GL_MODELVIEW);
		for (int power = 0; power < 84; power += 14) {
			prepared.gl->Scalex(ONE << 14, ONE, ONE << 14);
		}
		prepared.gl->Translatex(moved[i], 0, 0);
		gl_canvas_draw_all(prepared.canvas.gl);
		for (int k = 0; k < 4; k++) {
			if (moved[i] >= 32 * ONE) { /* 2^89 and more */
				assert_int_equal(draw->eye[0][k], 0);
			}
		}
		assert_int_equal(draw->eye[0][3] != 0,
			moved[i] > 0 && moved[i] < 32 * ONE);
		assert_int_not_equal(draw->eye[2][2], 0);
		gl_canvas_end_and_close(&prepared.canvas);
	}
}

/* The environment adds a colour to what was there before, whose alpha stays. */
static void add_constant(const struct gl *gl, GLenum unit)
{
	static const struct {
		GLenum name, value;
	} set[] = {
		{GL_TEXTURE_ENV_MODE, GL_COMBINE},
		{GL_COMBINE_RGB, GL_ADD},
		{GL_SRC0_RGB, GL_PREVIOUS},
		{GL_SRC1_RGB, GL_CONSTANT},
		{GL_COMBINE_ALPHA, GL_REPLACE},
		{GL_SRC0_ALPHA, GL_PREVIOUS},
	};

	gl->ActiveTexture(unit);
	for (size_t i = 0; i < ARRAY_COUNT(set); i++) {
		gl->TexEnvx(GL_TEXTURE_ENV, set[i].name, (GLfixed)set[i].value);
	}
}

static void test_a_second_texture_that_adds_a_colour_alone_is_not_read(
	void **state)
{
	(void)state;
	for (int i = 0; i < 6; i++) {
		const bool second = i % 2, only = i < 2, fogged = i >= 4;
		const bool added = second && !only && !fogged;
		struct prepared prepared = begin();
		const struct draw *draw = prepared.draw;

		if (!only) {
			gl_canvas_make_texture(prepared.canvas.gl);
		}
		prepared.gl->ActiveTexture(GL_TEXTURE1);
		gl_canvas_make_texture(prepared.canvas.gl);
		add_constant(prepared.gl, second ? GL_TEXTURE1 : GL_TEXTURE0);
		(fogged ? prepared.gl->Enable : prepared.gl->Disable)(GL_FOG);
		gl_canvas_draw_all(prepared.canvas.gl);
		assert_int_equal(draw->added != NULL, added);
		assert_true(draw->texture[0].used);
		assert_int_equal(draw->texture[1].used, !only && !added);
		gl_canvas_end_and_close(&prepared.canvas);
	}
}

/* A triangle from far outside of the picture over all of it. */
static void draw_large(struct prepared *prepared, float size)
{
	const float corner[3][3] = {
		{-size, -size, 0}, {size, -size, 0}, {0, size, 0}};

	prepared->gl->EnableClientState(GL_VERTEX_ARRAY);
	prepared->gl->VertexPointer(3, GL_FLOAT, 0, corner);
	prepared->gl->DrawArrays(GL_TRIANGLES, 0, 3);
}

/* Others fit in 32 bits as they are scaled. */
static void test_positions_of_2_to_the_30_and_more_are_checked(void **state)
{
	(void)state;
	for (int power = 4; power < 100;
		power += power < 26 || power > 33 ? 7 : 1) {
		struct prepared prepared = begin();
		const struct draw *draw = prepared.draw;

		draw_large(&prepared, ldexpf(1.5f, power));
		assert_int_equal(draw->checked, power >= 30);
		assert_int_equal(draw->view.kind,
			power >= 30 ? POSITION_OTHER : POSITION_FLOATS);
		assert_int_equal(draw->position_q, power < 29 ? 29 - power : 0);
		gl_canvas_end_and_close(&prepared.canvas);
	}
}

static void test_a_box_without_pixels_is_not_drawn(void **state)
{
	(void)state;
	for (int width = 0; width < 3; width++) {
		for (int height = 0; height < 3; height++) {
			struct prepared prepared = begin();

			prepared.gl->Enable(GL_SCISSOR_TEST);
			prepared.gl->Scissor(5, 7, width, height);
			gl_canvas_draw_all(prepared.canvas.gl);
			assert_int_equal(
				prepared.draw->draws, width > 0 && height > 0);
			gl_canvas_end_and_close(&prepared.canvas);
		}
	}
}

/* Normals of floats, and of shorts whose lengths are made 1, are read fast. */
static void test_normals_are_read_by_their_type(void **state)
{
	static const GLenum type[] = {GL_FLOAT, GL_SHORT, GL_BYTE, GL_FIXED};
	static const GLfixed normals[3 * 4];

	(void)state;
	for (int i = 0; i < 8; i++) {
		const GLenum own = type[i / 2];
		struct prepared prepared = begin();
		const struct shading *shading = &prepared.draw->shading;

		gl_canvas_set_up_light(prepared.canvas.gl);
		prepared.gl->EnableClientState(GL_NORMAL_ARRAY);
		prepared.gl->NormalPointer(own, 12, normals);
		(i % 2 ? prepared.gl->Enable : prepared.gl->Disable)(
			GL_NORMALIZE);
		gl_canvas_draw_all(prepared.canvas.gl);
		assert_int_equal(shading->floats, own == GL_FLOAT);
		assert_int_equal(shading->fast,
			own == GL_FLOAT || (own == GL_SHORT && i % 2));
		assert_ptr_equal(shading->normals, normals);
		assert_int_equal(shading->normal_stride, 12);
		gl_canvas_end_and_close(&prepared.canvas);
	}
}

static void test_slopes_have_the_inverse_of_each_small_extent(void **state)
{
	struct prepared prepared = begin();

	(void)state;
	for (int i = 2; i <= SMALL_EXTENT; i++) {
		assert_int_equal(
			prepared.draw->inverse_q31[i], (INT64_C(1) << 31) / i);
	}
	gl_canvas_end_and_close(&prepared.canvas);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_texture_matrix_keeps_the_digits_of_its_largest_element),
		cmocka_unit_test(
			test_clip_coordinates_fill_28_bits_whichever_element_is_large),
		cmocka_unit_test(
			test_any_coordinate_that_changes_w_gives_perspective),
		cmocka_unit_test(
			test_the_scale_of_fog_has_29_bits_whatever_its_range),
		cmocka_unit_test(test_rows_of_numbers_beyond_all_scales_become_0),
		cmocka_unit_test(
			test_a_second_texture_that_adds_a_colour_alone_is_not_read),
		cmocka_unit_test(
			test_positions_of_2_to_the_30_and_more_are_checked),
		cmocka_unit_test(test_a_box_without_pixels_is_not_drawn),
		cmocka_unit_test(test_normals_are_read_by_their_type),
		cmocka_unit_test(
			test_slopes_have_the_inverse_of_each_small_extent),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
