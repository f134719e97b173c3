/*
 * Key frames, their interpolation and weighted targets in fixed point.
 */
#include "app/anim/kernel/kernel.h"
#include "app/anim/kernel/layout/fixed_key.h"
#include "app/anim/kernel/layout/fixed_morph.h"
#include "app/anim/kernel/layout/fixed_skin.h"
#include "app/anim/kernel/run/fixed_lerp.h"
#include "app/anim/kernel/run/fixed_morph_run.h"
#include "app/anim/kernel/run/fixed_palette.h"
#include "app/anim/kernel/run/fixed_skin_run.h"
#include "app/model/model_deltas.h"
#include "tests/support/model/scattered.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <string.h>

enum {
	VERTICES = 50,
	TARGETS = 3
};

struct keys {
	float position[2][VERTICES][3];
	struct fixed_placement placement;
	struct fixed_vector key[2][VERTICES];
	struct fixed_pair pair[VERTICES][3];
	struct fixed_vector temporal[VERTICES];
};

static void set_up(struct keys *k)
{
	struct fixed_range range = fixed_range_empty();

	memset(k, 0, sizeof(*k));
	for (int i = 0; i < 2 * VERTICES * 3; i++) {
		int v = i / 3;

		k->position[v / VERTICES][v % VERTICES][i % 3] =
			3 * scattered(i) + (float)(i % 3);
	}
	for (int n = 0; n < 2; n++) {
		fixed_range_add(
			&range, VERTICES, (const float(*)[3])k->position[n]);
	}
	assert_int_equal(fixed_range_placement(&range, &k->placement), 0);
	for (int n = 0; n < 2; n++) {
		fixed_key_positions(VERTICES, (const float(*)[3])k->position[n],
			&k->placement, k->key[n]);
	}
	fixed_lerp_prepare(VERTICES, k->key[0], k->key[1], k->pair);
}

static void assert_same(
	const struct fixed_vector *got, const struct fixed_vector *want)
{
	for (int i = 0; i < VERTICES; i++) {
		assert_int_equal(got[i].x, want[i].x);
		assert_int_equal(got[i].y, want[i].y);
		assert_int_equal(got[i].z, want[i].z);
	}
}

static void test_a_key_frame_fills_15_bits(void **state)
{
	static struct keys k;
	int most = 0;

	(void)state;
	set_up(&k);
	for (int i = 0; i < 2 * VERTICES; i++) {
		const struct fixed_vector *v =
			&k.key[i / VERTICES][i % VERTICES];
		const int16_t *at = &v->x;

		for (int axis = 0; axis < 3; axis++) {
			most = at[axis] > most ? at[axis] : most;
			assert_int_equal(v->fraction, 0);
			assert_near(at[axis] * k.placement.scale +
					k.placement.offset[axis],
				k.position[i / VERTICES][i % VERTICES][axis],
				0.51 * k.placement.scale);
		}
	}
	assert_int_equal(most, 16383);
}

static void test_a_lerp_ends_at_its_key_frames(void **state)
{
	static struct keys k;

	(void)state;
	set_up(&k);
	for (int n = 0; kernel_registry[n]; n++) {
		const struct fixed_loops *loops = kernel_registry[n]->fixed;
		const struct fixed_pair(*pair)[3] =
			(const struct fixed_pair(*)[3])k.pair;

		if (!loops) {
			continue;
		}
		loops->lerp(VERTICES, pair, fixed_lerp_weights(0), k.temporal);
		assert_same(k.temporal, k.key[0]);
		loops->lerp(VERTICES, pair, fixed_lerp_weights(1), k.temporal);
		assert_same(k.temporal, k.key[1]);
		loops->lerp(VERTICES, pair, fixed_lerp_weights(NAN), k.temporal);
		assert_same(k.temporal, k.key[0]);
	}
}

static void test_a_lerp_is_straight_on_the_way(void **state)
{
	static struct keys k;

	(void)state;
	set_up(&k);
	for (int i = 0; i <= 20; i++) {
		float omega = (float)i / 20;

		fixed_loops_c.lerp(VERTICES,
			(const struct fixed_pair(*)[3])k.pair,
			fixed_lerp_weights(omega), k.temporal);
		for (int v = 0; v < VERTICES; v++) {
			double want = (1 - (double)omega) * k.key[0][v].y +
				(double)omega * k.key[1][v].y;

			assert_near(k.temporal[v].y, want, 1.01);
		}
	}
}

