/*
 * Setters of named parameters, by a table for each kind of object (lights,
 * materials, fog, textures, texture environments); glGetIntegerv, glGetString.
 */
#include "platform/gl/soft/state/state.h"

#include <string.h>

#include "platform/base/fixed.h"
#include "platform/gl/soft/state/matrix.h"

/* More names of ES 1.1 that gl.h does not have. */
enum {
	ALPHA_SCALE = 0x0D1C,
	OPERAND0_ALPHA = 0x8598,
};

/*
 * A parameter: count values of 32 bits, enumerants or 16.16, in a struct; or
 * several of one value each with consecutive names.
 */
struct parameter {
	GLenum name, names; /* the first of consecutive names, how many */
	size_t count;
	size_t offset;       /* of the first name's; the others' follow it */
	GLenum error;        /* that a value sets which is not allowed */
	GLfixed least, most; /* allowed are values from least to most, */
	GLenum allowed[8];   /* and those of this list */
	size_t allowed_count;
};

#define PARAMETER(name, names, type, member, ...)                           \
	{                                                                   \
		name, names, sizeof(((type *)0)->member) / sizeof(GLfixed), \
			offsetof(type, member), __VA_ARGS__                 \
	}
#define ANY(name, type, member)                                             \
	PARAMETER(name, 1, type, member, GL_NO_ERROR, INT32_MIN, INT32_MAX, \
		{0}, 0)
#define RANGE(name, names, type, member, most) \
	PARAMETER(name, names, type, member, GL_INVALID_VALUE, 0, most, {0}, 0)
#define LISTED(name, names, type, member, error, ...)                     \
	PARAMETER(name, names, type, member, error, INT32_MAX, INT32_MIN, \
		{__VA_ARGS__}, ARRAY_COUNT(((const GLenum[]){__VA_ARGS__})))
#define NUMBER(name, type, member, ...) \
	LISTED(name, 1, type, member, GL_INVALID_VALUE, __VA_ARGS__)
#define ENUM(name, type, member, ...) \
	LISTED(name, 1, type, member, GL_INVALID_ENUM, __VA_ARGS__)

/*
 * Sets the object's parameter of that name, or GL's error; the groups change if
 * it had another value. given is the number of values: 1 from glFogx and its
 * like, 4 from glFogxv and its like.
 */
static void set_parameter(const struct parameter *table, size_t count,
	uint32_t groups, void *object, GLenum name, const GLfixed *values,
	size_t given)
{
	const struct parameter *p = table, *end = table + count;

	while (p != end && (name - p->name >= p->names || p->count > given)) {
		p++;
	}
	if (soft_check(p != end, GL_INVALID_ENUM) &&
		soft_check((values[0] >= p->least && values[0] <= p->most) ||
				soft_is_one_of((GLenum)values[0], p->allowed,
					p->allowed_count),
			p->error)) {
		/* all parameters are words: GLenum or GLfixed */
		GLfixed *member = (GLfixed *)(void *)((char *)object +
			p->offset + (name - p->name) * sizeof(*values));

		for (size_t i = 0; i < p->count; i++) {
			if (member[i] != values[i]) {
				soft_change(groups);
				member[i] = values[i];
			}
		}
	}
}

#define SET_PARAMETER(table, ...) \
	set_parameter(table, ARRAY_COUNT(table), __VA_ARGS__)

/* Defines two GL functions, for a scalar parameter and for a vector. */
#define TWO_CALLS(call, set)                                        \
	void soft_gl_##call##x(GLenum name, GLfixed value)          \
	{                                                           \
		set(name, &value, 1);                               \
	}                                                           \
	void soft_gl_##call##xv(GLenum name, const GLfixed *values) \
	{                                                           \
		set(name, values, 4);                               \
	}
#define TWO_CALLS_OF(call, set)                                           \
	void soft_gl_##call##x(GLenum object, GLenum name, GLfixed value) \
	{                                                                 \
		set(object, name, &value, 1);                             \
	}                                                                 \
	void soft_gl_##call##xv(                                          \
		GLenum object, GLenum name, const GLfixed *values)        \
	{                                                                 \
		set(object, name, values, 4);                             \
	}

static void set_fog(GLenum name, const GLfixed *values, size_t given)
{
	static const struct parameter of_fog[] = {
		ENUM(GL_FOG_MODE, struct fog, mode, GL_LINEAR, GL_EXP, GL_EXP2),
		RANGE(GL_FOG_DENSITY, 1, struct fog, density, INT32_MAX),
		ANY(GL_FOG_START, struct fog, start),
		ANY(GL_FOG_END, struct fog, end),
		ANY(GL_FOG_COLOR, struct fog, color),
	};

	SET_PARAMETER(of_fog, GROUP_FRAGMENTS, &soft_current()->fog, name,
		values, given);
}
TWO_CALLS(Fog, set_fog)

