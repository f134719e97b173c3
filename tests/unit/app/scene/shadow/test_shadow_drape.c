#include "app/anim/math/vec.h"
#include "app/scene/shadow/shadow_drape.h"
#include "platform/base/fixed.h"
#include "platform/base/scalar.h"
#include "platform/gl/gl_context.h"
#include "tests/support/gl/gl_state.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	PICTURE = 96
};

struct cast {
	struct model *model;
	struct instance *instance;
	struct shadow_drape drape;
};

static struct cast begin_in(
	struct model *model, const struct shadow_cloth *cloth)
{
	struct log nowhere = log_to_nowhere();
	struct cast cast = {.model = model};

	assert_int_equal(instance_create(model, kernel_find(NULL), &nowhere,
				 &cast.instance),
		0);
	assert_int_equal(shadow_drape_init(&cast.drape, cast.instance, cloth,
				 cloth ? 1 : 0, &nowhere),
		0);
	return cast;
}

static struct cast begin(struct model *model)
{
	return begin_in(model, NULL);
}

static void end(struct cast *cast)
{
	instance_destroy(cast->instance);
	model_destroy(cast->model);
}

/* A unit cube with eight vertices. */
static struct model *make_cube(void)
{
	static const uint32_t index[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6,
		0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5,
		3, 7, 5};
	struct model *model = small_model_grid(3, 2, 1.0f, true);
	struct model_primitive *primitive = &model->mesh[0].primitive[0];

	primitive->vertex_count = 8;
	primitive->index_count = 36;
	memcpy(primitive->index, index, sizeof(index));
	for (int i = 0; i < 8; i++) {
		for (int axis = 0; axis < 3; axis++) {
			primitive->position[i][axis] = (float)(i >> axis & 1);
		}
	}
	return model;
}

/* Where a ray down the light meets the ground, found by halving. */
static void find_ground(
	const struct shadow_light *light, const float from[3], float out[3])
{
	float above = -20.0f, below = 20.0f;

	for (int i = 0; i < 60; i++) {
		float middle = 0.5f * (above + below);

		vec_add_scaled(from, light->towards, -middle, out);
		if (out[1] > floor_height(light->ground, out[0], out[2])) {
			above = middle;
		} else {
			below = middle;
		}
	}
}

/* Of a point from the line through two others. */
static float distance_to_line(
	const float at[3], const float a[3], const float b[3])
{
	float along[3], to[3], across[3];

	vec_subtract(b, a, along);
	vec_subtract(at, a, to);
	vec_cross(along, to, across);
	return vec_length(across) / vec_length(along);
}

static void check_positions(const struct shadow_drape *drape,
	const struct shadow_light *light, float tolerance)
{
	const struct shadow_sheet *sheet = &drape->sheet[0];

	for (int v = 0; v < sheet->vertex_count; v++) {
		const float *at = sheet->position[v];
		float ground[3], lifted[3], away[3];

		for (int axis = 0; axis < 3; axis++) {
			assert_true(at[axis] >= drape->box.low[axis]);
			assert_true(at[axis] <= drape->box.high[axis]);
		}
		find_ground(light, sheet->posed[v], ground);
		assert_true(
			distance_to_line(at, light->eye, ground) < tolerance);
		/* It is a little nearer to the eye. */
		vec_subtract(ground, at, lifted);
		vec_subtract(ground, light->eye, away);
		assert_true(vec_dot(lifted, away) > 0.0f);
		assert_true(vec_length(lifted) < 0.11f * vec_length(away));
	}
}

static void test_a_shadow_is_seen_where_the_light_meets_the_ground(void **state)
{
	static struct floor floor = {
		.y = -2.0f, .tile = 1.0f, .radius = 9.0f, .wave_height = 0.5f};
	const struct shadow_light light = {.towards = {0.6f, 0.8f, 0.0f},
		.eye = {1.0f, 3.0f, 9.0f},
		.ground = &floor};
	struct cast cast = begin(make_cube());

	(void)state;
	shadow_drape_update(&cast.drape, cast.instance, &light);
	assert_int_equal(cast.drape.sheet_count, 1);
	assert_true(cast.drape.sheet[0].vertex_count > 8);
	check_positions(&cast.drape, &light, 0.02f);
	end(&cast);
}

