/* A model that is exported with its skins, and what is loaded from its file. */
#include "app/compare/export/export.h"
#include "app/compare/export/export_bake.h"
#include "app/model/model_deltas.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/model/written_glb.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	INFLUENCES = 8
};

/* Exports the model with at most so many influences, and loads it. */
static struct model *loaded_of(
	const struct comparison *comparison, int max, bool targets)
{
	struct log log = log_to_stderr(LOG_WARNING);
	const struct comparison_row row = {.kind = COMPARISON_ORIGINAL,
		.max_influences = max,
		.targets = targets};
	struct model *loaded;

	assert_int_equal(export_load(comparison, &row, &log, &loaded), 0);
	return loaded;
}

static struct model *exported(const struct model *model, int max, bool targets)
{
	const struct comparison comparison = {.model = model};

	return loaded_of(&comparison, max, targets);
}

static void expect_floats(
	const void *value, const void *wanted, int count, double tolerance)
{
	assert_int_equal(value == NULL, wanted == NULL);
	if (wanted) {
		assert_all_near(value, wanted, count, tolerance);
	}
}

static void expect_deltas(const struct model_deltas *deltas,
	const struct model_deltas *wanted, int vertex_count)
{
	assert_int_equal(deltas->vertex_count == 0, wanted->vertex_count == 0);
	for (int v = 0; v < vertex_count; v++) {
		float a[3], b[3];

		model_deltas_get(deltas, v, a);
		model_deltas_get(wanted, v, b);
		assert_all_near(a, b, 3, 0.0);
	}
}

static void expect_levels(const struct model_primitive *primitive,
	const struct model_primitive *wanted)
{
	assert_int_equal(primitive->lod_count, wanted->lod_count);
	for (int i = 0; i < wanted->lod_count; i++) {
		const struct model_lod *lod = &primitive->lod[i];

		assert_near(lod->error_m, wanted->lod[i].error_m, 1e-6);
		assert_int_equal(lod->index_count, wanted->lod[i].index_count);
		assert_memory_equal(lod->index, wanted->lod[i].index,
			(size_t)lod->index_count * sizeof(*lod->index));
	}
}

static void expect_primitive(const struct model_primitive *primitive,
	const struct model_primitive *wanted, int target_count)
{
	int count = wanted->vertex_count;

	assert_int_equal(primitive->vertex_count, count);
	assert_int_equal(primitive->material, wanted->material);
	assert_int_equal(primitive->index_count, wanted->index_count);
	assert_memory_equal(primitive->index, wanted->index,
		(size_t)wanted->index_count * sizeof(*wanted->index));
	expect_floats(primitive->position, wanted->position, 3 * count, 0.0);
	expect_floats(primitive->normal, wanted->normal, 3 * count, 1e-6);
	expect_floats(primitive->texcoord, wanted->texcoord, 2 * count, 0.0);
	assert_int_equal(primitive->color == NULL, wanted->color == NULL);
	if (wanted->color) {
		assert_memory_equal(
			primitive->color, wanted->color, (size_t)count * 4);
	}
	for (int t = 0; t < target_count; t++) {
		expect_deltas(&primitive->target[t].position,
			&wanted->target[t].position, count);
		expect_deltas(&primitive->target[t].normal,
			&wanted->target[t].normal, count);
	}
	expect_levels(primitive, wanted);
}

static void expect_skins(const struct model *model, const struct model *wanted)
{
	assert_int_equal(model->skin_count, wanted->skin_count);
	for (int s = 0; s < wanted->skin_count; s++) {
		const struct model_skin *skin = &wanted->skin[s];
		size_t joints = (size_t)skin->joint_count;

		assert_int_equal(model->skin[s].joint_count, skin->joint_count);
		assert_memory_equal(model->skin[s].joint, skin->joint,
			joints * sizeof(*skin->joint));
		assert_all_near(model->skin[s].inverse_bind, skin->inverse_bind,
			16 * skin->joint_count, 0.0);
	}
}

static void expect_same(const struct model *model, const struct model *wanted)
{
	assert_int_equal(model->mesh_count, wanted->mesh_count);
	for (int m = 0; m < wanted->mesh_count; m++) {
		const struct model_mesh *mesh = &wanted->mesh[m];

		assert_string_equal(model->mesh[m].name, mesh->name);
		assert_int_equal(
			model->mesh[m].target_count, mesh->target_count);
		assert_int_equal(
			model->mesh[m].primitive_count, mesh->primitive_count);
		for (int p = 0; p < mesh->primitive_count; p++) {
			expect_primitive(&model->mesh[m].primitive[p],
				&mesh->primitive[p], mesh->target_count);
		}
	}
	for (int n = 0; n < wanted->node_count; n++) {
		assert_int_equal(model->node[n].mesh, wanted->node[n].mesh);
		assert_int_equal(model->node[n].skin, wanted->node[n].skin);
	}
	expect_skins(model, wanted);
}

