/*
 * A draw call prepares anew what reads a group of the state that has changed:
 * see soft.h. Here each setter of gl_functions.h is called in random states,
 * with a draw after it, and pictures, depths and stencil are those of a driver
 * that prepares everything anew for each draw.
 */
#include "platform/base/compiler.h"
#include "platform/base/fixed.h"
#include "platform/gl/soft/soft.h"
#include "tests/support/gl/gl_checks.h"
#include "tests/support/gl/gl_entries.h"
#include "tests/support/random.h"

#include <stdlib.h>
#include <string.h>

enum {
	SEQUENCES = 2500,
	BEFORE = 40, /* setters before a sequence */
	STEPS = 24,  /* of a sequence: a setter and a draw */
	CORNERS = 48,
	TEXTURES = 4,
	SIDE = 8, /* of textures */
	ONE = FX16_ONE,
};

/* A sequence's driver, what its arrays point to, and its random numbers. */
struct scene {
	struct gl_canvas canvas;
	const struct gl *gl;
	uint32_t *seed;
	GLuint texture[TEXTURES];
	float values[CORNERS * 4 + 64];
	GLfixed fixed[CORNERS * 4 + 64];
	uint8_t bytes[CORNERS * 4 + 64];
};

#define PICK(...)                                                \
	(((const GLenum[]){__VA_ARGS__})[random_between(seed, 0, \
		(int)ARRAY_COUNT(((const GLenum[]){__VA_ARGS__})) - 1)])

/* A number that states have: 0, 1, or about these. */
static GLfixed number(uint32_t *seed)
{
	return random_one_in(seed, 4) ? ONE * random_between(seed, 0, 2)
				      : random_within(seed, ONE);
}

static GLfixed positive(uint32_t *seed)
{
	return random_between(seed, 1, 3 * ONE);
}

static const GLfixed *four(uint32_t *seed)
{
	static GLfixed v[4];

	for (int i = 0; i < 4; i++) {
		v[i] = number(seed);
	}
	v[3] = random_one_in(seed, 2) ? v[3] : 0;
	return v;
}

static GLenum capability(uint32_t *seed)
{
	return PICK(GL_LIGHTING, GL_LIGHT0, GL_LIGHT0 + 1, GL_TEXTURE_2D,
		GL_TEXTURE_2D, GL_BLEND, GL_CULL_FACE, GL_DEPTH_TEST,
		GL_STENCIL_TEST, GL_ALPHA_TEST, GL_SCISSOR_TEST,
		GL_POLYGON_OFFSET_FILL, GL_COLOR_MATERIAL, GL_NORMALIZE,
		GL_RESCALE_NORMAL, GL_FOG, GL_POINT_SMOOTH, GL_LINE_SMOOTH,
		GL_DITHER);
}

static GLenum array(uint32_t *seed)
{
	return PICK(GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_COLOR_ARRAY,
		GL_TEXTURE_COORD_ARRAY);
}

static GLenum comparison(uint32_t *seed)
{
	return GL_NEVER + (GLenum)random_between(seed, 1, 7);
}

static GLenum action(uint32_t *seed)
{
	return PICK(GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT);
}

/* An array's type, and a place where values of it begin. */
static GLenum place(struct scene *s, const void **out)
{
	uint32_t *seed = s->seed;
	const GLenum type = PICK(GL_FLOAT, GL_FIXED, GL_FLOAT, GL_SHORT);
	const int at = random_between(seed, 0, 40);

	*out = type == GL_FLOAT ? (const void *)(s->values + at)
				: (const void *)(s->fixed + at);
	return type;
}

static void send_texture(struct scene *s, int level, int side)
{
	uint32_t *seed = s->seed;
	const GLenum format = PICK(GL_RGB, GL_RGBA, GL_ALPHA, GL_LUMINANCE,
		GL_LUMINANCE_ALPHA, GL_RGB);
	uint8_t texels[4 * SIDE * SIDE];

	for (int i = 0; i < 4 * side * side; i++) {
		texels[i] = (uint8_t)next_random(seed);
	}
	s->gl->TexImage2D(GL_TEXTURE_2D, level, (GLint)format, side, side, 0,
		format, GL_UNSIGNED_BYTE, texels);
}

/* A name of a call with one value, and the value. */
struct named {
	GLenum name;
	GLfixed value;
};

