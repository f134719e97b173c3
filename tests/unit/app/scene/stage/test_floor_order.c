/* The order of uneven ground's triangles, and which of them need depths. */
#include "app/anim/math/vec.h"
#include "app/scene/stage/floor.h"
#include "platform/base/compiler.h"
#include "tests/support/random.h"
#include "tests/support/ray.h"
#include "tests/support/test.h"

enum {
	WIDTH = 480,
	HEIGHT = 640,
	SCENES = 200,
};

struct scene {
	struct floor floor;
	struct camera camera;
	struct floor_content content;
	struct floor_sight sight;
};

static float between(uint32_t *seed, float low, float high)
{
	return low +
		(high - low) * (float)random_between(seed, 0, 1000) / 1000.0f;
}

static void find_sight(struct scene *scene)
{
	floor_find_sight(&scene->floor, &scene->camera, WIDTH, HEIGHT,
		&scene->content, &scene->sight);
	assert_true(scene->sight.mesh.seen);
}

/* A figure stands somewhere on waves, or lies on higher ones seen from lower. */
static void make_scene(struct scene *scene, uint32_t *seed, bool lying)
{
	struct bounds *box =
		lying ? &scene->content.lying : &scene->content.standing;
	float at[3];

	*scene = (struct scene){
		.floor = {.radius = 6.0f,
			.tile = 1.0f,
			.wave_height = between(seed, 0.05f, 0.3f),
			.offset = {between(seed, 0.0f, 8.0f),
				between(seed, 0.0f, 8.0f)}},
		.camera = camera_default(),
		.content = {.bounded = true,
			.standing = bounds_empty(),
			.lying = bounds_empty()},
	};
	floor_mesh_list(scene->floor.index);
	scene->camera.distance = 6.0f;
	scene->camera.target[1] = 0.9f;
	scene->camera.pitch_rad = between(seed, 0.1f, 0.8f);
	if (lying) {
		scene->floor.wave_height *= 2.0f;
		scene->camera.pitch_rad *= 0.3f;
	}
	scene->camera.yaw_rad = between(seed, 0.0f, 6.0f);
	for (int axis = 0; axis < 3; axis++) {
		at[axis] = between(seed, -1.0f, 1.0f);
	}
	at[1] *= lying ? 0.3f : 1.0f;
	at[2] -= lying ? 0.0f : 6.0f;
	for (int axis = 0; axis < 3; axis++) {
		box->low[axis] = at[axis] - between(seed, 0.1f, 0.3f);
		box->high[axis] = at[axis] + between(seed, 0.1f, 0.3f);
	}
}

static void choose_point(const struct bounds *box, uint32_t *seed, float out[3])
{
	for (int axis = 0; axis < 3; axis++) {
		out[axis] = between(seed, box->low[axis], box->high[axis]);
	}
}

/* From the eye to a random point of what stands, along the view's axes. */
static void choose_ray(const struct scene *scene, uint32_t *seed, float way[3])
{
	float at[3];
	mat4 view;

	camera_view(&scene->camera, view);
	choose_point(&scene->content.standing, seed, at);
	for (int axis = 0; axis < 3; axis++) {
		way[axis] = view[axis][0] * at[0] + view[axis][1] * at[1] +
			view[axis][2] * at[2];
	}
}

/* Triangles without depths whose picture the ray is in. */
static int count_missing(const struct scene *scene, const float way[3])
{
	const struct floor_order *order = &scene->sight.order;
	const uint16_t *index = order->index;
	float eye[3];
	int missing = 0;

	camera_eye(&scene->camera, eye);
	for (int r = 0; r < order->run_count; r++) {
		const struct floor_run *run = &order->run[r];

		for (int i = 0; i < run->index_count; i += 3) {
			missing += !run->with_depth &&
				ray_meet(eye, way, scene->sight.mesh.position,
					index + i) > 0.0f;
		}
		index += run->index_count;
	}
	return missing;
}

static int count_without_depth(const struct floor_order *order)
{
	int count = 0;

	for (int r = 0; r < order->run_count; r++) {
		count += order->run[r].with_depth ? 0
						  : order->run[r].index_count;
	}
	return count / 3;
}

static void test_ground_has_depths_wherever_a_figure_stands(void **state)
{
	uint32_t seed = 1;
	struct scene scene;
	int without = 0;

	(void)state;
	for (int i = 0; i < SCENES; i++) {
		make_scene(&scene, &seed, false);
		find_sight(&scene);
		without += count_without_depth(&scene.sight.order);
		for (int k = 0; k < 30; k++) {
			float way[3];

			choose_ray(&scene, &seed, way);
			assert_int_equal(count_missing(&scene, way), 0);
		}
	}
	/* Most of the ground does without. */
	assert_true(without > SCENES * FLOOR_INDICES / 3 / 2);
}

