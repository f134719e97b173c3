/* Where a model of any size stands in the crowd. */
#include "app/demo/crowd/crowd_figure.h"
#include "platform/base/compiler.h"
#include "platform/base/scalar.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

static void transform(mat4 matrix, const float at[3], float out[3])
{
	for (int row = 0; row < 3; row++) {
		out[row] = matrix[3][row];
		for (int k = 0; k < 3; k++) {
			out[row] += matrix[k][row] * at[k];
		}
	}
}

static const struct crowd_figure figure = {
	.scale = 0.5f, .center = {3, 1, -2}, .front_rad = 0.25f};
static const struct crowd_route route = {.size = 1.5f};
static const struct crowd_position position = {
	.x = 4, .z = 5, .yaw_rad = 1.0f, .lean_rad = 0.125f};
static const float drift[3] = {0.75f, 2, -0.5f};

static void test_the_figures_middle_stands_on_its_route(void **state)
{
	const float middle[3] = {3.75f, 3, -2.5f};
	float at[3];
	mat4 matrix;

	(void)state;
	crowd_figure_matrix(&figure, &route, &position, drift, matrix);
	transform(matrix, middle, at);
	assert_all_near(at, ((float[]){4, 0, 5}), 3, 1e-5);
}

static void test_the_figure_looks_along_its_route_in_its_size(void **state)
{
	/* A unit before its middle, where it looks. */
	const float before[3] = {3.75f + sinf(0.25f), 3, -2.5f + cosf(0.25f)};
	struct crowd_position upright = position;
	float at[3];
	mat4 matrix;

	(void)state;
	upright.lean_rad = 0;
	crowd_figure_matrix(&figure, &route, &upright, drift, matrix);
	transform(matrix, before, at);
	assert_all_near(at,
		((float[]){4 + 0.75f * sinf(1.0f), 0, 5 + 0.75f * cosf(1.0f)}),
		3, 1e-5);
}

/* Its head leans to its own left; nothing but the place has a fourth row. */
static void test_a_figure_leans_before_it_turns(void **state)
{
	const float s = 1.5f, cy = cosf(1.0f), sy = sinf(1.0f);
	const float cl = cosf(0.125f), sl = sinf(0.125f);
	const float expected[4][4] = {{s * cl * cy, s * -sl, s * -cl * sy, 0},
		{s * sl * cy, s * cl, s * -sl * sy, 0}, {s * sy, 0, s * cy, 0},
		{4, 0, 5, 1}};
	mat4 matrix;

	(void)state;
	crowd_matrix(&route, &position, matrix);
	assert_all_near(matrix, expected, 16, 1e-6);
}

/* The figure of a sloping board with these corners. */
static struct crowd_figure make_board(const float low[3], const float high[3])
{
	struct log log = log_to_stderr(LOG_ERROR);
	const struct demo_env env = {
		.log = &log, .model_path = "board.glb", .character = "none"};
	struct model *model = small_model_grid(1, 1, 1, true);
	struct model_primitive *board = model->mesh[0].primitive;
	struct actor actor = {.model = model};
	struct crowd_figure made = {0};

	for (int v = 0; v < board->vertex_count; v++) {
		float *at = board->position[v];

		at[2] = at[0];
		for (int axis = 0; axis < 3; axis++) {
			at[axis] = at[axis] > 0 ? high[axis] : low[axis];
		}
	}
	actor.instance = small_model_instance(model);
	assert_int_equal(crowd_figure_make(&made, &env, &actor), 0);
	instance_destroy(actor.instance);
	model_destroy(model);
	return made;
}

static struct crowd_figure make_wide(float left, float lowest)
{
	return make_board((float[]){left, lowest, -0.1f},
		(float[]){left + 2, lowest + 2, 0.1f});
}

/* The height of the point that stands on the route. */
static float height_of_ground(float lowest)
{
	return make_wide(-1, lowest).center[1];
}

