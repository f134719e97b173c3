/* The soft driver's vertices: lit as in double. */
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"
#include "tests/support/gl/gl_expect.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
	VERTICES = 64
};

/* What arrays hold, and one specular table for all. */
struct lit_mesh {
	int16_t halves[VERTICES][4];
	float floats[VERTICES][3];
	uint8_t color[VERTICES][4];
	float texcoord[VERTICES][2];
	struct spec_table_step step[SPEC_TABLE_STEPS];
};

static void fill_mesh(struct lit_mesh *mesh, uint32_t *seed)
{
	for (int i = 0; i < VERTICES; i++) {
		float most = i % 3 ? 0.6f : 1.9999999f;

		for (int j = 0; j < 3; j++) {
			int16_t any = (int16_t)random_within(seed, 32767);

			mesh->halves[i][j + 1] = i < 2 ? INT16_MIN
				: i < 4                ? INT16_MAX
				: i < 6                ? (int16_t)(i - 5)
				: i < 20               ? any >> 6
						       : any;
			mesh->floats[i][j] = most * (float)any / 32767.0f;
			mesh->color[i][j] = (uint8_t)next_random(seed);
		}
		mesh->color[i][3] = (uint8_t)next_random(seed);
	}
	mesh->floats[0][0] = 2.0f;
	mesh->floats[1][1] = -1e30f;
	mesh->floats[2][2] = NAN;
	mesh->floats[3][0] = INFINITY;
}

static void make_light_source(const struct lit_mesh *mesh,
	struct light_source *light_source, uint32_t *seed)
{
	int32_t most = next_random(seed) % 2 ? 620000000 : INT32_MAX - 1;

	for (int j = 0; j < 3; j++) {
		light_source->towards_q30[j] = random_within(seed, most / 2) * 2;
		light_source->half_q30[j] = random_within(seed, most / 2) * 2;
		light_source->diffuse_q30[j] = random_within(seed, 1 << 30);
		light_source->specular_q20[j] = random_within(seed, 1 << 20);
	}
	/* Up to 0.5, so that no table is steeper than twice a cosine. */
	light_source->least_q26 = abs(random_within(seed, 1 << 25)) & ~7;
	light_source->scale = (int32_t)fmin(INT32_MAX,
		ldexp(1, 46) / ((1 << 26) - light_source->least_q26 + 8));
	light_source->step = next_random(seed) % 2 ? mesh->step : NULL;
}

static void make_light(
	const struct lit_mesh *mesh, struct shading *light, uint32_t *seed)
{
	int light_sources = random_within(seed, 4) + 4;

	light->roots = soft_root_table;
	light->floats = next_random(seed) % 2;
	light->normals = light->floats ? (const uint8_t *)mesh->floats
				       : (const uint8_t *)&mesh->halves[0][1];
	light->normal_stride = light->floats ? 12 : 8;
	light->colors = mesh->color[0];
	light->color_stride = next_random(seed) % 2 ? 4 : 0;
	light->two_side = next_random(seed) % 2;
	light->square_least = next_random(seed) % 2 << 23;
	light->square_range = light->square_least ? 1u << 24 : 1u << 26;
	for (int i = 0; i < 3; i++) {
		light->ambient_q24[i] = random_within(seed, 1 << 25);
		light->emission_q16[i] = random_within(seed, 1 << 16);
	}
	for (int i = 0; i < light_sources; i++) {
		make_light_source(mesh, &light->light_source[i], seed);
	}
	light->weighted = light->end = light->light_source + light_sources;
}

/* Untextured, or with coordinates of which some are too large. */
static void make_texture(
	struct lit_mesh *mesh, struct draw *draw, uint32_t *seed)
{
	struct texture_input *input = &draw->texture[0];

	input->used = next_random(seed) % 2;
	input->identity = true;
	input->plain_floats = true;
	input->array = &draw->soft->arrays.texcoord[0];
	for (int i = 0; i < 2 * VERTICES; i++) {
		mesh->texcoord[i / 2][i % 2] =
			ldexpf((float)random_within(seed, 1 << 20), i % 9 - 20);
	}
	mesh->texcoord[0][0] = 16383.999f;
	mesh->texcoord[1][1] = 16384.0f;
	mesh->texcoord[2][0] = -16384.0f;
	mesh->texcoord[3][1] = -1e20f;
	draw->soft->arrays.texcoord[0] = (struct array){
		.enabled = true,
		.size = 2,
		.type = GL_FLOAT,
		.stride_bytes = 8,
		.pointer = (const uint8_t *)mesh->texcoord,
	};
}

static void make_rest(const struct lit_mesh *mesh, struct draw *draw)
{
	draw->attributes = 15;
	draw->shading.lit = true;
	draw->shading.fast = true;
	draw->shade_more = true;
	draw->shading.alpha_q16 = 65536;
	draw->soft->arrays.normal = (struct array){
		.enabled = true,
		.size = 3,
		.type = GL_FLOAT,
		.stride_bytes = 12,
		.pointer = (const uint8_t *)mesh->floats,
	};
}

/* False where the normal is not lit the fast way, or it is too short to be exact. */
static bool find_normal(const struct shading *light,
	const struct lit_mesh *mesh, uint32_t index, double n[3])
{
	double square = 0;

	for (int i = 0; i < 3; i++) {
		n[i] = light->floats ? (double)mesh->floats[index][i]
				     : 2.0 * mesh->halves[index][i + 1] + 1;
		square += n[i] * n[i];
	}
	if (!light->floats) {
		for (int i = 0; i < 3; i++) {
			n[i] /= sqrt(square);
		}
		/* Short ones are only nearly of unit length. */
		return square > 4.0 * 8192 * 8192;
	}
	square *= 1 << 24;
	return fabs(n[0]) < 2 && fabs(n[1]) < 2 && fabs(n[2]) < 2 &&
		square > light->square_least + 1000.0 &&
		square < light->square_least + light->square_range - 1000.0;
}

