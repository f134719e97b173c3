/*
 * The attributes of vertices: colours, fog and texture coordinates. Lighting as
 * most is wanted is here too, see struct dir_lights: normals of Q28, their
 * cosines with lights Q26, diffuse light Q24, what highlights add Q16.
 */
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

#include <string.h>

/* A normal or a colour, in registers. */
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
 * To unit length, from halves: c is (2 c + 1) / 65535. Their sum of squares is
 * a quarter of the length's, within 2^-9 where any is 256 or more.
 */
static ALWAYS_INLINE struct triple normalize_shorts(
	const struct dir_lights *light, const void *at)
{
	int32_t x = load_short(at), y = load_short((const char *)at + 2);
	int32_t z = load_short((const char *)at + 4);
	/* Below 2^32: three of at most 2^30. */
	uint32_t square =
		1 + (uint32_t)(x * x) + (uint32_t)(y * y) + (uint32_t)(z * z);
	int zeros = LEADING_ZEROS_32(square) & ~1;
	uint32_t v = square << zeros; /* 0.25..1 in Q32 */
	uint32_t r = (uint32_t)light->roots[(v >> 24) - 64] << 13; /* Q28 */
	uint32_t product_q24 = mul_high_unsigned(mul_high_unsigned(r, r), v);
	/* |2 c + 1| << zeros / 2 is below 2^17. */
	int32_t up = 1 << (14 + zeros / 2), root;

	/* r (3 - v r^2) / 2: 7 bits become 14; Q29. */
	root = (int32_t)(mul_high_unsigned(r, (3u << 24) - product_q24) << 8);
	return (struct triple){mul_high((2 * x + 1) * up, root),
		mul_high((2 * y + 1) * up, root),
		mul_high((2 * z + 1) * up, root)};
}

/* Q28; what is no number is 0. What is too large has a square of 4 or more. */
static ALWAYS_INLINE int32_t take_float(float value)
{
	if (value >= 2.0f || value <= -2.0f) {
		return INT32_MAX;
	}
	return value == value ? (int32_t)(value * 268435456.0f) : 0;
}

/* Adds to what highlights there were, at shine, and puts the sum at out. */
static ALWAYS_INLINE const int32_t *add_highlight(
	const struct dir_light *light_source, struct triple n,
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

/* Of a colour of four bytes, the first one lowest. */
static ALWAYS_INLINE void light_side(const struct dir_lights *light,
	struct triple n, uint32_t color, int32_t out[4])
{
	struct triple dull = load_triple(light->ambient_q24);
	const int32_t *shine = light->emission_q16;
	uint32_t red_blue, green_alpha;

	for (const struct dir_light *light_source = light->dir_light;
		light_source != light->end; light_source++) {
		int32_t towards_q26 = dot(light_source->towards_q30, n);

		if (towards_q26 <= 0) {
			continue;
		}
		add_scaled(&dull, towards_q26, light_source->diffuse_q30);
		if (light_source->step) {
			shine = add_highlight(light_source, n, shine, out);
		}
	}
	red_blue = BYTES_AS_HALVES(color);
	green_alpha = ODD_BYTES_AS_HALVES(color);
	out[0] = to_attribute(MULTIPLY_ADD_HALF(shine[0], dull.x, red_blue));
	out[1] = to_attribute(MULTIPLY_ADD_HALF(shine[1], dull.y, green_alpha));
	out[2] = to_attribute(
		MULTIPLY_ADD_HALF(shine[2], dull.z, red_blue >> 16));
	out[3] = 128 + (int32_t)(green_alpha >> 16 << 8);
}

/* Q28; false where struct dir_lights does not take it. */
static ALWAYS_INLINE bool take_floats(
	const struct dir_lights *light, const float f[3], struct triple *n)
{
	int32_t square;

	*n = (struct triple){
		take_float(f[0]), take_float(f[1]), take_float(f[2])};
	square = mul_high(n->x, n->x);
	square = mul_high_add(square, n->y, n->y);
	square = mul_high_add(square, n->z, n->z);
	return (uint32_t)square - light->square_least < light->square_range;
}

/* The lit colour of a side; false where the normal is not for it. */
static ALWAYS_INLINE bool light_by_dir_lights(const struct dir_lights *light,
	uint32_t index, bool back, int32_t out[4])
{
	const uint8_t *normal =
		light->normals + index * (size_t)light->normal_stride;
	const uint8_t *color =
		light->colors + index * (size_t)light->color_stride;
	uint32_t bytes;
	struct triple n;

	/* The colour comes from memory while the normal is made ready. */
	memcpy(&bytes, color, sizeof(bytes));
	PRELOAD(normal + 40);
	if (!light->floats) {
		n = normalize_shorts(light, normal);
	} else if (!take_floats(light, (const float *)(const void *)normal, &n)) {
		return false;
	}
	if (back) {
		n = (struct triple){-n.x, -n.y, -n.z};
	}
	light_side(light, n, bytes, out);
	return true;
}

static NEVER_INLINE void light_back(
	const struct dir_lights *light, struct vertex *vertex)
{
	light_by_dir_lights(light, vertex->index, true, vertex->back);
}

static int32_t fog_share_q16(const struct draw *draw, int32_t distance_q16)
{
	const struct fog *fog = &draw->soft->fog;
	int64_t thickness_q16 = (int64_t)fog->density * distance_q16 >> 16;

	if (fog->mode == GL_LINEAR) {
		/* |difference| < 2^32, |scale| <= 2^29 */
		return saturate_64(((int64_t)draw->fog_end_q16 - distance_q16) *
				draw->fog_scale >>
			draw->fog_scale_q);
	}
	if (fog->mode == GL_EXP2) {
		thickness_q16 = saturate_64(thickness_q16);
		thickness_q16 = thickness_q16 * thickness_q16 >> 16;
	}
	/* 1/e in Q28 */
	return soft_power_q28(98749918, saturate_64(thickness_q16)) >> 12;
}

/* The share of the fragment's own colour, like a colour. */
static NEVER_INLINE int32_t find_fog(
	const struct draw *draw, const struct vertex *vertex)
{
	int32_t eye[3];

	soft_light_find_eye(draw, vertex->index, eye);
	return to_attribute(fog_share_q16(draw, eye[2] < 0 ? -eye[2] : eye[2]));
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
		/* So that differences fit 32 bits. */
		out[i] = clamp_int(out[i], -(1 << 30), 1 << 30);
	}
}

