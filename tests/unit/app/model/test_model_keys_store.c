/* The numbers in which key frames are stored, by hand. */
#include "app/model/model_deltas.h"
#include "app/model/model_keys.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	VERTICES = 3,
	TARGETS = 2,
	KEY_MAX = 16383
};

/* Vertices and targets that move them; all zeros at first. */
struct fixture {
	float position[VERTICES][3], normal[VERTICES][3], tangent[VERTICES][4];
	float moved[TARGETS][3][VERTICES][3]; /* position, normal, tangent */
	struct model_target target[TARGETS];
	struct model_primitive primitive;
	struct arena arena;
};

static void begin(struct fixture *f)
{
	memset(f, 0, sizeof(*f));
	f->arena = arena_empty();
	f->primitive = (struct model_primitive){.vertex_count = VERTICES,
		.position = f->position,
		.normal = f->normal,
		.tangent = f->tangent,
		.target = f->target};
}

static void pack(struct fixture *f, struct model_deltas *deltas,
	float (*moved)[3], enum model_number number, float one)
{
	assert_int_equal(model_deltas_pack(deltas, (const float(*)[3])moved,
				 VERTICES, number, one, &f->arena),
		0);
}

/* Positions in units of 1 / one, directions in those of 1 / 127. */
static void pack_all(struct fixture *f, float one)
{
	for (int t = 0; t < TARGETS; t++) {
		pack(f, &f->target[t].position, f->moved[t][0], MODEL_INT16,
			one);
		pack(f, &f->target[t].normal, f->moved[t][1], MODEL_INT8, 127);
		pack(f, &f->target[t].tangent, f->moved[t][2], MODEL_INT8, 127);
	}
}

static const struct model_keys *store(
	struct fixture *f, bool tangents, bool rounded)
{
	assert_int_equal(model_keys_store(&f->primitive, TARGETS, tangents,
				 rounded, &f->arena),
		0);
	return f->primitive.keys;
}

static void end(struct fixture *f)
{
	arena_release(&f->arena);
}

/* Vertices at one place, but for one that is twice the half away on an axis. */
static void spread(struct fixture *f, int axis, float from, float half)
{
	begin(f);
	for (int v = 0; v < VERTICES; v++) {
		f->position[v][axis] = from + (v == 1 ? 2.0f * half : 0.0f);
	}
}

static void test_positions_fill_what_15_bits_hold(void **state)
{
	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		for (int half = KEY_MAX; half <= KEY_MAX + 1; half++) {
			const struct model_keys *keys;
			struct fixture f;

			spread(&f, axis, -5.0f, (float)half);
			pack_all(&f, 1.0f);
			keys = store(&f, false, false);
			assert_int_equal(keys != NULL, half == KEY_MAX);
			if (keys) {
				assert_near(keys->scale, 1, 0);
				assert_near(keys->offset[axis], half - 5.0, 0);
				assert_int_equal(
					keys->key[0][0][axis], 2 * KEY_MAX);
				assert_int_equal(
					keys->key[0][1][axis], -2 * KEY_MAX);
			}
			end(&f);
		}
	}
}

/* What a target shows counts as well. */
static void test_the_box_holds_what_targets_show(void **state)
{
	(void)state;
	for (int more = 0; more < 2; more++) {
		const struct model_keys *keys;
		struct fixture f;

		spread(&f, 0, 0.0f, 100.0f);
		f.moved[1][0][1][0] = (float)(2 * KEY_MAX - 200 + 2 * more);
		pack_all(&f, 1.0f);
		keys = store(&f, false, false);
		assert_int_equal(keys != NULL, more == 0);
		if (keys) {
			assert_near(keys->offset[0], KEY_MAX, 0);
			assert_int_equal(keys->key[0][2 * keys->stride + 1][0],
				-2 * KEY_MAX);
			assert_int_equal(keys->key[0][1 * keys->stride + 1][0],
				-2 * (200 - KEY_MAX));
		}
		end(&f);
	}
}

/* The largest power of two with which the half and a rounding still fit. */
static void test_small_models_have_finer_numbers(void **state)
{
	static const struct {
		float half;
		int factor;
	} cases[] = {{0, 8192}, {1, 8192}, {2, 4096}, {3, 4096}, {4, 2048},
		{100, 128}, {4095, 4}, {8191, 2}, {8192, 1}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		const float one = 4.0f;
		const struct model_keys *keys;
		struct fixture f;

		spread(&f, 1, 0.0f, cases[i].half / one);
		f.moved[0][0][0][1] = 2.0f * cases[i].half / one;
		f.moved[0][0][1][1] = -f.moved[0][0][0][1];
		pack_all(&f, one);
		keys = store(&f, false, false);
		assert_non_null(keys);
		assert_near(keys->scale, 1.0 / (cases[i].factor * 4.0), 0);
		assert_near(f.target[0].position.unit,
			-2.0 * cases[i].factor * 4.0, 0);
		end(&f);
	}
}

