/*
 * Vertices that a turn and a wave move by any part, against the formulas in
 * double, in float and in fixed point.
 */
#include "app/scene/instance/bend.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
	VERTICES = 200,
	SMOOTH = 14 /* places to either side between which a slope is taken */
};

static const float unit = 0.5f; /* vertex_scale */
static const struct fixed_placement placement = {
	.scale = 1.0f / 16384, .offset = {0.25f, -0.5f, 0.125f}};

struct scene {
	struct model_primitive primitive;
	struct drawable drawable;
	struct drawable_fixed fixed;
	struct bend_vertex vertex[VERTICES];
	float from_position[VERTICES][3], from_normal[VERTICES][3];
	float position[VERTICES][3], normal[VERTICES][3];
	struct fixed_vector fixed_from[VERTICES], fixed_from_normal[VERTICES];
	struct fixed_vector fixed_position[VERTICES], fixed_normal[VERTICES];
	struct bend bend;
};

static int16_t part_of(uint32_t *seed)
{
	int kind = random_between(seed, 0, 3);

	return (int16_t)(kind == 0  ? 0
			: kind == 1 ? 16384
				    : random_between(seed, 1, 16383));
}

static void make_vertex(struct scene *s, int v, uint32_t *seed)
{
	struct fixed_vector *p = &s->fixed_from[v];
	struct fixed_vector *n = &s->fixed_from_normal[v];
	double length;

	*p = (struct fixed_vector){0, (int16_t)random_within(seed, 12000),
		(int16_t)random_within(seed, 12000),
		(int16_t)random_within(seed, 12000)};
	*n = (struct fixed_vector){0, (int16_t)random_within(seed, 16000),
		(int16_t)random_within(seed, 16000),
		(int16_t)(1000 + random_between(seed, 0, 15000))};
	length = sqrt((double)n->x * n->x + (double)n->y * n->y +
		(double)n->z * n->z);
	n->x = (int16_t)(n->x * 16384 / length);
	n->y = (int16_t)(n->y * 16384 / length);
	n->z = (int16_t)(n->z * 16384 / length);
	fixed_placement_apply(&placement, p, s->from_position[v]);
	s->from_normal[v][0] = (float)n->x / 16384;
	s->from_normal[v][1] = (float)n->y / 16384;
	s->from_normal[v][2] = (float)n->z / 16384;
	s->vertex[v] = (struct bend_vertex){.turn_q14 = part_of(seed),
		.reach_q14 = part_of(seed),
		.place = (uint8_t)random_between(seed, 0, BEND_STEPS - 1)};
}

static void begin(struct scene *s, bool fixed, uint32_t seed)
{
	memset(s, 0, sizeof(*s));
	s->primitive.vertex_count = VERTICES;
	s->fixed = (struct drawable_fixed){.placement = placement,
		.position = s->fixed_from,
		.normal = s->fixed_from_normal};
	s->drawable.primitive = &s->primitive;
	s->drawable.vertex_scale = unit;
	s->drawable.fixed = fixed ? &s->fixed : NULL;
	for (int v = 0; v < VERTICES; v++) {
		make_vertex(s, v, &seed);
	}
	s->vertex[0].place = 0;
	s->vertex[1].place = BEND_STEPS - 1;
	s->bend = (struct bend){.part_count = 1,
		.neck = {.x = 0.3f, .z = -0.2f},
		.low = {-1, 0, 0.5f},
		.high = {0.5f, 0.5f, 1.5f},
		.wave = {.direction = {0.48f, 0.6f, 0.64f},
			.axis = {0.8f, 0.36f, -0.48f},
			.amplitude = 0.2f,
			.delay = 1.5f}};
	s->bend.part[0] = (struct bend_part){.drawable = &s->drawable,
		.vertex = s->vertex,
		.position = s->position,
		.normal = s->normal,
		.fixed_position = s->fixed_position,
		.fixed_normal = s->fixed_normal,
		.from_position = s->from_position,
		.from_normal = s->from_normal};
}

static double height_at(const struct scene *s, double omega, int place)
{
	return (double)morph_wave_at(
		&s->bend.wave, (float)omega, (float)place / (BEND_STEPS - 1));
}

/* Between places that are 14 to either side, or at the wave's end. */
static double slope_at(const struct scene *s, double omega, int place)
{
	int from = place - SMOOTH < 0 ? 0 : place - SMOOTH;
	int to = place + SMOOTH > BEND_STEPS - 1 ? BEND_STEPS - 1
						 : place + SMOOTH;
	/* of the box along the axis: 0.8 * 1.5 + 0.36 * 0.5 + 0.48 * 1 */
	const double length = 1.86;

	return (height_at(s, omega, to) - height_at(s, omega, from)) /
		(length * (to - from) / (BEND_STEPS - 1));
}

/* A part of a turn has that part of its sine, and its square of 1 - cosine. */
static void turn(double out[3], double x, double z, double angle, double part)
{
	double sine = sin(angle) * part;
	double less = (1 - cos(angle)) * part * part;

	out[0] += z * sine - x * less;
	out[2] += -x * sine - z * less;
}

/*
 * What the vertex and its normal become, in the vertices' unit. A wave tilts
 * the normal that the turn left.
 */
