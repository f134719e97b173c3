/* The space that the camera leaves for a character. */
#include "app/character/run/effects.h"
#include "app/character/show/character_bounds.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

static const float unit = 0.5f; /* scene units a metre */

static void begin_at(struct acting *acting, struct character_bounds *bounds,
	const char *model, const char *text)
{
	acting_begin(acting, model);
	acting->instance->unit_scale = unit;
	acting_expect(acting, text);
	memset(bounds, 0, sizeof(*bounds));
	assert_int_equal(character_bounds_init(bounds, acting->character), 0);
}

static void begin(struct acting *acting, struct character_bounds *bounds,
	const char *text)
{
	begin_at(acting, bounds, "assets/walker.glb", text);
}

static void expect_box(
	const struct bounds *box, const struct bounds *wanted, double tolerance)
{
	assert_all_near(box->low, wanted->low, 3, tolerance);
	assert_all_near(box->high, wanted->high, 3, tolerance);
}

static void expect_now(struct character_bounds *bounds,
	const struct acting *acting, const struct bounds *wanted)
{
	float moved[3];
	struct bounds now =
		character_bounds_now(bounds, acting->character, moved);

	expect_box(&now, wanted, 1e-6);
	assert_all_near(moved, ((float[3]){0}), 3, 0.0);
}

static int clip_of(const struct acting *acting, const char *name)
{
	int clip = model_find_clip(acting->model, name);

	assert_true(clip >= 0);
	return clip;
}

static struct bounds joined(const struct bounds *a, const struct bounds *b)
{
	struct bounds box = *a;

	bounds_join(&box, b);
	return box;
}

static void test_the_clips_of_a_state_are_in_its_box(void **state)
{
	struct character_bounds bounds;
	struct acting acting;
	struct bounds both;

	(void)state;
	begin(&acting, &bounds,
		"[parameter v]\n[state a]\nclip = walk\n[state b]\nclip = rest\n"
		"[state c]\nblend = v, jump 0, run 1\n[transition a c]\n"
		"fade = 0\n[buttons]\nUP = go b\nDOWN = go c\n");
	assert_near(bounds_extent(&bounds.rest), unit * 1.76, unit * 0.02);
	expect_now(&bounds, &acting, &bounds.clip[clip_of(&acting, "walk")]);
	acting_tap(&acting, BUTTON_UP, 1.0, 50.0);
	expect_now(&bounds, &acting, &bounds.rest);
	acting_tap(&acting, BUTTON_DOWN, 1.0, 50.0);
	both = joined(&bounds.clip[clip_of(&acting, "jump")],
		&bounds.clip[clip_of(&acting, "run")]);
	expect_now(&bounds, &acting, &both);
	acting_end(&acting);
}

/* Begins with text, and measures a box that the layer's jump makes higher. */
static const struct bounds *begin_jumping(struct acting *acting,
	struct character_bounds *bounds, const char *text, struct bounds *with)
{
	const struct bounds *idle;

	begin(acting, bounds, text);
	idle = &bounds->clip[clip_of(acting, "idle")];
	*with = joined(idle, &bounds->clip[clip_of(acting, "jump")]);
	assert_true(with->high[1] > idle->high[1] + 0.05f);
	expect_now(bounds, acting, idle);
	return idle;
}

static void test_a_layer_is_in_the_box_while_it_is_on(void **state)
{
	struct character_bounds bounds;
	struct acting acting;
	struct bounds with;
	const struct bounds *idle = begin_jumping(&acting, &bounds,
		"[state a]\nclip = idle\n[layer l]\nclip = jump\non = no\n"
		"[buttons]\nUP = toggle l\n",
		&with);

	(void)state;
	acting_tap(&acting, BUTTON_UP, 0.1, 50.0);
	expect_now(&bounds, &acting, &with);
	acting_tap(&acting, BUTTON_UP, 0.1, 50.0);
	expect_now(&bounds, &acting, idle);
	acting_end(&acting);
}

static void test_a_layer_that_plays_once_is_in_the_box_meanwhile(void **state)
{
	struct character_bounds bounds;
	struct acting acting;
	struct bounds with;
	const struct bounds *idle = begin_jumping(&acting, &bounds,
		"[state a]\nclip = idle\n[layer l]\nclip = jump\nplay = once\n"
		"[buttons]\nUP = play l\n",
		&with);

	(void)state;
	acting_tap(&acting, BUTTON_UP, 0.5, 50.0);
	expect_now(&bounds, &acting, &with);
	acting_run_to(&acting, 3.0, 50.0);
	expect_now(&bounds, &acting, idle);
	acting_end(&acting);
}

