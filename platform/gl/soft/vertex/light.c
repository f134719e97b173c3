/*
 * The colour of a lit vertex, by GL ES 1.1 section 2.12.1. Normals are Q28,
 * cosines Q26, diffuse light is Q24 and specular light Q16.
 */
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

#include <string.h>

/* A normal or a colour, as values that stay in registers. */
struct triple {
	int32_t x, y, z;
};

static ALWAYS_INLINE struct triple load_triple(const int32_t from[3])
{
	return (struct triple){from[0], from[1], from[2]};
}

static ALWAYS_INLINE int32_t dot(const int32_t a[3], struct triple b)
{
	int32_t sum = mul_high_add(mul_high(a[0], b.x), a[1], b.y);

	return mul_high_add(sum, a[2], b.z);
}

static ALWAYS_INLINE void add_scaled(
	struct triple *sum, int32_t factor, const int32_t a[3])
{
	sum->x = mul_high_add(sum->x, factor, a[0]);
	sum->y = mul_high_add(sum->y, factor, a[1]);
	sum->z = mul_high_add(sum->z, factor, a[2]);
}

static ALWAYS_INLINE int16_t load_short(const void *at)
{
	int16_t value;

	memcpy(&value, at, sizeof(value));
	return value;
}

/*
 * Normalizes a normal of shorts c, which mean (2 c + 1) / 65535. The sum of c^2
 * is a quarter of the sum of (2 c + 1)^2, within 2^-9 if any |c| is 256 or more.
 */
static ALWAYS_INLINE struct triple normalize_shorts(
	const struct shading *shading, const void *at)
{
	int32_t x = load_short(at), y = load_short((const char *)at + 2);
	int32_t z = load_short((const char *)at + 4);
	/* below 2^32: three squares of at most 2^30 */
	uint32_t square =
		1 + (uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z);
	int zeros = LEADING_ZEROS_32(square) & ~1;
	uint32_t v = square << zeros; /* 0.25..1 in Q32 */
	uint32_t r = (uint32_t)shading->roots[(v >> 24) - 64] << 13; /* Q28 */
	uint32_t product_q24 = mul_high_unsigned(mul_high_unsigned(r, r), v);
	/* |2 c + 1| << zeros / 2 is below 2^17. */
	int32_t up = 1 << (14 + zeros / 2), root;

	/* Newton step r (3 - v r^2) / 2: 7 exact bits become 14; Q29 */
	root = (int32_t)(mul_high_unsigned(r, (3u << 24) - product_q24) << 8);
	return (struct triple){mul_high((2 * x + 1) * up, root),
		mul_high((2 * y + 1) * up, root),
		mul_high((2 * z + 1) * up, root)};
}

/* Converts to Q28; NaN gives 0, |value| >= 2 a number with a square near 64. */
static ALWAYS_INLINE int32_t take_float(float value)
{
	if (value >= 2.0f || value <= -2.0f) {
		return INT32_MAX;
	}
	return value == value ? (int32_t)(value * 268435456.0f) : 0;
}

/* Adds specular light to shine, into out; returns out, or shine if it is 0. */
static ALWAYS_INLINE const int32_t *add_highlight(
	const struct light_source *light_source, struct triple n,
	const int32_t *shine, int32_t *out)
{
	int32_t above_q26 =
		dot(light_source->half_q30, n) - light_source->least_q26;
	const struct spec_table_step *step;
	int32_t place, share;

	if (above_q26 <= 0) {
		return shine;
	}
	place = LIMIT_TO_BITS(mul_high(above_q26, light_source->scale), 14);
	step = &light_source->step[place >> 8];
	share = step->value_q28 + step->rise_q28 * (place & 255);
	for (int i = 0; i < 3; i++) {
		out[i] = mul_high_add(
			shine[i], share, light_source->specular_q20[i]);
	}
	return out;
}

/* Adds a directional light; returns as add_highlight() does. */
static ALWAYS_INLINE const int32_t *add_light(
	const struct light_source *light_source, struct triple n,
	struct triple *dull, const int32_t *shine, int32_t *out)
{
	int32_t towards_q26 = dot(light_source->towards_q30, n);

	if (towards_q26 <= 0) {
		return shine;
	}
	add_scaled(dull, towards_q26, light_source->diffuse_q30);
	return light_source->step ? add_highlight(light_source, n, shine, out)
				  : shine;
}

/* Lights a side whose colour is four bytes, red in the lowest one. */
static ALWAYS_INLINE void light_side(const struct shading *shading,
	struct triple n, uint32_t color, int32_t out[4])
{
	struct triple dull = load_triple(shading->ambient_q24);
	const int32_t *shine = shading->emission_q16;
	uint32_t red_blue, green_alpha;

