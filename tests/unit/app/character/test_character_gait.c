/* Feet while the gait changes: they neither slide nor sink nor hover. */
#include "app/character/run/parameters.h"
#include "app/character/state/entry.h"
#include "platform/base/compiler.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
	MOMENTS = 40,
	VERTICES_MAX = 512
};

static const double rate_hz = 30.0;
static const float planted_m = 0.003f;

static const char gaits[] =
	"[parameter speed]\nrange = 0 2.6\nease = 0.6\n"
	"[state move]\nblend = speed, idle 0, walk 1.03, run 2.6\n"
	"[motion]\nfeet = toe.L toe.R\n"
	"[feet ground]\nhips = hips\n"
	"left = thigh.L shin.L foot.L\nright = thigh.R shin.R foot.R\n";

static const struct {
	float speed;
	double duration_s; /* of the clip */
} gait[] = {{0.0f, 3.2}, {1.03f, 1.1}, {2.6f, 0.7}};

/* The vertices of both soles, with where they touched the ground. */
struct soles {
	int count;
	struct {
		int drawable, vertex;
		bool planted;
		float place[3], from[2];
	} at[VERTICES_MAX];
	float ground[2];
};

static void find_soles(struct acting *acting, struct soles *soles)
{
	const struct instance *instance = acting->instance;

	soles->count = 0;
	instance_update(acting->instance);
	for (int d = 0; d < instance->drawable_count; d++) {
		const struct drawable *drawable = &instance->drawable[d];

		for (int v = 0; v < drawable->primitive->vertex_count; v++) {
			float place[3];

			instance_world_vertex(instance, drawable, v, place);
			if (place[1] < 0.025f) {
				assert_true(soles->count < VERTICES_MAX);
				soles->at[soles->count].drawable = d;
				soles->at[soles->count++].vertex = v;
			}
		}
	}
	assert_true(soles->count > 40);
}

/* What was seen of a frame's feet, or of many frames' at worst. */
struct seen {
	double slide, lowest;
};

static struct seen look_at_soles(
	const struct acting *acting, struct soles *soles)
{
	const struct character_motion *motion = &acting->character->motion;
	struct seen seen = {0.0, 9.0};

	instance_update(acting->instance);
	for (int axis = 0; axis < 2; axis++) {
		soles->ground[axis] += motion->scroll[axis];
	}
	for (int i = 0; i < soles->count; i++) {
		float place[3], x, z;

		instance_world_vertex(acting->instance,
			&acting->instance->drawable[soles->at[i].drawable],
			soles->at[i].vertex, place);
		x = place[0] + soles->ground[0];
		z = place[2] + soles->ground[1];
		seen.lowest = fmin(seen.lowest, (double)place[1]);
		if (place[1] >= planted_m) {
			soles->at[i].planted = false;
			continue;
		}
		if (!soles->at[i].planted) {
			soles->at[i].planted = true;
			soles->at[i].from[0] = x;
			soles->at[i].from[1] = z;
		}
		seen.slide = fmax(seen.slide,
			(double)hypotf(x - soles->at[i].from[0],
				z - soles->at[i].from[1]));
	}
	return seen;
}

/* In run's flight phase the clip itself has both feet off the ground. */
static bool is_flight(const struct acting *acting)
{
	const struct character_entry *run =
		&acting->character->machine.state[0].entry[2];

	return run->weight > 0.0f && character_entry_sole_m(run, 0) > 0.008f;
}

static void set_speed(struct acting *acting, float speed)
{
	character_parameter_set(&acting->character->parameter[0], speed);
}

static void change_gait(struct acting *acting, struct soles *soles, int from,
	int to, double moment_s)
{
	double end_s;

	acting_expect(acting, gaits);
	soles->ground[0] = soles->ground[1] = 0.0f;
	set_speed(acting, gait[from].speed);
	acting_run_to(acting, 2.0 + moment_s, rate_hz);
	set_speed(acting, gait[to].speed);
	for (int i = 0; i < soles->count; i++) {
		soles->at[i].planted = false;
	}
	for (end_s = acting->now_s + 1.4; acting->now_s < end_s;) {
		struct seen seen;

		acting_run_to(acting, acting->now_s + 1.0 / rate_hz, rate_hz);
		seen = look_at_soles(acting, soles);
		assert_true(seen.slide < 0.01);
		assert_true(seen.lowest > -0.006);
		assert_true(seen.lowest < 0.01 || is_flight(acting));
	}
}