static struct named environment(uint32_t *seed)
{
	switch (random_between(seed, 0, 3)) {
	case 0:
		return (struct named){GL_COMBINE_RGB,
			(GLfixed)PICK(GL_REPLACE, GL_MODULATE, GL_ADD)};
	case 1:
		return (struct named){GL_SRC0_RGB,
			(GLfixed)PICK(GL_TEXTURE, GL_CONSTANT, GL_PREVIOUS)};
	default:
		return (struct named){GL_TEXTURE_ENV_MODE,
			(GLfixed)PICK(GL_MODULATE, GL_MODULATE, GL_DECAL,
				GL_BLEND, GL_ADD, GL_REPLACE, GL_COMBINE)};
	}
}

static struct named parameter(uint32_t *seed)
{
	switch (random_between(seed, 0, 2)) {
	case 0:
		return (struct named){GL_TEXTURE_MAG_FILTER,
			(GLfixed)PICK(GL_NEAREST, GL_LINEAR)};
	case 1:
		return (struct named){PICK(GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T),
			(GLfixed)PICK(GL_REPEAT, GL_CLAMP_TO_EDGE)};
	default:
		return (struct named){GL_TEXTURE_MIN_FILTER,
			(GLfixed)PICK(GL_NEAREST, GL_LINEAR,
				GL_LINEAR_MIPMAP_NEAREST)};
	}
}

/* A call that draws nothing, named as the function that it calls. */
#define SETTER(name, ...)                                       \
	static void set_##name(struct scene *s, uint32_t *seed) \
	{                                                       \
		const struct gl *gl = s->gl;                    \
		const void *at = NULL;                          \
		GLenum type = 0;                                \
		struct named named = {0, 0};                    \
                                                                \
		(void)seed;                                     \
		(void)gl;                                       \
		(void)at;                                       \
		(void)type;                                     \
		(void)named;                                    \
		__VA_ARGS__;                                    \
	}

#define NUMBER number(seed)
SETTER(ActiveTexture, gl->ActiveTexture(PICK(GL_TEXTURE0, GL_TEXTURE1)))
SETTER(AlphaFuncx, gl->AlphaFuncx(comparison(seed), NUMBER))
SETTER(BindTexture,
	gl->BindTexture(GL_TEXTURE_2D,
		s->texture[random_between(seed, 0, TEXTURES - 1)]))
SETTER(BlendFunc,
	gl->BlendFunc(PICK(GL_ONE, GL_SRC_ALPHA, GL_DST_COLOR),
		PICK(GL_ZERO, GL_ONE, GL_ONE_MINUS_SRC_ALPHA)))
SETTER(ClearColorx, gl->ClearColorx(NUMBER, NUMBER, NUMBER, NUMBER))
SETTER(ClearDepthx, gl->ClearDepthx(random_between(seed, ONE / 2, ONE)))
SETTER(ClearStencil, gl->ClearStencil(random_between(seed, 0, 3)))
SETTER(ClientActiveTexture,
	gl->ClientActiveTexture(PICK(GL_TEXTURE0, GL_TEXTURE1)))
SETTER(Color4x, gl->Color4x(NUMBER, NUMBER, NUMBER, NUMBER))
SETTER(ColorMask,
	gl->ColorMask(GL_TRUE, random_one_in(seed, 2), GL_TRUE, GL_TRUE))
SETTER(ColorPointer, type = place(s, &at);
	gl->ColorPointer(4, type == GL_SHORT ? GL_UNSIGNED_BYTE : type, 0,
		type == GL_SHORT ? s->bytes : at))
SETTER(CullFace, gl->CullFace(PICK(GL_FRONT, GL_BACK)))
SETTER(DeleteTextures, int i = random_between(seed, 0, TEXTURES - 1);
	gl->DeleteTextures(1, &s->texture[i]))
SETTER(DepthFunc, gl->DepthFunc(comparison(seed)))
SETTER(DepthMask, gl->DepthMask(random_one_in(seed, 2)))
SETTER(Disable, gl->Disable(capability(seed)))
SETTER(
	DisableClientState, type = array(seed);
	if (type != GL_VERTEX_ARRAY) { gl->DisableClientState(type); })
