/*
 * Derives struct shading from lights and materials.
 *
 * Where the model-view matrix keeps angles and all lights are directional, the
 * lights are transformed to the normals' space, instead of every normal to eye
 * space: n_eye . l = (N n) . l = n . (transpose(N) l). Otherwise normals are
 * rotated and lights stay in eye space.
 */
#include "platform/gl/soft/state/matrix.h"
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

#include <string.h>

#include "platform/base/scalar.h"

enum {
	ONE_Q16 = 1 << 16,
	SHIFT_MOST = 9, /* colours beyond 1024 are cut */
};

static const float two_28 = 268435456.0f;

/* transpose(m) v, in Q30; m is a column-major 3x3, or NULL for the identity. */
static void turn(const float *m, const float v[3], int32_t out_q30[3])
{
	for (int i = 0; i < 3; i++) {
		float turned = m ? m[3 * i] * v[0] + m[3 * i + 1] * v[1] +
				m[3 * i + 2] * v[2]
				 : v[i];

		out_q30[i] = clamp_int(soft_matrix_to_int(turned * two_28),
				     1 - (1 << 29), (1 << 29) - 1) *
			4;
	}
}

static void make_spec_table(struct spec_table *spec_table, int32_t shininess_q16)
{
	int32_t least_q28 = 0, range_q28, value = 0;

	if (shininess_q16 >= ONE_Q16) {
		/* x^s is 2^-10 at 2^(-10 / s). */
		least_q28 = soft_power_q28(
			1 << 18, (int32_t)(((int64_t)1 << 32) / shininess_q16));
	} else if (shininess_q16 == 0) {
		value = 1 << 28;
	}
	range_q28 = (1 << 28) - least_q28;
	spec_table->shininess_q16 = shininess_q16;
	spec_table->least_q26 = least_q28 >> 2;
	spec_table->scale = soft_matrix_to_int(
		(float)(1 << 20) * (float)(1 << 28) / (float)range_q28);
	for (int i = 0; i < SPEC_TABLE_STEPS; i++) {
		int32_t next = soft_power_q28(
			least_q28 + range_q28 / SPEC_TABLE_STEPS * (i + 1),
			shininess_q16);

		spec_table->step[i].value_q28 = value;
		spec_table->step[i].rise_q28 = (next - value) >> 8;
		value = next;
	}
}

/*
 * Scales a position so that its difference from a vertex's, less than 2^28 in
 * draw->eye_q, is below 2^30.
 */
static void prepare_place(const struct draw *draw, const struct light *light,
	struct light_source *source)
{
	float place[3];
	int q;

	for (int i = 0; i < 3; i++) {
		place[i] = light->position[i] / light->position[3];
	}
	q = 28 - soft_matrix_exponent(soft_matrix_largest(place, 3));
	source->position_q = q < draw->eye_q ? q : draw->eye_q;
	/* beyond 31 the vertices are in the same place, as seen from the light */
	source->eye_shift = clamp_int(draw->eye_q - source->position_q, 0, 31);
	for (int i = 0; i < 3; i++) {
		int32_t at = soft_matrix_to_int(place[i] *
			soft_matrix_power_of_two(source->position_q));

		/* only infinite numbers are larger */
		source->position[i] = clamp_int(at, -(1 << 29), 1 << 29);
	}
}

static void prepare_spot(const struct light *light, struct light_source *source)
{
	float direction[3];

	source->spot = light->cutoff != 180 * ONE_Q16;
	if (!source->spot) {
		return;
	}
	memcpy(direction, light->direction, sizeof(direction));
	soft_matrix_normalize(direction);
	for (int i = 0; i < 3; i++) {
		source->direction_q28[i] =
			soft_matrix_to_int(direction[i] * two_28);
	}
	source->cutoff_q26 = (int32_t)(scalar_cos((float)light->cutoff /
					       65536.0f * (SCALAR_PI / 180.0f)) *
		two_28 / 4.0f);
	source->exponent_q16 = light->exponent;
}

/* Finds what vertices get of a light, as far as that is the same for all. */
static void prepare_share(const struct light *light, struct light_source *source)
{
	const GLfixed *attenuation = light->attenuation;
	int32_t towards_q30[3];

	source->share_q16 = ONE_Q16;
	if (light->position[3] != 0.0f) {
		source->positional = source->weighted = true;
		source->fades = attenuation[1] != 0 || attenuation[2] != 0;
		source->share_q16 = soft_light_fade(attenuation, 0);
		memcpy(source->attenuation_q16, attenuation,
			sizeof(source->attenuation_q16));
	} else if (source->spot) { /* it does not fade: section 2.12.1 */
		turn(NULL, light->towards, towards_q30);
		source->share_q16 =
			soft_light_spot(source, towards_q30, ONE_Q16);
		source->weighted = true;
	}
}

/* The material's colour, or the current one; 1 if vertices have their own. */
static const GLfixed *choose_color(const struct soft *soft,
	const struct shading *shading, const GLfixed *material)
{
	static const GLfixed whole[4] = {ONE_Q16, ONE_Q16, ONE_Q16, ONE_Q16};

	if (shading->tracked) {
		return whole;
	}
	return soft->lighting.color_material ? soft->arrays.current_color
					     : material;
}

