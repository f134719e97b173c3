/* What effects do to bones, and by how much. */
#include "app/anim/math/vec.h"
#include "app/character/run/effects.h"
#include "platform/base/compiler.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double rate_hz = 50.0;

static void begin(struct acting *acting, const char *text)
{
	acting_begin(acting, "assets/walker.glb");
	acting_expect(acting, text);
	acting_run_to(acting, 0.1, rate_hz);
}

/* The operation of an effect of this kind. */
static void *find_effect(const struct acting *acting,
	void (*run)(struct character *character, void *what))
{
	const struct character *character = acting->character;

	for (int i = 0; i < character->op_count; i++) {
		if (character->op[i].run == run) {
			return character->op[i].what;
		}
	}
	fail_msg("there is no such effect");
	return NULL;
}

/* By how many degrees a bone is turned from the rest pose. */
static double turned_deg(const struct acting *acting, const char *bone)
{
	int node = model_find_node(acting->model, bone);
	const float *now = acting->instance->pose.local[node].rotation;
	const float *rest = acting->model->node[node].rest.rotation;
	double dot = 0.0;

	for (int i = 0; i < 4; i++) {
		dot += (double)now[i] * rest[i];
	}
	return 2.0 * acos(fmin(1.0, fabs(dot))) * 180.0 / 3.14159265358979;
}

#define TURN                                                              \
	"[state a]\nclip = rest\n[turn lift]\nbone = forearm.L, hand.L\n" \
	"axis = 0 0 1\nangle = 40\n"

/* At half its weight by half the angle, from the clip or from the rest pose. */
static void test_bones_turn_by_a_part_of_the_angle(void **state)
{
	static const char *const texts[] = {
		TURN "weight = 0.5\n", TURN "weight = 0.5\nfrom = rest\n"};
	struct acting acting;

	(void)state;
	for (int i = 0; i < 2; i++) {
		begin(&acting, texts[i]);
		assert_near(turned_deg(&acting, "forearm.L"), 20, 0.01);
		assert_near(turned_deg(&acting, "hand.L"), 20, 0.01);
		acting_end(&acting);
	}
	begin(&acting, TURN "on = no\n");
	assert_near(turned_deg(&acting, "hand.L"), 0, 0.05);
	acting_end(&acting);
}

/* To what the action does not say, whatever it was before. */
static void test_what_a_held_button_switches_goes_back(void **state)
{
	static const struct {
		const char *text;
		bool before, held, after;
	} rows[] = {
		{"on = no\n[buttons]\nUP hold = on lift\n", false, true, false},
		{"on = yes\n[buttons]\nUP hold = off lift\n", true, false, true},
		{"on = yes\n[buttons]\nUP hold = on lift\n", true, true, false},
		{"on = no\n[buttons]\nUP hold = off lift\n", false, false, true}};
	struct acting acting;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		const struct character_turn *turn;
		char text[256];

		snprintf(text, sizeof(text), TURN "%s", rows[i].text);
		begin(&acting, text);
		turn = find_effect(&acting, character_turn_run);
		assert_int_equal(turn->is.is_on, rows[i].before);
		acting_press(&acting, BUTTON_UP);
		acting_run_to(&acting, 0.2, rate_hz);
		assert_int_equal(turn->is.is_on, rows[i].held);
		acting_release(&acting, BUTTON_UP);
		acting_run_to(&acting, 0.3, rate_hz);
		assert_int_equal(turn->is.is_on, rows[i].after);
		acting_end(&acting);
	}
}

static void test_a_turn_from_rest_replaces_what_the_clip_does(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting,
		"[state a]\nclip = run\n[turn lift]\nbone = forearm.L\n"
		"axis = 0 0 1\nangle = 40\nfrom = rest\n");
	for (int i = 0; i < 20; i++) {
		acting_run_to(&acting, acting.now_s + 0.02, rate_hz);
		assert_near(turned_deg(&acting, "forearm.L"), 40, 0.01);
	}
	acting_end(&acting);
}

/* A shake's fade is what is missing of its weight. */
static void test_a_shake_has_its_weight(void **state)
{
	const struct character_shake *shake;
	struct acting acting;

	(void)state;
	begin(&acting,
		"[state a]\nclip = rest\n[shake s]\nbone = head\nspeed = 5\n"
		"amplitude = 1\nrotation = 1 0 0\nweight = 0.25\n");
	shake = acting.character->shake[0];
	assert_near(shake->swing.fade, 0.75, 1e-6);
	acting_end(&acting);
}

