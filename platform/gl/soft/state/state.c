/* Capabilities, the fragment's state and where it may go. */
#include "platform/base/fixed.h"
#include "platform/gl/soft/state/parameter.h"
#include "platform/gl/soft/vertex/number.h"

static bool is_comparison(GLenum function)
{
	return function >= GL_NEVER && function <= GL_ALWAYS;
}

#define FLAG(capability, member)                          \
	{                                                 \
		capability, offsetof(struct soft, member) \
	}

/* The flags behind capabilities that are no light or texture unit. */
static const struct {
	GLenum capability;
	size_t offset;
} flags[] = {
	FLAG(GL_FOG, fog.enabled),
	FLAG(GL_CULL_FACE, fragment.cull),
	FLAG(GL_ALPHA_TEST, fragment.alpha_test),
	FLAG(GL_BLEND, fragment.blend),
	FLAG(GL_STENCIL_TEST, fragment.stencil.enabled),
	FLAG(GL_DEPTH_TEST, fragment.depth_test),
	FLAG(GL_SCISSOR_TEST, fragment.scissor_test),
	FLAG(GL_POLYGON_OFFSET_FILL, fragment.offset_fill),
	FLAG(GL_POINT_SMOOTH, fragment.point_smooth),
	FLAG(GL_LINE_SMOOTH, fragment.line_smooth),
	FLAG(GL_DITHER, fragment.dither),
	FLAG(GL_LIGHTING, lighting.enabled),
	FLAG(GL_COLOR_MATERIAL, lighting.color_material),
	FLAG(GL_NORMALIZE, lighting.normalize),
	FLAG(GL_RESCALE_NORMAL, lighting.rescale),
};

static bool *find_flag(struct soft *soft, GLenum capability)
{
	if (capability == GL_TEXTURE_2D) {
		return &soft->textures.unit[soft->textures.active].enabled;
	}
	if (capability - GL_LIGHT0 < SOFT_LIGHTS) {
		return &soft->lighting.light[capability - GL_LIGHT0].enabled;
	}
	for (size_t i = 0; i < ARRAY_COUNT(flags); i++) {
		if (flags[i].capability == capability) {
			return (bool *)((char *)soft + flags[i].offset);
		}
	}
	return NULL;
}

static void set_flag(GLenum capability, bool on)
{
	struct soft *soft = soft_current();
	bool *flag = find_flag(soft, capability);

	if (soft_check(flag != NULL, GL_INVALID_ENUM)) {
		*flag = on;
	}
}

static void enable(GLenum capability)
{
	set_flag(capability, true);
	if (capability == GL_STENCIL_TEST) {
		soft_check(
			soft_stencil(soft_current()) != NULL, GL_OUT_OF_MEMORY);
	}
}

static void disable(GLenum capability)
{
	set_flag(capability, false);
}

static void set_enum(GLenum *where, GLenum value, bool known)
{
	if (soft_check(known, GL_INVALID_ENUM)) {
		*where = value;
	}
}

static void alpha_func(GLenum function, GLfixed reference)
{
	struct fragment_state *state = &soft_current()->fragment;

	if (soft_check(is_comparison(function), GL_INVALID_ENUM)) {
		state->alpha_function = function;
		state->alpha_reference = clamp_int(reference, 0, FX16_ONE);
	}
}

static bool is_source_factor(GLenum factor)
{
	return factor <= GL_ONE || (factor >= GL_SRC_ALPHA && factor <= 0x0308);
}

static bool is_destination_factor(GLenum factor)
{
	return factor <= GL_ONE ||
		(factor >= GL_SRC_COLOR && factor <= GL_ONE_MINUS_DST_ALPHA);
}

static void blend_func(GLenum source, GLenum destination)
{
	struct fragment_state *state = &soft_current()->fragment;

	if (soft_check(is_source_factor(source) &&
			    is_destination_factor(destination),
		    GL_INVALID_ENUM)) {
		state->blend_source = source;
		state->blend_destination = destination;
	}
}

static void color_mask(
	GLboolean red, GLboolean green, GLboolean blue, GLboolean alpha)
{
	GLboolean *mask = soft_current()->fragment.color_mask;

	mask[0] = red != GL_FALSE;
	mask[1] = green != GL_FALSE;
	mask[2] = blue != GL_FALSE;
	mask[3] = alpha != GL_FALSE;
}

static void depth_func(GLenum function)
{
	set_enum(&soft_current()->fragment.depth_function, function,
		is_comparison(function));
}

static void depth_mask(GLboolean write)
{
	soft_current()->fragment.depth_mask = write != GL_FALSE;
}

static void cull_face(GLenum face)
{
	set_enum(&soft_current()->fragment.cull_face, face,
		IS_ONE_OF(face, GL_FRONT, GL_BACK, GL_FRONT_AND_BACK));
}

