/* When a simplification ends: hardly any further collapse is within the limit. */
#include "app/model/levels/simplify_choose.h"
#include "app/model/levels/simplify_mesh.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	SIDE = 10,
	VERTICES = SIDE * SIDE,
	INDICES = (SIDE - 1) * (SIDE - 1) * 6,
	CASES = 30
};

struct hills {
	float position[VERTICES][3], normal[VERTICES][3];
	uint32_t index[INDICES];
	bool shared[VERTICES];
	struct model_primitive primitive;
	struct simplify simplify;
};

static void begin(struct hills *hills, uint32_t *seed)
{
	const struct simplify_input input = {
		.primitive = &hills->primitive,
		.index = hills->index,
		.index_count = INDICES,
		.extent = 9.0f,
		.shared = hills->shared,
	};
	uint32_t *next = hills->index;

	memset(hills, 0, sizeof(*hills));
	for (int v = 0; v < VERTICES; v++) {
		hills->position[v][0] = (float)(v % SIDE);
		hills->position[v][1] = (float)(v / SIDE);
		hills->position[v][2] = (float)random_within(seed, 100) / 300;
		hills->normal[v][2] = 1.0f;
		hills->shared[v] = random_one_in(seed, 20);
	}
	for (uint32_t i = 0; i < INDICES / 6; i++) {
		uint32_t a = i / (SIDE - 1) * SIDE + i % (SIDE - 1);
		const uint32_t corner[6] = {
			a, a + 1, a + SIDE, a + SIDE, a + 1, a + SIDE + 1};

		memcpy(next, corner, sizeof(corner));
		next += 6;
	}
	hills->primitive = (struct model_primitive){.vertex_count = VERTICES,
		.position = hills->position,
		.normal = hills->normal};
	assert_int_equal(simplify_begin(&hills->simplify, &input, NULL), 0);
}

static bool is_used(const struct simplify *simplify, uint32_t vertex)
{
	return simplify_mesh_valence(simplify, vertex) > 0;
}

/* Triangles have three places, and vertices that must stay are there. */
static void check_list(const struct hills *hills)
{
	const struct simplify *simplify = &hills->simplify;

	for (int i = 0; i < simplify->index_count; i++) {
		uint32_t a = simplify->index[i];
		uint32_t b = simplify->index[i % 3 == 2 ? i - 2 : i + 1];

		assert_int_not_equal(a, b);
	}
	for (uint32_t v = 0; v < VERTICES; v++) {
		assert_int_equal(simplify->to[v], v);
		assert_true(is_used(simplify, v) || !hills->shared[v]);
	}
}

static void test_hardly_any_collapse_within_the_limit_is_left(void **state)
{
	static const float limits[] = {0.002f, 0.006f, 0.015f, 0.03f};
	static struct hills hills;
	struct simplify *simplify = &hills.simplify;
	uint32_t seed = 2;
	int left = 0, used = 0, total = 0;

	(void)state;
	for (int i = 0; i < RANDOM_CASES(CASES); i++) {
		int count = INDICES;

		begin(&hills, &seed);
		for (int l = 0; l < 4; l++) {
			simplify_until(simplify, limits[l]);
			assert_true(simplify->index_count <= count);
			count = simplify->index_count;
			check_list(&hills);
			for (uint32_t v = 0; v < VERTICES; v++) {
				simplify_choose(simplify, v, limits[l]);
				left += !hills.shared[v] &&
					is_used(simplify, v) &&
					simplify->best[v].to != v &&
					simplify->best[v].error <= limits[l];
				used += is_used(simplify, v);
			}
		}
		total += count;
		simplify_end(simplify);
	}
	/* A change two edges away may allow a collapse that was not. */
	assert_true(left * 1000 <= used);
	assert_true(2 * total < RANDOM_CASES(CASES) * INDICES);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_hardly_any_collapse_within_the_limit_is_left),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