static void expect(const struct scene *s, int v, double angle, double omega,
	double at[3], double normal[3])
{
	const struct bend_vertex *vertex = &s->vertex[v];
	const struct morph_wave *wave = &s->bend.wave;
	double part = vertex->turn_q14 / 16384.0;
	double reach = vertex->reach_q14 / 16384.0, facing = 0, tilt, height;

	for (int i = 0; i < 3; i++) {
		at[i] = (double)s->from_position[v][i];
		normal[i] = (double)s->from_normal[v][i];
	}
	turn(at, at[0] - 0.3 * (double)unit, at[2] + 0.2 * (double)unit, angle,
		part);
	turn(normal, normal[0], normal[2], angle, part);
	if (!(omega > 0 && omega < 1)) {
		return;
	}
	for (int i = 0; i < 3; i++) {
		facing += (double)wave->direction[i] * normal[i];
	}
	height = height_at(s, omega, vertex->place) * reach * (double)unit;
	tilt = slope_at(s, omega, vertex->place) * reach * facing;
	for (int i = 0; i < 3; i++) {
		at[i] += (double)wave->direction[i] * height;
		normal[i] -= (double)wave->axis[i] * tilt;
	}
}

static const struct {
	float angle, omega;
} motions[] = {{0, 0}, {0.4f, 0}, {-0.3f, 1}, {0, 0.15f}, {0, 0.5f}, {0, 0.85f},
	{0.25f, 0.4f}, {-0.5f, 0.6f}};

static void test_floats_follow_the_formulas(void **state)
{
	static struct scene s;

	(void)state;
	begin(&s, false, 1);
	for (size_t m = 0; m < ARRAY_COUNT(motions); m++) {
		bend_update(&s.bend, motions[m].angle, motions[m].omega);
		for (int v = 0; v < VERTICES; v++) {
			double at[3], normal[3];

			expect(&s, v, (double)motions[m].angle,
				(double)motions[m].omega, at, normal);
			for (int i = 0; i < 3; i++) {
				assert_near(s.position[v][i], at[i], 1e-5);
				assert_near(s.normal[v][i], normal[i], 1e-4);
			}
		}
	}
}

static void test_fixed_point_follows_them_in_its_steps(void **state)
{
	static struct scene s;

	(void)state;
	begin(&s, true, 2);
	for (size_t m = 0; m < ARRAY_COUNT(motions); m++) {
		bend_update(&s.bend, motions[m].angle, motions[m].omega);
		for (int v = 0; v < VERTICES; v++) {
			const struct fixed_vector *n = &s.fixed_normal[v];
			double at[3], normal[3];
			float own[3];

			expect(&s, v, (double)motions[m].angle,
				(double)motions[m].omega, at, normal);
			fixed_placement_apply(
				&placement, &s.fixed_position[v], own);
			for (int i = 0; i < 3; i++) {
				assert_near(own[i], at[i], 8.0 / 16384);
			}
			assert_near(n->x / 16384.0, normal[0], 3e-3);
			assert_near(n->y / 16384.0, normal[1], 3e-3);
			assert_near(n->z / 16384.0, normal[2], 3e-3);
		}
	}
}

/* A vertex that leaves the range of 16 bits stays at its end. */
static void test_a_vertex_beyond_the_range_stays_at_its_end(void **state)
{
	static struct scene s;

	(void)state;
	begin(&s, true, 3);
	s.bend.wave.direction[0] = -1;
	s.bend.wave.direction[1] = 0;
	s.bend.wave.direction[2] = 0;
	s.bend.wave.delay = 0;
	for (int up = 0; up < 2; up++) {
		/* 0.2 units are 1638 steps in the middle of the wave. */
		s.bend.wave.amplitude = up ? -0.2f : 0.2f;
		for (int i = 0; i < 3; i++) {
			int16_t x = (int16_t)(31100 + 20 * i);

			s.fixed_from[i].x = (int16_t)(up ? x : -x);
			s.vertex[i].turn_q14 = 0;
			s.vertex[i].reach_q14 = 16384;
		}
		bend_update(&s.bend, 0, 0.5f);
		for (int i = 0; i < 3; i++) {
			int x = 31100 + 20 * i + 1638;

			x = x > 32767 ? 32767 : x;
			assert_near(s.fixed_position[i].x, up ? x : -x, 8);
			if (i == 2) {
				assert_int_equal(
					s.fixed_position[i].x, up ? x : -x);
			}
		}
	}
}

static void test_a_wave_without_height_moves_nothing(void **state)
{
	static struct scene s;

	(void)state;
	for (int fixed = 0; fixed < 2; fixed++) {
		begin(&s, fixed, 4);
		s.bend.wave.amplitude = 0;
		bend_update(&s.bend, 0, 0.5f);
		if (fixed) {
			assert_memory_equal(s.fixed_position, s.fixed_from,
				sizeof(s.fixed_from));
		} else {
			assert_memory_equal(s.position, s.from_position,
				sizeof(s.from_position));
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_floats_follow_the_formulas),
		cmocka_unit_test(test_fixed_point_follows_them_in_its_steps),
		cmocka_unit_test(test_a_vertex_beyond_the_range_stays_at_its_end),
		cmocka_unit_test(test_a_wave_without_height_moves_nothing),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
