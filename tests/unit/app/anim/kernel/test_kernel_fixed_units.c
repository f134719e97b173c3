/* The numbers and the spans of morph targets in fixed point. */
#include "app/anim/kernel/run/fixed_morph_run.h"
#include "tests/support/test.h"
#include "tests/unit/app/anim/kernel/target_views.h"

#include <errno.h>
#include <math.h>
#include <string.h>

enum {
	VERTICES = 2 * FIXED_MORPH_CHUNK + 40,
	TARGETS = 5
};

struct fixture {
	float position[VERTICES][3], normal[VERTICES][3];
	float tangent[VERTICES][4];
	float delta[TARGETS][3][VERTICES][3];
	struct model_target target[TARGETS];
	struct model_primitive primitive;
	struct arena arena;
	struct fixed_morph morph;
};

/* The box of positions is 2, 1 and 0.5 large, around 11, 20.5 and -29.75. */
static void set_up(struct fixture *f)
{
	memset(f, 0, sizeof(*f));
	for (int v = 0; v < VERTICES; v++) {
		f->position[v][0] = v == 1 ? 12 : 10;
		f->position[v][1] = v == 1 ? 21 : 20;
		f->position[v][2] = v == 1 ? -30 : -29.5f;
		f->normal[v][1] = 1;
		f->tangent[v][2] = -1;
		f->tangent[v][3] = 9;
	}
	target_views(f->target, TARGETS, f->delta[0][0][0], VERTICES);
	f->primitive = (struct model_primitive){.vertex_count = VERTICES,
		.position = f->position,
		.normal = f->normal,
		.tangent = f->tangent,
		.target = f->target};
}

static void init(struct fixture *f, int targets, unsigned streams)
{
	assert_int_equal(fixed_morph_init(&f->morph, &f->primitive, targets,
				 streams, &f->arena),
		0);
}

static void assert_vector(const struct fixed_vector *got, int x, int y, int z)
{
	assert_int_equal(got->fraction, FIXED_HALF);
	assert_int_equal(got->x, x);
	assert_int_equal(got->y, y);
	assert_int_equal(got->z, z);
}

static void test_base_vectors_fill_16_bits_around_their_middle(void **state)
{
	static const float middle[3] = {11, 20.5f, -29.75f};
	static struct fixture f;
	const struct fixed_morph_stream *stream = f.morph.stream;

	(void)state;
	set_up(&f);
	init(&f, 0, FIXED_NORMALS | FIXED_TANGENTS);
	assert_all_near(f.morph.placement.offset, middle, 3, 0);
	assert_near(f.morph.placement.scale * 32600, 1, 1e-6);
	assert_vector(&stream[FIXED_POSITION].base[0], -32600, -16300, 8150);
	assert_vector(&stream[FIXED_POSITION].base[1], 32600, 16300, -8150);
	assert_vector(&stream[FIXED_NORMAL].base[0], 0, 32600, 0);
	assert_vector(&stream[FIXED_TANGENT].base[VERTICES - 1], 0, 0, -32600);
	fixed_morph_set_limit(&f.morph, 4);
	assert_near(f.morph.placement.scale * 8150, 1, 1e-6);
	assert_vector(&stream[FIXED_POSITION].base[1], 8150, 4075, -2038);
	assert_vector(&stream[FIXED_NORMAL].base[0], 0, 8150, 0);
	assert_vector(&stream[FIXED_TANGENT].base[0], 0, 0, -8150);
	arena_release(&f.arena);
}

static void test_only_the_wanted_streams_are_kept(void **state)
{
	static struct fixture f;

	(void)state;
	for (unsigned i = 0; i < 4; i++) {
		set_up(&f);
		init(&f, 1,
			(i & 1 ? FIXED_NORMALS : 0u) |
				(i & 2 ? FIXED_TANGENTS : 0u));
		assert_non_null(f.morph.stream[FIXED_POSITION].base);
		assert_int_equal(f.morph.stream[FIXED_NORMAL].base != NULL,
			(i & 1) != 0);
		assert_int_equal(f.morph.stream[FIXED_TANGENT].base != NULL,
			(i & 2) != 0);
		assert_int_equal(fixed_morph_bytes(&f.morph),
			(size_t)(1 + (i & 1) + (i >> 1)) *
				(VERTICES * sizeof(struct fixed_vector) +
					sizeof(struct fixed_deltas)));
		arena_release(&f.arena);
	}
}

