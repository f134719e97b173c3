/* Which clips of a board of two metres stand, walk and run, and how it climbs. */
#include "app/character/motions/motions.h"
#include "tests/support/files.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	CLIPS = 18
};

/*
 * A clip that takes the board along x and z, and up, and turns it about x. What
 * goes by up to 0.3 m is not carried away.
 */
struct way {
	const char *name;
	float x, z, duration_s;
	float middle_y, end_y;
	float turn_rad;
};

struct fixture {
	struct log log;
	struct model *model;
	struct instance *instance;
	struct model_clip clip[CLIPS];
	struct model_channel channel[CLIPS][2];
	float time_s[CLIPS][3], value[CLIPS][9], turn[CLIPS][12];
};

static void begin(struct fixture *f, const struct way *way, int count)
{
	memset(f, 0, sizeof(*f));
	f->log = log_to_stderr(LOG_WARNING);
	f->model = small_model_grid(1, 1, 2, true);
	for (int v = 0; v < 4; v++) {
		f->model->mesh[0].primitive->position[v][0] = 0;
	}
	for (int i = 0; i < count; i++) {
		const struct way *one = &way[i];
		const float half_rad = 0.5f * one->turn_rad;
		const float value[9] = {0, 0, 0, 0.5f * one->x, one->middle_y,
			0.5f * one->z, one->x, one->end_y, one->z};
		const float turn[12] = {0, 0, 0, 1, sinf(0.5f * half_rad), 0, 0,
			cosf(0.5f * half_rad), sinf(half_rad), 0, 0,
			cosf(half_rad)};

		memcpy(f->value[i], value, sizeof(value));
		memcpy(f->turn[i], turn, sizeof(turn));
		f->time_s[i][1] = 0.5f * one->duration_s;
		f->time_s[i][2] = one->duration_s;
		for (int k = 0; k < 2; k++) {
			f->channel[i][k] = (struct model_channel){
				.path = k ? MODEL_ROTATION : MODEL_TRANSLATION,
				.interpolation = MODEL_LINEAR,
				.width = k ? 4 : 3,
				.key_count = 3,
				.time_s = f->time_s[i],
				.value = k ? f->turn[i] : f->value[i]};
		}
		f->clip[i] = (struct model_clip){.name = one->name,
			.duration_s = one->duration_s,
			.channel_count = 2,
			.channel = f->channel[i]};
	}
	f->model->clip = f->clip;
	f->model->clip_count = count;
	f->instance = small_model_instance(f->model);
	f->instance->unit_scale = 1;
}

static void end(struct fixture *f)
{
	instance_destroy(f->instance);
	f->model->clip_count = 0;
	model_destroy(f->model);
}

static struct motions find(struct fixture *f, const char *clip)
{
	const struct character_request request = {
		.model_path = "board.glb", .file = "none", .clip = clip};
	struct motions motions;

	assert_int_equal(
		motions_find(&request, f->instance, &f->log, &motions), 0);
	/* It is left at rest. */
	assert_near(f->instance->pose.local[0].translation[0], 0, 0);
	assert_near(f->instance->world[0][3][0], 0, 0);
	assert_near(f->instance->world[0][3][2], 0, 0);
	return motions;
}

#define STAND(name)                    \
	{                              \
		name, 0, 0, 1, 0, 0, 0 \
	}
#define MOMENT(name)                   \
	{                              \
		name, 0, 0, 0, 0, 0, 0 \
	}
#define SLOW(name)                             \
	{                                      \
		name, 0, -0.15f, 0.5f, 0, 0, 0 \
	}
#define FAST(name)                             \
	{                                      \
		name, 0, -0.18f, 0.3f, 0, 0, 0 \
	}
#define TIP(name)                            \
	{                                    \
		name, 0, 0, 0.5f, 0, 0, 0.3f \
	}
#define FALL(name)                                \
	{                                         \
		name, -0.25f, 0, 0.5f, 0, 0, 0.3f \
	}

