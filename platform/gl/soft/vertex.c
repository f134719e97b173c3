/* From positions to clip coordinates, and from there to the window. */
#include "platform/gl/soft/draw.h"
#include "platform/gl/soft/number.h"

#include <string.h>

static ALWAYS_INLINE int32_t transform_row(
	const int32_t m[4], const int32_t p[3])
{
	return m[3] + mul_high(m[0], p[0]) + mul_high(m[1], p[1]) +
		mul_high(m[2], p[2]);
}

static uint8_t find_outcode(const int32_t c[4])
{
	int32_t x = c[0], y = c[1], z = c[2], w = c[3];
	unsigned out = 0;

	/* Sums stay below 2^31, see prepare_clip(): the signs tell. */
	if (((w - x) | (w + x) | (w - y) | (w + y) | (w - z) | (w + z) |
		    (w - 1)) >= 0) {
		return 0;
	}
	out |= x < -w ? OUT_LEFT : 0;
	out |= x > w ? OUT_RIGHT : 0;
	out |= y < -w ? OUT_BOTTOM : 0;
	out |= y > w ? OUT_TOP : 0;
	out |= z < -w || w <= 0 ? OUT_NEAR : 0;
	out |= z > w ? OUT_FAR : 0;
	return (uint8_t)out;
}

void soft_transform(const struct draw *draw, uint32_t index, struct vertex *out)
{
	const int32_t(*m)[4] = draw->clip_matrix;
	int32_t p[3];

	if (draw->float_positions) {
		float f[3];

		memcpy(f,
			draw->positions +
				(size_t)index * (size_t)draw->position_stride,
			sizeof(f));
		p[0] = (int32_t)(f[0] * draw->position_scale);
		p[1] = (int32_t)(f[1] * draw->position_scale);
		p[2] = (int32_t)(f[2] * draw->position_scale);
	} else {
		array_position(draw, index, p);
	}
	out->clip[0] = transform_row(m[0], p);
	out->clip[1] = transform_row(m[1], p);
	out->clip[2] = transform_row(m[2], p);
	out->clip[3] = transform_row(m[3], p);
	out->position[0] = p[0];
	out->position[1] = p[1];
	out->position[2] = p[2];
	out->index = index;
	out->shaded = false;
	out->outcode = find_outcode(out->clip);
	if (out->outcode == 0) {
		soft_project(draw, out);
	}
}

/* |x| <= w: x / w in Q29, from x << (zeros - 1) that fits 32 bits. */
static ALWAYS_INLINE int32_t divide_q29(int32_t x, const struct vertex *vertex)
{
	return mul_high((int32_t)((uint32_t)x << (vertex->w_zeros - 1)),
		vertex->inverse_w_q30);
}

void soft_project(const struct draw *draw, struct vertex *vertex)
{
	const int32_t *c = vertex->clip;

	if (draw->perspective) {
		int zeros = LEADING_ZEROS_32((uint32_t)c[3]);

		vertex->w_zeros = (uint8_t)zeros;
		vertex->inverse_w_q30 = reciprocal((uint32_t)c[3] << zeros);
	} else {
		vertex->w_zeros = draw->w_zeros;
		vertex->inverse_w_q30 = draw->inverse_w_q30;
	}
	vertex->x =
		(draw->center_x_q8 +
			mul_high(divide_q29(c[0], vertex), draw->width_q10)) >>
		4;
	vertex->y =
		(draw->center_y_q8 +
			mul_high(divide_q29(c[1], vertex), draw->height_q10)) >>
		4;
	/* 4 (1 + 65533 (z/w + 1) / 2) */
	vertex->z = 131070 + mul_high(divide_q29(c[2], vertex), 1048528);
}
