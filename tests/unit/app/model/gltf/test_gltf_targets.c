/* Morph targets of glTF files: their numbers, and those that are key frames. */
#include "app/model/model_keys.h"
#include "tests/support/model/deltas.h"
#include "tests/unit/app/model/gltf/buffer.h"

#include <string.h>

enum {
	VERTICES = 3,
	TARGETS = 2
};

/* A buffer, as the accessors below count it. */
struct file {
	float position[VERTICES][3], time[2], weight[2][TARGETS];
	float floats[TARGETS][VERTICES][3];
	int16_t shorts[TARGETS][VERTICES][3];
	int8_t bytes[TARGETS][VERTICES][3];
	int8_t rest[6]; /* a multiple of three bytes */
};

static const struct file file = {.position = {{0}, {4, 0, 0}, {0, 8, 0}},
	.time = {0, 1},
	.weight = {{1, 0}, {0, 1}},
	.floats = {{{0.5f, 1, 2}, {-3, 4, 5}, {6, 7, -8}},
		{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}}},
	.shorts = {{{1, -2, 3}, {4, 5, 300}, {-7, 8, 9}},
		{{2, 0, 1}, {0, 400, 0}, {0, 1, -6}}},
	.bytes = {{{9, 8, -7}, {6, 5, 4}, {3, 2, 1}},
		{{-1, 2, 3}, {4, 127, 6}, {7, 8, -9}}}};

#define ACCESSOR                                                          \
	"{'bufferView':0,'byteOffset':%zu,'componentType':%d,'count':%d," \
	"'type':'%s','normalized':%s}"

/* What differs between files. */
struct kind {
	size_t at, size; /* of the targets' values, and of each target's */
	int component;
	bool is_normalized;
	const char *node;   /* more members of the node */
	const char *others; /* and of the file */
	const char *attribute;
};

#define WEIGHTS                                                            \
	",'animations':[{'samplers':[{'input':1,'output':2}],'channels':[" \
	"{'sampler':0,'target':{'node':0,'path':'weights'}}]}]"

static struct model *load(const struct kind *kind)
{
	char text[BUFFER_TEXT];
	const char *normalized = kind->is_normalized ? "true" : "false";

	snprintf(text, sizeof(text),
		"'accessors':[" ACCESSOR "," ACCESSOR "," ACCESSOR "," ACCESSOR
		"," ACCESSOR "," ACCESSOR
		"],'meshes':[{'primitives':[{'attributes':{"
		"'POSITION':0,'NORMAL':0,'TANGENT':5},'targets':[{'%s':3},{'%s':4}]}]}],"
		"'nodes':[{'mesh':0%s}]%s",
		offsetof(struct file, position), 5126, VERTICES, "VEC3",
		"false", offsetof(struct file, time), 5126, 2, "SCALAR",
		"false", offsetof(struct file, weight), 5126, 2 * TARGETS,
		"SCALAR", "false", kind->at, kind->component, VERTICES, "VEC3",
		normalized, kind->at + kind->size, kind->component, VERTICES,
		"VEC3", normalized, (size_t)0, 5126, VERTICES, "VEC4", "false",
		kind->attribute, kind->attribute, kind->node, kind->others);
	return buffer_model(&file, sizeof(file), text);
}

/* The displacement of a vertex in the file. */
static float value_of(const struct kind *kind, int t, int v, int i)
{
	switch (kind->component) {
	case 5122:
		return (float)file.shorts[t][v][i] /
			(kind->is_normalized ? 32767.0f : 1.0f);
	case 5120:
		return (float)file.bytes[t][v][i] /
			(kind->is_normalized ? 127.0f : 1.0f);
	default:
		return file.floats[t][v][i];
	}
}

