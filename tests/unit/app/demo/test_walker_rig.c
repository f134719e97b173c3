/*
 * The walker's procedural layers.
 */
#include "app/anim/clip.h"
#include "app/demo/walker/walker_rig.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

static const float step_s = 1.0f / 30.0f;

struct walk {
	struct model *model;
	struct instance *instance;
	struct walker_rig rig;
	struct floor floor;
	struct clip_cursor cursor;
	int clip;
	float time_s;
};

static void begin(struct walk *walk, const char *clip)
{
	struct log log = log_to_stderr(LOG_WARNING);

	memset(walk, 0, sizeof(*walk));
	assert_int_equal(model_load("assets/walker.glb", &log, &walk->model), 0);
	assert_int_equal(instance_create(walk->model, kernel_find("float"),
				 &log, &walk->instance),
		0);
	assert_int_equal(clip_cursor_init(&walk->cursor, walk->model,
				 &walk->instance->arena),
		0);
	assert_int_equal(walker_rig_init(&walk->rig, walk->instance, &log), 0);
	memset(walk->rig.on, 0, sizeof(walk->rig.on));
	walk->floor.tile = 0.5f;
	walk->clip = model_find_clip(walk->model, clip);
	assert_true(walk->clip >= 0);
}

static void end(struct walk *walk)
{
	instance_destroy(walk->instance);
	model_destroy(walk->model);
}

static void go_on(struct walk *walk, int frames)
{
	const struct model_clip *clip = &walk->model->clip[walk->clip];

	for (int i = 0; i < frames; i++) {
		walk->time_s += step_s;
		pose_rest(&walk->instance->pose, walk->model);
		clip_sample(clip,
			clip_time((double)walk->time_s, clip->duration_s,
				CLIP_LOOP),
			&walk->cursor, &walk->instance->pose);
		walk->floor.offset[1] += 1.03f * step_s;
		walker_rig_apply(&walk->rig, walk->instance,
			&(struct walker_rig_frame){.time_s = (double)walk->time_s,
				.step_s = step_s,
				.speed_m_per_s = 1.03f,
				.floor = &walk->floor});
	}
}

static const float *place_of(const struct walk *walk, int node)
{
	return walk->instance->world[node][3];
}

static void test_without_features_the_clip_is_left_alone(void **state)
{
	struct walk walk;
	struct pose plain;

	(void)state;
	begin(&walk, "walk");
	go_on(&walk, 20);
	assert_int_equal(
		pose_init(&plain, walk.model, &walk.instance->arena), 0);
	clip_sample(&walk.model->clip[walk.clip],
		clip_time((double)walk.time_s, 1.1f, CLIP_LOOP), &walk.cursor,
		&plain);
	for (int i = 0; i < plain.node_count; i++) {
		assert_all_near(walk.instance->pose.local[i].rotation,
			plain.local[i].rotation, 4, 2e-5);
	}
	end(&walk);
}

static void test_feet_keep_their_height_above_uneven_ground(void **state)
{
	struct walk flat, uneven;

	(void)state;
	begin(&flat, "walk");
	begin(&uneven, "walk");
	uneven.rig.on[RIG_GROUND] = true;
	go_on(&flat, 30);
	go_on(&uneven, 30);
	for (int frame = 0; frame < 60; frame++) {
		go_on(&flat, 1);
		go_on(&uneven, 1);
		for (int side = 0; side < 2; side++) {
			int foot = uneven.rig.leg[side].tip;
			const float *at = place_of(&uneven, foot);
			const float *level = place_of(&flat, foot);
			float ground =
				floor_height(&uneven.floor, level[0], level[2]);

			assert_near(at[1] - ground, level[1], 0.004);
			assert_near(at[0], level[0], 0.004);
			assert_near(at[2], level[2], 0.004);
		}
	}
	end(&uneven);
	end(&flat);
}

