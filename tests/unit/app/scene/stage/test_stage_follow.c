/* The ground below a figure that the camera follows upwards. */
#include "app/scene/stage/stage.h"
#include "platform/base/compiler.h"
#include "platform/gl/gl_context.h"
#include "tests/support/test.h"

enum {
	WIDTH = 240,
	HEIGHT = 320,
};

/* Finds what is seen of the ground once a figure 1 m high has gone this way. */
static struct floor_sight follow(const float way[3], float wave_height)
{
	const struct bounds bounds = {
		.low = {-0.5f, 0.0f, -0.5f}, .high = {0.5f, 1.0f, 0.5f}};
	const struct floor_content anything = {.bounded = false};
	struct log log = log_to_nowhere();
	struct gl_context *context;
	struct floor_sight sight;
	struct stage stage;

	assert_int_equal(gl_open("soft",
				 &(struct gl_request){
					 .format = PIXELS_RGB565, .log = &log},
				 &context),
		0);
	assert_int_equal(
		stage_init(&stage, &context->gl, &bounds, 1.0f,
			&(struct camera_framing){.aspect = (float)WIDTH / HEIGHT,
				.pitch_rad = 0.15f,
				.margin = 1.1f},
			PIXELS_RGB565, &log),
		0);
	floor_set_wave_height(&stage.floor, wave_height);
	stage_follow(&stage, way, way);
	floor_find_sight(
		&stage.floor, &stage.camera, WIDTH, HEIGHT, &anything, &sight);
	stage_finish(&stage, &context->gl);
	context->driver->destroy(context);
	return sight;
}

static void test_ground_stays_below_a_figure_that_rises(void **state)
{
	static const float way[][3] = {{0, 0, 0}, {0, 5, 0}, {0, 100, 0},
		{40, 100, -30}, {0, 2000, 0}, {0, 1e6f, 0}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(way); i++) {
		struct floor_sight sight = follow(way[i], 0.0f);

		/* GL has no numbers for a floor a million metres away. */
		assert_true(way[i][1] > 1e5f ||
			(sight.strips.opaque && sight.strips.fading));
	}
}

static void test_hills_stay_below_a_figure_that_rises(void **state)
{
	(void)state;
	assert_true(follow((const float[]){0, 20, 0}, 0.2f).mesh.seen);
}

/* What sinks is nearer to the ground, which needs no more of it. */
static void test_a_figure_that_sinks_sees_as_much_ground(void **state)
{
	struct floor_sight sight = follow((const float[]){0, -0.3f, 0}, 0.0f);

	(void)state;
	assert_true(sight.strips.opaque);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_ground_stays_below_a_figure_that_rises),
		cmocka_unit_test(test_hills_stay_below_a_figure_that_rises),
		cmocka_unit_test(test_a_figure_that_sinks_sees_as_much_ground),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
