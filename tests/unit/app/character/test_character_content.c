/* The boxes of what a character draws over uneven ground. */
#include "app/character/run/effects.h"
#include "app/character/show/character_draw.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <string.h>

struct shown {
	struct acting acting;
	struct character_drawing drawing;
	struct stage stage;
	mat4 view;
};

static void begin(struct shown *shown, const char *text)
{
	const struct shadow_ground none = {0};
	struct log log = log_to_stderr(LOG_WARNING);

	memset(shown, 0, sizeof(*shown));
	acting_begin(&shown->acting, "assets/walker.glb");
	acting_expect(&shown->acting, text);
	shown->stage.camera = camera_default();
	shown->stage.floor.wave_height = 0.1f;
	assert_int_equal(character_draw_init(&shown->drawing,
				 shown->acting.character, &none, &log),
		0);
	acting_run_to(&shown->acting, 0.5, 10);
	character_draw_update(&shown->drawing, &shown->stage);
	camera_view(&shown->stage.camera, shown->view);
}

static void end(struct shown *shown)
{
	acting_end(&shown->acting);
}

/* What stands is the figure and the ball, and 2% of their extent more. */
static void test_the_box_holds_the_figure_and_its_ball(void **state)
{
	const float center[3] = {0.3f, 1.4f, 1};
	struct floor_content content;
	struct shown shown;
	struct bounds box;
	float at[3], margin;

	(void)state;
	begin(&shown,
		"[target ball]\nplace = 0.3 1.4 1\nradius = 0.05\n"
		"[scene]\nwaves = 0.1\n");
	box = reach_now(&shown.drawing.reach, shown.acting.instance,
		(const vec4 *)shown.view);
	for (int row = 0; row < 3; row++) {
		at[row] = shown.view[3][row];
		for (int axis = 0; axis < 3; axis++) {
			at[row] += shown.view[axis][row] * center[axis];
		}
	}
	for (int side = -1; side <= 1; side += 2) {
		float corner[3];

		for (int axis = 0; axis < 3; axis++) {
			corner[axis] = at[axis] + 0.05f * (float)side;
		}
		bounds_add(&box, corner);
	}
	margin = 0.02f * bounds_extent(&box);
	content = character_draw_content(&shown.drawing, &shown.stage);
	assert_true(content.bounded);
	for (int axis = 0; axis < 3; axis++) {
		assert_near(content.standing.low[axis], box.low[axis] - margin,
			1e-5);
		assert_near(content.standing.high[axis],
			box.high[axis] + margin, 1e-5);
	}
	end(&shown);
}

/* The ball's shadow, where the ground is lowest and where it is highest. */
static void test_the_box_of_shadows_holds_that_of_the_ball(void **state)
{
	struct floor_content with, without;
	struct shown shown;

	(void)state;
	begin(&shown, "[scene]\nwaves = 0.1\n");
	without = character_draw_content(&shown.drawing, &shown.stage);
	end(&shown);
	begin(&shown,
		"[target ball]\nplace = 0 9 0\nradius = 0.1\n"
		"[scene]\nwaves = 0.1\n");
	with = character_draw_content(&shown.drawing, &shown.stage);
	end(&shown);
	/* Light falls by 0.778 along 0.389 and 0.494, from 9.1 units here. */
	assert_near(with.lying.low[0], -9.1 * 0.389 / 0.778 - 0.3, 1e-3);
	assert_near(with.lying.low[1], -0.1 - 0.3, 1e-5);
	assert_near(with.lying.low[2], -9.1 * 0.494 / 0.778 - 0.3, 1e-3);
	assert_near(with.lying.high[1], 0.1 + 0.3, 1e-5);
	assert_near(with.lying.high[0], without.lying.high[0], 1e-6);
	assert_near(with.lying.high[2], without.lying.high[2], 1e-6);
}

/* A cape in the middle of the figure does not reach out, and one behind does. */
static void test_the_box_holds_a_cape_that_is_worn(void **state)
{
	struct floor_content without, with;
	const struct cloth *cloth;
	struct shown shown;
	struct bounds box = bounds_empty();
	float margin;

	(void)state;
	begin(&shown, "[scene]\nwaves = 0.1\n");
	without = character_draw_content(&shown.drawing, &shown.stage);
	assert_all_near(&without.lying, &shown.drawing.drape.box, 6, 0.0);
	assert_false(bounds_is_empty(&without.lying));
	end(&shown);
	begin(&shown,
		"[scene]\nwaves = 0.1\n[cape a]\nbone = chest\non = no\n"
		"place = 0 1.4 0\n[cape c]\nbone = chest\n"
		"place = 0 1.42 -1\nlength = 0.5\n");
	shown.acting.instance->unit_scale = 2.0f;
	cloth = &shown.acting.character->cape[1].cloth;
	for (int v = 0; v < cloth->count; v++) {
		float at[3];

		for (int row = 0; row < 3; row++) {
			at[row] = shown.view[3][row];
			for (int axis = 0; axis < 3; axis++) {
				at[row] += 2.0f * shown.view[axis][row] *
					cloth->position[v][axis];
			}
		}
		bounds_add(&box, at);
	}
	with = character_draw_content(&shown.drawing, &shown.stage);
	margin = bounds_extent(&with.standing) * 0.02f / 1.04f;
	assert_near(with.standing.low[2], box.low[2] - margin, 1e-3);
	assert_true(box.low[2] < without.standing.low[2] - 0.1f);
	end(&shown);
}

static void test_level_ground_needs_no_boxes(void **state)
{
	struct shown shown;

	(void)state;
	begin(&shown, "[target ball]\nplace = 0 9 0\nradius = 0.1\n");
	assert_false(
		character_draw_content(&shown.drawing, &shown.stage).bounded);
	end(&shown);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_box_holds_the_figure_and_its_ball),
		cmocka_unit_test(test_the_box_of_shadows_holds_that_of_the_ball),
		cmocka_unit_test(test_the_box_holds_a_cape_that_is_worn),
		cmocka_unit_test(test_level_ground_needs_no_boxes),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