static void test_ranges_without_numbers_are_refused(void **state)
{
	static const float bad[] = {NAN, INFINITY, -INFINITY, 1e30f};
	struct fixed_placement placement;

	(void)state;
	for (int i = 0; i < 4; i++) {
		const float position[2][3] = {{0, bad[i], 0}, {1, 1, 1}};
		struct fixed_range range = fixed_range_empty();

		fixed_range_add(&range, 2, position);
		assert_int_equal(
			fixed_range_placement(&range, &placement), -ERANGE);
	}
}

static void test_a_point_alone_has_a_placement(void **state)
{
	static const float position[1][3] = {{5, 6, 7}};
	struct fixed_range range = fixed_range_empty();
	struct fixed_placement placement;
	struct fixed_vector v;

	(void)state;
	assert_int_equal(fixed_range_placement(&range, &placement), 0);
	fixed_range_add(&range, 1, position);
	assert_int_equal(fixed_range_placement(&range, &placement), 0);
	fixed_key_positions(1, position, &placement, &v);
	assert_int_equal(v.x, 0);
	assert_near(placement.offset[1], 6, 0);
}

/* A line of vertices. Targets move some of them; one target moves none. */
struct morphed {
	float position[VERTICES][3], normal[VERTICES][3];
	float delta[TARGETS][VERTICES][3];
	uint16_t joint[VERTICES];
	float weight[VERTICES];
	struct model_target target[TARGETS];
	struct model_primitive primitive;
	struct arena arena;
};

static void set_up_morphed(struct morphed *m)
{
	memset(m, 0, sizeof(*m));
	for (int v = 0; v < VERTICES; v++) {
		m->position[v][0] = (float)v;
		m->normal[v][1] = 1;
		m->weight[v] = 1;
		for (int k = 0; k < 3; k++) {
			m->delta[0][v][k] = v < 9 ? 4 * scattered(v * 3 + k) : 0;
			m->delta[2][v][k] = v % 16 > 11 ? scattered(v + k) : 0;
		}
	}
	for (int t = 0; t < TARGETS; t++) {
		m->target[t].position = model_deltas_view(
			(const float(*)[3])m->delta[t], VERTICES);
	}
	m->primitive = (struct model_primitive){.vertex_count = VERTICES,
		.position = m->position,
		.normal = m->normal,
		.influences = 1,
		.joint = m->joint,
		.weight = m->weight,
		.target = m->target};
}

static void assert_morphed(const struct morphed *m, const float *weight,
	const struct fixed_vector *got, const struct fixed_placement *placement,
	double tolerance)
{
	for (int v = 0; v < VERTICES; v++) {
		const int16_t *at = &got[v].x;

		for (int k = 0; k < 3; k++) {
			double want = m->position[v][k];

			for (int t = 0; t < TARGETS; t++) {
				want += (double)weight[t] * m->delta[t][v][k];
			}
			assert_near(
				at[k] * placement->scale + placement->offset[k],
				want, tolerance);
		}
	}
}

static const float weights[][TARGETS] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0},
	{0, 0, 1}, {0.3f, 0.5f, -0.9f}, {1, 1, 1}, {-1, -1, -1}, {5, 0, -30},
	{0.5f, 0.5f, 0.5f}, {0, 0, 0}};

static void test_targets_add_up_at_all_weights(void **state)
{
	static struct morphed m;
	struct fixed_vector out[VERTICES];
	struct fixed_morph morph;

	(void)state;
	set_up_morphed(&m);
	assert_int_equal(
		fixed_morph_init(&morph, &m.primitive, TARGETS, 0, &m.arena), 0);
	for (size_t i = 0; i < sizeof(weights) / sizeof(weights[0]); i++) {
		assert_int_equal(fixed_morph_set_weights(&morph, weights[i]), 0);
		fixed_morph_run(&morph, &fixed_loops_c, FIXED_POSITION, out);
		assert_morphed(&m, weights[i], out, &morph.placement,
			1.6 * morph.placement.scale);
	}
	assert_near(morph.weight_limit, 32, 0);
	arena_release(&m.arena);
}

