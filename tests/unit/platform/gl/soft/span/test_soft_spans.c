/*
 * Every span function against the reference, which draws any state: random
 * states, textures, sizes and places. Coverage, depth and stencil are equal,
 * colours within a step of RGB565.
 */
#include "platform/gl/soft/raster/raster.h"
#include "tests/support/random.h"
#include "tests/support/soft/reference.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	WIDTH = 112,
	HEIGHT = 90,
	PIXELS = WIDTH * HEIGHT,
	TRIANGLES = 1, /* others on top would add to the difference */
	SIDE_MOST = 256,
};

struct corner {
	float position[3];
	uint8_t color[4];
	float texcoord[2][2]; /* of the texture units */
};

struct scene {
	struct gl_context *context;
	const struct gl *gl;
	struct soft *soft;
	uint8_t bytes[PIXELS * 4];
	struct pixels picture;
};

static struct scene *open_scene(enum pixel_format format)
{
	const struct log log = {0};
	struct scene *scene = calloc(1, sizeof(*scene));

	assert_non_null(scene);
	scene->picture = (struct pixels){
		.width = WIDTH,
		.height = HEIGHT,
		.stride_bytes = WIDTH * pixel_bytes(format),
		.format = format,
		.data = scene->bytes,
	};
	assert_int_equal(
		gl_open("soft",
			&(struct gl_request){.format = format, .log = &log},
			&scene->context),
		0);
	scene->gl = &scene->context->gl;
	scene->soft = (struct soft *)scene->context;
	return scene;
}

static void close_scene(struct scene *scene)
{
	scene->context->driver->end_frame(scene->context);
	scene->context->driver->destroy(scene->context);
	free(scene);
}

/* A format, and how many bytes of it a texel takes. */
static const struct texel_case {
	GLenum format, type;
	int bytes;
} texels[] = {
	{GL_RGB, GL_UNSIGNED_SHORT_5_6_5, 2},
	{GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, 2},
	{GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, 2},
	{GL_RGBA, GL_UNSIGNED_BYTE, 4},
	{GL_LUMINANCE, GL_UNSIGNED_BYTE, 1},
	{GL_ALPHA, GL_UNSIGNED_BYTE, 1},
	{GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, 2},
	{GL_RGB, GL_UNSIGNED_BYTE, 3},
};

static GLenum one_of(uint32_t *seed, const GLenum *values, int count)
{
	return values[random_between(seed, 0, count - 1)];
}

static bool by_chance(uint32_t *seed, int one_in)
{
	return random_between(seed, 1, one_in) == 1;
}

static void give_texture(const struct gl *gl, uint32_t *seed)
{
	static uint8_t bytes[SIDE_MOST * SIDE_MOST * 4];
	static const GLenum min[] = {GL_NEAREST, GL_LINEAR,
		GL_NEAREST_MIPMAP_NEAREST, GL_LINEAR_MIPMAP_NEAREST,
		GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR_MIPMAP_LINEAR};
	static const GLenum mag[] = {GL_NEAREST, GL_LINEAR};
	static const GLenum wrap[] = {GL_REPEAT, GL_CLAMP_TO_EDGE};
	const struct texel_case *texel = &texels[random_between(seed, 0, 7)];
	int width = 1 << random_between(seed, 0, 8);
	int height = 1 << random_between(seed, 0, 8);
	GLuint name;

	for (size_t i = 0; i < sizeof(bytes); i++) {
		bytes[i] = (uint8_t)next_random(seed);
	}
	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
		(GLfixed)one_of(seed, min, 6));
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER,
		(GLfixed)one_of(seed, mag, 2));
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S,
		(GLfixed)one_of(seed, wrap, 2));
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T,
		(GLfixed)one_of(seed, wrap, 2));
	for (int level = 0;; level++) {
		gl->TexImage2D(GL_TEXTURE_2D, level, (GLint)texel->format,
			width, height, 0, texel->format, texel->type, bytes);
		if (width == 1 && height == 1) {
			break;
		}
		width = width > 1 ? width / 2 : 1;
		height = height > 1 ? height / 2 : 1;
	}
	gl->Enable(GL_TEXTURE_2D);
}