/* A text with presets a, b and c, of which the first is used at first. */
static void test_presets_go_round_both_ways(void **state)
{
	struct procedural_preset preset[3] = {
		{.name = "a"}, {.name = "b"}, {.name = "c"}};
	static const struct {
		int detail;
		float amount;
		int chosen;
	} use[] = {{-1, 1, 1}, {-1, 1, 2}, {-1, 1, 0}, {-1, -1, 2}, {-1, -1, 1},
		{2, 0, 2}, {0, 0, 0}, {1, 0, 1}, {-1, -7, 0}};
	struct character_shake *shake;
	struct acting acting;

	(void)state;
	begin(&acting,
		"[state a]\nclip = rest\n[shake first]\nbone = neck\n"
		"[shake s]\nbone = head\n");
	shake = acting.character->shake[1];
	shake->preset = preset;
	shake->preset_count = 3;
	for (size_t i = 0; i < sizeof(use) / sizeof(use[0]); i++) {
		struct character_action action = {.verb = CHARACTER_PRESET,
			.index = 1,
			.detail = use[i].detail,
			.amount = use[i].amount};

		character_shake_use(acting.character, &action);
		assert_int_equal(shake->chosen, use[i].chosen);
		assert_string_equal(
			shake->swing.preset.name, preset[use[i].chosen].name);
	}
	acting_end(&acting);
}

/* The figure moves on the spot, so the air moves. */
static void test_springs_feel_the_wind_of_the_motion(void **state)
{
	struct character_spring *spring;
	struct acting acting;

	(void)state;
	begin(&acting,
		"[state a]\nclip = rest\n[spring s]\nbones = ponytail.4 4\n"
		"gravity = 1 -2 3\nweight = 0.5\n");
	spring = find_effect(&acting, character_spring_run);
	acting.character->motion.velocity[0] = 0.5f;
	acting.character->motion.velocity[1] = -2.0f;
	character_spring_run(acting.character, spring);
	assert_all_near(spring->spring.gravity,
		((float[]){1 - 1.5f, -2, 3 + 6}), 3, 1e-6);
	assert_near(spring->spring.weight, 0.5, 1e-6);
	acting_end(&acting);
}

static double distance(const float a[3], const float b[3])
{
	return sqrt(pow(a[0] - b[0], 2) + pow(a[1] - b[1], 2) +
		pow(a[2] - b[2], 2));
}

/* The tip stops before a target, on the way from the first bone. */
static void test_a_reach_stops_short_of_its_target(void **state)
{
	static const char *const limbs[] = {
		"limb = upper_arm.R forearm.R hand.R\n",
		"chain = hand.R 3\nlimit = 90\n"};
	static const char *const firsts[] = {"upper_arm.R", "upper_arm.R"};

	(void)state;
	for (int i = 0; i < 2; i++) {
		char text[256] = "[state a]\nclip = rest\n[target t]\n"
				 "place = -0.35 1.2 0.3\n[reach r]\n"
				 "target = t\nshort = 0.1\n";
		const float target[3] = {-0.35f, 1.2f, 0.3f};
		struct acting acting;
		float tip[3], first[3];

		strcat(text, limbs[i]);
		begin(&acting, text);
		acting_run_to(&acting, 1.0, rate_hz);
		acting_place(&acting, "hand.R", tip);
		acting_place(&acting, firsts[i], first);
		assert_near(distance(tip, target), 0.1, 0.01);
		assert_near(distance(first, tip) + 0.1, distance(first, target),
			0.01);
		acting_end(&acting);
	}
}

static void test_the_middle_joint_bends_towards_the_pole(void **state)
{
	static const float side[] = {1.0f, -1.0f};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct acting acting;
		float tip[3], elbow[3], upper[3];
		const char *const texts[] = {
			"pole = 0 5 0\n", "pole = 0 -5 0\n"};
		char text[256] = "[state a]\nclip = rest\n[target t]\n"
				 "place = -0.25 1.35 0.35\n[reach r]\n"
				 "limb = upper_arm.R forearm.R hand.R\n"
				 "target = t\n";

		strcat(text, texts[i]);
		begin(&acting, text);
		acting_place(&acting, "hand.R", tip);
		acting_place(&acting, "forearm.R", elbow);
		acting_place(&acting, "upper_arm.R", upper);
		assert_near(distance(tip, (float[]){-0.25f, 1.35f, 0.35f}), 0,
			0.005);
		assert_true((elbow[1] - 0.5f * (tip[1] + upper[1])) * side[i] >
			0.02f);
		acting_end(&acting);
	}
}

