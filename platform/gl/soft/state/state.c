/*
 * The current context, its error and its stencil buffer; glEnable's flags; the
 * state of fragment operations; scissor box and viewport; setters of one value.
 */
#include <stdlib.h>
#include <string.h>

#include "platform/base/fixed.h"
#include "platform/gl/soft/state/state.h"
#include "platform/gl/soft/vertex/number.h"

/* The context that this thread's GL functions work on. */
static _Thread_local struct soft *current;

struct soft *soft_current(void)
{
	return current;
}

struct soft *soft_change(uint32_t groups)
{
	current->changed |= groups;
	return current;
}

void soft_make_current(struct soft *soft)
{
	current = soft;
	if (soft) {
		soft->changed = GROUP_ALL;
	}
}

bool soft_is_one_of(GLenum value, const GLenum *known, size_t count)
{
	for (size_t i = 0; i < count; i++) {
		if (known[i] == value) {
			return true;
		}
	}
	return false;
}

/* The stencil buffer has room for as many pixels as the depth buffer. */
uint8_t *soft_stencil(struct soft *soft)
{
	struct buffers *buffers = &soft->buffers;
	size_t room = buffers->room ? buffers->room : 1;

	if (!buffers->stencil) {
		buffers->stencil = malloc(room);
		soft->changed |= GROUP_FRAGMENTS;
		if (buffers->stencil) {
			memset(buffers->stencil, soft->fragment.stencil.clear,
				room);
		}
	}
	return buffers->stencil;
}

GLenum soft_gl_GetError(void)
{
	GLenum error = soft_current()->error;

	soft_current()->error = GL_NO_ERROR;
	return error;
}

void soft_gl_Finish(void)
{
}

#define FLAG(capability, member, groups)                          \
	{                                                         \
		capability, offsetof(struct soft, member), groups \
	}

/* The flags of all capabilities but lights and texture units, common ones first. */
static const struct {
	GLenum capability;
	size_t offset;
	uint32_t groups;
} flags[] = {
	FLAG(GL_BLEND, fragment.blend, GROUP_FRAGMENTS),
	FLAG(GL_LIGHTING, lighting.enabled, GROUP_LIGHTING | GROUP_FRAGMENTS),
	FLAG(GL_CULL_FACE, fragment.cull, GROUP_FRAGMENTS),
	FLAG(GL_DEPTH_TEST, fragment.depth_test, GROUP_FRAGMENTS),
	FLAG(GL_STENCIL_TEST, fragment.stencil.enabled, GROUP_FRAGMENTS),
	FLAG(GL_ALPHA_TEST, fragment.alpha_test, GROUP_FRAGMENTS),
	FLAG(GL_SCISSOR_TEST, fragment.scissor_test, GROUP_VIEWPORT),
	FLAG(GL_POLYGON_OFFSET_FILL, fragment.offset_fill, GROUP_FRAGMENTS),
	FLAG(GL_COLOR_MATERIAL, lighting.color_material, GROUP_LIGHTING),
	FLAG(GL_NORMALIZE, lighting.normalize, GROUP_LIGHTING),
	FLAG(GL_RESCALE_NORMAL, lighting.rescale, GROUP_LIGHTING),
	FLAG(GL_FOG, fog.enabled, GROUP_FRAGMENTS),
	FLAG(GL_POINT_SMOOTH, fragment.point_smooth, GROUP_FRAGMENTS),
	FLAG(GL_LINE_SMOOTH, fragment.line_smooth, GROUP_FRAGMENTS),
	FLAG(GL_DITHER, fragment.dither, 0),
};

static void set_flag(GLenum capability, bool on)
{
	struct soft *soft = soft_current();
	struct textures *textures = &soft->textures;
	uint32_t groups = GROUP_LIGHTING;
	bool *flag = NULL;

	if (capability == GL_TEXTURE_2D) {
		flag = &textures->unit[textures->active].enabled;
		groups = GROUP_TEXTURES;
	} else if (capability - GL_LIGHT0 < SOFT_LIGHTS) {
		flag = &soft->lighting.light[capability - GL_LIGHT0].enabled;
	}
	for (size_t i = 0; i < ARRAY_COUNT(flags) && !flag; i++) {
		if (flags[i].capability == capability) {
			flag = (bool *)((char *)soft + flags[i].offset);
			groups = flags[i].groups;
		}
	}
	if (soft_check(flag != NULL, GL_INVALID_ENUM) && *flag != on) {
		soft_change(groups);
		*flag = on;
	}
}

