/*
 * Skins whose joints mirror: their triangles are turned round, and so are the
 * front face and flat normals.
 */
#include "app/anim/math/vec.h"
#include "app/scene/draw/draw.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/model/instance_pair.h"
#include "tests/support/test.h"

static GLenum drawn_front_face(const struct instance *instance)
{
	struct gl gl = gl_recorder_begin();
	struct texture_set no_textures = {0};

	draw_instance(&gl, instance, &no_textures, DRAW_SHADED);
	assert_true(gl_recorder_result()->draw_count > 0);
	return gl_recorder_result()->draw[0].front_face;
}

/* Node 1 is the root joint of the fixture. */
static void mirror_root(struct instance *instance, float factor)
{
	instance->pose.local[1].scale[0] = factor;
	instance->pose.animated[1] = true;
	instance_update(instance);
}

static void test_mirrored_joints_turn_the_front_face(void **state)
{
	struct instance_pair pair;

	(void)state;
	instance_pair_load(
		&pair, "tests/fixtures/gltf/skin/no_inverse_bind.gltf");
	for (int i = 0; i < 2; i++) {
		struct instance *instance = i ? pair.fixed : pair.exact;

		mirror_root(instance, 1.0f);
		assert_int_equal(drawn_front_face(instance), GL_CCW);
		mirror_root(instance, 0.25f);
		assert_int_equal(drawn_front_face(instance), GL_CCW);
		mirror_root(instance, -1.0f);
		assert_int_equal(drawn_front_face(instance), GL_CW);
	}
	instance_pair_end(&pair);
}

/* Node 0 has the mesh and carries no joint. */
static void test_a_mirrored_node_of_the_mesh_turns_it_too(void **state)
{
	struct instance_pair pair;

	(void)state;
	instance_pair_load(
		&pair, "tests/fixtures/gltf/skin/no_inverse_bind.gltf");
	for (int i = 0; i < 2; i++) {
		struct instance *instance = i ? pair.fixed : pair.exact;

		instance->pose.local[0].scale[0] = -1.0f;
		instance->pose.animated[0] = true;
		instance_update(instance);
		assert_int_equal(drawn_front_face(instance), GL_CW);
		mirror_root(instance, -1.0f);
		assert_int_equal(drawn_front_face(instance), GL_CW);
	}
	instance_pair_end(&pair);
}

static void test_a_joint_that_is_flat_does_not_decide(void **state)
{
	struct instance_pair pair;

	(void)state;
	instance_pair_load(&pair, "tests/fixtures/gltf/skin/unsorted.gltf");
	for (int i = 0; i < 2; i++) {
		struct instance *instance = i ? pair.fixed : pair.exact;
		const struct model *model = instance->model;
		int first = model->skin[0].joint[0];
		int root = first;

		/* The skin's first joint is the tip of its chain. */
		while (model->node[root].parent >= 0) {
			root = model->node[root].parent;
		}
		instance->pose.local[first].scale[1] = 0.0f;
		instance->pose.local[root].scale[0] = -1.0f;
		instance_update(instance);
		assert_int_equal(drawn_front_face(instance), GL_CW);
	}
	instance_pair_end(&pair);
}

static void get_float_normal(const struct batch *batch, int corner, float out[3])
{
	memcpy(out, batch->normal[batch->index[corner]], sizeof(float[3]));
}

static void get_fixed_normal(const struct batch *batch, int corner, float out[3])
{
	const struct fixed_vector *n =
		&batch->fixed_normal[batch->index[corner]];

	out[0] = n->x;
	out[1] = n->y;
	out[2] = n->z;
}

/* A mirror image has the mirror image's normals. */
static void test_flat_normals_of_mirrored_skins_point_outwards(void **state)
{
	struct instance_pair pair;

	(void)state;
	instance_pair_load(
		&pair, "tests/fixtures/gltf/skin/no_inverse_bind.gltf");
	for (int i = 0; i < 2; i++) {
		struct instance *instance = i ? pair.fixed : pair.exact;
		const struct batch *batch = &instance->drawable[0].batch[0];
		void (*get)(const struct batch *batch, int corner,
			float out[3]) = i ? get_fixed_normal : get_float_normal;
		float straight[3], mirrored[3];

		mirror_root(instance, 1.0f);
		get(batch, 2, straight);
		mirror_root(instance, -1.0f);
		get(batch, 2, mirrored);
		vec_normalize(straight);
		vec_normalize(mirrored);
		straight[0] = -straight[0];
		assert_all_near(mirrored, straight, 3, 1e-3);
	}
	instance_pair_end(&pair);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_mirrored_joints_turn_the_front_face),
		cmocka_unit_test(test_a_joint_that_is_flat_does_not_decide),
		cmocka_unit_test(
			test_flat_normals_of_mirrored_skins_point_outwards),
		cmocka_unit_test(test_a_mirrored_node_of_the_mesh_turns_it_too),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
