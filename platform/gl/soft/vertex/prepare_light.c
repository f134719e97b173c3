/*
 * Lights as vertices meet them.
 *
 * Where the model-view matrix keeps angles and the lights are directional,
 * they are turned into the normals' space instead of every normal into
 * theirs: n_eye . l = (N n) . l = n . (transpose(N) l). Otherwise normals are
 * rotated and lights stay in eye space.
 */
#include "platform/gl/soft/state/matrix.h"
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

#include <string.h>

#include "platform/base/scalar.h"

static const float two_28 = 268435456.0f;

static void normalize(float v[3])
{
	float length = scalar_sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);

	for (int i = 0; i < 3 && length > 0.0f; i++) {
		v[i] /= length;
	}
}

/* Directions of up to 4 times unit length. */
static void to_q28(const float v[3], int32_t out[3])
{
	for (int i = 0; i < 3; i++) {
		out[i] = soft_matrix_to_int(v[i] * two_28);
	}
}

/* transpose(m) v, both column-major 3x3; m NULL changes nothing. */
static void turn(const float *m, const float v[3], int32_t out_q28[3])
{
	float turned[3];

	for (int i = 0; i < 3; i++) {
		turned[i] = m ? m[3 * i] * v[0] + m[3 * i + 1] * v[1] +
				m[3 * i + 2] * v[2]
			      : v[i];
	}
	to_q28(turned, out_q28);
}

/* material times light: 16.16 each; shift more places. */
static int32_t product(GLfixed a, GLfixed b, int shift)
{
	int64_t all = (int64_t)a * b;

	return saturate_64(shift < 0 ? all >> -shift : all << shift);
}

static void prepare_positional(
	const struct light *light, struct light_source *light_source)
{
	float direction[3];

	light_source->positional = true;
	light_source->spot = light->cutoff != 180 * 65536;
	for (int i = 0; i < 3; i++) {
		light_source->position_q16[i] = soft_matrix_to_int(
			light->position[i] / light->position[3] * 65536.0f);
		light_source->attenuation_q16[i] = light->attenuation[i];
	}
	memcpy(direction, light->direction, sizeof(direction));
	normalize(direction);
	to_q28(direction, light_source->direction_q28);
	light_source->cutoff_q28 =
		(int32_t)(scalar_cos((float)light->cutoff / 65536.0f *
				  (SCALAR_PI / 180.0f)) *
			two_28);
	light_source->exponent_q16 = light->exponent;
}

static void prepare_directional(const struct light *light, const float *normal,
	struct light_source *light_source)
{
	float towards[3], half[3];

	memcpy(towards, light->position, sizeof(towards));
	normalize(towards);
	memcpy(half, towards, sizeof(half));
	half[2] += 1.0f; /* the viewer is infinitely far along z */
	normalize(half);
	turn(normal, towards, light_source->towards_q28);
	turn(normal, half, light_source->half_q28);
}

/* What is tracked by vertex comes later; else the current colour is known. */
static const GLfixed *choose_color(const struct soft *soft,
	const struct shading *shading, const GLfixed *material)
{
	static const GLfixed whole[4] = {65536, 65536, 65536, 65536};

	if (shading->tracked) {
		return whole;
	}
	return soft->lighting.color_material ? soft->arrays.current_color
					     : material;
}

