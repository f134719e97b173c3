/*
 * Perspective division at single pixels of a row, and linear steps between
 * them. Only walk.c, thin_line.c and begin.c include this header.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_POINTS_H
#define PLATFORM_GL_SOFT_SPAN_POINTS_H

#include "platform/gl/soft/span/colors.h"
#include "platform/gl/soft/span/texels.h"

/* What is interpolated; texture coordinates are always divided by 1 / w. */
struct walk_kind {
	bool textured, colored, colors_divided;
};

struct row_point {
	struct point divisor; /* only q and its reciprocal are set */
	struct texels texels;
	struct colors colors;
};

/* An attribute's value at column x: its plane's value divided by 1 / w's. */
static ALWAYS_INLINE int32_t divide(
	const struct line *line, const struct point *divisor, int plane, int x)
{
	const struct raster *raster = &line->draw->raster;
	int32_t value = rows_divide(divisor, find_value(line, plane, x),
		plane >= TEX_S ? raster->tex_shift[plane - TEX_S] + 8 : 24);

	return plane >= TEX_S ? value : limit_color(value);
}

/* At column x; texels are those of a texture unit. */
static ALWAYS_INLINE struct row_point find_point(
	const struct line *line, const struct walk_kind kind, int unit, int x)
{
	const struct soft_spans *spans = &line->draw->spans;
	struct row_point out;
	const struct point *by = &out.divisor;

	rows_find_divisor(find_value(line, INVERSE_W, x), &out.divisor);
	if (kind.textured) {
		out.texels.s = divide(line, by, TEX_S + 2 * unit, x);
		out.texels.t = divide(line, by, TEX_S + 2 * unit + 1, x);
	}
	if (kind.colors_divided) {
		out.colors.red = divide(line, by, RED, x);
		out.colors.green = divide(line, by, GREEN, x);
		out.colors.blue = divide(line, by, BLUE, x);
		if (spans->alpha_moves) {
			out.colors.alpha = divide(line, by, ALPHA, x);
		}
		if (spans->fog_moves) {
			out.colors.fog = divide(line, by, FOG, x);
		}
	}
	return out;
}

static ALWAYS_INLINE uint32_t distance(int32_t a, int32_t b)
{
	return a < b ? (uint32_t)b - (uint32_t)a : (uint32_t)a - (uint32_t)b;
}

static ALWAYS_INLINE uint32_t larger(uint32_t a, uint32_t b)
{
	return a > b ? a : b;
}

/* The largest change of a colour, scaled to weigh as much as one of texels. */
static ALWAYS_INLINE uint32_t find_change(const struct draw *draw,
	const struct colors *from, const struct colors *to)
{
	const struct soft_spans *spans = &draw->spans;
	uint32_t most = larger(distance(from->red, to->red),
		larger(distance(from->green, to->green),
			distance(from->blue, to->blue)));

	if (spans->alpha_moves) {
		most = larger(most, distance(from->alpha, to->alpha));
	}
	if (spans->fog_moves) {
		most = larger(most, distance(from->fog, to->fog));
	}
	return most >> rows_color_tolerance(draw);
}

/*
 * How many pixels apart a row's exact divisions may be; most is the change of
 * other coordinates. Linear values are off by |dv dq| / 4 q at most, and in
 * halves of the row by a quarter of that.
 */
static ALWAYS_INLINE int find_spacing(const struct draw *draw,
	const struct walk_kind kind, const struct row_point *from,
	const struct row_point *to, int steps, uint32_t most)
{
	uint32_t q =
		(uint32_t)(from->divisor.q < to->divisor.q ? from->divisor.q
							   : to->divisor.q);
	uint64_t error, allowed = (uint64_t)q << 16;

	if (kind.textured) {
		most = larger(most,
			larger(distance(from->texels.s, to->texels.s),
				distance(from->texels.t, to->texels.t)));
	}
	if (kind.colors_divided) {
		most = larger(
			most, find_change(draw, &from->colors, &to->colors));
	}
	error = (uint64_t)most * distance(from->divisor.q, to->divisor.q);
	if (error <= allowed && steps <= SMALL_EXTENT) {
		return steps + 1;
	}
	return rows_find_spacing(error, allowed, steps);
}

/* Steps a pixel between two points. */
struct change {
	struct texels texels;
	struct colors colors;
};

static ALWAYS_INLINE struct change set_steps(const struct line *line,
	const struct walk_kind kind, const struct row_point *from,
	const struct row_point *to, int steps)
{
	struct soft_spans *spans = &line->draw->spans;
	int32_t inverse = line->draw->inverse_q31[steps];
	struct change out;

	if (kind.textured) {
		out.texels.s =
			rows_find_step(from->texels.s, to->texels.s, inverse);
		out.texels.t =
			rows_find_step(from->texels.t, to->texels.t, inverse);
		if (!spans->made) {
			soft_set_texel_steps(&spans->levels[0].view, out.texels,
				&spans->run);
		}
	}
	if (kind.colors_divided) {
		out.colors = find_color_steps(
			spans, &from->colors, &to->colors, inverse);
		set_color_steps(spans, &out.colors);
	}
	return out;
}

#endif
