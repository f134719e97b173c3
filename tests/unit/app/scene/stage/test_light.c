/* The lights of the stage, as they reach GL. */
#include "app/scene/stage/light.h"

#include "app/anim/math/vec.h"
#include "tests/support/gl/gl_state.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

/* What GL was told; its calls have no context parameter. */
static struct {
	double position[2][4], diffuse[2][4], specular[2][4],
		light_ambient[2][4];
	double ambient[4];
	double material_specular[4], shininess;
} lit;

static void keep(const GLfixed *values, double out[4])
{
	for (int i = 0; i < 4; i++) {
		out[i] = values[i] / 65536.0;
	}
}

static void keep_light(GLenum light, GLenum name, const GLfixed *values)
{
	int number = (int)light - GL_LIGHT0;

	assert_in_range(number, 0, 1);
	keep(values,
		name == GL_POSITION           ? lit.position[number]
			: name == GL_DIFFUSE  ? lit.diffuse[number]
			: name == GL_SPECULAR ? lit.specular[number]
					      : lit.light_ambient[number]);
}

static void keep_ambient(GLenum name, const GLfixed *values)
{
	assert_int_equal(name, GL_LIGHT_MODEL_AMBIENT);
	keep(values, lit.ambient);
}

static void keep_material(GLenum face, GLenum name, const GLfixed *values)
{
	assert_int_equal(face, GL_FRONT_AND_BACK);
	assert_int_equal(name, GL_SPECULAR);
	keep(values, lit.material_specular);
}

static void keep_shininess(GLenum face, GLenum name, GLfixed value)
{
	assert_int_equal(face, GL_FRONT_AND_BACK);
	assert_int_equal(name, GL_SHININESS);
	lit.shininess = value / 65536.0;
}

static struct gl begin(bool enabled)
{
	struct gl gl = gl_state_begin(enabled);

	memset(&lit, 0, sizeof(lit));
	gl.Lightxv = keep_light;
	gl.LightModelxv = keep_ambient;
	gl.Materialxv = keep_material;
	gl.Materialx = keep_shininess;
	return gl;
}

/* The most that a surface of any direction gets in a channel. */
static double most_light(int channel)
{
	double most = 0.0;

	for (int i = 0; i < 64 * 32; i++) {
		double round = i % 64 * 0.098175,
		       rise = (i / 64 - 16) * 0.098175;
		double normal[3] = {cos(rise) * cos(round), sin(rise),
			cos(rise) * sin(round)};
		double sum = lit.ambient[channel];

		for (int light = 0; light < 2; light++) {
			double facing = 0.0;

			for (int k = 0; k < 3; k++) {
				facing += normal[k] * lit.position[light][k];
			}
			sum += fmax(facing, 0.0) * lit.diffuse[light][channel];
		}
		most = fmax(most, sum);
	}
	return most;
}

/* Drivers clamp at different stages. */
static void test_no_surface_gets_more_light_than_one(void **state)
{
	struct gl gl = begin(false);

	(void)state;
	light_apply(&gl);
	for (int channel = 0; channel < 3; channel++) {
		assert_true(most_light(channel) <= 1.001);
		assert_true(most_light(channel) > 0.95);
	}
}

