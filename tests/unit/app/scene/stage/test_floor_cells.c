/*
 * Which cells of uneven ground need depths: exactly those whose picture
 * overlaps that of the content, and which slopes hide what lies on the ground.
 */
#include "app/anim/math/matrix.h"
#include "app/scene/stage/floor_mesh.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <float.h>
#include <math.h>

enum {
	WIDTH = 480,
	HEIGHT = 640,
	SCENES = 300
};

static float between(uint32_t *seed, float low, float high)
{
	return low +
		(high - low) * (float)random_between(seed, 0, 1000) / 1000.0f;
}

/* A rectangle of the picture at the distance 1. */
struct window {
	double low[2], high[2];
};

static const struct window nowhere = {{DBL_MAX, DBL_MAX}, {-DBL_MAX, -DBL_MAX}};

static void extend(struct window *window, const float eye[3])
{
	assert_true(eye[2] < 0);
	for (int axis = 0; axis < 2; axis++) {
		double at = (double)eye[axis] / (double)-eye[2];

		window->low[axis] = fmin(window->low[axis], at);
		window->high[axis] = fmax(window->high[axis], at);
	}
}

static void corner_of(const struct bounds *box, int number, float out[3])
{
	for (int axis = 0; axis < 3; axis++) {
		out[axis] =
			number >> axis & 1 ? box->high[axis] : box->low[axis];
	}
}

/* The gap between two windows; negative where they overlap. */
static double gap_of(const struct window *a, const struct window *b)
{
	double gap = -DBL_MAX;

	for (int axis = 0; axis < 2; axis++) {
		gap = fmax(gap, a->low[axis] - b->high[axis]);
		gap = fmax(gap, b->low[axis] - a->high[axis]);
	}
	return gap;
}

struct scene {
	struct camera camera;
	struct floor_mesh mesh;
	uint16_t index[FLOOR_INDICES];
	struct floor_order order;
};

static void make_scene(struct scene *scene, uint32_t *seed)
{
	const struct floor_mesh_ground ground = {
		.wave_height = 0.2f, .opaque_end = 12, .end = 20};

	scene->camera = camera_default();
	scene->camera.distance = 6;
	scene->camera.target[1] = 0.9f;
	scene->camera.pitch_rad = between(seed, 0.2f, 0.8f);
	scene->camera.yaw_rad = between(seed, 0, 6);
	floor_mesh_find(&scene->mesh, &scene->camera, WIDTH, HEIGHT, &ground);
	assert_true(scene->mesh.seen);
	floor_mesh_list(scene->index);
	for (int i = 0; i < FLOOR_VERTICES; i++) {
		scene->mesh.position[i][1] = between(seed, -0.2f, 0.2f);
	}
}

static void check_cells(struct scene *scene, const struct window *content)
{
	const struct floor_order *order = &scene->order;
	int at = 0;
	mat4 view;

	camera_view(&scene->camera, view);
	for (int r = 0; r < order->run_count; r++) {
		int end = at + order->run[r].index_count;

		for (; at < end; at += 6) {
			struct window own = nowhere;
			double gap;

			for (int i = 0; i < 6; i++) {
				float eye[3];

				matrix_apply(view,
					scene->mesh.position[order->index[at + i]],
					eye);
				extend(&own, eye);
			}
			gap = gap_of(&own, content);
			if (fabs(gap) > 1e-5) {
				assert_int_equal(
					order->run[r].with_depth, gap < 0);
			}
		}
	}
	assert_int_equal(at, FLOOR_INDICES);
}

/* What stands is given in eye space. */
static void test_cells_behind_what_stands_have_depths(void **state)
{
	uint32_t seed = 1;

	(void)state;
	for (int i = 0; i < SCENES; i++) {
		struct floor_content content = {
			.bounded = true, .lying = bounds_empty()};
		struct window window = nowhere;
		struct scene scene;

		make_scene(&scene, &seed);
		for (int axis = 0; axis < 3; axis++) {
			float at = between(&seed, -2, 2) - (axis == 2 ? 6 : 0);

			content.standing.low[axis] = at;
			content.standing.high[axis] =
				at + between(&seed, 0.1f, 2);
		}
		for (int k = 0; k < 8; k++) {
			float corner[3];

			corner_of(&content.standing, k, corner);
			extend(&window, corner);
		}
		floor_mesh_order(&scene.mesh, scene.index, &scene.camera,
			&content, &scene.order);
		check_cells(&scene, &window);
	}
}

/* What lies counts where a slope may hide a part of it. */
static void test_cells_around_what_may_be_hidden_have_depths(void **state)
{
	uint32_t seed = 2;
	int hidden = 0;

	(void)state;
	for (int i = 0; i < SCENES; i++) {
		struct floor_content content = {
			.bounded = true, .standing = bounds_empty()};
		struct window window = nowhere;
		struct scene scene;
		float eye[3];
		mat4 view;

		make_scene(&scene, &seed);
		camera_eye(&scene.camera, eye);
		camera_view(&scene.camera, view);
		for (int axis = 0; axis < 3; axis++) {
			float at = between(&seed, -1.5f, 0.5f);

			content.lying.low[axis] = at;
			content.lying.high[axis] = at + between(&seed, 0.1f, 2);
		}
		if (floor_mesh_may_hide(
			    &scene.mesh, scene.index, eye, &content.lying)) {
			for (int k = 0; k < 8; k++) {
				float corner[3];

				corner_of(&content.lying, k, corner);
				matrix_apply(view, corner, corner);
				extend(&window, corner);
			}
			hidden++;
		}
		floor_mesh_order(&scene.mesh, scene.index, &scene.camera,
			&content, &scene.order);
		check_cells(&scene, &window);
	}
	assert_in_range(hidden, SCENES / 10, SCENES * 9 / 10);
}