/* Also those of bones below the ones that an effect turns. */
static void test_world_matrices_follow_what_effects_do(void **state)
{
	static const char *const effects[] = {
		"[look l]\nbone = neck 0.5\nbone = head\ntarget = t\n",
		"[reach r]\nlimb = upper_arm.R forearm.R hand.R\ntarget = t\n",
		"[reach r]\nlimb = upper_arm.R forearm.R hand.R\ntarget = t\n"
		"grip = 0 0.06 0.02\nweight = 0.5\n",
		"[reach r]\nchain = hand.R 3\ntarget = t\n",
		"[spring s]\nbones = ponytail.4 4\ngravity = 3 1 0\n",
	};

	(void)state;
	for (size_t i = 0; i < sizeof(effects) / sizeof(effects[0]); i++) {
		char text[512] = "[state a]\nclip = walk\n[target t]\n"
				 "place = -0.3 1.2 0.35\n";
		struct acting acting;
		mat4 world[64];
		size_t size;

		strcat(text, effects[i]);
		begin(&acting, text);
		acting_run_to(&acting, 1.0, rate_hz);
		size = (size_t)acting.model->node_count * sizeof(mat4);
		assert_true(size <= sizeof(world));
		memcpy(world, acting.instance->world, size);
		instance_update_nodes(acting.instance);
		assert_all_near(acting.instance->world, world,
			size / sizeof(float), 1e-5);
		acting_end(&acting);
	}
}

/* A target is used while an effect is on that has it, even as that fades. */
static void test_targets_are_used_while_an_effect_is_on(void **state)
{
	static const char *const effects[] = {
		"[look l]\nbone = head\ntarget = t\non = no\n"
		"[look m]\nbone = neck\ntarget = t\non = no\n",
		"[reach l]\nchain = hand.R 3\ntarget = t\non = no\n"
		"[reach m]\nchain = hand.L 3\ntarget = t\non = no\n"};

	(void)state;
	for (int i = 0; i < 2; i++) {
		char text[512] = "[state a]\nclip = rest\n"
				 "[buttons]\nUP = toggle l\nDOWN = toggle m\n"
				 "[target t]\nplace = 0 1.5 1\n"
				 "[target free]\nplace = 0 1 2\n";
		const struct character_target *target;
		struct acting acting;

		strcat(text, effects[i]);
		begin(&acting, text);
		target = acting.character->target;
		assert_false(target[0].used);
		assert_true(target[1].used);
		acting_tap(&acting, BUTTON_UP, 0.1, rate_hz);
		assert_true(target[0].used); /* by the first one alone */
		acting_tap(&acting, BUTTON_DOWN, 0.1, rate_hz);
		assert_true(target[0].used);
		acting_tap(&acting, BUTTON_UP, 0.1, rate_hz);
		assert_true(target[0].used); /* by the second one */
		acting_tap(&acting, BUTTON_DOWN, 0.02, rate_hz);
		assert_false(target[0].used);
		acting_end(&acting);
	}
}

static double scale_of(const struct acting *acting, const char *bone, int axis)
{
	return acting->instance->pose
		.local[model_find_node(acting->model, bone)]
		.scale[axis];
}

/* By their weights; what is off leaves the bone as it is. */
static void test_breath_and_muscles_swell_bones_while_they_are_on(void **state)
{
	struct acting acting;
	double most = 0.0;

	(void)state;
	begin(&acting,
		"[state a]\nclip = rest\n[breath b]\nbone = chest\nrate = 1\n"
		"swell = 0.1 0 0.2\n[muscle m]\njoint = forearm.R\n"
		"bone = upper_arm.R\nfrom = 0\nto = 30\nswell = 0.2 0 0.4\n"
		"weight = 0.5\n[turn t]\nbone = forearm.R\naxis = 0 0 1\n"
		"angle = 60\n");
	for (int i = 0; i < 50; i++) {
		acting_run_to(&acting, acting.now_s + 0.02, rate_hz);
		most = fmax(most, scale_of(&acting, "chest", 0));
	}
	assert_near(most, 1.1, 0.01);
	assert_near(scale_of(&acting, "upper_arm.R", 0), 1.1, 1e-4);
	assert_near(scale_of(&acting, "upper_arm.R", 2), 1.2, 1e-4);
	acting_end(&acting);
	begin(&acting,
		"[state a]\nclip = rest\n[breath b]\nbone = chest\nrate = 1\n"
		"swell = 0.1 0 0.2\non = no\n");
	for (int i = 0; i < 50; i++) {
		acting_run_to(&acting, acting.now_s + 0.02, rate_hz);
		assert_near(scale_of(&acting, "chest", 0), 1.0, 1e-6);
	}
	acting_end(&acting);
}

