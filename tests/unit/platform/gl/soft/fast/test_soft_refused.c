/*
 * States that differ in one point from what a fast path draws: the path must
 * not be taken, and pictures are those of the long way.
 */
#include "platform/base/compiler.h"
#include "platform/base/fixed.h"
#include "tests/support/soft/fast_scene.h"
#include "tests/support/test.h"

#include <string.h>

#define ONE FX16_ONE

static void offset(const struct gl *gl)
{
	gl->Enable(GL_POLYGON_OFFSET_FILL);
	gl->PolygonOffsetx(0, -3000 * ONE);
}

static void light_both_sides(const struct gl *gl)
{
	static const GLfixed white[] = {ONE, ONE, ONE, ONE};

	gl->Enable(GL_LIGHTING);
	gl->Enable(GL_LIGHT0);
	gl->Lightxv(GL_LIGHT0, GL_DIFFUSE, white);
	gl->Enable(GL_COLOR_MATERIAL);
	gl->LightModelx(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
	gl->Normal3x(0, 0, -ONE);
}

static void mask_green(const struct gl *gl)
{
	gl->ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
}

static void mask_red(const struct gl *gl)
{
	gl->ColorMask(GL_FALSE, GL_TRUE, GL_TRUE, GL_TRUE);
}

static void test_greater(const struct gl *gl)
{
	gl->DepthFunc(GL_GREATER);
	gl->ClearDepthx(ONE / 2);
	gl->Clear(GL_DEPTH_BUFFER_BIT);
}

static void keep_depth(const struct gl *gl)
{
	gl->DepthMask(GL_FALSE);
}

static void test_alpha(const struct gl *gl)
{
	gl->Enable(GL_ALPHA_TEST);
	gl->AlphaFuncx(GL_LESS, ONE / 2);
}

static void blend_by_alpha(const struct gl *gl)
{
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
}

static void add(const struct gl *gl)
{
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE);
}

