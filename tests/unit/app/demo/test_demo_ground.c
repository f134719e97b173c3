/* Figures of every demo cast shadows on ground that their model brings along. */
#include "app/demo/actor.h"
#include "app/demo/demo_figures.h"
#include "platform/gl/gl_context.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	WIDTH = 320,
	HEIGHT = 240,
	PIXELS = WIDTH * HEIGHT
};

struct show {
	struct log log;
	struct gl_context *context;
	struct pixels pixels;
	const struct demo_driver *driver;
	struct demo *demo;
};

static void begin(struct show *show, const char *name, const char *model)
{
	struct demo_env env = {
		.log = &show->log,
		.target = PIXELS_RGBA8888,
		.kernel = &kernel_float,
		.width = WIDTH,
		.height = HEIGHT,
		.model_path = model,
		.no_labels = true,
	};

	*show = (struct show){
		.log = log_to_stderr(LOG_ERROR), .driver = demo_find(name)};
	assert_int_equal(gl_open("soft",
				 &(struct gl_request){.format = PIXELS_RGBA8888,
					 .log = &show->log},
				 &show->context),
		0);
	assert_int_equal(pixels_alloc(&show->pixels, WIDTH, HEIGHT,
				 PIXELS_RGBA8888, &show->log),
		0);
	env.gl = &show->context->gl;
	assert_int_equal(demo_create(show->driver, &env, &show->demo), 0);
	show->driver->update(show->demo, 0.0);
	show->driver->update(show->demo, 0.3);
}

static void end(struct show *show)
{
	demo_destroy(show->driver, show->demo);
	show->context->driver->destroy(show->context);
	free(show->pixels.data);
}

static void draw(struct show *show, bool with_stencil, uint8_t *rgba)
{
	struct gl_context *context = show->context;
	struct demo_base *base = (void *)show->demo;

	base->stage.has_stencil = with_stencil;
	assert_int_equal(
		context->driver->begin_frame(context, &show->pixels), 0);
	demo_draw_stage(show->driver, show->demo, WIDTH, HEIGHT);
	assert_int_equal(context->driver->end_frame(context), 0);
	for (int row = 0; row < HEIGHT; row++) {
		memcpy(rgba + (size_t)row * WIDTH * 4,
			show->pixels.data + row * show->pixels.stride_bytes,
			(size_t)WIDTH * 4);
	}
}

/*
 * The pixels that are darker with a stencil buffer, which shadows on ground of
 * the model's own need. Those on the floor are darker without it, if at all.
 */
static int count_shaded(
	const char *name, const char *model, enum button button, int presses)
{
	static uint8_t with[PIXELS * 4], without[PIXELS * 4];
	struct show show;
	int count = 0;

	begin(&show, name, model);
	for (int i = 0; i < presses; i++) {
		demo_press(show.driver, show.demo,
			&(struct button_event){.button = button, .down = true});
	}
	show.driver->update(show.demo, 9.0);
	draw(&show, true, with);
	draw(&show, false, without);
	for (int i = 0; i < PIXELS; i++) {
		count += with[4 * i + 1] + 8 < without[4 * i + 1];
	}
	end(&show);
	return count;
}

static const char hills[] = "tests/fixtures/gltf/scene/hills.gltf";
static const char level[] = "tests/fixtures/gltf/scene/ground.gltf";

static void test_shadows_lie_on_hills(void **state)
{
	(void)state;
	assert_in_range(count_shaded("crowd", hills, BUTTON_F6, 0), 150, 2000);
	assert_in_range(count_shaded("duel", hills, BUTTON_F6, 0), 150, 2000);
}

static void test_shadows_lie_on_level_ground(void **state)
{
	(void)state;
	assert_in_range(count_shaded("crowd", level, BUTTON_F6, 0), 100, 2000);
	assert_in_range(count_shaded("duel", level, BUTTON_F6, 0), 100, 2000);
	/* The tuner shakes the lawn until F10. */
	assert_in_range(count_shaded("tuner", level, BUTTON_F10, 1), 100, 4000);
}

static void test_f6_leaves_them_out_of_the_crowd(void **state)
{
	(void)state;
	assert_int_equal(count_shaded("crowd", hills, BUTTON_F6, 1), 0);
	assert_true(count_shaded("crowd", hills, BUTTON_F6, 2) > 150);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_shadows_lie_on_hills),
		cmocka_unit_test(test_shadows_lie_on_level_ground),
		cmocka_unit_test(test_f6_leaves_them_out_of_the_crowd),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
