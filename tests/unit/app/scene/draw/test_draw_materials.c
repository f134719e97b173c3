/* The state of GL in which any two materials are drawn one after the other. */
#include "app/scene/draw/draw.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/model/small_model.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	DRAWS_MAX = 4 /* a material that has two sides may be drawn twice */
};

struct seen {
	bool lit, alpha_tested, blended, textured, depth_written, two_sided;
	bool culled;
	GLenum culled_face;
	GLfixed cutoff, shininess, specular, emission;
	GLsizei count;
};

/* GL's calls carry no context argument. */
static struct {
	struct seen now;
	struct seen draw[DRAWS_MAX];
	int draw_count;
} state;

static void set(GLenum capability, bool on)
{
	switch (capability) {
	case GL_LIGHTING:
		state.now.lit = on;
		break;
	case GL_ALPHA_TEST:
		state.now.alpha_tested = on;
		break;
	case GL_BLEND:
		state.now.blended = on;
		break;
	case GL_TEXTURE_2D:
		state.now.textured = on;
		break;
	case GL_CULL_FACE:
		state.now.culled = on;
		break;
	default:
		break;
	}
}

static void enable(GLenum capability)
{
	set(capability, true);
}

static void disable(GLenum capability)
{
	set(capability, false);
}

static void alpha_func(GLenum function, GLfixed reference)
{
	assert_int_equal(function, GL_GEQUAL);
	state.now.cutoff = reference;
}

static void cull_face(GLenum face)
{
	state.now.culled_face = face;
}

static void depth_mask(GLboolean on)
{
	state.now.depth_written = on;
}

static void light_model(GLenum name, GLfixed value)
{
	assert_int_equal(name, GL_LIGHT_MODEL_TWO_SIDE);
	state.now.two_sided = value != 0;
}

static void material_one(GLenum face, GLenum name, GLfixed value)
{
	(void)face;
	assert_int_equal(name, GL_SHININESS);
	state.now.shininess = value;
}

static void material_four(GLenum face, GLenum name, const GLfixed *value)
{
	(void)face;
	assert_true(name == GL_SPECULAR || name == GL_EMISSION);
	assert_int_equal(value[1], value[0]);
	assert_int_equal(value[2], value[0]);
	if (name == GL_SPECULAR) {
		state.now.specular = value[0];
	} else {
		state.now.emission = value[0];
	}
}

static void draw_elements(
	GLenum mode, GLsizei count, GLenum type, const void *index)
{
	assert_int_equal(mode, GL_TRIANGLES);
	assert_int_equal(type, GL_UNSIGNED_SHORT);
	assert_non_null(index);
	assert_true(state.draw_count < DRAWS_MAX);
	state.draw[state.draw_count] = state.now;
	state.draw[state.draw_count++].count = count;
}

static struct gl watched_gl(void)
{
	struct gl gl = gl_recorder_begin();

	gl.Enable = enable;
	gl.Disable = disable;
	gl.AlphaFuncx = alpha_func;
	gl.CullFace = cull_face;
	gl.DepthMask = depth_mask;
	gl.LightModelx = light_model;
	gl.Materialx = material_one;
	gl.Materialxv = material_four;
	gl.DrawElements = draw_elements;
	return gl;
}

static void choose(struct model_material *material, uint32_t *seed)
{
	static const enum model_alpha kinds[] = {
		MODEL_OPAQUE, MODEL_MASK, MODEL_BLEND};

	material->alpha = kinds[random_between(seed, 0, 2)];
	material->alpha_cutoff = (float)random_between(seed, 0, 8) / 8.0f;
	material->base_color[3] = (float)random_between(seed, 0, 8) / 8.0f;
	material->unlit = random_one_in(seed, 3);
	material->double_sided = random_one_in(seed, 2);
	material->roughness = (float)random_between(seed, 0, 8) / 8.0f;
	if (random_one_in(seed, 3)) {
		for (int i = 0; i < 3; i++) {
			material->base_color[i] = 0.0f;
			material->emissive[i] = 0.2140411f; /* 0.5 in sRGB */
		}
	}
}

/* What glTF 2.0, section 3.9, asks for, with limber's highlights. */
static void expect_drawn_as(
	const struct seen *seen, const struct model_material *material)
{
	const double gloss = 1.0 - (double)material->roughness;
	float alpha = material->base_color[3];
	bool tested =
		material->alpha == MODEL_MASK && alpha < material->alpha_cutoff;
	bool blended = material->alpha == MODEL_BLEND && alpha < 1.0f;

	assert_int_equal(seen->lit, !material->unlit);
	assert_int_equal(seen->alpha_tested, tested);
	assert_int_equal(seen->blended, blended);
	assert_int_equal(seen->depth_written, !blended);
	assert_false(seen->textured);
	if (seen->alpha_tested) {
		assert_near(seen->cutoff / 65536.0,
			(double)material->alpha_cutoff, 1e-4);
	}
	if (seen->lit) {
		assert_near(seen->emission / 65536.0,
			material->emissive[0] > 0.0f ? 0.5 : 0.0, 1e-4);
		assert_near(seen->specular / 65536.0, gloss * gloss / 2, 1e-4);
		assert_near(seen->shininess / 65536.0, 4 + 60 * gloss, 1e-3);
	}
}

/*
 * Each side that shows is drawn once, and only back faces at the cost of light
 * of two sides; they come last, but first where they are seen through front faces.
 */
static void expect_sides(const struct model_material *material, GLsizei count)
{
	int front = 0, back = 0;

	for (int i = 0; i < state.draw_count; i++) {
		const struct seen *seen = &state.draw[i];

		if (seen->count != count) {
			continue;
		}
		expect_drawn_as(seen, material);
		if (seen->culled && front + back == 0) {
			assert_int_equal(seen->culled_face,
				seen->blended && material->double_sided
					? GL_FRONT
					: GL_BACK);
		}
		front += !seen->culled || seen->culled_face == GL_BACK;
		back += !seen->culled || seen->culled_face == GL_FRONT;
		if (seen->lit) {
			assert_int_equal(seen->two_sided,
				!seen->culled || seen->culled_face == GL_FRONT);
		}
	}
	assert_int_equal(front, 1);
	assert_int_equal(back, material->double_sided);
}

static void test_no_material_changes_the_look_of_the_next(void **unused)
{
	uint32_t seed = 1;

	(void)unused;
	for (int turn = 0; turn < 300; turn++) {
		struct model *model = small_model_grid(1, 1, 1.0f, true);
		struct model_primitive two[2] = {model->mesh[0].primitive[0],
			model->mesh[0].primitive[0]};
		struct model_material material[2] = {
			model->material[0], model->material[0]};
		struct texture_set no_textures = {0};
		struct gl gl = watched_gl();
		struct instance *instance;

		two[1].material = 1;
		two[1].index_count = 3;
		for (int i = 0; i < 2; i++) {
			choose(&material[i], &seed);
		}
		model->mesh[0].primitive = two;
		model->mesh[0].primitive_count = model->material_count = 2;
		model->material = material;
		instance = small_model_instance(model);
		/* As any frame before may have left it. */
		memset(&state, random_one_in(&seed, 2), sizeof(state.now));
		state.now.culled_face = GL_BACK;
		state.now.emission = 0; /* as every frame leaves it */
		state.draw_count = 0;
		draw_instance(&gl, instance, &no_textures, DRAW_SHADED);
		expect_sides(&material[0], 6);
		expect_sides(&material[1], 3);
		instance_destroy(instance);
		model_destroy(model);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_no_material_changes_the_look_of_the_next),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
