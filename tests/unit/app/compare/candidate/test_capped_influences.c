/* The joints that a vertex keeps, from those of a file in any order. */
#include "app/compare/candidate/capped_influences.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	VERTICES = 3,
	INFLUENCES = 4
};

static const float weights[VERTICES][INFLUENCES] = {
	{0.1f, 0.2f, 0.3f, 0.4f}, {0.25f, 0.25f, 0.5f, 0}, {0, 0, 0, 1}};

static void expect(int vertex, int max, int count,
	const uint16_t joint[INFLUENCES], const float weight[INFLUENCES])
{
	uint16_t joints[VERTICES][INFLUENCES] = {
		{5, 6, 7, 8}, {1, 2, 3, 4}, {9, 9, 9, 9}};
	float copy[VERTICES][INFLUENCES];
	const struct model_primitive primitive = {.vertex_count = VERTICES,
		.influences = INFLUENCES,
		.joint = &joints[0][0],
		.weight = &copy[0][0]};
	struct capped_influences kept;

	memcpy(copy, weights, sizeof(copy));
	kept = capped_influences_of(&primitive, vertex, max);
	assert_int_equal(kept.count, count);
	for (int i = 0; i < INFLUENCES; i++) {
		assert_int_equal(kept.joint[i], joint[i]);
		assert_near(kept.weight[i], weight[i], 1e-6);
	}
}

static void test_the_heaviest_joints_come_first_and_sum_to_1(void **state)
{
	(void)state;
	expect(0, 0, 4, (uint16_t[]){8, 7, 6, 5},
		(float[]){0.4f, 0.3f, 0.2f, 0.1f});
	expect(0, 2, 2, (uint16_t[]){8, 7, 0, 0},
		(float[]){4 / 7.0f, 3 / 7.0f, 0, 0});
	expect(1, 3, 3, (uint16_t[]){3, 1, 2, 0},
		(float[]){0.5f, 0.25f, 0.25f, 0});
	expect(1, 1, 1, (uint16_t[]){3, 0, 0, 0}, (float[]){1, 0, 0, 0});
	expect(2, 4, 1, (uint16_t[]){9, 0, 0, 0}, (float[]){1, 0, 0, 0});
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_the_heaviest_joints_come_first_and_sum_to_1),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