/* A plan from above: distances ahead of the eye, and the angle to the right. */
struct plan {
	double ahead, angle_rad;
};

static struct plan plan_of(
	const float eye[3], const double middle[2], double x, double z)
{
	double to[2] = {x - (double)eye[0], z - (double)eye[2]};
	double way[2] = {middle[0] - (double)eye[0], middle[1] - (double)eye[2]};
	double length = hypot(way[0], way[1]);

	return (struct plan){.ahead = (way[0] * to[0] + way[1] * to[1]) / length,
		.angle_rad = atan2(way[0] * to[1] - way[1] * to[0],
			way[0] * to[0] + way[1] * to[1])};
}

/* How far the three corners are beyond the box, or at one side of it. */
static double outside_by(
	const float eye[3], const struct bounds *box, const float (*corner)[3])
{
	const double middle[2] = {
		0.5 * ((double)box->low[0] + (double)box->high[0]),
		0.5 * ((double)box->low[2] + (double)box->high[2])};
	double low = DBL_MAX, high = -DBL_MAX, far = 0;
	double left = DBL_MAX, right = DBL_MAX, beyond = DBL_MAX;

	for (int i = 0; i < 4; i++) {
		struct plan plan = plan_of(eye, middle,
			(double)(i & 1 ? box->high[0] : box->low[0]),
			(double)(i & 2 ? box->high[2] : box->low[2]));

		low = fmin(low, plan.angle_rad);
		high = fmax(high, plan.angle_rad);
		far = fmax(far, plan.ahead);
	}
	for (int k = 0; k < 3; k++) {
		struct plan plan = plan_of(eye, middle, (double)corner[k][0],
			(double)corner[k][2]);

		left = fmin(left, low - plan.angle_rad);
		right = fmin(right, plan.angle_rad - high);
		beyond = fmin(beyond, plan.ahead - far);
	}
	return fmax(beyond, fmax(left, right));
}

/*
 * One slope that faces away from an eye at any side of a box: it falls so
 * steeply that its plane is above the eye.
 */
static void test_a_slope_hides_if_it_is_before_a_box_from_any_side(void **state)
{
	static const uint16_t index[FLOOR_INDICES] = {1, 2, 3};
	uint32_t seed = 3;
	int hides = 0;

	(void)state;
	for (int i = 0; i < 20 * SCENES; i++) {
		float turn = between(&seed, 0, 6.28f), corner[3][3];
		float right[2] = {cosf(turn), sinf(turn)};
		float eye[3] = {0.3f - 8 * right[1], 1, 0.4f + 8 * right[0]};
		struct bounds box = {.low = {0, 0, 0},
			.high = {between(&seed, 0.2f, 2), 0.3f,
				between(&seed, 0.2f, 2)}};
		struct floor_mesh mesh = {.seen = true,
			.position = {{300 * right[1], 0, -300 * right[0]}}};
		double by;
		bool found;

		/* Ahead of the eye, whose way is (right[1], -right[0]). */
		for (int k = 0; k < 3; k++) {
			float ahead = between(&seed, 1, 12);
			float across = between(&seed, -3, 3);

			corner[k][0] =
				eye[0] + right[1] * ahead + right[0] * across;
			corner[k][2] =
				eye[2] - right[0] * ahead + right[1] * across;
			corner[k][1] = 3 - 2 * ahead;
			for (int axis = 0; axis < 3; axis++) {
				mesh.position[1 + k][axis] = corner[k][axis];
			}
		}
		by = outside_by(eye, &box, (const float(*)[3])corner);
		found = floor_mesh_may_hide(&mesh, index, eye, &box);
		if (fabs(by) > 1e-3) {
			assert_int_equal(found, by < 0);
		}
		hides += found;
	}
	assert_in_range(hides, 5 * SCENES, 19 * SCENES);
}

/* A box around the eye, or beside it, may be hidden by anything. */
static void test_a_box_that_is_not_ahead_may_be_hidden(void **state)
{
	static const uint16_t index[FLOOR_INDICES];
	static const struct floor_mesh mesh = {
		.seen = true, .position = {{0, 0, -100}}};
	static const float eye[3] = {0, 1, 10};
	const struct bounds ahead = {{-1, 0, 8}, {1, 1, 9}};
	const struct bounds beside = {{-1, 0, 8}, {1, 1, 11}};
	const struct bounds around = {{-1, 0, 9}, {1, 1, 11}};

	(void)state;
	assert_false(floor_mesh_may_hide(&mesh, index, eye, &ahead));
	assert_true(floor_mesh_may_hide(&mesh, index, eye, &beside));
	assert_true(floor_mesh_may_hide(&mesh, index, eye, &around));
}

/* Where the picture ends before ground fades, all of it is opaque. */
static void test_ground_that_ends_near_is_all_opaque(void **state)
{
	const struct floor_mesh_ground ground = {
		.wave_height = 0.1f, .opaque_end = 12, .end = 20};
	struct camera camera = camera_default();
	struct floor_mesh mesh;

	(void)state;
	camera.distance = 5;
	camera.pitch_rad = 1.2f;
	floor_mesh_find(&mesh, &camera, WIDTH, HEIGHT, &ground);
	assert_true(mesh.seen);
	for (int i = 0; i < FLOOR_VERTICES; i++) {
		assert_int_equal(mesh.alpha[i], 255);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_cells_behind_what_stands_have_depths),
		cmocka_unit_test(
			test_cells_around_what_may_be_hidden_have_depths),
		cmocka_unit_test(
			test_a_slope_hides_if_it_is_before_a_box_from_any_side),
		cmocka_unit_test(test_a_box_that_is_not_ahead_may_be_hidden),
		cmocka_unit_test(test_ground_that_ends_near_is_all_opaque),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
