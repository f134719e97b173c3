#include "app/model/gltf/gltf_internal.h"
#include "app/model/little_endian.h"

#include <errno.h>
#include <math.h>
#include <string.h>

size_t gltf_component_bytes(enum gltf_component component)
{
	switch (component) {
	case GLTF_I8:
	case GLTF_U8:
		return 1;
	case GLTF_I16:
	case GLTF_U16:
		return 2;
	case GLTF_U32:
	case GLTF_F32:
		return 4;
	}
	return 0;
}

static const uint8_t *element_at(const struct gltf_elements *elements, int index)
{
	return elements->data + (size_t)index * elements->stride;
}

static uint32_t get_uint(const uint8_t *bytes, enum gltf_component component)
{
	switch (component) {
	case GLTF_U8:
		return bytes[0];
	case GLTF_U16:
		return little_endian_u16(bytes);
	default:
		return little_endian_u32(bytes);
	}
}

uint32_t gltf_get_uint(const struct gltf_elements *elements, int index)
{
	return get_uint(element_at(elements, index), elements->component);
}

/*
 * Reads a component as a float. Of normalised bytes, both -128 and -127 become
 * -1 (glTF 2.0, 3.6.2.2), likewise of shorts.
 */
static float get_float(
	const uint8_t *bytes, enum gltf_component component, bool normalized)
{
	uint32_t bits;
	float value = 0;
	float unit = 1;

	switch (component) {
	case GLTF_I8:
		value = (float)(int8_t)bytes[0];
		unit = 127.0f;
		break;
	case GLTF_U8:
		value = (float)bytes[0];
		unit = 255.0f;
		break;
	case GLTF_I16:
		value = (float)(int16_t)little_endian_u16(bytes);
		unit = 32767.0f;
		break;
	case GLTF_U16:
		value = (float)little_endian_u16(bytes);
		unit = 65535.0f;
		break;
	case GLTF_U32:
		return (float)little_endian_u32(bytes);
	case GLTF_F32:
		bits = little_endian_u32(bytes);
		memcpy(&value, &bits, sizeof(value));
		return value;
	}
	if (!normalized) {
		return value;
	}
	value /= unit;
	return value < -1 ? -1 : value;
}

/* Copies elements of numbers of 32 bits, which most numbers of a model are. */
static void copy_words(const struct gltf_elements *elements, int count,
	size_t width, void *out)
{
	uint8_t *to = out;

	for (int i = 0; i < count; i++) {
		const uint8_t *from = element_at(elements, i);

		for (size_t k = 0; k < width; k++, to += 4) {
			uint32_t word = little_endian_u32(from + 4 * k);

			memcpy(to, &word, sizeof(word));
		}
	}
}

/* Unpacks an element, without the bytes that align a matrix's columns. */
static void unpack_floats(const struct gltf_elements *elements, int index,
	const struct gltf_accessor *accessor, float *out)
{
	const uint8_t *bytes = element_at(elements, index);
	size_t size = gltf_component_bytes(elements->component);
	size_t column = ((size_t)accessor->rows * size + 3) & ~(size_t)3;

	for (int i = 0; i < accessor->width; i += accessor->rows) {
		for (int row = 0; row < accessor->rows; row++) {
			out[i + row] = get_float(bytes + (size_t)row * size,
				elements->component, accessor->normalized);
		}
		bytes += column;
	}
}

static int check_finite(const struct gltf_at *at,
	const struct gltf_accessor *accessor, const float *values)
{
	size_t total = (size_t)accessor->count * (size_t)accessor->width;
	size_t i;

	for (i = 0; i < total; i++) {
		if (!(fabsf(values[i]) <= MODEL_NUMBER_MAX)) {
			return gltf_fail(at, -EINVAL,
				"element %zu of accessor %d is %s",
				i / (size_t)accessor->width, accessor->index,
				isfinite(values[i]) ? "larger than 1e9"
						    : "not finite");
		}
	}
	return 0;
}

int gltf_unpack_floats(const struct gltf_at *at,
	const struct gltf_accessor *accessor, float *out)
{
	size_t width = (size_t)accessor->width;
	int i;

	memset(out, 0, (size_t)accessor->count * width * sizeof(*out));
	if (accessor->base.data && accessor->base.component == GLTF_F32) {
		copy_words(&accessor->base, accessor->count, width, out);
	} else {
		for (i = 0; accessor->base.data && i < accessor->count; i++) {
			unpack_floats(&accessor->base, i, accessor,
				out + (size_t)i * width);
		}
	}
	for (i = 0; i < accessor->sparse_count; i++) {
		uint32_t element = gltf_get_uint(&accessor->sparse_index, i);

		unpack_floats(&accessor->sparse_value, i, accessor,
			out + element * width);
	}
	return accessor->base.component == GLTF_F32
		? check_finite(at, accessor, out)
		: 0;
}

/* Unpacks count elements from the first one on. */
static void unpack_uints(const struct gltf_elements *elements, int first,
	int count, size_t width, uint32_t *out)
{
	enum gltf_component component = elements->component;
	size_t size = gltf_component_bytes(component);

	for (int i = first; i < first + count; i++) {
		const uint8_t *bytes = element_at(elements, i);

		for (size_t k = 0; k < width; k++) {
			*out++ = get_uint(bytes + k * size, component);
		}
	}
}

void gltf_unpack_uints(const struct gltf_accessor *accessor, uint32_t *out)
{
	size_t width = (size_t)accessor->width;

	memset(out, 0, (size_t)accessor->count * width * sizeof(*out));
	if (accessor->base.data) {
		unpack_uints(&accessor->base, 0, accessor->count, width, out);
	}
	for (int i = 0; i < accessor->sparse_count; i++) {
		uint32_t element = gltf_get_uint(&accessor->sparse_index, i);

		unpack_uints(&accessor->sparse_value, i, 1, width,
			out + element * width);
	}
}
