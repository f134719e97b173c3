/* Exported models that are loaded at once. */
#include "app/compare/export/export.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

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

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_loaded_exports_share_the_images_of_their_model),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
