/* The walker's procedural effects, as assets/walker.character has them. */
#include "app/anim/clip.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/character/run/effects.h"
#include "app/character/run/feet.h"
#include "app/character/run/parameters.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

static const double rate_hz = 30.0;

static void begin(struct acting *acting)
{
	acting_begin(acting, "assets/walker.glb");
	acting_load(acting, "assets/walker.character");
	assert_int_equal(acting->error, 0);
	/* The walker wears nothing and does nothing but what a test asks for. */
	for (int i = 0; i < acting->character->switch_count; i++) {
		acting->character->switches[i]->is_on = false;
		acting->character->switches[i]->level = 0.0f;
	}
}

static void set_on(struct acting *acting, const char *name, bool on)
{
	for (int i = 0; i < acting->character->switch_count; i++) {
		struct character_switch *is = acting->character->switches[i];

		if (strcmp(is->name, name) == 0) {
			is->is_on = on;
			return;
		}
	}
	fail_msg("there is no %s", name);
}

static void set_parameter(struct acting *acting, const char *name, float value)
{
	for (int i = 0; i < acting->character->parameter_count; i++) {
		struct character_parameter *one =
			&acting->character->parameter[i];

		if (strcmp(one->name, name) == 0) {
			character_parameter_set(one, value);
			one->value = one->goal;
			one->elapsed_s = one->ease_s;
			return;
		}
	}
	fail_msg("there is no parameter %s", name);
}

static void go_on(struct acting *acting, int frames)
{
	acting_run_to(acting, acting->now_s + (frames - 0.5) / rate_hz, rate_hz);
}

static const float *ball_of(const struct acting *acting)
{
	return acting->character->target[0].point;
}

static float distance(const struct acting *acting, const char *node)
{
	float place[3], away[3];

	acting_place(acting, node, place);
	vec_subtract(place, ball_of(acting), away);
	return vec_length(away);
}

static void test_without_features_the_clip_is_left_alone(void **state)
{
	struct acting acting;
	struct pose plain;
	struct clip_cursor cursor = {0};
	const struct character_entry *walk;

	(void)state;
	begin(&acting);
	set_parameter(&acting, "speed", 1.03f);
	go_on(&acting, 20);
	walk = &acting.character->machine.state[0].entry[1];
	assert_near(walk->weight, 1.0, 0.0);
	assert_int_equal(
		pose_init(&plain, acting.model, &acting.instance->arena), 0);
	clip_sample(walk->of->clip, walk->shown_s, &cursor, &plain);
	for (int i = 0; i < plain.node_count; i++) {
		assert_all_near(acting.instance->pose.local[i].rotation,
			plain.local[i].rotation, 4, 2e-5);
	}
	acting_end(&acting);
}

/* Hills that move with the ground under the walker. */
static float hills(void *user, float x, float z)
{
	const struct acting *acting = user;

	return 0.1f * sinf(2.0f * x) +
		0.1f * cosf(3.0f * (z - 1.03f * (float)acting->now_s));
}

static void test_feet_keep_their_height_above_uneven_ground(void **state)
{
	struct acting flat, uneven;

	(void)state;
	begin(&flat);
	begin(&uneven);
	for (int i = 0; i < 2; i++) {
		struct acting *acting = i ? &uneven : &flat;

		set_on(acting, "steps", true);
		acting->character->feet->is.level = 1.0f;
		set_parameter(acting, "speed", 1.03f);
	}
	uneven.character->ground_height = hills;
	uneven.character->ground_user = &uneven;
	go_on(&flat, 30);
	go_on(&uneven, 30);
	for (int frame = 0; frame < 60; frame++) {
		go_on(&flat, 1);
		go_on(&uneven, 1);
		for (int side = 0; side < 2; side++) {
			const char *foot = side ? "foot.R" : "foot.L";
			float at[3], level[3], ground;

			acting_place(&uneven, foot, at);
			acting_place(&flat, foot, level);
			ground = hills(&uneven, level[0], level[2]);
			assert_near(at[1] - ground, level[1], 0.004);
			assert_near(at[0], level[0], 0.004);
			assert_near(at[2], level[2], 0.004);
		}
	}
	acting_end(&uneven);
	acting_end(&flat);
}

