/*
 * Sections [clip], and what is measured of each clip: how far its root goes,
 * how fast it goes over the ground, where its feet step and how high its soles
 * are. For this the instance is posed at even times of the clip.
 */
#include "app/character/build/build.h"
#include "app/character/build/gait.h"

#include "app/character/run/feet.h"
#include "platform/base/scalar.h"

#include <cglm/cglm.h>
#include <errno.h>
#include <string.h>

static int read_marks(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_clip *clip = member;
	float duration_s = clip->clip ? clip->clip->duration_s : 0;

	clip->mark_count = 0;
	while (!character_at_end(words)) {
		float *mark = &clip->mark[clip->mark_count];

		if (clip->mark_count == CHARACTER_MARKS_MAX ||
			!character_take_number(words, mark) || *mark < 0 ||
			*mark > duration_s ||
			(clip->mark_count > 0 && *mark <= mark[-1])) {
			return character_fail(words,
				"give at most %d increasing times within the clip's %g s, such as %s",
				CHARACTER_MARKS_MAX, (double)duration_s,
				key->right);
		}
		clip->mark_count++;
		character_take(words, ",");
	}
	if (clip->mark[clip->mark_count - 1] - clip->mark[0] >= duration_s) {
		return character_fail(words,
			"the first and the last time are the same moment of a round: leave out one of them");
	}
	return 0;
}

static int read_event(struct character_words *words,
	const struct character_key *key, void *member)
{
	struct character_clip *clip = member;
	struct character_event **last = &clip->event;
	float duration_s = clip->clip ? clip->clip->duration_s : 0;
	struct character_action *action = NULL;
	float time_s;
	int error;

	if (!character_take_number(words, &time_s) || time_s < 0 ||
		time_s > duration_s) {
		return character_fail(words,
			"an event begins with its time within the clip's %g s: give %s",
			(double)duration_s, key->right);
	}
	do {
		error = character_read_action(words, &action, NULL);
	} while (!error && character_take(words, ","));
	while (*last) {
		last = &(*last)->next;
	}
	*last = ARENA_NEW(words->build->arena, struct character_event);
	if (!*last) {
		return character_fail_memory(words->build);
	}
	**last = (struct character_event){time_s, action, NULL};
	return error;
}

static const struct character_key keys[] = {
	{"marks", read_marks, .right = "0.1 0.6"},
	{"event", read_event,
		.right = "a time and actions, such as 0.25 line step"},
	{0},
};

/* Poses the nodes as they are at a fraction of the clip. */
static void pose_at(const struct character_build *build,
	const struct character_clip *clip, float fraction)
{
	struct instance *instance = build->character->instance;

	pose_rest(&instance->pose, build->model);
	if (clip->clip) {
		clip_sample(clip->clip, fraction * clip->clip->duration_s,
			&(struct clip_cursor){0}, &instance->pose);
	}
	instance_update_nodes(instance);
}

static void copy_position(
	const struct character_build *build, int node, float out[3])
{
	memcpy(out, build->character->instance->world[node][3],
		sizeof(float[3]));
}

/* Converts a level way in the world to the frame of the node's translation. */
static void level_to_local(const struct character_build *build, int node,
	const float way[2], float out[3])
{
	int parent = build->model->node[node].parent;
	mat3 linear = GLM_MAT3_IDENTITY_INIT;
	float level[3] = {way[0], 0, way[1]};

	if (parent >= 0) {
		glm_mat4_pick3(
			build->character->instance->world[parent], linear);
	}
	if (glm_mat3_det(linear) != 0) {
		glm_mat3_inv(linear, linear);
		glm_mat3_mulv(linear, level, out);
	}
}

/*
 * Finds how far the root goes over the ground from the clip's start to its end.
 */
static void find_travel(const struct character_build *build, int root,
	struct character_clip *clip)
{
	float start[3], end[3];

