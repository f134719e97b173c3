/*
 * The arm: hierarchical animation, AN4044 section 2.
 *
 * Every node of the model is a pivot. A part moves when one of its pivot's
 * variables changes; draw_hierarchy() does the rest.
 */
#include "app/anim/hierarchy.h"
#include "app/demo/actor.h"
#include "app/demo/arm_program.h"
#include "app/demo/demo.h"
#include "app/scene/draw/draw.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const float wheel_radius_m = 0.056f;
static const float joint_deg_per_s = 45.0f;
static const float truck_m_per_s = 0.35f;
static const float truck_half_m = 0.26f; /* of its length */
static const double pause_s = 1.0;       /* between two runs of the sequence */

/* The pivots that the demo moves; part_names are their nodes' names. */
enum part {
	PART_ARM,
	PART_FOREARM,
	PART_HAND,
	PART_INDEX,
	PART_THUMB,
	PART_TRUCK,
	PART_WHEEL_FL,
	PART_WHEEL_FR,
	PART_WHEEL_RL,
	PART_WHEEL_RR,
	PART_CRATE,
	PART_COUNT,
};

static const char *const part_names[PART_COUNT] = {"Arm", "Forearm", "Hand",
	"IndexFinger", "Thumb", "Car", "WheelFL", "WheelFR", "WheelRL",
	"WheelRR", "Crate"};

/* The parts that ENTER selects, and the joints that the arrows move. */
struct handle {
	const char *name;
	enum arm_joint up_down, left_right;
	float up, right; /* the joints' direction for UP and RIGHT */
};

static const struct handle handles[] = {
	{"arm", ARM_PITCH, ARM_HEADING, -1.0f, 1.0f},
	{"forearm", FOREARM_PITCH, ARM_HEADING, -1.0f, 1.0f},
	{"hand", HAND_PITCH, HAND_BANK, -1.0f, 1.0f},
	{"finger", FINGER_HEADING, FINGER_HEADING, 1.0f, 1.0f},
	{"truck", TRUCK_POSITION, TRUCK_POSITION, 1.0f, 1.0f},
};

static const struct {
	float low, high;
} joint_limits[ARM_JOINT_COUNT] = {
	[ARM_HEADING] = {-160.0f, 160.0f},
	[ARM_PITCH] = {-60.0f, 60.0f},
	[FOREARM_PITCH] = {-50.0f, 80.0f},
	[HAND_PITCH] = {-80.0f, 100.0f},
	[HAND_BANK] = {-180.0f, 180.0f},
	[FINGER_HEADING] = {-6.0f, 25.0f},
	[TRUCK_POSITION] = {-0.2f, 0.45f},
};

static const struct actor_framing framing = {.camera = {.yaw_rad = 0.6f,
						     .pitch_rad = 0.28f,
						     .margin = 1.03f,
						     .follow = true},
	.label_rows = 6,
	.label_bars = 1};

struct demo {
	struct demo_base base;
	struct hierarchy hierarchy;
	mat4 *pivot_world; /* [hierarchy.pivot_count], for overlays */
	int pivot[PART_COUNT];
	struct hierarchy_pivot crate_rest;
	float truck_rest[3];

	float joint[ARM_JOINT_COUNT];
	enum crate_place crate;
	size_t handle;
	float up, right; /* while held: -1, 0 or 1 */

	bool repeating;
	int step; /* of the sequence, or -1 */
	float from[ARM_JOINT_COUNT];
	double step_start_s, now_s;
};

/*
 * Makes a pivot for each node in the model's order, except that the crate is
 * last: parents precede their children, and any part may become its parent.
 */
