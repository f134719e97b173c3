/* The duel refuses a model that needs more than --memory before it fits keys. */
#include "app/compare/candidate/fit.h"
#include "app/demo/demo.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdlib.h>

static int fits;

static int make_keys(float duration_s, int count, struct fit_keys *out)
{
	*out = (struct fit_keys){.count = count,
		.time_s = malloc((size_t)count * sizeof(*out->time_s))};
	for (int i = 0; out->time_s && i < count; i++) {
		out->time_s[i] = duration_s * (float)i / (float)(count - 1);
	}
	return out->time_s ? 0 : -ENOMEM;
}

/* These stand for the functions of fit.c: a fit of many keys. */
int fit_keys_within(struct reference *reference,
	const struct screen_view *screen, const struct time_grid *grid,
	float bound_px, size_t memory_bytes, struct fit_keys *out)
{
	(void)screen;
	(void)bound_px;
	(void)memory_bytes;
	fits++;
	return make_keys(reference->clip->duration_s, grid->count / 2, out);
}

int fit_keys_evenly(float duration_s, int count, struct fit_keys *out)
{
	return make_keys(duration_s, count, out);
}

void fit_keys_release(struct fit_keys *keys)
{
	free(keys->time_s);
	*keys = (struct fit_keys){0};
}

/* Begins the duel with that much memory and ends it. */
static int try_memory(size_t bytes, const struct log *log)
{
	const struct demo_driver *duel = demo_find("duel");
	struct gl gl = gl_recorder_begin();
	struct demo_env env = {
		.log = log,
		.gl = &gl,
		.target = PIXELS_RGBA8888,
		.kernel = &kernel_float,
		.width = 120,
		.height = 160,
		.model_path = "assets/walker.glb",
		.memory_bytes = bytes,
	};
	struct demo *demo;
	int error = demo_create(duel, &env, &demo);

	if (!error) {
		demo_destroy(duel, demo);
	}
	return error;
}

static void test_memory_is_refused_before_keys_are_fitted(void **state)
{
	const size_t step = 256 * 1024;
	size_t bytes = 2 << 20;
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);

	(void)state;
	fits = 0;
	while (try_memory(bytes, &log) != 0) {
		assert_int_equal(fits, 0);
		assert_true(log_capture_has(&capture, LOG_ERROR, "--memory"));
		bytes += step;
		assert_true(bytes < (size_t)32 << 20);
		log = log_capture_begin(&capture);
	}
	assert_true(bytes > (size_t)4 << 20);
	assert_int_equal(fits, 1);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_memory_is_refused_before_keys_are_fitted),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
