#include "app/scene/shadow/shadow_volume.h"
#include "platform/base/fixed.h"
#include "platform/gl/gl_context.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	PICTURE = 96
};

static const float from_front[3] = {0.0f, 0.0f, 1.0f};
static const float from_back[3] = {0.0f, 0.0f, -1.0f};

struct cast {
	struct model *model;
	struct instance *instance;
	struct shadow_volume volume;
};

static struct cast begin(struct model *model)
{
	struct log nowhere = log_to_nowhere();
	struct cast cast = {.model = model};

	assert_int_equal(instance_create(model, kernel_find(NULL), &nowhere,
				 &cast.instance),
		0);
	assert_int_equal(
		shadow_volume_init(&cast.volume, cast.instance, &nowhere), 0);
	return cast;
}

/* A light without ground. */
static void update(struct cast *cast, const float towards[3], float reach)
{
	const struct shadow_light light = {
		.towards = {towards[0], towards[1], towards[2]},
		.max_length = reach,
	};

	shadow_volume_update(&cast->volume, cast->instance, &light);
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
			primitive->position[i][axis] = i >> axis & 1 ? 1 : 0;
		}
	}
	return model;
}

/* A closed surface has each edge equally often in both directions. */
static void assert_watertight(const struct shadow_caster *caster)
{
	for (int i = 0; i < caster->index_count; i++) {
		int triangle = i / 3 * 3;
		const float *a = caster->position[caster->index[i]];
		const float *b =
			caster->position[caster->index[triangle + (i + 1) % 3]];
		int balance = 0;

		for (int j = 0; j < caster->index_count; j++) {
			const float *c = caster->position[caster->index[j]];
			const float *d =
				caster->position[caster->index[j / 3 * 3 +
					(j + 1) % 3]];

			balance +=
				memcmp(a, c, 12) == 0 && memcmp(b, d, 12) == 0;
			balance -=
				memcmp(a, d, 12) == 0 && memcmp(b, c, 12) == 0;
		}
		assert_int_equal(balance, 0);
	}
}

/* Six times the volume; positive when triangles face outwards. */
static float volume_of(const struct shadow_caster *caster)
{
	float sum = 0.0f;

	for (int i = 0; i < caster->index_count; i += 3) {
		const float *a = caster->position[caster->index[i]];
		const float *b = caster->position[caster->index[i + 1]];
		const float *c = caster->position[caster->index[i + 2]];

		sum += a[0] * (b[1] * c[2] - b[2] * c[1]) +
			a[1] * (b[2] * c[0] - b[0] * c[2]) +
			a[2] * (b[0] * c[1] - b[1] * c[0]);
	}
	return sum;
}

static void test_a_plane_facing_the_light_casts_a_closed_box(void **state)
{
	struct cast cast = begin(small_model_grid(2, 2, 1.0f, true));
	const struct shadow_caster *caster = &cast.volume.caster[0];

	(void)state;
	update(&cast, from_front, 3.0f);
	/* 8 triangles in both caps, and two for each of 8 border edges. */
	assert_int_equal(caster->index_count, 3 * (8 + 8 + 16));
	assert_watertight(caster);
	assert_near(volume_of(caster), 6.0 * 3.0, 1e-4);
	end(&cast);
}

static void test_a_plane_facing_away_casts_nothing_of_its_own(void **state)
{
	struct cast cast = begin(small_model_grid(2, 2, 1.0f, true));

	(void)state;
	update(&cast, from_back, 3.0f);
	assert_int_equal(cast.volume.caster[0].index_count, 0);
	end(&cast);
}

static void test_a_cube_casts_a_closed_volume_along_a_slanted_light(void **state)
{
	static const float slanted[3] = {0.36f, 0.48f, 0.8f};
	struct cast cast = begin(make_cube());
	const struct shadow_caster *caster = &cast.volume.caster[0];

	(void)state;
	assert_int_equal(caster->edge_count, 18);
	update(&cast, slanted, 2.0f);
	assert_true(caster->index_count > 0);
	assert_watertight(caster);
	/* Three lit sides, each with its area times cosine times length 2. */
	assert_near(volume_of(caster), 6.0 * 2.0 * (0.36 + 0.48 + 0.8), 1e-4);
	end(&cast);
}