/* Many vertices are laid by a grid, whether or not they fill it. */
static void test_a_shadow_of_many_vertices_is_seen_there_too(void **state)
{
	static struct floor floor = {
		.y = -2.0f, .tile = 1.0f, .radius = 9.0f, .wave_height = 0.5f};
	struct shadow_light light = {
		.eye = {1.0f, 3.0f, 9.0f}, .ground = &floor};
	struct cast cast = begin(small_model_grid(40, 40, 1.0f, true));

	(void)state;
	for (int i = 0; i < 24; i++) {
		float turn = 0.5f * (float)i;

		light.towards[0] = 0.6f * scalar_cos(turn);
		light.towards[1] = 0.8f;
		light.towards[2] = 0.6f * scalar_sin(turn);
		floor.offset[0] = 0.31f * (float)i;
		floor.offset[1] = 0.23f * (float)i;
		shadow_drape_update(&cast.drape, cast.instance, &light);
		assert_in_range(cast.drape.grid.node_count, 1,
			cast.drape.sheet[0].vertex_count / 2);
		check_positions(&cast.drape, &light, 0.02f);
	}
	/* A grid over this area would have more nodes than there are vertices. */
	floor.tile = 0.1f;
	shadow_drape_update(&cast.drape, cast.instance, &light);
	assert_int_equal(cast.drape.grid.node_count, 0);
	end(&cast);
}

/* A closed surface has each edge equally often in both directions. */
static void assert_closed(const struct shadow_sheet *sheet)
{
	for (int i = 0; i < sheet->index_count; i++) {
		const float *a = sheet->posed[sheet->index[i]];
		const float *b =
			sheet->posed[sheet->index[i / 3 * 3 + (i + 1) % 3]];
		int balance = 0;

		for (int j = 0; j < sheet->index_count; j++) {
			const float *c = sheet->posed[sheet->index[j]];
			const float *d =
				sheet->posed[sheet->index[j / 3 * 3 + (j + 1) % 3]];

			balance +=
				memcmp(a, c, 12) == 0 && memcmp(b, d, 12) == 0;
			balance -=
				memcmp(a, d, 12) == 0 && memcmp(b, c, 12) == 0;
		}
		assert_int_equal(balance, 0);
	}
}

static void test_long_edges_are_divided_without_gaps(void **state)
{
	static struct floor floor = {.y = -1.0f, .tile = 1.0f};
	const struct shadow_light light = {.towards = {0.36f, 0.48f, 0.8f},
		.eye = {0.0f, 3.0f, 9.0f},
		.ground = &floor};
	struct cast cast = begin(make_cube());
	const struct shadow_sheet *sheet = &cast.drape.sheet[0];

	(void)state;
	shadow_drape_update(&cast.drape, cast.instance, &light);
	assert_near(cast.drape.longest, 0.25, 1e-5);
	for (int i = 0; i < sheet->index_count; i++) {
		const float *a = sheet->posed[sheet->index[i]];
		const float *b =
			sheet->posed[sheet->index[i / 3 * 3 + (i + 1) % 3]];
		float edge[3];

		vec_subtract(a, b, edge);
		assert_true(vec_length(edge) < 0.25f + 1e-5f);
	}
	assert_closed(sheet);
	end(&cast);
}

static void test_divisions_end_where_memory_does(void **state)
{
	static struct floor floor = {.y = -1.0f, .tile = 1.0f};
	const struct shadow_light light = {.towards = {0.36f, 0.48f, 0.8f},
		.eye = {0.0f, 3.0f, 9.0f},
		.ground = &floor};
	struct cast cast = begin(make_cube());
	const struct shadow_sheet *sheet = &cast.drape.sheet[0];

	(void)state;
	cast.drape.longest = 0.0f;
	shadow_drape_update(&cast.drape, cast.instance, &light);
	assert_int_equal(cast.drape.divisions_left, 0);
	assert_true(sheet->index_count <= cast.drape.index_max);
	assert_int_equal(sheet->index_count, 36 + 3 * (sheet->vertex_count - 8));
	end(&cast);
}