static void test_vertices_that_do_not_move_are_left_out(void **state)
{
	static struct morphed m;
	struct fixed_morph morph;
	const struct fixed_deltas *deltas;

	(void)state;
	set_up_morphed(&m);
	assert_int_equal(fixed_morph_init(&morph, &m.primitive, TARGETS,
				 FIXED_NORMALS, &m.arena),
		0);
	assert_int_equal(morph.pair_count, 2);
	deltas = morph.stream[FIXED_POSITION].deltas;
	assert_int_equal(deltas[0].span_count, 1);
	assert_int_equal(deltas[0].span[0].count, 9);
	assert_int_equal(deltas[1].span_count, 3);
	assert_int_equal(deltas[1].span[1].first, 28);
	assert_int_equal(deltas[1].span[1].count, 4);
	assert_int_equal(deltas[1].span[1].first_pair, 4);
	assert_int_equal(morph.stream[FIXED_NORMAL].deltas[0].span_count, 0);
	arena_release(&m.arena);
}

static void test_the_bytes_of_targets_are_summed(void **state)
{
	static struct morphed m;
	struct fixed_morph morph;

	(void)state;
	set_up_morphed(&m);
	assert_int_equal(
		fixed_morph_init(&morph, &m.primitive, TARGETS, 0, &m.arena), 0);
	/* Target 0 moves 9 vertices in one span, target 2 moves 12 in three. */
	assert_int_equal(fixed_morph_bytes(&morph),
		VERTICES * sizeof(struct fixed_vector) +
			2 * sizeof(struct fixed_deltas) +
			4 * sizeof(struct fixed_span) +
			(9 + 12) * sizeof(struct fixed_pair[3]));
	arena_release(&m.arena);
}

static void test_weights_that_are_no_numbers_are_refused(void **state)
{
	static struct morphed m;
	const float bad[][TARGETS] = {
		{0, NAN, 0}, {INFINITY, 0, 0}, {0, 0, 1025}};
	struct fixed_morph morph;

	(void)state;
	set_up_morphed(&m);
	assert_int_equal(
		fixed_morph_init(&morph, &m.primitive, TARGETS, 0, &m.arena), 0);
	for (int i = 0; i < 3; i++) {
		assert_int_equal(
			fixed_morph_set_weights(&morph, bad[i]), -ERANGE);
	}
	m.delta[0][3][1] = NAN;
	assert_int_equal(
		fixed_morph_init(&morph, &m.primitive, TARGETS, 0, &m.arena),
		-ERANGE);
	arena_release(&m.arena);
}

static void test_a_morphed_primitive_is_skinned(void **state)
{
	static struct morphed m;
	struct fixed_vector out[VERTICES];
	struct fixed_skin skin;
	struct fixed_matrix matrix;
	struct fixed_placement placement;
	mat4 identity = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};

	(void)state;
	set_up_morphed(&m);
	assert_int_equal(
		fixed_skin_init(&skin, &m.primitive, FIXED_NORMALS, &m.arena),
		0);
	assert_int_equal(fixed_skin_add_targets(&skin, TARGETS, &m.arena), 0);
	assert_int_equal(skin.targets.moved_count, 9 + 12);
	for (size_t i = 0; i < sizeof(weights) / sizeof(weights[0]); i++) {
		assert_int_equal(fixed_skin_set_weights(
					 &skin, &fixed_loops_c, weights[i]),
			0);
		assert_int_equal(
			fixed_palette_make(&skin, (const mat4 *)&identity,
				&matrix, &placement),
			0);
		fixed_loops_c.skin(skin.group, skin.group_count,
			skin.base[FIXED_POSITION], &matrix, out);
		/* One joint and one influence: the order is the primitive's. */
		assert_morphed(
			&m, weights[i], out, &placement, 3 * placement.scale);
	}
	arena_release(&m.arena);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_key_frame_fills_15_bits),
		cmocka_unit_test(test_a_lerp_ends_at_its_key_frames),
		cmocka_unit_test(test_a_lerp_is_straight_on_the_way),
		cmocka_unit_test(test_ranges_without_numbers_are_refused),
		cmocka_unit_test(test_a_point_alone_has_a_placement),
		cmocka_unit_test(test_targets_add_up_at_all_weights),
		cmocka_unit_test(test_vertices_that_do_not_move_are_left_out),
		cmocka_unit_test(test_the_bytes_of_targets_are_summed),
		cmocka_unit_test(test_weights_that_are_no_numbers_are_refused),
		cmocka_unit_test(test_a_morphed_primitive_is_skinned),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