/* A vertex with all its deltas fits, and so does each target's weight. */
static void test_deltas_make_the_unit_smaller(void **state)
{
	static const struct {
		float at[3]; /* deltas along x, y, z of targets 0, 1, 2 */
		int vertex;
		double unit;
	} cases[] = {
		{{0.5f, 0, 0}, 0, 32600 / 1.5},
		{{-0.5f, 0, 0}, 1, 32600 / 1.5},
		{{0.5f, 0.25f, 0}, 0, 32600 / 1.5},
		{{0, 1, 0}, VERTICES - 1, 16383},
		{{0, 0, -1.9f}, 3, 16383 / 1.9},
		{{0, 0.75f, 0}, 2, 16383 / 0.75},
		{{0, 0.502f, 0}, 2, 32600 / 1.002},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		static struct fixture f;

		set_up(&f);
		for (int t = 0; t < 3; t++) {
			f.delta[t][0][cases[i].vertex][t] = cases[i].at[t];
			f.delta[t][2][cases[i].vertex][t] = 1.5f;
		}
		init(&f, 3, FIXED_TANGENTS);
		assert_near(f.morph.stream[FIXED_POSITION].unit / cases[i].unit,
			1, 1e-6);
		assert_near(f.morph.placement.scale * cases[i].unit, 1, 1e-6);
		assert_near(
			f.morph.stream[FIXED_TANGENT].unit, 16383 / 1.5, 0.01);
		arena_release(&f.arena);
	}
}

/* Of any vertex, along any axis, on top of the distance from the middle. */
static void test_deltas_add_up_in_a_vertex(void **state)
{
	static const int vertex[] = {0, 1, 7, VERTICES - 1};
	static const double away[3] = {1, 0.5, 0.25};
	static struct fixture f;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(vertex) * 3; i++) {
		int v = vertex[i / 3];

		set_up(&f);
		f.delta[0][0][v][i % 3] = 1;
		f.delta[1][0][v][i % 3] = -1;
		f.delta[2][0][v][i % 3] = 0.5f;
		f.delta[3][0][v ^ 1][i % 3] = 1;
		init(&f, 4, 0);
		assert_near(f.morph.stream[FIXED_POSITION].unit,
			32600 / (2.5 + away[i % 3]), 0.01);
		arena_release(&f.arena);
	}
}

/* The next vertex in memory is not the primitive's. */
static void test_a_vertex_alone_is_its_own_middle(void **state)
{
	static const float middle[3] = {10, 20, -29.5f};
	static const float none[3] = {0, 0, 0};
	static struct fixture f;

	(void)state;
	set_up(&f);
	f.primitive.vertex_count = 1;
	init(&f, 1, 0);
	assert_all_near(f.morph.placement.offset, middle, 3, 0);
	assert_vector(&f.morph.stream[FIXED_POSITION].base[0], 0, 0, 0);
	arena_release(&f.arena);
	f.primitive.vertex_count = 0;
	f.primitive.position = NULL;
	init(&f, 0, 0);
	assert_all_near(f.morph.placement.offset, none, 3, 0);
	arena_release(&f.arena);
}

static void test_two_targets_are_a_pair(void **state)
{
	static const int pairs[] = {0, 1, 1, 2, 2, 3};
	static struct fixture f;

	(void)state;
	for (int targets = 0; targets <= TARGETS; targets++) {
		set_up(&f);
		init(&f, targets, 0);
		assert_int_equal(f.morph.pair_count, pairs[targets]);
		arena_release(&f.arena);
	}
}

static void assert_span(
	const struct fixed_span *span, int first, int count, int pair)
{
	assert_int_equal(span->first, first);
	assert_int_equal(span->count, count);
	assert_int_equal(span->first_pair, pair);
}

