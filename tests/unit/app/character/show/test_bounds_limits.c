/* What is just in the space of a character, and what is just outside. */
#include "app/character/run/effects.h"
#include "app/character/show/character_bounds.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

static const float unit = 0.5f; /* scene units a metre */

static void load(struct acting *acting, const char *model)
{
	acting_begin(acting, model);
	acting->instance->unit_scale = unit;
}

static void measure(struct acting *acting, struct character_bounds *bounds,
	const char *text)
{
	acting_expect(acting, text);
	memset(bounds, 0, sizeof(*bounds));
	assert_int_equal(character_bounds_init(bounds, acting->character), 0);
}

static void expect_box(
	const struct bounds *box, const struct bounds *wanted, double tolerance)
{
	assert_all_near(box->low, wanted->low, 3, tolerance);
	assert_all_near(box->high, wanted->high, 3, tolerance);
}

/* The model has its own extent in all clips, and is at rest afterwards. */
static void test_all_clips_make_the_extent(void **state)
{
	struct character_bounds bounds;
	struct bounds wanted;
	struct acting acting;
	struct pose *pose;

	(void)state;
	load(&acting, "assets/walker.glb");
	measure(&acting, &bounds, "[state a]\nclip = rest\n");
	wanted = bounds.rest;
	for (int i = 0; i < acting.model->clip_count; i++) {
		bounds_join(&wanted, &bounds.clip[i]);
		assert_false(bounds.is_played[i]);
	}
	assert_true(bounds_extent(&wanted) > bounds_extent(&bounds.rest));
	expect_box(&bounds.all, &wanted, 0);
	assert_near(bounds.extent, bounds_extent(&wanted), 0);
	pose = &acting.instance->pose;
	for (int i = 0; i < acting.model->node_count; i++) {
		const struct transform *rest = &acting.model->node[i].rest;

		assert_all_near(
			pose->local[i].translation, rest->translation, 3, 1e-6);
		assert_all_near(
			pose->local[i].rotation, rest->rotation, 4, 1e-6);
	}
	acting_end(&acting);
}

/* Of the first clip and of the first drawable, nothing else goes so far. */
static void test_the_first_ones_count_too(void **state)
{
	static const float place[3][3] = {{0}, {2, 0, 0}, {4, 0, 0}};
	struct character_bounds bounds;
	struct bounds wanted;
	struct acting acting;
	float moved[3];

	(void)state;
	load(&acting, "tests/fixtures/gltf/clip/far.gltf");
	memcpy((float *)acting.model->clip[0].channel[0].value, place,
		sizeof(place));
	measure(&acting, &bounds, "[state a]\nclip = rest\n");
	assert_near(bounds.all.high[0], unit * 5, 1e-5);
	acting_end(&acting);
	load(&acting, "tests/fixtures/gltf/scene/ground.gltf");
	acting.model->node[2].name = "lamp";
	measure(&acting, &bounds, "[state a]\nclip = rest\n[part lamp]\n");
	acting_run_to(&acting, 0.1, 50.0);
	character_bounds_now(&bounds, acting.character, moved);
	wanted = bounds_of_instance(acting.instance);
	expect_box(&bounds.extra, &wanted, 1e-5);
	acting_end(&acting);
}

static void test_the_clip_of_the_first_state_is_played(void **state)
{
	struct character_bounds bounds;
	struct acting acting;

	(void)state;
	load(&acting, "assets/walker.glb");
	measure(&acting, &bounds,
		"[state a]\nclip = run\n[state b]\nclip = idle\n"
		"[layer l]\nclip = wave\n");
	for (int i = 0; i < acting.model->clip_count; i++) {
		const char *name = acting.model->clip[i].name;

		assert_int_equal(bounds.is_played[i],
			strcmp(name, "run") == 0 || strcmp(name, "idle") == 0 ||
				strcmp(name, "wave") == 0);
	}
	acting_end(&acting);
}