static void expect_values(const struct kind *kind, struct model *model,
	enum model_number number, float unit)
{
	for (int t = 0; t < TARGETS; t++) {
		const struct model_target *target =
			&model->mesh[0].primitive[0].target[t];
		const struct model_deltas *all[] = {
			&target->position, &target->normal, &target->tangent};
		static const char *const names[] = {
			"POSITION", "NORMAL", "TANGENT"};
		float wanted[VERTICES][3];

		for (int k = 0; k < VERTICES * 3; k++) {
			wanted[k / 3][k % 3] = value_of(kind, t, k / 3, k % 3);
		}
		for (int i = 0; i < 3; i++) {
			if (strcmp(names[i], kind->attribute) != 0) {
				assert_int_equal(all[i]->vertex_count, 0);
				continue;
			}
			assert_int_equal(all[i]->number, number);
			assert_near(all[i]->unit, unit, 0);
			assert_deltas(
				all[i], (const float(*)[3])wanted, VERTICES);
		}
	}
}

#define FLOATS offsetof(struct file, floats), sizeof(file.floats[0]), 5126
#define SHORTS offsetof(struct file, shorts), sizeof(file.shorts[0]), 5122
#define BYTES  offsetof(struct file, bytes), sizeof(file.bytes[0]), 5120

/* Integers stay what they are, and outlive the load. */
static void test_targets_keep_the_numbers_of_the_file(void **state)
{
	static const struct {
		struct kind kind;
		enum model_number number;
		float unit;
	} cases[] = {
		{{FLOATS, false, "", "", "POSITION"}, MODEL_FLOAT, 1},
		{{SHORTS, false, "", "", "POSITION"}, MODEL_INT16, 1},
		{{SHORTS, true, "", "", "POSITION"}, MODEL_INT16, 32767},
		{{BYTES, false, "", "", "POSITION"}, MODEL_INT8, 1},
		{{BYTES, true, "", "", "POSITION"}, MODEL_INT8, 127},
		{{FLOATS, false, "", "", "NORMAL"}, MODEL_FLOAT, 1},
		{{SHORTS, true, "", "", "NORMAL"}, MODEL_INT16, 32767},
		{{BYTES, true, "", "", "NORMAL"}, MODEL_INT8, 127},
		{{FLOATS, false, "", "", "TANGENT"}, MODEL_FLOAT, 1},
		{{SHORTS, true, "", "", "TANGENT"}, MODEL_INT16, 32767},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(*cases); i++) {
		struct model *model = load(&cases[i].kind);

		assert_null(model->mesh[0].primitive[0].keys);
		expect_values(
			&cases[i].kind, model, cases[i].number, cases[i].unit);
		model_destroy(model);
	}
}

/* With a clip, integers of a node without a skin become key frames. */
static void test_only_integers_without_a_skin_become_key_frames(void **state)
{
	static const struct {
		struct kind kind;
		bool are_keys;
	} cases[] = {
		{{SHORTS, false, "", WEIGHTS, "POSITION"}, true},
		{{BYTES, false, "", WEIGHTS, "POSITION"}, true},
		{{SHORTS, false, "", "", "POSITION"}, false},
		{{FLOATS, false, "", WEIGHTS, "POSITION"}, false},
		{{SHORTS, false, ",'skin':0",
			 ",'skins':[{'joints':[0]}]" WEIGHTS, "POSITION"},
			false},
		{{SHORTS, false, "},{'mesh':0", WEIGHTS, "POSITION"}, true},
		{{SHORTS, false, "},{'mesh':0,'skin':0",
			 ",'skins':[{'joints':[0]}]" WEIGHTS, "POSITION"},
			true},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(*cases); i++) {
		struct model *model = load(&cases[i].kind);
		const struct model_primitive *primitive =
			&model->mesh[0].primitive[0];

		assert_int_equal(primitive->keys != NULL, cases[i].are_keys);
		for (int v = 0; v < VERTICES; v++) {
			float delta[3];

			model_deltas_get(
				&primitive->target[1].position, v, delta);
			for (int k = 0; k < 3; k++) {
				assert_near(delta[k],
					value_of(&cases[i].kind, 1, v, k), 0);
			}
		}
		model_destroy(model);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_targets_keep_the_numbers_of_the_file),
		cmocka_unit_test(
			test_only_integers_without_a_skin_become_key_frames),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
