/* Elements of vertex arrays as fixed point. */
#include <string.h>

#include "platform/base/scalar.h"
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

static const float two_16 = 65536.0f, two_30 = 1073741824.0f;

static const uint8_t *element_at(const struct array *array, uint32_t index)
{
	return array->pointer + (size_t)index * (size_t)array->stride_bytes;
}

static uint32_t load_bits(const uint8_t *at)
{
	uint32_t bits;

	memcpy(&bits, at, sizeof(bits));
	return bits;
}

static float to_float(uint32_t bits)
{
	float value;

	memcpy(&value, &bits, sizeof(value));
	return value;
}

static ALWAYS_INLINE float load_float(const uint8_t *at)
{
	float value;

	memcpy(&value, at, sizeof(value));
	return value;
}

/* Any float; what is too large is cut, NaN is 0. */
static int32_t checked(uint32_t bits, float scale)
{
	float value = to_float(bits) * scale;

	if (value >= 2147483520.0f) {
		return INT32_MAX;
	}
	if (value <= -2147483520.0f) {
		return -INT32_MAX;
	}
	return value == value ? (int32_t)value : 0;
}

/*
 * Three floats below 2^(exponent - 126), told by their bits together; what may
 * be larger is looked at one by one.
 */
static ALWAYS_INLINE void load_floats(
	const uint8_t *at, int count, float scale, uint32_t limit, int32_t *out)
{
	uint32_t bits[3], all = 0;

	for (int i = 0; i < count; i++) {
		bits[i] = load_bits(at + 4 * i);
		all |= bits[i];
	}
	if ((all & INT32_MAX) < limit) {
		for (int i = 0; i < count; i++) {
			out[i] = (int32_t)(to_float(bits[i]) * scale);
		}
		return;
	}
	for (int i = 0; i < count; i++) {
		out[i] = checked(bits[i], scale);
	}
}

static int32_t load_integer(const uint8_t *at, GLenum type, int i)
{
	int16_t value;

	switch (type) {
	case GL_BYTE:
		return (int8_t)at[i];
	case GL_SHORT:
		memcpy(&value, at + 2 * i, sizeof(value));
		return value;
	default:
		return (int32_t)load_bits(at + 4 * i);
	}
}

/* Of the sizes of floats, as bits without their sign. */
static ALWAYS_INLINE uint32_t larger(uint32_t most, uint32_t bits)
{
	return bits << 1 > most ? bits << 1 : most;
}

int soft_array_position_exponent(
	const struct array *array, uint32_t first, uint32_t count)
{
	const uint8_t *at = element_at(array, first);
	int size = array->size < 3 ? array->size : 3;
	uint32_t most = 0;

	if (array->type == GL_BYTE) {
		return 7;
	}
	if (array->type != GL_FLOAT) {
		return 15;
	}
	if (size == 3) {
		most = ((uintptr_t)at | (uintptr_t)array->stride_bytes) % 4 == 0
			? soft_largest_aligned_float(
				  at, array->stride_bytes, count)
			: soft_largest_float(at, array->stride_bytes, count);
		return (int)(most >> 24) - 127;
	}
	for (uint32_t n = 0; n < count; n++, at += array->stride_bytes) {
		most = larger(most, load_bits(at));
		most = larger(most, load_bits(at + 4));
	}
	return (int)(most >> 24) - 127;
}

void soft_array_position(const struct draw *draw, uint32_t index, int32_t out[3])
{
	const struct array *array = &draw->soft->arrays.vertex;
	const uint8_t *at = element_at(array, index);
	int size = array->size < 3 ? array->size : 3;

	if (array->type == GL_FLOAT && !draw->checked) {
		float scale = draw->view.scale;

		out[0] = (int32_t)(load_float(at) * scale);
		out[1] = (int32_t)(load_float(at + 4) * scale);
		out[2] = size == 3 ? (int32_t)(load_float(at + 8) * scale) : 0;
		return;
	}
	out[2] = 0;
	for (int i = 0; i < size; i++) {
		if (array->type == GL_FLOAT) {
			out[i] = clamp_int(
				checked(load_bits(at + 4 * i), draw->view.scale),
				-(1 << 30), 1 << 30);
			continue;
		}
		/* 8 and 16 bits up to 2^29, 16.16 halved. */
		out[i] = load_integer(at, array->type, i);
		out[i] = array->type == GL_FIXED ? out[i] >> 2
			: array->type == GL_BYTE ? out[i] * (1 << 22)
						 : out[i] * (1 << 14);
	}
}