static void reach_for_the_ball(struct acting *acting)
{
	set_on(acting, "reach", true);
	set_on(acting, "fingers", true);
	set_on(acting, "thumb", true);
	go_on(acting, 30);
}

static void test_the_hand_goes_to_a_ball_in_reach(void **state)
{
	struct acting acting;
	int reached = 0;

	(void)state;
	begin(&acting);
	reach_for_the_ball(&acting);
	for (int frame = 0; frame < 200; frame++) {
		float gap, reach;

		go_on(&acting, 1);
		gap = distance(&acting, "hand.R");
		reach = distance(&acting, "upper_arm.R");
		assert_true(isfinite(gap));
		/*
		 * Upper arm and forearm are 0.262 + 0.232 m long; a ball in the
		 * palm is 0.06 m farther along the hand and 0.07 m beside it.
		 */
		if (reach < 0.55f) {
			assert_true(gap < 0.0935f);
			reached++;
		}
		if (reach < 0.58f) {
			assert_true(gap < 0.0935f + 0.04f);
		}
	}
	assert_true(reached > 50);
	acting_end(&acting);
}

/* The least distance of the skin from the ball's middle, and how many vertices
   are within 2 cm of its surface. */
static float skin_distance(const struct acting *acting, int *near)
{
	const struct instance *instance = acting->instance;
	const float *ball = ball_of(acting);
	float least = 9.0f;

	*near = 0;
	for (int d = 0; d < instance->drawable_count; d++) {
		const struct drawable *drawable = &instance->drawable[d];

		for (int v = 0; v < drawable->primitive->vertex_count; v++) {
			float at[3], away;

			instance_world_vertex(instance, drawable, v, at);
			away = hypotf(hypotf(at[0] - ball[0], at[1] - ball[1]),
				at[2] - ball[2]);
			least = fminf(least, away);
			*near += away < 0.07f;
		}
	}
	return least;
}

static void test_the_fingers_close_around_the_ball(void **state)
{
	struct acting acting;
	int grasped = 0;

	(void)state;
	begin(&acting);
	set_parameter(&acting, "speed", 1.03f);
	reach_for_the_ball(&acting);
	for (int frame = 0; frame < 120; frame++) {
		int near;

		go_on(&acting, 1);
		instance_update(acting.instance);
		if (distance(&acting, "hand.R") < 0.0935f) {
			/* The ball's radius is 5 cm: nothing pierces it. */
			assert_true(skin_distance(&acting, &near) > 0.048f);
			assert_true(near > 20);
			grasped++;
		}
	}
	assert_true(grasped > 60);
	acting_end(&acting);
}

static void test_the_head_turns_towards_the_ball(void **state)
{
	struct acting acting;
	int head;

	(void)state;
	begin(&acting);
	head = model_find_node(acting.model, "head");
	set_on(&acting, "look at", true);
	go_on(&acting, 60);
	for (int frame = 0; frame < 100; frame++) {
		const vec4 *world;
		float to[3], length, cosine;

		go_on(&acting, 1);
		world = (const vec4 *)acting.instance->world[head];
		vec_subtract(ball_of(&acting), world[3], to);
		length = vec_length(to);
		cosine = (world[2][0] * to[0] + world[2][1] * to[1] +
				 world[2][2] * to[2]) /
			length;
		/* The head lags by at most a quarter of a right angle. */
		assert_true(cosine > 0.92f);
	}
	acting_end(&acting);
}

/* How far a bone has turned from rest, radians. */
static float turn_of(const struct acting *acting, const char *name)
{
	const struct pose *pose = &acting->instance->pose;
	int node = model_find_node(acting->model, name);
	float back[4], turn[4];

	quat_conjugate(acting->model->node[node].rest.rotation, back);
	quat_multiply(back, pose->local[node].rotation, turn);
	return quat_angle(turn);
}