/* Adds ambient light, times 257/256; within +-64, to which 8 lights add 32. */
static void add_ambient(struct shading *shading, int i, int64_t color_q16)
{
	const int64_t sum = shading->ambient_q24[i] + color_q16 * 257;

	shading->ambient_q24[i] =
		clamp_int(saturate_64(sum), -(1 << 30), 1 << 30);
}

/* material times light, Q32; ORs the magnitudes of all into *sizes. */
static void multiply_colors(const GLfixed *material, const GLfixed *light,
	int64_t out[3], uint64_t *sizes)
{
	for (int i = 0; i < 3; i++) {
		out[i] = (int64_t)material[i] * light[i];
		*sizes |= (uint64_t)(out[i] ^ (out[i] >> 63));
	}
}

static void prepare_colors(const struct soft *soft, const struct light *light,
	struct shading *shading, struct light_source *source)
{
	const struct material *material = &soft->lighting.material;
	int64_t diffuse[3], ambient[3], specular[3];
	uint64_t sizes = 1;
	int shift, ambient_shift;

	multiply_colors(choose_color(soft, shading, material->diffuse),
		light->diffuse, diffuse, &sizes);
	multiply_colors(choose_color(soft, shading, material->ambient),
		light->ambient, ambient, &sizes);
	multiply_colors(material->specular, light->specular, specular, &sizes);
	shift = clamp_int(31 - LEADING_ZEROS_64(sizes), 0, SHIFT_MOST);
	source->shift = shift;
	/* the weight has the factor of normals, which ambient light has not */
	ambient_shift = 16 + shift + shading->normal_shift;
	for (int i = 0; i < 3 && shift != 0; i++) {
		diffuse[i] >>= shift;
		specular[i] >>= shift;
	}
	for (int i = 0; i < 3; i++) {
		source->diffuse_q30[i] = saturate_64((diffuse[i] >> 10) * 257);
		source->specular_q20[i] = clamp_int(
			saturate_64(specular[i] >> 12), -(1 << 21), 1 << 21);
		if (source->weighted) {
			source->ambient_q24[i] = saturate_64(
				(ambient[i] >> ambient_shift) * 257);
		} else {
			/* without a weight it is the same for all vertices */
			add_ambient(shading, i, ambient[i] >> 16);
		}
	}
	source->shift += shading->normal_shift;
	source->weighted |= source->shift != 0;
}

static void prepare_light_source(const struct soft *soft, struct draw *draw,
	const struct light *light, struct light_source *source)
{
	const int32_t *specular = source->specular_q20;

	*source = (struct light_source){.light = light};
	prepare_spot(light, source);
	prepare_share(light, source);
	prepare_colors(soft, light, &draw->shading, source);
	if (specular[0] | specular[1] | specular[2]) {
		struct spec_table *spec_table = &draw->spec_table;
		int32_t shininess = soft->lighting.material.shininess;

		if (spec_table->scale == 0 ||
			spec_table->shininess_q16 != shininess) {
			make_spec_table(spec_table, shininess);
		}
		source->least_q26 = spec_table->least_q26;
		source->scale = spec_table->scale;
		source->step = spec_table->step;
	}
}

/* What GL multiplies normals by, or any scale where vertices normalize them. */
static float find_factor(
	const struct lighting *lighting, float scale, const float turned[9])
{
	const float *third = turned + 6;
	float size = 1.0f;

	if (scale != 0.0f && (lighting->normalize || lighting->rescale)) {
		return scale;
	}
	if (lighting->normalize) {
		size = soft_matrix_largest(turned, 9);
	} else if (lighting->rescale) { /* section 2.11.3 */
		size = scalar_sqrt(third[0] * third[0] + third[1] * third[1] +
			third[2] * third[2]);
	}
	return size > 0.0f ? 1.0f / size : 1.0f;
}

/*
 * Finds the matrix of normals, scaled for GL_NORMALIZE or GL_RESCALE_NORMAL: in
 * normal_q28 to rotate normals by, and in turned to transform lights by.
 */
void soft_prepare_normals(struct soft *soft, struct draw *draw)
{
	const struct lighting *lighting = &soft->lighting;
	const struct matrix *m = soft->matrices.stack[STACK_MODELVIEW].top;
	struct shading *shading = &draw->shading;
	float scale = soft_matrix_uniform_scale(m), factor;
	float *turned = shading->turned;
	int shift = 0;

	soft_matrix_normal(m, turned);
	shading->normalize = lighting->normalize;
	factor = find_factor(lighting, scale, turned);
	/* Directions of transformed lights must be shorter than 2. */
	shading->rotate_normals =
		draw->eye_needed || scale == 0.0f || factor > 1.9f * scale;
	if (shading->rotate_normals && !shading->normalize) {
		/* The matrix's elements must be below 4. */
		shift = clamp_int(soft_matrix_exponent(factor *
					  soft_matrix_largest(turned, 9)) -
				1,
			0, SHIFT_MOST);
		factor *= soft_matrix_power_of_two(-shift);
	}
	/* lights make up for it */
	soft->changed |= shading->normal_shift != shift ? GROUP_LIGHTING : 0;
	shading->normal_shift = shift;
	/* Normals of back faces point the other way: section 2.12.1. */
	factor = shading->back_only ? -factor : factor;
	for (int i = 0; i < 9; i++) {
		turned[i] *= factor;
		shading->normal_q28[i] = soft_matrix_to_int(turned[i] * two_28);
	}
}