static void test_no_light_from_above_casts_no_shadow(void **state)
{
	static struct floor floor = {.y = -1.0f, .tile = 1.0f};
	struct shadow_light light = {
		.towards = {1.0f, 0.0f, 0.0f}, .ground = &floor};
	struct cast cast = begin(make_cube());

	(void)state;
	shadow_drape_update(&cast.drape, cast.instance, &light);
	assert_int_equal(cast.drape.sheet[0].index_count, 0);
	light.towards[1] = 0.5f;
	shadow_drape_update(&cast.drape, cast.instance, &light);
	assert_true(cast.drape.sheet[0].index_count > 0);
	cast.instance->drawable[0].hidden = true;
	shadow_drape_update(&cast.drape, cast.instance, &light);
	assert_int_equal(cast.drape.sheet[0].index_count, 0);
	end(&cast);
}

/* The light comes from the other side, so that the shadow lies elsewhere. */
static void test_a_shadow_forgets_where_it_was(void **state)
{
	static struct floor floor = {.y = -2.0f, .tile = 1.0f, .radius = 9.0f};
	struct shadow_light light = {.towards = {0.6f, 0.8f, 0.0f},
		.eye = {1.0f, 3.0f, 9.0f},
		.ground = &floor};
	struct cast moved = begin(make_cube()), fresh = begin(make_cube());

	(void)state;
	shadow_drape_update(&moved.drape, moved.instance, &light);
	light.towards[0] = -0.6f;
	shadow_drape_update(&moved.drape, moved.instance, &light);
	shadow_drape_update(&fresh.drape, fresh.instance, &light);
	assert_int_equal(moved.drape.sheet[0].vertex_count,
		fresh.drape.sheet[0].vertex_count);
	assert_all_near(moved.drape.sheet[0].position[0],
		fresh.drape.sheet[0].position[0],
		3 * fresh.drape.sheet[0].vertex_count, 0.0);
	assert_memory_equal(
		&moved.drape.box, &fresh.drape.box, sizeof(fresh.drape.box));
	end(&moved);
	end(&fresh);
}

/* Whatever was on before; without hills in front, depths do not matter. */
static void test_a_shadow_is_blended_once_and_writes_no_depth(void **state)
{
	static const GLenum on[] = {
		GL_BLEND, GL_STENCIL_TEST, GL_CULL_FACE, GL_VERTEX_ARRAY, 0};
	static const GLenum off[] = {GL_LIGHTING, GL_TEXTURE_2D, GL_COLOR_ARRAY,
		GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY, GL_STATE_DEPTH_WRITES,
		0};
	static const GLenum off_after[] = {
		GL_BLEND, GL_STENCIL_TEST, GL_CULL_FACE, 0};
	static struct floor floor = {.y = -2.0f, .tile = 1.0f, .radius = 9.0f};
	const struct shadow_light light = {.towards = {0.6f, 0.8f, 0.0f},
		.eye = {1.0f, 3.0f, 9.0f},
		.ground = &floor};
	struct cast cast = begin(make_cube());

	(void)state;
	shadow_drape_update(&cast.drape, cast.instance, &light);
	for (int i = 0; i < 4; i++) {
		struct gl gl = gl_state_begin(i & 1);

		gl.Enable(GL_DEPTH_TEST);
		shadow_drape_draw(&cast.drape, &gl, 0.5f, 0, i & 2);
		gl_state_expect_on(gl_state_last(), on);
		gl_state_expect_off(gl_state_last(), off);
		assert_int_equal(
			gl_state_has(gl_state_last(), GL_DEPTH_TEST), i / 2);
		assert_near(gl_state_last()->color[3], 0.5, 1e-4);
		gl_state_expect_off(NULL, off_after);
		assert_true(gl_state_has(NULL, GL_DEPTH_TEST));
		assert_true(gl_state_has(NULL, GL_STATE_DEPTH_WRITES));
	}
	end(&cast);
}