static void test_names_come_first_then_speeds_and_last_what_ends(void **state)
{
	static const struct {
		struct way way[4];
		int count, role[MOTION_ROLES]; /* stand, walk, run */
	} rows[] = {
		{{SLOW("a"), FAST("b"), STAND("c")}, 3, {2, 0, 1}},
		{{FAST("a"), SLOW("b"), STAND("c")}, 3, {2, 1, 0}},
		/* The first of several that are equal. */
		{{SLOW("a"), SLOW("b"), FAST("c"), FAST("d")}, 4, {0, 0, 2}},
		{{SLOW("a"), SLOW("b")}, 2, {0, 0, 0}},
		{{STAND("a"), STAND("b"), SLOW("c")}, 3, {0, 2, 2}},
		/* A moment gives way to what lasts, unless that moves. */
		{{MOMENT("a"), STAND("b"), SLOW("c")}, 3, {1, 2, 2}},
		{{STAND("a"), MOMENT("b"), SLOW("c")}, 3, {0, 2, 2}},
		{{MOMENT("a"), MOMENT("b"), SLOW("c")}, 3, {0, 2, 2}},
		{{SLOW("a"), MOMENT("b")}, 2, {1, 0, 0}},
		/* With a name, no speed tells about ways. */
		{{SLOW("walk"), FAST("b"), STAND("c")}, 3, {2, 0, 0}},
		{{SLOW("run"), FAST("b"), STAND("c")}, 3, {2, 0, 0}},
		{{FAST("b"), SLOW("walk"), STAND("c")}, 3, {2, 1, 1}},
		{{FAST("idle"), SLOW("b"), FAST("c")}, 3, {0, 1, 0}},
		{{SLOW("walk"), FAST("fun"), STAND("wide")}, 3, {2, 0, 0}},
		/* Where all have names, no other clip is better. */
		{{MOMENT("idle"), SLOW("walk"), FAST("run"), STAND("d")}, 4,
			{0, 1, 2}},
		/* What cannot be repeated is better than none. */
		{{FALL("a"), FALL("b")}, 2, {0, 0, 0}},
		{{MOMENT("a"), FALL("b")}, 2, {0, 1, 1}},
		{{FALL("a"), MOMENT("b")}, 2, {1, 0, 0}},
		{{STAND("a"), FALL("b")}, 2, {0, 0, 0}},
		{{FALL("a"), STAND("b")}, 2, {1, 1, 1}},
		{{FALL("a"), SLOW("b")}, 2, {1, 1, 1}},
		{{SLOW("walk"), FALL("b")}, 2, {0, 0, 0}},
		{{SLOW("run"), FALL("b")}, 2, {0, 0, 0}},
		{{SLOW("walk"), TIP("b")}, 2, {0, 0, 0}},
		{{SLOW("run"), TIP("b")}, 2, {0, 0, 0}},
		{{TIP("a"), MOMENT("b")}, 2, {0, 0, 0}},
		{{FALL("b"), SLOW("run")}, 2, {1, 1, 1}},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct fixture f;
		struct motions motions;

		begin(&f, rows[i].way, rows[i].count);
		motions = find(&f, NULL);
		for (int role = 0; role < MOTION_ROLES; role++) {
			if (motions.role[role].clip != rows[i].role[role]) {
				fail_msg("row %zu, role %d: clip %d", i, role,
					motions.role[role].clip);
			}
		}
		assert_int_equal(motions.bone_count, 0);
		end(&f);
	}
}

/* The sixteenth is, and no other. */
static void test_sixteen_clips_are_measured(void **state)
{
	for (int walking = 14; walking < CLIPS; walking++) {
		struct way way[CLIPS];
		struct motions motions;
		struct fixture f;

		(void)state;
		for (int i = 0; i < CLIPS; i++) {
			way[i] = (struct way)STAND("a");
		}
		way[walking] = (struct way)SLOW("b");
		begin(&f, way, CLIPS);
		motions = find(&f, NULL);
		assert_int_equal(motions.role[MOTION_WALK].clip,
			walking < 16 ? walking : 0);
		end(&f);
	}
}

/* The first clip, and none at all. */
static void test_any_clip_may_be_asked_for(void **state)
{
	static const struct way way[] = {SLOW("a"), FAST("b")};
	static const char *const names[] = {"a", "b", "0", "1"};
	struct fixture f;

	(void)state;
	begin(&f, way, 2);
	for (size_t i = 0; i < ARRAY_COUNT(names); i++) {
		struct motions motions = find(&f, names[i]);

		for (int role = 0; role < MOTION_ROLES; role++) {
			assert_int_equal(motions.role[role].clip, (int)i % 2);
		}
	}
	end(&f);
	begin(&f, way, 0);
	assert_int_equal(find(&f, NULL).role[MOTION_STAND].clip, -1);
	assert_int_equal(find(&f, NULL).role[MOTION_RUN].clip, -1);
	end(&f);
}

