#include "app/anim/blend.h"

#include "app/anim/transform.h"
#include "platform/base/scalar.h"

float ease_at(enum ease ease, float u)
{
	u = scalar_clamp(u, 0, 1);
	return ease == EASE_CUBIC ? u * u * (3 - 2 * u) : u;
}

void mask_fill(float *mask, int node_count, float weight)
{
	for (int i = 0; i < node_count; i++) {
		mask[i] = weight;
	}
}

void mask_subtree(float *mask, const struct model *model, int node, float weight)
{
	/* Parents come first, so descendants lie behind the node. */
	for (int i = node; i < model->node_count; i++) {
		int ancestor = i;

		while (ancestor > node) {
			ancestor = model->node[ancestor].parent;
		}
		if (ancestor == node) {
			mask[i] = weight;
		}
	}
}

/* A node's morph weights in a pose: where they begin and how many. */
static int weight_range(const struct pose *pose, int node, int *first)
{
	const struct model *model = pose->model;
	int mesh = model->node[node].mesh;

	*first = model->node[node].weight_offset;
	return mesh < 0 ? 0 : model->mesh[mesh].target_count;
}

static void mix_node(const struct pose *a, const struct pose *b, int node,
	float t, struct pose *out)
{
	int first;
	int count = weight_range(a, node, &first);
	const struct pose *whole = t <= 0 ? a : b;

	out->animated[node] = t <= 0 ? a->animated[node]
		: t >= 1             ? b->animated[node]
				     : a->animated[node] || b->animated[node];
	if (t <= 0 || t >= 1) {
		out->local[node] = whole->local[node];
	} else {
		transform_mix(
			&a->local[node], &b->local[node], t, &out->local[node]);
	}
	for (int i = first; i < first + count; i++) {
		out->weight[i] = t <= 0 || t >= 1
			? whole->weight[i]
			: a->weight[i] * (1 - t) + b->weight[i] * t;
	}
}

void pose_mix(const struct pose *a, const struct pose *b, float t,
	const float *mask, struct pose *out)
{
	for (int i = 0; i < out->node_count; i++) {
		mix_node(a, b, i, mask ? t * mask[i] : t, out);
	}
}

static void add_transform(struct transform *pose, const struct transform *layer,
	const struct transform *reference, float weight)
{
	static const float none[4] = {0, 0, 0, 1};
	float turn[4];

	for (int i = 0; i < 3; i++) {
		float scale = reference->scale[i];

		pose->translation[i] += weight *
			(layer->translation[i] - reference->translation[i]);
		/* Where there is nothing to compare with, nothing is added. */
		if (scale != 0) {
			pose->scale[i] *=
				1 + weight * (layer->scale[i] / scale - 1);
		}
	}
	quat_conjugate(reference->rotation, turn);
	quat_multiply(turn, layer->rotation, turn);
	quat_slerp(none, turn, weight, turn);
	quat_multiply(pose->rotation, turn, pose->rotation);
	quat_normalize(pose->rotation);
}

void pose_add(struct pose *pose, const struct pose *layer,
	const struct pose *reference, float weight, const float *mask)
{
	for (int n = 0; n < pose->node_count; n++) {
		float amount = mask ? weight * mask[n] : weight;
		int first;
		int count = weight_range(pose, n, &first);

		if (amount == 0) {
			continue;
		}
		add_transform(&pose->local[n], &layer->local[n],
			&reference->local[n], amount);
		pose->animated[n] = pose->animated[n] || layer->animated[n];
		for (int i = first; i < first + count; i++) {
			pose->weight[i] += amount *
				(layer->weight[i] - reference->weight[i]);
		}
	}
}

int fade_init(struct fade *fade, const struct model *model, struct arena *arena)
{
	*fade = (struct fade){.running = false};
	return pose_init(&fade->from, model, arena);
}

void fade_begin(struct fade *fade, const struct pose *shown, float duration_s,
	enum ease ease)
{
	pose_copy(&fade->from, shown);
	fade->ease = ease;
	fade->duration_s = duration_s;
	fade->elapsed_s = 0;
	fade->running = true;
}

bool fade_update(struct fade *fade, float step_s, struct pose *pose)
{
	float u;

	if (!fade->running) {
		return false;
	}
	fade->elapsed_s += step_s;
	if (!(fade->elapsed_s < fade->duration_s)) {
		fade->running = false;
		return false;
	}
	u = fade->elapsed_s / fade->duration_s;
	pose_mix(&fade->from, pose, ease_at(fade->ease, u), NULL, pose);
	return true;
}

float clip_frame_s(const struct model_clip *clip)
{
	float least = 0;

	for (int c = 0; c < clip->channel_count; c++) {
		const struct model_channel *channel = &clip->channel[c];

		for (int k = 1; k < channel->key_count; k++) {
			float gap = channel->time_s[k] - channel->time_s[k - 1];

			least = least == 0 || gap < least ? gap : least;
		}
	}
	return least > 0 ? least : 1.0f / 30;
}

struct clip_join clip_join_frames(
	const struct model_clip *from, const struct model_clip *to, int frames)
{
	float shorter = from->duration_s < to->duration_s ? from->duration_s
							  : to->duration_s;

	return (struct clip_join){
		.from = from,
		.to = to,
		.overlap_s = scalar_clamp(
			(float)frames * clip_frame_s(from), 0, shorter),
		.ease = EASE_CUBIC,
		.interpolation = CLIP_AUTO,
	};
}

float clip_join_duration(const struct clip_join *join)
{
	return join->from->duration_s + join->to->duration_s - join->overlap_s;
}

void clip_join_sample(const struct clip_join *join, float time_s,
	struct clip_cursor *from_cursor, struct clip_cursor *to_cursor,
	struct pose *scratch, struct pose *pose)
{
	float into_s = time_s - (join->from->duration_s - join->overlap_s);

	if (!(into_s > 0)) {
		clip_pose(join->from, time_s, join->interpolation, from_cursor,
			pose);
		return;
	}
	clip_pose(join->to, into_s, join->interpolation, to_cursor, pose);
	if (into_s < join->overlap_s) {
		clip_pose(join->from, time_s, join->interpolation, from_cursor,
			scratch);
		pose_mix(scratch, pose,
			ease_at(join->ease, into_s / join->overlap_s), NULL,
			pose);
	}
}
