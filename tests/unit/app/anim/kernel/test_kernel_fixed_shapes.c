/* The numbers of key frames made from targets, and which two a frame mixes. */
#include "app/anim/kernel/run/fixed_keys_run.h"
#include "tests/support/test.h"
#include "tests/unit/app/anim/kernel/target_views.h"

#include <errno.h>
#include <math.h>
#include <string.h>

enum {
	VERTICES = 3,
	STRIDE = 4,
	TARGETS = 2
};

struct fixture {
	float position[VERTICES][3], normal[VERTICES][3];
	float tangent[VERTICES][4];
	float delta[TARGETS][3][VERTICES][3];
	struct model_target target[TARGETS];
	struct model_primitive primitive;
	struct arena arena;
	struct fixed_keys keys;
};

/*
 * The box around all shapes reaches from 0, 10, -6 to 2, 14, 0: along x as far
 * as the mesh without targets, along y target 0, along z target 1.
 */
static void set_up(struct fixture *f)
{
	*f = (struct fixture){
		.position = {{0, 10, -4}, {2, 10, -6}, {1, 11, -4}},
		.normal = {{0.6f, 0.8f, 0}, {2, 3, 6}, {0, 0, -1}},
		.tangent = {{-1, 0, 0, 9}, {0, -1, 0, 9}, {0.9f, 0.8f, 0, 9}},
		.delta = {{{{1, 0, 0}, {-0.5f, 0, 1}, {0, 3, 0}},
				  {{0.6f, 0.8f, 0}}, {{0}, {0, 0.5f, 0}}},
			{{{0.5f, 0, 0}, {-0.25f, 0, 0.5f}, {0, 0, 4}},
				{{-0.3f, -0.4f, 0}}, {{0}, {0, 0, 0.5f}}}},
	};
	target_views(f->target, TARGETS, f->delta[0][0][0], VERTICES);
	f->primitive = (struct model_primitive){.vertex_count = VERTICES,
		.position = f->position,
		.normal = f->normal,
		.tangent = f->tangent,
		.target = f->target};
}

static void init(struct fixture *f, unsigned streams)
{
	assert_int_equal(fixed_keys_init(&f->keys, &f->primitive, TARGETS,
				 streams, &f->arena),
		0);
}

static void assert_keys(const struct fixed_key *got,
	const int16_t want[1 + TARGETS][VERTICES][3])
{
	for (int i = 0; i < (1 + TARGETS) * VERTICES; i++) {
		const struct fixed_key *key =
			&got[i / VERTICES * STRIDE + i % VERTICES];
		const int16_t *number = want[i / VERTICES][i % VERTICES];

		assert_int_equal(key->x, number[0]);
		assert_int_equal(key->y, number[1]);
		assert_int_equal(key->z, number[2]);
	}
}

/* Numbers are times -2, so 3 units along z, the longest side, are -32766. */
static void test_positions_fill_the_box_of_all_shapes(void **state)
{
	static const int16_t want[1 + TARGETS][VERTICES][3] = {
		{{10922, 21844, 10922}, {-10922, 21844, 32766},
			{0, 10922, 10922}},
		{{0, 21844, 10922}, {-5462, 21844, 21844}, {0, -21844, 10922}},
		{{5462, 21844, 10922}, {-8192, 21844, 27306}, {0, 10922, -32766}},
	};
	static const float middle[3] = {1, 12, -3};
	static struct fixture f;

	(void)state;
	set_up(&f);
	init(&f, 0);
	assert_int_equal(f.keys.stride, STRIDE);
	assert_all_near(f.keys.placement.offset, middle, 3, 1e-6);
	assert_near(f.keys.placement.scale * 16383, 3, 1e-6);
	assert_keys(f.keys.key[FIXED_POSITION], want);
	assert_null(f.keys.key[FIXED_NORMAL]);
	assert_null(f.keys.key[FIXED_TANGENT]);
	assert_int_equal(fixed_keys_bytes(&f.keys), 3 * STRIDE * 6);
	arena_release(&f.arena);
}

