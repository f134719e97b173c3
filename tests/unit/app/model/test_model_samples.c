/*
 * The contents of Khronos' sample models, which are not part of the project;
 * the test is skipped without them (tests/support/model/samples.h).
 */
#include "app/model/model.h"
#include "app/model/model_stats.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/samples.h"
#include "tests/support/test.h"

#include <math.h>

struct sample {
	const char *name;
	int nodes, meshes, skins, joints, clips, channels;
	int vertices, triangles, targets, influences, images;
	float duration_s;
};

/* clang-format off */
static const struct sample samples[] = {
	{"AnimatedMorphCube.glb",    1, 1, 0,  0, 1,  1,   24,   12, 2, 0, 0, 4.19999743f},
	{"AnimatedTriangle.gltf",    1, 1, 0,  0, 1,  1,    3,    1, 0, 0, 0, 1},
	{"BoxAnimated.glb",          4, 2, 0,  0, 1,  2,  320,  254, 0, 0, 0, 3.70832992f},
	{"CesiumMan.glb",           22, 1, 1, 19, 1, 57, 3273, 4672, 0, 4, 1, 2},
	{"RiggedFigure.glb",        22, 1, 1, 19, 1, 57,  370,  256, 0, 4, 0, 1.25f},
	{"RiggedSimple.glb",         5, 1, 1,  2, 1,  3,  160,  188, 0, 2, 0, 2.08333302f},
	{"SimpleMorph.gltf",         1, 1, 0,  0, 1,  1,    3,    1, 2, 0, 0, 4},
	{"SimpleSkin.gltf",          3, 1, 1,  2, 1,  1,   10,    8, 0, 2, 0, 5.5f},
	{"SimpleSparseAccessor.gltf",1, 1, 0,  0, 0,  0,   14,   12, 0, 0, 0, 0},
};
/* clang-format on */

static struct model *load(const struct sample *sample)
{
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct model *model;

	if (model_load(samples_path(sample->name).text, &log, &model) != 0) {
		fail_msg("%s", logged.sentence[0]);
	}
	assert_int_equal(logged.count, 0);
	return model;
}

static void expect_facts(const struct sample *sample, const struct model *model)
{
	struct model_stats stats;

	model_measure(model, &stats);
	print_message("# %s\n", sample->name);
	assert_int_equal(model->node_count, sample->nodes);
	assert_int_equal(model->mesh_count, sample->meshes);
	assert_int_equal(model->skin_count, sample->skins);
	if (model->skin_count) {
		assert_int_equal(model->skin[0].joint_count, sample->joints);
	}
	assert_int_equal(model->clip_count, sample->clips);
	assert_int_equal(stats.channel_count, sample->channels);
	assert_int_equal(stats.vertex_count, sample->vertices);
	assert_int_equal(stats.triangle_count, sample->triangles);
	assert_int_equal(stats.target_count, sample->targets);
	assert_int_equal(stats.max_influences, sample->influences);
	assert_int_equal(model->image_count, sample->images);
	assert_near(stats.longest_s, sample->duration_s, 0);
}

static void expect_sound_primitive(
	const struct model *model, const struct model_primitive *primitive)
{
	int i, k;

	assert_in_range(primitive->material, 0, model->material_count - 1);
	assert_int_equal(primitive->index_count % 3, 0);
	for (i = 0; i < primitive->index_count; i++) {
		assert_true(primitive->index[i] <
			(uint32_t)primitive->vertex_count);
	}
	for (i = 0; i < primitive->vertex_count; i++) {
		float sum = 0;

		assert_true(fabsf(primitive->position[i][0]) < 100);
		for (k = 0; k < primitive->influences; k++) {
			sum += primitive->weight[i * primitive->influences + k];
		}
		if (primitive->influences) {
			assert_near(sum, 1, 1e-6);
		}
		if (primitive->normal) {
			const float *n = primitive->normal[i];

			assert_near(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1,
				1e-5);
		}
	}
}

/* The guarantees of model.h. */
static void expect_sound(const struct model *model)
{
	int i, k;

	for (i = 0; i < model->node_count; i++) {
		assert_in_range(model->node[i].parent + 1, 0, i);
		assert_non_null(model->node[i].name);
		assert_true(model->node[i].in_scene);
	}
	for (i = 0; i < model->mesh_count; i++) {
		for (k = 0; k < model->mesh[i].primitive_count; k++) {
			expect_sound_primitive(
				model, &model->mesh[i].primitive[k]);
		}
	}
	for (i = 0; i < model->clip_count; i++) {
		for (k = 0; k < model->clip[i].channel_count; k++) {
			const struct model_channel *channel =
				&model->clip[i].channel[k];

			assert_in_range(channel->node, 0, model->node_count - 1);
			assert_in_range(channel->key_count, 1, 200);
		}
	}
}

static void test_loads_the_samples(void **state)
{
	size_t i;

	(void)state;
	samples_require("");
	for (i = 0; i < sizeof(samples) / sizeof(samples[0]); i++) {
		struct model *model = load(&samples[i]);

		expect_facts(&samples[i], model);
		expect_sound(model);
		model_destroy(model);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_loads_the_samples),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
