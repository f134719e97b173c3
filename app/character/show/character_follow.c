#include "app/character/show/character_follow.h"

#include "app/anim/clip.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <stdlib.h>

enum {
	STEPS = 12
};

/*
 * A model that goes further than this many times its longest side is followed.
 * In a clip whose travel is taken out, fewer times suffice: if that travel was
 * uneven, a part of it is left in the clip.
 */
static const float far_sides = 6.0f, far_sides_of_walk = 2.5f;

/* The middle of the model and all nodes at some times of a clip. */
struct track {
	int node_count;
	float middle[STEPS + 1][3];
	float (*node)[3]; /* [STEPS + 1][node_count] */
};

static bool goes_far(const struct bounds *box, const struct bounds_sides *sides,
	bool walks, int axis)
{
	float longest = 0.0f;

	for (int i = 0; i < 3; i++) {
		longest = scalar_max(sides->side[i], longest);
	}
	return box->high[axis] - box->low[axis] >
		(walks ? far_sides_of_walk : far_sides) * longest;
}

static void place_of(const struct instance *instance, int node, float out[3])
{
	for (int axis = 0; axis < 3; axis++) {
		out[axis] =
			instance->world[node][3][axis] * instance->unit_scale;
	}
}

/* Takes the travel of the motion's root out of the pose. */
static void take_back(const struct character *character, int clip, float part)
{
	int root = character->motion.root;
	const float *travel = character->clip[clip].travel;

	for (int axis = 0; root >= 0 && axis < 3; axis++) {
		character->instance->pose.local[root].translation[axis] -=
			travel[axis] * part;
	}
}

static void fill_track(
	struct track *track, const struct character *character, int clip)
{
	struct instance *instance = character->instance;
	const struct model_clip *c = &instance->model->clip[clip];
	struct clip_cursor none = {0};

	pose_rest(&instance->pose, instance->model);
	for (int step = 0; step <= STEPS; step++) {
		float(*node)[3] = &track->node[step * track->node_count];
		float time_s = c->duration_s * (float)step / (float)STEPS;
		struct bounds now;

		clip_sample(c, time_s, &none, &instance->pose);
		take_back(character, clip, clip_share(c, time_s));
		instance_update(instance);
		now = bounds_of_instance(instance);
		bounds_center(&now, track->middle[step]);
		for (int n = 0; n < track->node_count; n++) {
			place_of(instance, n, node[n]);
		}
	}
}

/*
 * Finds the greatest change, along each axis, of the offset from the node to
 * the middle since the start.
 */
static void find_error(const struct track *track, int node, float out[3])
{
	out[0] = out[1] = out[2] = 0.0f;
	for (int step = 0; step <= STEPS; step++) {
		const float *at = track->node[step * track->node_count + node];

		for (int axis = 0; axis < 3; axis++) {
			float now = track->middle[step][axis] - at[axis];
			float first = track->middle[0][axis] -
				track->node[node][axis];
			float off = scalar_abs(now - first);

			out[axis] = scalar_max(off, out[axis]);
		}
	}
}

static float sum_followed(const struct character_follow *follow, float error[3])
{
	float sum = 0.0f;

	for (int axis = 0; axis < 3; axis++) {
		sum += follow->axis[axis] ? error[axis] : 0.0f;
	}
	return sum;
}

static void choose_node(struct character_follow *follow,
	const struct track *track, const struct bounds_sides *sides)
{
	float error[3], least = 0.0f;

	for (int n = 0; n < track->node_count; n++) {
		float sum;

		find_error(track, n, error);
		sum = sum_followed(follow, error);
		if (follow->node < 0 || sum < least) {
			follow->node = n;
			least = sum;
		}
	}
	find_error(track, follow->node, error);
	for (int axis = 0; axis < 3; axis++) {
		follow->start[axis] = track->node[follow->node][axis];
		follow->offset[axis] =
			track->middle[0][axis] - follow->start[axis];
		follow->half[axis] = 0.5f * sides->side[axis] + error[axis];
	}
}

/* Poses the instance if the clip goes far. Returns 0 or -ENOMEM. */
static int find(struct character_follow *follow,
	const struct character *character, int clip, const struct bounds *box,
	const struct bounds_sides *sides)
{
	struct track track = {
		.node_count = character->instance->model->node_count};
	const float *carried = character->clip[clip].carried_m;
	bool walks = carried[0] != 0.0f || carried[1] != 0.0f, any = false;

	*follow = (struct character_follow){.node = -1};
	for (int axis = 0; axis < 3; axis++) {
		follow->axis[axis] = goes_far(box, sides, walks, axis);
		any = any || follow->axis[axis];
	}
	if (!any) {
		return 0;
	}
	track.node = calloc(
		(size_t)track.node_count * (STEPS + 1), sizeof(*track.node));
	if (!track.node) {
		return -ENOMEM;
	}
	fill_track(&track, character, clip);
	choose_node(follow, &track, sides);
	free(track.node);
	return 0;
}

/*
 * Finds what to follow in a clip. If there is something, *box becomes the box
 * of the model in the place of the rest pose.
 */
static int find_followed(struct character_follow *follow,
	const struct character *character, int clip, const struct bounds *rest,
	const struct bounds_sides *sides, struct bounds *box)
{
	float low = box->low[1], home[3];
	int error = find(follow, character, clip, box, sides);

	if (error || follow->node < 0) {
		return error;
	}
	bounds_center(rest, home);
	for (int axis = 0; axis < 3; axis++) {
		home[axis] -= follow->start[axis] + follow->offset[axis];
	}
	character_follow_box(follow, home, box);
	/* The box stays as low as the clip goes; the ground is below it. */
	box->low[1] = low;
	return 0;
}

static int find_all(const struct character *character, float (*way)[2],
	struct bounds_sides *sides, const struct character_boxes *out)
{
	struct instance *instance = character->instance;
	int count = instance->model->clip_count;
	int error = 0;

	for (int i = 0; i < 2 * count; i++) {
		way[i / 2][i % 2] = character->clip[i / 2].carried_m[i % 2] *
			instance->unit_scale;
	}
	*out->rest = bounds_of_model(
		instance, (const float(*)[2])way, out->clip, sides);
	for (int i = 0; i < count && !error; i++) {
		error = find_followed(&out->follow[i], character, i, out->rest,
			&sides[i], &out->clip[i]);
	}
	return error;
}

int character_follow_find(
	const struct character *character, const struct character_boxes *out)
{
	size_t count = (size_t)character->instance->model->clip_count;
	struct bounds_sides *sides = calloc(count + 1, sizeof(*sides));
	float(*way)[2] = calloc(count + 1, sizeof(*way));
	int error =
		sides && way ? find_all(character, way, sides, out) : -ENOMEM;

	free(way);
	free(sides);
	return error;
}

void character_follow_way(const struct character_follow *follow,
	const struct instance *instance, float out[3])
{
	float at[3];

	place_of(instance, follow->node, at);
	for (int axis = 0; axis < 3; axis++) {
		out[axis] = follow->axis[axis] ? at[axis] - follow->start[axis]
					       : 0.0f;
	}
}

void character_follow_box(const struct character_follow *follow,
	const float way[3], struct bounds *box)
{
	for (int axis = 0; axis < 3; axis++) {
		float middle =
			follow->start[axis] + follow->offset[axis] + way[axis];

		if (follow->axis[axis]) {
			box->low[axis] = middle - follow->half[axis];
			box->high[axis] = middle + follow->half[axis];
		}
	}
}
