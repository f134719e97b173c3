/* What demos find out about any model: its clips, its speeds, its bones. */
#include "app/character/motions/motions.h"
#include "app/demo/crowd/crowd_figure.h"
#include "app/demo/tuner/tuner_bones.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct found {
	struct log log;
	struct actor actor;
	struct motions motions;
};

static void load(struct found *found, const char *path)
{
	memset(found, 0, sizeof(*found));
	found->log = log_to_stderr(LOG_WARNING);
	assert_int_equal(model_load(path, &found->log, &found->actor.model), 0);
}

/* In the model that load() left. */
static void find_in(struct found *found, const char *path, const char *clip,
	const char *character)
{
	const struct character_request request = {
		.model_path = path,
		.clip = clip,
		.file = character,
	};

	assert_int_equal(
		instance_create(found->actor.model, kernel_find("fixed"),
			&found->log, &found->actor.instance),
		0);
	found->actor.extent = 1.72f;
	assert_int_equal(motions_find(&request, found->actor.instance,
				 &found->log, &found->motions),
		0);
}

static void find(struct found *found, const char *path, const char *clip,
	const char *character)
{
	load(found, path);
	find_in(found, path, clip, character);
}

static void release(struct found *found)
{
	instance_destroy(found->actor.instance);
	model_destroy(found->actor.model);
}

static const char *clip_of(const struct found *found, enum motion_role role)
{
	int clip = found->motions.role[role].clip;

	return clip < 0 ? "" : found->actor.model->clip[clip].name;
}

static void test_the_walkers_feet_tell_its_speeds(void **state)
{
	struct found found;
	const struct motion *role = found.motions.role;

	(void)state;
	find(&found, "assets/walker.glb", NULL, "none");
	assert_string_equal(clip_of(&found, MOTION_STAND), "idle");
	assert_string_equal(clip_of(&found, MOTION_WALK), "walk");
	assert_string_equal(clip_of(&found, MOTION_RUN), "run");
	assert_near(role[MOTION_STAND].speed, 0.0, 1e-6);
	assert_near(role[MOTION_WALK].speed, 1.03, 0.06);
	assert_near(role[MOTION_RUN].speed, 2.6, 0.3);
	assert_near(role[MOTION_WALK].facing_rad, 0.0, 1e-6);
	assert_near(role[MOTION_WALK].drift[1], 0.0, 1e-6);
	release(&found);
}

/* A walker that is turned to its left goes there, and so in the crowd. */
static void test_a_figure_faces_where_its_feet_take_it(void **state)
{
	static const float turned[4] = {0.0f, 0.70710678f, 0.0f, 0.70710678f};
	struct found found;
	struct crowd_figure figure = {0};
	const struct demo_env env = {.log = &found.log,
		.model_path = "assets/walker.glb",
		.character = "none"};

	(void)state;
	load(&found, "assets/walker.glb");
	for (int i = 0; i < found.actor.model->node_count; i++) {
		struct model_node *node = &found.actor.model->node[i];

		if (node->parent < 0) {
			memcpy(node->rest.rotation, turned, sizeof(turned));
		}
	}
	find_in(&found, "assets/walker.glb", NULL, "none");
	assert_near(found.motions.role[MOTION_WALK].facing_rad, acos(0), 1e-3);
	assert_int_equal(crowd_figure_make(&figure, &env, &found.actor), 0);
	assert_near(figure.front_rad, acos(0), 1e-3);
	release(&found);
}

/* Whatever place the clip with a role's name has. */
static void test_a_named_walk_is_the_run_where_none_is_named(void **state)
{
	struct found found;

	(void)state;
	for (int place = 0; place < 3; place++) {
		struct model *model;
		struct model_clip walk;
		int at;

		load(&found, "assets/walker.glb");
		model = found.actor.model;
		for (int i = 0; i < model->clip_count; i++) {
			if (strcmp(model->clip[i].name, "run") == 0) {
				model->clip[i].name = "dash";
			}
		}
		at = model_find_clip(model, "walk");
		walk = model->clip[at];
		model->clip[at] = model->clip[place];
		model->clip[place] = walk;
		find_in(&found, "assets/walker.glb", NULL, "none");
		assert_string_equal(clip_of(&found, MOTION_WALK), "walk");
		assert_string_equal(clip_of(&found, MOTION_RUN), "walk");
		assert_string_equal(clip_of(&found, MOTION_STAND), "idle");
		release(&found);
	}
}

static void test_the_instance_stays_in_the_rest_pose(void **state)
{
	struct found found;

	(void)state;
	find(&found, "assets/walker.glb", NULL, "none");
	for (int i = 0; i < found.actor.model->node_count; i++) {
		assert_memory_equal(&found.actor.instance->pose.local[i],
			&found.actor.model->node[i].rest,
			sizeof(struct transform));
	}
	release(&found);
}

/* The floor carries the drift away, so the box is that of a clip in place. */
static void test_bounds_leave_the_drift_out(void **state)
{
	struct found found;
	struct bounds whole, placed;
	struct motion motion;

	(void)state;
	find(&found, "assets/walker.glb", NULL, "none");
	motion = found.motions.role[MOTION_WALK];
	whole = bounds_of_clip(found.actor.instance, motion.clip);
	motion.drift[0] = 0.5f;
	motion.drift[1] = -0.25f;
	placed = motion_bounds(found.actor.instance, &motion);
	assert_near(placed.high[0], whole.high[0] - 0.5f, 1e-6);
	assert_near(placed.low[0], whole.low[0], 1e-6);
	assert_near(placed.high[2], whole.high[2], 1e-6);
	assert_near(placed.low[2], whole.low[2] + 0.25f, 1e-6);
	release(&found);
}