	if (root < 0 || !clip->clip || clip->clip->duration_s <= 0) {
		return;
	}
	pose_at(build, clip, 0);
	copy_position(build, root, start);
	pose_at(build, clip, 1);
	copy_position(build, root, end);
	for (int i = 0; i < 2; i++) {
		clip->carried_m[i] = end[2 * i] - start[2 * i];
		clip->ground_m_per_s[i] =
			clip->carried_m[i] / clip->clip->duration_s;
	}
	level_to_local(build, root, clip->carried_m, clip->travel);
}

static bool is_same_way(const float a[2], const float b[2])
{
	float x = a[0] - b[0], z = a[1] - b[1];

	return x * x + z * z < 1e-3f * (b[0] * b[0] + b[1] * b[1]);
}

/*
 * Returns the uppermost node that goes as far as the whole figure does, or -1.
 */
static int find_carrier(const struct character_build *build,
	const struct character_clip *clip, const float drift[2])
{
	int found = -1;

	for (int i = 0; i < clip->clip->channel_count; i++) {
		const struct model_channel *channel = &clip->clip->channel[i];
		struct character_clip tried = {.clip = clip->clip};

		if (channel->path != MODEL_TRANSLATION || channel->constant ||
			(found >= 0 && found < channel->node)) {
			continue;
		}
		find_travel(build, channel->node, &tried);
		if (is_same_way(tried.carried_m, drift)) {
			found = channel->node;
		}
	}
	return found;
}

/*
 * Whether a clip carries the model, whose feet do not step, farther than it is
 * long, as one that drives, swims or flies.
 */
static bool goes_away(const struct gait *gait)
{
	float x = gait->drift[0], z = gait->drift[1];

	return x * x + z * z > gait->extent * gait->extent;
}

static bool carries_all(const struct model *model, int node)
{
	return node >= 0 &&
		model_is_below(model, model_find_carrier(model), node);
}

static bool is_zero(const float way[2])
{
	return way[0] == 0 && way[1] == 0;
}

/*
 * Finds how fast a clip goes over the ground, by the vertices that touch it. A
 * clip that goes away stays in its place, and the ground moves instead. Below a
 * model that slides less far, such as a crate that is pushed, the ground rests.
 */
static void find_gait(const struct character_build *build,
	const struct gait *gait, struct character_clip *clip)
{
	struct character_motion *motion = &build->character->motion;
	bool walks = !is_zero(gait->velocity);
	bool leaves = walks ? !is_zero(gait->drift) : goes_away(gait);
	int root = motion->root;

	if (leaves && root < 0) {
		root = find_carrier(build, clip, gait->drift);
	}
	/* One of two cars must not stay behind. */
	if (leaves && (walks || carries_all(build->model, root))) {
		motion->root = root;
		find_travel(build, root, clip);
	}
	/* Else the ground goes with the root that the file names, if it does. */
	for (int axis = 0; axis < 2 && walks; axis++) {
		clip->ground_m_per_s[axis] = gait->velocity[axis];
		if (gait->drift[axis] != 0) {
			clip->ground_m_per_s[axis] -=
				(gait->drift[axis] - clip->carried_m[axis]) /
				clip->clip->duration_s;
		}
	}
}

static void find_gaits(const struct character_build *build)
{
	struct character *character = build->character;
	struct gait_body body;

	gait_body_make(&body, build->model);
	for (int i = 0; i < build->model->clip_count; i++) {
		struct gait gait = gait_measure(&body, character->instance, i,
			gait_steps_for(build->model->clip_count));

		find_gait(build, &gait, &character->clip[i]);
	}
}

/* Samples how far the first foot is ahead of the second one, along x and z. */
static void sample_feet(const struct character_build *build,
	const struct character_clip *clip, float ahead[CHARACTER_SAMPLES][2])
{
	struct character_motion *motion = &build->character->motion;

	for (int i = 0; i < CHARACTER_SAMPLES; i++) {
		float foot[2][3];

		pose_at(build, clip, (float)i / CHARACTER_SAMPLES);
		for (int f = 0; f < 2; f++) {
			copy_position(build, motion->foot[f], foot[f]);
			motion->low_m[f] =
				scalar_min(foot[f][1], motion->low_m[f]);
		}
		ahead[i][0] = foot[0][0] - foot[1][0];
		ahead[i][1] = foot[0][2] - foot[1][2];
	}
}