/* A place in the table, whose values grow by as much from step to step. */
static double find_highlight(const struct light_source *light, double cosine)
{
	double place = (ldexp(cosine, 26) - light->least_q26) * light->scale;

	place = fmin(fmax(ldexp(place, -32), 0), (1 << 14) - 1);
	return ldexp(place, 14 - 28);
}

static double cosine_of(const int32_t a_q30[3], const double n[3])
{
	return ldexp(a_q30[0] * n[0] + a_q30[1] * n[1] + a_q30[2] * n[2], -30);
}

/* The colours of a side, of 0 to 255. */
static void expect_side(const struct shading *light, const double n[3],
	const uint8_t color[4], double out[3])
{
	for (int i = 0; i < 3; i++) {
		double dull = ldexp(light->ambient_q24[i], -24);
		double shine = ldexp(light->emission_q16[i], -16);

		for (const struct light_source *from = light->light_source;
			from != light->end; from++) {
			double towards = cosine_of(from->towards_q30, n);
			double half = cosine_of(from->half_q30, n);

			if (towards <= 0) {
				continue;
			}
			dull += towards * ldexp(from->diffuse_q30[i], -30);
			if (from->step) {
				shine += find_highlight(from, half) *
					ldexp(from->specular_q20[i], -20);
			}
		}
		shine += dull * color[i] / 256;
		out[i] = 255 * fmin(fmax(shine, 0), 1);
	}
}

static void check_side(const struct shading *light, const double n[3],
	const uint8_t color[4], const int32_t lit[4])
{
	double expected[3];

	expect_side(light, n, color, expected);
	for (int i = 0; i < 3; i++) {
		double got = (lit[i] - 128) / 256.0;

		if (fabs(got - expected[i]) > 1) {
			fail_msg("channel %d: %f, expected %f", i, got,
				expected[i]);
		}
	}
	assert_int_equal(lit[3], 128 + color[3] * 256);
}

static void check_texcoord(
	const struct draw *draw, const float st[2], const int32_t got[2])
{
	for (int i = 0; draw->texture[0].used && i < 2; i++) {
		double q16 = fmin(fmax(ldexp(st[i], 16), -(1 << 30)), 1 << 30);

		assert_true(fabs(got[i] - q16) < 1);
	}
}

static int check_lit(const struct draw *draw, const struct lit_mesh *mesh)
{
	const struct shading *light = &draw->shading;
	int lit = 0;

	for (uint32_t i = 0; i < VERTICES; i++) {
		const uint8_t *color = mesh->color[light->color_stride ? i : 0];
		struct vertex vertex = {.index = i};
		double n[3];

		soft_shade(draw, &vertex);
		assert_true(vertex.shaded);
		check_texcoord(
			draw, mesh->texcoord[i], vertex.attribute + TEX_S);
		if (!find_normal(light, mesh, i, n)) {
			continue;
		}
		check_side(light, n, color, vertex.attribute + RED);
		for (int j = 0; j < 3; j++) {
			n[j] = -n[j];
		}
		if (light->two_side) {
			check_side(light, n, color, vertex.back);
		}
		lit++;
	}
	return lit;
}

static void test_vertices_are_lit_as_in_double(void **state)
{
	struct lit_mesh *mesh =
		aligned_alloc(_Alignof(struct lit_mesh), sizeof(*mesh));
	struct soft *soft = calloc(1, sizeof(*soft));
	struct draw *draw = aligned_alloc(_Alignof(struct draw), sizeof(*draw));
	uint32_t seed = 3;
	int lit = 0;

	(void)state;
	assert_non_null(mesh);
	assert_non_null(soft);
	assert_non_null(draw);
	memset(mesh, 0, sizeof(*mesh));
	memset(draw, 0, sizeof(*draw));
	draw->soft = soft;
	for (int i = 0; i < SPEC_TABLE_STEPS; i++) {
		mesh->step[i].value_q28 = i << 22;
		mesh->step[i].rise_q28 = 1 << 14;
	}
	for (int round = 0; round < 1000; round++) {
		fill_mesh(mesh, &seed);
		make_light(mesh, &draw->shading, &seed);
		make_texture(mesh, draw, &seed);
		make_rest(mesh, draw);
		lit += check_lit(draw, mesh);
	}
	assert_true(lit > 1000 * VERTICES / 2);
	free(draw);
	free(soft);
	free(mesh);
}

/* A light 32000 units right of the vertices and 24000 above them. */
static void test_a_far_light_keeps_its_direction(void **state)
{
	static const GLfixed place[] = {16000 * 65536, 12000 * 65536, 0, 65536};
	static const GLfixed white[] = {65536, 65536, 65536, 65536};
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	(void)state;
	gl_canvas_set_up_light(gl);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_DIFFUSE, white);
	gl->Lightxv(GL_LIGHT0, GL_POSITION, place);
	gl->Normal3x(0, 65536, 0);
	gl->Translatex(-16000 * 65536, -12000 * 65536, 0);
	gl->MatrixMode(GL_PROJECTION);
	gl->Translatex(16000 * 65536, 12000 * 65536, 0);
	gl_canvas_draw_all(gl);
	gl_expect_color(&canvas, "far", 9, 9, (double[]){0.6, 0.6, 0.6});
	gl_canvas_end_frame(&canvas);
	gl_canvas_close(&canvas);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_vertices_are_lit_as_in_double),
		cmocka_unit_test(test_a_far_light_keeps_its_direction),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