void soft_gl_Enable(GLenum capability)
{
	set_flag(capability, true);
	if (capability == GL_STENCIL_TEST) {
		soft_check(
			soft_stencil(soft_current()) != NULL, GL_OUT_OF_MEMORY);
	}
}

void soft_gl_Disable(GLenum capability)
{
	set_flag(capability, false);
}

static bool is_comparison(GLenum function)
{
	return function >= GL_NEVER && function <= GL_ALWAYS;
}

static bool is_unit(GLenum name)
{
	return name - GL_TEXTURE0 < SOFT_UNITS;
}

/*
 * A GL function that sets a member of struct soft, of those groups, to another
 * value if may_be is true.
 */
#define CALL(name, type, may_be, error, groups, member, set) \
	void soft_gl_##name(type value)                      \
	{                                                    \
		if (soft_check(may_be, error) &&             \
			soft_current()->member != (set)) {   \
			soft_change(groups)->member = (set); \
		}                                            \
	}
#define ENUM_CALL(name, may_be, groups, member, set) \
	CALL(name, GLenum, may_be, GL_INVALID_ENUM, groups, member, set)
#define ANY_CALL(name, type, groups, member, set) \
	CALL(name, type, true, GL_NO_ERROR, groups, member, set)

ENUM_CALL(DepthFunc, is_comparison(value), GROUP_FRAGMENTS,
	fragment.depth_function, value)
ENUM_CALL(CullFace, IS_ONE_OF(value, GL_FRONT, GL_BACK, GL_FRONT_AND_BACK),
	GROUP_FRAGMENTS, fragment.cull_face, value)
ENUM_CALL(FrontFace, IS_ONE_OF(value, GL_CW, GL_CCW), GROUP_FRAGMENTS,
	fragment.front_face, value)
ENUM_CALL(ShadeModel, IS_ONE_OF(value, GL_FLAT, GL_SMOOTH), GROUP_FRAGMENTS,
	fragment.flat, value == GL_FLAT)
ENUM_CALL(MatrixMode, IS_ONE_OF(value, GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE),
	0, matrices.mode, value)
ENUM_CALL(ActiveTexture, is_unit(value), 0, textures.active,
	(int)(value - GL_TEXTURE0))
ENUM_CALL(ClientActiveTexture, is_unit(value), 0, arrays.client_unit,
	(int)(value - GL_TEXTURE0))
CALL(LineWidthx, GLfixed, value > 0, GL_INVALID_VALUE, GROUP_FRAGMENTS,
	fragment.line_width, value)
CALL(PointSizex, GLfixed, value > 0, GL_INVALID_VALUE, GROUP_FRAGMENTS,
	fragment.point_size, value)
ANY_CALL(DepthMask, GLboolean, GROUP_FRAGMENTS, fragment.depth_mask, value)
ANY_CALL(ClearDepthx, GLfixed, 0, fragment.clear_depth,
	clamp_int(value, 0, FX16_ONE))
ANY_CALL(ClearStencil, GLint, 0, fragment.stencil.clear, (uint8_t)value)
ANY_CALL(StencilMask, GLuint, GROUP_FRAGMENTS, fragment.stencil.write_mask,
	(uint8_t)value)

void soft_gl_AlphaFuncx(GLenum function, GLfixed reference)
{
	if (soft_check(is_comparison(function), GL_INVALID_ENUM)) {
		soft_change(GROUP_FRAGMENTS)->fragment.alpha_function = function;
		soft_current()->fragment.alpha_reference =
			clamp_int(reference, 0, FX16_ONE);
	}
}

/* Whether a blend factor is GL_ZERO, GL_ONE, or one of first to last. */
static bool is_factor(GLenum factor, GLenum first, GLenum last)
{
	return factor <= GL_ONE || (factor >= first && factor <= last);
}