static ALWAYS_INLINE int32_t scale_short(
	const struct texture_input *input, int i, int16_t value)
{
	int64_t sum = (int64_t)input->matrix[i][i] * value + input->matrix[i][2];

	return (int32_t)(sum >> (input->matrix_q - 16));
}

static ALWAYS_INLINE void find_texcoord(
	const struct draw *draw, int unit, struct vertex *vertex)
{
	const struct texture_input *input = &draw->texture[unit];
	const uint8_t *at = input->array->pointer +
		(size_t)vertex->index * (size_t)input->array->stride_bytes;
	int32_t *out = vertex->attribute + TEX_S + 2 * unit;
	uint32_t bits[2];
	int16_t shorts[2];
	float st[2];

	if (input->kind == TEXCOORD_FLOATS) {
		PRELOAD(at + 40);
		memcpy(bits, at, sizeof(bits));
		/* Below 2^14, as the bits of 2^14 tell, without their signs. */
		if (bits[0] << 1 < 0x8D000000 && bits[1] << 1 < 0x8D000000) {
			memcpy(st, bits, sizeof(st));
			out[0] = (int32_t)(st[0] * 65536.0f);
			out[1] = (int32_t)(st[1] * 65536.0f);
			return;
		}
	} else if (input->kind == TEXCOORD_SHORTS) {
		memcpy(shorts, at, sizeof(shorts));
		out[0] = scale_short(input, 0, shorts[0]);
		out[1] = scale_short(input, 1, shorts[1]);
		return;
	}
	find_any_texcoord(draw, unit, vertex->index, out);
}

static NEVER_INLINE void find_any_color(
	const struct draw *draw, struct vertex *vertex)
{
	int32_t color[4];

	soft_array_color_q16(draw, vertex->index, color);
	for (int i = 0; i < 4; i++) {
		vertex->attribute[i] = to_attribute(color[i]);
	}
}

/* Bytes become what to_attribute() makes of them, or one below. */
static ALWAYS_INLINE void find_color(
	const struct draw *draw, struct vertex *vertex)
{
	const struct array *array = &draw->soft->arrays.color;
	const uint8_t *at = array->pointer +
		(size_t)vertex->index * (size_t)array->stride_bytes;

	if (!array->enabled || array->type != GL_UNSIGNED_BYTE) {
		find_any_color(draw, vertex);
		return;
	}
	for (int i = 0; i < 4; i++) {
		vertex->attribute[i] = at[i] << 8 | 128;
	}
}

static ALWAYS_INLINE void shade_rest(
	const struct draw *draw, struct vertex *vertex)
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

void soft_shade_rest(const struct draw *draw, struct vertex *vertex)
{
	shade_rest(draw, vertex);
}

void soft_shade_vertex(
	const struct draw *draw, struct vertex *vertex, uint32_t index)
{
	vertex->shaded = true;
	if (!draw->shading.lit) {
		find_color(draw, vertex);
	} else if (!draw->shading.by_dir_lights ||
		!light_by_dir_lights(&draw->dir_lights, index, false,
			vertex->attribute + RED)) {
		soft_light(draw, vertex);
	}
	if (draw->shade_more) {
		if (draw->shading.by_dir_lights && draw->shading.two_side) {
			light_back(&draw->dir_lights, vertex);
		}
		shade_rest(draw, vertex);
	}
}

void soft_shade(const struct draw *draw, struct vertex *vertex)
{
	if (!vertex->shaded && draw->attributes != 0) {
		soft_shade_vertex(draw, vertex, vertex->index);
	}
}
