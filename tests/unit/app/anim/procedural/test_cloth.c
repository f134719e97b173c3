#include "app/anim/math/vec.h"
#include "app/anim/procedural/cloth.h"
#include "platform/base/scalar.h"
#include "tests/support/model/bones.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <string.h>

enum {
	LEFT,
	RIGHT,
	SIDE_MAX = 8
};

/* A cape between two shoulders, hanging down behind them from (0, 1.5, 0). */
struct fixture {
	struct bones bones;
	struct cloth_settings settings;
	struct cloth cloth;
	float shape[SIDE_MAX * SIDE_MAX][3];
};

static const float SPACING = 0.1f;

static void set_up(struct fixture *f, int columns, int rows)
{
	int pin[SIDE_MAX];

	bones_begin(&f->bones);
	bones_add(&f->bones, -1, -0.2f, 1.5f, 0);
	bones_add(&f->bones, -1, 0.2f, 1.5f, 0);
	bones_pose(&f->bones);
	f->settings = cloth_settings_default();
	f->settings.columns = columns;
	f->settings.rows = rows;
	for (int i = 0; i < columns * rows; i++) {
		float column = (float)(i % columns);

		f->shape[i][0] =
			SPACING * (column - 0.5f * (float)(columns - 1));
		f->shape[i][1] = 1.5f - SPACING * (float)(i / columns);
		f->shape[i][2] = -0.05f;
	}
	for (int c = 0; c < columns; c++) {
		pin[c] = 2 * c < columns ? LEFT : RIGHT;
	}
	assert_int_equal(
		cloth_init(&f->cloth, &f->settings, (const float(*)[3])f->shape,
			pin, (const mat4 *)f->bones.world, &f->bones.model.arena),
		0);
}

static void tear_down(struct fixture *f)
{
	bones_end(&f->bones);
}

static void frame(struct fixture *f, float step_s)
{
	bones_update(&f->bones);
	cloth_update(&f->cloth, step_s, NULL, 0, (const mat4 *)f->bones.world);
}

static double apart(const struct cloth *cloth, int a, int b)
{
	float offset[3];

	vec_subtract(cloth->position[b], cloth->position[a], offset);
	return (double)vec_length(offset);
}

static void test_links_are_what_the_grid_has(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, 3, 4);
	/* Across 2*4, down 3*3, diagonals 2*2*3, to the second 1*4 + 3*2. */
	assert_int_equal(f.cloth.link_count, 8 + 9 + 12 + 10);
	for (int l = 0; l < f.cloth.link_count; l++) {
		const struct cloth_link *link = &f.cloth.link[l];

		assert_true(link->a < 12 && link->b < 12);
		assert_near(
			link->length, apart(&f.cloth, link->a, link->b), 1e-6);
	}
	assert_near(f.cloth.hang[11], 0.3, 1e-6);
	assert_near(f.cloth.hang[0], 0, 0);
	tear_down(&f);
}

static void test_it_begins_in_its_shape(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, 4, 5);
	memset(f.settings.gravity, 0, sizeof(f.settings.gravity));
	f.cloth.settings = f.settings;
	frame(&f, 0.016f);
	assert_all_near(f.cloth.position, f.shape, 60, 1e-5);
	tear_down(&f);
}

static void test_hanging_it_stays_in_its_shape(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, 4, 5);
	for (int i = 0; i < 300; i++) {
		frame(&f, 0.016f);
	}
	/* Gravity stretches it, but no more than 2%. */
	assert_all_near(f.cloth.position, f.shape, 60, 0.012);
	for (int i = 0; i < 20; i++) {
		assert_near(f.cloth.velocity[i][1], 0, 0.02);
	}
	tear_down(&f);
}

