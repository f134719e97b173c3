/*
 * The colour of a lit vertex, by GL ES 1.1 section 2.12.1. Normals are Q28,
 * cosines Q26, diffuse light is Q24 and specular light Q16.
 */
#include "platform/gl/soft/raster/pixel.h"
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

/*
 * Normalizes a normal of shorts c, which mean (2 c + 1) / 65535. The sum of c^2
 * is a quarter of the sum of (2 c + 1)^2, within 2^-9 if any |c| is 256 or more.
 */
static ALWAYS_INLINE struct triple normalize_shorts(
	const struct shading *shading, const uint8_t *at)
{
	int32_t x = (int16_t)load_16(at), y = (int16_t)load_16(at + 2);
	int32_t z = (int16_t)load_16(at + 4);
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
	const struct light_source *source, const int32_t half_q30[3],
	struct triple n, const int32_t *shine, int32_t *out)
{
	int32_t above_q26 = dot(half_q30, n) - source->least_q26;
	const struct spec_table_step *step;
	int32_t place, share;

	if (above_q26 <= 0) {
		return shine;
	}
	place = LIMIT_TO_BITS(mul_high(above_q26, source->scale), 14);
	step = &source->step[place >> 8];
	share = step->value_q28 + step->rise_q28 * (place & 255);
	for (int i = 0; i < 3; i++) {
		out[i] = mul_high_add(shine[i], share, source->specular_q20[i]);
	}
	return out;
}

/* Adds a light from a direction; returns as add_highlight() does. */
static ALWAYS_INLINE const int32_t *add_light(const struct light_source *source,
	const int32_t towards_q30[3], const int32_t half_q30[3],
	struct triple n, struct triple *dull, const int32_t *shine, int32_t *out)
{
	int32_t towards_q26 = dot(towards_q30, n);

	if (towards_q26 <= 0) {
		return shine;
	}
	add_scaled(dull, towards_q26, source->diffuse_q30);
	return source->step ? add_highlight(source, half_q30, n, shine, out)
			    : shine;
}

/* Whether a normal's length is such that it can be lit as it is. */
static ALWAYS_INLINE bool is_in_range(
	const struct shading *shading, struct triple n)
{
	int32_t square = mul_high(n.x, n.x);

	square = mul_high_add(square, n.y, n.y);
	square = mul_high_add(square, n.z, n.z);
	return (uint32_t)square - shading->square_least < shading->square_range;
}

/* Loads a normal of floats in Q28; false unless it is_in_range(). */
static ALWAYS_INLINE bool take_floats(
	const struct shading *shading, const float f[3], struct triple *n)
{
	*n = (struct triple){
		take_float(f[0]), take_float(f[1]), take_float(f[2])};
	return is_in_range(shading, *n);
}

/* Adds the lights from directions before end; returns as add_highlight() does. */
static ALWAYS_INLINE const int32_t *add_lights(const struct shading *shading,
	const struct light_source *end, struct triple n, struct triple *dull,
	int32_t *out)
{
	const int32_t *shine = shading->emission_q16;

	for (const struct light_source *source = shading->light_source;
		source != end; source++) {
		shine = add_light(source, source->towards_q30, source->half_q30,
			n, dull, shine, out);
	}
	return shine;
}

/*
 * Lights a side by directional lights, if the colour is four bytes and arrays
 * of normals need no conversion; false if the normal is a float out of range.
 */
static ALWAYS_INLINE bool light_fast(const struct shading *shading,
	uint32_t index, bool back, int32_t out[4])
{
	const uint8_t *normal =
		shading->normals + index * (size_t)shading->normal_stride;
	const uint8_t *color =
		shading->colors + index * (size_t)shading->color_stride;
	struct triple dull = load_triple(shading->ambient_q24), n;
	const int32_t *shine;
	/* loaded early: the cache fetches it while the normal is normalized */
	uint32_t bytes = load_32(color), red_blue, green_alpha;

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
	shine = add_lights(shading, shading->end, n, &dull, out);
	red_blue = BYTES_AS_HALVES(bytes);
	green_alpha = ODD_BYTES_AS_HALVES(bytes);
	out[0] = to_attribute(MULTIPLY_ADD_HALF(shine[0], dull.x, red_blue));
	out[1] = to_attribute(MULTIPLY_ADD_HALF(shine[1], dull.y, green_alpha));
	out[2] = to_attribute(
		MULTIPLY_ADD_HALF(shine[2], dull.z, red_blue >> 16));
	out[3] = 128 + (int32_t)(green_alpha >> 16 << 8);
	return true;
}