static void test_the_key_light_is_warm_and_the_fill_light_cool(void **state)
{
	struct gl gl = begin(false);
	float towards[3];

	(void)state;
	light_apply(&gl);
	light_direction(towards);
	assert_near(vec_length(towards), 1.0, 2e-3);
	assert_true(towards[1] > 0.7f);
	for (int light = 0; light < 2; light++) {
		const double *p = lit.position[light];

		assert_true(gl_state_has(NULL, GL_LIGHT0 + (GLenum)light));
		assert_near(p[3], 0.0, 0.0);
		assert_near(sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]), 1.0,
			2e-3);
		for (int i = 0; i < 4; i++) {
			assert_near(lit.light_ambient[light][i], i == 3, 0.0);
		}
		assert_near(lit.diffuse[light][3], 1.0, 0.0);
		assert_near(lit.specular[light][3], 1.0, 0.0);
	}
	for (int i = 0; i < 3; i++) {
		assert_near(lit.position[0][i], towards[i], 1e-4);
		assert_near(lit.specular[1][i], 0.0, 0.0);
		assert_in_range((int)(100 * lit.specular[0][i]), 89, 100);
		assert_true(lit.diffuse[0][i] > 1.5 * lit.diffuse[1][i]);
		assert_true(lit.diffuse[1][i] >= 0.29);
		assert_in_range((int)(100 * lit.ambient[i]), 37, 41);
	}
	assert_near(lit.ambient[3], 1.0, 0.0);
	assert_true(lit.diffuse[0][0] > lit.diffuse[0][2]);
	assert_true(lit.diffuse[1][0] < lit.diffuse[1][2]);
	/* From both sides, so that no side is without. */
	assert_true(lit.position[0][0] > 0.3 && lit.position[0][2] > 0.3);
	assert_true(lit.position[1][0] < -0.3 && lit.position[1][2] < -0.3);
	assert_true(lit.position[1][1] > 0.0);
}

/* A pass of the key light's colour and one of the rest are the whole. */
static void test_light_is_drawn_in_parts(void **state)
{
	double ambient[4], diffuse[4];
	struct gl gl = begin(false);

	(void)state;
	light_apply(&gl);
	memcpy(ambient, lit.ambient, sizeof(ambient));
	memcpy(diffuse, lit.diffuse[0], sizeof(diffuse));
	light_select(&gl, LIGHT_KEY_COLOR);
	assert_false(gl_state_has(NULL, GL_LIGHT0));
	assert_false(gl_state_has(NULL, GL_LIGHT1));
	assert_memory_equal(lit.ambient, diffuse, sizeof(diffuse));
	light_select(&gl, LIGHT_REMAINDER);
	assert_true(gl_state_has(NULL, GL_LIGHT0));
	assert_true(gl_state_has(NULL, GL_LIGHT1));
	assert_memory_equal(lit.ambient, ambient, sizeof(ambient));
	for (int i = 0; i < 4; i++) {
		assert_near(lit.diffuse[0][i], i == 3, 0.0);
	}
	light_select(&gl, LIGHT_ALL);
	assert_true(gl_state_has(NULL, GL_LIGHT0));
	assert_memory_equal(lit.ambient, ambient, sizeof(ambient));
	assert_memory_equal(lit.diffuse[0], diffuse, sizeof(diffuse));
}

static void test_a_material_is_opaque_and_lit(void **state)
{
	static const GLenum on[] = {
		GL_LIGHTING, GL_COLOR_MATERIAL, GL_NORMALIZE, GL_CULL_FACE, 0};
	static const GLenum off[] = {GL_TEXTURE_2D, GL_BLEND, 0};
	static const float color[3] = {0.25f, 0.5f, 0.75f};

	(void)state;
	for (int before = 0; before < 2; before++) {
		struct gl gl = begin(before);

		light_set_material(&gl, color, 0.125f, 37);
		gl.DrawArrays(GL_TRIANGLES, 0, 0);
		gl_state_expect_on(NULL, on);
		gl_state_expect_off(NULL, off);
		for (int i = 0; i < 4; i++) {
			assert_near(gl_state_last()->color[i],
				i < 3 ? color[i] : 1.0, 1e-4);
			assert_near(lit.material_specular[i],
				i < 3 ? 0.125 : 1.0, 1e-4);
		}
		assert_near(lit.shininess, 37.0, 0.0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_no_surface_gets_more_light_than_one),
		cmocka_unit_test(
			test_the_key_light_is_warm_and_the_fill_light_cool),
		cmocka_unit_test(test_light_is_drawn_in_parts),
		cmocka_unit_test(test_a_material_is_opaque_and_lit),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
