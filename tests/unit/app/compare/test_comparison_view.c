/* Errors are those of the view that is played, which is each clip's own. */
#include "app/compare/comparison.h"
#include "app/model/levels/levels.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

/* How much of the picture's height or width the box around a clip takes. */
static float covered_by(const struct screen_view *screen)
{
	float low[2] = {1e9f, 1e9f}, high[2] = {-1e9f, -1e9f}, across, up;

	for (int i = 0; i < 8; i++) {
		const struct bounds *box = &screen->box;
		const float corner[3] = {i & 1 ? box->high[0] : box->low[0],
			i & 2 ? box->high[1] : box->low[1],
			i & 4 ? box->high[2] : box->low[2]};
		float at[2];

		screen_view_project(screen, corner, at);
		for (int axis = 0; axis < 2; axis++) {
			low[axis] = at[axis] < low[axis] ? at[axis] : low[axis];
			high[axis] =
				at[axis] > high[axis] ? at[axis] : high[axis];
		}
	}
	across = (high[0] - low[0]) / (float)screen->width;
	up = (high[1] - low[1]) / (float)screen->height;
	return across > up ? across : up;
}

static void test_each_clip_fills_the_picture(void **state)
{
	const struct log log = log_to_nowhere();
	struct model *model = model_fixture("../../assets/walker.glb", NULL);
	struct comparison_request request = {.clip = -1,
		.rate_hz = 30.0,
		.bound_px = 8.0f,
		.board = board_profile_find(NULL),
		.width = 240,
		.height = 320,
		.jobs = 1,
		.kernel = &kernel_float};
	struct comparison *comparison;

	(void)state;
	assert_int_equal(levels_make(model), 0);
	assert_int_equal(
		comparison_create(model, &request, &log, &comparison), 0);
	assert_true(comparison->clip_count > 1);
	for (int i = 0; i < comparison->clip_count; i++) {
		/* A margin of a tenth stays free around the box. */
		assert_near(covered_by(&comparison->clip[i].screen),
			1.0f / 1.1f, 0.01f);
	}
	comparison_destroy(comparison);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_clip_fills_the_picture),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
