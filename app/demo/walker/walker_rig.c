#include "app/demo/walker/walker_rig.h"

#include "app/anim/ease.h"
#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/anim/procedural/bone.h"
#include "app/demo/actor.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

static const float switch_s = 0.4f; /* the duration of a fade */
static const float expression_s = 1.3f;
static const float wave_height_m = 0.2f;
/*
 * The middle of a ball of 5 cm that lies in the right palm, from the wrist in
 * the hand's axes (fingers along y, back of the hand along x), and how far
 * fingers and thumb close around it.
 */
static const float grip_m[3] = {-0.070f, 0.060f, 0.0f};
static const float finger_rad = 0.85f, thumb_rad = 0.30f;

enum {
	GRIP_ROUNDS = 4
};

static const char *const feature_names[RIG_FEATURE_COUNT] = {
	[RIG_LOOK] = "look at",
	[RIG_REACH] = "reach",
	[RIG_GROUND] = "ground",
	[RIG_SHAKE] = "arm shake",
	[RIG_BREATH] = "breath",
	[RIG_HAIR] = "ponytail",
	[RIG_CAPE] = "cape",
	[RIG_FACE] = "face",
	[RIG_SHADOW] = "shadow",
	[RIG_BUMPS] = "bump map",
};

const char *walker_rig_feature_name(enum walker_rig_feature feature)
{
	return feature_names[feature];
}

static int find_bones(struct walker_rig *rig, const struct model *model,
	const struct log *log)
{
	const struct {
		const char *name;
		int *node;
	} bones[] = {
		{"hips", &rig->hips},
		{"neck", &rig->neck.node},
		{"head", &rig->head.node},
		{"upper_arm.R", &rig->arm.upper},
		{"forearm.R", &rig->arm.lower},
		{"hand.R", &rig->arm.tip},
		{"fingers.R", &rig->fingers},
		{"thumb.R", &rig->thumb},
		{"thigh.L", &rig->leg[0].upper},
		{"shin.L", &rig->leg[0].lower},
		{"foot.L", &rig->leg[0].tip},
		{"thigh.R", &rig->leg[1].upper},
		{"shin.R", &rig->leg[1].lower},
		{"foot.R", &rig->leg[1].tip},
		{"shoulder.L", &rig->shake[0].node},
		{"shoulder.R", &rig->shake[1].node},
		{"chest", &rig->breath.chest},
		{"forearm.L", &rig->biceps[0].joint},
		{"forearm.R", &rig->biceps[1].joint},
		{"upper_arm.L", &rig->biceps[0].node},
		{"upper_arm.R", &rig->biceps[1].node},
	};

	for (size_t i = 0; i < ARRAY_COUNT(bones); i++) {
		int error = actor_find_bone(
			model, bones[i].name, log, bones[i].node);

		if (error) {
			return error;
		}
	}
	return 0;
}

/* The head's node if it has morph targets, else -1. */
static int find_face(const struct model *model)
{
	int node = model_find_node(model, "walker_head");
	int mesh = node < 0 ? -1 : model->node[node].mesh;

	return mesh >= 0 && model->mesh[mesh].target_count > 0 ? node : -1;
}

static void use_preset(struct walker_rig *rig, int preset)
{
	rig->preset_chosen = preset;
	for (int side = 0; side < 2; side++) {
		rig->shake[side].preset = rig->presets.preset[preset];
	}
}

void walker_rig_next_preset(struct walker_rig *rig)
{
	use_preset(rig, (rig->preset_chosen + 1) % rig->presets.count);
}

int walker_rig_init(struct walker_rig *rig, struct instance *instance,
	const struct log *log)
{
	const struct muscle biceps = {.from_rad = 0.3f,
		.to_rad = 1.6f,
		.swell = {0.16f, 0.0f, 0.16f},
		.weight = -1};
	int error;

	*rig = (struct walker_rig){
		.neck = lookat_default(0),
		.head = lookat_default(0),
		.breath = breath_default(0),
		.biceps = {biceps, biceps},
	};
	error = preset_file_read(&rig->presets, log);
	if (error) {
		return error;
	}
	for (int side = 0; side < 2; side++) {
		rig->shake[side] = procedural_begin(&rig->presets.preset[0], 0);
	}
	rig->on[RIG_HAIR] = rig->on[RIG_BREATH] = true;
	rig->on[RIG_SHADOW] = rig->on[RIG_BUMPS] = true;
	error = find_bones(rig, instance->model, log);
	rig->face = find_face(instance->model);
	return error ? error
		     : walker_secondary_init(&rig->secondary, instance, log);
}

