/* The targets of skinned primitives in fixed point. */
#include "app/anim/kernel/run/fixed_skin_run.h"
#include "app/model/model_deltas.h"
#include "tests/support/test.h"
#include "tests/unit/app/anim/kernel/target_views.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
	VERTICES = 4,
	WIDTH = 2,
	TARGETS = 2
};

struct fixture {
	float position[VERTICES][3], normal[VERTICES][3];
	float tangent[VERTICES][4];
	uint16_t joint[VERTICES][WIDTH];
	float weight[VERTICES][WIDTH];
	float delta[TARGETS][3][VERTICES][3];
	struct model_target target[TARGETS];
	struct model_primitive primitive;
	struct arena arena;
	struct fixed_skin skin;
};

/* A square of 2; vertices 1 and 3 have two joints, the heavier one first. */
static void set_up(struct fixture *f)
{
	memset(f, 0, sizeof(*f));
	for (int v = 0; v < VERTICES; v++) {
		f->position[v][0] = v & 1 ? 1 : -1;
		f->position[v][1] = v & 2 ? 1 : -1;
		f->normal[v][2] = 1;
		f->tangent[v][1] = 1;
		f->joint[v][0] = 5;
		f->joint[v][1] = 2;
		f->weight[v][0] = v & 1 ? 0.75f : 1;
		f->weight[v][1] = v & 1 ? 0.25f : 0;
	}
	target_views(f->target, TARGETS, f->delta[0][0][0], VERTICES);
	f->primitive = (struct model_primitive){.vertex_count = VERTICES,
		.position = f->position,
		.normal = f->normal,
		.tangent = f->tangent,
		.influences = WIDTH,
		.joint = f->joint[0],
		.weight = f->weight[0],
		.target = f->target};
}

static void lay_out(struct fixture *f)
{
	assert_int_equal(fixed_skin_init(&f->skin, &f->primitive,
				 FIXED_NORMALS | FIXED_TANGENTS, &f->arena),
		0);
	assert_int_equal(
		fixed_skin_add_targets(&f->skin, TARGETS, &f->arena), 0);
}

static void set_weights(struct fixture *f, float first, float second)
{
	const float weight[TARGETS] = {first, second};

	assert_int_equal(
		fixed_skin_set_weights(&f->skin, &fixed_loops_c, weight), 0);
}

/*
 * A direction of 1 with its deltas is 32766 at most, and a delta's number is at
 * most half of that among the deltas: 16383 for the largest one.
 */
static void test_directions_fit_with_their_deltas(void **state)
{
	static const struct {
		float delta, weight;
		double scale;
	} cases[] = {
		{0, 1, 32766},
		{0.1f, 1, 32766 / 1.1},
		{0.25f, 1, 32766 / 1.25},
		{0.5f, 1, 16383},
		{2, 1, 16383 / 4.0},
		{0.1f, 2, 32766 / 1.2},
		{0.25f, 2, 16383},
		{0.125f, -3.5f, 16383},
	};
	static struct fixture f;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases) * 6; i++) {
		size_t c = i / 6, axis = i % 3;
		int attribute = 1 + (int)(i / 3 % 2);
		double other = 32766;

		set_up(&f);
		f.delta[1][attribute][2][axis] = -cases[c].delta;
		f.delta[0][FIXED_POSITION][1][0] = 0.01f;
		lay_out(&f);
		set_weights(&f, 0, cases[c].weight);
		assert_near(f.skin.scale[attribute] / cases[c].scale, 1, 1e-6);
		assert_near(f.skin.scale[3 - attribute] / other, 1, 1e-6);
		arena_release(&f.arena);
	}
}