static void front_face(GLenum mode)
{
	set_enum(&soft_current()->fragment.front_face, mode,
		IS_ONE_OF(mode, GL_CW, GL_CCW));
}

static void shade_model(GLenum mode)
{
	if (soft_check(IS_ONE_OF(mode, GL_FLAT, GL_SMOOTH), GL_INVALID_ENUM)) {
		soft_current()->fragment.flat = mode == GL_FLAT;
	}
}

static void set_size(GLfixed *where, GLfixed size)
{
	if (soft_check(size > 0, GL_INVALID_VALUE)) {
		*where = size;
	}
}

static void line_width(GLfixed width)
{
	set_size(&soft_current()->fragment.line_width, width);
}

static void point_size(GLfixed size)
{
	set_size(&soft_current()->fragment.point_size, size);
}

static void polygon_offset(GLfixed factor, GLfixed units)
{
	struct fragment_state *state = &soft_current()->fragment;

	state->offset_factor = factor;
	state->offset_units = units;
}

static void set_rectangle(struct rectangle *rectangle, int x, int y,
	GLsizei width, GLsizei height)
{
	if (soft_check(width >= 0 && height >= 0, GL_INVALID_VALUE)) {
		*rectangle = (struct rectangle){x, y, width, height};
	}
}

static void scissor(GLint x, GLint y, GLsizei width, GLsizei height)
{
	set_rectangle(&soft_current()->fragment.scissor, x, y, width, height);
}

/* Larger ones are cut to PIXELS_SIZE_MAX, as GL allows. */
static void viewport(GLint x, GLint y, GLsizei width, GLsizei height)
{
	const int most = PIXELS_SIZE_MAX;

	set_rectangle(&soft_current()->fragment.viewport,
		clamp_int(x, -most, most), clamp_int(y, -most, most),
		clamp_int(width, -most, most), clamp_int(height, -most, most));
}

static void stencil_func(GLenum function, GLint reference, GLuint mask)
{
	struct stencil *stencil = &soft_current()->fragment.stencil;

	if (soft_check(is_comparison(function), GL_INVALID_ENUM)) {
		stencil->function = function;
		stencil->reference = (uint8_t)clamp_int(reference, 0, 255);
		stencil->mask = (uint8_t)mask;
	}
}

static void stencil_mask(GLuint mask)
{
	soft_current()->fragment.stencil.write_mask = (uint8_t)mask;
}

static bool is_stencil_action(GLenum action)
{
	return IS_ONE_OF(action, GL_KEEP, GL_ZERO, GL_REPLACE, GL_INCR, GL_DECR,
		GL_INVERT);
}

static void stencil_op(GLenum fail, GLenum depth_fail, GLenum pass)
{
	struct stencil *stencil = &soft_current()->fragment.stencil;

	if (soft_check(is_stencil_action(fail) && is_stencil_action(depth_fail) &&
			    is_stencil_action(pass),
		    GL_INVALID_ENUM)) {
		stencil->fail = fail;
		stencil->depth_fail = depth_fail;
		stencil->pass = pass;
	}
}

static void finish(void)
{
}

/* A box inside of a rectangle, which may lie anywhere: sums have 64 bits. */
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

static void set_defaults(struct fragment_state *fragment)
{
	*fragment = (struct fragment_state){
		.dither = true,
		.alpha_function = GL_ALWAYS,
		.depth_function = GL_LESS,
		.blend_source = GL_ONE,
		.blend_destination = GL_ZERO,
		.color_mask = {1, 1, 1, 1},
		.depth_mask = 1,
		.cull_face = GL_BACK,
		.front_face = GL_CCW,
		.line_width = FX16_ONE,
		.point_size = FX16_ONE,
		.clear_depth = FX16_ONE,
		.stencil =
			{
				.function = GL_ALWAYS,
				.fail = GL_KEEP,
				.depth_fail = GL_KEEP,
				.pass = GL_KEEP,
				.mask = 255,
				.write_mask = 255,
			},
	};
}

void soft_init_state(struct soft *soft)
{
	struct gl *gl = &soft->base.gl;

	set_defaults(&soft->fragment);
	gl->Enable = enable;
	gl->Disable = disable;
	gl->AlphaFuncx = alpha_func;
	gl->BlendFunc = blend_func;
	gl->ColorMask = color_mask;
	gl->DepthFunc = depth_func;
	gl->DepthMask = depth_mask;
	gl->CullFace = cull_face;
	gl->FrontFace = front_face;
	gl->ShadeModel = shade_model;
	gl->LineWidthx = line_width;
	gl->PointSizex = point_size;
	gl->PolygonOffsetx = polygon_offset;
	gl->Scissor = scissor;
	gl->Viewport = viewport;
	gl->StencilFunc = stencil_func;
	gl->StencilMask = stencil_mask;
	gl->StencilOp = stencil_op;
	gl->Finish = finish;
}
