/*
 * Points and lines as parallelograms, GL ES 1.1 sections 3.3, 3.4: of two
 * triangles, or of one that draws all of it, as draw->fourth has it.
 * raster/thin_line.c draws most points, and lines that are one pixel wide.
 */
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

/* A size in 1/16 pixels: 1 to 64 pixels, whole ones unless smooth. */
static int32_t find_size(GLfixed size, bool smooth)
{
	int32_t size_q4 = smooth
		? size >> 12
		: (int32_t)(((uint32_t)size + 0x8000) >> 16) * 16;

	return clamp_int(size_q4, 16, SOFT_WIDTH_MAX * 16);
}

struct offset {
	int32_t x, y; /* sixteenths */
};

static bool is_above(const struct vertex *a, const struct vertex *b)
{
	return a->y != b->y ? a->y < b->y : a->x < b->x;
}

/*
 * Draws a parallelogram of two triangles: corner 0 is a + off, corner 1 is b +
 * off + along; corners 2 and 3 are these two + across.
 */
static NEVER_INLINE void fill_between(struct draw *draw, const struct vertex *a,
	const struct vertex *b, struct offset off, struct offset along,
	struct offset across)
{
	struct vertex corner[4] = {*a, *b, *a, *b};
	int first = 0;

	for (int i = 0; i < 4; i++) {
		corner[i].x +=
			off.x + (i % 2 ? along.x : 0) + (i / 2 ? across.x : 0);
		corner[i].y +=
			off.y + (i % 2 ? along.y : 0) + (i / 2 ? across.y : 0);
	}
	/* span functions draw the parallelogram as one triangle: see fourth */
	if (draw->fill == soft_rows_fill) {
		for (int i = 1; i < 4; i++) {
			first = is_above(&corner[i], &corner[first]) ? i : first;
		}
		draw->fourth = &corner[3 - first];
	}
	soft_fill_triangle(draw,
		(struct vertex *[]){&corner[first], &corner[first ^ 1],
			&corner[first ^ 2]});
	if (!draw->fourth) {
		soft_fill_triangle(draw,
			(struct vertex *[]){&corner[2], &corner[1], &corner[3]});
	}
	draw->fourth = NULL;
}

void soft_draw_point(struct draw *draw, struct vertex *v)
{
	int32_t size = find_size(draw->soft->fragment.point_size, draw->smooth);
	int32_t half = (size - 16) / 2;
	struct offset off;

	if (v->outcode) {
		return;
	}
	soft_shade(draw, v);
	draw->provoking = v;
	/* GL's y points up: a centre on a border belongs to the pixel below. */
	off.x = ((v->x - half) & ~15) - v->x;
	off.y = ((v->y + half + 15) & ~15) - size - v->y;
	if (draw->lists) {
		const int x = (v->x + off.x) >> 4, y = (v->y + off.y) >> 4;

		soft_draw_sharp_point(draw, v,
			(struct clip_box){
				x, y, x + (size >> 4), y + (size >> 4)});
		return;
	}
	if (draw->smooth) {
		draw->spans.coverage = (struct soft_coverage){
			.used = true,
			.x = v->x,
			.y = v->y,
			.radius_q8 = size * 8,
		};
		off = (struct offset){-size / 2 - 16, -size / 2 - 16};
		size += 32;
	}
	fill_between(draw, v, v, off, (struct offset){size, 0},
		(struct offset){0, size});
}

/*
 * Draws a line as a parallelogram with vertical ends if it is flat, else with
 * horizontal ones: each column, or row, gets as many pixels as the line is wide.
 * It is moved by 1/16 so that ties are broken as in GL: to the left and down;
 * and so that the first pixel belongs to the line and the last one does not.
 */
static void draw_sharp(struct draw *draw, const struct vertex *a,
	const struct vertex *b, int32_t width)
{
	int32_t dx = b->x - a->x, dy = b->y - a->y, half = width / 2;
	bool flat = (dx < 0 ? -dx : dx) >= (dy < 0 ? -dy : dy);
	int32_t x = flat ? dx < 0 : -half, y = flat ? 1 - half : dy < 0;

	fill_between(draw, a, b, (struct offset){x, y}, (struct offset){0, 0},
		(struct offset){flat ? 0 : width, flat ? width : 0});
}

/* Draws a rectangle a pixel larger than the line; coverage fades its edges. */
static void draw_smooth(struct draw *draw, const struct vertex *a,
	const struct vertex *b, int32_t width)
{
	int32_t dx = b->x - a->x, dy = b->y - a->y;
	uint64_t length2 = (uint64_t)((int64_t)dx * dx + (int64_t)dy * dy);
	struct root root = soft_reciprocal_root(length2);
	int shift = root.shift + 16;
	/* unit vector along the line, 1.14 */
	int32_t u = (int32_t)((int64_t)dx * root.mantissa_q30 >> shift);
	int32_t v = (int32_t)((int64_t)dy * root.mantissa_q30 >> shift);
	int32_t out = width / 2 + 16, x = u * 16 >> 14, y = v * 16 >> 14;
	int32_t across_x = -v * out >> 14, across_y = u * out >> 14;

	draw->spans.coverage = (struct soft_coverage){
		.used = true,
		.x = (a->x + b->x) / 2,
		.y = (a->y + b->y) / 2,
		.u_q14 = u,
		.v_q14 = v,
		/* half of the length u dx + v dy */
		.half_length_q8 =
			(int32_t)(((int64_t)u * dx + (int64_t)v * dy) >> 11),
		.half_width_q8 = width * 8,
	};
	fill_between(draw, a, b, (struct offset){across_x - x, across_y - y},
		(struct offset){2 * x, 2 * y},
		(struct offset){-2 * across_x, -2 * across_y});
}

void soft_draw_line(
	struct draw *draw, const struct vertex *a, const struct vertex *b)
{
	int32_t width;

	if (a->x == b->x && a->y == b->y) {
		return;
	}
	if (draw->lists) {
		soft_draw_thin_line(draw, a, b);
		return;
	}
	width = find_size(draw->soft->fragment.line_width, draw->smooth);
	if (draw->smooth) {
		draw_smooth(draw, a, b, width);
	} else {
		draw_sharp(draw, a, b, width);
	}
}