SETTER(Enable, gl->Enable(capability(seed)))
SETTER(EnableClientState, gl->EnableClientState(array(seed)))
SETTER(Fogx, gl->Fogx(PICK(GL_FOG_START, GL_FOG_END), NUMBER))
SETTER(Fogxv, gl->Fogxv(GL_FOG_COLOR, four(seed)))
SETTER(FrontFace, gl->FrontFace(PICK(GL_CW, GL_CCW)))
SETTER(Frustumx, gl->LoadIdentity();
	gl->Frustumx(-ONE, ONE, -ONE, positive(seed), ONE / 2, 4 * ONE);
	gl->Translatex(0, 0, -ONE))
SETTER(GenTextures, gl->GenTextures(1, s->texture))
SETTER(LightModelx,
	gl->LightModelx(GL_LIGHT_MODEL_TWO_SIDE, random_between(seed, 0, 1)))
SETTER(LightModelxv, gl->LightModelxv(GL_LIGHT_MODEL_AMBIENT, four(seed)))
SETTER(Lightx,
	gl->Lightx(PICK(GL_LIGHT0, GL_LIGHT0 + 1),
		PICK(GL_SPOT_EXPONENT, GL_SPOT_CUTOFF, GL_LINEAR_ATTENUATION),
		positive(seed) * 8))
SETTER(Lightxv,
	gl->Lightxv(PICK(GL_LIGHT0, GL_LIGHT0 + 1),
		PICK(GL_POSITION, GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR,
			GL_SPOT_DIRECTION),
		four(seed)))
SETTER(LineWidthx, gl->LineWidthx(positive(seed)))
SETTER(LoadIdentity, gl->LoadIdentity())
SETTER(
	LoadMatrixx, GLfixed m[16]; for (int i = 0; i < 16; i++) {
		m[i] = i % 5 == 0 ? positive(seed) : number(seed) / 8;
	} m[3] = m[7] = m[11] = 0;
	gl->LoadMatrixx(m))
SETTER(Materialx,
	gl->Materialx(GL_FRONT_AND_BACK, GL_SHININESS, 9 * positive(seed)))
SETTER(Materialxv,
	gl->Materialxv(GL_FRONT_AND_BACK,
		PICK(GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION,
			GL_AMBIENT_AND_DIFFUSE),
		four(seed)))
SETTER(MatrixMode,
	gl->MatrixMode(
		PICK(GL_MODELVIEW, GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE)))
SETTER(MultMatrixx,
	GLfixed m[16] = {ONE, 0, 0, 0, 0, ONE, 0, 0, 0, 0, ONE, 0, NUMBER / 4,
		NUMBER / 4, 0, ONE};
	gl->MultMatrixx(m))
SETTER(Normal3x, gl->Normal3x(NUMBER, NUMBER, NUMBER))
SETTER(NormalPointer, type = place(s, &at); gl->NormalPointer(type, 0, at))
SETTER(Orthox, gl->LoadIdentity(); gl->Orthox(
	-positive(seed), ONE, -ONE, positive(seed), -2 * ONE, 2 * ONE))
SETTER(PixelStorei, gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1))
SETTER(PointSizex, gl->PointSizex(positive(seed)))
SETTER(PolygonOffsetx, gl->PolygonOffsetx(NUMBER, 200 * NUMBER))
SETTER(PopMatrix, gl->PopMatrix(); (void)gl->GetError())
SETTER(PushMatrix, gl->PushMatrix())
SETTER(Rotatex, gl->Rotatex(90 * NUMBER, NUMBER, NUMBER, ONE))
SETTER(Scalex, gl->Scalex(positive(seed) / 2, ONE, positive(seed) / 2))
SETTER(Scissor,
	gl->Scissor(random_between(seed, -3, 9), random_between(seed, 0, 9),
		random_between(seed, 0, 40), random_between(seed, 5, 30)))
SETTER(ShadeModel, gl->ShadeModel(PICK(GL_FLAT, GL_SMOOTH)))
SETTER(StencilFunc,
	gl->StencilFunc(PICK(GL_EQUAL, GL_EQUAL, GL_ALWAYS, comparison(seed)),
		random_between(seed, 0, 3), PICK(255, 1)))
SETTER(StencilMask, gl->StencilMask(PICK(255, 3)))
SETTER(StencilOp, gl->StencilOp(action(seed), GL_KEEP, action(seed)))
SETTER(TexCoordPointer, type = place(s, &at);
	gl->TexCoordPointer(2, type, 0, at))
SETTER(TexEnvx, named = environment(seed);
	gl->TexEnvx(GL_TEXTURE_ENV, named.name, named.value))