static void test_pins_follow_their_nodes(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, 4, 5);
	frame(&f, 0.016f);
	for (int i = 0; i < 50; i++) {
		f.bones.pose.local[LEFT].translation[2] -= 0.01f;
		f.bones.pose.local[RIGHT].translation[2] -= 0.01f;
		frame(&f, 0.016f);
		for (int c = 0; c < 4; c++) {
			assert_near(f.cloth.position[c][2],
				-0.05 - 0.01 * (i + 1), 1e-4);
		}
	}
	/* The lower end lags behind the pins, then follows. */
	assert_true(f.cloth.position[17][2] > -0.5f);
	for (int i = 0; i < 600; i++) {
		frame(&f, 0.016f);
	}
	assert_near(f.cloth.position[17][2], -0.55, 0.01);
	tear_down(&f);
}

static void test_turned_nodes_turn_the_pins(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, 4, 5);
	/* 180 degrees about y swap the sides and put the cape in front. */
	f.bones.pose.local[LEFT].rotation[1] = 1;
	f.bones.pose.local[LEFT].rotation[3] = 0;
	frame(&f, 0.016f);
	assert_near(f.cloth.position[0][0], -0.25, 1e-5);
	assert_near(f.cloth.position[0][2], 0.05, 1e-5);
	tear_down(&f);
}

static void test_wind_blows_it_out(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, 4, 5);
	f.cloth.settings.wind[2] = -6;
	for (int i = 0; i < 200; i++) {
		frame(&f, 0.016f);
	}
	assert_true(f.cloth.position[17][2] < -0.2f);
	assert_true(f.cloth.position[17][1] > 1.12f);
	tear_down(&f);
}

static void test_it_keeps_out_of_capsules(void **state)
{
	struct fixture f;
	/* A capsule right under the pins. */
	const struct capsule_world body = {
		{0, 1.35f, -0.1f}, {0, 0.8f, -0.1f}, 0.12f};

	(void)state;
	set_up(&f, 4, 6);
	for (int i = 0; i < 300; i++) {
		bones_update(&f.bones);
		cloth_update(&f.cloth, 0.016f, &body, 1,
			(const mat4 *)f.bones.world);
	}
	for (int i = 8; i < 24; i++) {
		float point[3];

		memcpy(point, f.cloth.position[i], sizeof(point));
		/* The length takes precedence: a millimetre of overlap is left. */
		assert_false(
			capsule_push(&body, f.settings.radius - 1e-3f, point));
	}
	tear_down(&f);
}

/* What a frame makes of a link whose end was pulled away by a quarter. */
struct pull {
	double moved; /* how far the other end followed */
	double left;  /* of the quarter */
};

static struct pull pull(int number, bool at_a)
{
	struct fixture f;
	const struct cloth_link *link;
	float before[3], offset[3], *pulled;
	struct pull pull;
	int other;

	set_up(&f, 4, 4);
	memset(f.cloth.settings.gravity, 0, sizeof(f.cloth.settings.gravity));
	frame(&f, 0.016f);
	link = &f.cloth.link[number];
	other = at_a ? link->b : link->a;
	pulled = f.cloth.position[at_a ? link->a : link->b];
	memcpy(before, f.cloth.position[other], sizeof(before));
	vec_subtract(pulled, before, offset);
	vec_add_scaled(pulled, offset, 0.25f, pulled);
	frame(&f, 1e-4f);
	vec_subtract(f.cloth.position[other], before, offset);
	pull.moved = (double)vec_length(offset);
	pull.left =
		apart(&f.cloth, link->a, link->b) / (double)link->length - 1.0;
	tear_down(&f);
	return pull;
}

/* Pins do not move. What hangs from one is drawn back to it before others. */
static void test_each_link_pulls_at_all_but_pins(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, 4, 4);
	for (int l = 0; l < f.cloth.link_count; l++) {
		const struct cloth_link *link = &f.cloth.link[l];
		bool both_free = link->a >= 4 && link->b >= 4;
		struct pull low = pull(l, false), high = pull(l, true);

		assert_int_equal(low.moved > 1e-4, both_free);
		assert_true(low.left < 0.15);
		if (link->a % 4 != link->b % 4) {
			assert_int_equal(high.moved > 1e-4, both_free);
		}
	}
	tear_down(&f);
}

