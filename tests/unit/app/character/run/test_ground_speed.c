/* How fast the ground goes, from clips, from a speed or from feet on it. */
#include "app/character/run/ground.h"
#include "tests/unit/app/character/run/footing.h"

enum {
	LEFT = 0, /* any nodes of the first pair's feet, also the first one */
	RIGHT = PLACES + ANKLE
};

static const float near_m = 0.02f;

/* Without feet that are held. */
static void begin(struct footing *f)
{
	footing_begin(f);
	f->character.feet = NULL;
	f->character.motion.foot[0] = f->character.motion.foot[1] = -1;
	f->character.step_s = 0.5f;
}

/* Two clips of 2 s that play by a quarter and by the rest. */
static void blend(struct footing *f, struct model_clip *clip, const float *rate)
{
	static const float speed[2][2] = {{1, -2}, {-3, 4}};
	struct character_state *state = &f->state[1];

	begin(f);
	*clip = (struct model_clip){.duration_s = 2};
	state->rate = rate;
	state->entry_count = 2;
	f->entry[0].weight = 0.25f;
	f->entry[1].weight = 0.75f;
	for (int i = 0; i < 2; i++) {
		f->clip[i].clip = clip;
		memcpy(f->clip[i].ground_m_per_s, speed[i], sizeof(speed[i]));
	}
	/* One that is not the state's. */
	f->entry[2] = f->entry[1];
}

/* As fast as the clips play: slower in the step in which one ends or turns. */
static void test_the_ground_goes_as_the_clips_do_in_the_mean(void **state)
{
	static const struct {
		enum clip_repeat repeat;
		float rate, step_s;
		double before_s, time_s;
		float share;
	} rows[] = {
		{CLIP_LOOP, 1, 0.5f, 1.75, 2.25, 1},
		{CLIP_LOOP, -2, 0.5f, 0, 0, -2},
		{CLIP_ONCE, 1, 0.5f, 1.75, 2.25, 0.5f},
		{CLIP_ONCE, 1, 0.5f, 2, 2, 0},
		{CLIP_ONCE, 4, 0.25f, 0.5, 1.5, 4},
		{CLIP_ONCE, -1, 0.5f, 1, 0.5, -1},
		{CLIP_ONCE, 3, 0, 1, 1, 3},
		{CLIP_PING_PONG, 1, 0.5f, 0.5, 1, 1},
		{CLIP_PING_PONG, 1, 0.5f, 1.75, 2.25, 0},
		{CLIP_PING_PONG, 1, 0.5f, 2.25, 2.75, -1},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		const float share = rows[i].share;
		const float wanted[2] = {-2 * share, 2.5f * share};
		struct model_clip clip;
		struct footing f;

		blend(&f, &clip, &rows[i].rate);
		f.character.motion.velocity[0] = 9;
		f.character.motion.velocity[1] = 9;
		f.state[1].repeat = rows[i].repeat;
		f.character.step_s = rows[i].step_s;
		for (int k = 0; k < 2; k++) {
			f.entry[k].before_s = rows[i].before_s;
			f.entry[k].time_s = rows[i].time_s;
		}
		character_ground_update(&f.character);
		assert_all_near(f.character.motion.velocity, wanted, 2, 1e-6);
		for (int axis = 0; axis < 2; axis++) {
			assert_near(f.character.motion.scroll[axis],
				wanted[axis] * rows[i].step_s, 1e-6);
		}
	}
}

static void test_a_speed_is_along_z(void **state)
{
	static const float speed = 1.5f, rate = 1;
	struct model_clip clip;
	struct footing f;

	(void)state;
	blend(&f, &clip, &rate);
	f.character.motion.speed = &speed;
	f.character.motion.velocity[0] = 9;
	character_ground_update(&f.character);
	assert_all_near(f.character.motion.velocity, ((float[]){0, 1.5f}), 2, 0);
	assert_all_near(f.character.motion.scroll, ((float[]){0, 0.75f}), 2, 0);
}

/* Whose lowest heights are 0.1 and 0.3 m. */
static void begin_feet(struct footing *f)
{
	struct character_motion *motion = &f->character.motion;

	begin(f);
	motion->foot[0] = LEFT;
	motion->foot[1] = RIGHT;
	motion->low_m[0] = 0.1f;
	motion->low_m[1] = 0.3f;
	motion->near_m = near_m;
}

static void raise(struct footing *f, int node, float y)
{
	f->world[node][3][1] = y;
}