static void test_what_is_loaded_is_what_was_exported(void **state)
{
	static const char *const names[] = {"skin/and_morph.gltf",
		"skin/shared_mesh.gltf", "skin/no_inverse_bind.gltf",
		"mesh/colors.gltf", "mesh/levels.gltf", "mesh/weights.gltf",
		"material/textures.gltf", "scene/matrices.gltf"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(names); i++) {
		char name[64];
		struct log_capture heard;
		struct model *model, *loaded;

		snprintf(name, sizeof(name), "gltf/%s", names[i]);
		model = model_fixture(name, &heard);
		loaded = exported(model, 0, true);
		expect_same(loaded, model);
		model_destroy(loaded);
		model_destroy(model);
	}
}

static void test_a_skin_without_targets_keeps_the_rest(void **state)
{
	struct model *model = model_fixture("gltf/skin/and_morph.gltf", NULL);
	struct model *loaded = exported(model, 0, false);

	(void)state;
	assert_true(model->mesh[0].target_count > 0);
	assert_int_equal(loaded->mesh[0].target_count, 0);
	for (int m = 0; m < model->mesh_count; m++) {
		model->mesh[m].target_count = 0;
	}
	expect_same(loaded, model);
	model_destroy(loaded);
	model_destroy(model);
}

static void test_a_single_target_is_exported(void **state)
{
	struct model *model = model_fixture("gltf/skin/and_morph.gltf", NULL);
	struct model *loaded;

	(void)state;
	for (int m = 0; m < model->mesh_count; m++) {
		model->mesh[m].target_count = 1;
	}
	loaded = exported(model, 0, true);
	expect_same(loaded, model);
	model_destroy(loaded);
	model_destroy(model);
}

/* Of two clips the compared one, and its weights with the targets. */
static void test_compared_clips_are_exported(void **state)
{
	struct model *model = model_fixture("gltf/mesh/weights.gltf", NULL);
	struct model_clip *own = model->clip;
	float time_s[2] = {0.0f, 0.5f}, value[8] = {0, 0, 0, 0, 1, 2, 3, 4};
	struct model_channel channel = {.path = MODEL_WEIGHTS,
		.interpolation = MODEL_LINEAR,
		.key_count = 2,
		.time_s = time_s,
		.value = value};
	struct model_clip clip[2] = {{.name = "none"},
		{"turn", 0.5f, .channel_count = 1, .channel = &channel}};
	struct comparison_clip compared = {.clip = 1};
	const struct comparison comparison = {
		.model = model, .clip_count = 1, .clip = &compared};
	int own_count = model->clip_count;

	(void)state;
	while (model->node[channel.node].mesh < 0) {
		channel.node++;
	}
	channel.width = model->mesh[model->node[channel.node].mesh].target_count;
	assert_in_range(channel.width, 1, 4);
	model->clip = clip;
	model->clip_count = 2;
	for (int targets = 0; targets < 2; targets++) {
		struct model *loaded = loaded_of(&comparison, 0, targets);

		assert_int_equal(loaded->clip_count, 1);
		assert_string_equal(loaded->clip[0].name, "turn");
		assert_int_equal(loaded->clip[0].channel_count, 1);
		assert_int_equal(
			loaded->clip[0].channel[0].path == MODEL_WEIGHTS,
			targets);
		model_destroy(loaded);
	}
	model->clip = own;
	model->clip_count = own_count;
	model_destroy(model);
}

/* A vertex's influence number i, in an order that is not that of the weights. */
static int joint_of(int vertex, int i)
{
	return (3 * i + vertex) % INFLUENCES;
}

static float weight_of(int vertex, int i)
{
	return (float)(1 + (5 * i + vertex) % INFLUENCES) / 36.0f;
}

/* Three vertices of eight influences, each with another weight. */
static struct model *model_of_eight(void)
{
	struct model *model =
		model_fixture("gltf/skin/eight_influences.gltf", NULL);
	struct model_primitive *primitive = model->mesh[0].primitive;

