/* Bump mapping as OSMesa draws it. */
#include "app/scene/draw/draw.h"
#include "app/scene/stage/light.h"
#include "tests/support/gl/gl_checks.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <string.h>

/* The left texel is tilted to -X, the right one to +X, by 45 degrees. */
static const uint8_t ridge_map[2][4] = {
	{37, 128, 218, 255}, {218, 128, 218, 255}};

/* A grid that OSMesa draws over the whole picture. */
struct shown {
	struct gl_canvas canvas;
	struct model *model;
	struct instance *instance;
	struct texture_set textures;
};

static void set_up(struct shown *shown, int texels, const uint8_t (*map)[4])
{
	static const uint8_t color[4][4] = {{255, 200, 100, 255},
		{255, 255, 255, 255}, {90, 180, 255, 255}, {40, 30, 20, 255}};
	struct log nowhere = log_to_nowhere();

	shown->canvas = gl_canvas_open("osmesa", PIXELS_RGBA8888);
	shown->model = small_model_grid(1, 1, 1.0f, true);
	small_model_add_normal_map(shown->model, texels, map);
	shown->model->mesh[0].primitive[0].color =
		arena_alloc(&shown->model->arena, 4, 4);
	assert_non_null(shown->model->mesh[0].primitive[0].color);
	memcpy(shown->model->mesh[0].primitive[0].color, color, sizeof(color));
	shown->instance = small_model_instance(shown->model);
	shown->instance->pose.local[0].scale[2] = 2;
	small_model_fill_picture(shown->instance);
	assert_int_equal(texture_set_create(&shown->textures, shown->model,
				 shown->canvas.gl, PIXELS_RGBA8888, &nowhere),
		0);
	assert_true(shown->textures.normal_mapping);
	shown->canvas.gl->Enable(GL_DEPTH_TEST);
	light_apply(shown->canvas.gl);
}

static void tear_down(struct shown *shown)
{
	texture_set_destroy(&shown->textures, shown->canvas.gl);
	instance_destroy(shown->instance);
	model_destroy(shown->model);
	gl_canvas_close(&shown->canvas);
}

/* Draws and returns the picture as RGBA, top row first. */
static void show(struct shown *shown, uint8_t (*out)[4])
{
	struct gl_canvas *canvas = &shown->canvas;

	canvas->gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	draw_instance(
		canvas->gl, shown->instance, &shown->textures, DRAW_SHADED);
	gl_canvas_end_frame(canvas);
	for (int y = 0; y < GL_CANVAS_HEIGHT; y++) {
		memcpy(out[(size_t)y * GL_CANVAS_WIDTH],
			canvas->pixels.data + y * canvas->pixels.stride_bytes,
			(size_t)GL_CANVAS_WIDTH * 4);
	}
	assert_int_equal(canvas->context->driver->begin_frame(
				 canvas->context, &canvas->pixels),
		0);
}

/* The sum of red, green and blue over a half of the picture. */
static long brightness(const uint8_t (*picture)[4], bool right)
{
	long sum = 0;

	for (int y = 0; y < GL_CANVAS_HEIGHT; y++) {
		for (int x = 0; x < GL_CANVAS_WIDTH / 2; x++) {
			const uint8_t *texel = picture[y * GL_CANVAS_WIDTH + x +
				(right ? GL_CANVAS_WIDTH / 2 : 0)];

			sum += texel[0] + texel[1] + texel[2];
		}
	}
	return sum;
}

static void test_a_ridge_is_bright_on_the_side_of_the_light(void **state)
{
	static uint8_t left[GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT][4];
	static uint8_t right[GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT][4];
	struct shown shown;

	(void)state;
	set_up(&shown, 2, ridge_map);
	small_model_light_from(shown.instance, -0.6f, 0, 0.8f);
	show(&shown, left);
	small_model_light_from(shown.instance, 0.6f, 0, 0.8f);
	show(&shown, right);
	/* The key light on the slopes is 0.99 and 0.14. */
	assert_true(brightness(left, false) * 2 > brightness(right, false) * 3);
	assert_true(brightness(right, true) * 2 > brightness(left, true) * 3);
	tear_down(&shown);
}

static void test_a_flat_map_looks_like_plain_light(void **state)
{
	static uint8_t plain[GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT][4];
	static uint8_t mapped[GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT][4];
	struct shown shown;

	(void)state;
	set_up(&shown, 1, small_model_flat_map);
	show(&shown, mapped);
	shown.instance->normal_mapping = false;
	show(&shown, plain);
	for (int i = 0; i < GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT; i++) {
		for (int channel = 0; channel < 3; channel++) {
			/* The picture is not empty, and three passes round
			   three times. */
			assert_true(plain[i][channel] > 10);
			assert_near(mapped[i][channel], plain[i][channel], 3.0);
		}
	}
	tear_down(&shown);
}

static void test_the_state_is_plain_again_afterwards(void **state)
{
	static uint8_t before[GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT][4];
	static uint8_t after[GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT][4];
	struct shown shown;

	(void)state;
	set_up(&shown, 2, ridge_map);
	shown.instance->normal_mapping = false;
	show(&shown, before);
	shown.instance->normal_mapping = true;
	show(&shown, after);
	assert_memory_not_equal(before, after, sizeof(after));
	shown.instance->normal_mapping = false;
	show(&shown, after);
	assert_memory_equal(before, after, sizeof(after));
	tear_down(&shown);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_ridge_is_bright_on_the_side_of_the_light),
		cmocka_unit_test(test_a_flat_map_looks_like_plain_light),
		cmocka_unit_test(test_the_state_is_plain_again_afterwards),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