/* Moves the ball in a figure of eight in front of the chest. */
static void move_ball(struct walker_rig *rig, double time_s)
{
	float turn = 0.9f * (float)time_s;

	rig->ball[0] = -0.14f + 0.34f * scalar_sin(turn);
	rig->ball[1] = 1.34f + 0.16f * scalar_sin(2.0f * turn);
	rig->ball[2] = 0.46f + 0.08f * scalar_cos(turn);
}

static void update_weights(struct walker_rig *rig, float step_s)
{
	for (int i = 0; i < RIG_FEATURE_COUNT; i++) {
		float change = rig->on[i] ? step_s : -step_s;

		rig->weight[i] = scalar_clamp(
			rig->weight[i] + change / switch_s, 0.0f, 1.0f);
	}
}

static float eased(const struct walker_rig *rig, enum walker_rig_feature feature)
{
	return ease_at(EASE_CUBIC, rig->weight[feature]);
}

/* Updates the world matrices of a changed node and its descendants. */
static void update_world_from(struct instance *instance, int node)
{
	pose_world_from(
		&instance->pose, instance->model, NULL, node, instance->world);
}

/* Shakes both arms, slightly out of phase. */
static void shake(struct walker_rig *rig, struct pose *pose, double time_s)
{
	for (int side = 0; side < 2; side++) {
		rig->shake[side].fade = 1.0f - eased(rig, RIG_SHAKE);
		procedural_apply(&rig->shake[side], time_s + 0.04 * side, pose);
	}
}

/* The chest breathes and bent arms bulge. */
static void flex_muscles(
	struct walker_rig *rig, struct pose *pose, double time_s)
{
	float weight = eased(rig, RIG_BREATH);

	if (weight == 0.0f) {
		return;
	}
	rig->breath.weight = weight;
	breath_apply(&rig->breath, time_s, pose);
	for (int side = 0; side < 2; side++) {
		muscle_apply(&rig->biceps[side], pose);
	}
}

/* Shows one expression after another, each faded in and out. */
static void set_expression(
	struct walker_rig *rig, struct instance *instance, double time_s)
{
	const struct model_node *node = &instance->model->node[rig->face];
	const struct model_mesh *mesh = &instance->model->mesh[node->mesh];
	float *weight = instance->pose.weight + node->weight_offset;
	float fraction = eased(rig, RIG_FACE);
	int cycle = (int)(time_s / (double)expression_s);
	float phase = (float)(time_s - (double)cycle * (double)expression_s) /
		expression_s;

	rig->expression = cycle % mesh->target_count;
	for (int i = 0; i < mesh->target_count; i++) {
		float wanted = i == rig->expression
			? ease_at(EASE_CUBIC,
				  4.0f * (phase < 0.5f ? phase : 1.0f - phase))
			: 0.0f;

		weight[i] += (wanted - weight[i]) * fraction;
	}
}

/* The neck turns first, the head turns by what remains. */
static void look(struct walker_rig *rig, struct instance *instance, float step_s)
{
	const float *target = rig->on[RIG_LOOK] ? rig->ball : NULL;
	struct lookat *lookat[2] = {&rig->neck, &rig->head};

	for (int i = 0; i < 2; i++) {
		lookat[i]->weight = (i ? 1.0f : 0.4f) * eased(rig, RIG_LOOK);
		lookat_update(lookat[i], target, step_s,
			(const mat4 *)instance->world, &instance->pose);
		update_world_from(instance, lookat[i]->node);
	}
}

/* Blends a joint from its pose to the rest pose turned about its own axis z. */
static void curl(struct walker_rig *rig, struct instance *instance, int node,
	float angle_rad)
{
	static const float axis[3] = {0.0f, 0.0f, 1.0f};
	struct transform *local = &instance->pose.local[node];
	float turn[4], closed[4];

	quat_from_axis_angle(axis, angle_rad, turn);
	quat_multiply(instance->model->node[node].rest.rotation, turn, closed);
	quat_slerp(local->rotation, closed, rig->arm.weight, local->rotation);
	instance->pose.animated[node] = true;
}

/* Where the wrist has to be for the ball to lie in the palm. */
static void wrist_goal(
	const struct walker_rig *rig, struct instance *instance, float out[3])
{
	float rotation[4], grip[3];

	matrix_rotation(instance->world[rig->arm.tip], rotation);
	quat_rotate(rotation, grip_m, grip);
	vec_subtract(rig->ball, grip, out);
}