static int make_pivots(struct demo *demo, const struct demo_env *env)
{
	const struct model *model = demo->base.actor.model;
	struct arena *arena = &demo->base.actor.instance->arena;
	int crate = model_find_node(model, part_names[PART_CRATE]);
	int *index = ARENA_ARRAY(arena, int, (size_t)model->node_count);
	struct hierarchy_pivot *pivot = ARENA_ARRAY(
		arena, struct hierarchy_pivot, (size_t)model->node_count);
	int next = 0;

	demo->pivot_world = arena_alloc(
		arena, (size_t)model->node_count, sizeof(*demo->pivot_world));
	if (!index || !pivot || !demo->pivot_world) {
		log_error(env->log,
			"%s: there is not enough memory for the pivots",
			env->model_path);
		return -ENOMEM;
	}
	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];

		index[i] = i == crate ? model->node_count - 1 : next++;
		pivot[index[i]] = hierarchy_pivot_default();
		pivot[index[i]].part = i;
		pivot[index[i]].parent =
			node->parent < 0 ? -1 : index[node->parent];
		memcpy(pivot[index[i]].position, node->rest.translation,
			sizeof(float[3]));
	}
	demo->hierarchy = (struct hierarchy){model->node_count, pivot};
	for (int part = 0; part < PART_COUNT; part++) {
		int node = model_find_node(model, part_names[part]);

		if (node < 0) {
			log_error(env->log, "%s: the model has no node named %s",
				env->model_path, part_names[part]);
			return -EINVAL;
		}
		demo->pivot[part] = index[node];
	}
	return hierarchy_check(&demo->hierarchy);
}

static struct hierarchy_pivot *pivot_of(struct demo *demo, enum part part)
{
	return &demo->hierarchy.pivot[demo->pivot[part]];
}

/* The rotation orders of AN4044's robot arm. */
static void set_orders(struct demo *demo)
{
	pivot_of(demo, PART_ARM)->order = HIERARCHY_HEADING_PITCH_BANK;
	pivot_of(demo, PART_FOREARM)->order = HIERARCHY_PITCH_HEADING_BANK;
	pivot_of(demo, PART_HAND)->order = HIERARCHY_PITCH_BANK_HEADING;
	demo->crate_rest = *pivot_of(demo, PART_CRATE);
	memcpy(demo->truck_rest, pivot_of(demo, PART_TRUCK)->position,
		sizeof(demo->truck_rest));
}

static void begin_step(struct demo *demo, int step)
{
	demo->step = step;
	demo->step_start_s = demo->now_s;
	memcpy(demo->from, demo->joint, sizeof(demo->from));
}

/* Extends the box to wherever the truck may drive. */
static void add_truck_path(const struct demo *demo, struct bounds *bounds)
{
	for (int end = 0; end < 2; end++) {
		float at[3];

		memcpy(at, demo->truck_rest, sizeof(at));
		at[2] += end ? joint_limits[TRUCK_POSITION].high + truck_half_m
			     : joint_limits[TRUCK_POSITION].low - truck_half_m;
		bounds_add(bounds, at);
	}
}

static int arm_prepare(struct demo *demo, const struct demo_env *env)
{
	struct bounds bounds;
	int error = make_pivots(demo, env);

	if (error) {
		return error;
	}
	set_orders(demo);
	memcpy(demo->joint, arm_home, sizeof(demo->joint));
	demo->repeating = env->unattended;
	begin_step(demo, demo->repeating ? 0 : -1);
	bounds = bounds_of_clip(demo->base.actor.instance, -1);
	add_truck_path(demo, &bounds);
	return actor_init_stage(env, &bounds, &framing, &demo->base.stage);
}

static void run_program(struct demo *demo)
{
	const struct arm_step *step = &arm_program[demo->step];
	float fraction =
		(float)(demo->now_s - demo->step_start_s) / step->duration_s;

	if (fraction < 0.0f) {
		return; /* the pause before the first step */
	}
	if (fraction < 1.0f) {
		arm_step_blend(demo->from, step, fraction, demo->joint);
		return;
	}
	memcpy(demo->joint, step->joint, sizeof(demo->joint));
	demo->crate = step->crate;
	if (demo->step + 1 < arm_program_length) {
		double end_s = demo->step_start_s + (double)step->duration_s;

		begin_step(demo, demo->step + 1);
		demo->step_start_s = end_s;
		run_program(demo);
	} else if (demo->repeating) {
		begin_step(demo, 0);
		demo->step_start_s += pause_s;
	} else {
		demo->step = -1;
	}
}

static void move_joint(
	struct demo *demo, enum arm_joint joint, float direction, float step_s)
{
	float speed = joint == TRUCK_POSITION ? truck_m_per_s : joint_deg_per_s;

	demo->joint[joint] =
		scalar_clamp(demo->joint[joint] + direction * speed * step_s,
			joint_limits[joint].low, joint_limits[joint].high);
}