static void test_no_gait_change_slides_or_lifts_planted_feet(void **state)
{
	static struct soles soles;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting, gaits);
	find_soles(&acting, &soles);
	for (int from = 0; from < 3; from++) {
		for (int to = 0; to < 3; to++) {
			for (int i = 0; i < MOMENTS && to != from; i++) {
				change_gait(&acting, &soles, from, to,
					gait[from].duration_s * i / MOMENTS);
			}
		}
	}
	acting_end(&acting);
}

/* Where a foot is in the end: as in the clip, with nothing that holds it. */
static void test_feet_return_to_the_clips_places(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting, gaits);
	set_speed(&acting, 2.6f);
	acting_run_to(&acting, 2.0, rate_hz);
	set_speed(&acting, 0.0f);
	acting_run_to(&acting, 4.5, rate_hz);
	for (int side = 0; side < 2; side++) {
		const char *const name[] = {"toe.L", "toe.R"};
		float held[3], plain[3], lift[3];
		struct pose *pose = &acting.instance->pose;

		acting_place(&acting, name[side], held);
		clip_pose(
			&acting.model->clip[model_find_clip(acting.model, "idle")],
			acting.character->machine.state[0].entry[0].shown_s,
			CLIP_AUTO, &(struct clip_cursor){0}, pose);
		instance_update_nodes(acting.instance);
		acting_place(&acting, name[side], plain);
		for (int axis = 0; axis < 3; axis++) {
			lift[axis] = held[axis] - plain[axis];
		}
		assert_near(hypotf(lift[0], lift[2]), 0.0, 0.015);
		assert_near(lift[1], 0.0, 0.003);
		acting_run_to(&acting, acting.now_s + 0.1, rate_hz);
	}
	acting_end(&acting);
}

/* Without the feet's names the ground goes as clips walk, and stands else. */
static void test_the_lowest_vertices_tell_how_the_ground_moves(void **state)
{
	static const struct {
		const char *clip, *rate;
		float speed, near_speed;
	} walks[] = {{"idle", "1", 0.0f, 1e-6f}, {"walk", "1", 1.03f, 0.06f},
		{"walk", "0.5", 0.515f, 0.03f}, {"run", "1", 2.6f, 0.3f},
		{"wave", "1", 0.0f, 1e-6f}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(walks); i++) {
		struct acting acting;
		char text[128];

		snprintf(text, sizeof(text),
			"[state a]\nclip = %s\nrate = %s\n[motion]\nclips = yes\n",
			walks[i].clip, walks[i].rate);
		acting_begin(&acting, "assets/walker.glb");
		acting_expect(&acting, text);
		acting_run_to(&acting, 0.5, rate_hz);
		assert_near(acting.character->motion.scroll[1] * (float)rate_hz,
			walks[i].speed, walks[i].near_speed);
		assert_near(acting.character->motion.scroll[0], 0.0, 1e-6);
		acting_end(&acting);
	}
}

/* Lets the clip's hips go ahead by speed * time, as recorded motion does. */
static void walk_away(struct model_clip *clip, int hips, float speed)
{
	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];
		float(*at)[3] = (float(*)[3])channel->value;

		for (int k = 0; k < channel->key_count && channel->node == hips &&
			channel->path == MODEL_TRANSLATION;
			k++) {
			at[k][2] += speed * channel->time_s[k];
		}
	}
}

/* The figure stays where it is when the clip begins again. */
static void test_a_clip_that_walks_away_moves_the_ground(void **state)
{
	struct acting acting;
	float before[3], now[3];
	int clip, hips;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	clip = model_find_clip(acting.model, "walk");
	hips = model_find_node(acting.model, "hips");
	walk_away(&acting.model->clip[clip], hips, 1.03f);
	acting_expect(
		&acting, "[state a]\nclip = walk\n[motion]\nclips = yes\n");
	assert_int_equal(acting.character->motion.root, hips);
	acting_run_to(&acting, 0.1, rate_hz);
	acting_place(&acting, "hips", before);
	for (double time_s = 0.2; time_s < 3.0; time_s += 0.1) {
		acting_run_to(&acting, time_s, rate_hz);
		acting_place(&acting, "hips", now);
		assert_near(now[2], before[2], 0.06);
		assert_near(acting.character->motion.scroll[1] * (float)rate_hz,
			1.03, 0.06);
	}
	acting_end(&acting);
}

