/* Whether struct beams takes a draw call's lights, and how. */
#include "platform/gl/soft/draw.h"
#include "platform/gl/soft/matrix.h"
#include "platform/gl/soft/number.h"

#include <string.h>

enum {
	ONE_Q22 = 1 << 22,
	ONE_Q16 = 1 << 16,
};

static void make_gleam(struct gleam *gleam, int32_t shininess_q16)
{
	/* x^s is 2^-10 at 2^(-10 / s). */
	int32_t inverse_q16 = (int32_t)(((int64_t)1 << 32) / shininess_q16);
	int32_t least_q28 = power_q28(1 << 18, inverse_q16);
	int32_t range_q28 = (1 << 28) - least_q28, value = 0;

	gleam->shininess_q16 = shininess_q16;
	gleam->least_q26 = least_q28 >> 2;
	gleam->scale = soft_matrix_to_int(
		(float)(1 << 20) * (float)(1 << 28) / (float)range_q28);
	for (int i = 0; i < GLEAM_STEPS; i++) {
		int32_t next =
			power_q28(least_q28 + range_q28 / GLEAM_STEPS * (i + 1),
				shininess_q16);

		gleam->step[i].value_q28 = value;
		gleam->step[i].rise_q28 = (next - value) >> 8;
		value = next;
	}
}

/* Tables are kept, as materials take turns. */
static const struct gleam *find_gleam(struct draw *draw, int32_t shininess_q16)
{
	struct gleam *gleam = draw->gleam;

	for (int i = 0; i < GLEAMS; i++) {
		if (gleam[i].shininess_q16 == shininess_q16) {
			return &gleam[i];
		}
	}
	gleam += draw->gleam_next;
	draw->gleam_next = (draw->gleam_next + 1) % GLEAMS;
	make_gleam(gleam, shininess_q16);
	return gleam;
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

/* Directions up to 2, colours below 2: sums of 8 lights fit, see beams.c. */
static bool takes_lamp(const struct lamp *lamp)
{
	return are_within(lamp->towards_q28, (1 << 29) - 1) &&
		are_within(lamp->half_q28, (1 << 29) - 1) &&
		are_within(lamp->diffuse_q22, ONE_Q22 * 15 / 8) &&
		are_within(lamp->specular_q20, ONE_Q22);
}

static bool takes_shading(const struct shading *shading)
{
	bool gleams = false;

	for (int i = 0; i < shading->lamp_count; i++) {
		if (!takes_lamp(&shading->lamp[i])) {
			return false;
		}
		gleams |= shading->lamp[i].specular;
	}
	return !shading->rotate_normals &&
		(!gleams || shading->shininess_q16 >= ONE_Q16) &&
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
	const struct shading *shading, struct beams *beams)
{
	beams->normals = arrays->normal.pointer;
	beams->normal_stride = arrays->normal.stride_bytes;
	beams->floats = arrays->normal.type == GL_FLOAT;
	/* Within 2^-10 of unit length, or any below 2. */
	beams->square_least = shading->normalize ? (1u << 24) - (1u << 15) : 0;
	beams->square_range = shading->normalize ? 1u << 16 : 1u << 26;
	if (shading->tracked) {
		beams->colors = arrays->color.pointer;
		beams->color_stride = arrays->color.stride_bytes;
		return;
	}
	memset(beams->color, 255, 3);
	beams->color[3] = (uint8_t)soft_byte(shading->base_q16[3]);
	beams->colors = beams->color;
	beams->color_stride = 0;
}

static void prepare_beam(
	const struct lamp *from, const struct gleam *gleam, struct beam *lamp)
{
	for (int i = 0; i < 3; i++) {
		lamp->towards_q30[i] = from->towards_q28[i] * 4;
		lamp->half_q30[i] = from->half_q28[i] * 4;
		lamp->diffuse_q30[i] = from->diffuse_q22[i] * 257;
		lamp->specular_q20[i] = from->specular_q20[i];
	}
	lamp->gleams = from->specular;
	if (from->specular) {
		lamp->least_q26 = gleam->least_q26;
		lamp->scale = gleam->scale;
		lamp->step = gleam->step;
	}
}

void soft_prepare_beams(const struct soft *soft, struct draw *draw)
{
	struct shading *shading = &draw->shading;
	struct beams *beams = &draw->beams;
	const struct gleam *gleam = NULL;

	shading->by_beams =
		takes_shading(shading) && takes_arrays(&soft->arrays, shading);
	if (!shading->by_beams) {
		return;
	}
	prepare_arrays(&soft->arrays, shading, beams);
	beams->two_side = shading->two_side;
	for (int i = 0; i < 3; i++) {
		beams->ambient_q24[i] = shading->ambient_q16[i] * 257;
		beams->emission_q16[i] = shading->emission_q16[i];
	}
	for (int i = 0; i < shading->lamp_count; i++) {
		const struct lamp *lamp = &shading->lamp[i];

		if (lamp->specular && !gleam) {
			gleam = find_gleam(draw, shading->shininess_q16);
		}
		prepare_beam(lamp, gleam, &beams->beam[i]);
	}
	beams->end = beams->beam + shading->lamp_count;
}