	for (const struct light_source *light_source = shading->light_source;
		light_source != shading->end; light_source++) {
		shine = add_light(light_source, n, &dull, shine, out);
	}
	red_blue = BYTES_AS_HALVES(color);
	green_alpha = ODD_BYTES_AS_HALVES(color);
	out[0] = to_attribute(MULTIPLY_ADD_HALF(shine[0], dull.x, red_blue));
	out[1] = to_attribute(MULTIPLY_ADD_HALF(shine[1], dull.y, green_alpha));
	out[2] = to_attribute(
		MULTIPLY_ADD_HALF(shine[2], dull.z, red_blue >> 16));
	out[3] = 128 + (int32_t)(green_alpha >> 16 << 8);
}

/* Loads a normal of floats in Q28; false if its length is out of range. */
static ALWAYS_INLINE bool take_floats(
	const struct shading *shading, const float f[3], struct triple *n)
{
	int32_t square;

	*n = (struct triple){
		take_float(f[0]), take_float(f[1]), take_float(f[2])};
	square = mul_high(n->x, n->x);
	square = mul_high_add(square, n->y, n->y);
	square = mul_high_add(square, n->z, n->z);
	return (uint32_t)square - shading->square_least < shading->square_range;
}

/* Lights a side in 32 bits; false if the normal is a float out of range. */
static ALWAYS_INLINE bool light_fast(const struct shading *shading,
	uint32_t index, bool back, int32_t out[4])
{
	const uint8_t *normal =
		shading->normals + index * (size_t)shading->normal_stride;
	const uint8_t *color =
		shading->colors + index * (size_t)shading->color_stride;
	uint32_t bytes;
	struct triple n;

	/* loaded early: the cache fetches it while the normal is normalized */
	memcpy(&bytes, color, sizeof(bytes));
	PRELOAD(normal + 40);
	if (!shading->floats) {
		n = normalize_shorts(shading, normal);
	} else if (!take_floats(
			   shading, (const float *)(const void *)normal, &n)) {
		return false;
	}
	if (back) {
		n = (struct triple){-n.x, -n.y, -n.z};
	}
	light_side(shading, n, bytes, out);
	return true;
}

