/* Displacements of targets: packed without loss, also as key frames. */
#include "app/anim/kernel/kernel.h"
#include "app/anim/kernel/run/fixed_keys_run.h"
#include "app/model/model_keys.h"
#include "tests/support/model/deltas.h"
#include "tests/support/test.h"

#include <stdlib.h>

enum {
	VERTICES = 77,
	TARGETS = 4
};

static const float short_one = 32767.0f, byte_one = 127.0f;

/* A third of the vertices move if sparse, in runs with gaps; else all do. */
static void move(float (*value)[3], bool sparse, float one, int most)
{
	for (int v = 0; v < VERTICES; v++) {
		bool moves = !sparse || v % 9 == 1 || v % 9 == 3 || v % 9 == 4;

		for (int k = 0; k < 3; k++) {
			int number =
				(v * 7919 + k * 10007) % (2 * most + 1) - most;

			value[v][k] = moves ? (float)number / one : 0.0f;
		}
	}
}

static void assert_same(const struct model_deltas *deltas,
	const float (*expected)[3], struct arena *arena)
{
	const float(*all)[3];

	assert_deltas(deltas, expected, VERTICES);
	assert_int_equal(model_deltas_floats(deltas, arena, &all), 0);
	assert_memory_equal(all, expected, VERTICES * sizeof(*all));
}

static void test_any_number_is_read_as_it_was_packed(void **state)
{
	static const struct {
		enum model_number number;
		float one;
		int most;
	} kind[] = {
		{MODEL_FLOAT, 3.0f, 1000},
		{MODEL_INT16, 1.0f, 32767},
		{MODEL_INT16, 32767.0f, 32767},
		{MODEL_INT8, 1.0f, 127},
		{MODEL_INT8, 127.0f, 127},
	};
	struct arena arena = arena_empty();

	(void)state;
	for (size_t i = 0; i < 2 * ARRAY_COUNT(kind); i++) {
		bool sparse = i % 2 == 1;
		struct model_deltas deltas, copy;
		float value[VERTICES][3];

		move(value, sparse, kind[i / 2].one, kind[i / 2].most);
		assert_int_equal(
			model_deltas_pack(&deltas, (const float(*)[3])value,
				VERTICES, kind[i / 2].number, kind[i / 2].one,
				&arena),
			0);
		assert_same(&deltas, (const float(*)[3])value, &arena);
		assert_int_equal(model_deltas_copy(&copy, &deltas, &arena), 0);
		assert_same(&copy, (const float(*)[3])value, &arena);
	}
	arena_release(&arena);
}

static void test_few_moved_vertices_take_little_memory(void **state)
{
	static const float none[VERTICES][3];
	struct arena arena = arena_empty();
	float value[VERTICES][3] = {{0}};
	struct model_deltas deltas;

	(void)state;
	assert_int_equal(model_deltas_pack(&deltas, none, VERTICES, MODEL_FLOAT,
				 1.0f, &arena),
		0);
	assert_int_equal(model_deltas_bytes(&deltas), 0);
	assert_deltas(&deltas, none, VERTICES);
	value[0][1] = value[VERTICES - 1][2] = 1.0f;
	assert_int_equal(model_deltas_pack(&deltas, (const float(*)[3])value,
				 VERTICES, MODEL_INT8, byte_one, &arena),
		0);
	assert_int_equal(model_deltas_count(&deltas), 2);
	assert_deltas(&deltas, (const float(*)[3])value, VERTICES);
	arena_release(&arena);
}

/* A span takes 12 bytes, so that two vertices of 6 that rest are kept. */
static void test_spans_end_where_two_vertices_rest(void **state)
{
	static const struct {
		int second, vertices, spans, stored;
	} cases[] = {{0, 3, 0, 3}, {0, 4, 1, 1}, {2, 5, 0, 5}, {2, 6, 1, 3},
		{3, 6, 0, 6}, {3, 7, 2, 2}, {12, 13, 2, 2}};
	struct arena arena = arena_empty();

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		for (int k = 0; k < 3; k++) {
			struct model_deltas deltas;
			float value[13][3] = {{0}};

			value[0][k] = value[cases[i].second][k] = 5;
			assert_int_equal(model_deltas_pack(&deltas,
						 (const float(*)[3])value,
						 cases[i].vertices, MODEL_INT16,
						 1.0f, &arena),
				0);
			assert_int_equal(deltas.span_count, cases[i].spans);
			assert_int_equal(
				model_deltas_count(&deltas), cases[i].stored);
			assert_int_equal(model_deltas_bytes(&deltas),
				6 * cases[i].stored + 12 * cases[i].spans);
			for (int v = 0; v < cases[i].vertices; v++) {
				assert_int_equal(model_deltas_moves(&deltas, v),
					v == 0 || v == cases[i].second);
			}
		}
	}
	arena_release(&arena);
}

