/*
 * Points and lines: rectangles of two triangles, GL ES 1.1 sections 3.3, 3.4.
 * raster/thin_line.c draws most of one pixel.
 */
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

/* In sixteenths, 1 to 64 pixels; whole ones unless the edges are smooth. */
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

/*
 * Two triangles between two vertices: the first corner lies off the first one,
 * the second one's further along, and the other side across from there.
 */
static NEVER_INLINE void fill_between(struct draw *draw, const struct vertex *a,
	const struct vertex *b, struct offset off, struct offset along,
	struct offset across)
{
	struct vertex corner[4] = {*a, *b, *a, *b};

	for (int i = 0; i < 4; i++) {
		corner[i].x +=
			off.x + (i % 2 ? along.x : 0) + (i / 2 ? across.x : 0);
		corner[i].y +=
			off.y + (i % 2 ? along.y : 0) + (i / 2 ? across.y : 0);
	}
	soft_fill_triangle(
		draw, (struct vertex *[]){&corner[0], &corner[1], &corner[2]});
	soft_fill_triangle(
		draw, (struct vertex *[]){&corner[2], &corner[1], &corner[3]});
}

static void fill_square(struct draw *draw, const struct vertex *v,
	struct offset off, int32_t size)
{
	fill_between(draw, v, v, off, (struct offset){size, 0},
		(struct offset){0, size});
}

void soft_draw_point(struct draw *draw, struct vertex *v)
{
	int32_t size = find_size(draw->soft->fragment.point_size, draw->smooth);
	int32_t half = (size - 16) / 2;

	if (v->outcode) {
		return;
	}
	soft_shade(draw, v);
	draw->provoking = v;
	if (draw->smooth) {
		draw->spans.coverage = (struct soft_coverage){
			.used = true,
			.x = v->x,
			.y = v->y,
			.radius_q8 = size * 8,
		};
		fill_square(draw, v,
			(struct offset){-size / 2 - 16, -size / 2 - 16},
			size + 32);
		return;
	}
	/* GL's y runs upwards: a centre on a border is that of the pixel below. */
	fill_square(draw, v,
		(struct offset){((v->x - half) & ~15) - v->x,
			((v->y + half + 15) & ~15) - size - v->y},
		size);
}

/*
 * A parallelogram whose ends are upright or level, whichever is more across:
 * each column of pixels, or each row, has as many as the line is wide. Points
 * on borders of pixels are moved as GL's are: to the left and down, and so that
 * the first pixel belongs to the line and the last does not.
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

/* A rectangle that reaches a pixel further than what coverage leaves of it. */
static void draw_smooth(struct draw *draw, const struct vertex *a,
	const struct vertex *b, int32_t width)
{
	int32_t dx = b->x - a->x, dy = b->y - a->y;
	uint64_t length2 = (uint64_t)((int64_t)dx * dx + (int64_t)dy * dy);
	struct root root = soft_reciprocal_root(length2);
	int shift = root.shift + 16;
	/* along the line, 1.14 */
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
		/* half of the length, u dx + v dy */
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
	if (draw->thin_lines) {
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