/* The player's offset must be exact. */
static void test_models_far_from_the_origin_are_not_stored(void **state)
{
	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		for (int sign = -1; sign <= 1; sign += 2) {
			for (int more = 0; more < 2; more++) {
				struct fixture f;

				spread(&f, axis,
					(float)(sign * (999999 + more)), 0);
				f.moved[0][0][0][(axis + 1) % 3] = 8.0f;
				pack_all(&f, 1.0f);
				assert_int_equal(store(&f, false, false) != NULL,
					more == 0);
				end(&f);
			}
		}
	}
}

/* A byte of a direction is 129 of the 16383 numbers. */
static void test_directions_are_bytes_times_129(void **state)
{
	const struct model_keys *keys;
	struct fixture f;

	(void)state;
	for (int attribute = 1; attribute <= 2; attribute++) {
		for (int more = 0; more < 2; more++) {
			begin(&f);
			f.moved[0][0][0][0] = 1.0f;
			f.normal[2][0] = f.tangent[2][0] = 0.6f;
			f.normal[2][1] = f.tangent[2][1] = -0.8f;
			f.moved[1][attribute][2][0] =
				(float)(50 + more) / 127.0f;
			f.moved[1][attribute][2][1] = -25.0f / 127.0f;
			pack_all(&f, 1.0f);
			keys = store(&f, true, false);
			/* 9830 + 129 * 50 is 16280; with 51 it is too much. */
			assert_int_equal(keys != NULL, more == 0);
			if (keys) {
				const int16_t(*key)[3] = keys->key[attribute];

				assert_int_equal(key[2][0], -2 * 9830);
				assert_int_equal(key[2][1], 2 * 13106);
				assert_int_equal(key[2 * keys->stride + 2][0],
					-2 * (9830 + 129 * 50));
				assert_int_equal(key[2 * keys->stride + 2][1],
					2 * (13106 + 129 * 25));
				assert_near(
					(attribute == 1 ? f.target[1].normal
							: f.target[1].tangent)
						.unit,
					-2.0 * 129 * 127, 0);
			}
			end(&f);
		}
	}
}

/* Units may differ between attributes, but not between targets. */
static void test_targets_have_one_unit(void **state)
{
	(void)state;
	for (int i = 0; i < 9; i++) {
		static const float units[] = {0.5f, 1.0f, 2.0f};
		float one = units[i % 3], other = units[i / 3];
		struct fixture f;

		begin(&f);
		f.moved[0][0][0][0] = f.moved[1][0][0][0] = 4.0f;
		pack_all(&f, one);
		pack(&f, &f.target[1].position, f.moved[1][0], MODEL_INT16,
			other);
		assert_int_equal(store(&f, false, false) != NULL, one == other);
		end(&f);
	}
}

/* Without any displacement of positions there is no unit. */
static void test_targets_of_directions_alone_are_not_stored(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	f.moved[0][1][0][0] = 1.0f;
	pack(&f, &f.target[0].normal, f.moved[0][1], MODEL_INT8, 127);
	assert_null(store(&f, false, false));
	end(&f);
}

/* Directions are in bytes of 127, or there are none. */
static void test_directions_in_other_units_are_not_stored(void **state)
{
	(void)state;
	for (int i = 0; i < 4; i++) {
		struct fixture f;

		begin(&f);
		f.moved[0][0][0][0] = 1.0f;
		f.moved[0][1][0][0] = 1.0f;
		pack(&f, &f.target[0].position, f.moved[0][0], MODEL_INT16, 1);
		if (i > 0) {
			pack(&f, &f.target[0].normal, f.moved[0][1],
				i == 2 ? MODEL_INT16 : MODEL_INT8,
				i == 1           ? 127
					: i == 2 ? 32767
						 : 1);
		}
		assert_int_equal(store(&f, false, false) != NULL, i < 2);
		end(&f);
	}
}

/* Each vertex may be at an end of the box in a single key alone. */
static void test_the_box_holds_each_vertex_of_each_key(void **state)
{
	(void)state;
	for (int i = 0; i < VERTICES * (1 + TARGETS); i++) {
		int vertex = i % VERTICES, key = i / VERTICES;
		const struct model_keys *keys;
		struct fixture f;

		begin(&f);
		f.moved[0][0][(vertex + 1) % VERTICES][1] = 1.0f;
		if (key > 0) {
			f.moved[key - 1][0][vertex][0] = 100.0f;
		} else {
			f.position[vertex][0] = 100.0f;
			for (int t = 0; t < TARGETS; t++) {
				f.moved[t][0][vertex][0] = -100.0f;
			}
		}
		pack_all(&f, 1.0f);
		keys = store(&f, false, false);
		assert_non_null(keys);
		assert_near(keys->offset[0], 50, 0);
		assert_near(keys->scale, 1 / 256.0, 0);
		assert_int_equal(keys->key[0][key * keys->stride + vertex][0],
			-2 * 256 * 50);
		end(&f);
	}
}

