/*
 * Perspective without a division: in a small triangle a value v whose v / w is
 * linear is close to a polynomial of degree two. The polynomial taken here is
 * exact at the corners and in the middle of the edges, so that triangles with a
 * common edge agree there. With barycentric coordinates l0, l1, l2 it is
 *
 *	l0 v0 + l1 v1 + l2 v2 + l0 l1 f01 + l0 l2 f02 + l1 l2 f12
 *
 * where fab = 2 (va - vb) (wb - wa) / (wa + wb).
 */
#include "platform/gl/soft/raster/frame.h"
#include "platform/gl/soft/raster/rows.h"

/* Coefficients of x^2, x y and y^2 in l1^2, l2^2 and l1 l2, Q26. */
struct products {
	int32_t xx[3], xy[3], yy[3]; /* [l1^2, l2^2, l1 l2] */
};

/* (wb - wa) / (wa + wb), Q16: at most 1/3, as w differs by a factor of 2. */
static int32_t find_ratio(const struct vertex *a, const struct vertex *b)
{
	uint32_t sum = (uint32_t)a->clip[3] + (uint32_t)b->clip[3];
	int32_t difference = b->clip[3] - a->clip[3];
	int zeros = LEADING_ZEROS_32(sum | 1);

	return mul_high(difference * (1 << zeros), reciprocal(sum << zeros)) >>
		14;
}

/*
 * Whether the polynomial's error, at most texel ratio^2 / 5 for a coordinate
 * that changes by texel, in 1/256 texels, is below a quarter of a texel: 64.
 */
static bool is_exact(const int32_t ratio[3], uint32_t texel)
{
	uint32_t a = raster_size(ratio[0]);
	uint32_t b = raster_size(ratio[1]);
	uint32_t c = raster_size(ratio[2]), most = a > b ? a : b;

	most = c > most ? c : most;
	most = most * most >> 16;
	return (uint64_t)texel * most <= 5u << 22;
}

/* The product of two steps; factors and result are Q26. */
static int32_t multiply(int32_t a, int32_t b)
{
	return mul_high(a * 8, b * 8);
}

/* False if the triangle is so thin that a step of l1 or l2 is 4 or more. */
static bool find_products(const struct frame *frame, struct products *out)
{
	const int32_t corner[4] = {
		frame->y2, frame->less_y1, frame->less_x2, frame->x1};
	int32_t step[4]; /* of l1 and l2 to the right, then down; Q26 */

	for (int i = 0; i < 4; i++) {
		/* 2^30 / area times a corner in 1/16: Q26 a pixel */
		int32_t high = mul_high(corner[i] * (1 << 18), frame->inverse);

		if (raster_size(high) >> (28 - frame->shift) != 0) {
			return false;
		}
		step[i] = high * (1 << frame->shift);
	}
	out->xx[0] = multiply(step[0], step[0]);
	out->xx[1] = multiply(step[1], step[1]);
	out->xx[2] = multiply(step[0], step[1]);
	out->yy[0] = multiply(step[2], step[2]);
	out->yy[1] = multiply(step[3], step[3]);
	out->yy[2] = multiply(step[2], step[3]);
	out->xy[0] = 2 * multiply(step[0], step[2]);
	out->xy[1] = 2 * multiply(step[1], step[3]);
	out->xy[2] = multiply(step[0], step[3]) + multiply(step[1], step[2]);
	return true;
}

/* A coefficient of degree two, from the products' for l1^2, l2^2, l1 l2. */
static int32_t add_up(
	const int32_t product[3], int32_t f01, int32_t f02, int32_t g)
{
	int64_t sum = (int64_t)product[2] * g - (int64_t)product[0] * f01 -
		(int64_t)product[1] * f02 + (1 << 25);

	return (int32_t)(sum >> 26);
}

/* Moves the origin from v[0] to the centre of column 0 in the first row. */
static void move_bend(
	const struct frame *frame, struct plane *plane, const struct bend *bend)
{
	/* These wrap around in thin triangles, as planes do. */
	uint32_t x = (uint32_t)frame->off_x, y = (uint32_t)frame->off_y;
	uint32_t xx = (uint32_t)bend->xx, xy = (uint32_t)bend->xy;
	uint32_t yy = (uint32_t)bend->yy, column = (uint32_t)frame->column;
	uint32_t right = (uint32_t)((int32_t)(2 * xx * x + xy * y) >> 4);
	uint32_t down = (uint32_t)((int32_t)(2 * yy * y + xy * x) >> 4);

	plane->start += (uint32_t)((int32_t)(right * x + down * y) >> 5) -
		right * column + xx * column * column;
	plane->dx = (int32_t)((uint32_t)plane->dx + right - 2 * xx * column);
	plane->dy = (int32_t)((uint32_t)plane->dy + down - xy * column);
}

static void bend_plane(struct raster *raster, const struct products *products,
	const int32_t ratio[3], const struct delta *delta, int name)
{
	struct plane *plane = &raster->plane[name];
	struct bend *bend = &raster->bend[name];
	int32_t d1 = delta->d1, d2 = delta->d2;
	int32_t f01 = (-d1 * ratio[0]) >> 7, f02 = (-d2 * ratio[1]) >> 7;
	int32_t f12 = ((d1 - d2) * ratio[2]) >> 7;
	int32_t g = f12 - f01 - f02;
	const struct delta bent = {
		delta->first, d1 + ((f01 + 128) >> 8), d2 + ((f02 + 128) >> 8)};

	*bend = (struct bend){add_up(products->xx, f01, f02, g),
		add_up(products->xy, f01, f02, g),
		add_up(products->yy, f01, f02, g)};
	*plane = frame_find_plane(&raster->frame, &bent);
	plane->start += TEXEL_NUDGE;
	move_bend(&raster->frame, plane, bend);
}

/* A chord across n pixels is off the polynomial by xx n^2 / 4 at most. */
static bool is_straight(
	const struct raster *raster, int name, int columns, int pixels)
{
	uint32_t n = (uint32_t)(columns < pixels ? columns : pixels);

	/* half a texel */
	return (uint64_t)raster_size(raster->bend[name].xx) * n * n <= 4 << 15;
}

bool soft_bend(struct draw *draw, const struct setup *setup,
	const struct delta delta[], uint32_t texel)
{
	struct raster *raster = &draw->raster;
	const struct vertex *const *v = setup->v;
	const int32_t ratio[3] = {find_ratio(v[0], v[1]),
		find_ratio(v[0], v[2]), find_ratio(v[1], v[2])};
	struct products products;

	if (!is_exact(ratio, texel) ||
		!find_products(&raster->frame, &products)) {
		return false;
	}
	raster->bent = true;
	raster->middle_column = (v[0]->x + v[1]->x + v[2]->x) / 48;
	raster->middle_row = (v[0]->y + v[1]->y + v[2]->y) / 48 - setup->top;
	raster->bent_pixels = SOFT_RUN_PIXELS;
	for (int i = 0; i < raster->moving_count; i++) {
		int name = raster->moving[i];

		if (name < TEX_S) {
			continue;
		}
		bend_plane(raster, &products, ratio, &delta[name], name);
		while (raster->bent_pixels > PERSPECTIVE_STEP &&
			!is_straight(raster, name, setup->columns,
				raster->bent_pixels)) {
			raster->bent_pixels /= 2;
		}
	}
	return true;
}