/* In scene units, and in the direction opposite to the feet's. */
static void test_a_motion_has_its_speed_and_direction(void **state)
{
	static const struct {
		struct way way;
		float velocity[2], drift[2]; /* metres */
		bool repeats;
	} rows[] = {
		{{"walk", 0.18f, 0, 0.2f, 0, 0, 0}, {-0.9f, 0}, {0, 0}, true},
		{{"walk", 0, 0.18f, 0.2f, 0, 0, 0}, {0, -0.9f}, {0, 0}, true},
		{{"walk", -0.12f, 0.09f, 0.125f, 0, 0, 0}, {0.96f, -0.72f},
			{0, 0}, true},
		{{"walk", 0.2f, 0, 0.5f, 0, 0, 0.19f}, {-0.4f, 0}, {0, 0}, true},
		{{"walk", 0.2f, 0, 0.5f, 0, 0, 0.21f}, {-0.4f, 0}, {0, 0}, false},
		{{"walk", 0.5f, -0.75f, 1, 0, 0, 0}, {0, 0}, {0.5f, -0.75f},
			true},
		{MOMENT("walk"), {0, 0}, {0, 0}, false},
	};

	(void)state;
	for (size_t i = 0; i < 2 * ARRAY_COUNT(rows); i++) {
		const float unit = i % 2 ? 0.5f : 1;
		const float *v = rows[i / 2].velocity;
		struct motion motion;
		struct fixture f;

		begin(&f, &rows[i / 2].way, 1);
		f.instance->unit_scale = unit;
		motion = motion_of_clip(f.instance, 0);
		/* It is left at rest. */
		assert_near(f.instance->pose.local[0].translation[0], 0, 0);
		assert_near(f.instance->world[0][3][0], 0, 0);
		assert_near(f.instance->world[0][3][2], 0, 0);
		assert_int_equal(motion.clip, 0);
		assert_near(motion.speed,
			unit * sqrtf(v[0] * v[0] + v[1] * v[1]), 1e-5);
		if (motion.speed > 0) {
			assert_near(motion.facing_rad, atan2f(v[0], v[1]), 1e-5);
		}
		for (int axis = 0; axis < 2; axis++) {
			assert_near(motion.drift[axis],
				unit * rows[i / 2].drift[axis], 1e-5);
		}
		assert_int_equal(motion.repeats, rows[i / 2].repeats);
		assert_int_equal(motion.rise_steps, 0);
		/* A clip of a role's name has that speed, too. */
		for (int role = 0; role < MOTION_ROLES; role++) {
			static const char *const names[] = {
				"idle", "walk", "run"};

			f.clip[0].name = names[role];
			assert_near(find(&f, NULL).role[role].speed,
				motion.speed, 1e-6);
		}
		end(&f);
	}
}

/* At 21 even times; the box is that of the figure alone. */
static void test_a_figure_that_climbs_is_where_it_was_measured(void **state)
{
	static const struct way climb[] = {
		{"a", 0, 0, 2, 0.5f, 3, 0}, {"b", 0, 0, 2, -3, -2, 0}};

	(void)state;
	for (int i = 0; i < 2; i++) {
		const float unit = 0.5f;
		struct motion motion;
		struct bounds whole, placed;
		struct fixture f;
		float way[3];

		begin(&f, climb, 2);
		f.instance->unit_scale = unit;
		motion = motion_of_clip(f.instance, i);
		assert_int_equal(motion.rise_steps, 20);
		assert_near(motion.rise[0], 0, 0);
		assert_near(
			motion.rise[5], 0.5f * unit * climb[i].middle_y, 1e-5);
		assert_near(motion.rise[10], unit * climb[i].middle_y, 1e-5);
		assert_near(motion.rise[20], unit * climb[i].end_y, 1e-5);
		motion_drift_at(&motion, f.model, 1.03f, way);
		assert_near(way[1],
			unit *
				(climb[i].middle_y * 0.97f +
					climb[i].end_y * 0.03f),
			1e-5);
		whole = bounds_of_clip(f.instance, i);
		placed = motion_bounds(f.instance, &motion);
		assert_near(placed.low[1], whole.low[1] - (i ? -3 * unit : 0),
			1e-5);
		assert_near(placed.high[1], whole.high[1] - (i ? 0 : 3 * unit),
			1e-5);
		end(&f);
	}
}