static void test_no_deltas_are_zeros(void **state)
{
	const struct model_deltas none = {0};
	struct arena arena = arena_empty();
	const float(*all)[3];
	float got[3] = {1, 1, 1};

	(void)state;
	model_deltas_get(&none, 5, got);
	assert_all_near(got, ((const float[3]){0}), 3, 0);
	assert_int_equal(model_deltas_floats(&none, &arena, &all), 0);
	assert_null(all);
	arena_release(&arena);
}

struct morphed {
	float position[VERTICES][3], normal[VERTICES][3];
	float delta[TARGETS][2][VERTICES][3];
	struct model_target target[TARGETS];
	struct model_primitive primitive;
	struct arena arena;
};

/* Positions are in units of 1 / one, over twice `most` of them and a shift. */
static void set_up(struct morphed *m, float one, int most)
{
	*m = (struct morphed){.arena = arena_empty()};
	m->primitive = (struct model_primitive){.vertex_count = VERTICES,
		.position = m->position,
		.normal = m->normal,
		.target = m->target};
	move(m->position, false, one, most);
	for (int v = 0; v < VERTICES; v++) {
		m->position[v][1] += 50.0f;
		m->normal[v][v % 3] = v % 2 ? 0.6f : -0.6f;
	}
	for (int t = 0; t < TARGETS; t++) {
		move(m->delta[t][0], t == 2, one, most / (t + 2));
		move(m->delta[t][1], t == 1, byte_one, 30);
		assert_int_equal(model_deltas_pack(&m->target[t].position,
					 (const float(*)[3])m->delta[t][0],
					 VERTICES, MODEL_INT16, one, &m->arena),
			0);
		assert_int_equal(
			model_deltas_pack(&m->target[t].normal,
				(const float(*)[3])m->delta[t][1], VERTICES,
				MODEL_INT8, byte_one, &m->arena),
			0);
	}
	m->target[3].normal = (struct model_deltas){0};
}

/* The loop's vertices at one target's full weight, against float. */
static void assert_played(const struct morphed *m, int target)
{
	float weight[TARGETS] = {0};
	struct fixed_vector out[VERTICES];
	struct fixed_keys_frame frame;
	struct fixed_keys keys;
	struct arena arena = arena_empty();

	weight[target] = 1.0f;
	assert_int_equal(fixed_keys_init(&keys, &m->primitive, TARGETS,
				 FIXED_NORMALS, &arena),
		0);
	assert_ptr_equal(keys.key[FIXED_NORMAL], m->primitive.keys->key[1]);
	assert_int_equal(fixed_keys_find(&keys, weight, &frame), 0);
	fixed_keys_run(&keys, &fixed_loops_c, &frame, FIXED_POSITION, out);
	for (int v = 0; v < VERTICES; v++) {
		for (int k = 0; k < 3; k++) {
			assert_near((float)(&out[v].x)[k] * keys.placement.scale +
					keys.placement.offset[k],
				m->position[v][k] + m->delta[target][0][v][k],
				1.01f * keys.placement.scale);
		}
	}
	arena_release(&arena);
}

static void test_key_frames_keep_the_displacements_to_the_bit(void **state)
{
	static const struct {
		float one;
		int most;
	} kind[] = {{1.0f, 10000}, {1.0f, 90}, {32767.0f, 10000}, {32767.0f, 7}};
	static struct morphed m;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(kind); i++) {
		set_up(&m, kind[i].one, kind[i].most);
		m.position[3][1] = m.position[4][1] = 0.0f;
		if (kind[i].one > 1.0f) {
			for (int v = 0; v < VERTICES; v++) {
				m.position[v][1] = 0.01f * (float)v / 77.0f;
			}
		}
		assert_int_equal(model_keys_store(&m.primitive, TARGETS, false,
					 false, &m.arena),
			0);
		assert_non_null(m.primitive.keys);
		for (int t = 0; t < TARGETS; t++) {
			assert_deltas(&m.target[t].position,
				(const float(*)[3])m.delta[t][0], VERTICES);
			if (t < 3) {
				assert_deltas(&m.target[t].normal,
					(const float(*)[3])m.delta[t][1],
					VERTICES);
			}
			assert_played(&m, t);
		}
		assert_int_equal(m.target[3].normal.vertex_count, 0);
		arena_release(&m.arena);
	}
}

