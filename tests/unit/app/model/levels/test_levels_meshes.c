/* Which meshes' borders belong together in levels of detail. */
#include "app/model/levels/levels.h"
#include "tests/unit/app/model/levels/levels_net.h"

/* Two flat nets that touch, each a mesh of its own. */
static struct net two_meshes(int influences)
{
	struct net net = make_net(shape_flat, 2);
	struct arena *arena = &net.model->arena;

	net.model->mesh_count = 2;
	net.model->mesh = ARENA_ARRAY(arena, struct model_mesh, 2);
	assert_non_null(net.model->mesh);
	for (int m = 0; m < 2; m++) {
		struct model_primitive *primitive = &net.primitive[m];

		net.model->mesh[m].primitive_count = 1;
		net.model->mesh[m].primitive = primitive;
		if (influences > 0) {
			primitive->influences = influences;
			primitive->joint = ARENA_ARRAY(
				arena, uint16_t, (size_t)(COUNT * influences));
			primitive->weight = ARENA_ARRAY(
				arena, float, (size_t)(COUNT * influences));
			for (int v = 0; v < COUNT; v++) {
				primitive->weight[v * influences] = 1;
			}
		}
	}
	return net;
}

/* How many levels of both nets have all vertices of the common border. */
static int count_whole(const struct net *net)
{
	int count = 0;

	for (int m = 0; m < 2; m++) {
		const struct model_primitive *primitive = &net->primitive[m];

		assert_true(primitive->lod_count > 0);
		for (int l = 0; l < primitive->lod_count; l++) {
			bool whole = true;

			for (uint32_t v = 0; v < ROW; v++) {
				whole = whole &&
					has_vertex(&primitive->lod[l],
						v * ROW + (m ? 0 : SIDE));
			}
			count += whole;
		}
	}
	return count;
}

/* Nodes may move them apart. */
static void test_rigid_meshes_are_simplified_each_by_itself(void **state)
{
	struct net net = two_meshes(0), alone = make_net(shape_flat, 1);
	const struct model_primitive *first = net.primitive;

	(void)state;
	assert_int_equal(levels_make(net.model), 0);
	assert_int_equal(levels_make(alone.model), 0);
	assert_int_equal(count_whole(&net), 0);
	assert_int_equal(first->lod_count, alone.primitive->lod_count);
	for (int l = 0; l < first->lod_count; l++) {
		const struct model_lod *lod = &first->lod[l];

		assert_int_equal(
			lod->index_count, alone.primitive->lod[l].index_count);
		assert_near(lod->error_m, alone.primitive->lod[l].error_m, 0);
	}
	free_net(&alone);
	free_net(&net);
}

/* One skin may pose both, so that a gap would open between them. */
static void test_skinned_meshes_keep_their_common_border(void **state)
{
	(void)state;
	for (int influences = 1; influences <= 2; influences++) {
		struct net net = two_meshes(influences);

		assert_int_equal(levels_make(net.model), 0);
		assert_int_equal(count_whole(&net),
			net.primitive[0].lod_count + net.primitive[1].lod_count);
		free_net(&net);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_rigid_meshes_are_simplified_each_by_itself),
		cmocka_unit_test(test_skinned_meshes_keep_their_common_border),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
