/* The paths of triangles, and the choice of one for a draw call. */
#include "platform/gl/soft/raster/raster.h"

/* RGB565, all of it written, up to one texture; opaque, or blended by alpha. */
static bool is_simple(const struct draw *draw)
{
	const struct soft_spans *spans = &draw->spans;

	return draw->soft->format == PIXELS_RGB565 &&
		spans->color_mask == UINT32_MAX && !draw->texture[1].used &&
		!spans->blended_last &&
		(spans->finish == SOFT_OPAQUE || spans->finish == SOFT_BLENDED);
}

/* Tested LESS, and written; planes do not differ by triangle. */
static bool is_solid(const struct draw *draw)
{
	return draw->spans.direct && !draw->spans.equal_passes &&
		!draw->blended && !draw->offset && !draw->shading.two_side;
}

static bool is_modulated(const struct draw *draw, enum texel_format format)
{
	const struct texture_input *input = &draw->texture[0];

	return input->used && input->mode == GL_MODULATE &&
		input->base->format == format;
}

static bool has_filters(const struct draw *draw, GLenum mag, GLenum min)
{
	const struct texture *texture = draw->texture[0].texture;

	return texture->mag_filter == mag && texture->min_filter == min;
}

/* Where the stencil is EQUAL; then it gets another value, or stays. */
static bool passes_stencil_once(const struct draw *draw)
{
	const struct stencil *stencil = &draw->soft->fragment.stencil;
	const GLenum pass = stencil->pass;

	return stencil->enabled && draw->soft->buffers.stencil &&
		stencil->function == GL_EQUAL && stencil->mask == 255 &&
		stencil->write_mask == 255 && stencil->fail == GL_KEEP &&
		stencil->reference < 255 &&
		(pass == GL_INCR || pass == GL_KEEP || pass == GL_ZERO);
}

static bool takes_flat(const struct draw *draw)
{
	return is_simple(draw) && !draw->shading.lit &&
		!draw->shading.color_array && !draw->texture[0].used &&
		!draw->soft->fragment.depth_test && passes_stencil_once(draw);
}

static bool takes_rectangles(const struct draw *draw)
{
	return is_simple(draw) && draw->blended &&
		is_modulated(draw, TEXEL_A8) &&
		has_filters(draw, GL_NEAREST, GL_NEAREST) &&
		!draw->shading.lit && !draw->perspective &&
		!draw->soft->fragment.depth_test && !draw->spans.stenciled;
}

static bool takes_narrow(const struct draw *draw)
{
	return is_simple(draw) && is_solid(draw) && !draw->texture[0].used;
}

/* Those whose texels are mixed may have a colour added. */
static bool takes_textured(const struct draw *draw)
{
	if (!is_solid(draw) || !is_modulated(draw, TEXEL_565)) {
		return false;
	}
	if (has_filters(draw, GL_NEAREST, GL_NEAREST)) {
		return is_simple(draw);
	}
	return draw->soft->format == PIXELS_RGB565 && !draw->texture[1].used &&
		draw->spans.finish ==
		(draw->added ? SOFT_OPAQUE_FOG : SOFT_OPAQUE) &&
		(has_filters(draw, GL_LINEAR, GL_LINEAR) ||
			has_filters(draw, GL_LINEAR, GL_LINEAR_MIPMAP_NEAREST));
}

static bool takes_luminance(const struct draw *draw)
{
	const struct fragment_state *state = &draw->soft->fragment;
	const struct texture_input *input = &draw->texture[0];

	return is_simple(draw) && is_modulated(draw, TEXEL_L8) &&
		input->base->tiles && input->texture->wrap_s == GL_REPEAT &&
		input->texture->wrap_t == GL_REPEAT &&
		has_filters(draw, GL_LINEAR, GL_LINEAR_MIPMAP_NEAREST) &&
		!draw->spans.stenciled &&
		(!state->depth_test || state->depth_function == GL_ALWAYS);
}

/* Which way triangles of a draw call go: one of fast/, or the template's. */
static const struct path {
	bool (*takes)(const struct draw *draw); /* NULL: all calls */
	fill_function fill;
	void (*begin)(struct draw *draw); /* once a draw call, or NULL */
	bool one_color; /* no vertex is shaded: all of a call has one colour */
	bool divides;   /* of struct draw */
	bool rectangles;
} path[] = {
	{.takes = takes_flat,
		.fill = soft_fill_flat,
		.begin = soft_fill_flat_begin,
		.one_color = true},
	{.takes = takes_rectangles, .fill = soft_rows_fill, .rectangles = true},
	{.takes = takes_narrow, .fill = soft_fill_narrow},
	{.takes = takes_textured,
		.fill = soft_fill_textured,
		.begin = soft_fill_textured_begin},
	{.takes = takes_luminance, .fill = soft_fill_luminance, .divides = true},
	{.fill = soft_rows_fill},
};

void soft_choose_path(struct draw *draw)
{
	const struct path *chosen = path;

	if (draw->soft->fill || draw->smooth || draw->thin_lines) {
		chosen = &path[ARRAY_COUNT(path) - 1];
	}
	while (chosen->takes && !chosen->takes(draw)) {
		chosen++;
	}
	draw->fill = draw->soft->fill ? draw->soft->fill : chosen->fill;
	draw->divides = chosen->divides;
	draw->rectangles = chosen->rectangles;
	if (chosen->one_color) {
		draw->attributes = 0;
	}
	if (chosen->begin) {
		chosen->begin(draw);
	}
}