/*
 * Brings the hand to the ball and closes the fingers around it. Where the palm
 * is follows from the hand's rotation, and that from the arm's: a few rounds
 * make both agree.
 */
static void reach(struct walker_rig *rig, struct instance *instance)
{
	const int node[3] = {rig->arm.upper, rig->arm.lower, rig->arm.tip};
	const float *ball = rig->ball;
	/* The elbow points down and a little outwards. */
	const float pole[3] = {ball[0] - 0.5f, ball[1] - 1.0f, ball[2] - 0.6f};
	struct transform animated[3];
	float weight = eased(rig, RIG_REACH);

	if (weight == 0.0f) {
		return;
	}
	for (int i = 0; i < 3; i++) {
		animated[i] = instance->pose.local[node[i]];
	}
	for (int round = 0; round < GRIP_ROUNDS; round++) {
		float wrist[3];

		wrist_goal(rig, instance, wrist);
		for (int i = 0; i < 3; i++) {
			instance->pose.local[node[i]] = animated[i];
		}
		update_world_from(instance, rig->arm.upper);
		rig->arm.weight = round + 1 < GRIP_ROUNDS ? 1.0f : weight;
		ik_limb_solve(&rig->arm, wrist, pole,
			(const mat4 *)instance->world, &instance->pose);
		update_world_from(instance, rig->arm.upper);
	}
	curl(rig, instance, rig->fingers, finger_rad);
	curl(rig, instance, rig->thumb, thumb_rad);
	update_world_from(instance, rig->arm.tip);
}

/* The rotation from a level foot to the ground's slope. */
static void slope_rotation(
	const struct floor *floor, const float at[3], float out[4])
{
	float step = 0.08f;
	float here = floor_height(floor, at[0], at[2]);
	float dx = (floor_height(floor, at[0] + step, at[2]) - here) / step;
	float dz = (floor_height(floor, at[0], at[2] + step) - here) / step;

	quat_from_slope(dx, dz, out);
}

/*
 * Lifts each foot by the height of the ground under it. The hips move with the
 * lower foot, so that both legs reach the ground.
 */
static void place_feet(
	struct walker_rig *rig, struct instance *instance, struct floor *floor)
{
	struct pose *pose = &instance->pose;
	mat4 *world = instance->world;
	float target[2][3], slope[2][4], lift[2];

	floor_set_wave_height(floor, wave_height_m * eased(rig, RIG_GROUND));
	if (floor->wave_height == 0.0f) {
		return;
	}
	for (int side = 0; side < 2; side++) {
		memcpy(target[side], world[rig->leg[side].tip][3],
			sizeof(target[side]));
		slope_rotation(floor, target[side], slope[side]);
		lift[side] =
			floor_height(floor, target[side][0], target[side][2]) -
			floor->y;
		target[side][1] += lift[side];
	}
	pose->local[rig->hips].translation[1] +=
		lift[0] < lift[1] ? lift[0] : lift[1];
	for (int side = 0; side < 2; side++) {
		struct ik_limb *leg = &rig->leg[side];
		float turned[4];

		update_world_from(instance, rig->hips);
		matrix_rotation(world[leg->tip], turned);
		quat_multiply(slope[side], turned, turned);
		leg->weight = 1.0f;
		ik_limb_solve(
			leg, target[side], NULL, (const mat4 *)world, pose);
		update_world_from(instance, leg->upper);
		bone_set_world_rotation(
			pose, (const mat4 *)world, leg->tip, turned, 1.0f);
	}
	update_world_from(instance, rig->hips);
}

void walker_rig_apply(struct walker_rig *rig, struct instance *instance,
	const struct walker_rig_frame *frame)
{
	bool had_cape = rig->weight[RIG_CAPE] > 0.0f;

	move_ball(rig, frame->time_s);
	update_weights(rig, frame->step_s);
	shake(rig, &instance->pose, frame->time_s);
	flex_muscles(rig, &instance->pose, frame->time_s);
	if (rig->face >= 0) {
		set_expression(rig, instance, frame->time_s);
	}
	instance_update_nodes(instance);
	place_feet(rig, instance, frame->floor);
	look(rig, instance, frame->step_s);
	reach(rig, instance);
	if (!had_cape && rig->on[RIG_CAPE]) {
		walker_secondary_reset_cape(&rig->secondary);
	}
	walker_secondary_update(&rig->secondary, instance, frame->speed_m_per_s,
		eased(rig, RIG_HAIR), rig->on[RIG_CAPE] || had_cape,
		frame->step_s);
}
