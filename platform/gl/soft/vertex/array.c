/* Elements of vertex arrays as fixed point. */
#include <string.h>

#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/state/matrix.h"
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

static const float two_16 = 65536.0f, two_28 = 268435456.0f;

/* An element of an array, or the current value if the array is disabled. */
struct element {
	const uint8_t *at;
	GLenum type;
};

static const uint8_t *element_at(const struct array *array, uint32_t index)
{
	return array->pointer + (size_t)index * (size_t)array->stride_bytes;
}

static struct element find_element(
	const struct array *array, uint32_t index, const GLfixed *current)
{
	if (!array->enabled) {
		return (struct element){(const uint8_t *)current, GL_FIXED};
	}
	return (struct element){element_at(array, index), array->type};
}

/* value * scale as an integer; limited to 32 bits, and 0 for NaN. */
static ALWAYS_INLINE int32_t scale_float(float value, float scale)
{
	value *= scale;
	if (value > -2147483520.0f && value < 2147483520.0f) {
		return (int32_t)value;
	}
	return value > 0.0f ? INT32_MAX : value < 0.0f ? -INT32_MAX : 0;
}

/*
 * Loads values: floats times scale, the others as 16.16, of which unsigned
 * bytes are 0 to 1.
 */
static void load_values(
	const struct element *from, int count, float scale, int32_t *out)
{
	const uint8_t *at = from->at;
	float value;

	switch (from->type) {
	case GL_FLOAT:
		for (int i = 0; i < count; i++) {
			memcpy(&value, at + 4 * i, sizeof(value));
			out[i] = scale_float(value, scale);
		}
		break;
	case GL_BYTE:
		for (int i = 0; i < count; i++) {
			out[i] = (int8_t)at[i] * 65536;
		}
		break;
	case GL_UNSIGNED_BYTE:
		for (int i = 0; i < count; i++) {
			out[i] = at[i] * 257 + (at[i] >> 7);
		}
		break;
	case GL_SHORT:
		for (int i = 0; i < count; i++) {
			out[i] = (int16_t)load_16(at + 2 * i) * 65536;
		}
		break;
	default:
		memcpy(out, at, (size_t)count * sizeof(*out));
	}
}

/* The largest magnitude of count elements of GL_FIXED, or a bit more. */
static uint32_t find_largest_fixed(
	const struct array *array, uint32_t first, uint32_t count)
{
	uint32_t most = 0;

	for (uint32_t i = 0; i < count; i++) {
		const uint8_t *at = element_at(array, first + i);

		for (int j = 0; j < array->size && j < 3; j++) {
			int32_t value = (int32_t)load_32(at + 4 * j);

			most |= (uint32_t)(value ^ value >> 31);
		}
	}
	return most;
}

int soft_array_position_exponent(
	const struct array *array, uint32_t first, uint32_t count)
{
	const uint8_t *at = element_at(array, first);
	int stride_bytes = array->stride_bytes;
	bool aligned = ((uintptr_t)at | (uintptr_t)stride_bytes) % 4 == 0;
	uint32_t most;

	if (array->type == GL_FIXED) {
		most = find_largest_fixed(array, first, count);
		return 15 - LEADING_ZEROS_32(most | 1);
	}
	if (array->type != GL_FLOAT) {
		return array->type == GL_BYTE ? 7 : 15;
	}
	most = aligned && array->size >= 3
		? soft_largest_aligned_float(at, stride_bytes, count)
		: soft_largest_float(at, stride_bytes, count,
			  array->size < 3 ? array->size : 3);
	return (int)(most >> 24) - 127;
}

void soft_array_position(const struct draw *draw, uint32_t index, int32_t out[3])
{
	const struct array *array = &draw->soft->arrays.vertex;
	const struct element from = {element_at(array, index), array->type};

	if (draw->view.kind == POSITION_FLOATS) {
		const float *f = (const float *)(const void *)from.at;

		for (int i = 0; i < 3; i++) {
			out[i] = (int32_t)(f[i] * draw->view.scale);
		}
		return;
	}
	out[2] = 0;
	load_values(&from, array->size < 3 ? array->size : 3, draw->view.scale,
		out);
	for (int i = 0; i < 3; i++) {
		/* Floats may be larger; the others, as 16.16, are not. */
		out[i] = from.type == GL_FLOAT
			? clamp_int(out[i], -(1 << 30), 1 << 30)
			: shift_by(out[i], draw->position_q - 16);
	}
}

/* What makes the largest of three floats 2^27 to 2^28; 0 if it is infinite. */
static float find_scale(const struct element *from)
{
	const int exponent = (int)(soft_largest_float(from->at, 0, 1, 3) >> 24);

	return exponent == 255
		? 0.0f
		: soft_matrix_power_of_two(clamp_int(154 - exponent, -126, 127));
}

void soft_array_normal_q28(
	const struct draw *draw, uint32_t index, int32_t out[3])
{
	const struct arrays *arrays = &draw->soft->arrays;
	const struct element from =
		find_element(&arrays->normal, index, arrays->current_normal);
	const bool any_length = draw->shading.normalize;
	const float scale =
		from.type == GL_FLOAT && any_length ? find_scale(&from) : two_28;
	uint32_t sizes = 1;
	int zeros;

	load_values(&from, 3, scale, out);
	for (int i = 0; i < 3; i++) {
		sizes |= (uint32_t)(out[i] ^ out[i] >> 31);
	}
	/* 16.16 becomes 2^27 to 2^28, or Q28, limited to below 8 */
	zeros = any_length ? LEADING_ZEROS_32(sizes) - 4 : 12;
	for (int i = 0; i < 3 && from.type != GL_FLOAT; i++) {
		/* integers c mean (2 c + 1) / (2^bits - 1) */
		out[i] = from.type == GL_BYTE
			? (2 * (out[i] >> 16) + 1) * 1052688
			: from.type == GL_SHORT ? (out[i] >> 3) + 4096
			: any_length            ? shift_by(out[i], zeros)
				     : saturate_64((int64_t)out[i] * 4096);
	}
}

void soft_array_color_q16(
	const struct draw *draw, uint32_t index, int32_t out[4])
{
	const struct arrays *arrays = &draw->soft->arrays;
	const struct element from =
		find_element(&arrays->color, index, arrays->current_color);

	load_values(&from, 4, two_16, out);
}

void soft_array_texcoord_q16(
	const struct draw *draw, int unit, uint32_t index, int32_t out[2])
{
	static const GLfixed nothing[2] = {0, 0};
	const struct element from =
		find_element(draw->texture[unit].array, index, nothing);

	load_values(&from, 2, two_16, out);
}