static const char ball_text[] =
	"[parameter x]\nrange = -1.5 0.5\n[parameter z]\nrange = 0.2 1\n"
	"[state a]\nclip = rest\n"
	"[target ball]\nplace = x 1.5 z\nradius = 0.1\n"
	"[look watch]\nbone = head\ntarget = ball\non = no\n"
	"[buttons]\nUP = toggle watch\n";

/* Wherever its parameters can move it. */
static void test_a_ball_has_room_while_it_is_used(void **state)
{
	const struct bounds wanted = {{unit * -1.6f, unit * 1.4f, unit * 0.1f},
		{unit * 0.6f, unit * 1.6f, unit * 1.1f}};
	struct character_bounds bounds;
	struct acting acting;
	struct bounds with;

	(void)state;
	begin(&acting, &bounds, ball_text);
	expect_box(&bounds.ball[0], &wanted, 1e-6);
	with = joined(&bounds.rest, &wanted);
	expect_now(&bounds, &acting, &bounds.rest);
	acting_tap(&acting, BUTTON_UP, 0.1, 50.0);
	expect_now(&bounds, &acting, &with);
	acting_tap(&acting, BUTTON_UP, 0.5, 50.0);
	expect_now(&bounds, &acting, &bounds.rest);
	acting_end(&acting);
}

/* A ball that would make the figure less than half as large is left out. */
static void test_balls_that_are_not_shown_or_too_far_have_no_room(void **state)
{
	struct character_bounds bounds;
	struct acting acting;
	char text[512];
	float extent;

	(void)state;
	begin(&acting, &bounds, "[state a]\nclip = rest\n");
	extent = bounds_extent(&bounds.all) / unit;
	snprintf(text, sizeof(text),
		"[target none]\nplace = 0 3 0\n"
		"[target camera]\ncamera = yes\nradius = 0.1\n"
		"[target hand]\nnode = hand.L\nradius = 0.1\n"
		"[target near]\nplace = 0 0 %.3f\nradius = 0.1\n"
		"[target far]\nplace = 0 0 %.3f\nradius = 0.1\n",
		(double)(bounds.all.low[2] / unit + 1.98f * extent - 0.1f),
		(double)(bounds.all.low[2] / unit + 2.02f * extent - 0.1f));
	acting_end(&acting);
	begin(&acting, &bounds, text);
	for (int i = 0; i < 5; i++) {
		assert_int_equal(bounds_is_empty(&bounds.ball[i]), i != 3);
	}
	acting_end(&acting);
}

static const char truck_text[] =
	"[part base]\nnode = Base\n[part truck]\nnode = Car\n"
	"y = 0 0 0.1\nz = 0 -0.4 0.6 2\n"
	"[buttons]\nUP hold = move truck z 1\n";

/* The node's box with the truck shifted, posed by hand. */
static struct bounds with_shift(struct acting *acting, int axis, float way)
{
	struct instance *instance = acting->instance;
	int car = model_find_node(acting->model, "Car");
	struct bounds box;

	pose_rest(&instance->pose, instance->model);
	instance->pose.local[car].translation[axis] += way;
	instance_update(instance);
	box = bounds_of_instance(instance);
	pose_rest(&instance->pose, instance->model);
	instance_update(instance);
	return box;
}

static void test_a_part_has_room_where_it_may_be_shifted(void **state)
{
	struct character_bounds bounds;
	struct acting acting;
	struct bounds wanted = bounds_empty();
	float place[3];

	(void)state;
	begin_at(&acting, &bounds, "assets/arm.glb", truck_text);
	acting_place(&acting, "Car", place);
	assert_near(place[2], 0.22, 1e-5);
	for (int i = 0; i < 4; i++) {
		struct bounds box = with_shift(&acting, 1 + i / 2,
			((float[]){0.0f, 0.1f, -0.4f, 0.6f})[i]);

		bounds_join(&wanted, &box);
	}
	expect_box(&bounds.extra, &wanted, 1e-6);
	assert_true(bounds.extra.low[2] < bounds.rest.low[2] - 0.01f);
	assert_true(bounds.extra.high[2] > bounds.rest.high[2] + 0.01f);
	expect_now(&bounds, &acting, &wanted);
	acting_end(&acting);
}

static void test_a_part_that_may_go_far_away_has_no_room_there(void **state)
{
	struct character_bounds bounds;
	struct acting acting;
	struct bounds wanted;

	(void)state;
	begin_at(&acting, &bounds, "assets/arm.glb",
		"[part truck]\nnode = Car\nz = 0 -0.4 9\n");
	wanted = with_shift(&acting, 2, -0.4f);
	expect_box(&bounds.extra, &wanted, 1e-6);
	acting_end(&acting);
}