static void prepare_base(const struct soft *soft, struct shading *shading)
{
	const struct lighting *lighting = &soft->lighting;
	const struct material *material = &lighting->material;
	const GLfixed *ambient = choose_color(soft, shading, material->ambient);

	for (int i = 0; i < 3; i++) {
		shading->emission_q16[i] = clamp_int(
			material->emission[i], -16 * ONE_Q16, 16 * ONE_Q16);
		shading->ambient_q24[i] = 0;
		add_ambient(shading, i,
			(int64_t)ambient[i] * lighting->ambient[i] >> 16);
	}
	shading->alpha_q16 = choose_color(soft, shading, material->diffuse)[3];
	memset(shading->color, 255, 3);
	shading->color[3] = (uint8_t)soft_byte(shading->alpha_q16);
}

void soft_prepare_lit_arrays(struct soft *soft, struct draw *draw)
{
	const struct array *normal = &soft->arrays.normal;
	const struct array *color = &soft->arrays.color;
	struct shading *shading = &draw->shading;
	const uintptr_t places =
		(uintptr_t)normal->pointer | (uintptr_t)normal->stride_bytes;
	const bool shorts = normal->type == GL_SHORT && shading->normalize;

	shading->floats = normal->type == GL_FLOAT && places % 4 == 0;
	shading->fast = shading->weighted == shading->end && normal->enabled &&
		(shorts || shading->floats) && !shading->rotate_normals &&
		(!shading->tracked || color->type == GL_UNSIGNED_BYTE);
	shading->normals = normal->pointer;
	shading->normal_stride = normal->stride_bytes;
	/* lengths within 2^-10 of 1; without GL_NORMALIZE any below 2 */
	shading->square_least = shading->normalize ? (1u << 24) - (1u << 15) : 0;
	shading->square_range = shading->normalize ? 1u << 16 : 1u << 26;
	shading->colors = shading->tracked ? color->pointer : shading->color;
	shading->color_stride = shading->tracked ? color->stride_bytes : 0;
}

/* Takes the light at end in: weighted ones stay behind the others. */
static void take_light_source(struct shading *shading)
{
	struct light_source *added = shading->end++;

	if (!added->weighted) {
		struct light_source *first = shading->weighted++;

		if (first != added) {
			const struct light_source moved = *first;

			*first = *added;
			*added = moved;
		}
	}
}

/* Finds the same lights' colours anew; false where one has a weight. */
static bool prepare_same(const struct soft *soft, struct shading *shading)
{
	struct light_source *at = shading->light_source;

	prepare_base(soft, shading);
	for (; at != shading->weighted; at++) {
		prepare_colors(soft, at->light, shading, at);
		if (at->weighted) {
			return false;
		}
	}
	return at == shading->end;
}

/* Finds the lights and their colours; directions are found on their own. */
void soft_prepare_sources(struct soft *soft, struct draw *draw)
{
	const struct lighting *lighting = &soft->lighting;
	struct shading *shading = &draw->shading;

	shading->tracked =
		lighting->color_material && soft->arrays.color.enabled;
	if (!(soft->changed & GROUP_LIGHTING) && prepare_same(soft, shading)) {
		return;
	}
	soft->changed |= GROUP_LIGHTING;
	prepare_base(soft, shading);
	shading->weighted = shading->end = shading->light_source;
	for (int i = 0; i < SOFT_LIGHTS; i++) {
		if (lighting->light[i].enabled) {
			prepare_light_source(
				soft, draw, &lighting->light[i], shading->end);
			take_light_source(shading);
		}
	}
}

void soft_prepare_directions(struct soft *soft, struct draw *draw)
{
	const struct shading *shading = &draw->shading;
	const float *turned = shading->rotate_normals ? NULL : shading->turned;

	(void)soft;
	for (struct light_source *at = draw->shading.light_source;
		at != shading->end; at++) {
		if (at->positional) {
			prepare_place(draw, at->light, at);
		} else {
			turn(turned, at->light->towards, at->towards_q30);
			turn(turned, at->light->half, at->half_q30);
		}
	}
}

/* Points and lines have no back. */
void soft_prepare_sides(struct soft *soft, struct draw *draw)
{
	struct shading *shading = &draw->shading;
	const bool both = soft->lighting.enabled && soft->lighting.two_side;
	const bool back_only = both && draw->cull_front;

	shading->lit = soft->lighting.enabled;
	shading->two_side = both && !draw->cull_front && !draw->cull_back &&
		draw->primitive == GL_TRIANGLES;
	/* it turns normals */
	soft->changed |= shading->back_only != back_only ? GROUP_LIGHTING : 0;
	shading->back_only = back_only;
}