static void set_model(GLenum name, const GLfixed *values, size_t given)
{
	static const struct parameter of_model[] = {
		ANY(GL_LIGHT_MODEL_AMBIENT, struct lighting, ambient),
		ANY(GL_LIGHT_MODEL_TWO_SIDE, struct lighting, two_side),
	};

	SET_PARAMETER(of_model, GROUP_LIGHTING, &soft_current()->lighting, name,
		values, given);
}
TWO_CALLS(LightModel, set_model)

/* Transforms a light's position or direction to eye space when it is set. */
static void set_place(float *out, size_t count, const GLfixed *values)
{
	const struct matrix_stack *stack =
		&soft_change(GROUP_LIGHTING)->matrices.stack[STACK_MODELVIEW];
	float given[4] = {0.0f}, eye[4];

	for (size_t i = 0; i < count; i++) {
		given[i] = fx16_to_float(values[i]);
	}
	soft_matrix_transform(stack->top, given, eye);
	memcpy(out, eye, count * sizeof(*out));
}

/* Finds a directional light's unit vectors. */
static void set_directions(struct light *light)
{
	memcpy(light->towards, light->position, sizeof(light->towards));
	soft_matrix_normalize(light->towards);
	memcpy(light->half, light->towards, sizeof(light->half));
	light->half[2] += 1.0f; /* towards the viewer, infinitely far along z */
	soft_matrix_normalize(light->half);
}

static void set_light(
	GLenum name, GLenum what, const GLfixed *values, size_t given)
{
	static const struct parameter of_light[] = {
		ANY(GL_AMBIENT, struct light, ambient),
		ANY(GL_DIFFUSE, struct light, diffuse),
		ANY(GL_SPECULAR, struct light, specular),
		RANGE(GL_SPOT_EXPONENT, 1, struct light, exponent,
			128 * FX16_ONE),
		PARAMETER(GL_SPOT_CUTOFF, 1, struct light, cutoff,
			GL_INVALID_VALUE, 0, 90 * FX16_ONE, {180 * FX16_ONE}, 1),
		RANGE(GL_CONSTANT_ATTENUATION, 3, struct light, attenuation[0],
			INT32_MAX),
	};
	struct light *light;

	if (!soft_check(name - GL_LIGHT0 < SOFT_LIGHTS, GL_INVALID_ENUM)) {
		return;
	}
	light = &soft_current()->lighting.light[name - GL_LIGHT0];
	if (what == GL_POSITION && given == 4) {
		set_place(light->position, 4, values);
		set_directions(light);
	} else if (what == GL_SPOT_DIRECTION && given == 4) {
		set_place(light->direction, 3, values);
	} else {
		SET_PARAMETER(
			of_light, GROUP_LIGHTING, light, what, values, given);
	}
}
TWO_CALLS_OF(Light, set_light)

/* ES 1.1 allows no face but GL_FRONT_AND_BACK. */
static void set_material(
	GLenum face, GLenum name, const GLfixed *values, size_t given)
{
	static const struct parameter of_material[] = {
		ANY(GL_AMBIENT, struct material, ambient),
		ANY(GL_DIFFUSE, struct material, diffuse),
		ANY(GL_SPECULAR, struct material, specular),
		ANY(GL_EMISSION, struct material, emission),
		RANGE(GL_SHININESS, 1, struct material, shininess,
			128 * FX16_ONE),
	};
	struct material *material = &soft_current()->lighting.material;
	const bool both = name == GL_AMBIENT_AND_DIFFUSE;

	if (!soft_check(face == GL_FRONT_AND_BACK, GL_INVALID_ENUM)) {
		return;
	}
	SET_PARAMETER(of_material, GROUP_LIGHTING, material,
		both ? GL_AMBIENT : name, values, given);
	if (both) {
		SET_PARAMETER(of_material, GROUP_LIGHTING, material, GL_DIFFUSE,
			values, given);
	}
}
TWO_CALLS_OF(Material, set_material)

/* Texture environments; stages/combine_rows.c computes them. */
static void set_env(
	GLenum target, GLenum name, const GLfixed *values, size_t given)
{
#define COMBINERS                                                       \
	GL_REPLACE, GL_MODULATE, GL_ADD, GL_ADD_SIGNED, GL_INTERPOLATE, \
		GL_SUBTRACT
#define SOURCES(name, member)                                                  \
	LISTED(name, 3, struct texenv, member[0], GL_INVALID_ENUM, GL_TEXTURE, \
		GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS)
#define OPERANDS(name, member, ...)                                \
	LISTED(name, 3, struct texenv, member[0], GL_INVALID_ENUM, \
		__VA_ARGS__ GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA)
#define SCALE(name, member)                                         \
	NUMBER(name, struct texenv, member, FX16_ONE, 2 * FX16_ONE, \
		4 * FX16_ONE)
	static const struct parameter of_env[] = {
		ENUM(GL_TEXTURE_ENV_MODE, struct texenv, mode, GL_MODULATE,
			GL_DECAL, GL_BLEND, GL_ADD, GL_REPLACE, GL_COMBINE),
		ENUM(GL_COMBINE_RGB, struct texenv, combine_rgb, COMBINERS,
			GL_DOT3_RGB, GL_DOT3_RGBA),
		ENUM(GL_COMBINE_ALPHA, struct texenv, combine_alpha, COMBINERS),
		SOURCES(GL_SRC0_RGB, source_rgb),
		SOURCES(GL_SRC0_ALPHA, source_alpha),
		OPERANDS(GL_OPERAND0_RGB, operand_rgb, GL_SRC_COLOR,
			GL_ONE_MINUS_SRC_COLOR, ),
		OPERANDS(OPERAND0_ALPHA, operand_alpha, ),
		SCALE(GL_RGB_SCALE, scale_rgb),
		SCALE(ALPHA_SCALE, scale_alpha),
		ANY(GL_TEXTURE_ENV_COLOR, struct texenv, color),
	};
	struct textures *textures = &soft_current()->textures;

	if (soft_check(target == GL_TEXTURE_ENV, GL_INVALID_ENUM)) {
		SET_PARAMETER(of_env, GROUP_TEXTURES,
			&textures->unit[textures->active].env, name, values,
			given);
	}
}
TWO_CALLS_OF(TexEnv, set_env)