static void multiply(const struct gl *gl)
{
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

static void test_stencil(const struct gl *gl)
{
	gl->Enable(GL_STENCIL_TEST);
	gl->StencilFunc(GL_NOTEQUAL, 1, 255);
	gl->StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
	gl->Clear(GL_STENCIL_BUFFER_BIT);
}

static void count_failures(const struct gl *gl)
{
	gl->StencilOp(GL_INCR, GL_KEEP, GL_INCR);
}

static void compare_a_bit(const struct gl *gl)
{
	gl->StencilFunc(GL_EQUAL, 0, 1);
}

static void write_two_bits(const struct gl *gl)
{
	gl->StencilMask(3);
	gl->StencilFunc(GL_ALWAYS, 0, 255);
}

static void test_depth(const struct gl *gl)
{
	gl->Enable(GL_DEPTH_TEST);
}

static void filter_small(const struct gl *gl)
{
	/* 40 texels across some pixels: all triangles are minified */
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
}

static void filter_large(const struct gl *gl)
{
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

static void replace(const struct gl *gl)
{
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_REPLACE);
}

static void clamp_s(const struct gl *gl)
{
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
}

static void clamp_t(const struct gl *gl)
{
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

static void filter_nearest(const struct gl *gl)
{
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

static void filter_one_level(const struct gl *gl)
{
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
}

/* A ramp of luminance with mipmaps, which repeats and is filtered. */
static void use_luminance(const struct gl *gl)
{
	uint8_t texel[FAST_SIDE * FAST_SIDE];
	GLuint name;

	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	for (int level = 0; FAST_SIDE >> level > 0; level++) {
		int side = FAST_SIDE >> level;

		for (int i = 0; i < side * side; i++) {
			texel[i] = (uint8_t)(256 / (2 * side) *
				(i % side + i / side));
		}
		gl->TexImage2D(GL_TEXTURE_2D, level, GL_LUMINANCE, side, side,
			0, GL_LUMINANCE, GL_UNSIGNED_BYTE, texel);
	}
	gl->TexParameterx(
		GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
	gl->Disable(GL_DEPTH_TEST);
}

struct state_case {
	const char *name;
	enum fast_kind kind;
	void (*set)(const struct gl *gl);
	int size; /* of triangles, in thousandths of clip space */
};

static const struct state_case cases[] = {
	{"offset", FAST_PLAIN, offset, 200},
	{"two sides", FAST_PLAIN, light_both_sides, 200},
	{"no red", FAST_PLAIN, mask_red, 200},
	{"no green", FAST_PLAIN, mask_green, 200},
	{"greater", FAST_PLAIN, test_greater, 200},
	{"no depth written", FAST_PLAIN, keep_depth, 200},
	{"alpha test", FAST_PLAIN, test_alpha, 200},
	{"blended", FAST_PLAIN, blend_by_alpha, 200},
	{"stencil", FAST_PLAIN, test_stencil, 200},
	{"textured, offset", FAST_TEXTURED, offset, 200},
	{"textured, two sides", FAST_TEXTURED, light_both_sides, 200},
	{"textured, no depth written", FAST_TEXTURED, keep_depth, 200},
	{"textured, blended", FAST_TEXTURED, blend_by_alpha, 200},
	{"textured, small", FAST_TEXTURED, filter_small, 120},
	{"textured, large", FAST_TEXTURED, filter_large, 900},
	{"textured alone", FAST_TEXTURED, replace, 200},
	{"added", FAST_SHADOW, add, 300},
	{"source whole", FAST_SHADOW, multiply, 300},
	{"failures counted", FAST_SHADOW, count_failures, 300},
	{"a bit compared", FAST_SHADOW, compare_a_bit, 300},
	{"two bits written", FAST_SHADOW, write_two_bits, 300},
	{"shadow with depth", FAST_SHADOW, test_depth, 300},
};

static const struct state_case luminance_cases[] = {
	{"s clamped", FAST_TEXTURED, clamp_s, 900},
	{"t clamped", FAST_TEXTURED, clamp_t, 900},
	{"alone", FAST_TEXTURED, replace, 900},
	{"nearest", FAST_TEXTURED, filter_nearest, 900},
	{"one level", FAST_TEXTURED, filter_one_level, 200},
	{"stencil", FAST_TEXTURED, test_stencil, 900},
	{"depth", FAST_TEXTURED, test_depth, 900},
	{"alpha test", FAST_TEXTURED, test_alpha, 900},
	{"no red", FAST_TEXTURED, mask_red, 900},
	{"added", FAST_TEXTURED, add, 900},
};

/* How many pixels differ by more than rounding; seen counts all drawn ones. */
static int count_others(
	const struct state_case *c, uint32_t seed, bool luminance, int *seen)
{
	struct soft_scene *fast = fast_scene_open(7), *slow = fast_scene_open(7);
	struct soft_corner corner[FAST_CORNERS];
	int others = 0;

	fast_scene_make_triangles(corner, seed, c->kind, c->size);
	for (int i = 0; i < FAST_CORNERS; i++) {
		corner[i].color[3] = (uint8_t)(i * 37);
	}
	for (int i = 0; i < 2; i++) {
		struct soft_scene *scene = i ? slow : fast;

		fast_scene_set_state(scene, corner, c->kind, i);
		if (luminance) {
			use_luminance(scene->gl);
		}
		c->set(scene->gl);
		scene->gl->DrawArrays(GL_TRIANGLES, 0, FAST_CORNERS);
	}
	assert_memory_equal(fast->soft->buffers.depth,
		slow->soft->buffers.depth, SOFT_SCENE_PIXELS * 2);
	if (fast->soft->buffers.stencil) {
		assert_memory_equal(fast->soft->buffers.stencil,
			slow->soft->buffers.stencil, SOFT_SCENE_PIXELS);
	}
	*seen = 0;
	for (int i = 0; i < SOFT_SCENE_PIXELS; i++) {
		*seen += slow->pixel[i] != 0;
		others += soft_scene_steps(fast->pixel[i], slow->pixel[i]) > 1;
	}
	soft_scene_close(fast);
	soft_scene_close(slow);
	return others;
}

static void check_cases(
	const struct state_case *list, size_t count, bool luminance)
{
	for (size_t i = 0; i < count; i++) {
		const struct state_case *c = &list[i];
		int seen,
			others = count_others(
				c, (uint32_t)i + 1, luminance, &seen);
		/* either of two texels at their edge; sums of blending */
		int most = seen / (c->kind == FAST_TEXTURED ? 30 : 200);

		if (others > most || seen < 100) {
			fail_msg("%s: %d of %d pixels differ", c->name, others,
				seen);
		}
	}
}

static void test_states_that_no_path_draws_look_as_the_long_way(void **state)
{
	(void)state;
	check_cases(cases, ARRAY_COUNT(cases), false);
}

static void test_other_states_of_luminance_look_as_the_long_way(void **state)
{
	(void)state;
	check_cases(luminance_cases, ARRAY_COUNT(luminance_cases), true);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_states_that_no_path_draws_look_as_the_long_way),
		cmocka_unit_test(
			test_other_states_of_luminance_look_as_the_long_way),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