/* Else the ground would go with it, as if it stood on a belt. */
static void test_the_ground_rests_below_what_slides_along(void **state)
{
	struct acting acting;
	float *at;

	(void)state;
	acting_begin(&acting, "tests/fixtures/gltf/clip/far.gltf");
	/* A triangle of a metre goes 0.89 m instead of 44.7 m. */
	at = (float *)(uintptr_t)acting.model->clip->channel->value;
	for (int i = 0; i < 9; i++) {
		at[i] *= 0.02f;
	}
	acting_expect(
		&acting, "[state a]\nclip = leave\n[motion]\nclips = yes\n");
	for (double time_s = 0.1; time_s < 2.0; time_s += 0.1) {
		acting_run_to(&acting, time_s, rate_hz);
		assert_near(acting.character->motion.scroll[0], 0, 0);
		assert_near(acting.character->motion.scroll[1], 0, 0);
	}
	acting_end(&acting);
}

/* Such as a car that drives away, which would jump back in each round. */
static void test_what_goes_farther_than_it_is_long_moves_the_ground(void **state)
{
	struct acting acting;
	float *at;

	(void)state;
	acting_begin(&acting, "tests/fixtures/gltf/clip/far.gltf");
	at = (float *)(uintptr_t)acting.model->clip->channel->value;
	/* At an even speed. */
	at[3] = 20;
	at[5] = -10;
	acting_expect(
		&acting, "[state a]\nclip = leave\n[motion]\nclips = yes\n");
	assert_int_equal(acting.character->motion.root, 0);
	for (double time_s = 0.1; time_s < 4.0; time_s += 0.1) {
		const float *place = acting.character->instance->world[0][3];

		acting_run_to(&acting, time_s, rate_hz);
		assert_near(acting.character->motion.scroll[0] * (float)rate_hz,
			20.0, 1e-3);
		assert_near(acting.character->motion.scroll[1] * (float)rate_hz,
			-10.0, 1e-3);
		assert_near(place[0], 0, 1e-3);
		assert_near(place[2], 0, 1e-3);
	}
	acting_end(&acting);
}

/* Else one of two cars would stay behind. */
static void test_the_ground_rests_below_two_that_go_away(void **state)
{
	struct acting acting;
	struct model *model;

	(void)state;
	acting_begin(&acting, "tests/fixtures/gltf/clip/far.gltf");
	model = acting.model;
	/* Each node shows the triangle, and both are moved alike. */
	model->node[0].mesh = model->node[1].mesh;
	model->node[1].parent = -1;
	model->clip->channel = (struct model_channel[]){
		model->clip->channel[0], model->clip->channel[0]};
	model->clip->channel_count = 2;
	((struct model_channel *)(uintptr_t)model->clip->channel)[1].node = 1;
	acting_expect(
		&acting, "[state a]\nclip = leave\n[motion]\nclips = yes\n");
	assert_int_equal(acting.character->motion.root, -1);
	acting_run_to(&acting, 0.5, rate_hz);
	assert_near(acting.character->motion.scroll[0], 0, 0);
	acting_end(&acting);
}

/* With the name of what slides, such as a fish, the ground moves instead. */
static void test_a_named_root_moves_the_ground_below_what_slides(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "tests/fixtures/gltf/clip/far.gltf");
	acting.model->node[0].name = "crate";
	acting_expect(&acting,
		"[state a]\nclip = leave\n[motion]\nclips = yes\nroot = crate\n");
	acting_run_to(&acting, 0.5, rate_hz);
	assert_near(acting.character->motion.scroll[0] * (float)rate_hz, 20.0,
		1e-3);
	assert_near(acting.character->motion.scroll[1] * (float)rate_hz, -10.0,
		1e-3);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_no_gait_change_slides_or_lifts_planted_feet),
		cmocka_unit_test(test_feet_return_to_the_clips_places),
		cmocka_unit_test(
			test_the_lowest_vertices_tell_how_the_ground_moves),
		cmocka_unit_test(test_a_clip_that_walks_away_moves_the_ground),
		cmocka_unit_test(test_the_ground_rests_below_what_slides_along),
		cmocka_unit_test(
			test_what_goes_farther_than_it_is_long_moves_the_ground),
		cmocka_unit_test(test_the_ground_rests_below_two_that_go_away),
		cmocka_unit_test(
			test_a_named_root_moves_the_ground_below_what_slides),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
