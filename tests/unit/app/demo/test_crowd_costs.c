/* What a walker of the crowd costs, by its height on the screen. */
#include "app/demo/actor.h"
#include "app/demo/demo_figures.h"
#include "app/scene/hud/hud_group.h"
#include "tests/support/model/demo_run.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
	CROWD = 50, /* the most */
	SOME = 24,
	FEW = 6,
	RATES = 3
};

static const double step_s = 0.125;

struct seen {
	const struct instance *instance;
	float height_px;
	int rate; /* frames from one pose to the next */
	uint32_t pose;
	long triangles;
};

static struct demo_base *base_of(const struct demo_run *run)
{
	return (struct demo_base *)run->demo;
}

static void press(struct demo_run *run, enum button button, int times)
{
	const struct button_event event = {.button = button, .down = true};

	for (int i = 0; i < times; i++) {
		demo_press(run->driver, run->demo, &event);
	}
}

static void step(struct demo_run *run)
{
	run->now_s += step_s;
	run->driver->update(run->demo, run->now_s);
}

static uint32_t hash(const void *bytes, size_t size)
{
	uint32_t hash = 0x811c9dc5u;

	for (size_t i = 0; i < size; i++) {
		hash = (hash ^ ((const uint8_t *)bytes)[i]) * 0x01000193u;
	}
	return hash;
}

/* Its height is the model's, at its distance from the eye. */
static void look_at(const struct demo_run *run, int number, struct seen *seen)
{
	const struct demo_base *base = base_of(run);
	const struct camera *camera = &base->stage.camera;
	struct overlay_figure figure;
	float eye[3], square = 0.0f, scale = 0.0f;

	assert_true(demo_find_figure(run->driver, run->demo, number, &figure));
	camera_eye(camera, eye);
	for (int i = 0; i < 3; i++) {
		float away = eye[i] - (i == 1 ? 0.0f : figure.place[3][i]);

		square += away * away;
		scale += figure.place[1][i] * figure.place[1][i];
	}
	seen->instance = figure.instance;
	seen->height_px = sqrtf(scale) * base->actor.extent *
		lod_px_per_unit_at(camera, sqrtf(square), base->height);
	seen->rate = seen->height_px >= 170.0f ? 1
		: seen->height_px >= 85.0f     ? 2
					       : 3;
	seen->triangles = lod_triangles(figure.instance);
	seen->pose = hash(figure.instance->pose.local,
		(size_t)figure.instance->model->node_count *
			sizeof(figure.instance->pose.local[0]));
}

static bool is_near_a_bound(float height_px)
{
	static const float bounds_px[] = {64.0f, 85.0f, 160.0f, 170.0f, 240.0f};

	for (size_t i = 0; i < ARRAY_COUNT(bounds_px); i++) {
		if (fabsf(height_px - bounds_px[i]) < 0.01f) {
			return true;
		}
	}
	return false;
}

/* Fewer triangles the smaller it is; exactly those that lod.h chooses. */
static void expect_triangles(
	const struct demo_run *run, const struct seen *seen, struct lod lod)
{
	struct instance *instance = (struct instance *)seen->instance;
	float px = seen->height_px / base_of(run)->actor.extent;
	long shown = lod_triangles(instance);

	assert_true(instance->lod_px_per_unit < 1.11f * px);
	assert_true(instance->lod_px_per_unit > px / 1.11f);
	lod_choose(instance, &lod, instance->lod_px_per_unit);
	assert_int_equal(lod_triangles(instance), shown);
}

static struct lod error_of(float px)
{
	return (struct lod){.kind = LOD_ERROR, .error_px = px};
}

/* A crowd of this number, whose camera has come to its place. */
static void begin(struct demo_run *run, int count)
{
	demo_run_begin(run, "crowd");
	press(run, BUTTON_LEFT, 3);
	press(run, BUTTON_UP, count - 1);
	run->driver->update(run->demo, run->now_s += 10.0);
}

/* Sizes of pictures in which the walkers appear as small and as large as needed. */
static const int heights[] = {400, 700, 1300};

static void look_at_all(
	const struct demo_run *run, int count, struct seen seen[CROWD])
{
	for (int i = 0; i < count; i++) {
		look_at(run, i, &seen[i]);
	}
}