static void give_combiner(const struct gl *gl, uint32_t *seed)
{
	static const GLenum functions[] = {GL_REPLACE, GL_MODULATE, GL_ADD,
		0x8574 /* ADD_SIGNED */, 0x8575 /* INTERPOLATE */,
		0x84E7 /* SUBTRACT */, GL_DOT3_RGB, GL_DOT3_RGBA};
	static const GLenum sources[] = {
		GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS};
	static const GLenum operands[] = {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA,
		GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR};

	gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_RGB,
		(GLfixed)one_of(seed, functions, 8));
	gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_ALPHA,
		(GLfixed)one_of(seed, functions, 6));
	for (GLenum i = 0; i < 3; i++) {
		gl->TexEnvx(GL_TEXTURE_ENV, GL_SRC0_RGB + i,
			(GLfixed)one_of(seed, sources, 4));
		gl->TexEnvx(GL_TEXTURE_ENV, GL_SRC0_ALPHA + i,
			(GLfixed)one_of(seed, sources, 4));
		gl->TexEnvx(GL_TEXTURE_ENV, GL_OPERAND0_RGB + i,
			(GLfixed)one_of(seed, operands, 4));
		gl->TexEnvx(GL_TEXTURE_ENV, 0x8598 /* GL_OPERAND0_ALPHA */ + i,
			(GLfixed)one_of(seed, operands, 2));
	}
	gl->TexEnvx(GL_TEXTURE_ENV, GL_RGB_SCALE,
		65536 << random_between(seed, 0, 2));
	gl->TexEnvx(GL_TEXTURE_ENV, 0x0D1C /* GL_ALPHA_SCALE */,
		65536 << random_between(seed, 0, 2));
}

static void give_environment(const struct gl *gl, uint32_t *seed)
{
	static const GLenum modes[] = {GL_MODULATE, GL_MODULATE, GL_REPLACE,
		GL_DECAL, GL_ADD, GL_BLEND, GL_COMBINE};
	GLfixed color[4];

	for (int i = 0; i < 4; i++) {
		color[i] = random_between(seed, 0, 65536);
	}
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
		(GLfixed)one_of(seed, modes, 7));
	gl->TexEnvxv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
	give_combiner(gl, seed);
}

/* None, the first, the second, or both, with coordinates of their own. */
static void give_textures(const struct gl *gl, uint32_t *seed)
{
	int which = random_between(seed, 0, 7);

	which = which > 3 ? 1 : which;
	for (int unit = 0; unit < 2; unit++) {
		if (which >> unit & 1) {
			gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
			gl->ClientActiveTexture(GL_TEXTURE0 + (GLenum)unit);
			give_texture(gl, seed);
			give_environment(gl, seed);
			gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
		}
	}
}

static void give_fragments(const struct gl *gl, uint32_t *seed)
{
	static const GLenum functions[] = {GL_LESS, GL_LEQUAL, GL_GREATER,
		GL_ALWAYS, GL_NOTEQUAL, GL_GEQUAL, GL_EQUAL};
	static const GLenum source[] = {GL_SRC_ALPHA, GL_SRC_ALPHA,
		GL_SRC_ALPHA, GL_ONE, GL_DST_COLOR, GL_ZERO,
		GL_ONE_MINUS_DST_COLOR, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA,
		0x0308 /* GL_SRC_ALPHA_SATURATE */};
	static const GLenum destination[] = {GL_ONE_MINUS_SRC_ALPHA,
		GL_ONE_MINUS_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ZERO,
		GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA,
		GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA};

	if (by_chance(seed, 3)) {
		gl->Enable(GL_BLEND);
		gl->BlendFunc(one_of(seed, source, 10),
			one_of(seed, destination, 10));
	}
	if (by_chance(seed, 3)) {
		gl->Enable(GL_ALPHA_TEST);
		gl->AlphaFuncx(one_of(seed, functions, 7),
			random_between(seed, 0, 65536));
	}
	if (by_chance(seed, 4)) {
		static const GLfixed color[] = {20000, 50000, 9000, 65536};

		gl->Enable(GL_FOG);
		gl->Fogx(GL_FOG_MODE, GL_LINEAR);
		gl->Fogx(GL_FOG_START, 2 * 65536);
		gl->Fogx(GL_FOG_END, 6 * 65536);
		gl->Fogxv(GL_FOG_COLOR, color);
	}
	if (!by_chance(seed, 6)) {
		gl->Enable(GL_DEPTH_TEST);
		gl->DepthFunc(by_chance(seed, 2) ? GL_LESS
						 : one_of(seed, functions, 7));
		gl->DepthMask(!by_chance(seed, 4));
	}
	if (by_chance(seed, 8)) {
		gl->ColorMask(by_chance(seed, 2), by_chance(seed, 2),
			by_chance(seed, 2), by_chance(seed, 2));
	}
	if (by_chance(seed, 8)) {
		gl->Enable(GL_STENCIL_TEST);
		gl->StencilFunc(GL_EQUAL, 0, 255);
		gl->StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
	}
}

