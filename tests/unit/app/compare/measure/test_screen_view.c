/* Distances on the screen, and the shortcut that needs no projection. */
#include "app/compare/measure/screen_view.h"
#include "tests/support/model/compared_clip.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <math.h>

enum {
	TRIALS = 60000 /* enough to meet points beside the nearest corner */
};

static const struct bounds boxes[] = {
	{{-1, 0, -1}, {1, 2, 1}},
	{{-0.2f, 0, -0.1f}, {0.2f, 1.8f, 0.1f}},
	{{-5, -0.1f, -5}, {5, 0.1f, 5}},
};

static struct screen_view view_of(
	const struct bounds *box, int width, int height, float unit)
{
	struct screen_view screen = {.width = width,
		.height = height,
		.unit = unit,
		.framing = screen_view_played(box)};

	screen_view_frame(&screen, box);
	return screen;
}

static float share(uint32_t *seed)
{
	return (float)random_between(seed, 0, 1000) / 1000.0f;
}

/*
 * A point of the box or a fifth of the nearest corner's depth outside of it,
 * and one at a distance of up to the box's height.
 */
static float random_points(const struct screen_view *screen, uint32_t *seed,
	float a[3], float b[3])
{
	const struct bounds *box = &screen->box;
	float apart = 0.5f * (box->high[1] - box->low[1]) * share(seed);
	float beside = 4.0f * sqrtf(screen->near_square / 3.0f);
	float square = 0.0f;

	apart *= apart * apart; /* most are close */
	for (int i = 0; i < 3; i++) {
		float shift = apart * (2.0f * share(seed) - 1.0f);

		a[i] = box->low[i] + share(seed) * (box->high[i] - box->low[i]);
		a[i] += beside * (2.0f * share(seed) - 1.0f);
		b[i] = a[i] + shift;
		square += shift * shift;
	}
	return sqrtf(square);
}

static void expect_limit(const struct screen_view *screen)
{
	uint32_t seed = 5;
	float most = 0.0f;

	assert_true(screen->near_square > 0.0f);
	for (int trial = 0; trial < TRIALS; trial++) {
		float a[3], b[3];
		float apart = random_points(screen, &seed, a, b);
		float px = screen_view_distance_px(screen, a, b);
		float above = px * 1.01f + 1e-3f, below = px * 0.99f;

		if (apart > 1e-3f && apart * apart <= screen->near_square) {
			assert_true(px <= apart * screen->px_per_unit * 1.001f);
			most = fmaxf(most, px / apart);
		}
		assert_true(screen_view_within(screen, a, b, above,
			screen_view_near_square(screen, above)));
		if (px > 0.1f) {
			assert_false(screen_view_within(screen, a, b, below,
				screen_view_near_square(screen, below)));
		}
	}
	/* A limit that is far too large would be no shortcut. */
	assert_true(screen->px_per_unit < 5.0f * most);
}

static void test_the_shortcut_says_what_the_projection_says(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(boxes); i++) {
		struct screen_view tall = view_of(&boxes[i], 480, 640, 1.0f);
		struct screen_view wide = view_of(&boxes[i], 640, 200, 1.0f);
		struct screen_view scaled = view_of(&boxes[i], 480, 640, 0.01f);

		expect_limit(&tall);
		expect_limit(&wide);
		expect_limit(&scaled);
	}
}

static void expect_limit_of_corners(const struct screen_view *screen)
{
	const struct bounds *box = &screen->box;
	double nearest = 1e9, aside = 0.0, tangent;

	for (int corner = 0; corner < 8; corner++) {
		float point[3];
		double x, y;

		for (int k = 0; k < 3; k++) {
			point[k] = corner >> k & 1 ? box->high[k] : box->low[k];
		}
		x = (double)screen_view_eye(screen, point, 0);
		y = (double)screen_view_eye(screen, point, 1);
		aside = fmax(aside, sqrt(x * x + y * y));
		nearest = fmin(
			nearest, -(double)screen_view_eye(screen, point, 2));
	}
	tangent = (aside + 0.2 * nearest) / (0.8 * nearest);
	assert_near(screen->near_square / (nearest * nearest), 0.01, 1e-6);
	assert_near(screen->px_per_unit /
			(0.5 * (double)screen->focal_px / (0.75 * nearest) *
				sqrt(1.0 + tangent * tangent)),
		1.0, 1e-5);
}

/*
 * The corner farthest aside and the nearest one, by the formula of the limit,
 * from all sides.
 */
static void test_the_limit_is_that_of_the_corners(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(boxes); i++) {
		for (int side = 0; side < 16; side++) {
			struct screen_view screen =
				view_of(&boxes[i], 480, 640, 0.5f);

			screen.framing.yaw_rad = 0.8f * (float)(side / 2);
			screen.framing.pitch_rad = side % 2 ? 0.6f : -0.6f;
			screen_view_frame(&screen, &boxes[i]);
			expect_limit_of_corners(&screen);
		}
	}
}