/* Between the heights that are known, and at both ends. */
static void test_heights_are_interpolated(void **state)
{
	static const struct {
		int steps;
		float time_s, y;
	} rows[] = {{4, 0, 0}, {4, 0.25f, 0.5f}, {4, 0.5f, 1}, {4, 0.75f, 2.5f},
		{4, 1, 4}, {4, 1.25f, 3}, {4, 1.5f, 2}, {4, 1.75f, 5},
		{4, 2, 8}, {4, 3, 8}, {4, -1, 0}, {1, 1, 0.5f}, {1, 2, 1},
		{0, 1, 0}, {0, 2, 0}};
	struct model_clip clip = {.duration_s = 2};
	struct model model = {.clip = &clip, .clip_count = 1};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		const struct motion motion = {.drift = {2, -4},
			.rise_steps = rows[i].steps,
			.rise = {0, 1, 4, 2, 8, INFINITY}};
		float way[3];

		motion_drift_at(&motion, &model, rows[i].time_s, way);
		assert_near(way[1], rows[i].y, 1e-6);
	}
}

/* Up to half a metre, and down. */
static void test_a_box_leaves_out_what_a_motion_rises(void **state)
{
	static const struct way stand[] = {STAND("a")};
	struct motion motion = {
		.rise_steps = 3, .rise = {0, -0.25f, 0.1f, 0.5f}};
	struct bounds whole, placed;
	struct fixture f;

	(void)state;
	begin(&f, stand, 1);
	whole = bounds_of_clip(f.instance, 0);
	placed = motion_bounds(f.instance, &motion);
	assert_near(placed.low[1], whole.low[1] + 0.25f, 1e-6);
	assert_near(placed.high[1], whole.high[1] - 0.5f, 1e-6);
	motion.rise[3] = -0.75f;
	placed = motion_bounds(f.instance, &motion);
	assert_near(placed.low[1], whole.low[1] + 0.75f, 1e-6);
	assert_near(placed.high[1], whole.high[1] - 0.1f, 1e-6);
	end(&f);
}

/* Metres a second in the file, and scene units a second here. */
static void test_a_speed_of_the_file_is_in_metres(void **state)
{
	static const struct way walk[] = {
		{"walk", 0.18f, 0, 0.2f, 0, 0, 0}, STAND("b")};
	static const char text[] = "[parameter v]\nrange = 0 9\n"
				   "[state s]\nblend = v, b 0, walk 1\n";
	struct test_path folder = temp_dir_make();
	struct test_path file = path_join(&folder, "a.character");
	const struct character_request request = {
		.model_path = "board.glb", .file = file.text};

	(void)state;
	file_write(file.text, text, strlen(text));
	for (int half = 0; half < 2; half++) {
		const float unit = half ? 0.5f : 1;
		struct motions motions;
		struct fixture f;

		begin(&f, walk, 2);
		f.instance->unit_scale = unit;
		assert_int_equal(
			motions_find(&request, f.instance, &f.log, &motions), 0);
		assert_near(motions.role[MOTION_WALK].speed, unit, 1e-6);
		assert_int_equal(motions.role[MOTION_STAND].clip, 1);
		end(&f);
	}
	temp_dir_remove(&folder);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_names_come_first_then_speeds_and_last_what_ends),
		cmocka_unit_test(test_sixteen_clips_are_measured),
		cmocka_unit_test(test_any_clip_may_be_asked_for),
		cmocka_unit_test(test_a_motion_has_its_speed_and_direction),
		cmocka_unit_test(test_a_speed_of_the_file_is_in_metres),
		cmocka_unit_test(
			test_a_figure_that_climbs_is_where_it_was_measured),
		cmocka_unit_test(test_heights_are_interpolated),
		cmocka_unit_test(test_a_box_leaves_out_what_a_motion_rises),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