static void test_it_does_not_stretch(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, 5, 6);
	for (int i = 0; i < 500; i++) {
		float turn = 0.3f * (float)i;

		f.bones.pose.local[LEFT].translation[0] =
			-0.2f + 0.4f * scalar_sin(turn);
		f.bones.pose.local[RIGHT].translation[0] =
			0.2f + 0.4f * scalar_sin(turn);
		frame(&f, 0.016f);
		for (int p = 5; p < 30; p++) {
			assert_true(apart(&f.cloth, p, p % 5) <
				(double)f.cloth.hang[p] * 1.021);
		}
	}
	tear_down(&f);
}

static void test_normals_are_unit_and_face_back(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, 4, 5);
	frame(&f, 0.016f);
	for (int i = 0; i < 20; i++) {
		/* Columns run to +X and rows down, so normals point to +Z. */
		assert_near(f.cloth.normal[i][2], 1, 1e-3);
	}
	f.cloth.settings.wind[2] = -9;
	for (int n = 0; n < 100; n++) {
		frame(&f, 0.016f);
	}
	for (int i = 0; i < 20; i++) {
		assert_near(vec_length(f.cloth.normal[i]), 1, 1e-5);
	}
	tear_down(&f);
}

static void test_triangles_face_where_normals_point(void **state)
{
	struct fixture f;
	uint16_t index[6 * 3 * 4];

	(void)state;
	set_up(&f, 4, 5);
	assert_int_equal(cloth_triangles(&f.settings, index), 72);
	for (int t = 0; t < 72; t += 3) {
		float u[3], v[3], normal[3];

		vec_subtract(f.shape[index[t + 1]], f.shape[index[t]], u);
		vec_subtract(f.shape[index[t + 2]], f.shape[index[t]], v);
		vec_cross(u, v, normal);
		assert_true(normal[2] > 0);
	}
	tear_down(&f);
}

static void test_a_jump_begins_anew(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, 4, 5);
	for (int i = 0; i < 20; i++) {
		frame(&f, 0.016f);
	}
	f.bones.pose.local[LEFT].translation[0] += 50;
	f.bones.pose.local[RIGHT].translation[0] += 50;
	frame(&f, 0.016f);
	for (int i = 0; i < 20; i++) {
		assert_near(f.cloth.position[i][0], f.shape[i][0] + 50, 0.01);
		assert_near(f.cloth.position[i][1], f.shape[i][1], 0.01);
	}
	tear_down(&f);
}

/* Shoulders that move wildly, and a capsule in the cloth. */
static void throw_about(int columns, int rows, int count, float step_s)
{
	struct fixture f;
	const struct capsule_world body = {
		{0, 1.4f, -0.1f}, {0, 1, -0.1f}, 0.1f};

	set_up(&f, columns, rows);
	f.cloth.settings.passes = 2;
	f.cloth.settings.damping = 0;
	f.cloth.settings.wind[0] = 20;
	for (int i = 0; i < count; i++) {
		float *left = f.bones.pose.local[LEFT].translation;
		float *right = f.bones.pose.local[RIGHT].translation;

		left[0] = i % 3 ? -0.2f : -0.4f;
		right[1] = 1.5f + 0.1f * (float)(i % 5);
		right[2] = i % 2 ? 0.3f : -0.3f;
		bones_update(&f.bones);
		cloth_update(&f.cloth, step_s, &body, 1,
			(const mat4 *)f.bones.world);
		for (int p = 0; p < columns * rows; p++) {
			assert_true(vec_length(f.cloth.position[p]) < 4);
			assert_true(vec_length(f.cloth.velocity[p]) < 31);
		}
	}
	tear_down(&f);
}

static void test_it_stays_bounded_for_100000_steps(void **state)
{
	(void)state;
	throw_about(2, 2, 100000, 0.005f);
	throw_about(2, 2, 100000, 0.016f);
	throw_about(2, 2, 100000, 0.2f);
}