/* Draws from above; the picture is 8 units a side. */
static void look_down(const struct gl *gl)
{
	static const GLfixed down[16] = {FX16_ONE / 4, 0, 0, 0, 0, 0,
		-FX16_ONE / 4, 0, 0, -FX16_ONE / 4, 0, 0, 0, 0, 0, FX16_ONE};

	gl->ClearColorx(0, 0, 0, FX16_ONE);
	gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT |
		GL_STENCIL_BUFFER_BIT);
	gl->MatrixMode(GL_MODELVIEW);
	gl->LoadIdentity();
	gl->MultMatrixx(down);
}

/*
 * Draws white ground with the shadow, and a white roof over the ground's left
 * part, up to x. Returns the number of dark pixels.
 */
static int draw_shadow(struct gl_context *context, struct pixels *picture,
	const struct shadow_drape *drape, int16_t roof, bool may_be_hidden)
{
	const int16_t ground[4][3] = {
		{-4, -1, -4}, {-4, -1, 4}, {4, -1, -4}, {4, -1, 4}};
	const int16_t cover[4][3] = {
		{-4, 0, -4}, {-4, 0, 4}, {roof, 0, -4}, {roof, 0, 4}};
	const struct gl *gl = &context->gl;
	int dark = 0;

	assert_int_equal(context->driver->begin_frame(context, picture), 0);
	look_down(gl);
	gl->Enable(GL_DEPTH_TEST);
	gl->Disable(GL_CULL_FACE);
	gl->Color4x(FX16_ONE, FX16_ONE, FX16_ONE, FX16_ONE);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(3, GL_SHORT, 0, ground);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
	gl->VertexPointer(3, GL_SHORT, 0, cover);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
	shadow_drape_draw(drape, gl, 0.5f, 0, may_be_hidden);
	context->driver->end_frame(context);
	for (int i = 0; i < PICTURE * PICTURE; i++) {
		uint8_t value = picture->data[4 * i];

		dark += value > 0 && value < 200;
		assert_true(value == 0 || value > 100);
	}
	return dark;
}

/* Opens a driver and a picture for draw_shadow(); close_picture() ends. */
static struct gl_context *open_picture(struct pixels *picture)
{
	struct log log = log_to_nowhere();
	struct gl_context *context;
	const struct gl_request request = {
		.format = PIXELS_RGBA8888, .log = &log};

	assert_int_equal(gl_open("soft", &request, &context), 0);
	assert_int_equal(
		pixels_alloc(picture, PICTURE, PICTURE, PIXELS_RGBA8888, &log),
		0);
	return context;
}

static void close_picture(struct gl_context *context, struct pixels *picture)
{
	free(picture->data);
	context->driver->destroy(context);
}

static void test_ground_that_is_seen_is_darkened_once(void **state)
{
	static struct floor floor = {.y = -1.0f, .tile = 1.0f, .radius = 9.0f};
	struct cast cast = begin(make_cube());
	struct pixels picture;
	struct gl_context *context = open_picture(&picture);
	const struct shadow_light light = {.towards = {0.36f, 0.8f, 0.48f},
		.eye = {0.0f, 100.0f, 0.0f},
		.ground = &floor};

	(void)state;
	shadow_drape_update(&cast.drape, cast.instance, &light);
	/* 1 + 0.45 + 0.6 square units of 144 pixels. */
	assert_in_range(draw_shadow(context, &picture, &cast.drape, -3, true),
		270, 330);
	/* The shadow extends from x = -0.9 to 0.55. */
	assert_int_equal(
		draw_shadow(context, &picture, &cast.drape, 1, true), 0);
	assert_in_range(
		draw_shadow(context, &picture, &cast.drape, 0, true), 1, 200);
	/* Without a depth test, the roof gets what the ground does. */
	assert_int_equal(draw_shadow(context, &picture, &cast.drape, 1, false),
		draw_shadow(context, &picture, &cast.drape, -3, true));
	/* The shadow of glass is as faint as the glass. */
	cast.instance->drawable[0].alpha = MODEL_BLEND;
	cast.instance->drawable[0].mean_alpha = 0.6f; /* darkens to 183 */
	assert_in_range(draw_shadow(context, &picture, &cast.drape, -3, true),
		270, 330);
	cast.instance->drawable[0].mean_alpha = 0.2f; /* to 231 */
	assert_int_equal(
		draw_shadow(context, &picture, &cast.drape, -3, true), 0);
	close_picture(context, &picture);
	end(&cast);
}

