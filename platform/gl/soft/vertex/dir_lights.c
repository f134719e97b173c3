/*
 * Lighting as most is wanted, see struct dir_lights: normals of Q28, their
 * cosines with lights Q26, diffuse light Q24, what highlights add Q16.
 */
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

#include <string.h>

/*
 * To unit length, from halves: c is (2 c + 1) / 65535. Their sum of squares is
 * a quarter of the length's, within 2^-9 where any is 256 or more.
 */
static ALWAYS_INLINE void normalize_shorts(
	const struct dir_lights *light, const int16_t c[3], int32_t n[3])
{
	/* Below 2^32: three of at most 2^30. */
	uint32_t square = 1 + (uint32_t)(c[0] * c[0]) +
		(uint32_t)(c[1] * c[1]) + (uint32_t)(c[2] * c[2]);
	int zeros = LEADING_ZEROS_32(square) & ~1;
	uint32_t v = square << zeros; /* 0.25..1 in Q32 */
	uint32_t r = (uint32_t)light->roots[(v >> 24) - 64] << 13; /* Q28 */
	uint32_t product_q24 = mul_high_unsigned(mul_high_unsigned(r, r), v);

	/* r (3 - v r^2) / 2: 7 bits become 14; Q29. */
	r = mul_high_unsigned(r, (3u << 24) - product_q24) << 8;
	for (int i = 0; i < 3; i++) {
		/* |2 c + 1| << zeros / 2 is below 2^17. */
		n[i] = mul_high(
			(2 * c[i] + 1) * (1 << (14 + zeros / 2)), (int32_t)r);
	}
}

/* What is no number is 0. */
static ALWAYS_INLINE bool take_floats(
	const struct dir_lights *light, const void *at, int32_t n[3])
{
	uint32_t square;
	float f[3];

	memcpy(f, at, sizeof(f));
	for (int i = 0; i < 3; i++) {
		if (f[i] >= 2.0f || f[i] <= -2.0f) {
			return false;
		}
		n[i] = f[i] == f[i] ? (int32_t)(f[i] * 268435456.0f) : 0;
	}
	square = (uint32_t)dot_high(n, n);
	return square - light->square_least < light->square_range;
}

static void add_spec_table(const struct dir_light *light_source,
	const int32_t n[3], int32_t shine[3])
{
	int32_t above_q26 =
		dot_high(n, light_source->half_q30) - light_source->least_q26;
	const struct spec_table_step *step;
	int32_t place, spec_table_q28;

	if (above_q26 <= 0) {
		return;
	}
	place = mul_high(above_q26, light_source->scale);
	place = clamp_int(place, 0, 256 * SPEC_TABLE_STEPS - 1);
	step = &light_source->step[place >> 8];
	spec_table_q28 = step->value_q28 + step->rise_q28 * (place & 255);
	for (int i = 0; i < 3; i++) {
		shine[i] = mul_high_add(shine[i], spec_table_q28,
			light_source->specular_q20[i]);
	}
}

static void light_side(const struct dir_lights *light, const int32_t n[3],
	const uint8_t color[4], int32_t out[4])
{
	int32_t dull[3], shine[3];

	memcpy(dull, light->ambient_q24, sizeof(dull));
	memcpy(shine, light->emission_q16, sizeof(shine));
	for (const struct dir_light *light_source = light->dir_light;
		light_source != light->end; light_source++) {
		int32_t towards_q26 = dot_high(n, light_source->towards_q30);

		if (towards_q26 <= 0) {
			continue;
		}
		for (int i = 0; i < 3; i++) {
			dull[i] = mul_high_add(dull[i], towards_q26,
				light_source->diffuse_q30[i]);
		}
		if (light_source->spec_tables) {
			add_spec_table(light_source, n, shine);
		}
	}
	for (int i = 0; i < 3; i++) {
		out[i] = to_attribute(
			MULTIPLY_ADD_HALF(shine[i], dull[i], color[i]));
	}
	out[3] = 128 + color[3] * 256;
}

bool soft_light_by_dir_lights(
	const struct dir_lights *light, struct vertex *vertex)
{
	size_t index = vertex->index;
	const void *normal =
		light->normals + index * (size_t)light->normal_stride;
	const uint8_t *color =
		light->colors + index * (size_t)light->color_stride;
	int16_t c[3];
	int32_t n[3];

	if (!light->floats) {
		memcpy(c, normal, sizeof(c));
		normalize_shorts(light, c, n);
	} else if (!take_floats(light, normal, n)) {
		return false;
	}
	light_side(light, n, color, vertex->attribute + RED);
	if (light->two_side) {
		for (int i = 0; i < 3; i++) {
			n[i] = -n[i];
		}
		light_side(light, n, color, vertex->back);
	}
	return true;
}