static void test_a_figure_up_to_3_percent_off_the_ground_is_left_there(
	void **state)
{
	(void)state;
	assert_near(height_of_ground(0), 0, 1e-6);
	assert_near(height_of_ground(0.058f), 0, 1e-6);
	assert_near(height_of_ground(-0.058f), 0, 1e-6);
	assert_near(height_of_ground(0.062f), 0.062, 1e-6);
	assert_near(height_of_ground(-0.062f), -0.062, 1e-6);
	assert_near(height_of_ground(5), 5, 1e-6);
}

static void test_a_figure_beside_its_origin_stands_on_its_middle(void **state)
{
	const struct crowd_figure right = make_wide(0.5f, 0);
	const struct crowd_figure behind = make_board(
		(float[]){-0.1f, 0, -2}, (float[]){0.1f, 1.7f, -1.5f});

	(void)state;
	assert_near(right.center[0], 1.5, 1e-6);
	assert_near(right.scale, 0.4, 1e-6);
	assert_near(make_wide(-3, 0).center[0], -2, 1e-6);
	assert_near(behind.center[2], -1.75, 1e-6);
	assert_near(make_wide(0, 0).center[0], 0, 1e-6);
	assert_near(make_wide(-0.5f, 0).center[0], 0, 1e-6);
}

/* A person takes 0.4 m to a side, 0.6 m to the front and 1.72 m of height. */
static void test_figures_get_a_persons_size_unless_they_nearly_have_it(
	void **state)
{
	static const struct {
		float low[3], high[3], scale, beyond_m;
	} figures[] = {
		/* too high, too low */
		{{-0.1f, 0, -0.1f}, {0.1f, 3.44f, 0.1f}, 0.5f, 0},
		{{-0.01f, 0, -0.1f}, {0.01f, 0.43f, 0.1f}, 4, 0},
		/* too far to the left, to the right, to the front */
		{{-0.8f, 0, -0.1f}, {0.1f, 1.5f, 0.1f}, 0.5f, 0},
		{{-0.1f, 0, -0.1f}, {0.8f, 1.4f, 0.1f}, 0.5f, 0.25f},
		{{-0.1f, 0, -0.1f}, {0.1f, 1, 2.4f}, 0.25f, 0},
		{{-0.1f, 0, -2.4f}, {0.1f, 1, 0.1f}, 0.25f, 0},
		/* Less than a quarter more or less stays. */
		{{-0.1f, 0, -0.1f}, {0.1f, 2.1f, 0.1f}, 1, 0},
		{{-0.1f, 0, -0.1f}, {0.1f, 2.2f, 0.1f}, 1.72f / 2.2f, 0},
		{{-0.1f, 0, -0.1f}, {0.1f, 1.4f, 0.1f}, 1, 0},
		{{-0.1f, 0, -0.1f}, {0.1f, 1.3f, 0.1f}, 1.72f / 1.3f, 0},
		{{-0.1f, 0, -0.1f}, {0.5f, 1.5f, 0.1f}, 0.8f, 0},
		{{-0.1f, 0, -0.1f}, {0.32f, 1.3f, 0.1f}, 1.25f, 0},
		/* a point */
		{{0, 0, 0}, {0, 0, 0}, 1, 0.25f},
		/* Heights count from the ground: this one floats. */
		{{-0.1f, 2, -0.1f}, {0.1f, 5.44f, 0.1f}, 0.5f, 0},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(figures); i++) {
		const struct crowd_figure made =
			make_board(figures[i].low, figures[i].high);

		assert_near(made.scale, figures[i].scale, 1e-5);
		assert_near(made.beyond_m, figures[i].beyond_m, 1e-6);
	}
}

/* Number 1 walks and 6 runs the other way, in limber's own crowd. */
static void test_figures_move_as_fast_as_their_feet_up_to_4_m_a_second(
	void **state)
{
	struct crowd_figure walking = {.scale = 0.5f, .one_clip = true};
	struct motion motion;

	(void)state;
	walking.motions.role[MOTION_WALK].speed = 3;
	walking.motions.role[MOTION_RUN].speed = 9;
	assert_near(
		crowd_figure_route(&walking, 1, &motion).speed_m_s, 1.5, 1e-6);
	assert_near(motion.speed, 3, 1e-6);
	assert_near(
		crowd_figure_route(&walking, 6, &motion).speed_m_s, -4, 1e-6);
	assert_near(motion.speed, 9, 1e-6);
}

