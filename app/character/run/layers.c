#include "app/character/run/layers.h"

#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/anim/pose_blend.h"
#include "app/character/run/entry.h"

#include <string.h>

/* A layer that plays once fades in and out within its clip. */
static float weight_of(struct character_layer *layer)
{
	float fade_s = layer->is.fade_s, duration_s, left_s, weight;

	if (!layer->once) {
		return layer->is.now;
	}
	duration_s = character_entry_duration_s(&layer->entry);
	left_s = duration_s - (float)layer->entry.time_s;
	if (!layer->playing || left_s <= 0) {
		layer->playing = false;
		return 0;
	}
	weight = *layer->is.weight;
	if (fade_s > 0) {
		weight *= ease_at(EASE_CUBIC,
				  (float)layer->entry.time_s / fade_s) *
			ease_at(EASE_CUBIC, left_s / fade_s);
	}
	return weight;
}

void character_layer_play(struct character_layer *layer)
{
	layer->playing = true;
	layer->entry.time_s = 0;
	layer->entry.shown_s = -1;
}

void character_layer_run(struct character *character, void *what)
{
	struct character_layer *layer = what;
	struct pose *pose = &character->instance->pose;
	float weight;

	if (layer->playing || !layer->once) {
		layer->entry.time_s +=
			(double)(character->step_s * *layer->rate);
	}
	weight = weight_of(layer);
	layer->is.now = weight;
	if (weight == 0) {
		return;
	}
	layer->entry.weight = 1;
	character_entry_sample(character, &layer->entry,
		layer->once ? CLIP_ONCE : CLIP_LOOP, -1, &character->scratch);
	if (layer->additive) {
		pose_add(pose, &character->scratch, &layer->reference, weight,
			layer->mask);
	} else {
		pose_mix(pose, &character->scratch, weight, layer->mask, pose);
	}
}

void character_expression_run(struct character *character, void *what)
{
	const struct character_expression *expression = what;
	float *weight = character->instance->pose.weight;

	for (int i = 0; i < expression->count; i++) {
		weight[expression->target[i]] +=
			expression->amount[i] * expression->is.now;
	}
}

void character_morph_go(struct character_morph *morph, int key)
{
	memcpy(morph->source, morph->temporal,
		(size_t)morph->target_count * sizeof(*morph->source));
	morph->destiny = key;
	morph->elapsed_s = 0;
	morph->count = 0;
	morph->running = true;
}

/* One coordinate of a Bezier curve from 0 to 1 with two inner points. */
static float bezier(float a, float b, float s)
{
	float left = 1 - s;

	return 3 * left * left * s * a + 3 * left * s * s * b + s * s * s;
}

/* The Bezier's y where x is u; x grows with s, so halving finds it. */
static float bezier_at(const float point[4], float u)
{
	float low = 0, high = 1;

	for (int i = 0; i < 20; i++) {
		float middle = 0.5f * (low + high);

		if (bezier(point[0], point[2], middle) < u) {
			low = middle;
		} else {
			high = middle;
		}
	}
	return bezier(point[1], point[3], 0.5f * (low + high));
}

float character_morph_curve(const struct character_morph *morph, float u)
{
	int last = morph->table_count - 1, at;

	if (u <= 0 || u >= 1) {
		return u <= 0 ? 0 : 1;
	}
	if (morph->curve == CHARACTER_CURVE_BEZIER) {
		return bezier_at(morph->table, u);
	}
	if (morph->curve != CHARACTER_CURVE_TABLE) {
		return u;
	}
	at = (int)(u * (float)last);
	at = at < last ? at : last - 1;
	u = u * (float)last - (float)at;
	return morph->table[at] * (1 - u) + morph->table[at + 1] * u;
}

static float plain_omega(const struct character_morph *morph)
{
	float duration_s = morph->duration_s / morph->pace;

	if (!morph->running) {
		return 1;
	}
	if (morph->frame_count > 0) {
		float frames = (float)morph->frame_count / morph->pace;

		return scalar_clamp((float)morph->count / frames, 0, 1);
	}
	return duration_s > 0 ? scalar_clamp(morph->elapsed_s / duration_s, 0, 1)
			      : 1;
}

float character_morph_omega(const struct character_morph *morph)
{
	return character_morph_curve(morph, plain_omega(morph));
}

/*
 * By frames, each frame adds a share of Destiny - Source to Temporal (AN4044,
 * 1.2.2); over time, Temporal is computed from both (1.2.1).
 */
static void move_on(struct character_morph *morph, float step_s)
{
	const float *destiny = morph->key[morph->destiny];
	float before = character_morph_omega(morph), omega;

	morph->elapsed_s += step_s;
	morph->count += step_s > 0;
	omega = character_morph_omega(morph);
	if (plain_omega(morph) >= 1) {
		morph->running = false;
		memcpy(morph->temporal, destiny,
			(size_t)morph->target_count * sizeof(*destiny));
		return;
	}
	for (int i = 0; i < morph->target_count; i++) {
		float all = destiny[i] - morph->source[i];

		if (morph->frame_count > 0) {
			morph->temporal[i] += all * (omega - before);
		} else {
			morph->temporal[i] = morph->source[i] + all * omega;
		}
	}
}

/* The sine that is mounted on the line (1.2.5); 0 at both ends. */
static void add_sine(const struct character_morph *morph, struct pose *pose)
{
	struct transform *local = &pose->local[morph->node];
	float moved[3];
	float wave =
		morph->amplitude_m * scalar_sin(SCALAR_PI * plain_omega(morph));

	for (int i = 0; i < 3; i++) {
		moved[i] = morph->direction[i] * wave * local->scale[i];
	}
	quat_rotate(local->rotation, moved, moved);
	vec_add_scaled(local->translation, moved, 1, local->translation);
	pose->animated[morph->node] = true;
}

void character_morph_run(struct character *character, void *what)
{
	struct character_morph *morph = what;
	struct pose *pose = &character->instance->pose;
	int first = pose->model->node[morph->node].weight_offset;

	if (morph->running) {
		move_on(morph, character->step_s);
	}
	for (int i = 0; i < morph->target_count; i++) {
		pose->weight[first + i] += morph->temporal[i];
	}
	if (morph->curve == CHARACTER_CURVE_SINE && morph->running) {
		add_sine(morph, pose);
	}
}