/* Normalizes a vector below 2^30 to Q30; returns its length. */
static NEVER_INLINE int32_t normalize(int32_t v[3])
{
	uint32_t most = 0, square, root;
	int up, half;

	for (int i = 0; i < 3; i++) {
		most |= (uint32_t)(v[i] ^ v[i] >> 31);
	}
	if (most == 0) {
		return 0;
	}
	up = LEADING_ZEROS_32(most) - 2;
	for (int i = 0; i < 3; i++) {
		v[i] = (int32_t)((uint32_t)v[i] << up);
	}
	/* 2^26 to 3 * 2^28 */
	square = (uint32_t)mul_high_add(
		mul_high_add(mul_high(v[0], v[0]), v[1], v[1]), v[2], v[2]);
	half = LEADING_ZEROS_32(square) / 2;
	square <<= 2 * half;
	root = reciprocal_root(square);
	for (int i = 0; i < 3; i++) {
		v[i] = mul_high((int32_t)((uint32_t)v[i] << 1),
			       (int32_t)(root << 1)) *
			(1 << half);
	}
	return (int32_t)(mul_high_unsigned(square, root) << (4 - half) >> up);
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

int32_t soft_light_fade(const int32_t k_q16[3], int32_t distance_q16)
{
	int64_t d = distance_q16;
	int64_t square = d * d >> 16;

	/* square < 2^46 and k < 2^31: their product may need 77 bits. */
	return invert_q16(k_q16[0] + (k_q16[1] * d >> 16) +
		(square >> 32 ? (square >> 16) * k_q16[2]
			      : square * k_q16[2] >> 16));
}

int32_t soft_light_spot(const struct light_source *source,
	const int32_t towards_q30[3], int32_t share_q16)
{
	const int32_t along_q26 =
		-dot(towards_q30, load_triple(source->direction_q28));

	if (along_q26 < source->cutoff_q26) {
		return 0;
	}
	return (int32_t)((int64_t)share_q16 *
			soft_power_q28(along_q26 * 4, source->exponent_q16) >>
		28);
}

/*
 * Finds a positional light's directions from a vertex; returns its attenuation
 * times its spotlight factor, 16.16.
 */
static int32_t meet(const struct light_source *source, const int32_t eye[3],
	int32_t towards[3], int32_t half[3])
{
	int32_t share_q16 = source->share_q16, distance;

	for (int i = 0; i < 3; i++) {
		towards[i] = source->position[i] - (eye[i] >> source->eye_shift);
	}
	distance = normalize(towards);
	if (source->step) { /* there are highlights */
		half[0] = towards[0] >> 2;
		half[1] = towards[1] >> 2;
		half[2] = (towards[2] >> 2) + (1 << 28);
		normalize(half);
	}
	if (source->fades) {
		share_q16 = soft_light_fade(source->attenuation_q16,
			soft_shade_to_q16(distance, source->position_q));
	}
	return source->spot ? soft_light_spot(source, towards, share_q16)
			    : share_q16;
}

/* Sums of light on a vertex, 16.16. */
struct lit {
	int32_t dull[3]; /* still to be multiplied by the vertex's colour */
	int32_t shine[3];
};

/* Sums lights up that have weights. A light adds less than 2^12, 16.16. */
static NEVER_INLINE void add_weighted(const struct draw *draw, uint32_t index,
	const struct light_source *from, const int32_t normal_q28[3],
	struct lit *lit)
{
	static const int32_t nothing[3];
	const struct light_source *end = draw->shading.end;
	int32_t eye[3], towards[3], half[3], added[3];

	*lit = (struct lit){{0}, {0}};
	if (from == end) {
		return;
	}
	if (draw->eye_needed) {
		soft_shade_find_eye(draw, index, 0, eye);
	}
	for (; from != end; from++) {
		const bool positional = from->positional;
		int32_t share_q16 = positional ? meet(from, eye, towards, half)
					       : from->share_q16;
		/* limited to 64; all terms are below 32 before */
		int32_t weight_q24 = share_q16 >= 1 << (22 - from->shift)
			? 1 << 30
			: share_q16 << (8 + from->shift);
		struct triple dull = load_triple(from->ambient_q24);
		const int32_t *shine = add_light(from,
			positional ? towards : from->towards_q30,
			positional ? half : from->half_q30,
			load_triple(normal_q28), &dull, nothing, added);

		lit->dull[0] = mul_high_add(lit->dull[0], dull.x, weight_q24);
		lit->dull[1] = mul_high_add(lit->dull[1], dull.y, weight_q24);
		lit->dull[2] = mul_high_add(lit->dull[2], dull.z, weight_q24);
		for (int i = 0; i < 3 && shine != nothing; i++) {
			lit->shine[i] = mul_high_add(
				lit->shine[i], shine[i] * 256, weight_q24);
		}
	}
}

/* Fetches a normal of any type, rotates and normalizes it; Q28, within +-8. */
static void find_any_normal(
	const struct draw *draw, uint32_t index, int32_t out[3])
{
	const struct shading *shading = &draw->shading;
	const int32_t *m = shading->normal_q28;
	int32_t n[3];

	soft_array_normal_q28(draw, index, out);
	memcpy(n, out, sizeof(n));
	for (int i = 0; i < 3 && shading->rotate_normals; i++) {
		int64_t sum = (int64_t)m[i] * n[0] + (int64_t)m[3 + i] * n[1] +
			(int64_t)m[6 + i] * n[2];

		/* a normal to be normalized may have any scale */
		out[i] = shading->normalize ? (int32_t)(sum >> 30)
					    : saturate_64(sum >> 28);
	}
	if (shading->normalize) {
		normalize(out);
		for (int i = 0; i < 3; i++) {
			out[i] >>= 2;
		}
	}
}

/* Lights a side, from weighted on by add_weighted(). */
static void light_any_side(const struct draw *draw, uint32_t index,
	const int32_t normal[3], const struct light_source *weighted,
	const int32_t color_q16[4], int32_t out[4])
{
	const struct shading *shading = &draw->shading;
	struct triple dull = load_triple(shading->ambient_q24);
	const int32_t *shine =
		add_lights(shading, weighted, load_triple(normal), &dull, out);
	const int32_t plain[3] = {dull.x, dull.y, dull.z};
	struct lit lit;

	add_weighted(draw, index, weighted, normal, &lit);
	for (int i = 0; i < 3; i++) {
		int64_t product = (int64_t)((plain[i] >> 8) + lit.dull[i]) *
			(color_q16[i] - (color_q16[i] >> 8));

		out[i] = to_attribute(
			saturate_64((product >> 16) + shine[i] + lit.shine[i]));
	}
	out[3] = to_attribute(color_q16[3]);
}

/* Lights a vertex of any types by any lights. */
static NEVER_INLINE void light_any(
	const struct draw *draw, struct vertex *vertex)
{
	const struct shading *shading = &draw->shading;
	const struct light_source *weighted = shading->weighted;
	const uint32_t index = vertex->index;
	int32_t color[4] = {65536, 65536, 65536, shading->alpha_q16};
	int32_t normal[3];

	find_any_normal(draw, index, normal);
	/* Long normals need the room that weighted sums have. */
	if (!is_in_range(shading, load_triple(normal))) {
		weighted = shading->light_source;
	}
	if (shading->tracked) {
		soft_array_color_q16(draw, index, color);
	}
	light_any_side(
		draw, index, normal, weighted, color, vertex->attribute + RED);
	if (shading->two_side) {
		for (int i = 0; i < 3; i++) {
			normal[i] = -normal[i];
		}
		light_any_side(
			draw, index, normal, weighted, color, vertex->back);
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