/* The first update was frame 0. */
static void test_small_walkers_are_posed_in_every_second_or_third_frame(
	void **state)
{
	struct seen before[CROWD], now[CROWD];
	int at_rate[1 + RATES] = {0}, frame = 1;
	struct demo_run run;

	(void)state;
	begin(&run, SOME);
	for (size_t k = 0; k < ARRAY_COUNT(heights); k++) {
		actor_reframe_stage(base_of(&run), heights[k], heights[k]);
		step(&run);
		look_at_all(&run, SOME, before);
		for (int last = frame++ + 6; frame <= last; frame++) {
			step(&run);
			look_at_all(&run, SOME, now);
			for (int i = 0; i < SOME; i++) {
				if (!is_near_a_bound(now[i].height_px)) {
					bool due =
						(frame + i) % now[i].rate == 0;

					/* A finer level needs a pose, too. */
					assert_true(now[i].triangles >
							before[i].triangles ||
						(now[i].pose !=
							before[i].pose) == due);
					at_rate[now[i].rate]++;
				}
			}
			memcpy(before, now, sizeof(now));
		}
	}
	for (int rate = 1; rate <= RATES; rate++) {
		assert_true(at_rate[rate] > SOME);
	}
	demo_run_end(&run);
}

/* The picture's height in which the first walker is barely smaller than this. */
static int height_below(const struct demo_run *run, float px)
{
	struct seen first;

	look_at(run, 0, &first);
	return (int)((float)base_of(run)->height * px / first.height_px);
}

/* Each walker is posed within three frames, here at the same time. */
static void expect_costs(struct demo_run *run, int (*cap_of)(float height_px),
	struct lod (*lod_of)(float height_px))
{
	static const float bounds_px[] = {85.0f, 170.0f, 240.0f};

	for (size_t k = 0; k < 2 * ARRAY_COUNT(bounds_px); k++) {
		int height = height_below(run, bounds_px[k / 2]) + (int)(k % 2);
		struct seen seen[CROWD];

		actor_reframe_stage(base_of(run), height, height);
		for (int i = 0; i < RATES; i++) {
			run->driver->update(run->demo, run->now_s);
		}
		look_at_all(run, FEW, seen);
		assert_near(seen[0].height_px, bounds_px[k / 2], 0.5);
		for (int i = 0; i < FEW; i++) {
			const float height_px = seen[i].height_px;

			if (!is_near_a_bound(height_px)) {
				expect_triangles(
					run, &seen[i], lod_of(height_px));
				assert_int_equal(
					seen[i].instance->max_influences,
					cap_of(height_px));
			}
		}
		step(run);
	}
}

static struct lod lod_by_height(float height_px)
{
	return height_px < 170.0f    ? error_of(4.0f)
		: height_px < 240.0f ? error_of(2.0f)
				     : (struct lod){.kind = LOD_AUTO};
}

static struct lod lod_of_3_px(float height_px)
{
	return error_of(height_px < 170.0f ? 4.0f : 3.0f);
}

static struct lod all_triangles(float height_px)
{
	(void)height_px;
	return (struct lod){.kind = LOD_ALL};
}

static int one(float height_px)
{
	(void)height_px;
	return 1;
}

static int three(float height_px)
{
	(void)height_px;
	return 3;
}

static int all(float height_px)
{
	(void)height_px;
	return 0;
}

static void test_small_walkers_have_fewer_triangles_and_influences(void **state)
{
	const struct demo_reduction reduction = {
		.error_px = 3.0f, .max_influences = 1};
	struct demo_run run;
	struct demo_base *base;

	(void)state;
	begin(&run, FEW);
	base = base_of(&run);
	expect_costs(&run, influence_cap_for_height, lod_by_height);
	/* --influences 3 says how many; the budget may still allow less. */
	base->actor.influence_cap =
		(struct influence_cap){INFLUENCE_CAP_FIXED, 3};
	expect_costs(&run, three, lod_by_height);
	base->actor.influence_cap.value = 0;
	demo_set_reduction(run.demo, &reduction);
	expect_costs(&run, one, lod_of_3_px);
	demo_set_reduction(run.demo, &(struct demo_reduction){0});
	press(&run, BUTTON_F8, 1);
	expect_costs(&run, all, all_triangles);
	demo_run_end(&run);
}

