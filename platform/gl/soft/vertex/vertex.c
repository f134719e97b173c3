/* Transforms positions to clip coordinates and to window coordinates. */
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

static ALWAYS_INLINE int32_t transform_row(
	int32_t moved, const int32_t m[3], const int32_t p[3])
{
	int32_t sum = mul_high_add(moved, m[0], p[0]);

	sum = mul_high_add(sum, m[1], p[1]);
	return mul_high_add(sum, m[2], p[2]);
}

static ALWAYS_INLINE uint8_t find_outcode(const int32_t c[4])
{
	int32_t x = c[0], y = c[1], z = c[2], w = c[3];
	unsigned out = 0;

	out |= x < -w ? OUT_LEFT : 0;
	out |= x > w ? OUT_RIGHT : 0;
	out |= y < -w ? OUT_BOTTOM : 0;
	out |= y > w ? OUT_TOP : 0;
	out |= z < -w || w <= 0 ? OUT_NEAR : 0;
	out |= z > w ? OUT_FAR : 0;
	return (uint8_t)out;
}

/* x / w in Q29, where |x| <= w, so that x << (w_zeros - 1) fits 32 bits. */
static ALWAYS_INLINE int32_t divide_q29(int32_t x, const struct vertex *vertex)
{
	return mul_high((int32_t)((uint32_t)x << (vertex->w_zeros - 1)),
		vertex->inverse_w_q30);
}

void soft_project(const struct draw *draw, struct vertex *vertex)
{
	const struct view *view = &draw->view;
	const int32_t *c = vertex->clip;
	int zeros = LEADING_ZEROS_32((uint32_t)c[3]);

	vertex->w_zeros = (uint8_t)zeros;
	vertex->inverse_w_q30 = reciprocal((uint32_t)c[3] << zeros);
	vertex->x = mul_high_add(view->center_x_q8, divide_q29(c[0], vertex),
			    view->width_q10) >>
		4;
	vertex->y = mul_high_add(view->center_y_q8, divide_q29(c[1], vertex),
			    view->height_q10) >>
		4;
	vertex->z = mul_high_add(
		view->center_z, divide_q29(c[2], vertex), view->depth);
}

static ALWAYS_INLINE void find_clip(
	const struct draw *draw, uint32_t index, int32_t out[4])
{
	const struct view *view = &draw->view;
	int32_t p[3];

	soft_array_position(draw, index, p);
	for (int i = 0; i < 3 && view->kind == POSITION_SHORTS; i++) {
		p[i] *= 4; /* the matrix is scaled for that */
	}
	out[0] = transform_row(view->moved_x, view->row_x, p);
	out[1] = transform_row(view->moved_y, view->row_y, p);
	out[2] = transform_row(view->moved_z, view->row_z, p);
	out[3] = transform_row(view->moved_w, view->row_w, p);
}

void soft_transform_c(
	const struct draw *draw, uint32_t index, struct vertex *out)
{
	find_clip(draw, index, out->clip);
	out->index = index;
	out->shaded = false;
	out->outcode = find_outcode(out->clip);
	if (out->outcode == 0) {
		soft_project(draw, out);
	}
}