/* Together the deltas of a coordinate count, not of several coordinates. */
static void test_deltas_of_all_targets_are_summed(void **state)
{
	static const float want[3] = {0.125f, 0.25f, 0};
	static struct fixture f;

	(void)state;
	set_up(&f);
	f.delta[0][FIXED_POSITION][3][1] = 0.0625f;
	f.delta[1][FIXED_POSITION][3][1] = -0.1875f;
	f.delta[1][FIXED_POSITION][3][0] = 0.125f;
	f.delta[0][FIXED_NORMAL][1][0] = 0.125f;
	f.delta[1][FIXED_NORMAL][1][0] = 0.0625f;
	f.delta[1][FIXED_NORMAL][1][2] = 0.125f;
	f.delta[1][FIXED_NORMAL][3][1] = 0.125f;
	lay_out(&f);
	assert_int_equal(f.skin.targets.moved_count, 2);
	assert_int_equal(f.skin.targets.moved[0], 0);
	assert_int_equal(f.skin.targets.moved[1], 1);
	assert_int_equal(f.skin.targets.moved[2], 0);
	assert_int_equal(f.skin.targets.moved[3], 2);
	assert_all_near(f.skin.targets.extent[1], want, 3, 0);
	assert_near(f.skin.targets.largest[FIXED_POSITION], 0.25, 0);
	assert_near(f.skin.targets.largest[FIXED_NORMAL], 0.1875, 0);
	assert_near(f.skin.targets.largest[FIXED_TANGENT], 0, 0);
	assert_near(f.skin.scale[FIXED_NORMAL], 32766 / 1.1875, 0.01);
	set_weights(&f, 3, 0);
	assert_near(f.skin.targets.extent[1][1], 1, 0);
	assert_near(f.skin.targets.extent[1][0], 0.5, 0);
	set_weights(&f, 0, -5);
	assert_near(f.skin.targets.extent[1][1], 2, 0);
	assert_near(f.skin.targets.extent[1][2], 0, 0);
	arena_release(&f.arena);
}

/* The base vectors of all influences in order, for the given weights. */
static void assert_bases(const struct fixture *f, int attribute, int cap,
	const float weight[TARGETS])
{
	const struct fixed_skin *skin = &f->skin;
	const struct fixed_base *base = skin->base[attribute];
	double scale = skin->scale[attribute];

	for (int i = 0; i < VERTICES; i++) {
		uint32_t v = skin->order[i];
		int first = v & 1 && cap != 1 ? 0 : 1;

		for (int j = first; j < 2; j++, base++) {
			const int16_t *got = &base->x;
			double part = first ? 1 : j ? 0.75 : 0.25;

			for (int k = 0; k < 3; k++) {
				double at = attribute == FIXED_POSITION
					? f->position[v][k] -
						skin->joint[j].middle[k]
					: f->normal[v][k];

				for (int t = 0; t < TARGETS; t++) {
					at += weight[t] *
						f->delta[t][attribute][v][k];
				}
				assert_near(got[k], at * part * scale, 3);
			}
		}
	}
}

/* After the cap has changed, too, which rewrites the base vectors. */
static void test_weights_move_the_base_vectors(void **state)
{
	static const float weights[][TARGETS] = {{0, 0}, {1, 0}, {0, 1},
		{0.5f, -1}, {0.5f, -1}, {0.125f, -1}, {1, 1}};
	static const int caps[] = {0, 1, 1, 2, 2, 1, 0};
	static struct fixture f;

	(void)state;
	set_up(&f);
	for (int k = 0; k < 3; k++) {
		f.delta[0][FIXED_POSITION][1][k] = 0.1f * (float)(k + 1);
		f.delta[1][FIXED_POSITION][3][k] = -0.2f * (float)(k + 1);
		f.delta[1][FIXED_POSITION][0][k] = 0.3f;
		f.delta[0][FIXED_NORMAL][3][k] = 0.1f * (float)(3 - k);
	}
	lay_out(&f);
	for (size_t i = 0; i < ARRAY_COUNT(weights); i++) {
		for (size_t c = 0; c < ARRAY_COUNT(caps); c++) {
			fixed_skin_set_cap(&f.skin, caps[c]);
			set_weights(&f, weights[i][0], weights[i][1]);
			assert_bases(&f, FIXED_POSITION, caps[c], weights[i]);
			assert_bases(&f, FIXED_NORMAL, caps[c], weights[i]);
			assert_int_equal(f.skin.targets.rebase_count,
				caps[c] == 1 ? 3 : 5);
		}
	}
	arena_release(&f.arena);
}