static void test_what_lies_counts_where_hills_may_hide_it(void **state)
{
	uint32_t seed = 2;
	int found[2] = {0, 0};
	struct scene scene;

	(void)state;
	for (int i = 0; i < SCENES; i++) {
		float eye[3], way[3];
		bool may_hide;

		make_scene(&scene, &seed, true);
		find_sight(&scene);
		camera_eye(&scene.camera, eye);
		may_hide = floor_mesh_may_hide(&scene.sight.mesh,
			scene.floor.index, eye, &scene.content.lying);
		for (int k = 0; may_hide && k < 30; k++) {
			choose_point(&scene.content.lying, &seed, way);
			vec_subtract(way, eye, way);
			assert_int_equal(count_missing(&scene, way), 0);
		}
		if (!may_hide) {
			assert_int_equal(count_without_depth(&scene.sight.order),
				FLOOR_INDICES / 3);
		}
		found[may_hide]++;
	}
}

static int row_of(const uint16_t *corner)
{
	int row = FLOOR_ROWS;

	for (int i = 0; i < 3; i++) {
		int own = corner[i] / (FLOOR_COLUMNS + 1);

		row = own < row ? own : row;
	}
	return row;
}

/* Each triangle of the mesh once, far rows first, and fading ones as such. */
static void check_order(const struct scene *scene)
{
	const struct floor_order *order = &scene->sight.order;
	int listed[FLOOR_ROWS] = {0}, at = 0, last = FLOOR_ROWS - 1;
	uint64_t sum = 0;

	assert_in_range(order->run_count, 1, FLOOR_RUNS_MAX);
	assert_int_equal(order->index_count, FLOOR_INDICES);
	for (int r = 0; r < order->run_count; r++) {
		const struct floor_run *run = &order->run[r];

		for (int i = 0; i < run->index_count; i += 3, at += 3) {
			int row = row_of(order->index + at);

			assert_true(row <= last);
			assert_int_equal(run->fading, row >= FLOOR_OPAQUE_ROWS);
			last = row;
			listed[row]++;
		}
	}
	assert_int_equal(at, FLOOR_INDICES);
	for (int row = 0; row < FLOOR_ROWS; row++) {
		assert_int_equal(listed[row], 2 * FLOOR_COLUMNS);
	}
	for (int i = 0; i < FLOOR_INDICES; i += 3) {
		const uint16_t *own = order->index + i;
		const uint16_t *whole = scene->floor.index + i;

		sum += ((uint64_t)own[0] << 20 | own[1] << 10 | own[2]) *
			(uint64_t)(own[0] + 7 * own[2]);
		sum -= ((uint64_t)whole[0] << 20 | whole[1] << 10 | whole[2]) *
			(uint64_t)(whole[0] + 7 * whole[2]);
	}
	assert_true(sum == 0);
}

static void test_all_triangles_are_listed_from_far_to_near(void **state)
{
	uint32_t seed = 3;
	struct scene scene;

	(void)state;
	for (int i = 0; i < SCENES; i++) {
		make_scene(&scene, &seed, i % 2);
		find_sight(&scene);
		check_order(&scene);
	}
	scene.content.bounded = false;
	find_sight(&scene);
	check_order(&scene);
	assert_int_equal(count_without_depth(&scene.sight.order), 0);
}

/* A box that reaches behind the eye may be anywhere in the picture. */
static void test_a_figure_around_the_eye_needs_all_depths(void **state)
{
	uint32_t seed = 4;
	struct scene scene;

	(void)state;
	make_scene(&scene, &seed, false);
	scene.content.standing.high[2] = 0.5f;
	find_sight(&scene);
	assert_int_equal(count_without_depth(&scene.sight.order), 0);
}

/* A hill's far side, whose corners are at x and z, between an eye and a box. */
static void test_a_slope_hides_unless_it_is_all_beyond_or_beside(void **state)
{
	static const struct {
		float plan[3][2];
		bool hides;
	} slopes[] = {
		{{{0, -1}, {0.1f, -1}, {0.1f, -2}}, false},
		{{{0, -1}, {0.1f, -1}, {0.1f, 5}}, true},
		{{{-1, 5}, {-1, 4}, {-2, 5}}, false},
		{{{-1, 5}, {-1, 4}, {0, 5}}, true},
		{{{1, 5}, {1, 4}, {2, 5}}, false},
		{{{1, 5}, {1, 4}, {0, 5}}, true},
	};
	static const float eye[3] = {0, 1, 10};
	static const struct bounds box = {
		.low = {-0.5f, 0, -0.5f}, .high = {0.5f, 0.5f, 0.5f}};
	/* The others are one far point. */
	static const uint16_t index[FLOOR_INDICES] = {1, 2, 3};
	struct floor_mesh mesh = {.seen = true, .position = {{0, 0, -100}}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(slopes); i++) {
		for (int k = 0; k < 3; k++) {
			const float *plan = slopes[i].plan[k];

			mesh.position[1 + k][0] = plan[0];
			mesh.position[1 + k][1] = 3 * plan[1] - 15;
			mesh.position[1 + k][2] = plan[1];
		}
		assert_int_equal(floor_mesh_may_hide(&mesh, index, eye, &box),
			slopes[i].hides);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_ground_has_depths_wherever_a_figure_stands),
		cmocka_unit_test(test_what_lies_counts_where_hills_may_hide_it),
		cmocka_unit_test(test_all_triangles_are_listed_from_far_to_near),
		cmocka_unit_test(test_a_figure_around_the_eye_needs_all_depths),
		cmocka_unit_test(
			test_a_slope_hides_unless_it_is_all_beyond_or_beside),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
