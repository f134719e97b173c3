#include "app/anim/math/vec.h"
#include "app/anim/procedural/cloth.h"
#include "app/anim/procedural/substep.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	SIDE = 3,
	COUNT = 9
};

/* Hangs from one node in three columns, whose rows are 1, 1.5 and 2 high. */
struct fixture {
	struct arena arena;
	mat4 world[1];
	struct cloth cloth;
};

static const float SHAPE[COUNT][3] = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0},
	{0, -1, 0}, {1, -1.5f, 0}, {2, -2, 0}, {0, -2, 0}, {1, -3, 0},
	{2, -4, 0}};

/* No force acts, and no link; only the columns' lengths count. */
static void set_up(struct fixture *f)
{
	static const mat4 origin = {
		{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
	static const int pin[SIDE];
	struct cloth_settings settings = cloth_settings_default();

	settings.columns = settings.rows = SIDE;
	memset(settings.gravity, 0, sizeof(settings.gravity));
	settings.air = settings.damping = 0;
	settings.fastest = 1e6f;
	settings.passes = 0;
	f->arena = arena_empty();
	memcpy(f->world[0], origin, sizeof(origin));
	assert_int_equal(cloth_init(&f->cloth, &settings, SHAPE, pin,
				 (const mat4 *)f->world, &f->arena),
		0);
}

static void tear_down(struct fixture *f)
{
	arena_release(&f->arena);
}

static void frame(struct fixture *f, float step_s)
{
	cloth_update(&f->cloth, step_s, NULL, 0, (const mat4 *)f->world);
}

static void put(struct fixture *f, int i, float x, float y, float z)
{
	float *at = f->cloth.position[i];

	at[0] = x;
	at[1] = y;
	at[2] = z;
}

static void assert_at(const float at[3], double x, double y, double z)
{
	assert_near(at[0], x, 1e-5);
	assert_near(at[1], y, 1e-5);
	assert_near(at[2], z, 1e-5);
}

static void test_steps_are_divided_into_parts(void **state)
{
	static const struct {
		float step_s, whole_s;
		int count;
	} cases[] = {{0.008f, 0.008f, 1}, {0.0084f, 0.0084f, 2},
		{0.09f, 0.09f, 11}, {0.0999f, 0.0999f, 12}, {0.15f, 0.15f, 12},
		{0.19f, 0.19f, 12}, {0.2f, 0.2f, 12}, {0.21f, 0.2f, 12},
		{2e-4f, 2e-4f, 1}, {1e-5f, 1e-4f, 1}, {0, 1e-4f, 1},
		{-1, 1e-4f, 1}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct substep substep = substep_divide(cases[i].step_s);

		assert_int_equal(substep.count, cases[i].count);
		assert_near(substep.step_s, cases[i].whole_s, 0);
		assert_near(substep.part_s,
			(double)cases[i].whole_s / cases[i].count, 1e-9);
	}
}

static void test_all_but_the_pins_fall(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	memcpy(f.cloth.settings.gravity, (float[3]){10, -20, 30}, 12);
	f.cloth.settings.damping = 5;
	frame(&f, 0.008f);
	for (int i = 0; i < COUNT; i++) {
		bool falls = i >= SIDE;
		double speed = falls ? 0.08 / 1.04 : 0;

		assert_near(f.cloth.velocity[i][0], speed, 1e-4);
		assert_near(f.cloth.velocity[i][1], -2 * speed, 1e-4);
		assert_near(f.cloth.velocity[i][2], 3 * speed, 1e-4);
		assert_near(f.cloth.position[i][2], 0.024 * speed, 1e-5);
	}
	/* Speed adds up, and is damped again. */
	frame(&f, 0.008f);
	assert_near(f.cloth.velocity[4][2], (0.24 / 1.04 + 0.24) / 1.04, 1e-4);
	/* Twelve parts of the longest step. */
	cloth_reset(&f.cloth);
	f.cloth.settings.damping = 0;
	memcpy(f.cloth.settings.gravity, (float[3]){0, 0, 1}, 12);
	frame(&f, 0.2f);
	assert_near(f.cloth.velocity[4][2], 0.2, 1e-4);
	tear_down(&f);
}

/* Of the wind along the normal, at most half is taken over in a part. */
static void test_wind_pulls_along_the_normal_alone(void **state)
{
	static const struct {
		float air;
		double speed, later;
	} cases[] = {{50, 3.2, 5.12}, {62, 3.968, 5.967872}, {62.5f, 4, 6},
		{100, 4, 6}, {-50, 0, 0}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct fixture f;

		set_up(&f);
		memcpy(f.cloth.settings.wind, (float[3]){3, 5, 8}, 12);
		f.cloth.settings.air = cases[i].air;
		frame(&f, 0.008f);
		for (int p = SIDE; p < COUNT; p++) {
			assert_near(
				f.cloth.velocity[p][2], cases[i].speed, 1e-3);
			assert_near(f.cloth.velocity[p][0], 0, 1e-3);
			assert_near(f.cloth.velocity[p][1], 0, 1e-3);
		}
		frame(&f, 0.008f);
		assert_near(f.cloth.velocity[7][2], cases[i].later, 0.03);
		tear_down(&f);
	}
}

static void test_speed_is_limited_but_not_its_direction(void **state)
{
	/* Of (1, 2, -2) times the size. */
	static const struct {
		float size, fastest;
		double left;
	} cases[] = {{1, 2, 2.0 / 3}, {1, 2.99f, 2.99 / 3}, {1, 3.01f, 1},
		{1, 0, 0}, {0.1f, 0.15f, 0.05}, {0.1f, 1, 0.1}, {0, -1, 0}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct fixture f;
		float size = cases[i].size;

		set_up(&f);
		f.cloth.settings.fastest = cases[i].fastest;
		frame(&f, 0.008f);
		for (int p = SIDE; p < COUNT; p++) {
			float *v = f.cloth.velocity[p];

			v[0] = size;
			v[1] = 2 * size;
			v[2] = -2 * size;
		}
		frame(&f, 0.008f);
		for (int p = SIDE; p < COUNT; p++) {
			const float *v = f.cloth.velocity[p];

			assert_near(v[0], cases[i].left, 1e-3);
			assert_near(v[1], 2 * cases[i].left, 1e-3);
			assert_near(v[2], -2 * cases[i].left, 1e-3);
			/* The distance of this part is covered all the same. */
			assert_near(f.cloth.position[p][2],
				-0.016 * (double)size, 1e-5);
		}
		tear_down(&f);
	}
}

/* Two particles 0.5 apart are to be 0.25 apart. Pins stay at the origin. */
static void test_links_draw_their_ends_together(void **state)
{
	static const struct {
		int a, b, passes;
		float stiffness;
		double x[2];
	} cases[] = {{3, 7, 1, 1, {0.625, 0.875}},
		{3, 7, 1, 0.5f, {0.5625, 0.9375}},
		{3, 7, 2, 0.5f, {0.59375, 0.90625}}, {3, 7, 0, 1, {0.5, 1}},
		{0, 7, 1, 0.5f, {0, 0.625}}, {2, 7, 1, 0.5f, {2, 1.375}},
		{7, 0, 1, 0.5f, {0.625, 0}}, {3, 1, 1, 0.5f, {0.625, 1}},
		{7, 3, 1, 1, {0.875, 0.625}}, {0, 2, 1, 0.5f, {0, 2}}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct fixture f;

		set_up(&f);
		frame(&f, 1e-4f);
		put(&f, 3, 0.5f, 0, 0);
		put(&f, 7, 1, 0, 0);
		f.cloth.settings.passes = cases[i].passes;
		f.cloth.link_count = 1;
		f.cloth.link[0] = (struct cloth_link){(uint16_t)cases[i].a,
			(uint16_t)cases[i].b, 0.25f, cases[i].stiffness};
		frame(&f, 1e-4f);
		assert_near(
			f.cloth.position[cases[i].a][0], cases[i].x[0], 1e-6);
		assert_near(
			f.cloth.position[cases[i].b][0], cases[i].x[1], 1e-6);
		assert_near(f.cloth.position[cases[i].b][1], 0, 1e-6);
		tear_down(&f);
	}
}

static void test_ends_at_one_place_have_no_direction(void **state)
{
	static const float apart[4] = {0, 0.5e-9f, 1e-9f, 2e-9f};
	static const double end[4] = {0, 0, 0, 0.125};

	(void)state;
	for (int i = 0; i < 4; i++) {
		struct fixture f;

		set_up(&f);
		frame(&f, 1e-4f);
		put(&f, 3, 0, 0, 0);
		put(&f, 6, apart[i], 0, 0);
		f.cloth.settings.passes = 1;
		f.cloth.link_count = 1;
		f.cloth.link[0] = (struct cloth_link){3, 6, 0.25f, 1};
		frame(&f, 1e-4f);
		assert_near(f.cloth.position[3][0], -end[i], 1e-6);
		assert_near(f.cloth.position[6][0], end[i], 1e-6);
		tear_down(&f);
	}
}

/* A column may become longer by 2%, also where a capsule pushes it. */
static void test_no_particle_leaves_its_columns_reach(void **state)
{
	const struct capsule_world ball = {{1, -3, 0}, {1, -3, 0}, 0.5f};
	struct fixture f;

	(void)state;
	set_up(&f);
	frame(&f, 1e-4f);
	put(&f, 3, 0, 0, 8);
	put(&f, 4, 1, 3, 4);
	put(&f, 5, 2, -2.03f, 0);
	put(&f, 6, -9, 0, 0);
	put(&f, 7, 1, -3.05f, 0);
	put(&f, 8, 8, 0, 8);
	frame(&f, 1e-4f);
	assert_at(f.cloth.position[3], 0, 0, 1.02);
	assert_at(f.cloth.position[4], 1, 0.918, 1.224);
	assert_at(f.cloth.position[5], 2, -2.03, 0);
	assert_at(f.cloth.position[6], -2.04, 0, 0);
	assert_at(f.cloth.position[7], 1, -3.05, 0);
	assert_at(f.cloth.position[8], 2 + 4.08 * 0.6, 0, 4.08 * 0.8);
	put(&f, 7, 1, -3.05f, 0);
	f.cloth.settings.radius = 0.25f;
	memset(f.cloth.velocity, 0, COUNT * sizeof(*f.cloth.velocity));
	cloth_update(&f.cloth, 1e-4f, &ball, 1, (const mat4 *)f.world);
	assert_at(f.cloth.position[7], 1, -3.06, 0);
	tear_down(&f);
}

/* The last column is 4 long: a jump is further than 16. */
static void test_only_a_far_jump_begins_anew(void **state)
{
	static const struct {
		float x, y;
		bool anew;
	} cases[] = {{16, 0, false}, {16.01f, 0, true}, {0, -15.9f, false},
		{0, -16.1f, true}, {12, 11, true}, {NAN, 0, true}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct fixture f;
		float x = cases[i].x, y = cases[i].y;

		set_up(&f);
		frame(&f, 0.008f);
		f.cloth.settings.fastest = 1;
		f.world[0][3][0] = x;
		f.world[0][3][1] = y;
		frame(&f, 0.008f);
		assert_int_equal(vec_length(f.cloth.velocity[8]) == 0 ||
				isnan(f.cloth.position[8][0]),
			cases[i].anew);
		if (cases[i].anew && !isnan(x)) {
			for (int p = 0; p < COUNT; p++) {
				assert_at(f.cloth.position[p],
					(double)(SHAPE[p][0] + x),
					(double)(SHAPE[p][1] + y), 0);
			}
		}
		tear_down(&f);
	}
}

static void test_a_reset_begins_anew_without_motion(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	frame(&f, 0.008f);
	f.cloth.velocity[8][2] = 9;
	put(&f, 7, 1, -1, 1);
	cloth_reset(&f.cloth);
	f.world[0][3][1] = 5;
	frame(&f, 0.1f);
	for (int p = 0; p < COUNT; p++) {
		assert_at(f.cloth.position[p], (double)SHAPE[p][0],
			(double)SHAPE[p][1] + 5, 0);
	}
	tear_down(&f);
}

/* Pins move evenly during a step: it is worth its parts, step after step. */
static void test_a_step_is_worth_its_parts(void **state)
{
	struct fixture whole, parts;

	(void)state;
	set_up(&whole);
	set_up(&parts);
	whole.cloth.settings.passes = parts.cloth.settings.passes = 2;
	frame(&whole, 0.008f);
	frame(&parts, 0.008f);
	for (int i = 1; i <= 12; i++) {
		float t = (float)i;

		parts.world[0][3][0] = 0.1f * t;
		parts.world[0][3][1] = -0.05f * t;
		parts.world[0][3][2] = 0.025f * t;
		frame(&parts, 0.008f);
		if (i % 6 == 0) {
			memcpy(whole.world, parts.world, sizeof(whole.world));
			frame(&whole, 0.048f);
		}
	}
	assert_all_near(
		whole.cloth.position, parts.cloth.position, 3 * COUNT, 1e-4);
	for (int c = 0; c < SIDE; c++) {
		assert_at(whole.cloth.position[c], 1.2 + c, -0.6, 0.3);
	}
	tear_down(&whole);
	tear_down(&parts);
}

/* The slopes of a bumpy sheet to the right and down, at edges one-sided. */
static void test_normals_follow_the_slopes(void **state)
{
	static const float height[COUNT] = {
		0, 0.1f, 0.4f, 0.2f, 0.6f, 0.3f, 0.5f, 0.7f, 0};
	static const float right[COUNT] = {
		0.1f, 0.2f, 0.3f, 0.4f, 0.05f, -0.3f, 0.2f, -0.25f, -0.7f};
	static const float down[COUNT] = {
		0.2f, 0.5f, -0.1f, 0.25f, 0.3f, -0.2f, 0.3f, 0.1f, -0.3f};
	struct fixture f;

	(void)state;
	set_up(&f);
	frame(&f, 1e-4f);
	for (int i = 0; i < COUNT; i++) {
		f.cloth.hang[i] = 9;
		f.cloth.offset[i][0] = (float)(i % SIDE);
		f.cloth.offset[i][1] = -(float)(i / SIDE);
		f.cloth.offset[i][2] = height[i];
	}
	cloth_reset(&f.cloth);
	frame(&f, 1e-4f);
	for (int i = 0; i < COUNT; i++) {
		float want[3] = {-right[i], down[i], 1};

		vec_normalize(want);
		assert_all_near(f.cloth.normal[i], want, 3, 1e-5);
	}
	/* They are those of the end of a step. */
	put(&f, 7, 1, -2, 2.1f);
	frame(&f, 1e-4f);
	assert_near(f.cloth.normal[4][1] / f.cloth.normal[4][2], 1, 1e-3);
	/* Where there is no area, the last normal stays. */
	memset(f.cloth.offset, 0, COUNT * sizeof(*f.cloth.offset));
	cloth_reset(&f.cloth);
	frame(&f, 1e-4f);
	assert_near(vec_length(f.cloth.normal[4]), 1, 1e-5);
	assert_true(f.cloth.normal[4][1] > 0.2f);
	tear_down(&f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_steps_are_divided_into_parts),
		cmocka_unit_test(test_all_but_the_pins_fall),
		cmocka_unit_test(test_wind_pulls_along_the_normal_alone),
		cmocka_unit_test(test_speed_is_limited_but_not_its_direction),
		cmocka_unit_test(test_links_draw_their_ends_together),
		cmocka_unit_test(test_ends_at_one_place_have_no_direction),
		cmocka_unit_test(test_no_particle_leaves_its_columns_reach),
		cmocka_unit_test(test_only_a_far_jump_begins_anew),
		cmocka_unit_test(test_a_reset_begins_anew_without_motion),
		cmocka_unit_test(test_a_step_is_worth_its_parts),
		cmocka_unit_test(test_normals_follow_the_slopes),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