static void draw_corners(const struct gl *gl, const struct corner *corner)
{
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, sizeof(*corner), corner->position);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(*corner), corner->color);
	for (GLenum unit = 0; unit < 2; unit++) {
		gl->ClientActiveTexture(GL_TEXTURE0 + unit);
		gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
		gl->TexCoordPointer(
			2, GL_FLOAT, sizeof(*corner), corner->texcoord[unit]);
	}
	gl->DrawArrays(GL_TRIANGLES, 0, TRIANGLES * 3);
}

/* At depths around 4: w differs by up to half, hardly, or not at all. */
static void give_triangles(const struct gl *gl, uint32_t *seed)
{
	static struct corner corner[TRIANGLES * 3];
	static const int sizes[] = {3, 8, 30, 120, 400};
	int size = sizes[random_between(seed, 0, 4)];
	int bend = random_between(seed, 0, 2) * 40;
	int texels_wide = random_between(seed, 1, 30);
	bool one_color = by_chance(seed, 4);

	for (int i = 0; i < TRIANGLES * 3; i++) {
		struct corner *c = &corner[i];
		float depth = 4.0f +
			(float)random_between(seed, -bend, bend) / 100.0f;
		float x = (float)random_between(seed, -80, 80);
		float y = (float)random_between(seed, -80, 80);

		if (i % 3 != 0) {
			const float *first = corner[i / 3 * 3].position;

			x = first[0] * 50.0f +
				(float)random_between(seed, -size, size);
			y = first[1] * 50.0f +
				(float)random_between(seed, -size, size);
		}
		c->position[0] = x / 50.0f;
		c->position[1] = y / 50.0f;
		c->position[2] = -depth;
		for (int k = 0; k < 4; k++) {
			c->color[k] = (uint8_t)(one_color
					? 200
					: random_between(seed, 0, 255));
		}
		for (int k = 0; k < 4; k++) {
			c->texcoord[k / 2][k % 2] =
				(float)random_between(seed, -100, 100) /
				100.0f * (float)texels_wide / 8.0f;
		}
	}
	draw_corners(gl, corner);
}

/* A picture of noise, for one way of drawing or the other. */
static struct scene *begin(enum pixel_format format, bool reference)
{
	struct scene *scene = open_scene(format);
	const struct gl *gl = scene->gl;

	assert_int_equal(scene->context->driver->begin_frame(
				 scene->context, &scene->picture),
		0);
	reference_use(scene->soft, reference);
	gl->ClearDepthx(60000);
	gl->Enable(GL_STENCIL_TEST);
	gl->Clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
	gl->Disable(GL_STENCIL_TEST);
	for (size_t i = 0; i < sizeof(scene->bytes); i++) {
		scene->bytes[i] = (uint8_t)(i * 37 ^ i >> 5);
	}
	return scene;
}

static struct scene *draw(
	enum pixel_format format, uint32_t seed, bool reference)
{
	struct scene *scene = begin(format, reference);
	const struct gl *gl = scene->gl;

	gl->MatrixMode(GL_PROJECTION);
	gl->Frustumx(-20000, 20000, -16000, 16000, 65536, 8 * 65536);
	gl->MatrixMode(GL_MODELVIEW);
	give_textures(gl, &seed);
	give_fragments(gl, &seed);
	give_triangles(gl, &seed);
	return scene;
}

static int distance(int a, int b)
{
	return abs(a - b);
}

