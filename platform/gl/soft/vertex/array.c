/* Elements of vertex arrays as fixed point. */
#include <string.h>

#include "platform/base/scalar.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

static const float two_16 = 65536.0f, two_30 = 1073741824.0f;

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

static float load_float(const struct element *from, int i)
{
	float value;

	memcpy(&value, from->at + 4 * i, sizeof(value));
	return value;
}

/* value * scale as an integer; limited to 32 bits, and 0 for NaN. */
static int32_t scale_float(float value, float scale)
{
	value *= scale;
	if (value >= 2147483520.0f) {
		return INT32_MAX;
	}
	if (value <= -2147483520.0f) {
		return -INT32_MAX;
	}
	return value == value ? (int32_t)value : 0;
}

/*
 * The i-th value: floats times scale, the others as 16.16, of which unsigned
 * bytes are 0 to 1.
 */
static int32_t load_value(const struct element *from, int i, float scale)
{
	int16_t value;

	switch (from->type) {
	case GL_FLOAT:
		return scale_float(load_float(from, i), scale);
	case GL_BYTE:
		return (int8_t)from->at[i] * 65536;
	case GL_UNSIGNED_BYTE:
		return from->at[i] * 257 + (from->at[i] >> 7);
	case GL_SHORT:
		memcpy(&value, from->at + 2 * i, sizeof(value));
		return value * 65536;
	default:
		return (int32_t)load_32(from->at + 4 * i);
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
	for (int i = 0; i < 3 && i < array->size; i++) {
		int32_t value = load_value(&from, i, draw->view.scale);

		/* Floats may be larger; the others, as 16.16, are not. */
		out[i] = from.type == GL_FLOAT
			? clamp_int(value, -(1 << 30), 1 << 30)
			: shift_by(value, draw->position_q - 16);
	}
}

/* Scales a direction of any length: its largest component becomes 1/4, Q30. */
static void load_any_length(const struct element *from, int32_t out[3])
{
	float n[3], most = 0.0f;

	for (int i = 0; i < 3; i++) {
		n[i] = from->type == GL_FLOAT ? load_float(from, i)
					      : (float)load_value(from, i, 1.0f);
		most = scalar_abs(n[i]) > most ? scalar_abs(n[i]) : most;
	}
	for (int i = 0; i < 3; i++) {
		/* Infinite components give NaN, which becomes 0. */
		out[i] = scale_float(n[i] / most, two_30 / 4.0f);
	}
}

void soft_array_normal_q30(
	const struct draw *draw, uint32_t index, int32_t out[3])
{
	const struct arrays *arrays = &draw->soft->arrays;
	const struct element from =
		find_element(&arrays->normal, index, arrays->current_normal);
	bool words = from.type == GL_FLOAT || from.type == GL_FIXED;

	/* Q30 has no room for components of 2 or more. */
	if (draw->shading.normalize && words) {
		load_any_length(&from, out);
		return;
	}
	for (int i = 0; i < 3; i++) {
		int32_t value = load_value(&from, i, two_30);

		/* integers c mean (2 c + 1) / (2^bits - 1) */
		out[i] = from.type == GL_FLOAT ? value
			: from.type == GL_BYTE
			? (2 * (value >> 16) + 1) * 4210752
			: from.type == GL_SHORT
			? (value >> 1) + 16384
			: saturate_64((int64_t)value * 16384);
	}
}

void soft_array_color_q16(
	const struct draw *draw, uint32_t index, int32_t out[4])
{
	const struct arrays *arrays = &draw->soft->arrays;
	const struct element from =
		find_element(&arrays->color, index, arrays->current_color);

	for (int i = 0; i < 4; i++) {
		out[i] = load_value(&from, i, two_16);
	}
}

void soft_array_texcoord_q16(
	const struct draw *draw, int unit, uint32_t index, int32_t out[2])
{
	static const GLfixed nothing[2] = {0, 0};
	const struct element from =
		find_element(draw->texture[unit].array, index, nothing);

	for (int i = 0; i < 2; i++) {
		out[i] = load_value(&from, i, two_16);
	}
}
