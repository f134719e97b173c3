/* The colour of a lit vertex, by GL ES 1.1 section 2.12.1. */
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

#include <string.h>

/* What falls on a vertex so far; the terms of 16.16. */
struct lit {
	int32_t diffuse[3]; /* by the colour, where it is tracked */
	int32_t specular[3];
};

/* To unit length, from any but 0. */
static void normalize_q30(int32_t n[3])
{
	uint64_t square = (uint64_t)((int64_t)n[0] * n[0]) +
		(uint64_t)((int64_t)n[1] * n[1]) +
		(uint64_t)((int64_t)n[2] * n[2]);
	uint32_t square_q28 = (uint32_t)(square >> 32);
	struct root root;

	/* Within 2^-10 of unit length nobody sees the difference. */
	if (square_q28 - ((1u << 28) - (1u << 19)) < 1u << 20 || square == 0) {
		return;
	}
	root = soft_reciprocal_root(square);
	for (int i = 0; i < 3; i++) {
		n[i] = (int32_t)((int64_t)n[i] * root.mantissa_q30 >> root.shift);
	}
}

/* One that is to be normalised may be too long for Q30: then a 16th of it. */
static void rotate_normal(const int32_t m_q28[9], bool any_length, int32_t n[3])
{
	int64_t sum[3], sizes = 0;
	int shift;

	for (int i = 0; i < 3; i++) {
		sum[i] = (int64_t)m_q28[i] * n[0] +
			(int64_t)m_q28[3 + i] * n[1] +
			(int64_t)m_q28[6 + i] * n[2];
		sizes |= sum[i] ^ (sum[i] >> 63);
	}
	shift = any_length && sizes >> 59 ? 32 : 28;
	for (int i = 0; i < 3; i++) {
		n[i] = saturate_64(sum[i] >> shift);
	}
}

static ALWAYS_INLINE void add_directional(const struct shading *shading,
	const struct light_source *light_source, const int32_t n[3],
	struct lit *lit)
{
	int32_t towards_q26 = dot_high(n, light_source->towards_q28);
	int32_t glance_q26, power_q28;

	if (towards_q26 <= 0) {
		return;
	}
	lit->diffuse[0] += mul_high(towards_q26, light_source->diffuse_q22[0]);
	lit->diffuse[1] += mul_high(towards_q26, light_source->diffuse_q22[1]);
	lit->diffuse[2] += mul_high(towards_q26, light_source->diffuse_q22[2]);
	if (!light_source->specular) {
		return;
	}
	glance_q26 = dot_high(n, light_source->half_q28);
	if (glance_q26 <= 0) {
		return;
	}
	power_q28 =
		soft_power_q28(glance_q26 > 1 << 26 ? 1 << 28 : glance_q26 << 2,
			shading->shininess_q16);
	for (int i = 0; i < 3; i++) {
		lit->specular[i] +=
			mul_high(power_q28, light_source->specular_q20[i]);
	}
}

/* Its length in 16.16; the vector itself becomes Q28 of unit length. */
static int32_t take_length(int32_t v[3])
{
	uint64_t square = 0;
	struct root root;
	int64_t length;

	for (int i = 0; i < 3; i++) {
		/* |v| < 2^31 / 2 a component, so that three squares fit. */
		v[i] = clamp_int(v[i], -(1 << 30), 1 << 30);
		square += (uint64_t)((int64_t)v[i] * v[i]);
	}
	if (square == 0) {
		return 0;
	}
	root = soft_reciprocal_root(square);
	/* square / sqrt(square), square = high 2^32 + low */
	length =
		(int64_t)((square >> 16) * (uint64_t)(root.mantissa_q30 >> 14) >>
			root.shift);
	for (int i = 0; i < 3; i++) {
		v[i] = (int32_t)((int64_t)v[i] * root.mantissa_q30 >>
			(root.shift + 2));
	}
	return saturate_64(length);
}

/* 1 / value, both 16.16. */
static int32_t invert_q16(int64_t value)
{
	int zeros;

	if (value < 4) {
		return INT32_MAX;
	}
	zeros = LEADING_ZEROS_64((uint64_t)value);
	return reciprocal((uint32_t)((uint64_t)value << zeros >> 32)) >>
		(62 - zeros > 31 ? 31 : 62 - zeros);
}