/* In steps of what the picture has five bits of. */
static bool is_near(const struct scene *a, const struct scene *b, int i)
{
	if (a->soft->format == PIXELS_RGBA8888) {
		for (int k = 0; k < 4; k++) {
			if (distance(a->bytes[4 * i + k], b->bytes[4 * i + k]) >
				8) {
				return false;
			}
		}
		return true;
	}
	int p = a->bytes[2 * i] | a->bytes[2 * i + 1] << 8;
	int q = b->bytes[2 * i] | b->bytes[2 * i + 1] << 8;

	return distance(p >> 11, q >> 11) <= 1 &&
		distance(p >> 5 & 63, q >> 5 & 63) <= 2 &&
		distance(p & 31, q & 31) <= 1;
}

static int compare(const struct scene *a, const struct scene *b, uint32_t seed)
{
	const struct buffers *x = &a->soft->buffers, *y = &b->soft->buffers;
	int drawn = 0;

	assert_memory_equal(x->depth, y->depth, PIXELS * 2);
	assert_memory_equal(x->stencil, y->stencil, PIXELS);
	for (int i = 0; i < PIXELS; i++) {
		if (!is_near(a, b, i)) {
			const uint8_t *p = a->bytes, *q = b->bytes;
			int at = i * pixel_bytes(a->soft->format);

			fail_msg("seed %u: pixel %d,%d: %02x%02x%02x%02x, by "
				 "fragments %02x%02x%02x%02x, finish %d",
				seed, i % WIDTH, i / WIDTH, p[at], p[at + 1],
				p[at + 2], p[at + 3], q[at], q[at + 1],
				q[at + 2], q[at + 3],
				(int)a->soft->draw->spans.finish);
		}
		drawn += x->depth[i] != x->depth[0];
	}
	return drawn;
}

static void check(enum pixel_format format)
{
	/* other scenes than everyone's, to look for differences */
	const char *from = getenv("SPANS_FROM"), *count = getenv("SPANS_COUNT");
	uint32_t first = from ? (uint32_t)strtoul(from, NULL, 10) : 0;
	int seeds = count ? atoi(count) : 3000;
	int used = 0, drawn = 0;

	for (uint32_t i = 1; i <= (uint32_t)seeds; i++) {
		uint32_t seed = first + i;
		struct scene *fast = draw(format, seed * 7919, false);
		struct scene *slow = draw(format, seed * 7919, true);

		used += fast->soft->draw->fill == soft_rows_fill;
		drawn += compare(fast, slow, seed);
		close_scene(fast);
		close_scene(slow);
	}
	/* others have an alpha test that nothing passes */
	assert_true(used > seeds / 10 * 9);
	assert_true(drawn > 100000);
}

static void test_spans_of_565_are_those_of_fragments(void **state)
{
	(void)state;
	check(PIXELS_RGB565);
}

static void test_spans_of_8888_are_those_of_fragments(void **state)
{
	(void)state;
	check(PIXELS_RGBA8888);
}

static struct scene *draw_heap(
	enum pixel_format format, uint32_t seed, bool reference)
{
	struct scene *scene = begin(format, reference);
	const struct gl *gl = scene->gl;

	gl->MatrixMode(GL_PROJECTION);
	gl->Frustumx(-20000, 20000, -16000, 16000, 65536, 8 * 65536);
	gl->MatrixMode(GL_MODELVIEW);
	gl->Enable(GL_DEPTH_TEST);
	gl->DepthFunc(seed % 2 ? GL_LESS : GL_LEQUAL);
	give_texture(gl, &seed);
	for (int i = 0; i < 60; i++) {
		give_triangles(gl, &seed);
	}
	return scene;
}

/* Triangles behind others, which the driver does not set up, and before them. */
static void test_heaps_of_triangles_are_those_of_fragments(void **state)
{
	(void)state;
	for (uint32_t seed = 1; seed <= 120; seed++) {
		enum pixel_format format =
			seed % 3 ? PIXELS_RGB565 : PIXELS_RGBA8888;
		struct scene *fast = draw_heap(format, seed * 7919, false);
		struct scene *slow = draw_heap(format, seed * 7919, true);

		assert_true(compare(fast, slow, seed) > 1000);
		close_scene(fast);
		close_scene(slow);
	}
}

/* A state, and a triangle that is drawn in it, at depths of 1 to 200. */
struct single {
	void (*give)(const struct gl *gl);
	struct corner corner[3];
};

static struct scene *draw_single(
	const struct single *single, enum pixel_format format, bool reference)
{
	struct scene *scene = begin(format, reference);
	const struct gl *gl = scene->gl;

	gl->MatrixMode(GL_PROJECTION);
	gl->Frustumx(-65536, 65536, -65536, 65536, 65536, 200 * 65536);
	gl->MatrixMode(GL_MODELVIEW);
	single->give(gl);
	draw_corners(gl, single->corner);
	return scene;
}

