/* Vertices' attributes without lighting: colours, fog, texture coordinates. */
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

#include <string.h>

void soft_shade_find_eye(
	const struct draw *draw, uint32_t index, int first, int32_t out[3])
{
	int32_t p[3];

	soft_array_position(draw, index, p);
	for (int i = first; i < 3; i++) {
		const int32_t *row = draw->eye[i];
		int32_t sum = mul_high_add(row[3], row[0], p[0]);

		sum = mul_high_add(sum, row[1], p[1]);
		out[i] = mul_high_add(sum, row[2], p[2]);
	}
}

int32_t soft_shade_to_q16(int32_t value, int q)
{
	const int32_t most =
		q < 16 ? INT32_MAX >> clamp_int(16 - q, 0, 31) : INT32_MAX;

	return value > most ? INT32_MAX : shift_by(value, 16 - q);
}

static int32_t fog_share_q16(const struct draw *draw, int32_t distance_q16)
{
	const struct fog *fog = &draw->soft->fog;
	int64_t thickness_q16 = (int64_t)fog->density * distance_q16 >> 16;

	if (fog->mode == GL_LINEAR) {
		/* |difference| < 2^32, |scale| <= 2^29 */
		return saturate_64(
			((int64_t)fog->end - distance_q16) * draw->fog_scale >>
			draw->fog_scale_q);
	}
	if (fog->mode == GL_EXP2) {
		thickness_q16 = saturate_64(thickness_q16);
		thickness_q16 = thickness_q16 * thickness_q16 >> 16;
	}
	/* 1/e in Q28 */
	return soft_power_q28(98749918, saturate_64(thickness_q16)) >> 12;
}

/* The fog factor, how much of a fragment's own colour stays, as an attribute. */
static NEVER_INLINE int32_t find_fog(
	const struct draw *draw, const struct vertex *vertex)
{
	int32_t eye[3];

	soft_shade_find_eye(draw, vertex->index, 2, eye);
	return to_attribute(fog_share_q16(draw,
		soft_shade_to_q16(eye[2] < 0 ? -eye[2] : eye[2], draw->eye_q)));
}

static NEVER_INLINE void find_any_texcoord(
	const struct draw *draw, int unit, uint32_t index, int32_t out[2])
{
	const struct texture_input *input = &draw->texture[unit];
	int32_t st[2];

	soft_array_texcoord_q16(draw, unit, index, st);
	for (int i = 0; i < 2; i++) {
		const int32_t *m = input->matrix[i];
		int64_t sum = (int64_t)m[0] * st[0] + (int64_t)m[1] * st[1] +
			(int64_t)m[2] * 65536;

		out[i] = input->identity ? st[i]
					 : saturate_64(sum >> input->matrix_q);
		/* so that differences fit 32 bits */
		out[i] = clamp_int(out[i], -(1 << 30), 1 << 30);
	}
}

static ALWAYS_INLINE void find_texcoord(
	const struct draw *draw, int unit, struct vertex *vertex)
{
	const struct texture_input *input = &draw->texture[unit];
	const uint8_t *at = input->array->pointer +
		(size_t)vertex->index * (size_t)input->array->stride_bytes;
	int32_t *out = vertex->attribute + TEX_S + 2 * unit;
	uint32_t bits[2];
	float st[2];

	if (input->plain_floats) {
		PRELOAD(at + 40);
		memcpy(bits, at, sizeof(bits));
		/* |s|, |t| < 2^14: compares their bits without the sign */
		if (bits[0] << 1 < 0x8D000000 && bits[1] << 1 < 0x8D000000) {
			memcpy(st, bits, sizeof(st));
			out[0] = (int32_t)(st[0] * 65536.0f);
			out[1] = (int32_t)(st[1] * 65536.0f);
			return;
		}
	}
	find_any_texcoord(draw, unit, vertex->index, out);
}

/* Bytes become what to_attribute() gives for them, or one less. */
void soft_shade_color(const struct draw *draw, struct vertex *vertex)
{
	const struct array *array = &draw->soft->arrays.color;
	const uint8_t *at = array->pointer +
		(size_t)vertex->index * (size_t)array->stride_bytes;
	bool bytes = array->enabled && array->type == GL_UNSIGNED_BYTE;
	int32_t color[4];

	if (!bytes) {
		soft_array_color_q16(draw, vertex->index, color);
	}
	for (int i = 0; i < 4; i++) {
		vertex->attribute[i] =
			bytes ? at[i] << 8 | 128 : to_attribute(color[i]);
	}
}

void soft_shade_rest(const struct draw *draw, struct vertex *vertex)
{
	if (draw->fogged) {
		vertex->attribute[FOG] = find_fog(draw, vertex);
	}
	if (draw->texture[0].used) {
		find_texcoord(draw, 0, vertex);
	}
	if (draw->texture[1].used) {
		find_texcoord(draw, 1, vertex);
	}
}
