/* Levels of detail of a model with a texture. */
#include "app/model/levels/levels.h"
#include "tests/unit/app/model/levels/levels_net.h"

/*
 * A net whose texture has so many units a side, and is off by 1/32 of the net
 * at one vertex.
 */
static struct net make_textured(float units, uint32_t spot)
{
	struct net net = make_net(shape_flat, 1);
	float(*texcoord)[2] =
		arena_alloc(&net.model->arena, COUNT, sizeof(*texcoord));

	for (uint32_t i = 0; i < COUNT; i++) {
		float off = i == spot ? 0.03125f : 0.0f;

		for (int k = 0; k < 2; k++) {
			texcoord[i][k] =
				units * (net.primitive->position[i][k] + off);
		}
	}
	net.primitive->texcoord = texcoord;
	assert_int_equal(levels_make(net.model), 0);
	return net;
}

/* In units of any size: powers of two leave the same mantissas. */
static void test_a_shift_of_the_texture_counts_on_the_surface(void **state)
{
	static const float units[3] = {1.0f, 64.0f, 1.0f / 64.0f};
	const uint32_t spot = ROW * (SIDE / 2) + SIDE / 2;
	struct net first = make_textured(1.0f, spot);

	(void)state;
	assert_true(first.primitive->lod_count > 0);
	for (int k = 0; k < 3; k++) {
		struct net net = make_textured(units[k], spot);

		assert_int_equal(
			net.primitive->lod_count, first.primitive->lod_count);
		for (int i = 0; i < net.primitive->lod_count; i++) {
			const struct model_lod *lod = &net.primitive->lod[i];
			const struct model_lod *wanted =
				&first.primitive->lod[i];

			assert_int_equal(lod->index_count, wanted->index_count);
			assert_memory_equal(lod->index, wanted->index,
				(size_t)lod->index_count * sizeof(*lod->index));
			assert_true(lod->shadow_only || lod->error_m > 0.01f ||
				has_vertex(lod, spot));
		}
		free_net(&net);
	}
	free_net(&first);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_shift_of_the_texture_counts_on_the_surface),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
