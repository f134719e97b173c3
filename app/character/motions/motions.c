#include "app/character/motions/motions.h"

#include "app/character/run/effects.h"
#include "platform/base/scalar.h"

#include <ctype.h>
#include <limits.h>
#include <string.h>

enum {
	CLIPS_MAX = 16 /* clips that are measured at most */
};

/* The file's speed is used if it is within this factor of the measured one. */
static const float near_factor = 1.5f;

/* A clip that ends this near its start, in sides of the figure, can be repeated. */
static const float repeated_gap = 0.1f;

/* Each row ends with NULL. */
static const char *const role_names[MOTION_ROLES][4] = {
	[MOTION_STAND] = {"idle", "stand"},
	[MOTION_WALK] = {"walk"},
	[MOTION_RUN] = {"run", "gallop", "trot"},
};

static struct motion measure(struct instance *instance,
	const struct gait_body *body, int clip, int steps)
{
	float unit = instance->unit_scale;
	struct gait gait = gait_measure(body, instance, clip, steps);
	struct motion motion = {
		.clip = clip,
		.repeats = clip >= 0 &&
			instance->model->clip[clip].duration_s > 0.0f &&
			gait.gap <= repeated_gap * gait.extent,
		.speed = unit *
			scalar_sqrt(gait.velocity[0] * gait.velocity[0] +
				gait.velocity[1] * gait.velocity[1]),
		.facing_rad = scalar_atan2(gait.velocity[0], gait.velocity[1]),
		.drift = {gait.drift[0] * unit, gait.drift[1] * unit},
		.rise_steps = gait.steps,
	};

	for (int i = 0; i <= gait.steps; i++) {
		motion.rise[i] = gait.rise[i] * unit;
	}
	return motion;
}

static bool contains(const char *text, const char *word)
{
	size_t length = strlen(word);

	for (; *text; text++) {
		size_t i = 0;

		while (i < length && tolower((unsigned char)text[i]) == word[i]) {
			i++;
		}
		if (i == length) {
			return true;
		}
	}
	return false;
}

/*
 * Returns the clip with the role's name, or one whose name contains it, or -1.
 */
static int find_named(const struct model *model, enum motion_role role)
{
	for (int i = 0; role_names[role][i]; i++) {
		const char *name = role_names[role][i];
		int clip = model_find_clip(model, name);

		for (int c = 0; clip < 0 && c < model->clip_count; c++) {
			clip = contains(model->clip[c].name, name) ? c : -1;
		}
		if (clip >= 0) {
			return clip;
		}
	}
	return -1;
}

/* What the character file says about a role; clip -1: nothing. */
struct saying {
	int clip;
	float speed;
};

/* Finds the roles' clips in a blend over speed; the slowest entry is first. */
static void read_blend(const struct character_state *state,
	const struct model *model, struct saying say[MOTION_ROLES])
{
	float most = state->entry[state->entry_count - 1].at;

	for (int i = 0; i < state->entry_count; i++) {
		const struct character_entry *entry = &state->entry[i];
		enum motion_role role = entry->at <= 0.0f ? MOTION_STAND
			: say[MOTION_WALK].clip < 0       ? MOTION_WALK
							  : MOTION_RUN;

		if (entry->of->clip &&
			(role != MOTION_RUN || entry->at == most)) {
			say[role].clip = (int)(entry->of->clip - model->clip);
			say[role].speed = entry->at;
		}
	}
}

static void read_shakes(const struct character *character, struct motions *out)
{
	for (int i = 0;
		i < character->op_count && out->bone_count < MOTION_BONES_MAX;
		i++) {
		const struct character_op *op = &character->op[i];

		if (op->run == character_shake_run) {
			const struct character_shake *shake = op->what;

			out->bone[out->bone_count++] = shake->swing.node;
		}
	}
}

/* Reads the model's character file, if there is one. */
static int read_character(const struct character_request *request,
	struct instance *instance, const struct log *log, struct motions *out,
	struct saying say[MOTION_ROLES])
{
	char path[PATH_MAX];
	struct character *character;
	int error;

	if (!character_open_path(request, path, sizeof(path))) {
		return 0;
	}
	error = character_load(path, instance, log, &character);
	if (error) {
		return error;
	}
	for (int i = 0; i < character->machine.state_count; i++) {
		const struct character_state *state =
			&character->machine.state[i];

		if (state->entry_count > 1) {
			read_blend(state, instance->model, say);
			break;
		}
	}
	read_shakes(character, out);
	character_destroy(character);
	return 0;
}

/* A clip of one moment, such as a pose for binding, is better than none. */
static bool is_moment(const struct model *model, int clip)
{
	return clip < 0 || model->clip[clip].duration_s <= 0.0f;
}

/* Gives the clip the roles that it suits better than the present ones. */
static void consider(const struct model *model, const struct motion *one,
	bool walks, struct motion role[MOTION_ROLES])
{
	if (one->speed <= 0.0f) {
		if (role[MOTION_STAND].clip < 0 ||
			(is_moment(model, role[MOTION_STAND].clip) &&
				!is_moment(model, one->clip))) {
			role[MOTION_STAND] = *one;
		}
	} else if (!walks) {
		if (role[MOTION_WALK].clip < 0 ||
			one->speed < role[MOTION_WALK].speed) {
			role[MOTION_WALK] = *one;
		}
		if (one->speed > role[MOTION_RUN].speed) {
			role[MOTION_RUN] = *one;
		}
	}
}

