/*
 * The course of the walker's feet while its speed changes, on level ground and
 * on hills. test_character_gait.c says that they neither slide nor sink; these
 * numbers, noted from a run, say when a foot is held, raised and turned, so
 * that no change of that goes unnoticed.
 */
#include "app/character/run/feet.h"
#include "platform/base/scalar.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double rate_hz = 30.0;

enum {
	MOMENTS = 26,
	NUMBERS = 12
};

static const char gaits[] =
	"[parameter speed]\nrange = 0 2.6\nease = 0.4\n"
	"[state move]\nblend = speed, idle 0, walk 1.03, run 2.6\n"
	"[state wave]\nclip = wave\nfade = 0.5\n"
	"[motion]\nfeet = toe.L toe.R\n[feet ground]\nhips = hips\n"
	"left = thigh.L shin.L foot.L\nright = thigh.R shin.R foot.R\n"
	"[buttons]\nUP = set speed 1.03\nDOWN = set speed 2.6\n"
	"LEFT = set speed 0\nRIGHT = go wave\n";

/* Buttons that change the speed, with the frames before which they are pressed. */
static const struct {
	int frame;
	enum button button;
} press[] = {{40, BUTTON_UP}, {77, BUTTON_DOWN}, {105, BUTTON_UP},
	{140, BUTTON_LEFT}, {190, BUTTON_RIGHT}};

static float hills(void *user, float x, float z)
{
	(void)user;
	return 0.06f * sinf(4.0f * z + 1.0f) + 0.1f * x;
}

/* Millimetres and milliradians of both feet, and of the hips. */
static void measure(const struct acting *acting, int out[NUMBERS])
{
	const struct character_feet *feet = acting->character->feet;
	float hips[3];
	int n = 0;

	for (int side = 0; side < 2; side++) {
		const struct character_foot *foot = &feet->foot[side];
		float ankle[3];

		acting_place(acting, side == 0 ? "foot.L" : "foot.R", ankle);
		out[n++] = (int)lroundf(1000.0f * foot->hold.offset[1]);
		out[n++] = (int)lroundf(1000.0f * foot->hold.turn_rad);
		out[n++] = (int)lroundf(1000.0f * foot->raised_m);
		out[n++] = (int)lroundf(1000.0f * ankle[1]);
		out[n++] = (int)lroundf(1000.0f * ankle[2]);
	}
	acting_place(acting, "hips", hips);
	out[n++] = (int)lroundf(1000.0f * hips[1]);
	out[n++] = (int)lroundf(1000.0f * acting->character->motion.velocity[1]);
	assert_int_equal(n, NUMBERS);
}

/*
 * In each eighth frame, of each foot how far it is held along z, turned and
 * raised, and the ankle's y and z; then the hips' height and the velocity.
 */
static const int level[MOMENTS][NUMBERS] = {
	{0, 0, 0, 88, -25, 0, 0, 0, 88, 18, 943, 1},
	{0, 0, 0, 88, -25, 1, 0, 0, 88, 18, 942, 3},
	{0, 0, 0, 88, -25, 0, 0, 0, 88, 18, 942, 2},
	{0, 0, 0, 88, -25, 0, 0, 0, 88, 18, 942, 1},
	{0, 0, 0, 88, -25, 0, 0, 0, 88, 18, 942, 0},
	{-2, 0, 0, 88, -48, 9, -77, 0, 130, 45, 941, -311},
	{54, 16, 6, 158, -200, 4, -6, 0, 93, 233, 915, 987},
	{0, 0, 0, 172, 4, 6, -6, 0, 88, -31, 940, 1034},
	{0, -1, 0, 97, 240, 1, -8, 0, 145, -247, 915, 964},
	{36, 4, 0, 88, 12, -29, -12, 0, 226, -61, 935, 1051},
	{64, 21, 0, 436, -274, 0, 0, 0, 117, 256, 938, 1937},
	{0, 0, 0, 233, 315, 23, -4, 0, 188, -258, 930, 2427},
	{4, 1, 0, 118, -163, 0, 0, 0, 413, 159, 886, 2523},
	{0, 1, 0, 334, -187, -16, 7, 0, 87, 42, 923, 2051},
	{0, 0, 0, 106, 284, -65, 21, 0, 120, -279, 922, 1019},
	{0, -2, 0, 88, 49, -1, 0, 3, 222, -162, 932, 1030},
	{-1, -2, 0, 116, -205, 0, 0, 0, 108, 289, 924, 1005},
	{-230, 1, 0, 176, -386, 35, 22, 0, 99, 89, 945, 905},
	{-142, -20, 66, 154, -168, 88, 64, 0, 88, 105, 943, -261},
	{0, 0, 0, 88, -25, 44, 29, 24, 112, 61, 942, -7},
	{0, 0, 0, 88, -25, 1, 1, 0, 88, 18, 942, 1},
	{0, 0, 0, 88, -25, 1, 1, 0, 88, 18, 942, 1},
	{0, 0, 0, 88, -25, 1, 1, 0, 88, 18, 942, 1},
	{1, 0, 0, 88, -25, 1, 1, 0, 88, 18, 943, 2},
	{0, 0, 0, 88, -25, 1, 0, 0, 88, 18, 943, -1},
	{0, 0, 0, 88, -25, 1, 1, 0, 88, 18, 942, 0},
};