/* The triangle's targets reach 3 along z, turned here along each axis. */
static void test_shapes_have_room_along_each_axis(void **state)
{
	static const float turns[6][4] = {{0, 0, 0, 1}, {0, 1, 0, 0},
		{0, 0.70710678f, 0, 0.70710678f},
		{0, -0.70710678f, 0, 0.70710678f},
		{0.70710678f, 0, 0, 0.70710678f},
		{-0.70710678f, 0, 0, 0.70710678f}};

	(void)state;
	for (int i = 0; i < 12; i++) {
		struct character_bounds bounds;
		struct bounds wanted, all;
		struct acting acting;

		load(&acting, "tests/fixtures/gltf/mesh/weights.gltf");
		for (int n = 0; n < acting.model->node_count; n++) {
			memcpy(acting.model->node[n].rest.rotation,
				turns[i % 6], sizeof(turns[0]));
		}
		/* A hundredth of the model does not matter. */
		acting.model->mesh[0].primitive[0].position[1][0] *=
			i < 6 ? 10.0f : 1000.0f;
		measure(&acting, &bounds, "[morph m]\n");
		wanted = bounds_of_targets(
			acting.instance, acting.character->morph[0].node);
		if (i >= 6) {
			assert_true(bounds_is_empty(&bounds.extra));
			acting_end(&acting);
			continue;
		}
		expect_box(&bounds.extra, &wanted, 0);
		all = bounds.rest;
		bounds_join(&all, &wanted);
		expect_box(&bounds.all, &all, 0);
		acting_end(&acting);
	}
}

/* Each ball has room alone, but not both of them. */
static void test_room_that_one_ball_takes_is_missing_for_another(void **state)
{
	struct character_bounds bounds;
	struct acting acting;
	float extent, middle;
	char text[256];

	(void)state;
	load(&acting, "assets/walker.glb");
	measure(&acting, &bounds, "[state a]\nclip = rest\n");
	extent = bounds.extent / unit;
	middle = (bounds.all.low[0] + bounds.all.high[0]) / (2 * unit);
	snprintf(text, sizeof(text),
		"[target a]\nplace = %.3f 1 0\nradius = 0.1\n"
		"[target b]\nplace = %.3f 1 0\nradius = 0.1\n"
		"[target n]\nnode = %s\nradius = 0.1\n",
		(double)(middle + 1.2f * extent),
		(double)(middle - 1.2f * extent), acting.model->node[0].name);
	measure(&acting, &bounds, text);
	assert_false(bounds_is_empty(&bounds.ball[0]));
	assert_true(bounds_is_empty(&bounds.ball[1]));
	assert_true(bounds_is_empty(&bounds.ball[2]));
	acting_end(&acting);
}

/* Metres count, whatever the scale of the part is. */
static void test_a_part_has_room_along_each_axis_and_scale(void **state)
{
	static const float scale[3] = {2, 4, 8};

	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		struct bounds wanted = bounds_empty();
		struct character_bounds bounds;
		struct acting acting;
		struct instance *instance;
		char text[128];
		int hand;

		load(&acting, "assets/arm.glb");
		instance = acting.instance;
		hand = model_find_node(acting.model, "Hand");
		memcpy(acting.model->node[acting.model->node[hand].parent]
				.rest.scale,
			scale, sizeof(scale));
		snprintf(text, sizeof(text), "[part Hand]\n%c = 0 -0.1 0.2\n",
			"xyz"[axis]);
		measure(&acting, &bounds, text);
		for (int end = 0; end < 2; end++) {
			struct bounds box;

			pose_rest(&instance->pose, instance->model);
			instance->pose.local[hand].translation[axis] +=
				(end ? 0.2f : -0.1f) *
				acting.character->part[0].metre[axis];
			instance_update(instance);
			box = bounds_of_instance(instance);
			bounds_join(&wanted, &box);
		}
		assert_near(acting.character->part[0].metre[axis],
			1 / scale[axis], 1e-6);
		expect_box(&bounds.extra, &wanted, 1e-6);
		acting_end(&acting);
	}
}