/* With the square of the speed, along both axes. */
static void test_capes_feel_the_wind_of_the_motion(void **state)
{
	const struct character_cape *cape;
	struct acting acting;
	const float *wind;

	(void)state;
	begin(&acting,
		"[state a]\nclip = rest\n[cape c]\nbone = chest\n"
		"place = 0 1.42 -0.1\n");
	cape = acting.character->cape;
	wind = cape->cloth.settings.wind;
	acting.character->motion.velocity[0] = 3.0f;
	acting.character->motion.velocity[1] = -4.0f;
	character_cape_run(acting.character, acting.character->cape);
	assert_near(wind[0], -3 * 5 * 0.17, 1e-5);
	assert_near(wind[2], 4 * 5 * 0.17, 1e-5);
	acting.character->metre = 2.0f;
	character_cape_run(acting.character, acting.character->cape);
	assert_near(wind[0], -3 * 2.5 * 0.17, 1e-5);
	acting_end(&acting);
}

/* A cape that is put on again hangs as at first, and goes on from there. */
static void test_a_cape_hangs_anew_when_it_is_put_on(void **state)
{
	struct character_cape *cape;
	struct acting acting;
	float rest[3], *hem, way[3];

	(void)state;
	begin(&acting,
		"[state a]\nclip = rest\n[cape c]\nbone = chest\n"
		"place = 0 1.42 -0.1\n");
	cape = acting.character->cape;
	hem = cape->cloth.position[cape->cloth.count - 1];
	acting.character->step_s = 0;
	cape->worn = false;
	character_cape_run(acting.character, cape);
	assert_true(cape->worn);
	memcpy(rest, hem, sizeof(rest));
	acting.character->step_s = 0.02f;
	acting.character->motion.velocity[1] = 5;
	for (int i = 0; i < 25; i++) {
		character_cape_run(acting.character, cape);
	}
	vec_subtract(hem, rest, way);
	assert_true(vec_length(way) > 0.05f);
	/* Taken off, it stays where it was. */
	cape->is.now = 0;
	character_cape_run(acting.character, cape);
	assert_false(cape->worn);
	vec_subtract(hem, rest, way);
	assert_true(vec_length(way) > 0.05f);
	cape->is.now = 1;
	acting.character->step_s = 0;
	character_cape_run(acting.character, cape);
	assert_all_near(hem, rest, 3, 1e-4);
	acting_end(&acting);
}

static void test_a_target_may_be_the_camera_or_hang_on_a_node(void **state)
{
	const struct character_target *target;
	struct acting acting;
	float hand[3];

	(void)state;
	begin(&acting,
		"[parameter x]\nstart = 0.25\n[state a]\nclip = walk\n"
		"[target eye]\ncamera = yes\n[target place]\nplace = x 1 2\n"
		"[target hand]\nnode = hand.L\nplace = 1 2 x\n");
	target = acting.character->target;
	acting_place(&acting, "hand.L", hand);
	assert_all_near(target[0].point, ((float[]){0, 1, 4}), 3, 0);
	assert_all_near(target[1].point, ((float[]){0.25f, 1, 2}), 3, 0);
	assert_all_near(target[2].point,
		((float[]){hand[0] + 1, hand[1] + 2, hand[2] + 0.25f}), 3, 1e-6);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_what_a_held_button_switches_goes_back),
		cmocka_unit_test(test_bones_turn_by_a_part_of_the_angle),
		cmocka_unit_test(
			test_a_turn_from_rest_replaces_what_the_clip_does),
		cmocka_unit_test(test_a_shake_has_its_weight),
		cmocka_unit_test(test_presets_go_round_both_ways),
		cmocka_unit_test(test_capes_feel_the_wind_of_the_motion),
		cmocka_unit_test(test_a_cape_hangs_anew_when_it_is_put_on),
		cmocka_unit_test(
			test_a_target_may_be_the_camera_or_hang_on_a_node),
		cmocka_unit_test(test_springs_feel_the_wind_of_the_motion),
		cmocka_unit_test(test_a_reach_stops_short_of_its_target),
		cmocka_unit_test(test_the_middle_joint_bends_towards_the_pole),
		cmocka_unit_test(test_world_matrices_follow_what_effects_do),
		cmocka_unit_test(test_targets_are_used_while_an_effect_is_on),
		cmocka_unit_test(
			test_breath_and_muscles_swell_bones_while_they_are_on),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