static void expect_label(
	const struct demo_run *run, const char *title, const int at_rate[RATES])
{
	static const char *const names[] = {"full rate", "half rate", "a third"};
	static struct hud shown, wanted;
	struct hud *const both[] = {&shown, &wanted};
	int count = at_rate[0] + at_rate[1] + at_rate[2];
	struct hud_group group;

	for (int i = 0; i < 2; i++) {
		both[i]->font = &font_default;
		hud_begin(both[i], 480, 640);
	}
	run->driver->label(run->demo, &shown);
	group = hud_group_begin(&wanted, HUD_TOP_LEFT, title);
	for (int i = 0; i < RATES; i++) {
		char text[16];

		snprintf(text, sizeof(text), "%d", at_rate[i]);
		if (at_rate[i] > 0) {
			hud_group_bar(&group, names[i], text,
				(float)at_rate[i] / (float)count,
				hud_color_blue);
		}
	}
	hud_group_end(&group);
	assert_int_equal(shown.quad_count, wanted.quad_count);
	assert_memory_equal(shown.vertex, wanted.vertex,
		(size_t)shown.quad_count * 4 * sizeof(shown.vertex[0]));
}

static void test_labels_count_the_walkers_at_each_rate(void **state)
{
	struct demo_run run;

	(void)state;
	begin(&run, 1);
	press(&run, BUTTON_RIGHT, 12);
	for (size_t k = 0; k < ARRAY_COUNT(heights); k++) {
		int at_rate[RATES] = {0};
		struct seen seen[CROWD];

		actor_reframe_stage(base_of(&run), heights[k], heights[k]);
		step(&run);
		look_at_all(&run, CROWD, seen);
		for (int i = 0; i < CROWD; i++) {
			at_rate[seen[i].rate - 1]++;
		}
		expect_label(&run, "50 walkers", at_rate);
	}
	press(&run, BUTTON_F8, 1);
	step(&run);
	demo_set_rate(run.demo, 24.6f);
	expect_label(&run, "50 walkers, 25 fps", (const int[]){CROWD, 0, 0});
	/* There is always one left. */
	press(&run, BUTTON_LEFT, 12);
	step(&run);
	demo_set_rate(run.demo, 0.0f);
	expect_label(&run, "1 walker", (const int[]){1, 0, 0});
	demo_run_end(&run);
}

/* The rest of its way shrinks by e^-3 in a second. */
static void test_the_camera_eases_to_a_larger_crowd(void **state)
{
	struct demo_run run;
	float distance[4], radius[4];

	(void)state;
	begin(&run, 1);
	press(&run, BUTTON_UP, 11);
	for (int i = 0; i < 4; i++) {
		const struct camera *camera = &base_of(&run)->stage.camera;

		distance[i] = camera->distance;
		radius[i] = camera->radius;
		step(&run);
	}
	for (int i = 0; i < 2; i++) {
		float rest = expf(-3.0f * (float)step_s);

		assert_true(distance[i + 1] > distance[i] + 0.1f);
		assert_near((distance[i + 2] - distance[i + 1]) /
				(distance[i + 1] - distance[i]),
			rest, 1e-3);
		assert_near((radius[i + 2] - radius[i + 1]) /
				(radius[i + 1] - radius[i]),
			rest, 1e-3);
	}
	demo_run_end(&run);
}

/* In its own part of it, and faster for a smaller walker. */
static void test_each_walker_plays_its_clip_in_its_own_size(void **state)
{
	struct overlay_motion motion = overlay_motion_none();
	struct overlay_figure figure;
	const struct model_clip *clip;
	const struct model *model;
	struct demo_run run;

	(void)state;
	begin(&run, 1);
	for (int i = 0; i < 3; i++) {
		/* What the actor plays, the overlays show. */
		((struct demo_base *)run.demo)->actor.interpolation =
			i ? CLIP_STEP : CLIP_AUTO;
		step(&run);
		run.driver->get_motion(run.demo, &motion);
		assert_int_equal(
			motion.interpolation, i ? CLIP_STEP : CLIP_AUTO);
		assert_true(demo_find_figure(run.driver, run.demo, 0, &figure));
		assert_false(demo_find_figure(run.driver, run.demo, 1, &figure));
		model = base_of(&run)->actor.model;
		clip = &model->clip[motion.clip];
		assert_string_equal(clip->name, "wave");
		/* The first of twelve sizes, at the clip's begin. */
		assert_near(motion.time_s,
			fmod(run.now_s / (0.90 + 0.18 * 7.0 / 11.0),
				(double)clip->duration_s),
			1e-4);
	}
	assert_near(run.driver->period_s(run.demo), 8.0, 0.0);
	demo_run_end(&run);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_small_walkers_are_posed_in_every_second_or_third_frame),
		cmocka_unit_test(
			test_small_walkers_have_fewer_triangles_and_influences),
		cmocka_unit_test(test_labels_count_the_walkers_at_each_rate),
		cmocka_unit_test(test_the_camera_eases_to_a_larger_crowd),
		cmocka_unit_test(test_each_walker_plays_its_clip_in_its_own_size),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