static float radians(float degrees)
{
	return degrees * (SCALAR_PI / 180.0f);
}

static void place_crate(struct demo *demo)
{
	static const float in_hand[3] = {0.0f, 0.0f, 0.275f};
	static const float on_truck[3] = {0.0f, 0.194f, -0.118f};
	struct hierarchy_pivot *crate = pivot_of(demo, PART_CRATE);

	*crate = demo->crate_rest;
	if (demo->crate == CRATE_IN_HAND) {
		crate->parent = demo->pivot[PART_HAND];
		crate->pitch_rad = radians(-90.0f);
		memcpy(crate->position, in_hand, sizeof(in_hand));
	} else if (demo->crate == CRATE_ON_TRUCK) {
		crate->parent = demo->pivot[PART_TRUCK];
		memcpy(crate->position, on_truck, sizeof(on_truck));
	}
}

/* Sets the pivots' variables from the joint values. */
static void set_pivots(struct demo *demo)
{
	const float *joint = demo->joint;

	pivot_of(demo, PART_ARM)->heading_rad = radians(joint[ARM_HEADING]);
	pivot_of(demo, PART_ARM)->pitch_rad = radians(joint[ARM_PITCH]);
	pivot_of(demo, PART_FOREARM)->pitch_rad = radians(joint[FOREARM_PITCH]);
	pivot_of(demo, PART_HAND)->pitch_rad = radians(joint[HAND_PITCH]);
	pivot_of(demo, PART_HAND)->bank_rad = radians(joint[HAND_BANK]);
	pivot_of(demo, PART_INDEX)->heading_rad = radians(joint[FINGER_HEADING]);
	pivot_of(demo, PART_THUMB)->heading_rad =
		-radians(joint[FINGER_HEADING]);
	pivot_of(demo, PART_TRUCK)->position[2] =
		demo->truck_rest[2] + joint[TRUCK_POSITION];
	for (int wheel = PART_WHEEL_FL; wheel <= PART_WHEEL_RR; wheel++) {
		pivot_of(demo, (enum part)wheel)->pitch_rad =
			joint[TRUCK_POSITION] / wheel_radius_m;
	}
	place_crate(demo);
}

static void arm_update(struct demo *demo, double time_s)
{
	const struct handle *handle = &handles[demo->handle];
	float step_s = (float)(time_s - demo->now_s);

	demo->now_s = time_s;
	if (demo->step >= 0) {
		run_program(demo);
	} else {
		move_joint(demo, handle->up_down, demo->up * handle->up, step_s);
		move_joint(demo, handle->left_right,
			demo->right * handle->right, step_s);
	}
	set_pivots(demo);
}

static void arm_draw(struct demo *demo, int width, int height)
{
	const struct gl *gl = demo->base.gl;
	struct actor *actor = &demo->base.actor;

	actor_choose_lod(actor, &demo->base.stage.camera, height);
	stage_begin(&demo->base.stage, gl, width, height);
	stage_shadow_begin(&demo->base.stage, gl);
	draw_hierarchy(gl, &demo->hierarchy, actor->instance, &actor->textures,
		DRAW_SHADOW);
	stage_shadow_end(&demo->base.stage, gl);
	draw_hierarchy(gl, &demo->hierarchy, actor->instance, &actor->textures,
		DRAW_SHADED);
}

/* Writes the pivots' matrices where overlays read those of nodes. */
static bool arm_get_figure(
	struct demo *demo, int number, struct overlay_figure *out)
{
	const struct hierarchy *hierarchy = &demo->hierarchy;

	(void)out;
	if (number > 0) {
		return false;
	}
	hierarchy_world(hierarchy, demo->pivot_world);
	for (int i = 0; i < hierarchy->pivot_count; i++) {
		memcpy(demo->base.actor.instance->world[hierarchy->pivot[i].part],
			demo->pivot_world[i], sizeof(mat4));
	}
	return true;
}

static double arm_period_s(const struct demo *demo)
{
	(void)demo;
	return (double)arm_program_duration_s() + pause_s;
}