/* Up to three vertices that stay do not end a span. */
static void test_spans_hold_what_a_pair_moves(void **state)
{
	static struct fixture f;
	const struct fixed_deltas *deltas;

	(void)state;
	set_up(&f);
	f.delta[0][0][3][0] = 0.5f;
	f.delta[0][0][4][1] = -1;
	f.delta[1][0][8][2] = 2;
	f.delta[0][0][13][2] = 0.75f;
	f.delta[1][0][13][0] = -0.5f;
	f.delta[1][0][20][1] = 0.5f;
	f.delta[0][0][VERTICES - 1][1] = 1;
	/* Two vertices stay, and two more. */
	f.delta[2][0][0][0] = f.delta[2][0][3][0] = f.delta[2][0][6][0] = 4;
	f.delta[3][0][1][0] = 4; /* not used: there are three targets */
	init(&f, 3, 0);
	deltas = f.morph.stream[FIXED_POSITION].deltas;
	assert_int_equal(f.morph.pair_count, 2);
	assert_int_equal(deltas[0].span_count, 4);
	assert_span(&deltas[0].span[0], 3, 6, 0);
	assert_span(&deltas[0].span[1], 13, 1, 6);
	assert_span(&deltas[0].span[2], 20, 1, 7);
	assert_span(&deltas[0].span[3], VERTICES - 1, 1, 8);
	assert_int_equal(deltas[1].span_count, 1);
	assert_span(&deltas[1].span[0], 0, 7, 0);
	assert_int_equal(deltas[0].pair[0][0].a, 16384);
	assert_int_equal(deltas[0].pair[1][1].a, -32767);
	assert_int_equal(deltas[0].pair[1][1].b, 0);
	assert_int_equal(deltas[0].pair[2][1].a, 0);
	assert_int_equal(deltas[0].pair[5][2].b, 32767);
	assert_int_equal(deltas[0].pair[6][2].a, 24575);
	assert_int_equal(deltas[0].pair[6][0].b, -8192);
	assert_int_equal(deltas[0].pair[7][1].b, 8192);
	assert_int_equal(deltas[0].pair[8][1].a, 32767);
	assert_near(deltas[0].scale[0], 65536 / 32767.0, 1e-6);
	assert_near(deltas[0].scale[1], 131072 / 32767.0, 1e-6);
	assert_near(deltas[1].scale[0], 262144 / 32767.0, 1e-6);
	assert_near(deltas[1].scale[1], 0, 0);
	arena_release(&f.arena);
}

/* The largest delta is 16383 at the limit, for which the weight is 32767. */
static void test_the_limit_of_weights_doubles(void **state)
{
	static const struct {
		float weight, limit;
		int number;
	} cases[] = {{0.5f, 1, 16384}, {1, 1, 32767}, {-1, 1, -32767},
		{1.001f, 2, 16400}, {2, 2, 32767}, {-2.5f, 4, -20479},
		{2, 4, 16384}, {1024, 1024, 32767}, {-1024, 1024, -32767},
		{1, 1024, 32}, {0, 1024, 0}};
	static struct fixture f;

	(void)state;
	set_up(&f);
	f.delta[1][0][0][0] = 8;
	init(&f, 3, 0);
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		const float weight[TARGETS] = {0, cases[i].weight, 0, NAN, NAN};
		const struct fixed_morph_stream *stream = f.morph.stream;

		assert_int_equal(fixed_morph_set_weights(&f.morph, weight), 0);
		assert_near(f.morph.weight_limit, cases[i].limit, 0);
		assert_near(
			stream->unit * cases[i].limit / (16383 / 8.0), 1, 1e-6);
		assert_int_equal(stream->deltas[0].weights.a, 0);
		assert_in_range(stream->deltas[0].weights.b + 40000,
			cases[i].number + 39999, cases[i].number + 40001);
		assert_int_equal(stream->deltas[1].weights.b, 0);
	}
	arena_release(&f.arena);
}

static void test_refused_weights_change_nothing(void **state)
{
	static const float good[TARGETS] = {0.5f, 0.25f, 0.125f},
			   bad[][TARGETS] = {{1, 2, 1024.5f}, {-1025},
				   {0, NAN, 0}, {3, -INFINITY, 0}};
	static struct fixture f;
	struct fixed_weights before[2];

	(void)state;
	set_up(&f);
	f.delta[0][0][0][0] = f.delta[1][0][1][0] = f.delta[2][0][2][0] = 1;
	init(&f, 3, 0);
	assert_int_equal(fixed_morph_set_weights(&f.morph, good), 0);
	for (int p = 0; p < 2; p++) {
		before[p] = f.morph.stream[0].deltas[p].weights;
	}
	for (size_t i = 0; i < ARRAY_COUNT(bad); i++) {
		assert_int_equal(
			fixed_morph_set_weights(&f.morph, bad[i]), -ERANGE);
		assert_near(f.morph.weight_limit, 1, 0);
		for (int p = 0; p < 2; p++) {
			assert_memory_equal(&f.morph.stream[0].deltas[p].weights,
				&before[p], sizeof(before[p]));
		}
	}
	arena_release(&f.arena);
}