/* Finds the samples of the least and the largest value; returns their range. */
static float find_extremes(
	float ahead[CHARACTER_SAMPLES][2], int axis, int *least, int *most)
{
	*least = *most = 0;
	for (int i = 1; i < CHARACTER_SAMPLES; i++) {
		*least = ahead[i][axis] < ahead[*least][axis] ? i : *least;
		*most = ahead[i][axis] > ahead[*most][axis] ? i : *most;
	}
	return ahead[*most][axis] - ahead[*least][axis];
}

/* Marks where each foot is ahead of the other one most, if they step. */
static void find_steps(
	const struct character_build *build, struct character_clip *clip)
{
	struct character_motion *motion = &build->character->motion;
	float ahead[CHARACTER_SAMPLES][2];
	int first[2], second[2], axis;
	float range[2];

	if (motion->foot[0] < 0) {
		return;
	}
	sample_feet(build, clip, ahead);
	for (axis = 0; axis < 2; axis++) {
		range[axis] =
			find_extremes(ahead, axis, &second[axis], &first[axis]);
	}
	axis = range[1] >= range[0] ? 1 : 0;
	if (clip->mark_count > 0 || range[axis] <= 2 * motion->near_m) {
		return;
	}
	/* The first mark is the first foot's, so the second may lie beyond the
	   clip's end. */
	clip->mark_count = 2;
	clip->mark[0] =
		clip->clip->duration_s * (float)first[axis] / CHARACTER_SAMPLES;
	clip->mark[1] = clip->clip->duration_s * (float)second[axis] /
		CHARACTER_SAMPLES;
	if (second[axis] < first[axis]) {
		clip->mark[1] += clip->clip->duration_s;
	}
}

/* Samples the height of each pair's lower sole during the clip. */
static int find_soles(struct character_build *build, struct character_clip *clip)
{
	struct character *character = build->character;
	int pairs = character_text_count(build->text, "feet");

	if (pairs == 0) {
		return 0;
	}
	clip->sole_m =
		arena_alloc(build->arena, (size_t)pairs, sizeof(*clip->sole_m));
	if (!clip->sole_m) {
		return character_fail_memory(build);
	}
	for (int i = 0; i < CHARACTER_SAMPLES; i++) {
		pose_at(build, clip, (float)i / CHARACTER_SAMPLES);
		for (struct character_feet *feet = character->feet; feet;
			feet = feet->next) {
			clip->sole_m[feet->pair][i] =
				character_feet_place(feet, character->instance);
		}
	}
	return 0;
}

/* The list holds all clips of the model and, at its end, the rest pose. */
int character_build_clip_list(struct character_build *build)
{
	struct character *character = build->character;

	character->clip_count = build->model->clip_count + 1;
	character->clip = ARENA_ARRAY(build->arena, struct character_clip,
		(size_t)character->clip_count);
	if (!character->clip) {
		return character_fail_memory(build);
	}
	for (int i = 0; i < build->model->clip_count; i++) {
		character->clip[i].clip = &build->model->clip[i];
	}
	return 0;
}

int character_build_clips(struct character_build *build)
{
	struct character *character = build->character;
	int error = 0;

	for (const struct character_section *section =
			character_text_find(build->text->first, "clip");
		section && !error;
		section = character_text_find(section->next, "clip")) {
		int clip = character_name_in_heading(build, section, "name",
			section->name, character_name_clip);

		error = clip == -1
			? -EINVAL
			: character_read_section(build, section, keys,
				  &character->clip[clip < 0
						  ? character->clip_count - 1
						  : clip]);
	}
	for (int i = 0; i < character->clip_count && !error; i++) {
		find_travel(build, character->motion.root, &character->clip[i]);
		find_steps(build, &character->clip[i]);
		error = find_soles(build, &character->clip[i]);
	}
	if (!error && character->motion.by_clips) {
		find_gaits(build);
	}
	pose_rest(&character->instance->pose, build->model);
	instance_update_nodes(character->instance);
	return error;
}
