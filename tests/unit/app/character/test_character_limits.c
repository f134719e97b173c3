/* The numbers that a character file may give, and those that it leaves out. */
#include "app/character/run/effects.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

struct limits {
	const char *text; /* with # in place of the number */
	double low, high;
	double outside; /* how far a number is refused */
};

#define BALL   "[target ball]\nplace = 0 1 1\n"
#define LOOK   BALL "[look a]\ntarget = ball\nbone = head"
#define LAYER  "[layer a]\nclip = wave\n"
#define REACH  BALL "[reach a]\ntarget = ball\nchain = hand.R 3\n"
#define SHAKE  "[shake a]\nbone = head\n"
#define SPRING "[spring a]\nbones = ponytail.4 4\n"
#define MUSCLE "[muscle a]\njoint = forearm.L\nbone = upper_arm.L\n"
#define CAPE   "[cape a]\nbone = chest\nplace = 0 1.45 -0.12\n"
#define STATES "[state a]\nclip = walk\n[state b]\nclip = run\n"

static const struct limits walker[] = {
	{"[parameter a]\nease = #", 0, 60, 0.01},
	{"[state a]\nclip = walk\nrate = #", -100, 100, 0.01},
	{"[state a]\nclip = walk\nfade = #", 0, 60, 0.01},
	{"[state a]\nclip = walk\nfade = # frames", 0, 60, 0.01},
	{"[state a]\nclip = walk\npause = #", 0, 3600, 0.01},
	{STATES "[transition a b]\nexit = #", 0, 1, 0.01},
	{STATES "[transition a b]\nfade = #", 0, 60, 0.01},
	{LAYER "rate = #", -100, 100, 0.01},
	{LAYER "soft = #", 0, 16, 1},
	{LAYER "weight = #", 0, 1, 0.01},
	{LAYER "fade = #", 0, 60, 0.01},
	{LAYER "mask = head #", 0, 1, 0.01},
	{"[target a]\ncolor = # 0 0", 0, 1, 0.01},
	{LOOK " #", 0, 1, 0.01},
	{LOOK " 1 #", 0, 100, 0.01},
	{LOOK "\nyaw = #", 1, 179, 0.01},
	{LOOK "\npitch = #", 1, 89, 0.01},
	{LOOK "\nrate = #", 0, 100, 0.01},
	{REACH "limit = #", 0.1, 180, 0.01},
	{SHAKE "speed = #", 0, 200, 0.01},
	{SHAKE "amplitude = #", 0, 4, 0.01},
	{SHAKE "attenuation = #", -2, 2, 0.01},
	{SHAKE "modifier = #", 0, 4, 0.01},
	{SHAKE "delay = #", 0, 10, 0.01},
	{"[turn a]\nbone = head\nangle = #", -360, 360, 0.01},
	{SPRING "frequency = #", 0, 15, 0.01},
	{SPRING "damping = #", 0, 10, 0.01},
	{SPRING "limit = #", 0, 180, 0.01},
	{"[breath a]\nbone = chest\nrate = #", 0, 10, 0.01},
	{"[breath a]\nbone = chest\nlift = #", -45, 45, 0.01},
	{MUSCLE "from = #", 0, 180, 0.01},
	{MUSCLE "to = #", 0, 180, 0.01},
	{CAPE "flare = #", 0.1, 10, 0.01},
	{CAPE "color = # 0 0", 0, 1, 0.01},
	{"[scene]\nyaw = #", -360, 360, 0.01},
	{"[scene]\npitch = #", 0, 89, 0.01},
	{"[scene]\nmargin = #", 0.2, 10, 0.01},
	{"[scene]\nzoom = #", 0.04, 1, 0.01},
	{"[scene]\nwaves = #", 0, 1e6, 1},
	{"[scene]\nperiod = #", 0.1, 3600, 0.01},
	{"[target a]\nradius = #", 0, 1e6, 1},
	{"[target a]\ncolor = 0 # 0", 0, 1, 0.01},
	{"[target a]\ncolor = 0 0 #", 0, 1, 0.01},
	{"[scene]\nshadow = #", 0, 1, 0.01},
	{"[scene]\nrelief = #", 0, 1, 0.01},
};

