/* The influences of a vertex with weights in 16 bits. */
#include "app/anim/kernel/layout/fixed_influences.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	WIDTH = 8
};

struct influences {
	int count;
	uint16_t joint[WIDTH];
	int weight_q14[WIDTH];
};

static void gather(
	const float weight[WIDTH], int cap, struct fixed_influences *out)
{
	static uint16_t joint[WIDTH] = {7, 3, 9, 1, 5, 4, 2, 8};
	float copy[WIDTH];
	const struct model_primitive primitive = {.vertex_count = 1,
		.influences = WIDTH,
		.joint = joint,
		.weight = copy};

	memcpy(copy, weight, sizeof(copy));
	memset(out, 0x5A, sizeof(*out));
	fixed_influences_gather(&primitive, 0, cap, out);
}

static void assert_influences(
	const struct fixed_influences *got, const struct influences *want)
{
	assert_int_equal(got->count, want->count);
	for (int i = 0; i < want->count; i++) {
		assert_int_equal(got->joint[i], want->joint[i]);
		assert_int_equal(got->weight_q14[i], want->weight_q14[i]);
	}
}

/* The largest remainders are rounded up, the heavier weight of two alike. */
static void test_weights_are_rounded_to_a_sum_of_one(void **state)
{
	static const struct {
		float weight[WIDTH];
		int cap;
		struct influences want;
	} cases[] = {
		{{1}, 0, {1, {7}, {16384}}},
		{{0, 2}, 0, {1, {3}, {16384}}},
		{{0}, 0, {1, {7}, {16384}}},
		{{0.6f, 0.4f}, 0, {2, {7, 3}, {9830, 6554}}},
		{{0.4f, 0.6f}, 0, {2, {3, 7}, {9830, 6554}}},
		{{6, 4}, 1, {1, {7}, {16384}}},
		{{1, 1, 1}, 0, {3, {7, 3, 9}, {5462, 5461, 5461}}},
		{{1, 2, 3}, 0, {3, {9, 3, 7}, {8192, 5461, 2731}}},
		{{1, 2, 3}, 3, {3, {9, 3, 7}, {8192, 5461, 2731}}},
		{{1, 2, 3}, 4, {3, {9, 3, 7}, {8192, 5461, 2731}}},
		{{1, 2, 3}, 2, {2, {9, 3}, {9830, 6554}}},
		{{1, 2, 3}, 1, {1, {9}, {16384}}},
		{{1, 1, 1, 1, 1, 1}, 0,
			{6, {7, 3, 9, 1, 5, 4},
				{2731, 2731, 2731, 2731, 2730, 2730}}},
		{{8, 8, 8, 8, 8, 8, 8, 8}, 0,
			{8, {7, 3, 9, 1, 5, 4, 2, 8},
				{2048, 2048, 2048, 2048, 2048, 2048, 2048,
					2048}}},
		/* What becomes 0 is left out, but not what becomes 1. */
		{{16383, 1}, 0, {2, {7, 3}, {16383, 1}}},
		{{1, 1e-6f, 1e-7f}, 0, {1, {7}, {16384}}},
		{{1, 1e-6f, 1e-7f}, 2, {1, {7}, {16384}}},
		{{3, 1, 1e-6f}, 0, {2, {7, 3}, {12288, 4096}}},
		{{3, 1, 1e-6f}, 2, {2, {7, 3}, {12288, 4096}}},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct fixed_influences got;

		gather(cases[i].weight, cases[i].cap, &got);
		assert_influences(&got, &cases[i].want);
	}
}

/* Two of one joint stay in their order. */
static void test_influences_are_sorted_by_joint(void **state)
{
	static const struct {
		struct fixed_influences from;
		struct influences want;
	} cases[] = {
		{{1, {5}, {16384}}, {1, {5}, {16384}}},
		{{2, {5, 3}, {3, 2}}, {2, {3, 5}, {2, 3}}},
		{{2, {3, 5}, {3, 2}}, {2, {3, 5}, {3, 2}}},
		{{2, {4, 4}, {3, 2}}, {2, {4, 4}, {3, 2}}},
		{{4, {9, 0, 7, 1}, {4, 3, 2, 1}},
			{4, {0, 1, 7, 9}, {3, 1, 2, 4}}},
		{{5, {2, 1, 2, 0, 1}, {5, 4, 3, 2, 1}},
			{5, {0, 1, 1, 2, 2}, {2, 4, 1, 5, 3}}},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct fixed_influences got = cases[i].from;

		fixed_influences_by_joint(&got);
		assert_influences(&got, &cases[i].want);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_weights_are_rounded_to_a_sum_of_one),
		cmocka_unit_test(test_influences_are_sorted_by_joint),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