/* Returns a vector's length, 16.16, and normalizes the vector to Q30. */
static int32_t take_length(int32_t v[3])
{
	uint64_t square = 0; /* three squares of at most 2^62 fit */
	struct root root;
	int64_t length;

	for (int i = 0; i < 3; i++) {
		square += (uint64_t)((int64_t)v[i] * v[i]);
	}
	if (square == 0) {
		return 0;
	}
	root = soft_reciprocal_root(square);
	/* square / sqrt(square) */
	length =
		(int64_t)((square >> 16) * (uint64_t)(root.mantissa_q30 >> 14) >>
			root.shift);
	for (int i = 0; i < 3; i++) {
		v[i] = (int32_t)((int64_t)v[i] * root.mantissa_q30 >> root.shift);
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

/* A positional light's attenuation and spotlight factor, 16.16. */
static int32_t attenuate(const struct light_source *light_source,
	int32_t distance_q16, const int32_t towards_q30[3])
{
	const int32_t *k = light_source->attenuation_q16;
	int64_t d = distance_q16;
	int64_t square = d * d >> 16;
	/* square < 2^46 and k < 2^31: their product may need 77 bits. */
	int64_t by = k[0] + (k[1] * d >> 16) +
		(square >> 32 ? (square >> 16) * k[2] : square * k[2] >> 16);
	int64_t share = invert_q16(by);
	int64_t along = 0;

	if (!light_source->spot) {
		return (int32_t)share;
	}
	for (int i = 0; i < 3; i++) {
		along -= (int64_t)towards_q30[i] *
			light_source->direction_q28[i];
	}
	along >>= 30;
	if (along < light_source->cutoff_q28) {
		return 0;
	}
	return (int32_t)(share *
			soft_power_q28(
				(int32_t)(along > 1 << 28 ? 1 << 28 : along),
				light_source->exponent_q16) >>
		28);
}

/* Finds a positional light's directions from a vertex; returns attenuate(). */
static int32_t meet(struct light_source *light_source, const int32_t eye_q16[3])
{
	int32_t *towards = light_source->towards_q30;
	int32_t *half = light_source->half_q30;
	int32_t distance;

	for (int i = 0; i < 3; i++) {
		towards[i] = saturate_64(
			(int64_t)light_source->position_q16[i] - eye_q16[i]);
	}
	distance = take_length(towards);
	for (int i = 0; i < 3; i++) {
		half[i] = (towards[i] >> 2) + (i == 2 ? 1 << 28 : 0);
	}
	if (light_source->step) { /* there are highlights */
		take_length(half);
	}
	return attenuate(light_source, distance, towards);
}

/* Sums of light on a vertex, 16.16. */
struct lit {
	int32_t diffuse[3]; /* still to be multiplied by the vertex's colour */
	int32_t specular[3];
};

static void add_any_light(const struct light_source *light_source,
	struct triple n, const int32_t eye[3], struct lit *lit)
{
	const int32_t nothing[3] = {0, 0, 0}, *shine;
	struct light_source here = *light_source;
	int32_t share_q16 = 65536, added[3];
	struct triple dull = load_triple(here.ambient_q24);

	if (here.positional) {
		share_q16 = meet(&here, eye);
	}
	shine = add_light(&here, n, &dull, nothing, added);
	for (int i = 0; i < 3; i++) {
		int32_t dull_q24 = i == 0 ? dull.x : i == 1 ? dull.y : dull.z;

		dull_q24 += -dull_q24 >> 8; /* times 255/256 */
		lit->diffuse[i] += shading_bound(
			(int64_t)dull_q24 * share_q16 >> (24 - here.shift));
	}
	for (int i = 0; i < 3 && shine != nothing; i++) {
		lit->specular[i] += shading_bound(
			(int64_t)shine[i] * share_q16 >> (16 - here.shift));
	}
}

static void light_any_side(const struct draw *draw, struct triple n,
	const int32_t eye[3], const int32_t color[4], int32_t out[4])
{
	const struct shading *shading = &draw->shading;
	struct lit lit;

	memcpy(lit.diffuse, shading->ambient_q16, sizeof(lit.diffuse));
	memcpy(lit.specular, shading->emission_q16, sizeof(lit.specular));
	for (const struct light_source *light_source = shading->light_source;
		light_source != shading->end; light_source++) {
		add_any_light(light_source, n, eye, &lit);
	}
	for (int i = 0; i < 3; i++) {
		out[i] = to_attribute(lit.specular[i] +
			shading_bound((int64_t)lit.diffuse[i] * color[i] >> 16));
	}
	out[3] = to_attribute(color[3]);
}

/* Fetches a normal of any type, rotates and normalizes it; Q28, within +-8. */
static struct triple find_any_normal(const struct draw *draw, uint32_t index)
{
	const struct shading *shading = &draw->shading;
	const int32_t *m = shading->normal_q28;
	int64_t sum[3], sizes = 0;
	int32_t n[3];
	int shift;

	soft_array_normal_q30(draw, index, n);
	for (int i = 0; i < 3; i++) {
		sum[i] = shading->rotate_normals
			? (int64_t)m[i] * n[0] + (int64_t)m[3 + i] * n[1] +
				(int64_t)m[6 + i] * n[2]
			: n[i] * ((int64_t)1 << 28);
		sizes |= sum[i] ^ (sum[i] >> 63);
	}
	/* >> 30 gives Q28; a normal to be normalized may have any scale */
	shift = !shading->normalize ? 30 : sizes >> 59 ? 32 : 28;
	for (int i = 0; i < 3; i++) {
		n[i] = saturate_64(sum[i] >> shift);
	}
	if (shading->normalize) {
		take_length(n);
		n[0] >>= 2;
		n[1] >>= 2;
		n[2] >>= 2;
	}
	return load_triple(n);
}

/* Lights a vertex that light_fast() cannot, in 64 bits. */
static NEVER_INLINE void light_any(
	const struct draw *draw, struct vertex *vertex)
{
	const struct shading *shading = &draw->shading;
	struct triple n = find_any_normal(draw, vertex->index);
	int32_t eye[3] = {0, 0, 0};
	int32_t color[4] = {65536, 65536, 65536, shading->alpha_q16};

	if (shading->tracked) {
		soft_array_color_q16(draw, vertex->index, color);
	}
	if (draw->eye_needed) {
		soft_shade_find_eye(draw, vertex->index, 0, eye);
	}
	light_any_side(draw, n, eye, color, vertex->attribute + RED);
	if (shading->two_side) {
		n = (struct triple){-n.x, -n.y, -n.z};
		light_any_side(draw, n, eye, color, vertex->back);
	}
}

static NEVER_INLINE void light_back(
	const struct shading *shading, struct vertex *vertex)
{
	light_fast(shading, vertex->index, true, vertex->back);
}

void soft_shade_vertex(const struct draw *draw, struct vertex *vertex)
{
	const struct shading *shading = &draw->shading;

	vertex->shaded = true;
	if (!shading->lit) {
		soft_shade_color(draw, vertex);
	} else if (!shading->fast ||
		!light_fast(shading, vertex->index, false,
			vertex->attribute + RED)) {
		light_any(draw, vertex);
	} else if (shading->two_side) {
		light_back(shading, vertex);
	}
	if (draw->shade_more) {
		soft_shade_rest(draw, vertex);
	}
}