static void test_the_hand_goes_to_a_ball_in_reach(void **state)
{
	struct walk walk;
	int reached = 0;

	(void)state;
	begin(&walk, "idle");
	walk.rig.on[RIG_REACH] = true;
	go_on(&walk, 30);
	for (int frame = 0; frame < 200; frame++) {
		const float *hand, *shoulder;
		float gap, reach;

		go_on(&walk, 1);
		hand = place_of(&walk, walk.rig.arm.tip);
		shoulder = place_of(&walk, walk.rig.arm.upper);
		gap = hypotf(hypotf(hand[0] - walk.rig.ball[0],
				     hand[1] - walk.rig.ball[1]),
			hand[2] - walk.rig.ball[2]);
		reach = hypotf(hypotf(shoulder[0] - walk.rig.ball[0],
				       shoulder[1] - walk.rig.ball[1]),
			shoulder[2] - walk.rig.ball[2]);
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
	end(&walk);
}

/* The least distance of the skin from the ball's middle, and how many vertices
   are within 2 cm of its surface. */
static float skin_distance(const struct walk *walk, int *near)
{
	const struct instance *instance = walk->instance;
	float least = 9.0f;

	*near = 0;
	for (int d = 0; d < instance->drawable_count; d++) {
		const struct drawable *drawable = &instance->drawable[d];

		for (int v = 0; v < drawable->primitive->vertex_count; v++) {
			float at[3], distance;

			instance_world_vertex(instance, drawable, v, at);
			distance = hypotf(hypotf(at[0] - walk->rig.ball[0],
						  at[1] - walk->rig.ball[1]),
				at[2] - walk->rig.ball[2]);
			least = fminf(least, distance);
			*near += distance < 0.07f;
		}
	}
	return least;
}

static void test_the_fingers_close_around_the_ball(void **state)
{
	struct walk walk;
	int grasped = 0;

	(void)state;
	begin(&walk, "walk");
	walk.rig.on[RIG_REACH] = true;
	go_on(&walk, 30);
	for (int frame = 0; frame < 120; frame++) {
		const float *hand;
		int near;

		go_on(&walk, 1);
		instance_update(walk.instance);
		hand = place_of(&walk, walk.rig.arm.tip);
		if (hypotf(hypotf(hand[0] - walk.rig.ball[0],
				   hand[1] - walk.rig.ball[1]),
			    hand[2] - walk.rig.ball[2]) < 0.0935f) {
			/* The ball's radius is 5 cm: nothing pierces it. */
			assert_true(skin_distance(&walk, &near) > 0.048f);
			assert_true(near > 20);
			grasped++;
		}
	}
	assert_true(grasped > 60);
	end(&walk);
}

static void test_the_head_turns_towards_the_ball(void **state)
{
	struct walk walk;

	(void)state;
	begin(&walk, "idle");
	walk.rig.on[RIG_LOOK] = true;
	go_on(&walk, 60);
	for (int frame = 0; frame < 100; frame++) {
		const vec4 *head;
		float to[3], length, cosine;

		go_on(&walk, 1);
		head = walk.instance->world[walk.rig.head.node];
		for (int axis = 0; axis < 3; axis++) {
			to[axis] = walk.rig.ball[axis] - head[3][axis];
		}
		length = hypotf(hypotf(to[0], to[1]), to[2]);
		cosine = (head[2][0] * to[0] + head[2][1] * to[1] +
				 head[2][2] * to[2]) /
			length;
		/* The head lags by at most a quarter of a right angle. */
		assert_true(cosine > 0.92f);
	}
	end(&walk);
}

static void test_the_cape_stays_on_and_moves(void **state)
{
	struct walk walk;
	const float(*p)[3];
	float lowest = 9.0f, highest = -9.0f;

	(void)state;
	begin(&walk, "walk");
	walk.rig.on[RIG_CAPE] = true;
	for (int frame = 0; frame < 150; frame++) {
		float z;

		go_on(&walk, 1);
		p = (const float(*)[3])walk.rig.secondary.cape.position;
		z = p[CAPE_COLUMNS * CAPE_ROWS - 5][2];
		lowest = z < lowest ? z : lowest;
		highest = z > highest ? z : highest;
		for (int i = 0; i < CAPE_COLUMNS * CAPE_ROWS; i++) {
			assert_true(fabsf(p[i][0]) < 1.0f);
			assert_true(p[i][1] > 0.3f && p[i][1] < 1.7f);
			assert_true(fabsf(p[i][2]) < 1.1f);
		}
	}
	assert_true(highest - lowest > 0.01f);
	end(&walk);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_without_features_the_clip_is_left_alone),
		cmocka_unit_test(test_feet_keep_their_height_above_uneven_ground),
		cmocka_unit_test(test_the_hand_goes_to_a_ball_in_reach),
		cmocka_unit_test(test_the_fingers_close_around_the_ball),
		cmocka_unit_test(test_the_head_turns_towards_the_ball),
		cmocka_unit_test(test_the_cape_stays_on_and_moves),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