/* A model in another unit looks the same. */
static void test_the_unit_of_a_model_does_not_move_its_picture(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(boxes); i++) {
		struct screen_view plain = view_of(&boxes[i], 480, 640, 1.0f);
		struct screen_view scaled = view_of(&boxes[i], 480, 640, 0.5f);
		float at[2], other[2];

		for (int corner = 0; corner < 2; corner++) {
			const float *point =
				corner ? boxes[i].high : boxes[i].low;

			screen_view_project(&plain, point, at);
			screen_view_project(&scaled, point, other);
			assert_all_near(other, at, 2, 0.5);
		}
	}
}

static struct bounds posed_box(const struct reference *reference)
{
	struct bounds box = bounds_empty();

	for (int v = 0; v < reference->vertex_count; v++) {
		bounds_add(&box, reference->position[v]);
	}
	return box;
}

static void expect_view_of_clip(const char *path)
{
	float time_s[2] = {0.0f, 0.4f};
	struct time_grid grid = {.time_s = time_s};
	struct compared_clip bench;
	struct reference *reference;

	compared_clip_begin(&bench, path, "0");
	reference = bench.reference;
	bench.model->mesh[0].primitive->position[0][0] *= 3.0f;
	for (grid.count = 1; grid.count <= 2; grid.count++) {
		struct bounds box = bounds_empty(), rest;
		struct screen_view screen =
			screen_view_create(reference, &grid, 480, 640);

		for (int i = 0; i < grid.count; i++) {
			struct bounds one;

			reference_pose(reference, time_s[i], false);
			one = posed_box(reference);
			bounds_join(&box, &one);
		}
		assert_memory_equal(&screen.box, &box, sizeof(box));
		reference_rest(reference);
		rest = posed_box(reference);
		assert_near(screen.framing.pitch_rad, camera_pitch_for(&rest),
			1e-6);
	}
	compared_clip_end(&bench);
}

/* Each vertex, at each moment, and the view that suits the pose of rest. */
static void test_the_view_of_a_clip_contains_its_vertices(void **state)
{
	(void)state;
	expect_view_of_clip("tests/fixtures/gltf/skin/and_morph.gltf");
	expect_view_of_clip("tests/fixtures/gltf/scene/ground.gltf");
}

static void test_the_box_lies_within_the_screen(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(boxes); i++) {
		struct screen_view screen = view_of(&boxes[i], 480, 640, 1.0f);
		float most[2] = {0, 0};

		for (int corner = 0; corner < 8; corner++) {
			float at[2], point[3];

			for (int k = 0; k < 3; k++) {
				point[k] = corner >> k & 1 ? boxes[i].high[k]
							   : boxes[i].low[k];
			}
			screen_view_project(&screen, point, at);
			most[0] = fmaxf(most[0], fabsf(at[0]));
			most[1] = fmaxf(most[1], fabsf(at[1]));
		}
		assert_true(most[0] <= 240.0f && most[1] <= 320.0f);
		assert_true(most[0] > 150.0f || most[1] > 200.0f);
	}
}

/*
 * limber play keeps a tenth free around what it shows, beside or above it, and
 * so do all views in which errors are measured.
 */
static void test_the_box_fills_the_screen_as_it_is_played(void **state)
{
	(void)state;
	for (size_t b = 0; b < ARRAY_COUNT(boxes); b++) {
		struct screen_view screen = view_of(&boxes[b], 480, 640, 1.0f);
		float low[2] = {1e9f, 1e9f}, high[2] = {-1e9f, -1e9f};
		float across, up;

		for (int i = 0; i < 8; i++) {
			float corner[3], at[2];

			for (int axis = 0; axis < 3; axis++) {
				corner[axis] = i >> axis & 1
					? boxes[b].high[axis]
					: boxes[b].low[axis];
			}
			screen_view_project(&screen, corner, at);
			for (int axis = 0; axis < 2; axis++) {
				low[axis] = fminf(low[axis], at[axis]);
				high[axis] = fmaxf(high[axis], at[axis]);
			}
		}
		across = (high[0] - low[0]) / 480.0f;
		up = (high[1] - low[1]) / 640.0f;
		assert_near(fmaxf(across, up), 1.0f / 1.1f, 0.02f);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_shortcut_says_what_the_projection_says),
		cmocka_unit_test(test_the_limit_is_that_of_the_corners),
		cmocka_unit_test(
			test_the_unit_of_a_model_does_not_move_its_picture),
		cmocka_unit_test(test_the_view_of_a_clip_contains_its_vertices),
		cmocka_unit_test(test_the_box_lies_within_the_screen),
		cmocka_unit_test(test_the_box_fills_the_screen_as_it_is_played),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