static void check_single(const struct single *single)
{
	for (int i = 0; i < 2; i++) {
		enum pixel_format format = i ? PIXELS_RGBA8888 : PIXELS_RGB565;
		struct scene *fast = draw_single(single, format, false);
		struct scene *slow = draw_single(single, format, true);

		assert_ptr_equal(fast->soft->draw->fill, soft_rows_fill);
		compare(fast, slow, 0);
		close_scene(fast);
		close_scene(slow);
	}
}

static void give_fog(const struct gl *gl)
{
	static const GLfixed color[] = {65536, 0, 30000, 65536};

	gl->Enable(GL_FOG);
	gl->Fogx(GL_FOG_MODE, GL_LINEAR);
	gl->Fogx(GL_FOG_START, 2 * 65536);
	gl->Fogx(GL_FOG_END, 10 * 65536);
	gl->Fogxv(GL_FOG_COLOR, color);
}

/* 1 / w changes so much from column to column that column 0's wraps. */
static void test_fog_on_a_steep_sliver_of_one_color(void **state)
{
	static const struct single single = {give_fog,
		{{{-0.7f, 2.08889f, -2.0f}, {52, 42, 93, 17}, {{0}}},
			{{-10.0349f, 24.8106f, -28.31f}, {52, 42, 93, 17}, {{0}}},
			{{-0.682143f, 1.80556f, -2.0f}, {52, 42, 93, 17},
				{{0}}}}};

	(void)state;
	check_single(&single);
}

static void give_levels(const struct gl *gl, GLenum format, int side)
{
	static uint8_t bytes[128 * 128];
	GLuint name;

	for (size_t i = 0; i < sizeof(bytes); i++) {
		bytes[i] = (uint8_t)(i * 29 ^ i >> 3);
	}
	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	gl->TexParameterx(
		GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
	for (int level = 0; side >> level > 0; level++) {
		gl->TexImage2D(GL_TEXTURE_2D, level, (GLint)format,
			side >> level, side >> level, 0, format,
			GL_UNSIGNED_BYTE, bytes);
	}
	gl->Enable(GL_TEXTURE_2D);
}

static void give_dot_of_alpha(const struct gl *gl)
{
	give_levels(gl, GL_ALPHA, 32);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_PRIMARY_COLOR);
}

static void test_dot3_of_mixed_levels_of_alpha(void **state)
{
	static const struct single single = {give_dot_of_alpha,
		{{{-1.5f, -1.5f, -2.0f}, {200, 180, 220, 255}, {{0.0f, 0.0f}}},
			{{1.5f, -1.5f, -2.0f}, {20, 30, 10, 255}, {{5.0f, 0.0f}}},
			{{0.0f, 1.5f, -2.0f}, {90, 70, 60, 255},
				{{0.0f, 5.0f}}}}};

	(void)state;
	check_single(&single);
}

static void give_luminance(const struct gl *gl)
{
	give_levels(gl, GL_LUMINANCE, 128);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
}

/* Coordinates beyond 2^15 of a texture's texels wrap without overflowing. */
static void test_coordinates_far_outside_of_a_clamped_texture(void **state)
{
	static const struct single single = {give_luminance,
		{{{-0.5f, -0.5f, -2.0f}, {9, 80, 20, 255}, {{-600.0f, 0.0f}}},
			{{0.0f, -0.5f, -2.0f}, {9, 80, 20, 255},
				{{-600.5f, 0.0f}}},
			{{0.0f, 0.0f, -2.0f}, {9, 80, 20, 255},
				{{-601.0f, 0.5f}}}}};

	(void)state;
	check_single(&single);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_spans_of_565_are_those_of_fragments),
		cmocka_unit_test(test_spans_of_8888_are_those_of_fragments),
		cmocka_unit_test(test_heaps_of_triangles_are_those_of_fragments),
		cmocka_unit_test(test_fog_on_a_steep_sliver_of_one_color),
		cmocka_unit_test(test_dot3_of_mixed_levels_of_alpha),
		cmocka_unit_test(
			test_coordinates_far_outside_of_a_clamped_texture),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
