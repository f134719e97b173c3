/* The crowd where there is no memory for another walker. */
#include "app/demo/crowd/crowd_dress.h"
#include "app/demo/demo_figures.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>

static int most; /* walkers for which there is memory */

/* Takes the place of the crowd's, which needs memory for colours. */
int crowd_dress(struct instance *instance, int number)
{
	(void)instance;
	return number < most ? 0 : -ENOMEM;
}

static void press(struct demo *demo, enum button button)
{
	const struct button_event event = {.button = button, .down = true};

	demo_press(demo_find("crowd"), demo, &event);
}

static int count_walkers(const struct demo *demo)
{
	struct overlay_figure figure;
	int count = 0;

	while (demo_find_figure(demo_find("crowd"), demo, count, &figure)) {
		count++;
	}
	return count;
}

static int begin(int walkers, struct log *log, struct gl *gl, struct demo **out)
{
	const struct demo_env env = {.log = log,
		.gl = gl,
		.target = PIXELS_RGBA8888,
		.kernel = &kernel_float,
		.width = 240,
		.height = 320,
		.model_path = "assets/walker.glb",
		.speed = 1.0f,
		.walkers = walkers};

	return demo_create(demo_find("crowd"), &env, out);
}

/* One error is enough, until a walker goes. */
static void test_no_walker_is_tried_again_before_one_is_removed(void **state)
{
	struct log_capture heard;
	struct log log = log_capture_begin(&heard);
	struct gl gl = gl_recorder_begin();
	struct demo *demo;

	(void)state;
	most = 4;
	assert_int_equal(begin(2, &log, &gl, &demo), 0);
	press(demo, BUTTON_RIGHT);
	assert_int_equal(count_walkers(demo), 4);
	assert_int_equal(log_capture_count(&heard, LOG_ERROR), 1);
	assert_true(log_capture_has(&heard, LOG_ERROR, "memory for 5 walkers"));
	press(demo, BUTTON_UP);
	assert_int_equal(log_capture_count(&heard, LOG_ERROR), 1);
	press(demo, BUTTON_DOWN);
	press(demo, BUTTON_UP);
	assert_int_equal(count_walkers(demo), 4);
	assert_int_equal(log_capture_count(&heard, LOG_ERROR), 1);
	press(demo, BUTTON_UP);
	assert_int_equal(count_walkers(demo), 4);
	assert_int_equal(log_capture_count(&heard, LOG_ERROR), 2);
	demo_destroy(demo_find("crowd"), demo);
}

static void test_a_crowd_that_does_not_fit_does_not_begin(void **state)
{
	(void)state;
	for (most = 0; most < 2; most++) {
		struct log_capture heard;
		struct log log = log_capture_begin(&heard);
		struct gl gl = gl_recorder_begin();
		struct demo *demo;

		assert_int_equal(begin(3, &log, &gl, &demo), -ENOMEM);
		assert_int_equal(log_capture_count(&heard, LOG_ERROR), 1);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_no_walker_is_tried_again_before_one_is_removed),
		cmocka_unit_test(test_a_crowd_that_does_not_fit_does_not_begin),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