/* Directions that are longer than 1 are shortened, others stay. */
static void test_directions_are_one_long_at_most(void **state)
{
	static const int16_t normal[1 + TARGETS][VERTICES][3] = {
		{{-19660, -26212, 0}, {-9362, -14042, -28086}, {0, 0, 32766}},
		{{-19660, -26212, 0}, {-9362, -14042, -28086}, {0, 0, 32766}},
		{{-9830, -13106, 0}, {-9362, -14042, -28086}, {0, 0, 32766}},
	};
	static const int16_t tangent[1 + TARGETS][VERTICES][3] = {
		{{32766, 0, 0}, {0, 32766, 0}, {-24490, -21768, 0}},
		{{32766, 0, 0}, {0, 16384, 0}, {-24490, -21768, 0}},
		{{32766, 0, 0}, {0, 29306, -14654}, {-24490, -21768, 0}},
	};
	static const float none[3];
	static struct fixture f;

	(void)state;
	assert_near(fixed_keys_directions.scale * 16383, 1, 1e-6);
	assert_all_near(fixed_keys_directions.offset, none, 3, 0);
	set_up(&f);
	init(&f, FIXED_NORMALS | FIXED_TANGENTS);
	assert_keys(f.keys.key[FIXED_NORMAL], normal);
	assert_keys(f.keys.key[FIXED_TANGENT], tangent);
	assert_int_equal(fixed_keys_bytes(&f.keys), 3 * 3 * STRIDE * 6);
	arena_release(&f.arena);
	init(&f, FIXED_NORMALS);
	assert_non_null(f.keys.key[FIXED_NORMAL]);
	assert_null(f.keys.key[FIXED_TANGENT]);
	arena_release(&f.arena);
	init(&f, FIXED_TANGENTS);
	assert_null(f.keys.key[FIXED_NORMAL]);
	assert_non_null(f.keys.key[FIXED_TANGENT]);
	assert_int_equal(fixed_keys_bytes(&f.keys), 2 * 3 * STRIDE * 6);
	arena_release(&f.arena);
}

static void test_numbers_beyond_15_bits_are_clamped(void **state)
{
	static const struct fixed_placement placement = {0.5f, {1, 2, 3}};
	static const float from[][3] = {
		{2, 1, 3.24f}, {8193, -9000, 8194.5f}, {1e9f, 2, -1e9f}};
	struct fixed_key out[4] = {{0}};

	(void)state;
	fixed_keys_convert(3, from, &placement, out);
	assert_int_equal(out[0].x, -4);
	assert_int_equal(out[0].y, 4);
	assert_int_equal(out[0].z, 0);
	assert_int_equal(out[1].x, -32766);
	assert_int_equal(out[1].y, 32766);
	assert_int_equal(out[1].z, -32766);
	assert_int_equal(out[2].x, -32766);
	assert_int_equal(out[2].y, 0);
	assert_int_equal(out[2].z, 32766);
	assert_int_equal(out[3].x, 0);
}

/* As long as the model has keys of all attributes that are wanted. */
static void test_keys_of_the_model_are_taken(void **state)
{
	static const int16_t key[3][(1 + TARGETS) * STRIDE][3];
	static const float offset[3] = {4, 5, 6};
	static struct fixture f;

	(void)state;
	for (unsigned i = 0; i < 16; i++) {
		unsigned has = i & 3, wants = i >> 2;
		const struct model_keys keys = {STRIDE, 0.25f, {4, 5, 6},
			{key[0], has & 1 ? key[1] : NULL,
				has & 2 ? key[2] : NULL}};
		bool taken = (has & wants) == wants;

		set_up(&f);
		f.primitive.keys = &keys;
		init(&f,
			(wants & 1 ? FIXED_NORMALS : 0u) |
				(wants & 2 ? FIXED_TANGENTS : 0u));
		for (int a = 0; a < 3; a++) {
			bool wanted = a == 0 || (wants >> (a - 1) & 1);

			assert_true(wanted || !taken || !f.keys.key[a]);
			assert_true(!wanted || f.keys.key[a]);
			assert_int_equal(wanted && taken,
				(const void *)f.keys.key[a] == key[a]);
		}
		assert_int_equal(f.arena.used_bytes == 0, taken);
		if (taken) {
			assert_near(f.keys.placement.scale, 0.25, 0);
			assert_all_near(f.keys.placement.offset, offset, 3, 0);
		}
		arena_release(&f.arena);
	}
}