	assert_int_equal(primitive->influences, INFLUENCES);
	for (int v = 0; v < primitive->vertex_count; v++) {
		for (int i = 0; i < INFLUENCES; i++) {
			primitive->joint[v * INFLUENCES + i] =
				(uint16_t)joint_of(v, i);
			primitive->weight[v * INFLUENCES + i] = weight_of(v, i);
		}
	}
	return model;
}

/* The weight that the joint has among a vertex's influences. */
static float weight_in(
	const struct model_primitive *primitive, int vertex, int joint)
{
	int count = primitive->influences;
	float sum = 0.0f;

	for (int i = vertex * count; i < (vertex + 1) * count; i++) {
		sum += primitive->joint[i] == joint ? primitive->weight[i]
						    : 0.0f;
	}
	return sum;
}

/* The largest weights of each vertex are kept and add up to 1 again. */
static void test_influences_that_are_kept(void **state)
{
	struct model *model = model_of_eight();

	(void)state;
	for (int max = 0; max <= INFLUENCES + 1; max++) {
		struct model *loaded = exported(model, max, true);
		const struct model_primitive *primitive =
			loaded->mesh[0].primitive;
		int kept = max > 0 && max < INFLUENCES ? max : INFLUENCES;
		/* of weights 8 / 36 and less */
		float sum = (float)(kept * (17 - kept)) / 72.0f;

		assert_int_equal(primitive->influences, kept > 4 ? 8 : 4);
		for (int k = 0; k < 3 * INFLUENCES; k++) {
			int v = k / INFLUENCES, i = k % INFLUENCES;
			float weight = weight_of(v, i);

			weight = weight * 36.0f >
					(float)(INFLUENCES - kept) + 0.5f
				? weight / sum
				: 0.0f;
			assert_near(weight_in(primitive, v, joint_of(v, i)),
				weight, 1e-6);
		}
		model_destroy(loaded);
	}
	model_destroy(model);
}

/* Attributes of sets that no vertex needs would take 24 bytes of each. */
static void test_a_set_of_weights_has_four_influences(void **state)
{
	static const int sets[] = {2, 1, 1, 1, 1, 2, 2, 2, 2, 2};
	struct model *model = model_of_eight();
	const struct comparison comparison = {.model = model};

	(void)state;
	for (int max = 0; max < (int)ARRAY_COUNT(sets); max++) {
		struct written_glb written;
		const json_t *attributes;
		struct glb glb;

		glb_begin_memory(&glb);
		export_skin(&glb, &comparison, max, true);
		written = written_glb_take(&glb);
		attributes = json_object_get(written.root, "meshes");
		attributes = json_object_get(
			json_array_get(attributes, 0), "primitives");
		attributes = json_object_get(
			json_array_get(attributes, 0), "attributes");
		for (int set = 0; set < 4; set++) {
			char joints[16], weights[16];

			snprintf(joints, sizeof(joints), "JOINTS_%d", set);
			snprintf(weights, sizeof(weights), "WEIGHTS_%d", set);
			assert_int_equal(
				json_object_get(attributes, joints) != NULL,
				set < sets[max]);
			assert_int_equal(
				json_object_get(attributes, weights) != NULL,
				set < sets[max]);
		}
		written_glb_release(&written);
	}
	model_destroy(model);
}

/* Members that are empty, or of one without them, are not valid in glTF. */
static void test_a_model_without_skins_and_targets_names_none(void **state)
{
	struct model *model = model_fixture("gltf/mesh/colors.gltf", NULL);
	const struct comparison comparison = {.model = model};
	struct written_glb written;
	const json_t *primitives;
	struct glb glb;

	(void)state;
	glb_begin_memory(&glb);
	export_skin(&glb, &comparison, 0, true);
	written = written_glb_take(&glb);
	written_glb_expect(&written, "skins", "");
	written_glb_expect(&written, "animations", "");
	primitives = json_object_get(
		json_array_get(json_object_get(written.root, "meshes"), 0),
		"primitives");
	assert_null(json_object_get(json_array_get(primitives, 0), "targets"));
	written_glb_release(&written);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_what_is_loaded_is_what_was_exported),
		cmocka_unit_test(test_a_skin_without_targets_keeps_the_rest),
		cmocka_unit_test(test_a_single_target_is_exported),
		cmocka_unit_test(test_compared_clips_are_exported),
		cmocka_unit_test(test_influences_that_are_kept),
		cmocka_unit_test(test_a_set_of_weights_has_four_influences),
		cmocka_unit_test(
			test_a_model_without_skins_and_targets_names_none),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