/* Also when it goes back. */
static void test_what_parts_have_reached_stays_in_the_box(void **state)
{
	struct character_bounds bounds;
	struct acting acting;
	struct bounds raised;
	float moved[3];

	(void)state;
	begin_at(&acting, &bounds, "assets/arm.glb",
		"[part Forearm]\npitch = 0 -90 90 90\n"
		"[buttons]\nUP hold = move Forearm pitch -1\n");
	acting_tap(&acting, BUTTON_UP, 1.0, 50.0);
	character_bounds_now(&bounds, acting.character, moved);
	raised = bounds_of_instance(acting.instance);
	assert_true(raised.high[1] > bounds.rest.high[1] + 0.1f);
	/* All but what is round at the end of the box. */
	assert_near(bounds.extra.high[1], raised.high[1], 0.01);
	pose_rest(&acting.instance->pose, acting.model);
	instance_update(acting.instance);
	character_bounds_now(&bounds, acting.character, moved);
	assert_near(bounds.extra.high[1], raised.high[1], 0.01);
	acting_end(&acting);
}

/* The box of all vertices of a drawable, each moved along the slope. */
static struct bounds box_of_vertices(const struct instance *instance,
	int drawable, float y, const float slope[2])
{
	const struct drawable *shown = &instance->drawable[drawable];
	struct bounds box = bounds_empty();

	for (int v = 0; v < shown->primitive->vertex_count; v++) {
		float at[3];

		instance_world_vertex(instance, shown, v, at);
		for (int axis = 0; axis < 3; axis++) {
			at[axis] *= unit;
		}
		at[0] += slope[0] * (at[1] - y);
		at[2] += slope[1] * (at[1] - y);
		bounds_add(&box, at);
	}
	return box;
}

/* The crate's corners are its outermost vertices in any direction. */
static void test_outermost_vertices_make_the_box_of_a_turned_crate(void **state)
{
	const float slope[2] = {0.5f, -0.25f};
	struct character_bounds bounds;
	struct acting acting;
	int crate, checked = 0;

	(void)state;
	begin_at(&acting, &bounds, "assets/arm.glb",
		"[part Crate]\nheading = 30\npitch = 20\nbank = 50\n");
	acting_run_to(&acting, 0.1, 50.0);
	crate = model_find_node(acting.model, "Crate");
	for (int i = 0; i < acting.instance->drawable_count; i++) {
		struct bounds wanted, box = bounds_empty();

		if (acting.instance->drawable[i].node != crate) {
			continue;
		}
		wanted = box_of_vertices(acting.instance, i, 0.1f, slope);
		character_bounds_add(
			&bounds, acting.instance, i, 0.1f, slope, &box);
		expect_box(&box, &wanted, 0.005);
		checked++;
	}
	assert_true(checked > 0);
	acting_end(&acting);
}

/* At rest these are the outermost ones along the axes. */
static void test_outermost_vertices_make_the_box_at_rest(void **state)
{
	const float slope[2] = {0.0f, 0.0f};
	struct character_bounds bounds;
	struct acting acting;

	(void)state;
	begin_at(&acting, &bounds, "assets/arm.glb", "[part Base]\n");
	for (int i = 0; i < acting.instance->drawable_count; i++) {
		struct bounds box = bounds_empty();
		struct bounds wanted =
			box_of_vertices(acting.instance, i, 0.0f, slope);

		character_bounds_add(
			&bounds, acting.instance, i, 0.0f, slope, &box);
		expect_box(&box, &wanted, 1e-6);
	}
	acting_end(&acting);
}

/* Levels of detail leave out vertices of a skin that the fixed kernel poses. */
static void test_outermost_vertices_are_posed_at_each_level(void **state)
{
	struct log log = log_to_stderr(LOG_ERROR);
	struct character_bounds bounds = {0};
	struct acting acting;
	int skins = 0;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	instance_destroy(acting.instance);
	assert_int_equal(instance_create(acting.model, kernel_find("fixed"),
				 &log, &acting.instance),
		0);
	for (int i = 0; i < acting.instance->drawable_count; i++) {
		struct drawable *drawable = &acting.instance->drawable[i];

		if (drawable->fixed && drawable->skin >= 0) {
			drawable->fixed->skin.vertex_count_to[0] /= 2;
			skins++;
		}
	}
	assert_true(skins > 0);
	acting_expect(&acting, "[state a]\nclip = rest\n[part hand.L]\n");
	assert_int_equal(character_bounds_init(&bounds, acting.character), 0);
	for (int i = 0; i < acting.instance->drawable_count; i++) {
		const struct drawable *drawable = &acting.instance->drawable[i];

		for (int k = 0; drawable->fixed && drawable->skin >= 0 &&
			k < CHARACTER_DIRECTIONS;
			k++) {
			int vertex = bounds.outermost[i][k];

			assert_true(drawable->fixed->inverse_order[vertex] <
				(uint32_t)drawable->fixed->skin.vertex_count_to[0]);
		}
	}
	acting_end(&acting);
}