static const struct limits face[] = {
	{"[expression a]\ntargets = smile #", -10, 10, 0.01},
	{"[morph a]\nkey = glad, smile #", -10, 10, 0.01},
	{"[morph a]\ntime = #", 0, 60, 0.01},
	{"[morph a]\nframes = #", 1, 10000, 1},
	{"[morph a]\nweight = #", 0, 1, 0.01},
	{"[morph a]\nneck = 0.1 0.15\nturn = #", -28, 28, 0.01},
	{"[morph a]\ncurve = bezier # 0 0 0", 0, 1, 0.01},
	{"[morph a]\ncurve = bezier 0 0 # 0", 0, 1, 0.01},
};

static void check_limits(
	const char *model, const struct limits *limits, size_t count)
{
	struct acting acting;

	acting_begin(&acting, model);
	for (size_t i = 0; i < 4 * count; i++) {
		const struct limits *row = &limits[i / 4];
		const char *at = strchr(row->text, '#');
		double outside = i % 2 ? row->outside : 0;
		char text[256];

		snprintf(text, sizeof(text), "%.*s%.9g%s\n",
			(int)(at - row->text), row->text,
			i & 2 ? row->high + outside : row->low - outside,
			at + 1);
		acting_read(&acting, text);
		if (acting.error != (outside > 0 ? -EINVAL : 0)) {
			fail_msg("%s: %s",
				acting.error ? "refused" : "accepted", text);
		}
	}
	acting_end(&acting);
}

static void test_numbers_of_a_skeleton_lie_within_their_limits(void **state)
{
	(void)state;
	check_limits("assets/walker.glb", walker, ARRAY_COUNT(walker));
}

static void test_numbers_of_morphs_lie_within_their_limits(void **state)
{
	(void)state;
	check_limits("assets/face.glb", face, ARRAY_COUNT(face));
}

/* Sections, and what they leave out. */
static const struct {
	const char *given, *left_out;
} defaults[] = {
	{SHAKE,
		"speed = 40\namplitude = 0.3\nattenuation = 0.3\nmodifier = 1\n"
		"translation = 0 1 0\nrotation = 0 0.1 0\nunit = 0.01\n"
		"delay = 0\n"},
	{"[turn a]\nbone = head\n",
		"axis = 1 0 0\nangle = 28.6478898\nfrom = clip\n"},
	{SPRING "body = hips chest 0.2\n",
		"frequency = 2\ndamping = 0.3\ngravity = 0 -9.81 0\nlimit = 0\n"
		"radius = 0\n"},
	{"[breath a]\nbone = chest\n",
		"rate = 0.25\nswell = 0.02 0.01 0.05\nlift = -1.00267614\n"},
	{MUSCLE "swell = 0.2 0 0.3\n", "from = 17.1887339\nto = 91.6732472\n"},
	{"[target high]\nplace = 1 9 0.5\n"
	 "[look a]\ntarget = high\nbone = head\n",
		"pitch = 50.0192155\nrate = 8\nforward = 0 0 1\nup = 0 1 0\n"},
	{CAPE,
		"width = 0.33\nlength = 0.8\nflare = 1.35\npleat = 0.034\n"
		"shoulders = 0 0\nradius = 0.02\n"},
	{LAYER,
		"weight = 1\nfade = 0.4\non = yes\nmode = override\nplay = loop\n"
		"rate = 1\nnodes = all\nsoft = 0\n"},
};

static void expect_alike(const struct acting *one, const struct acting *other)
{
	for (int i = 0; i < one->model->node_count; i++) {
		for (int k = 0; k < 16; k++) {
			assert_near(one->instance->world[i][k / 4][k % 4],
				other->instance->world[i][k / 4][k % 4], 1e-4);
		}
	}
	for (int c = 0; c < one->character->cape_count; c++) {
		const struct cloth *cloth = &one->character->cape[c].cloth;

		for (int i = 0; i < 3 * cloth->count; i++) {
			assert_near(cloth->position[i / 3][i % 3],
				other->character->cape[c]
					.cloth.position[i / 3][i % 3],
				1e-4);
		}
	}
}