static const int uneven_ground[MOMENTS][NUMBERS] = {
	{0, 0, 0, 145, -25, 0, 0, 0, 131, 18, 986, 1},
	{0, 0, 0, 145, -25, 1, 0, 0, 131, 18, 985, 3},
	{0, 0, 0, 145, -25, 0, 0, 0, 131, 18, 985, 2},
	{0, 0, 0, 145, -25, 0, 0, 0, 131, 18, 985, 1},
	{0, 0, 0, 145, -25, 0, 0, 0, 131, 18, 985, 0},
	{-2, 0, 0, 139, -48, 9, -77, 0, 178, 45, 989, -311},
	{54, 16, 6, 178, -200, 4, -6, 0, 142, 233, 936, 987},
	{0, 0, 0, 231, 4, 6, -6, 0, 127, -31, 979, 1034},
	{0, -1, 0, 160, 240, 1, -8, 0, 138, -247, 908, 964},
	{36, 4, 0, 147, 12, -29, -12, 0, 261, -61, 969, 1051},
	{64, 21, 0, 437, -274, 0, 0, 0, 166, 256, 939, 1937},
	{0, 0, 0, 285, 315, 23, -4, 0, 180, -258, 922, 2427},
	{4, 1, 0, 144, -163, 0, 0, 0, 467, 159, 912, 2523},
	{0, 1, 0, 356, -187, -16, 7, 0, 136, 42, 945, 2051},
	{0, 0, 0, 164, 284, -65, 21, 0, 105, -279, 907, 1019},
	{0, -2, 0, 151, 49, -1, 0, 3, 234, -162, 944, 1030},
	{-1, -2, 0, 134, -205, 0, 0, 0, 151, 289, 943, 1005},
	{-230, 1, 0, 153, -386, 35, 22, 0, 150, 89, 922, 905},
	{-142, -20, 66, 183, -168, 88, 64, 0, 139, 105, 972, -261},
	{0, 0, 0, 145, -25, 44, 29, 24, 160, 61, 990, -7},
	{0, 0, 0, 145, -25, 1, 1, 0, 131, 18, 985, 1},
	{0, 0, 0, 145, -25, 1, 1, 0, 131, 18, 985, 1},
	{0, 0, 0, 145, -25, 1, 1, 0, 131, 18, 985, 1},
	{1, 0, 0, 145, -25, 1, 1, 0, 131, 18, 986, 2},
	{0, 0, 0, 145, -25, 1, 0, 0, 131, 18, 986, -1},
	{0, 0, 0, 145, -25, 1, 1, 0, 131, 18, 986, 0},
};

static void follow_course(bool uneven, const int (*wanted)[NUMBERS])
{
	struct acting acting;
	size_t pressed = 0;

	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting, gaits);
	acting.character->ground_height = uneven ? hills : NULL;
	for (int frame = 0; frame < 8 * MOMENTS; frame++) {
		int seen[NUMBERS];

		if (pressed < sizeof(press) / sizeof(press[0]) &&
			press[pressed].frame == frame) {
			acting_press(&acting, press[pressed].button);
			acting_release(&acting, press[pressed++].button);
		}
		acting_run_to(&acting, (frame + 0.5) / rate_hz, rate_hz);
		if (frame % 8 != 7) {
			continue;
		}
		measure(&acting, seen);
		for (int i = 0; i < NUMBERS; i++) {
			assert_near(seen[i], wanted[frame / 8][i],
				i == NUMBERS - 1 ? 20 : 3);
		}
	}
	acting_end(&acting);
}

static void test_feet_follow_their_course_on_level_ground(void **state)
{
	(void)state;
	follow_course(false, level);
}

static void test_feet_follow_their_course_on_hills(void **state)
{
	(void)state;
	follow_course(true, uneven_ground);
}

/*
 * The left foot of a standing figure, as if a clip had turned it since the frame
 * before: by half a turn it is held no more, by a whole one it has not moved.
 */
static void test_a_foot_that_turned_round_steps(void **state)
{
	(void)state;
	for (int half_turns = -2; half_turns <= 2; half_turns++) {
		struct acting acting;
		struct character_foot *foot;

		acting_begin(&acting, "assets/walker.glb");
		acting_expect(&acting, gaits);
		acting_run_to(&acting, 1.0, rate_hz);
		foot = &acting.character->feet->foot[0];
		assert_true(foot->low && foot->step_s < 0.0f);
		foot->direction -= SCALAR_PI * (float)half_turns;
		acting_run_to(&acting, 1.0 + 1.5 / rate_hz, rate_hz);
		assert_int_equal(foot->step_s >= 0.0f, half_turns % 2 != 0);
		acting_end(&acting);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_feet_follow_their_course_on_level_ground),
		cmocka_unit_test(test_feet_follow_their_course_on_hills),
		cmocka_unit_test(test_a_foot_that_turned_round_steps),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