/*
 * Fills roles for which neither the file nor a name has a clip. A clip that
 * cannot be repeated, such as a fall, is better than none.
 */
static void choose_by_speed(struct instance *instance,
	const struct gait_body *body, int steps, struct motions *out)
{
	const struct model *model = instance->model;
	struct motion *role = out->role, once = {.clip = -1};
	bool walks = role[MOTION_WALK].clip >= 0 || role[MOTION_RUN].clip >= 0;

	for (int i = 0; i < model->clip_count && i < CLIPS_MAX; i++) {
		struct motion one = measure(instance, body, i, steps);

		if (one.repeats || is_moment(model, i)) {
			consider(model, &one, walks, role);
		} else if (once.clip < 0) {
			once = one;
		}
	}
	if (once.clip >= 0 && role[MOTION_WALK].clip < 0 &&
		role[MOTION_RUN].clip < 0 &&
		is_moment(model, role[MOTION_STAND].clip)) {
		consider(model, &once, walks, role);
	}
}

static void replace_missing(struct motion role[MOTION_ROLES])
{
	static const enum motion_role other[MOTION_ROLES][2] = {
		[MOTION_STAND] = {MOTION_WALK, MOTION_RUN},
		[MOTION_WALK] = {MOTION_RUN, MOTION_STAND},
		[MOTION_RUN] = {MOTION_WALK, MOTION_STAND},
	};

	for (int i = 0; i < MOTION_ROLES; i++) {
		for (int k = 0; k < 2 && role[i].clip < 0; k++) {
			role[i] = role[other[i][k]];
		}
	}
}

/* The file's speed for a clip is in metres and beats the measured one. */
static void use_speed(struct motion *motion, float said)
{
	if (said > motion->speed / near_factor &&
		said < motion->speed * near_factor) {
		motion->speed = said;
	}
}

static void choose_all(struct instance *instance, const struct gait_body *body,
	const struct saying say[MOTION_ROLES], struct motions *out)
{
	int steps = gait_steps_for(instance->model->clip_count);
	bool missing = false;

	for (int i = 0; i < MOTION_ROLES; i++) {
		enum motion_role role = (enum motion_role)i;
		int clip = say[i].clip >= 0 ? say[i].clip
					    : find_named(instance->model, role);

		out->role[i] = measure(instance, body, clip, steps);
		use_speed(&out->role[i], say[i].speed * instance->unit_scale);
		missing = missing || clip < 0;
	}
	if (missing) {
		choose_by_speed(instance, body, steps, out);
	}
	replace_missing(out->role);
}

int motions_find(const struct character_request *request,
	struct instance *instance, const struct log *log, struct motions *out)
{
	struct saying say[MOTION_ROLES] = {{-1, 0}, {-1, 0}, {-1, 0}};
	struct gait_body body;
	int clip, error;

	*out = (struct motions){0};
	error = model_choose_clip(
		instance->model, request->clip, -1, log, &clip);
	if (!error) {
		error = read_character(request, instance, log, out, say);
	}
	if (error) {
		return error;
	}
	gait_body_make(&body, instance->model);
	if (clip >= 0) {
		for (int i = 0; i < MOTION_ROLES; i++) {
			out->role[i] =
				measure(instance, &body, clip, GAIT_STEPS_MOST);
		}
	} else {
		choose_all(instance, &body, say, out);
	}
	pose_rest(&instance->pose, instance->model);
	instance_update(instance);
	return 0;
}

struct motion motion_of_clip(struct instance *instance, int clip)
{
	struct gait_body body;
	struct motion motion;

	gait_body_make(&body, instance->model);
	motion = measure(instance, &body, clip, GAIT_STEPS_MOST);
	pose_rest(&instance->pose, instance->model);
	instance_update(instance);
	return motion;
}

/* A figure that climbs is at the box's top when it is highest. */
static void leave_out_rise(struct bounds *bounds, const struct motion *motion)
{
	float low = 0.0f, high = 0.0f;

	for (int i = 0; i <= motion->rise_steps; i++) {
		low = scalar_min(motion->rise[i], low);
		high = scalar_max(motion->rise[i], high);
	}
	bounds->low[1] -= low;
	bounds->high[1] -= high;
}

struct bounds motion_bounds(
	struct instance *instance, const struct motion *motion)
{
	struct bounds bounds = bounds_of_clip(instance, motion->clip);

	bounds_stay(&bounds, motion->drift);
	leave_out_rise(&bounds, motion);
	return bounds;
}

/* Interpolates between the heights that were measured. */
static float rise_at(
	const struct motion *motion, const struct model *model, float time_s)
{
	float steps = (float)motion->rise_steps, at;
	int i;

	if (motion->rise_steps == 0) {
		return 0.0f;
	}
	at = scalar_clamp(time_s / model->clip[motion->clip].duration_s * steps,
		0.0f, steps);
	i = at < steps ? (int)at : motion->rise_steps - 1;
	return motion->rise[i] +
		(at - (float)i) * (motion->rise[i + 1] - motion->rise[i]);
}

void motion_drift_at(const struct motion *motion, const struct model *model,
	float time_s, float out[3])
{
	float share = motion->clip >= 0
		? clip_share(&model->clip[motion->clip], time_s)
		: 0.0f;

	out[0] = motion->drift[0] * share;
	out[1] = rise_at(motion, model, time_s);
	out[2] = motion->drift[1] * share;
}