/* -x, x, -y ... and then the corners of a cube, x first. */
static float along(const float point[3], int direction)
{
	static const signed char ways[CHARACTER_DIRECTIONS][3] = {{-1, 0, 0},
		{1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1},
		{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {-1, -1, 1},
		{1, -1, 1}, {-1, 1, 1}, {1, 1, 1}};
	float sum = 0;

	for (int axis = 0; axis < 3; axis++) {
		sum += (float)ways[direction][axis] * point[axis];
	}
	return sum;
}

/* With any kernel, as all vertices of parts without a skin are posed. */
static void test_the_outermost_vertices_are_found_in_each_direction(void **state)
{
	static const char *const kernels[] = {"float", "fixed"};
	struct log log = log_to_stderr(LOG_ERROR);

	(void)state;
	for (int k = 0; k < 2; k++) {
		struct character_bounds bounds;
		struct acting acting;

		acting_begin(&acting, "assets/arm.glb");
		instance_destroy(acting.instance);
		assert_int_equal(
			instance_create(acting.model, kernel_find(kernels[k]),
				&log, &acting.instance),
			0);
		measure(&acting, &bounds, "[part Base]\n");
		for (int i = 0; i <
			acting.instance->drawable_count * CHARACTER_DIRECTIONS;
			i++) {
			int direction = i % CHARACTER_DIRECTIONS;
			int drawable = i / CHARACTER_DIRECTIONS;
			const struct model_primitive *primitive =
				acting.instance->drawable[drawable].primitive;
			const float *found =
				primitive->position[bounds.outermost[drawable]
								    [direction]];

			for (int v = 0; v < primitive->vertex_count; v++) {
				assert_true(along(primitive->position[v],
						    direction) <=
					along(found, direction) + 1e-6f);
			}
		}
		acting_end(&acting);
	}
}

static void test_what_a_raised_arm_reaches_has_room_on_all_sides(void **state)
{
	struct character_bounds bounds;
	struct acting acting;
	struct bounds raised;
	float moved[3];

	(void)state;
	load(&acting, "assets/arm.glb");
	measure(&acting, &bounds, "[part Forearm]\npitch = -60 -90 90 90\n");
	acting_run_to(&acting, 0.1, 50.0);
	character_bounds_now(&bounds, acting.character, moved);
	raised = bounds_of_instance(acting.instance);
	expect_box(&bounds.extra, &raised, 0.02);
	acting_end(&acting);
}

/*
 * Moves a worn cape into the middle of the figure but for its corner that goes
 * this part of the extent beyond the box along an axis. Returns whether the
 * corner has room.
 */
static bool has_room(struct acting *acting, struct character_bounds *bounds,
	int corner, int axis, float beyond)
{
	struct character_cape *cape = acting->character->cape;
	float middle[3], moved[3];
	struct bounds now;

	bounds_center(&bounds->rest, middle);
	for (int i = 0; i < cape->cloth.count; i++) {
		for (int k = 0; k < 3; k++) {
			cape->cloth.position[i][k] = middle[k] / unit;
		}
	}
	cape->cloth.position[corner][axis] =
		(beyond > 0 ? bounds->rest.high[axis] : bounds->rest.low[axis]) /
			unit +
		beyond * bounds->extent / unit;
	bounds->swung = bounds_empty();
	now = character_bounds_now(bounds, acting->character, moved);
	return now.low[axis] < bounds->rest.low[axis] ||
		now.high[axis] > bounds->rest.high[axis];
}

/* By less than 3% a cape does not matter; far away, the figure would be small. */
static void test_a_cape_has_room_if_it_swings_well_outside(void **state)
{
	struct character_bounds bounds;
	struct acting acting;

	(void)state;
	load(&acting, "assets/walker.glb");
	measure(&acting, &bounds,
		"[state a]\nclip = rest\n[cape c]\nbone = chest\n"
		"place = 0 1.4 -0.2\nfade = 0\n");
	acting_run_to(&acting, 0.1, 50.0);
	assert_true(acting.character->cape[0].worn);
	for (int i = 0; i < 12; i++) {
		int axis = i % 3, count = acting.character->cape->cloth.count;
		int corner = i < 6 ? 0 : count - 1;
		float sign = i / 3 % 2 ? -1 : 1, side, far;

		side = (bounds.all.high[axis] - bounds.all.low[axis]) /
			bounds.extent;
		far = 2 - side;
		assert_false(
			has_room(&acting, &bounds, corner, axis, sign * 0.028f));
		assert_true(
			has_room(&acting, &bounds, corner, axis, sign * 0.032f));
		assert_true(has_room(
			&acting, &bounds, corner, axis, sign * (far - 0.3f)));
		assert_false(has_room(
			&acting, &bounds, corner, axis, sign * (far + 0.3f)));
	}
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_all_clips_make_the_extent),
		cmocka_unit_test(test_the_first_ones_count_too),
		cmocka_unit_test(test_the_clip_of_the_first_state_is_played),
		cmocka_unit_test(test_shapes_have_room_along_each_axis),
		cmocka_unit_test(
			test_room_that_one_ball_takes_is_missing_for_another),
		cmocka_unit_test(test_a_part_has_room_along_each_axis_and_scale),
		cmocka_unit_test(
			test_the_outermost_vertices_are_found_in_each_direction),
		cmocka_unit_test(
			test_what_a_raised_arm_reaches_has_room_on_all_sides),
		cmocka_unit_test(test_a_cape_has_room_if_it_swings_well_outside),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
