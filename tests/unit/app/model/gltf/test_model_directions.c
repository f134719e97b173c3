/*
 * Which directions of glTF files get unit length: rotation keys that are far
 * from it, all normals and tangents. And which nodes are the parents.
 */
#include "tests/unit/app/model/gltf/buffer.h"

#include <string.h>

enum {
	FLOATS = 30 /* of a buffer */
};

/* Loads a clip that turns a node by this key, and reads the key. */
static void read_key(const float key[4], float out[4])
{
	float number[FLOATS] = {0};
	struct model *model;

	memcpy(number + 1, key, 4 * sizeof(*key));
	model = buffer_model(number, sizeof(number),
		"'nodes':[{}],'accessors':[{'bufferView':0,"
		"'componentType':5126,'count':1,'type':'SCALAR'},"
		"{'bufferView':0,'byteOffset':4,'componentType':5126,"
		"'count':1,'type':'VEC4'}],'animations':[{'samplers':["
		"{'input':0,'output':1}],'channels':[{'sampler':0,"
		"'target':{'node':0,'path':'rotation'}}]}]");
	memcpy(out, model->clip[0].channel[0].value, 4 * sizeof(*out));
	model_destroy(model);
}

/* Squares of lengths from 0.98 to 1.02 are left, whichever axes they have. */
static void test_float_rotations_are_kept_near_unit_length(void **state)
{
	static const struct {
		float length;
		bool is_kept;
	} cases[] = {{0.9895f, false}, {0.9905f, true}, {1.0095f, true},
		{1.0105f, false}, {0.5f, false}, {3.0f, false}};

	(void)state;
	for (int i = 0; i < 16; i++) {
		for (size_t c = 0; c < sizeof(cases) / sizeof(cases[0]); c++) {
			float length = cases[c].length;
			float key[4] = {0}, wanted[4] = {0}, out[4];

			wanted[i / 4] = 0.6f;
			wanted[i % 4] = i / 4 == i % 4 ? 1.0f : -0.8f;
			for (int k = 0; k < 4; k++) {
				key[k] = wanted[k] * length;
			}
			read_key(key, out);
			if (cases[c].is_kept) {
				assert_all_near(out, key, 4, 0);
			} else {
				assert_all_near(out, wanted, 4, 1e-6);
			}
		}
	}
}

/* Three corners, their normals and tangents of these lengths. */
static void test_normals_and_tangents_get_unit_length(void **state)
{
	(void)state;
	for (int i = 0; i < 9; i++) {
		int axis = i / 3, next = i % 3;
		const struct model_primitive *primitive;
		float number[FLOATS] = {0}, wanted[3] = {0};
		struct model *model;

		wanted[axis] = 0.6f;
		wanted[next] = axis == next ? 1.0f : -0.8f;
		number[3] = number[7] = 1;
		for (int v = 0; v < 3; v++) {
			for (int k = 0; k < 3; k++) {
				number[9 + 3 * v + k] =
					(float)v * 2.0f * wanted[k];
				number[18 + 4 * v + k] =
					(float)v * 0.3f * wanted[k];
			}
			number[18 + 4 * v + 3] = v == 1 ? -0.5f : 0.0f;
		}
		model = buffer_model(number, sizeof(number),
			"'accessors':[{'bufferView':0,'componentType':5126,"
			"'count':3,'type':'VEC3'},{'bufferView':0,"
			"'byteOffset':36,'componentType':5126,'count':3,"
			"'type':'VEC3'},{'bufferView':0,'byteOffset':72,"
			"'componentType':5126,'count':3,'type':'VEC4'}],"
			"'meshes':[{'primitives':[{'attributes':{'POSITION':0,"
			"'NORMAL':1,'TANGENT':2}}]}],'nodes':[{'mesh':0}]");
		primitive = &model->mesh[0].primitive[0];
		for (int v = 0; v < 3; v++) {
			for (int k = 0; k < 3; k++) {
				float one = v == 0 ? 0.0f : wanted[k];

				assert_near(primitive->normal[v][k], one, 1e-6);
				assert_near(primitive->tangent[v][k], one, 1e-6);
			}
			assert_near(
				primitive->tangent[v][3], v == 1 ? -1 : 1, 0);
		}
		model_destroy(model);
	}
}

/* Node 0 and the last one may be parents, and are no roots. */
static void test_each_node_may_be_a_parent(void **state)
{
	static const int parents[] = {3, 0, 0, -1, 2};
	static const float number[FLOATS] = {0};
	struct model *model = buffer_model(number, sizeof(number),
		"'nodes':[{'children':[1,2]},{},{'children':[4]},"
		"{'children':[0]},{}]");

	(void)state;
	assert_int_equal(model->node_count, 5);
	for (int i = 0; i < 5; i++) {
		int parent = fixture_node(model, i)->parent;

		assert_int_equal(
			parent < 0 ? -1 : model->node[parent].file_index,
			parents[i]);
	}
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_float_rotations_are_kept_near_unit_length),
		cmocka_unit_test(test_normals_and_tangents_get_unit_length),
		cmocka_unit_test(test_each_node_may_be_a_parent),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