/* From all sides to the viewer's, who is a little to the right. */
static void test_figures_that_cannot_walk_face_the_viewer(void **state)
{
	const struct crowd_figure still = {.scale = 1, .one_clip = true};
	struct crowd_figure walking = still;
	struct motion motion;

	(void)state;
	for (int number = 1; number < 16; number++) {
		const struct crowd_route where =
			crowd_figure_route(&still, number, &motion);

		assert_near(crowd_position_at(&where, 7).yaw_rad, 0.45, 1e-6);
	}
	walking.motions.role[MOTION_WALK].speed = 1;
	walking.motions.role[MOTION_STAND].speed = 1;
	assert_near(crowd_figure_route(&walking, 1, &motion).facing_rad, 0, 0);
	/* The last ring stands in any case, and looks to the middle. */
	assert_near(crowd_figure_route(&still, 30, &motion).facing_rad,
		SCALAR_PI, 1e-6);
	/* There is no way around a ring without a radius. */
	assert_near(crowd_figure_route(&walking, 0, &motion).speed_m_s, 0, 0);
}

/* A jump that goes away is taken back, as a walk is. */
static void test_a_clip_that_is_named_stays_in_its_place(void **state)
{
	enum {
		JUMPS = 32 /* the first walker that does */
	};
	struct log log = log_to_stderr(LOG_ERROR);
	struct model *model = model_fixture("gltf/clip/far.gltf", NULL);
	const struct demo_env env = {
		.log = &log, .model_path = "far.gltf", .character = "none"};
	struct actor actor = {.model = model};
	struct crowd_figure made = {0};
	struct motion motion;
	float scale;

	(void)state;
	model->clip[0].name = "jump";
	actor.instance = small_model_instance(model);
	scale = actor.instance->unit_scale;
	assert_int_equal(crowd_figure_make(&made, &env, &actor), 0);
	assert_string_equal(crowd_route(JUMPS).clip, "jump");
	assert_near(
		crowd_figure_route(&made, JUMPS, &motion).speed_m_s, 0.0, 0.0);
	assert_int_equal(motion.clip, 0);
	assert_near(motion.drift[0], 40.0f * scale, 1e-4f * scale);
	assert_near(motion.drift[1], -20.0f * scale, 1e-4f * scale);
	instance_destroy(actor.instance);
	model_destroy(model);
}

/*
 * A figure that climbs thirty times its height keeps a person's size, and its
 * foot stays on the ground at every moment.
 */
static void test_a_figure_that_climbs_stays_on_the_ground(void **state)
{
	static const float time_s[3] = {0, 1, 4};
	float value[9] = {0};
	struct log log = log_to_stderr(LOG_ERROR);
	const struct demo_env env = {.log = &log,
		.model_path = "assets/walker.glb",
		.character = "none",
		.clip = "climb"};
	struct model_channel channel = {.path = MODEL_TRANSLATION,
		.interpolation = MODEL_LINEAR,
		.width = 3,
		.key_count = 3,
		.time_s = time_s,
		.value = value};
	struct model_clip clip = {.name = "climb",
		.duration_s = 4,
		.channel_count = 1,
		.channel = &channel};
	struct crowd_figure made = {0}, still = {0};
	struct actor actor = {0};
	struct motion motion;

	(void)state;
	assert_int_equal(model_load(env.model_path, &log, &actor.model), 0);
	channel.node = actor.model->skin[0].joint[0];
	while (actor.model->node[channel.node].parent >= 0) {
		channel.node = actor.model->node[channel.node].parent;
	}
	actor.model->clip = &clip;
	actor.model->clip_count = 1;
	actor.instance = small_model_instance(actor.model);
	assert_int_equal(crowd_figure_make(&still, &env, &actor), 0);
	value[7] = 52;
	assert_int_equal(crowd_figure_make(&made, &env, &actor), 0);
	assert_near(made.scale, still.scale, 1e-4);
	assert_near(made.center[1], still.center[1], 1e-4);
	crowd_figure_route(&made, 5, &motion);
	for (float at_s = 0; at_s <= 4; at_s += 0.8f) {
		float moved[3], high = at_s < 1 ? 0 : 52 * (at_s - 1) / 3;

		motion_drift_at(&motion, actor.model, at_s, moved);
		assert_near(moved[1], high * actor.instance->unit_scale, 0.02);
	}
	instance_destroy(actor.instance);
	actor.model->clip_count = 0;
	model_destroy(actor.model);
}