/* The weight of a delta of 1 / 4: its part of the normals' numbers. */
static void test_records_weigh_deltas_in_the_skins_unit(void **state)
{
	static struct fixture f;
	const struct fixed_rebase *record;

	(void)state;
	set_up(&f);
	f.delta[0][FIXED_NORMAL][1][0] = 0.25f;
	lay_out(&f);
	assert_int_equal(f.skin.targets.rebase_count, 2);
	record = f.skin.targets.rebase[FIXED_NORMAL];
	/* 26212.8 / 65532 is 0.4. */
	assert_int_equal(record[0].weight_q16, 6554);
	assert_int_equal(record[1].weight_q16, 19661);
	f.weight[1][1] = 0;
	arena_release(&f.arena);
	lay_out(&f);
	assert_int_equal(f.skin.targets.rebase_count, 1);
	record = f.skin.targets.rebase[FIXED_NORMAL];
	assert_int_equal(record->weight_q16, 26214);
	assert_int_equal(record->delta_index, 0);
	assert_int_equal(f.skin.order[1], 1);
	assert_int_equal(record->base_index, 1);
	assert_int_equal(record->rest.z, 26213);
	arena_release(&f.arena);
}

static void test_a_vertex_alone_is_moved(void **state)
{
	static struct fixture f;

	(void)state;
	set_up(&f);
	f.primitive.vertex_count = 1;
	for (int t = 0; t < TARGETS; t++) {
		f.target[t].position.vertex_count = 1;
		f.target[t].normal.vertex_count = 1;
		f.target[t].tangent.vertex_count = 1;
	}
	f.delta[1][FIXED_POSITION][0][1] = 2;
	lay_out(&f);
	assert_int_equal(f.skin.targets.moved_count, 1);
	assert_near(f.skin.targets.largest[FIXED_POSITION], 2, 0);
	set_weights(&f, 0, 1);
	assert_near(
		f.skin.base[FIXED_POSITION][0].y / f.skin.scale[FIXED_POSITION],
		2, 1e-3);
	arena_release(&f.arena);
}

static void test_deltas_that_are_no_numbers_are_refused(void **state)
{
	static const float bad[] = {NAN, INFINITY, 1e18f, -1e18f};
	static struct fixture f;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(bad) * 3; i++) {
		set_up(&f);
		f.delta[1][i % 3][2][1] = bad[i / 3];
		assert_int_equal(
			fixed_skin_init(&f.skin, &f.primitive,
				FIXED_NORMALS | FIXED_TANGENTS, &f.arena),
			0);
		assert_int_equal(
			fixed_skin_add_targets(&f.skin, TARGETS, &f.arena),
			-ERANGE);
		arena_release(&f.arena);
	}
}

/* More vertices than a record can count. */
static void test_targets_move_65535_vertices_at_most(void **state)
{
	const int most = 65535;
	float(*vector)[3] = calloc((size_t)most + 1, sizeof(*vector));
	uint16_t *joint = calloc((size_t)most + 1, sizeof(*joint));
	float *weight = calloc((size_t)most + 1, sizeof(*weight));
	static struct fixture f;

	(void)state;
	assert_true(vector && joint && weight);
	for (int v = 0; v <= most; v++) {
		weight[v] = vector[v][v % 3] = 1;
	}
	for (int more = 0; more < 2; more++) {
		set_up(&f);
		f.primitive.vertex_count = most + more;
		f.primitive.position = vector;
		f.primitive.joint = joint;
		f.primitive.weight = weight;
		f.primitive.influences = 1;
		f.target[0].position = model_deltas_view(
			(const float(*)[3])vector, most + more);
		assert_int_equal(
			fixed_skin_init(&f.skin, &f.primitive, 0, &f.arena), 0);
		assert_int_equal(fixed_skin_add_targets(&f.skin, 1, &f.arena),
			more ? -ERANGE : 0);
		if (!more) {
			assert_int_equal(f.skin.targets.moved[most - 1], most);
		}
		arena_release(&f.arena);
	}
	free(vector);
	free(joint);
	free(weight);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_directions_fit_with_their_deltas),
		cmocka_unit_test(test_deltas_of_all_targets_are_summed),
		cmocka_unit_test(test_weights_move_the_base_vectors),
		cmocka_unit_test(test_records_weigh_deltas_in_the_skins_unit),
		cmocka_unit_test(test_a_vertex_alone_is_moved),
		cmocka_unit_test(test_deltas_that_are_no_numbers_are_refused),
		cmocka_unit_test(test_targets_move_65535_vertices_at_most),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