/* A coordinate, or the sum of a coordinate and its deltas. */
static void test_what_does_not_fit_a_float_is_refused(void **state)
{
	static const float bad[] = {1e18f, -1e18f, NAN};
	static struct fixture f;

	(void)state;
	for (int i = 0; i < 15; i++) {
		float *where[5];

		set_up(&f);
		where[0] = &f.position[0][2];
		where[1] = &f.position[VERTICES - 1][0];
		where[2] = &f.normal[VERTICES - 1][2];
		where[3] = &f.delta[1][0][VERTICES - 1][2];
		where[4] = &f.delta[0][1][0][0];
		*where[i % 5] = bad[i / 5];
		assert_int_equal(fixed_morph_init(&f.morph, &f.primitive, 2,
					 FIXED_NORMALS, &f.arena),
			-ERANGE);
		arena_release(&f.arena);
	}
	set_up(&f);
	f.delta[0][0][4][0] = f.delta[1][0][4][0] = 0.6e18f;
	assert_int_equal(
		fixed_morph_init(&f.morph, &f.primitive, 2, 0, &f.arena),
		-ERANGE);
	arena_release(&f.arena);
}

static void compare(
	struct fixture *f, const float *weight, enum fixed_attribute attribute)
{
	static struct fixed_vector out[VERTICES + 1];
	const struct fixed_placement *placement = &f->morph.placement;
	bool position = attribute == FIXED_POSITION;
	double unit = f->morph.stream[attribute].unit;

	memset(out, 0x5A, sizeof(out));
	fixed_morph_run(&f->morph, &fixed_loops_c, attribute, out);
	assert_int_equal(out[VERTICES].x, 0x5A5A);
	for (int v = 0; v < VERTICES; v++) {
		const int16_t *got = &out[v].x;

		for (int k = 0; k < 3; k++) {
			double want = position
				? f->position[v][k] - placement->offset[k]
				: f->normal[v][k];

			for (int t = 0; t < TARGETS; t++) {
				want += weight[t] * f->delta[t][attribute][v][k];
			}
			assert_near(got[k], want * unit, 1.6);
		}
	}
}

/*
 * Spans that end and begin beside the chunks in which several pairs are added,
 * and one that crosses all of them.
 */
static void test_spans_may_cross_chunks(void **state)
{
	static const int moved[][2] = {{2, 5}, {FIXED_MORPH_CHUNK - 6, 6},
		{FIXED_MORPH_CHUNK + 5, 9}, {2 * FIXED_MORPH_CHUNK - 3, 7},
		{2 * FIXED_MORPH_CHUNK + 30, 10}};
	static const float weight[][TARGETS] = {{0, 0, 0, 0, 0}, {1, 0, 0, 0, 0},
		{0, 0.5f, 0, 0, 0}, {0, 0, 1, -1, 0}, {0, 0, 0, 0, 0.75f},
		{0.5f, 1, 0, 0, 1}, {0, 0, 1, 0.25f, 1}, {1, 1, -1, 1, -1}};
	static struct fixture f;

	(void)state;
	set_up(&f);
	for (size_t i = 0; i < ARRAY_COUNT(moved); i++) {
		for (int n = 0; n < moved[i][1]; n++) {
			int v = moved[i][0] + n;

			f.delta[0][0][v][n % 3] = 0.01f * (float)(n + 1);
			f.delta[1][0][v][2] = -0.02f * (float)(n + 2);
			f.delta[1][1][v][0] = 0.1f * (float)(n + 1);
		}
	}
	for (int v = 3; v < VERTICES - 4; v++) {
		f.delta[3][0][v][v % 3] = 0.001f * (float)v;
	}
	for (int v = FIXED_MORPH_CHUNK; v < 2 * FIXED_MORPH_CHUNK; v++) {
		f.delta[4][0][v][1] = 0.002f * (float)v;
		f.delta[4][1][v][2] = 0.001f * (float)v;
	}
	init(&f, TARGETS, FIXED_NORMALS);
	for (size_t i = 0; i < ARRAY_COUNT(weight); i++) {
		assert_int_equal(
			fixed_morph_set_weights(&f.morph, weight[i]), 0);
		compare(&f, weight[i], FIXED_POSITION);
		compare(&f, weight[i], FIXED_NORMAL);
	}
	arena_release(&f.arena);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_base_vectors_fill_16_bits_around_their_middle),
		cmocka_unit_test(test_only_the_wanted_streams_are_kept),
		cmocka_unit_test(test_deltas_make_the_unit_smaller),
		cmocka_unit_test(test_deltas_add_up_in_a_vertex),
		cmocka_unit_test(test_a_vertex_alone_is_its_own_middle),
		cmocka_unit_test(test_two_targets_are_a_pair),
		cmocka_unit_test(test_spans_hold_what_a_pair_moves),
		cmocka_unit_test(test_the_limit_of_weights_doubles),
		cmocka_unit_test(test_refused_weights_change_nothing),
		cmocka_unit_test(test_what_does_not_fit_a_float_is_refused),
		cmocka_unit_test(test_spans_may_cross_chunks),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