static void assert_deltas_near(const struct model_deltas *deltas,
	const float (*expected)[3], float tolerance)
{
	for (int v = 0; v < VERTICES; v++) {
		float got[3];

		model_deltas_get(deltas, v, got);
		assert_all_near(got, expected[v], 3, tolerance);
	}
}

static void test_floats_are_rounded_to_15_bits(void **state)
{
	static struct morphed m;

	(void)state;
	set_up(&m, 1000.0f, 2500);
	for (int t = 0; t < TARGETS; t++) {
		m.target[t].position = model_deltas_view(
			(const float(*)[3])m.delta[t][0], VERTICES);
		m.target[t].normal = model_deltas_view(
			(const float(*)[3])m.delta[t][1], VERTICES);
	}
	assert_int_equal(
		model_keys_store(&m.primitive, TARGETS, false, true, &m.arena),
		0);
	assert_non_null(m.primitive.keys);
	assert_true(m.primitive.keys->scale < 5.0f / 16000.0f);
	for (int t = 0; t < TARGETS; t++) {
		assert_deltas_near(&m.target[t].position,
			(const float(*)[3])m.delta[t][0],
			1.01f * m.primitive.keys->scale);
		assert_deltas_near(&m.target[t].normal,
			(const float(*)[3])m.delta[t][1], 1.01f / 16383.0f);
		assert_played(&m, t);
	}
	arena_release(&m.arena);
}

/* Packs the displacements as floats among those of the model's targets. */
static void pack_floats(struct morphed *m, struct model *model)
{
	for (int t = 0; t < TARGETS; t++) {
		assert_int_equal(
			model_deltas_pack(&m->target[t].position,
				(const float(*)[3])m->delta[t][0], VERTICES,
				MODEL_FLOAT, 1.0f, &model->targets),
			0);
	}
}

static void test_rounding_releases_the_floats(void **state)
{
	static struct morphed m;
	float weight[2][TARGETS] = {{1.0f}, {0, 1.0f}};
	const float time_s[2] = {0.0f, 1.0f};
	struct model_channel channel = {.path = MODEL_WEIGHTS,
		.interpolation = MODEL_LINEAR,
		.width = TARGETS,
		.key_count = 2,
		.time_s = time_s,
		.value = &weight[0][0]};
	struct model_clip clip = {.channel_count = 1, .channel = &channel};
	struct model_material material = model_plain_material;
	struct model_node node = {.skin = -1};
	struct model_mesh mesh = {.primitive_count = 1, .target_count = TARGETS};
	struct model model = {.node_count = 1,
		.node = &node,
		.mesh_count = 1,
		.mesh = &mesh,
		.material_count = 1,
		.material = &material,
		.clip_count = 1,
		.clip = &clip};

	(void)state;
	set_up(&m, 1000.0f, 2500);
	mesh.primitive = &m.primitive;
	for (int skin = 0; skin >= -1; skin--) {
		node.skin = skin;
		pack_floats(&m, &model);
		assert_int_equal(model_keys_round(&model, NULL), 0);
		assert_int_equal(!m.primitive.keys, skin == 0);
		assert_int_equal(!model.targets.newest, skin == -1);
	}
	assert_deltas_near(&m.target[2].position,
		(const float(*)[3])m.delta[2][0],
		1.01f * m.primitive.keys->scale);
	arena_release(&model.arena);
	arena_release(&m.arena);
}

/* The displacements are as before, elsewhere; the target left_out has none. */
static void assert_kept(struct morphed *m, const void *before, int left_out)
{
	assert_ptr_not_equal(m->target[0].position.value, before);
	for (int t = 0; t < TARGETS; t++) {
		if (t != left_out) {
			assert_deltas(&m->target[t].position,
				(const float(*)[3])m->delta[t][0], VERTICES);
		}
	}
}