SETTER(TexEnvxv, gl->TexEnvxv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, four(seed)))
SETTER(TexImage2D, send_texture(s, 0, SIDE / random_between(seed, 1, 2)))
SETTER(TexParameterx, named = parameter(seed);
	gl->TexParameterx(GL_TEXTURE_2D, named.name, named.value))
SETTER(TexSubImage2D,
	gl->TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 4, 4,
		PICK(GL_RGB, GL_RGBA, GL_LUMINANCE), GL_UNSIGNED_BYTE, s->bytes);
	(void)gl->GetError())
SETTER(Translatex, gl->Translatex(NUMBER / 4, NUMBER / 4, NUMBER / 8))
SETTER(VertexPointer, type = place(s, &at);
	gl->VertexPointer(random_one_in(seed, 3) ? 2 : 3, type, 0, at))
SETTER(Viewport,
	gl->Viewport(random_between(seed, -2, 6), random_between(seed, -2, 6),
		random_between(seed, 9, 40), random_between(seed, 9, 40)))

static void set_nothing(struct scene *s, uint32_t *seed)
{
	(void)s;
	(void)seed;
}

#define set_Clear        set_nothing
#define set_DrawArrays   set_nothing
#define set_DrawElements set_nothing
#define set_Finish       set_nothing
#define set_GetError     set_nothing
#define set_GetIntegerv  set_nothing
#define set_GetString    set_nothing
#define set_ReadPixels   set_nothing

static void (*const setters[])(struct scene *s, uint32_t *seed) = {
#define GL_FUNCTION(result, name, parameters) set_##name,
#include "platform/gl/gl_functions.h"
#undef GL_FUNCTION
};

static void set_up_light(struct scene *s, uint32_t *seed)
{
	const struct gl *gl = s->gl;

	gl->Enable(GL_LIGHTING);
	gl->EnableClientState(GL_NORMAL_ARRAY);
	for (GLenum light = GL_LIGHT0; light < GL_LIGHT0 + 2; light++) {
		gl->Lightxv(light, GL_POSITION, four(seed));
		gl->Lightxv(light, GL_DIFFUSE, four(seed));
		gl->Lightxv(light, GL_AMBIENT, four(seed));
		gl->Enable(light);
	}
	if (random_one_in(seed, 2)) {
		gl->Enable(GL_COLOR_MATERIAL);
	}
}

/* A shadow, drawn in the current colour where the stencil is 0. */
static void set_up_shadow(struct scene *s, uint32_t *seed)
{
	const struct gl *gl = s->gl;

	(void)seed;
	gl->Disable(GL_LIGHTING);
	gl->Disable(GL_DEPTH_TEST);
	gl->DisableClientState(GL_COLOR_ARRAY);
	gl->Enable(GL_STENCIL_TEST);
	gl->StencilFunc(GL_EQUAL, 0, 255);
	gl->StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
}

static void set_up_text(struct scene *s, uint32_t *seed)
{
	const uint8_t texels[SIDE * SIDE] = {99, 0, 200, 255};
	const struct gl *gl = s->gl;

	(void)seed;
	gl->TexImage2D(GL_TEXTURE_2D, 0, GL_ALPHA, SIDE, SIDE, 0, GL_ALPHA,
		GL_UNSIGNED_BYTE, texels);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
	gl->Enable(GL_TEXTURE_2D);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	gl->Disable(GL_LIGHTING);
	gl->Disable(GL_DEPTH_TEST);
}

/* Two textures of the same arrays. */
static void set_up_textures(struct scene *s, uint32_t *seed)
{
	const int at = random_between(seed, 0, 40);

	for (GLenum unit = 0; unit < 2; unit++) {
		s->gl->ActiveTexture(GL_TEXTURE0 + unit);
		s->gl->BindTexture(GL_TEXTURE_2D, s->texture[unit]);
		s->gl->Enable(GL_TEXTURE_2D);
		s->gl->ClientActiveTexture(GL_TEXTURE0 + unit);
		s->gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
		s->gl->TexCoordPointer(2, GL_FLOAT, 0, s->values + at);
	}
}

static void (*const presets[])(struct scene *s, uint32_t *seed) = {
	set_nothing,
	set_up_light,
	set_up_light,
	set_up_shadow,
	set_up_text,
	set_up_textures,
};