/* Its targets reach 3 along z, and its triangle lies at 0. */
static void test_shapes_beyond_the_rest_pose_have_room(void **state)
{
	struct character_bounds bounds;
	struct acting acting;
	struct bounds wanted;

	(void)state;
	begin_at(&acting, &bounds, "tests/fixtures/gltf/mesh/weights.gltf",
		"[morph m]\n");
	wanted = bounds_of_targets(
		acting.instance, acting.character->morph[0].node);
	assert_near(wanted.high[2], 3.0 * unit, 1e-6);
	expect_box(&bounds.extra, &wanted, 0.0);
	acting_end(&acting);
	begin_at(&acting, &bounds, "assets/face.glb", "[morph m]\n");
	assert_true(bounds_is_empty(&bounds.extra));
	acting_end(&acting);
}

static const char swing_text[] =
	"[state idle]\nclip = rest\n"
	"[spring tail]\nbones = ponytail.4 4\ngravity = 0 60 0\nfade = 0.1\n"
	"on = no\n[buttons]\nUP = toggle tail\n";

static void test_springs_have_room_where_they_have_swung(void **state)
{
	const struct character_spring *tail = NULL;
	struct character_bounds bounds;
	struct acting acting;
	struct bounds now = bounds_empty();

	(void)state;
	begin(&acting, &bounds, swing_text);
	for (int i = 0; i < acting.character->op_count; i++) {
		if (acting.character->op[i].run == character_spring_run) {
			tail = acting.character->op[i].what;
		}
	}
	expect_now(&bounds, &acting, &bounds.rest);
	assert_non_null(tail);
	acting_tap(&acting, BUTTON_UP, 3.0, 50.0);
	for (int i = 0; i < tail->spring.count; i++) {
		float at[3];

		for (int axis = 0; axis < 3; axis++) {
			at[axis] = tail->spring.position[i][axis] * unit;
		}
		bounds_add(&now, at);
	}
	assert_true(now.high[1] > bounds.rest.high[1] + 0.03f);
	now = joined(&now, &bounds.rest);
	expect_now(&bounds, &acting, &now);
	/* Until they are switched off. */
	acting_tap(&acting, BUTTON_UP, 1.0, 50.0);
	expect_now(&bounds, &acting, &bounds.rest);
	assert_true(bounds_is_empty(&bounds.swung));
	acting_end(&acting);
}

static void test_a_cape_has_room_while_it_is_worn(void **state)
{
	struct character_bounds bounds;
	struct acting acting;
	struct bounds now = bounds_empty();
	const struct cloth *cloth;

	(void)state;
	begin(&acting, &bounds,
		"[state a]\nclip = rest\n[cape c]\nbone = chest\n"
		"place = 0 1.42 -0.4\nlength = 1.2\nflare = 2\nwidth = 0.6\n"
		"on = no\nfade = 0.1\n[buttons]\nUP = toggle c\n");
	expect_now(&bounds, &acting, &bounds.rest);
	acting_tap(&acting, BUTTON_UP, 0.5, 50.0);
	cloth = &acting.character->cape[0].cloth;
	for (int i = 0; i < cloth->count; i++) {
		float at[3];

		for (int axis = 0; axis < 3; axis++) {
			at[axis] = cloth->position[i][axis] * unit;
		}
		bounds_add(&now, at);
	}
	assert_true(now.low[2] < bounds.rest.low[2] - 0.03f);
	now = joined(&now, &bounds.rest);
	expect_now(&bounds, &acting, &now);
	acting_tap(&acting, BUTTON_UP, 1.0, 50.0);
	expect_now(&bounds, &acting, &bounds.rest);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_clips_of_a_state_are_in_its_box),
		cmocka_unit_test(test_a_layer_is_in_the_box_while_it_is_on),
		cmocka_unit_test(
			test_a_layer_that_plays_once_is_in_the_box_meanwhile),
		cmocka_unit_test(test_a_ball_has_room_while_it_is_used),
		cmocka_unit_test(
			test_balls_that_are_not_shown_or_too_far_have_no_room),
		cmocka_unit_test(test_a_part_has_room_where_it_may_be_shifted),
		cmocka_unit_test(
			test_a_part_that_may_go_far_away_has_no_room_there),
		cmocka_unit_test(test_what_parts_have_reached_stays_in_the_box),
		cmocka_unit_test(
			test_outermost_vertices_make_the_box_of_a_turned_crate),
		cmocka_unit_test(test_outermost_vertices_make_the_box_at_rest),
		cmocka_unit_test(test_outermost_vertices_are_posed_at_each_level),
		cmocka_unit_test(test_shapes_beyond_the_rest_pose_have_room),
		cmocka_unit_test(test_springs_have_room_where_they_have_swung),
		cmocka_unit_test(test_a_cape_has_room_while_it_is_worn),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