void soft_gl_BlendFunc(GLenum source, GLenum destination)
{
	if (soft_check(is_factor(source, GL_SRC_ALPHA, GL_SRC_ALPHA_SATURATE) &&
			    is_factor(destination, GL_SRC_COLOR,
				    GL_ONE_MINUS_DST_ALPHA),
		    GL_INVALID_ENUM)) {
		soft_change(GROUP_FRAGMENTS)->fragment.blend_source = source;
		soft_current()->fragment.blend_destination = destination;
	}
}

void soft_gl_ColorMask(
	GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha)
{
	struct soft *soft = soft_change(GROUP_FRAGMENTS);
	const bool r = red, g = green, b = blue, a = alpha;

	memcpy(soft->fragment.color_mask, (GLboolean[]){r, g, b, a}, 4);
	soft->fragment.color_bits = soft->format == PIXELS_RGB565
		? r * 0xF800F800u + g * 0x07E007E0u + b * 0x001F001Fu
		: r * 0xFFu + g * 0xFF00u + b * 0xFF0000u + a * 0xFF000000u;
}

void soft_gl_PolygonOffsetx(GLfixed factor, GLfixed units)
{
	soft_change(GROUP_FRAGMENTS)->fragment.offset_factor = factor;
	soft_current()->fragment.offset_units = units;
}

static void set_rectangle(struct rectangle *rectangle, int x, int y,
	GLsizei width, GLsizei height)
{
	if (soft_check(width >= 0 && height >= 0, GL_INVALID_VALUE)) {
		*rectangle = (struct rectangle){x, y, width, height};
	}
}

void soft_gl_Scissor(GLint x, GLint y, GLsizei width, GLsizei height)
{
	set_rectangle(&soft_change(GROUP_VIEWPORT)->fragment.scissor, x, y,
		width, height);
}

/* Limits the viewport to +-PIXELS_SIZE_MAX, as GL allows. */
void soft_gl_Viewport(GLint x, GLint y, GLsizei width, GLsizei height)
{
	const int most = PIXELS_SIZE_MAX;

	set_rectangle(&soft_change(GROUP_VIEWPORT)->fragment.viewport,
		clamp_int(x, -most, most), clamp_int(y, -most, most),
		clamp_int(width, -most, most), clamp_int(height, -most, most));
}

void soft_gl_StencilFunc(GLenum function, GLint reference, GLuint mask)
{
	struct stencil *stencil =
		&soft_change(GROUP_FRAGMENTS)->fragment.stencil;

	if (soft_check(is_comparison(function), GL_INVALID_ENUM)) {
		stencil->function = function;
		stencil->reference = (uint8_t)clamp_int(reference, 0, 255);
		stencil->mask = (uint8_t)mask;
	}
}

static bool is_stencil_action(GLenum action)
{
	return IS_ONE_OF(action, GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR,
		GL_INVERT);
}

void soft_gl_StencilOp(GLenum fail, GLenum depth_fail, GLenum pass)
{
	struct stencil *stencil =
		&soft_change(GROUP_FRAGMENTS)->fragment.stencil;

	if (soft_check(is_stencil_action(fail) && is_stencil_action(depth_fail) &&
			    is_stencil_action(pass),
		    GL_INVALID_ENUM)) {
		stencil->fail = fail;
		stencil->depth_fail = depth_fail;
		stencil->pass = pass;
	}
}

/* The box's part in a GL rectangle, whose corners may need 64 bits. */
static struct clip_box cut(
	struct clip_box box, const struct rectangle *r, int height)
{
	const int64_t right = (int64_t)r->x + r->width;
	const int64_t bottom = (int64_t)height - r->y;

	box.left = clamp_int(r->x, box.left, box.right);
	box.right = clamp_int(saturate_64(right), box.left, box.right);
	box.top =
		clamp_int(saturate_64(bottom - r->height), box.top, box.bottom);
	box.bottom = clamp_int(saturate_64(bottom), box.top, box.bottom);
	return box;
}

struct clip_box soft_clip_box(const struct soft *soft, bool viewport_too)
{
	const struct pixels *target = &soft->buffers.target;
	struct clip_box box = {0, 0, target->width, target->height};

	if (soft->fragment.scissor_test) {
		box = cut(box, &soft->fragment.scissor, target->height);
	}
	if (viewport_too) {
		box = cut(box, &soft->fragment.viewport, target->height);
	}
	return box;
}