/* What has the larger rate leads. */
static void test_a_bone_with_a_larger_rate_looks_first(void **state)
{
	struct acting acting;
	float early[2], late[2];

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[state stand]\nclip = rest\n"
		"[target ball]\nplace = 1 1.5 1\n"
		"[look watch]\nbone = neck 0.5 2\nbone = head 1 20\n"
		"target = ball\nfade = 0\n");
	acting_run_to(&acting, 0.15, rate_hz);
	early[0] = turn_of(&acting, "neck");
	early[1] = turn_of(&acting, "head");
	acting_run_to(&acting, 4.0, rate_hz);
	late[0] = turn_of(&acting, "neck");
	late[1] = turn_of(&acting, "head");
	assert_true(late[0] > 0.2f);
	assert_true(early[0] < 0.4f * late[0]);
	/* While the neck follows, the head gives back what it was ahead. */
	assert_true(early[1] > late[1]);
	acting_end(&acting);
}

/*
 * An iris moves on a sphere of 44 mm, so that a degree of its bone stands for
 * 1 / 0.3 degrees of a real eye.
 */
static float gaze_of(const struct acting *acting, const char *eye)
{
	return turn_of(acting, eye) / 0.3f;
}

static void test_the_eyes_turn_earlier_and_further_than_the_head(void **state)
{
	static const char *const eyes[] = {"eye.L", "eye.R"};
	struct acting acting;
	float head, most = 0;

	(void)state;
	begin(&acting);
	/* The ball is far aside. */
	go_on(&acting, 150);
	set_on(&acting, "look at", true);
	set_on(&acting, "eyes", true);
	go_on(&acting, 3);
	head = turn_of(&acting, "head") + turn_of(&acting, "neck");
	assert_true(head < 0.2f);
	for (int i = 0; i < 2; i++) {
		assert_true(gaze_of(&acting, eyes[i]) > 2 * head);
	}
	go_on(&acting, 3);
	most = gaze_of(&acting, "eye.L");
	/* While the head follows, the eyes give back what they were ahead. */
	go_on(&acting, 24);
	head = turn_of(&acting, "head") + turn_of(&acting, "neck");
	assert_true(head > 0.2f);
	assert_true(gaze_of(&acting, "eye.L") < 0.7f * most);
	acting_end(&acting);
}

static void test_the_cape_stays_on_and_moves(void **state)
{
	struct acting acting;
	float lowest = 9.0f, highest = -9.0f;

	(void)state;
	begin(&acting);
	set_parameter(&acting, "speed", 1.03f);
	set_on(&acting, "cape", true);
	for (int frame = 0; frame < 150; frame++) {
		const struct cloth *cloth = &acting.character->cape[0].cloth;
		float z;

		go_on(&acting, 1);
		z = cloth->position[cloth->count - 5][2];
		lowest = z < lowest ? z : lowest;
		highest = z > highest ? z : highest;
		for (int i = 0; i < cloth->count; i++) {
			const float *at = cloth->position[i];

			assert_true(fabsf(at[0]) < 1.0f);
			assert_true(at[1] > 0.3f && at[1] < 1.7f);
			assert_true(fabsf(at[2]) < 1.1f);
		}
	}
	assert_true(highest - lowest > 0.01f);
	acting_end(&acting);
}

static void test_the_floor_stands_while_the_walker_does(void **state)
{
	struct acting acting;

	(void)state;
	for (int steps = 0; steps <= 1; steps++) {
		begin(&acting);
		set_on(&acting, "steps", steps);
		go_on(&acting, 2);
		for (int frame = 0; frame < 120; frame++) {
			go_on(&acting, 1);
			assert_true(acting.character->motion.scroll[0] == 0 &&
				acting.character->motion.scroll[1] == 0);
		}
		set_parameter(&acting, "speed", 1.03f);
		go_on(&acting, 30);
		assert_true(acting.character->motion.scroll[1] > 0.02f);
		acting_end(&acting);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_without_features_the_clip_is_left_alone),
		cmocka_unit_test(test_feet_keep_their_height_above_uneven_ground),
		cmocka_unit_test(test_the_hand_goes_to_a_ball_in_reach),
		cmocka_unit_test(test_the_fingers_close_around_the_ball),
		cmocka_unit_test(test_the_head_turns_towards_the_ball),
		cmocka_unit_test(test_a_bone_with_a_larger_rate_looks_first),
		cmocka_unit_test(
			test_the_eyes_turn_earlier_and_further_than_the_head),
		cmocka_unit_test(test_the_cape_stays_on_and_moves),
		cmocka_unit_test(test_the_floor_stands_while_the_walker_does),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
