/* From positions to clip coordinates, and from there to the window. */
#include "platform/gl/soft/draw.h"
#include "platform/gl/soft/number.h"

#include <string.h>

static ALWAYS_INLINE int32_t transform_row(
	const int32_t m[4], int32_t x, int32_t y, int32_t z)
{
	return m[3] + mul_high(m[0], x) + mul_high(m[1], y) + mul_high(m[2], z);
}

static ALWAYS_INLINE int32_t transform_shorts(
	const int32_t m[4], int x, int y, int z)
{
	int32_t sum = MULTIPLY_ADD_HALF(m[3], m[0], x);

	sum = MULTIPLY_ADD_HALF(sum, m[1], y);
	return MULTIPLY_ADD_HALF(sum, m[2], z);
}

static ALWAYS_INLINE uint8_t find_outcode(const int32_t c[4])
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

/* |x| <= w: x / w in Q29, from x << (zeros - 1) that fits 32 bits. */
static ALWAYS_INLINE int32_t divide_q29(int32_t x, const struct vertex *vertex)
{
	return mul_high((int32_t)((uint32_t)x << (vertex->w_zeros - 1)),
		vertex->inverse_w_q30);
}

static ALWAYS_INLINE void project(const struct draw *draw, struct vertex *vertex)
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

void soft_project(const struct draw *draw, struct vertex *vertex)
{
	project(draw, vertex);
}

static ALWAYS_INLINE void find_clip(
	const struct draw *draw, uint32_t index, int32_t out[4])
{
	const void *at =
		draw->positions + (size_t)index * (size_t)draw->position_stride;
	const int32_t(*m)[4] = draw->clip_matrix;
	int32_t p[3];

	if (draw->position_kind == POSITION_SHORTS) {
		int16_t s[3];

		memcpy(s, at, sizeof(s));
		m = draw->short_matrix;
		out[0] = transform_shorts(m[0], s[0], s[1], s[2]);
		out[1] = transform_shorts(m[1], s[0], s[1], s[2]);
		out[2] = transform_shorts(m[2], s[0], s[1], s[2]);
		out[3] = transform_shorts(m[3], s[0], s[1], s[2]);
		return;
	}
	if (draw->position_kind == POSITION_FLOATS) {
		float f[3];

		memcpy(f, at, sizeof(f));
		p[0] = (int32_t)(f[0] * draw->position_scale);
		p[1] = (int32_t)(f[1] * draw->position_scale);
		p[2] = (int32_t)(f[2] * draw->position_scale);
	} else {
		array_position(draw, index, p);
	}
	out[0] = transform_row(m[0], p[0], p[1], p[2]);
	out[1] = transform_row(m[1], p[0], p[1], p[2]);
	out[2] = transform_row(m[2], p[0], p[1], p[2]);
	out[3] = transform_row(m[3], p[0], p[1], p[2]);
}

void soft_transform(const struct draw *draw, uint32_t index, struct vertex *out)
{
	find_clip(draw, index, out->clip);
	out->index = index;
	out->shaded = false;
	out->outcode = find_outcode(out->clip);
	if (out->outcode == 0) {
		project(draw, out);
	}
}