/* How much of a positional light source arrives, 16.16. */
static int32_t attenuate(const struct light_source *light_source,
	int32_t distance_q16, const int32_t towards_q28[3])
{
	const int32_t *k = light_source->attenuation_q16;
	int64_t d = distance_q16;
	int64_t by = k[0] + (k[1] * d >> 16) + ((d * d >> 16) * k[2] >> 16);
	int64_t share = invert_q16(by);
	int64_t along = 0;

	if (!light_source->spot) {
		return (int32_t)share;
	}
	for (int i = 0; i < 3; i++) {
		along -= (int64_t)towards_q28[i] *
			light_source->direction_q28[i];
	}
	along >>= 28;
	if (along < light_source->cutoff_q28) {
		return 0;
	}
	return (int32_t)(share *
			soft_power_q28(
				(int32_t)(along > 1 << 28 ? 1 << 28 : along),
				light_source->exponent_q16) >>
		28);
}

static void add_positional(const struct shading *shading,
	const struct light_source *light_source, const int32_t n[3],
	const int32_t eye_q16[3], struct lit *lit)
{
	struct light_source here = *light_source;
	struct lit added = {{0}, {0}};
	int32_t distance, share;

	for (int i = 0; i < 3; i++) {
		here.towards_q28[i] = saturate_64(
			(int64_t)light_source->position_q16[i] - eye_q16[i]);
	}
	distance = take_length(here.towards_q28);
	share = attenuate(light_source, distance, here.towards_q28);
	for (int i = 0; i < 3; i++) {
		here.half_q28[i] = here.towards_q28[i] + (i == 2 ? 1 << 28 : 0);
	}
	take_length(here.half_q28);
	add_directional(shading, &here, n, &added);
	for (int i = 0; i < 3; i++) {
		lit->diffuse[i] +=
			shading_bound((int64_t)(added.diffuse[i] +
					      light_source->ambient_q16[i]) *
					share >>
				16);
		lit->specular[i] +=
			shading_bound((int64_t)added.specular[i] * share >> 16);
	}
}

static ALWAYS_INLINE void light_side(const struct draw *draw, const int32_t n[3],
	const int32_t eye[3], const int32_t vertex_color[4], int32_t out[4])
{
	const struct shading *shading = &draw->shading;
	struct lit lit = {{shading->ambient_q16[0], shading->ambient_q16[1],
				  shading->ambient_q16[2]},
		{0, 0, 0}};

	for (int i = 0; i < shading->light_source_count; i++) {
		const struct light_source *light_source =
			&shading->light_source[i];

		if (light_source->positional) {
			add_positional(shading, light_source, n, eye, &lit);
		} else {
			add_directional(shading, light_source, n, &lit);
		}
	}
	if (shading->tracked) {
		for (int i = 0; i < 3; i++) {
			lit.diffuse[i] = shading_bound(
				(int64_t)lit.diffuse[i] * vertex_color[i] >> 16);
		}
	}
	out[0] = to_attribute(
		lit.diffuse[0] + lit.specular[0] + shading->emission_q16[0]);
	out[1] = to_attribute(
		lit.diffuse[1] + lit.specular[1] + shading->emission_q16[1]);
	out[2] = to_attribute(
		lit.diffuse[2] + lit.specular[2] + shading->emission_q16[2]);
	out[3] = to_attribute(
		shading->tracked ? vertex_color[3] : shading->base_q16[3]);
}

void soft_light_find_eye(const struct draw *draw, uint32_t index, int32_t out[3])
{
	int32_t p[3];

	soft_array_position(draw, index, p);
	for (int i = 0; i < 3; i++) {
		const int32_t *row = draw->eye_q16[i];
		int64_t sum = (int64_t)row[0] * p[0] + (int64_t)row[1] * p[1] +
			(int64_t)row[2] * p[2];

		out[i] = saturate_64((sum >> draw->position_q) + row[3]);
	}
}

void soft_light(const struct draw *draw, struct vertex *vertex)
{
	const struct shading *shading = &draw->shading;
	int32_t n[3], eye[3] = {0, 0, 0};
	int32_t color[4] = {65536, 65536, 65536, 65536};

	soft_array_normal_q30(draw, vertex->index, n);
	if (shading->rotate_normals) {
		rotate_normal(shading->normal_q28, shading->normalize, n);
	}
	if (shading->normalize) {
		normalize_q30(n);
	}
	if (shading->tracked) {
		soft_array_color_q16(draw, vertex->index, color);
	}
	if (draw->eye_needed) {
		soft_light_find_eye(draw, vertex->index, eye);
	}
	light_side(draw, n, eye, color, vertex->attribute + RED);
	if (shading->two_side) {
		for (int i = 0; i < 3; i++) {
			n[i] = -n[i];
		}
		light_side(draw, n, eye, color, vertex->back);
	}
}
