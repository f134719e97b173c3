/* Capabilities, the fragment's state and where it may go. */
#include "platform/gl/soft/soft.h"

#include "platform/base/compiler.h"
#include "platform/base/fixed.h"

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

	if (!flag) {
		soft_set_error(soft, GL_INVALID_ENUM);
		return;
	}
	*flag = on;
}

static void enable(GLenum capability)
{
	set_flag(capability, true);
	if (capability == GL_STENCIL_TEST && !soft_stencil(soft_current())) {
		soft_set_error(soft_current(), GL_OUT_OF_MEMORY);
	}
}

static void disable(GLenum capability)
{
	set_flag(capability, false);
}

static void set_enum(GLenum *where, GLenum value, bool known)
{
	if (!known) {
		soft_set_error(soft_current(), GL_INVALID_ENUM);
		return;
	}
	*where = value;
}

static void alpha_func(GLenum function, GLfixed reference)
{
	struct soft *soft = soft_current();

	if (!is_comparison(function)) {
		soft_set_error(soft, GL_INVALID_ENUM);
		return;
	}
	soft->fragment.alpha_function = function;
	soft->fragment.alpha_reference = reference < 0 ? 0
		: reference > FX16_ONE                 ? FX16_ONE
						       : reference;
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
	struct soft *soft = soft_current();

	if (!is_source_factor(source) || !is_destination_factor(destination)) {
		soft_set_error(soft, GL_INVALID_ENUM);
		return;
	}
	soft->fragment.blend_source = source;
	soft->fragment.blend_destination = destination;
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
		face == GL_FRONT || face == GL_BACK ||
			face == GL_FRONT_AND_BACK);
}

static void front_face(GLenum mode)
{
	set_enum(&soft_current()->fragment.front_face, mode,
		mode == GL_CW || mode == GL_CCW);
}

static void shade_model(GLenum mode)
{
	struct soft *soft = soft_current();

	if (mode != GL_FLAT && mode != GL_SMOOTH) {
		soft_set_error(soft, GL_INVALID_ENUM);
		return;
	}
	soft->fragment.flat = mode == GL_FLAT;
}

static void set_size(GLfixed *where, GLfixed size)
{
	if (size <= 0) {
		soft_set_error(soft_current(), GL_INVALID_VALUE);
		return;
	}
	*where = size;
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
	struct soft *soft = soft_current();

	soft->fragment.offset_factor = factor;
	soft->fragment.offset_units = units;
}

static int max_int(int a, int b)
{
	return a > b ? a : b;
}

static int min_int(int a, int b)
{
	return a < b ? a : b;
}

static void set_rectangle(struct rectangle *rectangle, int x, int y,
	GLsizei width, GLsizei height)
{
	if (width < 0 || height < 0) {
		soft_set_error(soft_current(), GL_INVALID_VALUE);
		return;
	}
	*rectangle = (struct rectangle){x, y, width, height};
}

static void scissor(GLint x, GLint y, GLsizei width, GLsizei height)
{
	set_rectangle(&soft_current()->fragment.scissor, x, y, width, height);
}

static int limit_place(int place)
{
	return max_int(-PIXELS_SIZE_MAX, min_int(place, PIXELS_SIZE_MAX));
}

/* Larger ones are cut to PIXELS_SIZE_MAX, as GL allows. */
static void viewport(GLint x, GLint y, GLsizei width, GLsizei height)
{
	set_rectangle(&soft_current()->fragment.viewport, limit_place(x),
		limit_place(y), min_int(width, PIXELS_SIZE_MAX),
		min_int(height, PIXELS_SIZE_MAX));
}

static void stencil_func(GLenum function, GLint reference, GLuint mask)
{
	struct soft *soft = soft_current();
	struct stencil *stencil = &soft->fragment.stencil;

	if (!is_comparison(function)) {
		soft_set_error(soft, GL_INVALID_ENUM);
		return;
	}
	stencil->function = function;
	stencil->reference = (uint8_t)(reference < 0 ? 0
			: reference > 255            ? 255
						     : reference);
	stencil->mask = (uint8_t)mask;
}

static void stencil_mask(GLuint mask)
{
	soft_current()->fragment.stencil.write_mask = (uint8_t)mask;
}

static bool is_stencil_action(GLenum action)
{
	return action == GL_KEEP || action == GL_ZERO || action == GL_REPLACE ||
		action == GL_INCR || action == GL_DECR || action == GL_INVERT;
}

static void stencil_op(GLenum fail, GLenum depth_fail, GLenum pass)
{
	struct soft *soft = soft_current();
	struct stencil *stencil = &soft->fragment.stencil;

	if (!is_stencil_action(fail) || !is_stencil_action(depth_fail) ||
		!is_stencil_action(pass)) {
		soft_set_error(soft, GL_INVALID_ENUM);
		return;
	}
	stencil->fail = fail;
	stencil->depth_fail = depth_fail;
	stencil->pass = pass;
}

static void finish(void)
{
}

/* Sums of 64 bits: a scissor box may lie anywhere. */
static struct clip_box cut(
	struct clip_box box, const struct rectangle *r, int height)
{
	int64_t right = (int64_t)r->x + r->width;
	int64_t top = (int64_t)height - r->y - r->height;
	int64_t bottom = (int64_t)height - r->y;

	box.left = max_int(box.left, r->x);
	box.right = right < box.right ? (int)max_int((int)right, 0) : box.right;
	box.top = top > box.top ? (int)(top < height ? top : height) : box.top;
	box.bottom = bottom < box.bottom ? (int)(bottom > 0 ? bottom : 0)
					 : box.bottom;
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
	box.left = min_int(box.left, target->width);
	box.right = max_int(box.right, box.left);
	box.bottom = max_int(box.bottom, box.top);
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