static void prepare_light_source(const struct soft *soft,
	const struct light *light, const float *normal, struct shading *shading)
{
	struct light_source *light_source =
		&shading->light_source[shading->light_source_count++];
	const struct material *material = &soft->lighting.material;
	const GLfixed *diffuse = choose_color(soft, shading, material->diffuse);
	const GLfixed *ambient = choose_color(soft, shading, material->ambient);

	*light_source = (struct light_source){0};
	for (int i = 0; i < 3; i++) {
		light_source->diffuse_q22[i] =
			product(diffuse[i], light->diffuse[i], -10);
		light_source->specular_q20[i] =
			product(material->specular[i], light->specular[i], -12);
		light_source->ambient_q16[i] = shading_bound(
			product(ambient[i], light->ambient[i], -16));
		light_source->specular |= light_source->specular_q20[i] != 0;
	}
	if (light->position[3] != 0.0f) {
		prepare_positional(light, light_source);
	} else {
		prepare_directional(light, normal, light_source);
	}
	if (!light_source->positional) {
		/* No distance to fade with: into the base at once. */
		for (int i = 0; i < 3; i++) {
			shading->ambient_q16[i] += light_source->ambient_q16[i];
		}
	}
}

static bool has_positional(const struct lighting *lighting)
{
	for (int i = 0; i < SOFT_LIGHTS; i++) {
		if (lighting->light[i].enabled &&
			lighting->light[i].position[3] != 0.0f) {
			return true;
		}
	}
	return false;
}

/*
 * The matrix for normals, in normal_q28 where they are to be rotated; what is
 * to turn the lights otherwise, in turned. Whole is the scale put in.
 */
static bool prepare_normals(
	const struct soft *soft, struct draw *draw, float turned[9])
{
	const struct lighting *lighting = &soft->lighting;
	const struct matrix *m = soft->matrices.modelview_stack.top;
	struct shading *shading = &draw->shading;
	float scale = soft_matrix_uniform_scale(m);
	float factor = 1.0f;

	soft_matrix_normal(m, turned);
	shading->normalize = lighting->normalize;
	shading->rotate_normals = draw->eye_needed || scale == 0.0f;
	if (scale != 0.0f && (lighting->normalize || lighting->rescale)) {
		factor = scale;
	} else if (lighting->normalize || lighting->rescale) {
		float most = 0.0f;

		/* Any length does; the normals' own is found by vertex. */
		for (int i = 0; i < 9; i++) {
			float value = scalar_abs(turned[i]);

			most = value > most ? value : most;
		}
		factor = lighting->normalize && most > 0.0f ? 1.0f / most : 1.0f;
	}
	for (int i = 0; i < 9; i++) {
		turned[i] *= factor;
		shading->normal_q28[i] = soft_matrix_to_int(turned[i] * two_28);
	}
	return !shading->rotate_normals;
}

static void prepare_base(const struct soft *soft, struct shading *shading)
{
	const struct lighting *lighting = &soft->lighting;
	const struct material *material = &lighting->material;
	const GLfixed *ambient = choose_color(soft, shading, material->ambient);

	for (int i = 0; i < 3; i++) {
		shading->emission_q16[i] = shading_bound(material->emission[i]);
		shading->ambient_q16[i] = shading_bound(
			product(ambient[i], lighting->ambient[i], -16));
	}
	shading->base_q16[3] = choose_color(soft, shading, material->diffuse)[3];
	shading->shininess_q16 = material->shininess;
}

void soft_prepare_shading(const struct soft *soft, struct draw *draw)
{
	const struct lighting *lighting = &soft->lighting;
	struct shading *shading = &draw->shading;
	float normal[9];
	bool turn_lights;

	shading->lit = lighting->enabled;
	shading->two_side = lighting->enabled && lighting->two_side;
	shading->tracked =
		lighting->color_material && soft->arrays.color.enabled;
	shading->by_dir_lights = false;
	shading->color_array = soft->arrays.color.enabled;
	shading->light_source_count = 0;
	draw->eye_needed = false;
	if (!shading->lit) {
		return;
	}
	draw->eye_needed = has_positional(lighting);
	turn_lights = prepare_normals(soft, draw, normal);
	prepare_base(soft, shading);
	for (int i = 0; i < SOFT_LIGHTS; i++) {
		if (lighting->light[i].enabled) {
			prepare_light_source(soft, &lighting->light[i],
				turn_lights ? normal : NULL, shading);
		}
	}
	soft_prepare_dir_lights(soft, draw);
}