void soft_gl_TexParameterx(GLenum target, GLenum name, GLfixed value)
{
	static const struct parameter of_texture[] = {
		ENUM(GL_TEXTURE_MIN_FILTER, struct texture, min_filter,
			GL_NEAREST, GL_LINEAR, GL_NEAREST_MIPMAP_NEAREST,
			GL_LINEAR_MIPMAP_NEAREST, GL_NEAREST_MIPMAP_LINEAR,
			GL_LINEAR_MIPMAP_LINEAR),
		ENUM(GL_TEXTURE_MAG_FILTER, struct texture, mag_filter,
			GL_NEAREST, GL_LINEAR),
		ENUM(GL_TEXTURE_WRAP_S, struct texture, wrap_s, GL_REPEAT,
			GL_CLAMP_TO_EDGE),
		ENUM(GL_TEXTURE_WRAP_T, struct texture, wrap_t, GL_REPEAT,
			GL_CLAMP_TO_EDGE),
	};
	struct textures *textures = &soft_current()->textures;

	if (soft_check(target == GL_TEXTURE_2D, GL_INVALID_ENUM)) {
		SET_PARAMETER(of_texture, GROUP_TEXTURES,
			textures->unit[textures->active].bound, name, &value, 1);
	}
}

void soft_gl_PixelStorei(GLenum name, GLint value)
{
	static const struct parameter of_transfer[] = {
		NUMBER(GL_UNPACK_ALIGNMENT, struct textures, unpack_alignment,
			1, 2, 4, 8),
		NUMBER(GL_PACK_ALIGNMENT, struct textures, pack_alignment, 1, 2,
			4, 8),
	};

	SET_PARAMETER(
		of_transfer, 0, &soft_current()->textures, name, &value, 1);
}

void soft_gl_GetIntegerv(GLenum name, GLint *values)
{
	static const struct {
		GLenum name;
		size_t count;
		GLint value[2];
	} numbers[] = {
		{GL_MAX_TEXTURE_SIZE, 1, {SOFT_TEXTURE_SIZE_MAX}},
		{GL_MAX_TEXTURE_UNITS, 1, {SOFT_UNITS}},
		{GL_MAX_MODELVIEW_STACK_DEPTH, 1, {SOFT_STACK_DEPTH}},
		{GL_STENCIL_BITS, 1, {8}},
		{GL_SUBPIXEL_BITS, 1, {4}},
		{GL_DEPTH_BITS, 1, {16}},
		{GL_SMOOTH_POINT_SIZE_RANGE, 2, {1, SOFT_WIDTH_MAX}},
		{GL_SMOOTH_LINE_WIDTH_RANGE, 2, {1, SOFT_WIDTH_MAX}},
		{GL_ALIASED_POINT_SIZE_RANGE, 2, {1, SOFT_WIDTH_MAX}},
		{GL_ALIASED_LINE_WIDTH_RANGE, 2, {1, SOFT_WIDTH_MAX}},
	};
	size_t i = 0;

	while (i < ARRAY_COUNT(numbers) && numbers[i].name != name) {
		i++;
	}
	if (soft_check(i < ARRAY_COUNT(numbers), GL_INVALID_ENUM)) {
		memcpy(values, numbers[i].value,
			numbers[i].count * sizeof(*values));
	}
}

const GLubyte *soft_gl_GetString(GLenum name)
{
	static const char *const strings[] = {
		[GL_VENDOR - GL_VENDOR] = "limber",
		[GL_RENDERER - GL_VENDOR] = "soft",
		[GL_VERSION - GL_VENDOR] = "OpenGL ES-CL 1.1",
		[GL_EXTENSIONS - GL_VENDOR] = "",
	};

	return soft_check(
		       name - GL_VENDOR < ARRAY_COUNT(strings), GL_INVALID_ENUM)
		? (const GLubyte *)strings[name - GL_VENDOR]
		: NULL;
}