/*
 * The mesh of node 1 is skinned, so that its displacements stay. Those in the
 * arena that is given back move to another one.
 */
static void test_rounding_keeps_the_floats_of_other_meshes(void **state)
{
	static struct morphed m[3];
	float weight[2][TARGETS] = {{1.0f}, {0, 1.0f}};
	const float time_s[2] = {0.0f, 1.0f};
	struct model_channel channel = {.path = MODEL_WEIGHTS,
		.interpolation = MODEL_LINEAR,
		.width = TARGETS,
		.key_count = 2,
		.time_s = time_s,
		.value = &weight[0][0]};
	struct model_clip clip = {.channel_count = 1, .channel = &channel};
	struct model_material material = model_plain_material;
	struct model_node node[2] = {{.skin = -1}, {.mesh = 1}};
	struct model_primitive other[2];
	struct model_mesh mesh[2] = {
		{.primitive_count = 1, .target_count = TARGETS},
		{.primitive_count = 2, .target_count = TARGETS}};
	struct model model = {.node_count = 2,
		.node = node,
		.mesh_count = 2,
		.mesh = mesh,
		.material_count = 1,
		.material = &material,
		.clip_count = 1,
		.clip = &clip};
	const void *before[2];

	(void)state;
	for (int i = 0; i < 3; i++) {
		set_up(&m[i], 1000.0f, 2500);
		pack_floats(&m[i], &model);
	}
	m[2].target[1].position = (struct model_deltas){0};
	mesh[0].primitive = &m[0].primitive;
	mesh[1].primitive = other;
	for (int i = 0; i < 2; i++) {
		other[i] = m[i + 1].primitive;
		before[i] = m[i + 1].target[0].position.value;
	}
	assert_int_equal(model_keys_round(&model, NULL), 0);
	assert_non_null(m[0].primitive.keys);
	assert_null(model.targets.newest);
	for (int i = 0; i < 2; i++) {
		assert_null(other[i].keys);
		assert_kept(&m[i + 1], before[i], i == 0 ? -1 : 1);
	}
	assert_int_equal(m[2].target[1].position.vertex_count, 0);
	arena_release(&model.arena);
	for (int i = 0; i < 3; i++) {
		arena_release(&m[i].arena);
	}
}

static void assert_not_stored(struct morphed *m)
{
	assert_int_equal(model_keys_store(&m->primitive, TARGETS, false, false,
				 &m->arena),
		0);
	assert_null(m->primitive.keys);
	arena_release(&m->arena);
}

static void test_what_16_bits_cannot_hold_stays_as_it_is(void **state)
{
	static struct morphed m;

	(void)state;
	set_up(&m, 1.0f, 30000);
	assert_not_stored(&m);
	set_up(&m, 1.0f, 1000);
	m.target[1].position =
		model_deltas_view((const float(*)[3])m.delta[1][0], VERTICES);
	assert_not_stored(&m);
	set_up(&m, 1.0f, 1000);
	m.target[0].normal.number = MODEL_INT16;
	m.target[0].normal.unit = short_one;
	assert_not_stored(&m);
	set_up(&m, 1.0f, 1000);
	m.normal[5][0] = 0.99f;
	m.delta[0][1][5][0] = 0.5f;
	assert_int_equal(model_deltas_pack(&m.target[0].normal,
				 (const float(*)[3])m.delta[0][1], VERTICES,
				 MODEL_INT8, byte_one, &m.arena),
		0);
	assert_not_stored(&m);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_any_number_is_read_as_it_was_packed),
		cmocka_unit_test(test_few_moved_vertices_take_little_memory),
		cmocka_unit_test(test_spans_end_where_two_vertices_rest),
		cmocka_unit_test(test_no_deltas_are_zeros),
		cmocka_unit_test(
			test_key_frames_keep_the_displacements_to_the_bit),
		cmocka_unit_test(test_floats_are_rounded_to_15_bits),
		cmocka_unit_test(test_rounding_releases_the_floats),
		cmocka_unit_test(test_rounding_keeps_the_floats_of_other_meshes),
		cmocka_unit_test(test_what_16_bits_cannot_hold_stays_as_it_is),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