/* A walker that is turned to its left goes there. */
static void test_a_figure_is_turned_where_its_feet_take_it(void **state)
{
	static const float turned[4] = {0.0f, 0.70710678f, 0.0f, 0.70710678f};
	struct log log = log_to_stderr(LOG_ERROR);
	const struct demo_env env = {.log = &log,
		.model_path = "assets/walker.glb",
		.character = "none"};
	struct crowd_figure made = {0};
	struct actor actor = {0};

	(void)state;
	assert_int_equal(model_load(env.model_path, &log, &actor.model), 0);
	for (int i = 0; i < actor.model->node_count; i++) {
		struct model_node *node = &actor.model->node[i];

		if (node->parent < 0) {
			memcpy(node->rest.rotation, turned, sizeof(turned));
		}
	}
	actor.instance = small_model_instance(actor.model);
	assert_int_equal(crowd_figure_make(&made, &env, &actor), 0);
	assert_near(made.front_rad, acos(0), 1e-3);
	instance_destroy(actor.instance);
	model_destroy(actor.model);
}

/* Those who stand play the clips of their names, others those of their gait. */
static void test_every_walker_plays_its_clip(void **state)
{
	struct log log = log_to_stderr(LOG_ERROR);
	struct demo_env env = {.log = &log,
		.model_path = "assets/walker.glb",
		.character = "none"};
	struct actor actor = {0};
	struct motion motion;

	(void)state;
	assert_int_equal(model_load(env.model_path, &log, &actor.model), 0);
	actor.instance = small_model_instance(actor.model);
	for (int one_clip = 0; one_clip < 2; one_clip++) {
		struct crowd_figure made = {0};

		env.clip = one_clip ? "jump" : NULL;
		assert_int_equal(crowd_figure_make(&made, &env, &actor), 0);
		for (int number = 0; number < CROWD_MAX; number++) {
			const char *name =
				one_clip ? "jump" : crowd_route(number).clip;

			crowd_figure_route(&made, number, &motion);
			assert_int_equal(motion.clip,
				model_find_clip(actor.model, name));
		}
	}
	instance_destroy(actor.instance);
	model_destroy(actor.model);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_figures_middle_stands_on_its_route),
		cmocka_unit_test(test_a_figure_leans_before_it_turns),
		cmocka_unit_test(
			test_a_figure_beside_its_origin_stands_on_its_middle),
		cmocka_unit_test(
			test_figures_get_a_persons_size_unless_they_nearly_have_it),
		cmocka_unit_test(
			test_figures_move_as_fast_as_their_feet_up_to_4_m_a_second),
		cmocka_unit_test(test_figures_that_cannot_walk_face_the_viewer),
		cmocka_unit_test(
			test_a_figure_up_to_3_percent_off_the_ground_is_left_there),
		cmocka_unit_test(
			test_the_figure_looks_along_its_route_in_its_size),
		cmocka_unit_test(test_a_clip_that_is_named_stays_in_its_place),
		cmocka_unit_test(test_a_figure_that_climbs_stays_on_the_ground),
		cmocka_unit_test(test_a_figure_is_turned_where_its_feet_take_it),
		cmocka_unit_test(test_every_walker_plays_its_clip),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