/* Of floats or 16.16, with components below 1/2: any length, one direction. */
static void load_long_normal(
	const uint8_t *at, bool floats, const GLfixed *fixed, int32_t out[3])
{
	float n[3], most = 0.0f;

	for (int i = 0; i < 3; i++) {
		n[i] = floats ? load_float(at + 4 * i) : (float)fixed[i];
		most = scalar_abs(n[i]) > most ? scalar_abs(n[i]) : most;
	}
	for (int i = 0; i < 3; i++) {
		float share = n[i] / most * (two_30 / 4.0f);

		/* Infinite ones leave no direction. */
		out[i] = share == share ? (int32_t)share : 0;
	}
}

static bool is_long(const GLfixed n[3])
{
	const GLfixed two = 2 * 65536;

	return n[0] >= two || n[1] >= two || n[2] >= two || n[0] <= -two ||
		n[1] <= -two || n[2] <= -two;
}

void soft_array_normal_q30(
	const struct draw *draw, uint32_t index, int32_t out[3])
{
	const struct arrays *arrays = &draw->soft->arrays;
	const struct array *array = &arrays->normal;
	const uint8_t *at = element_at(array, index);
	GLenum type = array->enabled ? array->type : GL_FIXED;
	GLfixed value[3];

	if (array->enabled && array->type == GL_FLOAT) {
		uint32_t all =
			load_bits(at) | load_bits(at + 4) | load_bits(at + 8);

		if (draw->shading.normalize && (all & INT32_MAX) >= 0x40000000) {
			load_long_normal(at, true, NULL, out);
			return;
		}
		load_floats(at, 3, two_30, 0x40000000, out);
		return;
	}
	if (array->enabled && array->type == GL_SHORT) {
		int16_t n[3];

		memcpy(n, at, sizeof(n));
		out[0] = (2 * n[0] + 1) * 16384;
		out[1] = (2 * n[1] + 1) * 16384;
		out[2] = (2 * n[2] + 1) * 16384;
		return;
	}
	for (int i = 0; i < 3; i++) {
		value[i] = array->enabled ? load_integer(at, type, i)
					  : arrays->current_normal[i];
	}
	if (draw->shading.normalize && type == GL_FIXED && is_long(value)) {
		load_long_normal(NULL, false, value, out);
		return;
	}
	for (int i = 0; i < 3; i++) {
		/* (2 c + 1) / (2^bits - 1) */
		out[i] = type == GL_BYTE
			? (2 * value[i] + 1) * 4210752
			: saturate_64((int64_t)value[i] * 16384);
	}
}

static int32_t color_from_byte(int byte)
{
	return byte * 257 + (byte >> 7);
}

void soft_array_color_q16(
	const struct draw *draw, uint32_t index, int32_t out[4])
{
	const struct arrays *arrays = &draw->soft->arrays;
	const struct array *array = &arrays->color;
	const uint8_t *at = element_at(array, index);

	if (array->enabled && array->type == GL_UNSIGNED_BYTE) {
		out[0] = color_from_byte(at[0]);
		out[1] = color_from_byte(at[1]);
		out[2] = color_from_byte(at[2]);
		out[3] = color_from_byte(at[3]);
		return;
	}
	for (int i = 0; i < 4; i++) {
		if (!array->enabled) {
			out[i] = arrays->current_color[i];
		} else if (array->type == GL_FIXED) {
			out[i] = (int32_t)load_bits(at + 4 * i);
		} else {
			out[i] = checked(load_bits(at + 4 * i), two_16);
		}
	}
}

void soft_array_texcoord_q16(
	const struct draw *draw, int unit, uint32_t index, int32_t out[2])
{
	const struct array *array = draw->texture[unit].array;
	const uint8_t *at = element_at(array, index);

	out[0] = 0;
	out[1] = 0;
	if (!array->enabled) {
		return;
	}
	if (array->type == GL_FLOAT) {
		/* Below 2^15, as the bits of 2^15 tell. */
		load_floats(at, 2, two_16, 0x47000000, out);
		return;
	}
	for (int i = 0; i < 2; i++) {
		out[i] = load_integer(at, array->type, i);
		out[i] = array->type == GL_FIXED ? out[i] : out[i] * 65536;
	}
}
