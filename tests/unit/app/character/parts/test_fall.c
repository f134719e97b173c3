/* How parts are pulled into a gripper, and how they fall. */
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <math.h>

static const double rate_hz = 100.0;

static const char text[] =
	"[part Arm]\npitch = -28 -60 60 100\n[part Crate]\n[part Hand]\n"
	"[buttons]\nUP = attach Crate Hand\nDOWN = drop Crate\n"
	"LEFT hold = move Arm pitch -1\nRIGHT = attach Crate Hand 9 0 0 0.3\n"
	"ENTER = detach Crate\nF6 = attach Crate Hand 0.01 0 0 0.3\n";

static void begin(struct acting *acting)
{
	acting_begin(acting, "assets/arm.glb");
	acting_expect(acting, text);
	acting_run_to(acting, 0.1, rate_hz);
}

static const struct character_part *crate_of(const struct acting *acting)
{
	return &acting->character->part[1];
}

static void next_frame(struct acting *acting)
{
	acting_run_to(acting, acting->now_s + 0.5 / rate_hz, rate_hz);
}

static float height_of(const struct acting *acting)
{
	float at[3];

	acting_place(acting, "Crate", at);
	return at[1];
}

/* By 9.81 m/s each second, until it lies at the height that it had. */
static void test_a_part_falls_as_gravity_says(void **state)
{
	struct acting acting;
	double high, fallen = 0.0, speed = 0.0;
	int frames = 0;

	(void)state;
	begin(&acting);
	assert_near(height_of(&acting), 0.06, 1e-5);
	acting_tap(&acting, BUTTON_UP, 0.02, rate_hz);
	acting_tap(&acting, BUTTON_LEFT, 0.6, rate_hz);
	high = height_of(&acting);
	assert_true(high > 0.2);
	acting_press(&acting, BUTTON_DOWN);
	acting_release(&acting, BUTTON_DOWN);
	while (fallen < high - 0.06) {
		next_frame(&acting);
		speed += 9.81 / rate_hz;
		fallen += speed / rate_hz;
		assert_near(height_of(&acting), fmax(high - fallen, 0.06), 1e-3);
		frames++;
	}
	assert_true(frames > 20);
	acting_run_to(&acting, acting.now_s + 1.0, rate_hz);
	assert_near(height_of(&acting), 0.06, 1e-5);
	assert_int_equal(crate_of(&acting)->holder, CHARACTER_GROUND);
	acting_end(&acting);
}

/* It stays where the hand has it, and falls from there as at first. */
static void test_a_part_that_falls_can_be_caught(void **state)
{
	struct acting acting;
	float high;

	(void)state;
	begin(&acting);
	acting_tap(&acting, BUTTON_UP, 0.02, rate_hz);
	acting_tap(&acting, BUTTON_LEFT, 0.6, rate_hz);
	acting_press(&acting, BUTTON_DOWN);
	acting_release(&acting, BUTTON_DOWN);
	acting_run_to(&acting, acting.now_s + 0.1, rate_hz);
	high = height_of(&acting);
	acting_press(&acting, BUTTON_UP);
	acting_release(&acting, BUTTON_UP);
	next_frame(&acting);
	assert_near(height_of(&acting), high, 1e-5);
	acting_run_to(&acting, acting.now_s + 0.5, rate_hz);
	assert_near(height_of(&acting), high, 1e-5);
	acting_press(&acting, BUTTON_DOWN);
	acting_release(&acting, BUTTON_DOWN);
	next_frame(&acting);
	assert_near(height_of(&acting), high - 9.81 / rate_hz / rate_hz, 1e-5);
	acting_end(&acting);
}

/* It was turned with the arm, and lies with its base on the ground. */
static void test_a_part_that_falls_is_upright(void **state)
{
	struct acting acting;
	const vec4 *world;

	(void)state;
	begin(&acting);
	acting_tap(&acting, BUTTON_UP, 0.02, rate_hz);
	acting_tap(&acting, BUTTON_LEFT, 0.6, rate_hz);
	world = acting.instance->world[crate_of(&acting)->node];
	assert_true(world[1][1] < 0.95f);
	acting_tap(&acting, BUTTON_DOWN, 1.0, rate_hz);
	assert_all_near(world[1], ((float[]){0, 1, 0}), 3, 1e-5);
	acting_end(&acting);
}