static void test_the_character_file_tells_speeds_and_bones(void **state)
{
	struct found found;

	(void)state;
	find(&found, "assets/walker.glb", NULL, NULL);
	assert_near(found.motions.role[MOTION_WALK].speed, 1.03, 1e-6);
	assert_near(found.motions.role[MOTION_RUN].speed, 2.6, 1e-6);
	assert_int_equal(found.motions.bone_count, 2);
	assert_string_equal(found.actor.model->node[found.motions.bone[0]].name,
		"shoulder.L");
	release(&found);
}

static void test_a_clip_that_is_asked_for_has_all_roles(void **state)
{
	struct found found;

	(void)state;
	find(&found, "assets/walker.glb", "jump", NULL);
	for (int i = 0; i < MOTION_ROLES; i++) {
		assert_string_equal(
			clip_of(&found, (enum motion_role)i), "jump");
	}
	release(&found);
}

/* Many files begin with the pose in which the skin was bound. */
static void test_a_clip_of_one_moment_gives_way_to_one_that_moves(void **state)
{
	struct found found;
	struct model *model;

	(void)state;
	load(&found, "assets/walker.glb");
	model = found.actor.model;
	model->clip[0].name = "bind";
	model->clip[0].duration_s = 0.0f;
	model->clip[0].channel_count = 0;
	model->clip[1].name = "bow";
	model->clip[1].channel_count = 0; /* it stays in its place */
	model->clip_count = 2;
	find_in(&found, "assets/walker.glb", NULL, "none");
	assert_string_equal(clip_of(&found, MOTION_STAND), "bow");
	assert_string_equal(clip_of(&found, MOTION_WALK), "bow");
	release(&found);
	load(&found, "assets/walker.glb");
	found.actor.model->clip[0].duration_s = 0.0f;
	found.actor.model->clip[0].channel_count = 0;
	found.actor.model->clip_count = 1;
	find_in(&found, "assets/walker.glb", NULL, "none");
	assert_int_equal(found.motions.role[MOTION_STAND].clip, 0);
	release(&found);
}

static void test_a_model_without_clips_stands(void **state)
{
	struct found found;

	(void)state;
	find(&found, "assets/arm.glb", NULL, "none");
	for (int i = 0; i < MOTION_ROLES; i++) {
		assert_int_equal(found.motions.role[i].clip, -1);
		assert_near(found.motions.role[i].speed, 0.0, 1e-6);
	}
	release(&found);
}

static void test_a_broken_character_file_is_an_error(void **state)
{
	struct found found;
	const struct character_request request = {.model_path = "assets/arm.glb",
		.file = "assets/characters/none.character"};

	(void)state;
	find(&found, "assets/arm.glb", NULL, "none");
	found.log = log_to_nowhere();
	assert_true(motions_find(&request, found.actor.instance, &found.log,
			    &found.motions) < 0);
	release(&found);
}

/* Both shoulders first, then every bone that moves a vertex, and back. */
static void test_the_tuner_chooses_any_bone(void **state)
{
	struct tuner_bones bones;
	struct found found;
	char name[64];
	int count = 0;

	(void)state;
	find(&found, "assets/walker.glb", NULL, "none");
	assert_int_equal(
		tuner_bones_init(&bones, found.actor.instance, &found.motions),
		0);
	assert_int_equal(bones.count, 2);
	tuner_bones_name(&bones, name, sizeof(name));
	assert_string_equal(name, "shoulder.L +1");
	do {
		tuner_bones_step(&bones, 1);
		count++;
		assert_true(bones.chosen < 0 || bones.moves[bones.chosen]);
		assert_true(bones.chosen < 0 || bones.level[bones.chosen] == 0);
	} while (bones.chosen >= 0);
	assert_true(count > 20);
	assert_true(count <= found.actor.model->node_count + 1);
	assert_int_equal(bones.count, 2);
	tuner_bones_step(&bones, -1);
	assert_int_equal(bones.count, 1);
	assert_true(bones.chosen >= 0);
	release(&found);
}

/* The arm of a robot without a character file. */
static void test_the_tuner_begins_with_the_longest_limb(void **state)
{
	struct tuner_bones bones;
	struct found found;
	char name[64];

	(void)state;
	find(&found, "assets/arm.glb", NULL, "none");
	assert_int_equal(
		tuner_bones_init(&bones, found.actor.instance, &found.motions),
		0);
	tuner_bones_name(&bones, name, sizeof(name));
	assert_string_equal(name, "Arm");
	assert_true(bones.deepest >= 2);
	release(&found);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_figure_faces_where_its_feet_take_it),
		cmocka_unit_test(test_the_walkers_feet_tell_its_speeds),
		cmocka_unit_test(
			test_a_named_walk_is_the_run_where_none_is_named),
		cmocka_unit_test(test_the_instance_stays_in_the_rest_pose),
		cmocka_unit_test(test_bounds_leave_the_drift_out),
		cmocka_unit_test(test_the_character_file_tells_speeds_and_bones),
		cmocka_unit_test(test_a_clip_that_is_asked_for_has_all_roles),
		cmocka_unit_test(
			test_a_clip_of_one_moment_gives_way_to_one_that_moves),
		cmocka_unit_test(test_a_model_without_clips_stands),
		cmocka_unit_test(test_a_broken_character_file_is_an_error),
		cmocka_unit_test(test_the_tuner_chooses_any_bone),
		cmocka_unit_test(test_the_tuner_begins_with_the_longest_limb),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
