/* Key frames played by the loop lerp_keys(), against float. */
#include "app/anim/kernel/kernel.h"
#include "app/anim/kernel/run/fixed_keys_run.h"
#include "app/model/model_deltas.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	VERTICES = 131, /* odd, and more than a chunk */
	TARGETS = 5
};

struct bench {
	float position[VERTICES][3], normal[VERTICES][3];
	float delta[TARGETS][2][VERTICES][3];
	struct model_target target[TARGETS];
	struct model_primitive primitive;
	struct arena arena;
	struct fixed_keys keys;
	struct fixed_vector out[VERTICES + 1];
};

static void make_unit(float v[3])
{
	float length = sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);

	for (int k = 0; k < 3; k++) {
		v[k] /= length;
	}
}

static void set_up(struct bench *b)
{
	memset(b, 0, sizeof(*b));
	for (int v = 0; v < VERTICES; v++) {
		float at = (float)v;

		b->position[v][0] = 3.0f + 0.01f * at;
		b->position[v][1] = sinf(0.3f * at);
		b->position[v][2] = -5.0f + cosf(0.1f * at);
		b->normal[v][0] = sinf(at);
		b->normal[v][1] = cosf(at);
		for (int t = 0; t < TARGETS; t++) {
			float to[3] = {
				cosf(at + (float)t), 0.5f, sinf(at * 2.0f)};

			make_unit(to);
			for (int k = 0; k < 3; k++) {
				b->delta[t][0][v][k] =
					0.4f * sinf(at * (float)(t + k + 1));
				b->delta[t][1][v][k] = to[k] - b->normal[v][k];
			}
		}
	}
	for (int t = 0; t < TARGETS; t++) {
		b->target[t].position = model_deltas_view(
			(const float(*)[3])b->delta[t][0], VERTICES);
		b->target[t].normal = model_deltas_view(
			(const float(*)[3])b->delta[t][1], VERTICES);
	}
	b->primitive = (struct model_primitive){.vertex_count = VERTICES,
		.position = b->position,
		.normal = b->normal,
		.target = b->target};
	b->arena = arena_empty();
	assert_int_equal(fixed_keys_init(&b->keys, &b->primitive, TARGETS,
				 FIXED_NORMALS, &b->arena),
		0);
}

static float wanted(const struct bench *b, int attribute, int v, int k,
	const float weight[TARGETS])
{
	float sum = attribute ? b->normal[v][k] : b->position[v][k];

	for (int t = 0; t < TARGETS; t++) {
		sum += weight[t] * b->delta[t][attribute][v][k];
	}
	return sum;
}

static void play(struct bench *b, const struct fixed_loops *loops,
	const float weight[TARGETS], bool mixed)
{
	struct fixed_keys_frame frame;

	assert_int_equal(fixed_keys_find(&b->keys, weight, &frame), 0);
	assert_int_equal(frame.mixed, mixed);
	for (int a = 0; a < 2; a++) {
		const struct fixed_placement *placement =
			a ? &fixed_keys_directions : &b->keys.placement;

		memset(&b->out[VERTICES], 0x5a, sizeof(b->out[0]));
		fixed_keys_run(&b->keys, loops, &frame, (enum fixed_attribute)a,
			b->out);
		assert_int_equal(b->out[VERTICES].x, 0x5a5a);
		for (int v = 0; v < VERTICES; v++) {
			const int16_t *got = &b->out[v].x;

			for (int k = 0; k < 3; k++) {
				assert_near((float)got[k] * placement->scale +
						placement->offset[k],
					wanted(b, a, v, k, weight),
					2.5f * placement->scale);
			}
		}
	}
}

static void test_two_keys_are_interpolated(void **state)
{
	static const float weight[][TARGETS] = {
		{0},
		{0, 1, 0, 0, 0},
		{0, 0.25f, 0, 0, 0},
		{0, 0, 0.3f, 0.7f, 0},
		{0.5f, 0, 0, 0, 0.5f},
	};
	static struct bench b;

	(void)state;
	set_up(&b);
	for (int i = 0; kernel_registry[i]; i++) {
		const struct fixed_loops *loops = kernel_registry[i]->fixed;

		for (size_t w = 0; loops && w < ARRAY_COUNT(weight); w++) {
			play(&b, loops, weight[w], false);
		}
	}
	arena_release(&b.arena);
}

static void test_any_other_mix_is_summed(void **state)
{
	static const float weight[][TARGETS] = {
		{0.2f, 0.3f, 0.1f, 0, 0},
		{0, 0.5f, 0.2f, 0, 0},
		{0, -0.25f, 0, 0, 0},
		{0, 0, 0, 1.25f, 0},
	};
	static struct bench b;

	(void)state;
	set_up(&b);
	for (size_t w = 0; w < ARRAY_COUNT(weight); w++) {
		play(&b, &fixed_loops_c, weight[w], true);
	}
	arena_release(&b.arena);
}

static void test_bad_weights_are_refused(void **state)
{
	static const float huge[TARGETS] = {0, 2000.0f, 0, 0, 0};
	static const float nan_weight[TARGETS] = {0, 0, NAN, 0, 0};
	struct fixed_keys_frame frame;
	static struct bench b;

	(void)state;
	set_up(&b);
	assert_true(fixed_keys_find(&b.keys, huge, &frame) != 0);
	assert_true(fixed_keys_find(&b.keys, nan_weight, &frame) != 0);
	arena_release(&b.arena);
}

static void test_a_key_takes_six_bytes_an_attribute(void **state)
{
	static struct bench b;

	(void)state;
	set_up(&b);
	assert_int_equal(fixed_keys_bytes(&b.keys),
		(TARGETS + 1) * (VERTICES + 1) * 2 * 6);
	arena_release(&b.arena);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_two_keys_are_interpolated),
		cmocka_unit_test(test_any_other_mix_is_summed),
		cmocka_unit_test(test_bad_weights_are_refused),
		cmocka_unit_test(test_a_key_takes_six_bytes_an_attribute),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