/* Evenly to its place in the hand, which does not move. */
static void test_a_part_is_pulled_into_the_gripper(void **state)
{
	struct acting acting;
	float from[3], to[3], at[3];
	const vec4 *hand;
	double whole, last = 1.0;
	float pull_s;

	(void)state;
	begin(&acting);
	acting_place(&acting, "Crate", from);
	hand = acting.instance->world[model_find_node(acting.model, "Hand")];
	for (int axis = 0; axis < 3; axis++) {
		to[axis] = hand[3][axis] + 0.3f * hand[2][axis];
	}
	whole = hypot(hypot(from[0] - to[0], from[1] - to[1]), from[2] - to[2]);
	assert_true(whole > 0.2);
	acting_press(&acting, BUTTON_RIGHT);
	acting_release(&acting, BUTTON_RIGHT);
	next_frame(&acting);
	pull_s = crate_of(&acting)->pull_s + (float)(1.0 / rate_hz);
	assert_near(pull_s, 0.2, 1e-6);
	while (last > 0.0) {
		double left;

		acting_place(&acting, "Crate", at);
		left = hypot(hypot(at[0] - to[0], at[1] - to[1]), at[2] - to[2]) /
			whole;
		assert_near(left, crate_of(&acting)->pull_s / pull_s, 2e-3);
		assert_near(hypot(hypot(from[0] - at[0], from[1] - at[1]),
				    from[2] - at[2]) /
				whole,
			1 - left, 2e-3);
		assert_true(left < last);
		last = crate_of(&acting)->pull_s > 0 ? left : 0.0;
		next_frame(&acting);
	}
	acting_place(&acting, "Crate", at);
	assert_all_near(at, to, 3, 1e-5);
	/* It goes back to where it was at first. */
	acting_tap(&acting, BUTTON_ENTER, 0.1, rate_hz);
	acting_place(&acting, "Crate", at);
	assert_all_near(at, from, 3, 1e-5);
	/* From there it is too far away for the other grip. */
	acting_tap(&acting, BUTTON_F6, 0.1, rate_hz);
	assert_int_equal(crate_of(&acting)->holder, -1);
	acting_end(&acting);
}

/* What lies on the ground stays there. */
static void test_a_part_that_lies_does_not_drop(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting);
	acting_tap(&acting, BUTTON_DOWN, 0.1, rate_hz);
	assert_int_equal(crate_of(&acting)->holder, -1);
	assert_near(height_of(&acting), 0.06, 1e-5);
	acting_end(&acting);
}

/*
 * Makes a square of two triangles at this height of the first mesh of a node;
 * half is half of its side.
 */
static void make_table(struct acting *acting, int node, float height, float half)
{
	static const float corner[6][2] = {
		{-1, -1}, {1, -1}, {1, 1}, {-1, -1}, {1, 1}, {-1, 1}};
	struct model_mesh *mesh =
		&acting->model->mesh[acting->model->node[node].mesh];
	struct model_primitive *shape = mesh->primitive;

	assert_true(shape->index_count >= 6 && shape->vertex_count >= 6);
	shape->index_count = 6;
	for (int i = 0; i < 6; i++) {
		shape->index[i] = (uint32_t)i;
		shape->position[i][0] = half * corner[i][0];
		shape->position[i][1] = height;
		shape->position[i][2] = half * corner[i][1];
	}
}

/* Drops the crate, whose pivot is 0.06 above its base, from 1 above the ground. */
static void expect_drop(
	float height, float half, float x, float z, double lies_at)
{
	struct acting acting;
	float *rest;
	int base;

	acting_begin(&acting, "assets/arm.glb");
	base = model_find_node(acting.model, "Base");
	make_table(&acting, base, height, half);
	rest = acting.model->node[model_find_node(acting.model, "Crate")]
		       .rest.translation;
	rest[0] = x;
	rest[1] = 1.0f;
	rest[2] = z;
	pose_rest(&acting.instance->pose, acting.model);
	instance_update(acting.instance);
	acting_expect(
		&acting, "[part Crate]\n[buttons]\nUP = drop Crate Base\n");
	acting_tap(&acting, BUTTON_UP, 2.0, rate_hz);
	assert_int_equal(acting.character->part[0].holder,
		lies_at > 0.06 ? base : CHARACTER_GROUND);
	assert_near(height_of(&acting), lies_at, 1e-4);
	acting_end(&acting);
}

/* A pivot above an edge is above the table; one beside it is not. */
static void test_a_table_holds_what_is_above_its_edge(void **state)
{
	static const struct {
		float x, z;
		bool held;
	} cases[] = {{0.25f, 0.25f, true}, {0.5f, -1, true}, {-1, 0.5f, true},
		{1, 0.5f, true}, {0.5f, 1, true}, {0.5f, -1.01f, false},
		{-1.01f, 0.5f, false}, {1.01f, 0.5f, false},
		{0.5f, 1.01f, false}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		expect_drop(0.5f, 1, cases[i].x, cases[i].z,
			cases[i].held ? 0.56 : 0.06);
	}
}

/* One in the ground holds nothing, nor one above the pivot. */
static void test_a_table_is_between_the_pivot_and_the_ground(void **state)
{
	static const struct {
		float height;
		double lies_at;
	} cases[] = {{1.01f, 0.06}, {1, 1.06}, {0.25f, 0.31}, {0, 0.06},
		{-0.5f, 0.06}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		expect_drop(cases[i].height, 1, 0.25f, 0.25f, cases[i].lies_at);
		expect_drop(
			cases[i].height, 0.5f, 0.25f, 0.125f, cases[i].lies_at);
		expect_drop(cases[i].height, 0, 0.25f, 0.25f, 0.06);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_part_falls_as_gravity_says),
		cmocka_unit_test(test_a_part_that_falls_can_be_caught),
		cmocka_unit_test(test_a_part_that_falls_is_upright),
		cmocka_unit_test(test_a_part_is_pulled_into_the_gripper),
		cmocka_unit_test(test_a_part_that_lies_does_not_drop),
		cmocka_unit_test(test_a_table_holds_what_is_above_its_edge),
		cmocka_unit_test(
			test_a_table_is_between_the_pivot_and_the_ground),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