/* Floats are rounded so that the box fills the numbers but for one. */
static void test_rounded_positions_fill_the_box(void **state)
{
	const struct model_keys *keys;
	struct fixture f;

	(void)state;
	spread(&f, 2, -1.0f, 1.5f);
	f.moved[1][0][1][2] = 1.0f;
	for (int t = 0; t < TARGETS; t++) {
		f.target[t].position = model_deltas_view(
			(const float(*)[3])f.moved[t][0], VERTICES);
	}
	keys = store(&f, false, true);
	/* From -1 to 3: half of it is 2 units of 8191. */
	assert_near(keys->scale, 1 / 8191.0, 1e-9);
	assert_near(keys->offset[2], 1, 1e-6);
	assert_int_equal(keys->key[0][0][2], 2 * (KEY_MAX - 1));
	assert_int_equal(keys->key[0][1][2], -2 * 8191);
	assert_int_equal(
		keys->key[0][2 * keys->stride + 1][2], -2 * (KEY_MAX - 1));
	end(&f);
}

/* What targets show is a direction, too: it is made as short as one. */
static void test_rounded_directions_are_of_unit_length(void **state)
{
	const struct model_keys *keys;
	struct fixture f;

	(void)state;
	begin(&f);
	f.moved[0][0][0][0] = 1.0f;
	f.normal[1][0] = 0.6f;
	f.normal[1][2] = 0.8f;
	f.moved[0][1][1][0] = 2.4f;
	f.moved[0][1][1][2] = 3.2f;
	f.moved[1][1][1][2] = -0.8f;
	for (int t = 0; t < TARGETS; t++) {
		f.target[t].position = model_deltas_view(
			(const float(*)[3])f.moved[t][0], VERTICES);
		f.target[t].normal = model_deltas_view(
			(const float(*)[3])f.moved[t][1], VERTICES);
	}
	keys = store(&f, false, true);
	assert_non_null(keys);
	for (int key = 0; key < 3; key++) {
		const int16_t *n = keys->key[1][key * keys->stride + 1];

		assert_int_equal(n[0], -2 * 9830);
		assert_int_equal(n[2], key == 2 ? 0 : -2 * 13106);
	}
	end(&f);
}

/* A length of 1.25 along any two axes becomes 1. */
static void test_directions_are_shortened_along_all_axes(void **state)
{
	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		int next = (axis + 1) % 3;
		const struct model_keys *keys;
		const int16_t *n;
		struct fixture f;

		begin(&f);
		f.moved[0][0][0][0] = 1.0f;
		f.normal[0][axis] = 1.0f;
		f.moved[0][1][0][axis] = -0.25f;
		f.moved[0][1][0][next] = -1.0f;
		for (int t = 0; t < TARGETS; t++) {
			f.target[t].position = model_deltas_view(
				(const float(*)[3])f.moved[t][0], VERTICES);
			f.target[t].normal = model_deltas_view(
				(const float(*)[3])f.moved[t][1], VERTICES);
		}
		keys = store(&f, false, true);
		assert_non_null(keys);
		n = keys->key[1][keys->stride];
		assert_int_equal(n[axis], -2 * 9830);
		assert_int_equal(n[next], 2 * 13106);
		assert_int_equal(n[3 - axis - next], 0);
		end(&f);
	}
}

/* Keys have an even number of vertices of 6 bytes, one key more than targets. */
static void test_tangents_are_stored_on_demand(void **state)
{
	(void)state;
	for (int i = 0; i < 3; i++) {
		const struct model_keys *keys;
		struct fixture f;

		begin(&f);
		f.moved[0][0][0][0] = 1.0f;
		f.primitive.tangent = i == 1 ? NULL : f.tangent;
		pack_all(&f, 1.0f);
		keys = store(&f, i > 0, false);
		assert_int_equal(keys->stride, 4);
		assert_non_null(keys->key[0]);
		assert_non_null(keys->key[1]);
		assert_int_equal(keys->key[2] != NULL, i == 2);
		assert_int_equal(model_keys_bytes(keys, TARGETS),
			(i == 2 ? 3 : 2) * 3 * 4 * 6);
		end(&f);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_positions_fill_what_15_bits_hold),
		cmocka_unit_test(test_the_box_holds_what_targets_show),
		cmocka_unit_test(test_small_models_have_finer_numbers),
		cmocka_unit_test(test_models_far_from_the_origin_are_not_stored),
		cmocka_unit_test(test_directions_are_bytes_times_129),
		cmocka_unit_test(test_targets_have_one_unit),
		cmocka_unit_test(test_targets_of_directions_alone_are_not_stored),
		cmocka_unit_test(test_directions_in_other_units_are_not_stored),
		cmocka_unit_test(test_the_box_holds_each_vertex_of_each_key),
		cmocka_unit_test(test_directions_are_shortened_along_all_axes),
		cmocka_unit_test(test_rounded_positions_fill_the_box),
		cmocka_unit_test(test_rounded_directions_are_of_unit_length),
		cmocka_unit_test(test_tangents_are_stored_on_demand),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