static void test_what_a_section_leaves_out_has_its_usual_value(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(defaults); i++) {
		struct acting brief, full;
		char text[512];

		acting_begin(&brief, "assets/walker.glb");
		acting_begin(&full, "assets/walker.glb");
		snprintf(text, sizeof(text), "[state s]\nclip = run\n%s",
			defaults[i].given);
		acting_expect(&brief, text);
		strcat(text, defaults[i].left_out);
		acting_expect(&full, text);
		for (double time_s = 0.4; time_s < 1.5; time_s += 0.4) {
			acting_run_to(&brief, time_s, 30.0);
			acting_run_to(&full, time_s, 30.0);
			expect_alike(&brief, &full);
		}
		acting_end(&brief);
		acting_end(&full);
	}
}

/* Where the upper edge of a cape with such pleats begins, soon after the start. */
static void find_corner(const char *pleat, float corner[3])
{
	struct acting acting;
	char text[128];

	acting_begin(&acting, "assets/walker.glb");
	snprintf(text, sizeof(text),
		"[state s]\nclip = run\n" CAPE "pleat = %s\n", pleat);
	acting_expect(&acting, text);
	acting_run_to(&acting, 0.1, 50.0);
	memcpy(corner, acting.character->cape[0].cloth.position[0],
		3 * sizeof(*corner));
	acting_end(&acting);
}

static void test_pleats_begin_at_the_upper_edge_with_an_eighth_of_their_depth(
	void **state)
{
	float smooth[3], pleated[3], sum = 0;

	(void)state;
	find_corner("0", smooth);
	find_corner("0.1", pleated);
	for (int i = 0; i < 3; i++) {
		sum += (pleated[i] - smooth[i]) * (pleated[i] - smooth[i]);
	}
	assert_near(sqrtf(sum), 0.012, 1e-4);
}

static void test_the_first_node_may_breathe(void **state)
{
	struct acting acting;
	char text[128];

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	snprintf(text, sizeof(text), "[breath a]\nbone = \"%s\"\n",
		acting.model->node[0].name);
	acting_expect(&acting, text);
	acting_end(&acting);
}

/* What is seen alone, and not moved. */
static void test_colours_and_the_camera_have_usual_values(void **state)
{
	const struct character *character;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[state s]\nclip = run\n" CAPE "[target t]\nradius = 0.1\n");
	character = acting.character;
	assert_all_near(character->cape[0].color,
		((float[]){0.82f, 0.15f, 0.19f}), 3, 0);
	assert_all_near(character->target[0].color,
		((float[]){0.95f, 0.35f, 0.2f}), 3, 0);
	for (int axis = 0; axis < 3; axis++) {
		assert_near(*character->target[0].place[axis], 0, 0);
	}
	assert_int_equal(character->target[0].node, -1);
	assert_near(*character->scene.wave_m, 0, 0);
	assert_near(*character->scene.shadow, 1, 0);
	assert_near(*character->scene.relief, 1, 0);
	assert_near(character->scene.yaw_rad, 0.45, 1e-6);
	assert_near(character->scene.pitch_rad, -1, 0);
	assert_near(character->scene.margin, 1.15, 1e-6);
	assert_int_equal(character->scene.labels, CHARACTER_LABELS_LEFT);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_numbers_of_a_skeleton_lie_within_their_limits),
		cmocka_unit_test(test_numbers_of_morphs_lie_within_their_limits),
		cmocka_unit_test(
			test_what_a_section_leaves_out_has_its_usual_value),
		cmocka_unit_test(test_colours_and_the_camera_have_usual_values),
		cmocka_unit_test(
			test_pleats_begin_at_the_upper_edge_with_an_eighth_of_their_depth),
		cmocka_unit_test(test_the_first_node_may_breathe),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