/* The volume is as thin as the ground's waves allow. */
static void test_a_volume_extends_over_the_possible_ground(void **state)
{
	static struct floor floor = {
		.y = -2.0f, .tile = 1.0f, .wave_height = 0.5f};
	const struct shadow_light light = {.towards = {0.6f, 0.8f, 0.0f},
		.max_length = 9.0f,
		.ground = &floor};
	struct cast cast = begin(make_cube());
	const struct shadow_caster *caster = &cast.volume.caster[0];

	(void)state;
	shadow_volume_update(&cast.volume, cast.instance, &light);
	assert_true(caster->index_count > 0);
	assert_watertight(caster);
	for (int v = 0; v < 8; v++) {
		const float *near = caster->position[v];
		const float *far = caster->position[v + 8];
		float x = 0.5f * (near[0] + far[0]);
		float z = 0.5f * (near[2] + far[2]);
		float y = 0.5f * (near[1] + far[1]);

		/* The corner's shadow on the ground. */
		assert_near(x, (v & 1) - 0.75 * ((v >> 1 & 1) - y), 1e-5);
		assert_near(z, v >> 2 & 1, 1e-5);
		assert_near(y, floor_height(&floor, x, z), 0.02);
		assert_near(near[1] - far[1],
			2.0f * floor_mesh_error(&floor, x, z), 1e-5);
	}
	end(&cast);
}

static void test_a_volume_is_no_longer_than_its_maximum(void **state)
{
	static struct floor floor = {.y = -9.0f, .tile = 1.0f};
	const struct shadow_light light = {.towards = {0.6f, 0.8f, 0.0f},
		.max_length = 2.0f,
		.ground = &floor};
	struct cast cast = begin(make_cube());

	(void)state;
	shadow_volume_update(&cast.volume, cast.instance, &light);
	assert_near(cast.volume.caster[0].position[8][1], -1.6, 1e-5);
	assert_near(cast.volume.caster[0].position[0][1], -1.6, 1e-5);
	end(&cast);
}

/* A corner below the ground stays where it is. */
static void test_a_volume_does_not_rise_towards_the_light(void **state)
{
	static struct floor floor = {
		.y = 3.0f, .tile = 1.0f, .wave_height = 0.5f};
	const struct shadow_light light = {.towards = {0.6f, 0.8f, 0.0f},
		.max_length = 2.0f,
		.ground = &floor};
	struct cast cast = begin(make_cube());

	(void)state;
	shadow_volume_update(&cast.volume, cast.instance, &light);
	assert_near(cast.volume.caster[0].position[2][1], 1.0, 1e-5);
	assert_near(cast.volume.caster[0].position[10][1], 1.0, 1e-5);
	end(&cast);
}

/* Only then may the back cap be omitted. */
static void test_depth_pass_needs_volumes_beyond_the_near_plane(void **state)
{
	static struct floor floor = {
		.y = -1.0f, .tile = 1.0f, .wave_height = 0.1f};
	struct shadow_light light = {.towards = {0.6f, 0.8f, 0.0f},
		.max_length = 5.0f,
		.ground = &floor,
		/* The volume begins at x = -1.6. */
		.near_plane = {1.0f, 0.0f, 0.0f, 1.6f}};
	struct cast cast = begin(make_cube());
	const struct shadow_caster *caster = &cast.volume.caster[0];
	int lit = 0;

	(void)state;
	shadow_volume_update(&cast.volume, cast.instance, &light);
	for (int t = 0; t < caster->corner_count / 3; t++) {
		lit += caster->lit[t];
	}
	assert_true(lit > 0);
	assert_int_equal(caster->back_cap_count, 3 * lit);
	assert_true(cast.volume.depth_pass);
	/* The near plane cuts the volume's end. */
	light.near_plane[3] = 1.4f;
	shadow_volume_update(&cast.volume, cast.instance, &light);
	assert_false(cast.volume.depth_pass);
	/* The back cap of a volume that ends above the ground is visible. */
	light.near_plane[3] = 1.6f;
	light.max_length = 1.5f;
	shadow_volume_update(&cast.volume, cast.instance, &light);
	assert_false(cast.volume.depth_pass);
	light.ground = NULL;
	light.max_length = 1.0f;
	shadow_volume_update(&cast.volume, cast.instance, &light);
	assert_false(cast.volume.depth_pass);
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

/* The number of dark pixels on white ground. */
static int draw_shadow(struct gl_context *context, struct pixels *picture,
	const struct floor *floor, const struct shadow_volume *volume)
{
	const struct gl *gl = &context->gl;
	int dark = 0;

	assert_int_equal(context->driver->begin_frame(context, picture), 0);
	look_down(gl);
	gl->Enable(GL_DEPTH_TEST);
	gl->Disable(GL_CULL_FACE);
	gl->Color4x(FX16_ONE, FX16_ONE, FX16_ONE, FX16_ONE);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, 0, floor->position);
	gl->DrawElements(GL_TRIANGLES, FLOOR_OPAQUE_INDICES, GL_UNSIGNED_SHORT,
		floor->index);
	shadow_volume_draw(volume, gl, 0.5f);
	context->driver->end_frame(context);
	for (int i = 0; i < PICTURE * PICTURE; i++) {
		uint8_t value = picture->data[4 * i];

		dark += value > 0 && value < 200;
	}
	return dark;
}