static void test_the_lower_foot_is_planted_if_it_is_near_the_ground(void **state)
{
	static const struct {
		float height_m[2];
		int planted;
	} rows[] = {
		{{0.005f, 0.01f}, 0},
		{{0.01f, 0.005f}, 1},
		{{0.01f, 0.0101f}, 0},
		{{0.0199f, 1}, 0},
		{{0.0201f, 1}, -1},
		{{1, 0.0199f}, 1},
		{{1, 0.0201f}, -1},
		{{-0.1f, 0}, 0},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct footing f;

		begin_feet(&f);
		raise(&f, LEFT, 0.1f + rows[i].height_m[0]);
		raise(&f, RIGHT, 0.3f + rows[i].height_m[1]);
		character_ground_update(&f.character);
		assert_int_equal(f.character.motion.planted, rows[i].planted);
	}
	/* At exactly the same height the first one is. */
	for (int i = 0; i < 2; i++) {
		struct footing f;

		begin_feet(&f);
		f.character.motion.low_m[0] = f.character.motion.low_m[1] = 0;
		raise(&f, LEFT, i ? near_m : 0.01f);
		raise(&f, RIGHT, i ? near_m : 0.01f);
		character_ground_update(&f.character);
		assert_int_equal(f.character.motion.planted, i ? -1 : 0);
	}
}

/* Puts a foot on the ground, and lifts the other one. */
static void plant(struct footing *f, int foot)
{
	raise(f, LEFT, foot == 0 ? 0.1f : 1);
	raise(f, RIGHT, foot == 1 ? 0.3f : 1);
}

static void test_the_ground_goes_with_the_planted_foot(void **state)
{
	(void)state;
	for (int foot = 0; foot < 2; foot++) {
		int node = foot ? RIGHT : LEFT;
		struct footing f;
		struct character_motion *motion = &f.character.motion;

		begin_feet(&f);
		plant(&f, foot);
		character_ground_update(&f.character);
		assert_all_near(motion->velocity, ((float[2]){0}), 2, 0);
		f.world[node][3][0] += 0.25f;
		f.world[node][3][2] -= 0.75f;
		character_ground_update(&f.character);
		assert_all_near(
			motion->velocity, ((float[]){-0.5f, 1.5f}), 2, 1e-6);
		assert_all_near(
			motion->scroll, ((float[]){-0.25f, 0.75f}), 2, 1e-6);
		/* In a pause it stands, and goes on as fast. */
		f.character.step_s = 0;
		f.world[node][3][0] += 1;
		character_ground_update(&f.character);
		assert_all_near(
			motion->velocity, ((float[]){-0.5f, 1.5f}), 2, 1e-6);
		assert_all_near(motion->scroll, ((float[2]){0}), 2, 0);
		/* So it does while no foot is on the ground. */
		f.character.step_s = 0.5f;
		plant(&f, -1);
		f.world[node][3][0] += 1;
		character_ground_update(&f.character);
		assert_all_near(
			motion->velocity, ((float[]){-0.5f, 1.5f}), 2, 1e-6);
		/* Then it goes on from where the foot was. */
		plant(&f, foot);
		f.world[node][3][0] += 0.5f;
		character_ground_update(&f.character);
		assert_all_near(motion->velocity, ((float[]){-1, 0}), 2, 1e-6);
	}
}

/* Less than near_m a second is no way. */
static void test_the_ground_rests_below_feet_that_sway(void **state)
{
	static const struct {
		float velocity[2];
		bool stands;
	} rows[] = {{{0.0199f, 0}, true}, {{0.0201f, 0}, false},
		{{0, -0.0199f}, true}, {{0, -0.0201f}, false},
		{{0.0118f, 0.016f}, true}, {{0.0122f, 0.016f}, false},
		{{0.02f, 0}, false}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct footing f;
		struct character_motion *motion = &f.character.motion;

		begin_feet(&f);
		plant(&f, -1);
		memcpy(motion->velocity, rows[i].velocity,
			sizeof(motion->velocity));
		character_ground_update(&f.character);
		for (int axis = 0; axis < 2; axis++) {
			assert_near(motion->scroll[axis],
				rows[i].stands ? 0
					       : 0.5f * rows[i].velocity[axis],
				1e-7);
		}
	}
}

/* As far as they are on at all; else the planted foot tells. */
static void test_feet_that_are_held_tell_how_the_ground_goes(void **state)
{
	(void)state;
	for (int on = 0; on < 2; on++) {
		struct footing f;
		struct character_motion *motion = &f.character.motion;

		footing_begin(&f);
		motion->foot[0] = LEFT;
		motion->foot[1] = RIGHT;
		motion->near_m = 1;
		motion->planted = 77;
		f.feet[0].is.now = on ? 0.25f : 0;
		f.feet[1].is.now = 0;
		for (int i = 0; i < 2; i++) {
			character_ground_update(&f.character);
			f.character.step_s = 0.5f;
			if (i == 0) {
				for (int k = 0; k < PAIRS * 2; k++) {
					move_foot(&f, k / 2, k % 2, 0.5f, 0, 1);
				}
			}
		}
		assert_all_near(motion->velocity, ((float[]){-1, -2}), 2, 1e-5);
		assert_int_equal(motion->planted, on ? 77 : 0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_the_ground_goes_as_the_clips_do_in_the_mean),
		cmocka_unit_test(test_a_speed_is_along_z),
		cmocka_unit_test(
			test_the_lower_foot_is_planted_if_it_is_near_the_ground),
		cmocka_unit_test(test_the_ground_goes_with_the_planted_foot),
		cmocka_unit_test(test_the_ground_rests_below_feet_that_sway),
		cmocka_unit_test(
			test_feet_that_are_held_tell_how_the_ground_goes),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
