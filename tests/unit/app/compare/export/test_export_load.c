/* Exported models that are loaded at once. */
#include "app/compare/export/export.h"
#include "app/model/levels/levels.h"
#include "tests/support/model/compared_clip.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <string.h>

/* The image that a primitive's material shows, or NULL. */
static const struct model_image *shown(const struct model *model, int mesh)
{
	int material = model->mesh[mesh].primitive[0].material;
	int texture = material < 0 ? -1 : model->material[material].texture;

	return texture < 0 ? NULL : &model->image[model->texture[texture].image];
}

/* The loader keeps images in the order of their use, not in that of the file. */
static void test_loaded_exports_share_the_images_of_their_model(void **state)
{
	struct log_capture heard;
	struct model *model =
		model_fixture("gltf/material/textures.gltf", &heard);
	const struct comparison comparison = {.model = model};
	const struct comparison_row row = {
		.kind = COMPARISON_ORIGINAL, .targets = true};
	const struct log log = log_capture_begin(&heard);
	struct model_image first = model->image[0];
	struct model *loaded;
	int images = 0;

	(void)state;
	assert_true(model->image_count > 1);
	model->image[0] = model->image[1];
	model->image[1] = first;
	for (int i = 0; i < model->texture_count; i++) {
		int image = model->texture[i].image;

		model->texture[i].image = image < 2 ? 1 - image : image;
	}
	assert_int_equal(export_load(&comparison, &row, &log, &loaded), 0);
	assert_int_equal(loaded->mesh_count, model->mesh_count);
	for (int mesh = 0; mesh < model->mesh_count; mesh++) {
		const struct model_image *from = shown(model, mesh);
		const struct model_image *to = shown(loaded, mesh);

		assert_int_equal(from == NULL, to == NULL);
		if (from) {
			assert_ptr_equal(to->rgba, from->rgba);
			assert_int_equal(to->width, from->width);
			assert_int_equal(to->height, from->height);
			assert_int_equal(to->opaque, from->opaque);
			images++;
		}
	}
	assert_true(images > 1);
	model_destroy(loaded);
	model_destroy(model);
}

/*
 * The error in metres of the first level of a morph of two keys, whose file has
 * one mesh of one part. The joint's matrix is multiplied by a scale.
 */
static float first_error_m(
	struct compared_clip *bench, int joint, float scale, float unit_scale)
{
	float time_s[2] = {0.0f, bench->reference->clip->duration_s};
	struct comparison_clip clip = {.clip = bench->reference->clip_index};
	struct comparison_cell cell = {.keys = {2, time_s}};
	const struct comparison comparison = {.model = bench->model,
		.box = bench->screen.box,
		.unit_scale = unit_scale,
		.clip_count = 1,
		.clip = &clip};
	const struct comparison_row row = {.kind = COMPARISON_MORPH,
		.cell = &cell,
		.total = {.key_count = 2}};
	vec4 *matrix = bench->model->skin[0].inverse_bind[joint];
	struct model *loaded;
	float error_m;
	mat4 kept;

	memcpy(kept, matrix, sizeof(kept));
	for (int column = 0; column < 4; column++) {
		for (int axis = 0; axis < 3; axis++) {
			matrix[column][axis] *= scale;
		}
	}
	assert_int_equal(
		export_load(&comparison, &row, &bench->log, &loaded), 0);
	memcpy(matrix, kept, sizeof(kept));
	assert_true(loaded->mesh[0].primitive[0].lod_count > 0);
	error_m = loaded->mesh[0].primitive[0].lod[0].error_m *
		loaded->node[0].rest.scale[0];
	model_destroy(loaded);
	return error_m;
}

/* The joint that moves a mesh's first vertex may be any of its skin. */
static void test_levels_of_a_morph_are_those_of_all_joints(void **state)
{
	struct compared_clip bench;
	float plain_m;

	(void)state;
	compared_clip_begin(&bench, "assets/walker.glb", "idle");
	assert_int_equal(levels_make(bench.model), 0);
	plain_m = first_error_m(&bench, 0, 1.0f, 0.0f);
	assert_true(plain_m > 0.0f && bench.model->skin[0].joint_count > 1);
	/* The player takes half of the largest scale, at least the first one. */
	assert_near(first_error_m(&bench, 0, 1e-3f, 0.0f), 0.5f * plain_m,
		1e-3 * plain_m);
	assert_near(first_error_m(&bench, 1, 8.0f, 0.0f), 4.0f * plain_m,
		1e-2 * plain_m);
	compared_clip_end(&bench);
}

/* The unit in which the model was posed is none of the file. */
static void test_levels_of_a_morph_are_in_metres(void **state)
{
	struct compared_clip bench;
	float plain_m;

	(void)state;
	compared_clip_begin(&bench, "assets/walker.glb", "idle");
	assert_int_equal(levels_make(bench.model), 0);
	plain_m = first_error_m(&bench, 0, 1.0f, 1.0f);
	/* At rest, joints move the mesh as it is. */
	assert_near(plain_m, bench.model->mesh[0].primitive[0].lod[0].error_m,
		1e-3 * plain_m);
	assert_near(
		first_error_m(&bench, 0, 1.0f, 0.25f), plain_m, 1e-4 * plain_m);
	assert_near(
		first_error_m(&bench, 0, 1.0f, 8.0f), plain_m, 1e-4 * plain_m);
	compared_clip_end(&bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_loaded_exports_share_the_images_of_their_model),
		cmocka_unit_test(test_levels_of_a_morph_are_those_of_all_joints),
		cmocka_unit_test(test_levels_of_a_morph_are_in_metres),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