static void test_depth_pass_and_depth_fail_draw_the_same_shadow(void **state)
{
	const struct bounds bounds = {
		.low = {0.0f, -1.0f, 0.0f}, .high = {1.0f, 1.0f, 1.0f}};
	struct log log = log_to_nowhere();
	struct cast cast = begin(make_cube());
	struct pixels picture[2];
	struct gl_context *context;
	struct floor floor;
	struct shadow_light light = {.towards = {0.36f, 0.8f, 0.48f},
		.max_length = 5.0f,
		.ground = &floor,
		.near_plane = {0.0f, 0.0f, 0.0f, 1.0f}};

	(void)state;
	assert_int_equal(gl_open("soft",
				 &(struct gl_request){.format = PIXELS_RGBA8888,
					 .log = &log},
				 &context),
		0);
	assert_int_equal(floor_init(&floor, &context->gl, &bounds, 4.0f,
				 PIXELS_RGBA8888, &log),
		0);
	floor_set_wave_height(&floor, 0.2f);
	shadow_volume_update(&cast.volume, cast.instance, &light);
	for (int i = 0; i < 2; i++) {
		assert_int_equal(pixels_alloc(&picture[i], PICTURE, PICTURE,
					 PIXELS_RGBA8888, &log),
			0);
		assert_true(cast.volume.depth_pass == (i == 0));
		/* 1 + 0.45 + 0.6 square units of 144 pixels. */
		assert_in_range(
			draw_shadow(context, &picture[i], &floor, &cast.volume),
			270, 330);
		cast.volume.depth_pass = false;
	}
	assert_memory_equal(
		picture[0].data, picture[1].data, PICTURE * PICTURE * 4);
	free(picture[0].data);
	free(picture[1].data);
	floor_finish(&floor, &context->gl);
	context->driver->destroy(context);
	end(&cast);
}

static void test_seams_are_not_borders(void **state)
{
	struct model *model = small_model_grid(2, 1, 1.0f, true);
	struct model_primitive *primitive = &model->mesh[0].primitive[0];
	struct cast cast;

	(void)state;
	/* The right quad gets vertices of its own at the seam. */
	primitive = &model->mesh[0].primitive[0];
	primitive->position = arena_alloc(&model->arena, 8, sizeof(float[3]));
	primitive->normal = arena_alloc(&model->arena, 8, sizeof(float[3]));
	primitive->vertex_count = 8;
	for (int i = 0; i < 8; i++) {
		primitive->position[i][0] = (float)(i % 2 + i / 4);
		primitive->position[i][1] = (float)(i / 2 % 2);
		primitive->normal[i][2] = 1.0f;
	}
	memcpy(primitive->index,
		((uint32_t[12]){0, 1, 2, 2, 1, 3, 4, 5, 6, 6, 5, 7}), 48);
	cast = begin(model);
	update(&cast, from_front, 1.0f);
	/* 4 triangles twice, 6 outer edges; the seam adds none. */
	assert_int_equal(cast.volume.caster[0].index_count, 3 * (8 + 12));
	end(&cast);
}

static void test_too_large_a_part_is_left_out_with_a_warning(void **state)
{
	struct model *model = small_model_grid(200, 200, 1.0f, true);
	struct log nowhere = log_to_nowhere();
	struct shadow_volume volume;
	struct instance *instance;

	(void)state;
	assert_int_equal(
		instance_create(model, kernel_find(NULL), &nowhere, &instance),
		0);
	assert_int_equal(shadow_volume_init(&volume, instance, &nowhere), 0);
	assert_int_equal(volume.caster_count, 0);
	instance_destroy(instance);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_plane_facing_the_light_casts_a_closed_box),
		cmocka_unit_test(
			test_a_plane_facing_away_casts_nothing_of_its_own),
		cmocka_unit_test(
			test_a_cube_casts_a_closed_volume_along_a_slanted_light),
		cmocka_unit_test(test_a_volume_extends_over_the_possible_ground),
		cmocka_unit_test(test_a_volume_is_no_longer_than_its_maximum),
		cmocka_unit_test(test_a_volume_does_not_rise_towards_the_light),
		cmocka_unit_test(
			test_depth_pass_needs_volumes_beyond_the_near_plane),
		cmocka_unit_test(
			test_depth_pass_and_depth_fail_draw_the_same_shadow),
		cmocka_unit_test(test_seams_are_not_borders),
		cmocka_unit_test(
			test_too_large_a_part_is_left_out_with_a_warning),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
