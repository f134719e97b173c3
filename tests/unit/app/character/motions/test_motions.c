/* What limber finds out about any model: its clips, its speeds, its bones. */
#include "app/character/motions/motions.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct found {
	struct log log;
	struct model *model;
	struct instance *instance;
	struct motions motions;
};

static void load(struct found *found, const char *path)
{
	memset(found, 0, sizeof(*found));
	found->log = log_to_stderr(LOG_WARNING);
	assert_int_equal(model_load(path, &found->log, &found->model), 0);
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

	assert_int_equal(instance_create(found->model, kernel_find("fixed"),
				 &found->log, &found->instance),
		0);
	assert_int_equal(motions_find(&request, found->instance, &found->log,
				 &found->motions),
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
	instance_destroy(found->instance);
	model_destroy(found->model);
}

/* Finds the motions of the walker as a character file says. */
static void find_as(struct found *found, const char *text)
{
	struct test_path folder = temp_dir_make();
	struct test_path file = path_join(&folder, "a.character");

	file_write(file.text, text, strlen(text));
	find(found, "assets/walker.glb", NULL, file.text);
	temp_dir_remove(&folder);
}

static const char *clip_of(const struct found *found, enum motion_role role)
{
	int clip = found->motions.role[role].clip;

	return clip < 0 ? "" : found->model->clip[clip].name;
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

/* A walker that is turned to its left goes there. */
static void test_a_figure_faces_where_its_feet_take_it(void **state)
{
	static const float turned[4] = {0.0f, 0.70710678f, 0.0f, 0.70710678f};
	struct found found;

	(void)state;
	load(&found, "assets/walker.glb");
	for (int i = 0; i < found.model->node_count; i++) {
		struct model_node *node = &found.model->node[i];

		if (node->parent < 0) {
			memcpy(node->rest.rotation, turned, sizeof(turned));
		}
	}
	find_in(&found, "assets/walker.glb", NULL, "none");
	assert_near(found.motions.role[MOTION_WALK].facing_rad, acos(0), 1e-3);
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
		model = found.model;
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
	for (int i = 0; i < found.model->node_count; i++) {
		assert_memory_equal(&found.instance->pose.local[i],
			&found.model->node[i].rest, sizeof(struct transform));
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
	whole = bounds_of_clip(found.instance, motion.clip);
	motion.drift[0] = 0.5f;
	motion.drift[1] = -0.25f;
	placed = motion_bounds(found.instance, &motion);
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
	assert_string_equal(
		found.model->node[found.motions.bone[0]].name, "shoulder.L");
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
	model = found.model;
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
	found.model->clip[0].duration_s = 0.0f;
	found.model->clip[0].channel_count = 0;
	found.model->clip_count = 1;
	find_in(&found, "assets/walker.glb", NULL, "none");
	assert_int_equal(found.motions.role[MOTION_STAND].clip, 0);
	release(&found);
}

static void rename_clips(struct model *model, const char *const names[5])
{
	for (int i = 0; i < 5; i++) {
		model->clip[i].name = names[i];
	}
}

/* Such as a fall, whose feet move; if there is no other clip, it is taken. */
static void test_a_clip_that_cannot_be_repeated_is_the_last_choice(void **state)
{
	static const char *const plain[5] = {"a", "b", "c", "d", "e"};
	static const float lying[4] = {-0.70710678f, 0, 0, 0.70710678f};
	static const float time_s[2] = {0, 3};
	static float rotation[8] = {0, 0, 0, 1};
	struct found found;
	struct model_channel fall = {.path = MODEL_ROTATION,
		.interpolation = MODEL_LINEAR,
		.key_count = 2,
		.width = 4,
		.time_s = time_s,
		.value = rotation};

	(void)state;
	memcpy(rotation + 4, lying, sizeof(lying));
	for (int count = 5; count > 0; count -= 4) {
		load(&found, "assets/walker.glb");
		rename_clips(found.model, plain);
		fall.node = model_find_node(found.model, "hips");
		found.model->clip[0].duration_s = 3;
		found.model->clip[0].channel = &fall;
		found.model->clip[0].channel_count = 1;
		found.model->clip_count = count;
		find_in(&found, "assets/walker.glb", NULL, "none");
		for (int i = 0; i < MOTION_ROLES; i++) {
			assert_int_equal(
				found.motions.role[i].clip == 0, count == 1);
		}
		release(&found);
	}
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
	assert_true(motions_find(&request, found.instance, &found.log,
			    &found.motions) < 0);
	release(&found);
}

/* The names of the walker's clips become others, whatever they are. */
/* The clips are idle, jump, run, walk and wave. */
static void test_names_may_hold_any_word_of_a_role(void **state)
{
	static const struct {
		const char *name[5];
		int role[MOTION_ROLES]; /* stand, walk, run */
	} rows[] = {
		{{"a", "b", "My-GALLOP.1", "Sleepwalking", "Idle_2"}, {4, 3, 2}},
		{{"Trot", "c", "d", "xwalk", "outSTANDing"}, {4, 3, 0}},
		{{"wal", "runs", "trot", "walker", "idling stand"}, {4, 3, 1}},
		/* A whole name comes first, and a role's first word. */
		{{"stand", "walks", "rerun", "walk", "the idle one"}, {4, 3, 2}},
		{{"my idle", "idle", "gallop", "walk", "stand"}, {1, 3, 2}},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct found found;

		load(&found, "assets/walker.glb");
		rename_clips(found.model, rows[i].name);
		find_in(&found, "assets/walker.glb", NULL, "none");
		for (int role = 0; role < MOTION_ROLES; role++) {
			assert_int_equal(found.motions.role[role].clip,
				rows[i].role[role]);
		}
		release(&found);
	}
}

/* Without names: the slowest and the fastest, and one that stays. */
static void test_speeds_tell_what_clips_without_names_are(void **state)
{
	static const char *const plain[5] = {"a", "b", "c", "d", "e"};
	struct found found;

	(void)state;
	for (int place = 0; place < 5; place++) {
		struct model_clip run;

		load(&found, "assets/walker.glb");
		rename_clips(found.model, plain);
		run = found.model->clip[2];
		found.model->clip[2] = found.model->clip[place];
		found.model->clip[place] = run;
		find_in(&found, "assets/walker.glb", NULL, "none");
		assert_string_equal(
			clip_of(&found, MOTION_STAND), place == 0 ? "b" : "a");
		assert_string_equal(clip_of(&found, MOTION_WALK), "d");
		assert_string_equal(clip_of(&found, MOTION_RUN), "c");
		release(&found);
	}
}

static void test_the_files_speed_counts_if_the_feet_are_nearly_as_fast(
	void **state)
{
	static const struct {
		float factor;
		bool counts;
	} rows[] = {{0.6f, false}, {0.72f, true}, {1.4f, true}, {1.6f, false}};
	struct found found;
	float measured;

	(void)state;
	find(&found, "assets/walker.glb", NULL, "none");
	measured = found.motions.role[MOTION_WALK].speed;
	release(&found);
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		float said = rows[i].factor * measured;
		char text[200];

		snprintf(text, sizeof(text),
			"[parameter v]\nrange = 0 9\n[state s]\n"
			"blend = v, idle 0, walk %g\n",
			(double)said);
		find_as(&found, text);
		assert_near(found.motions.role[MOTION_WALK].speed,
			rows[i].counts ? said : measured, 1e-5);
		release(&found);
	}
}

/* The first clip above a speed of 0 walks, and the last one runs. */
static void test_a_blend_over_speed_tells_the_roles_of_its_clips(void **state)
{
	static const char text[] = "[parameter v]\nrange = 0 9\n[state s]\n"
				   "blend = v, wave 0, idle 1, jump 2, walk 3\n";
	struct found found;

	(void)state;
	find_as(&found, text);
	assert_string_equal(clip_of(&found, MOTION_STAND), "wave");
	assert_string_equal(clip_of(&found, MOTION_WALK), "idle");
	assert_string_equal(clip_of(&found, MOTION_RUN), "walk");
	release(&found);
}

/* Of a file in which the first blend over a speed is not the first state. */
static void test_the_first_blend_tells_and_four_shakes(void **state)
{
	static const char text[] =
		"[parameter v]\nrange = 0 9\n[state x]\nclip = jump\n"
		"[state s]\nblend = v, rest 0, run 1, wave 2\n"
		"[state t]\nblend = v, jump 0, wave 1, idle 2\n"
		"[shake a]\nbone = head\n[shake b]\nbone = hips\n"
		"[shake c]\nbone = hand.L\n[shake d]\nbone = foot.R\n"
		"[shake e]\nbone = hand.R\n";
	static const char *const bones[MOTION_BONES_MAX] = {
		"head", "hips", "hand.L", "foot.R"};
	struct found found;

	(void)state;
	find_as(&found, text);
	/* The rest pose is no clip, so a name tells. */
	assert_string_equal(clip_of(&found, MOTION_STAND), "idle");
	assert_string_equal(clip_of(&found, MOTION_WALK), "run");
	assert_string_equal(clip_of(&found, MOTION_RUN), "wave");
	assert_int_equal(found.motions.bone_count, MOTION_BONES_MAX);
	for (int i = 0; i < MOTION_BONES_MAX; i++) {
		assert_string_equal(
			found.model->node[found.motions.bone[i]].name, bones[i]);
	}
	release(&found);
}

/* The way that a clip has gone by then. */
static void test_a_clip_drifts_evenly(void **state)
{
	struct found found;
	struct motion motion;
	float way[3]; /* x, y, z */
	int clip;

	(void)state;
	load(&found, "tests/fixtures/gltf/clip/far.gltf");
	assert_int_equal(instance_create(found.model, kernel_find("float"),
				 &found.log, &found.instance),
		0);
	clip = model_find_clip(found.model, "leave");
	motion = motion_of_clip(found.instance, clip);
	assert_int_equal(motion.clip, clip);
	assert_near(motion.drift[0], 40 * found.instance->unit_scale, 1e-3);
	assert_near(motion.drift[1], -20 * found.instance->unit_scale, 1e-3);
	motion_drift_at(&motion, found.model, 0.5f, way);
	assert_near(way[0], 0.25 * motion.drift[0], 1e-4);
	assert_near(way[2], 0.25 * motion.drift[1], 1e-4);
	motion.clip = -1;
	motion_drift_at(&motion, found.model, 0.5f, way);
	for (int i = 0; i < 3; i++) {
		assert_near(way[i], 0, 0);
	}
	release(&found);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_blend_over_speed_tells_the_roles_of_its_clips),
		cmocka_unit_test(test_the_first_blend_tells_and_four_shakes),
		cmocka_unit_test(test_a_clip_drifts_evenly),
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
		cmocka_unit_test(
			test_a_clip_that_cannot_be_repeated_is_the_last_choice),
		cmocka_unit_test(test_a_model_without_clips_stands),
		cmocka_unit_test(test_a_broken_character_file_is_an_error),
		cmocka_unit_test(test_names_may_hold_any_word_of_a_role),
		cmocka_unit_test(test_speeds_tell_what_clips_without_names_are),
		cmocka_unit_test(
			test_the_files_speed_counts_if_the_feet_are_nearly_as_fast),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