/* Cloth of a square unit and a wall, whichever side is towards the light. */
static void test_sheets_cast_shadows_from_both_sides(void **state)
{
	static const float corner[4][3] = {
		{-1, 0, -1}, {1, 0, -1}, {-1, 0, 1}, {1, 0, 1}};
	static const uint16_t index[2][6] = {
		{0, 2, 1, 1, 2, 3}, {0, 1, 2, 1, 3, 2}};
	static struct floor floor = {.y = -1.0f, .tile = 1.0f, .radius = 9.0f};
	struct shadow_light light = {
		.eye = {0.0f, 100.0f, 0.0f}, .ground = &floor};
	struct shadow_cloth cloth = {.position = corner,
		.vertex_count = 4,
		.index_count = 6,
		.scale = 0.5f};
	struct model *wall = small_model_grid(1, 1, 1.0f, true);
	struct cast cast;
	struct pixels picture;
	struct gl_context *context = open_picture(&picture);

	(void)state;
	wall->material[0].double_sided = true;
	cast = begin_in(wall, &cloth);
	for (int i = 0; i < 4; i++) {
		light.towards[1] = 0.6f;
		light.towards[2] = i % 2 == 0 ? 0.8f : -0.8f;
		cloth.index = index[i % 2];
		cloth.hidden = i >= 2;
		cast.instance->drawable[0].hidden = i < 2;
		shadow_drape_update(&cast.drape, cast.instance, &light);
		assert_in_range(
			draw_shadow(context, &picture, &cast.drape, -3, true),
			i < 2 ? 130 : 180, i < 2 ? 160 : 210);
	}
	cast.instance->drawable[0].hidden = true;
	shadow_drape_update(&cast.drape, cast.instance, &light);
	assert_int_equal(
		draw_shadow(context, &picture, &cast.drape, -3, true), 0);
	close_picture(context, &picture);
	end(&cast);
}

static void test_a_part_of_many_vertices_casts_a_shadow(void **state)
{
	static struct floor floor = {.y = -1.0f, .tile = 1.0f};
	const struct shadow_light light = {
		.towards = {0.0f, 0.6f, 0.8f}, .ground = &floor};
	struct cast cast = begin(small_model_grid(255, 255, 1.0f, true));
	const struct shadow_sheet *sheet = &cast.drape.sheet[0];

	(void)state;
	shadow_drape_update(&cast.drape, cast.instance, &light);
	assert_int_equal(cast.drape.sheet_count, 1);
	assert_true(sheet->index_count > 0);
	assert_true(sheet->vertex_count <= 65536);
	end(&cast);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_shadow_is_seen_where_the_light_meets_the_ground),
		cmocka_unit_test(
			test_a_shadow_of_many_vertices_is_seen_there_too),
		cmocka_unit_test(test_long_edges_are_divided_without_gaps),
		cmocka_unit_test(test_divisions_end_where_memory_does),
		cmocka_unit_test(test_no_light_from_above_casts_no_shadow),
		cmocka_unit_test(test_a_shadow_forgets_where_it_was),
		cmocka_unit_test(
			test_a_shadow_is_blended_once_and_writes_no_depth),
		cmocka_unit_test(test_ground_that_is_seen_is_darkened_once),
		cmocka_unit_test(test_sheets_cast_shadows_from_both_sides),
		cmocka_unit_test(test_a_part_of_many_vertices_casts_a_shadow),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
