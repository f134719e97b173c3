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

static struct vertex *move(
	struct vertex *out, const struct vertex *from, int32_t x, int32_t y)
{
	*out = *from;
	out->x = x;
	out->y = y;
	return out;
}

static void fill_square(struct draw *draw, const struct vertex *v, int32_t left,
	int32_t top, int size)
{
	struct vertex corner[4];

	move(&corner[0], v, left, top);
	move(&corner[1], v, left + size, top);
	move(&corner[2], v, left, top + size);
	move(&corner[3], v, left + size, top + size);
	soft_fill_quad(draw, corner);
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
	if (draw->thin_line) {
		soft_draw_thin_point(draw, v);
		return;
	}
	if (draw->smooth) {
		draw->spans.coverage = (struct soft_coverage){
			.used = true,
			.x = v->x,
			.y = v->y,
			.radius_q8 = size * 8,
		};
		fill_square(draw, v, v->x - size / 2 - 16, v->y - size / 2 - 16,
			size + 32);
		return;
	}
	/* GL's y runs upwards: a centre on a border is that of the pixel below. */
	fill_square(draw, v, (v->x - half) & ~15,
		((v->y + half + 15) & ~15) - size, size);
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
	struct vertex corner[4];

	move(&corner[0], a, a->x + x, a->y + y);
	move(&corner[1], b, b->x + x, b->y + y);
	x += flat ? 0 : width;
	y += flat ? width : 0;
	move(&corner[2], a, a->x + x, a->y + y);
	move(&corner[3], b, b->x + x, b->y + y);
	soft_fill_quad(draw, corner);
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
	struct vertex corner[4];

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
	move(&corner[0], a, a->x - x + across_x, a->y - y + across_y);
	move(&corner[1], b, b->x + x + across_x, b->y + y + across_y);
	move(&corner[2], a, a->x - x - across_x, a->y - y - across_y);
	move(&corner[3], b, b->x + x - across_x, b->y + y - across_y);
	soft_fill_quad(draw, corner);
}

void soft_draw_line(
	struct draw *draw, const struct vertex *a, const struct vertex *b)
{
	int32_t width = find_size(draw->soft->fragment.line_width, draw->smooth);

	if (a->x == b->x && a->y == b->y) {
		return;
	}
	if (draw->thin_line) {
		soft_draw_thin_line(draw, a, b);
	} else if (draw->smooth) {
		draw_smooth(draw, a, b, width);
	} else {
		draw_sharp(draw, a, b, width);
	}
}