static void begin(struct scene *s, enum pixel_format format)
{
	uint32_t *seed = s->seed;

	s->canvas = gl_canvas_open("soft", format);
	s->gl = s->canvas.gl;
	for (size_t i = 0; i < ARRAY_COUNT(s->values); i++) {
		/* draws that begin at other corners have other scales */
		s->fixed[i] = random_within(seed, ONE >> (i / 24 % 4));
		s->values[i] = (float)s->fixed[i] / ONE;
		s->bytes[i % sizeof(s->bytes)] = (uint8_t)next_random(seed);
	}
	s->gl->GenTextures(TEXTURES, s->texture);
	for (int i = 0; i < TEXTURES; i++) {
		s->gl->BindTexture(GL_TEXTURE_2D, s->texture[i]);
		s->gl->TexParameterx(
			GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
		send_texture(s, 0, SIDE);
	}
	set_VertexPointer(s, seed);
	set_NormalPointer(s, seed);
	set_ColorPointer(s, seed);
	for (GLenum unit = 0; unit < 2; unit++) {
		s->gl->ClientActiveTexture(GL_TEXTURE0 + unit);
		set_TexCoordPointer(s, seed);
	}
	s->gl->EnableClientState(GL_VERTEX_ARRAY);
	for (int i = random_between(seed, 0, BEFORE); i > 0; i--) {
		setters[random_between(seed, 0, ENTRIES - 1)](s, seed);
	}
	/* states that depend on much */
	presets[random_between(seed, 0, ARRAY_COUNT(presets) - 1)](s, seed);
}

static uint32_t add(uint32_t sum, const void *data, size_t bytes)
{
	for (size_t i = 0; i < bytes; i++) {
		sum = (sum ^ ((const uint8_t *)data)[i]) * 16777619u;
	}
	return sum;
}

/* Draws, and returns a sum of all that the call may have drawn. */
static uint32_t draw(struct scene *s, GLenum mode, int first, bool anew)
{
	struct soft *soft = (struct soft *)s->canvas.context;
	const struct buffers *buffers = &soft->buffers;
	const size_t pixels = (size_t)(buffers->width * buffers->height);
	uint32_t sum;

	s->gl->Clear(GL_DEPTH_BUFFER_BIT |
		(first % 4 ? 0 : GL_COLOR_BUFFER_BIT | GL_STENCIL_BUFFER_BIT));
	if (anew) {
		soft->changed = GROUP_ALL;
	}
	s->gl->DrawArrays(mode, first, CORNERS / 2);
	sum = add(1, buffers->target.data,
		pixels * (soft->format == PIXELS_RGB565 ? 2 : 4));
	sum = add(sum, buffers->depth, 2 * pixels);
	return buffers->stencil ? add(sum, buffers->stencil, pixels) : sum;
}

/* Notes a sum of each draw, and the setter before it. */
static void run(uint32_t seed, bool anew, uint32_t sums[STEPS],
	enum entry entries[STEPS])
{
	struct scene scene = {.seed = &seed};

	begin(&scene, random_one_in(&seed, 2) ? PIXELS_RGB565 : PIXELS_RGBA8888);
	for (int i = 0; i < STEPS; i++) {
		const GLenum mode = random_one_in(&seed, 3)
			? (GLenum)random_between(&seed, 0, 6)
			: GL_TRIANGLES;
		const int first = random_between(&seed, 0, CORNERS / 2 - 4);

		entries[i] = random_one_in(&seed, 8) ? ENTRY_Enable
			: random_one_in(&seed, 8)
			? ENTRY_Disable
			: (enum entry)random_between(&seed, 0, ENTRIES - 1);
		setters[entries[i]](&scene, &seed);
		sums[i] = draw(&scene, mode, first, anew);
	}
	(void)scene.gl->GetError();
	gl_canvas_end_and_close(&scene.canvas);
}

static void test_after_any_setter_a_draw_is_as_if_prepared_anew(void **state)
{
	uint32_t kept[STEPS], anew[STEPS];
	enum entry entries[STEPS];

	(void)state;
	for (uint32_t seed = 1; seed <= SEQUENCES; seed++) {
		run(seed, false, kept, entries);
		run(seed, true, anew, entries);
		for (int i = 0; i < STEPS; i++) {
			if (kept[i] != anew[i]) {
				fail_msg("seed %u: the draw after number %d, %s",
					seed, i, entry_names[entries[i]]);
			}
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_after_any_setter_a_draw_is_as_if_prepared_anew),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
