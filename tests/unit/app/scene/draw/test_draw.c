#include "app/scene/draw/draw.h"
#include "tests/support/gl/gl_checks.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

static void test_a_rigid_mesh_is_placed_by_its_node(void **state)
{
	struct model *model = small_model_grid(1, 1, 1000.0f, true);
	struct instance *instance = small_model_instance(model);
	struct gl gl = gl_recorder_begin();
	struct texture_set no_textures = {0};
	const struct gl_recorded_draw *draw = gl_recorder_result()->draw;
	float(*position)[3] = instance->drawable[0].position;

	(void)state;
	instance->pose.local[0].translation[0] = 500.0f;
	instance_update(instance);
	draw_instance(&gl, instance, &no_textures, DRAW_SHADED);
	assert_int_equal(gl_recorder_result()->draw_count, 1);
	assert_int_equal(draw->count, 6);
	assert_near(draw->matrix[0] * position[3][0] + draw->matrix[12],
		1500.0 * instance->unit_scale, 1e-3);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_a_mirrored_node_turns_the_front_face(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct instance *instance = small_model_instance(model);
	struct gl gl = gl_recorder_begin();
	struct texture_set no_textures = {0};

	(void)state;
	instance->pose.local[0].scale[0] = -1.0f;
	instance_update(instance);
	draw_instance(&gl, instance, &no_textures, DRAW_SHADED);
	assert_int_equal(gl_recorder_result()->draw[0].front_face, GL_CW);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_an_edge_of_two_triangles_is_drawn_once(void **state)
{
	/* 8 x 8 squares: 2 x 8 x 9 sides and 64 diagonals. */
	struct model *model = small_model_grid(8, 8, 1.0f, true);
	struct instance *instance = small_model_instance(model);
	struct gl gl = gl_recorder_begin();
	struct texture_set no_textures = {0};

	(void)state;
	instance_update(instance);
	draw_instance(&gl, instance, &no_textures, DRAW_EDGES);
	assert_int_equal(gl_recorder_result()->draw_count, 1);
	assert_int_equal(gl_recorder_result()->draw[0].count, 2 * (144 + 64));
	instance_destroy(instance);
	model_destroy(model);
}

static void test_hidden_drawables_cost_no_call(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct instance *instance = small_model_instance(model);
	struct gl gl = gl_recorder_begin();
	struct texture_set no_textures = {0};

	(void)state;
	instance->drawable[0].hidden = true;
	draw_instance(&gl, instance, &no_textures, DRAW_SHADED);
	assert_int_equal(gl_recorder_result()->draw_count, 0);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_blended_surfaces_come_after_opaque_ones(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct model_primitive two[2] = {
		model->mesh[0].primitive[0], model->mesh[0].primitive[0]};
	struct model_material material[2] = {
		model->material[0], model->material[0]};
	struct gl gl = gl_recorder_begin();
	struct texture_set no_textures = {0};
	struct instance *instance;

	(void)state;
	material[0].alpha = MODEL_BLEND;
	material[0].base_color[3] = 0.5f;
	two[1].material = 1;
	two[1].index_count = 3;
	model->mesh[0].primitive = two;
	model->mesh[0].primitive_count = model->material_count = 2;
	model->material = material;
	instance = small_model_instance(model);
	draw_instance(&gl, instance, &no_textures, DRAW_SHADED);
	assert_int_equal(gl_recorder_result()->draw_count, 2);
	assert_int_equal(gl_recorder_result()->draw[0].count, 3);
	assert_int_equal(gl_recorder_result()->draw[1].count, 6);
	instance_destroy(instance);
	model_destroy(model);
}

/* Draws a quad over the whole picture as a shadow on white. */
static void draw_shadow(struct gl_canvas *canvas, const struct model *model)
{
	struct instance *instance = small_model_instance(model);
	struct log nowhere = log_to_nowhere();
	struct texture_set textures;
	struct gl *gl = canvas->gl;

	small_model_fill_picture(instance);
	assert_int_equal(texture_set_create(&textures, model, gl,
				 PIXELS_RGBA8888, &nowhere),
		0);
	gl->ClearColorx(65536, 65536, 65536, 65536);
	gl->Clear(GL_COLOR_BUFFER_BIT);
	draw_set_shadow_color(gl, DRAW_SHADOW_ALPHA);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	draw_instance(gl, instance, &textures, DRAW_SHADOW);
	gl_canvas_end_frame(canvas);
	texture_set_destroy(&textures, gl);
	instance_destroy(instance);
}

/* A texel of this alpha is a hole; the base colour's alpha counts, too. */
static void check_masked_shadow(
	const char *driver, uint8_t hole_alpha, float base_alpha, float cutoff)
{
	const uint8_t holed[2][4] = {
		{255, 255, 255, 255}, {0, 0, 0, hole_alpha}};
	struct gl_canvas canvas = gl_canvas_open(driver, PIXELS_RGBA8888);
	struct model *model = small_model_grid(1, 1, 1.0f, true);

	small_model_add_normal_map(model, 2, holed);
	model->image[0].opaque = false;
	model->material[0].normal_texture = -1;
	model->material[0].texture = 0;
	model->material[0].alpha = MODEL_MASK;
	model->material[0].alpha_cutoff = cutoff;
	model->material[0].base_color[3] = base_alpha;
	draw_shadow(&canvas, model);
	gl_canvas_expect(
		&canvas, 2, 2, 166, 166, 166, 2); /* 255 * 0.625 + 16 * 0.375 */
	gl_canvas_expect(&canvas, GL_CANVAS_WIDTH - 3, 2, 255, 255, 255, 0);
	model_destroy(model);
	gl_canvas_close(&canvas);
}

/* What is masked or blended away, as exporters hide helpers, is not there. */
static void test_a_shadow_is_as_faint_as_its_surface(void **state)
{
	static const struct {
		enum model_alpha alpha;
		float base_alpha;
		uint8_t level; /* of white ground in the shadow */
	} surfaces[] = {
		{MODEL_MASK, 0.4f, 255},
		{MODEL_MASK, 0.6f, 166},
		{MODEL_BLEND, 0.0f, 255},
		/* as faint as the surface: 255 * 0.85 + 16 * 0.15 */
		{MODEL_BLEND, 0.4f, 219},
		{MODEL_BLEND, 0.8f, 184},
		{MODEL_OPAQUE, 0.0f, 166},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(surfaces); i++) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", PIXELS_RGBA8888);
		struct model *model = small_model_grid(1, 1, 1.0f, true);
		uint8_t level = surfaces[i].level;

		model->material[0].alpha = surfaces[i].alpha;
		model->material[0].alpha_cutoff = 0.5f;
		model->material[0].base_color[3] = surfaces[i].base_alpha;
		draw_shadow(&canvas, model);
		gl_canvas_expect(&canvas, 2, 2, level, level, level, 2);
		model_destroy(model);
		gl_canvas_close(&canvas);
	}
}

static void test_a_masked_surface_casts_a_shadow_with_its_holes(void **state)
{
	(void)state;
	check_masked_shadow("soft", 0, 1.0f, 0.9f);
	check_masked_shadow("osmesa", 0, 1.0f, 0.9f);
	check_masked_shadow("soft", 128, 0.8f, 0.45f);
	check_masked_shadow("osmesa", 128, 0.8f, 0.45f);
}

/* The texture's holes and the alpha of its other texels, on both drivers. */
static void test_a_blended_texture_casts_a_shadow_by_its_alpha(void **state)
{
	static const char *const drivers[] = {"soft", "osmesa"};
	const uint8_t faint[2][4] = {{255, 255, 255, 128}, {255, 255, 255, 0}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(drivers); i++) {
		struct gl_canvas canvas =
			gl_canvas_open(drivers[i], PIXELS_RGBA8888);
		struct model *model = small_model_grid(1, 1, 1.0f, true);

		small_model_add_normal_map(model, 2, faint);
		model->image[0].opaque = false;
		model->material[0].normal_texture = -1;
		model->material[0].texture = 0;
		model->material[0].alpha = MODEL_BLEND;
		draw_shadow(&canvas, model);
		gl_canvas_expect(&canvas, 2, 2, 210, 210, 210, 3);
		gl_canvas_expect(
			&canvas, GL_CANVAS_WIDTH - 3, 2, 255, 255, 255, 0);
		model_destroy(model);
		gl_canvas_close(&canvas);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_rigid_mesh_is_placed_by_its_node),
		cmocka_unit_test(test_a_mirrored_node_turns_the_front_face),
		cmocka_unit_test(test_an_edge_of_two_triangles_is_drawn_once),
		cmocka_unit_test(test_hidden_drawables_cost_no_call),
		cmocka_unit_test(test_blended_surfaces_come_after_opaque_ones),
		cmocka_unit_test(
			test_a_masked_surface_casts_a_shadow_with_its_holes),
		cmocka_unit_test(
			test_a_blended_texture_casts_a_shadow_by_its_alpha),
		cmocka_unit_test(test_a_shadow_is_as_faint_as_its_surface),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