static void test_shapes_without_numbers_are_refused(void **state)
{
	static const float bad[] = {1e18f, NAN};
	static struct fixture f;

	(void)state;
	for (int i = 0; i < 4; i++) {
		set_up(&f);
		*(i < 2 ? &f.position[0][2] : &f.delta[1][0][2][0]) = bad[i % 2];
		assert_int_equal(fixed_keys_init(&f.keys, &f.primitive, TARGETS,
					 0, &f.arena),
			-ERANGE);
		arena_release(&f.arena);
	}
}

static void test_a_frame_mixes_two_shapes(void **state)
{
	static const struct {
		float weight[4];
		int source, destiny;
		int16_t a, b; /* weights in Q15, negative */
	} cases[] = {
		{{0}, 0, 0, -32768, 0},
		{{1}, 0, 1, 0, -32768},
		{{0, 0, 0, 0.25f}, 0, 4, -24576, -8192},
		{{0.25f, 0, 0.75f}, 1, 3, -8192, -24576},
		{{0, 0.5f, 0.5f}, 2, 3, -16384, -16384},
		{{0, 0.5f, 0, 0.500009f}, 2, 4, -16384, -16384},
		{{0, 0.5f, 0, 0.499991f}, 2, 4, -16384, -16384},
	};
	static const float mixed[][4] = {{1.0001f}, {-0.0001f}, {0.5f, 0.25f},
		{0, 0.5f, 0.50002f}, {0, 0.5f, 0.49998f}, {0.5f, 0.25f, 0.25f},
		{1.5f, 0, -0.5f}, {1024}, {0, 0, 0, -1024}, {1, 1}};
	static const float bad[][4] = {
		{1024.5f}, {0, -1025}, {0, 0, 0, NAN}, {INFINITY}};
	const struct fixed_keys keys = {.target_count = 4};
	struct fixed_keys_frame frame;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		assert_int_equal(
			fixed_keys_find(&keys, cases[i].weight, &frame), 0);
		assert_false(frame.mixed);
		assert_int_equal(frame.source, cases[i].source);
		assert_int_equal(frame.destiny, cases[i].destiny);
		assert_int_equal(frame.weights.a, cases[i].a);
		assert_int_equal(frame.weights.b, cases[i].b);
	}
	for (size_t i = 0; i < ARRAY_COUNT(mixed); i++) {
		assert_int_equal(fixed_keys_find(&keys, mixed[i], &frame), 0);
		assert_true(frame.mixed);
		assert_ptr_equal(frame.weight, mixed[i]);
	}
	for (size_t i = 0; i < ARRAY_COUNT(bad); i++) {
		assert_int_equal(
			fixed_keys_find(&keys, bad[i], &frame), -ERANGE);
	}
}

/* Key 1 and key 2 less key 0, which gets the rest of the weights. */
static void test_any_mix_is_a_sum_of_shapes(void **state)
{
	static const float weight[TARGETS] = {1, 1};
	static const int16_t want[VERTICES][3] = {{2730, -10922, -5461},
		{1366, -10922, -8192}, {0, 10922, 16383}};
	static struct fixture f;
	struct fixed_vector out[VERTICES + 1] = {[VERTICES] = {.x = 77}};
	struct fixed_keys_frame frame;

	(void)state;
	set_up(&f);
	init(&f, 0);
	assert_int_equal(fixed_keys_find(&f.keys, weight, &frame), 0);
	fixed_keys_run(&f.keys, &fixed_loops_c, &frame, FIXED_POSITION, out);
	for (int v = 0; v < VERTICES; v++) {
		assert_memory_equal(&out[v].x, want[v], sizeof(want[v]));
	}
	assert_int_equal(out[VERTICES].x, 77);
	arena_release(&f.arena);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_positions_fill_the_box_of_all_shapes),
		cmocka_unit_test(test_directions_are_one_long_at_most),
		cmocka_unit_test(test_numbers_beyond_15_bits_are_clamped),
		cmocka_unit_test(test_keys_of_the_model_are_taken),
		cmocka_unit_test(test_shapes_without_numbers_are_refused),
		cmocka_unit_test(test_a_frame_mixes_two_shapes),
		cmocka_unit_test(test_any_mix_is_a_sum_of_shapes),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