static void test_a_larger_one_stays_bounded_too(void **state)
{
	(void)state;
	throw_about(5, 6, 1000, 0.005f);
	throw_about(5, 6, 1000, 0.016f);
	throw_about(5, 6, 1000, 0.2f);
}

static void test_odd_steps_and_shapes_stay_finite(void **state)
{
	static const float steps[5] = {0, -1, NAN, 1e9f, 1e-9f};
	struct fixture f;

	(void)state;
	set_up(&f, 3, 3);
	for (int i = 0; i < 5; i++) {
		frame(&f, steps[i]);
	}
	for (int i = 0; i < 9; i++) {
		assert_true(isfinite(vec_length(f.cloth.position[i])));
	}
	/* All particles have the same position. */
	memset(f.shape, 0, sizeof(f.shape));
	assert_int_equal(
		cloth_init(&f.cloth, &f.settings, (const float(*)[3])f.shape,
			(const int[3]){LEFT, LEFT, RIGHT},
			(const mat4 *)f.bones.world, &f.bones.model.arena),
		0);
	for (int i = 0; i < 10; i++) {
		frame(&f, 0.016f);
	}
	for (int i = 0; i < 9; i++) {
		assert_true(isfinite(vec_length(f.cloth.position[i])));
		assert_true(isfinite(vec_length(f.cloth.normal[i])));
	}
	tear_down(&f);
}

static void test_sides_out_of_range_are_refused(void **state)
{
	struct fixture f;
	const int pin[2] = {LEFT, LEFT};

	(void)state;
	set_up(&f, 2, 2);
	for (int side = 0; side < 200; side += side == 1 ? 64 : 1) {
		if (side >= CLOTH_SIDE_MIN && side <= CLOTH_SIDE_MAX) {
			continue;
		}
		f.settings.rows = side;
		assert_int_equal(cloth_init(&f.cloth, &f.settings,
					 (const float(*)[3])f.shape, pin,
					 (const mat4 *)f.bones.world,
					 &f.bones.model.arena),
			-EINVAL);
	}
	tear_down(&f);
}

static void test_mirrored_nodes_hold_its_shape(void **state)
{
	static const int pin[] = {LEFT, LEFT, RIGHT, RIGHT};
	struct fixture f;

	(void)state;
	set_up(&f, 4, 5);
	f.bones.pose.local[LEFT].scale[0] = -1;
	f.bones.pose.local[RIGHT].scale[2] = -1;
	bones_update(&f.bones);
	memset(f.settings.gravity, 0, sizeof(f.settings.gravity));
	assert_int_equal(
		cloth_init(&f.cloth, &f.settings, (const float(*)[3])f.shape,
			pin, (const mat4 *)f.bones.world, &f.bones.model.arena),
		0);
	frame(&f, 0.016f);
	assert_all_near(f.cloth.position, f.shape, 60, 1e-5);
	tear_down(&f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_links_are_what_the_grid_has),
		cmocka_unit_test(test_it_begins_in_its_shape),
		cmocka_unit_test(test_hanging_it_stays_in_its_shape),
		cmocka_unit_test(test_pins_follow_their_nodes),
		cmocka_unit_test(test_turned_nodes_turn_the_pins),
		cmocka_unit_test(test_wind_blows_it_out),
		cmocka_unit_test(test_it_keeps_out_of_capsules),
		cmocka_unit_test(test_each_link_pulls_at_all_but_pins),
		cmocka_unit_test(test_it_does_not_stretch),
		cmocka_unit_test(test_normals_are_unit_and_face_back),
		cmocka_unit_test(test_triangles_face_where_normals_point),
		cmocka_unit_test(test_a_jump_begins_anew),
		cmocka_unit_test(test_it_stays_bounded_for_100000_steps),
		cmocka_unit_test(test_a_larger_one_stays_bounded_too),
		cmocka_unit_test(test_odd_steps_and_shapes_stay_finite),
		cmocka_unit_test(test_sides_out_of_range_are_refused),
		cmocka_unit_test(test_mirrored_nodes_hold_its_shape),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
