/* Whether struct dir_lights takes a draw call's lights, and how. */
#include "platform/gl/soft/state/matrix.h"
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

#include <string.h>

enum {
	ONE_Q22 = 1 << 22,
	ONE_Q16 = 1 << 16,
};

static void make_spec_table(struct spec_table *spec_table, int32_t shininess_q16)
{
	/* x^s is 2^-10 at 2^(-10 / s). */
	int32_t inverse_q16 = (int32_t)(((int64_t)1 << 32) / shininess_q16);
	int32_t least_q28 = soft_power_q28(1 << 18, inverse_q16);
	int32_t range_q28 = (1 << 28) - least_q28, value = 0;

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

/* Tables are kept, as materials take turns. */
static const struct spec_table *find_spec_table(
	struct draw *draw, int32_t shininess_q16)
{
	struct spec_table *spec_table = draw->spec_table;

	for (int i = 0; i < SPEC_TABLES; i++) {
		if (spec_table[i].shininess_q16 == shininess_q16) {
			return &spec_table[i];
		}
	}
	spec_table += draw->spec_table_next++ % SPEC_TABLES;
	make_spec_table(spec_table, shininess_q16);
	return spec_table;
}

static bool are_within(const int32_t value[3], int32_t most)
{
	for (int i = 0; i < 3; i++) {
		if (value[i] < -most || value[i] > most) {
			return false;
		}
	}
	return true;
}

/* Directions up to 2, colours below 2: sums of 8 lights fit, see shade.c. */
static bool takes_light_source(const struct light_source *light_source)
{
	return are_within(light_source->towards_q28, (1 << 29) - 1) &&
		are_within(light_source->half_q28, (1 << 29) - 1) &&
		are_within(light_source->diffuse_q22, ONE_Q22 * 15 / 8) &&
		are_within(light_source->specular_q20, ONE_Q22);
}

static bool takes_shading(const struct shading *shading)
{
	bool spec_tables = false;

	for (int i = 0; i < shading->light_source_count; i++) {
		if (!takes_light_source(&shading->light_source[i])) {
			return false;
		}
		spec_tables |= shading->light_source[i].specular;
	}
	return !shading->rotate_normals &&
		(!spec_tables || shading->shininess_q16 >= ONE_Q16) &&
		are_within(shading->ambient_q16, 16 * ONE_Q16) &&
		are_within(shading->emission_q16, 16 * ONE_Q16);
}

static bool takes_arrays(
	const struct arrays *arrays, const struct shading *shading)
{
	const struct array *normal = &arrays->normal;
	uintptr_t places =
		(uintptr_t)normal->pointer | (uintptr_t)normal->stride_bytes;
	bool shorts = normal->type == GL_SHORT && shading->normalize;
	bool floats = normal->type == GL_FLOAT && places % 4 == 0;

	return normal->enabled && (shorts || floats) &&
		(!shading->tracked || arrays->color.type == GL_UNSIGNED_BYTE);
}

static void prepare_arrays(const struct arrays *arrays,
	const struct shading *shading, struct dir_lights *dir_lights)
{
	dir_lights->normals = arrays->normal.pointer;
	dir_lights->normal_stride = arrays->normal.stride_bytes;
	dir_lights->floats = arrays->normal.type == GL_FLOAT;
	/* Within 2^-10 of unit length, or any below 2. */
	dir_lights->square_least =
		shading->normalize ? (1u << 24) - (1u << 15) : 0;
	dir_lights->square_range = shading->normalize ? 1u << 16 : 1u << 26;
	if (shading->tracked) {
		dir_lights->colors = arrays->color.pointer;
		dir_lights->color_stride = arrays->color.stride_bytes;
		return;
	}
	memset(dir_lights->color, 255, 3);
	dir_lights->color[3] = (uint8_t)soft_byte(shading->base_q16[3]);
	dir_lights->colors = dir_lights->color;
	dir_lights->color_stride = 0;
}

static void prepare_dir_light(const struct light_source *from,
	const struct spec_table *spec_table, struct dir_light *light_source)
{
	for (int i = 0; i < 3; i++) {
		light_source->towards_q30[i] = from->towards_q28[i] * 4;
		light_source->half_q30[i] = from->half_q28[i] * 4;
		light_source->diffuse_q30[i] = from->diffuse_q22[i] * 257;
		light_source->specular_q20[i] = from->specular_q20[i];
	}
	light_source->step = NULL;
	if (spec_table) {
		light_source->least_q26 = spec_table->least_q26;
		light_source->scale = spec_table->scale;
		light_source->step = spec_table->step;
	}
}

void soft_prepare_dir_lights(const struct soft *soft, struct draw *draw)
{
	struct shading *shading = &draw->shading;
	struct dir_lights *dir_lights = &draw->dir_lights;

	shading->by_dir_lights =
		takes_shading(shading) && takes_arrays(&soft->arrays, shading);
	if (!shading->by_dir_lights) {
		return;
	}
	prepare_arrays(&soft->arrays, shading, dir_lights);
	dir_lights->two_side = shading->two_side;
	for (int i = 0; i < 3; i++) {
		dir_lights->ambient_q24[i] = shading->ambient_q16[i] * 257;
		dir_lights->emission_q16[i] = shading->emission_q16[i];
	}
	for (int i = 0; i < shading->light_source_count; i++) {
		const struct light_source *from = &shading->light_source[i];

		prepare_dir_light(from,
			from->specular
				? find_spec_table(draw, shading->shininess_q16)
				: NULL,
			&dir_lights->dir_light[i]);
	}
	dir_lights->end = dir_lights->dir_light + shading->light_source_count;
}