static const char *const joint_names[ARM_JOINT_COUNT] = {
	[ARM_HEADING] = "arm heading",
	[ARM_PITCH] = "arm pitch",
	[FOREARM_PITCH] = "forearm pitch",
	[HAND_PITCH] = "hand pitch",
	[HAND_BANK] = "hand bank",
	[FINGER_HEADING] = "finger heading",
	[TRUCK_POSITION] = "position",
};

static void label_joint(
	struct hud_group *group, enum arm_joint joint, const float *value)
{
	char text[32];

	if (joint == TRUCK_POSITION) {
		snprintf(text, sizeof(text), "%.2f m", (double)value[joint]);
	} else {
		snprintf(text, sizeof(text), "%.0f\u00b0", (double)value[joint]);
	}
	hud_group_text(group, joint_names[joint], text);
}

/* The values that the arrows change. */
static void label_handle(struct hud_group *group, const struct handle *handle,
	const float *value)
{
	label_joint(group, handle->up_down, value);
	if (handle->left_right != handle->up_down) {
		label_joint(group, handle->left_right, value);
	}
}

static void arm_label(const struct demo *demo, struct hud *hud)
{
	struct hud_group group =
		hud_group_begin(hud, HUD_TOP_LEFT, "Hierarchical");
	const float *joint = demo->joint;

	if (demo->step >= 0) {
		const struct arm_step *step = &arm_program[demo->step];
		float done_s = (float)(demo->now_s - demo->step_start_s);

		hud_group_text(&group, step->name, "");
		hud_group_time(&group, "",
			scalar_clamp(done_s, 0.0f, step->duration_s),
			step->duration_s, hud_color_amber);
	} else {
		hud_group_text(&group, "moving", handles[demo->handle].name);
		label_handle(&group, &handles[demo->handle], joint);
		hud_group_end(&group);
		return;
	}
	label_joint(&group, ARM_HEADING, joint);
	label_joint(&group, ARM_PITCH, joint);
	label_joint(&group, FOREARM_PITCH, joint);
	label_joint(&group, HAND_PITCH, joint);
	hud_group_end(&group);
}

/* The arrows end the sequence where it is. */
static void take_over(struct demo *demo)
{
	demo->step = -1;
	demo->repeating = false;
}

static void press_up(struct demo *demo, bool down)
{
	demo->up = down ? 1.0f : 0.0f;
	take_over(demo);
}

static void press_down(struct demo *demo, bool down)
{
	demo->up = down ? -1.0f : 0.0f;
	take_over(demo);
}

static void press_left(struct demo *demo, bool down)
{
	demo->right = down ? -1.0f : 0.0f;
	take_over(demo);
}

static void press_right(struct demo *demo, bool down)
{
	demo->right = down ? 1.0f : 0.0f;
	take_over(demo);
}

static void press_next_part(struct demo *demo, bool down)
{
	if (down) {
		demo->handle = (demo->handle + 1) % ARRAY_COUNT(handles);
	}
}

static void press_program(struct demo *demo, bool down)
{
	if (down) {
		demo->crate = CRATE_ON_FLOOR;
		demo->repeating = false;
		begin_step(demo, 0);
	}
}

static void press_repeat(struct demo *demo, bool down)
{
	if (down) {
		press_program(demo, true);
		demo->repeating = true;
	}
}

static const struct demo_action arm_actions[] = {
	{BUTTON_UP, "raise the part (truck: drive forward)", press_up},
	{BUTTON_DOWN, "lower the part (truck: drive back)", press_down},
	{BUTTON_LEFT, "turn the part left", press_left},
	{BUTTON_RIGHT, "turn the part right", press_right},
	{BUTTON_ENTER, "select arm, forearm, hand, finger or truck",
		press_next_part},
	{BUTTON_F8, "pick the crate up and load the truck", press_program},
	{BUTTON_F9, "do that again and again", press_repeat},
	{0},
};

const struct demo_driver demo_driver_arm = {
	.name = "arm",
	.summary = "hierarchical: a robot arm on pivots that loads a truck",
	.asset = "arm.glb",
	.action = arm_actions,
	.size = sizeof(struct demo),
	.prepare = arm_prepare,
	.update = arm_update,
	.draw = arm_draw,
	.period_s = arm_period_s,
	.label = arm_label,
	.get_figure = arm_get_figure,
};
