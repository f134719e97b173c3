#include "app/character/run/layers.h"

#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/anim/pose_blend.h"
#include "app/character/state/entry.h"

#include <string.h>

/* A layer that plays once fades in and out within its clip. */
static float weight_of(struct character_layer *layer)
{
	float fade_s = layer->is.fade_s, time_s, left_s, weight;

	if (!layer->once) {
		return layer->is.now;
	}
	time_s = (float)layer->entry.time_s;
	left_s = character_entry_duration_s(&layer->entry) - time_s;
	if (*layer->rate < 0) {
		float done_s = left_s;

		left_s = time_s;
		time_s = done_s;
	}
	if (!layer->playing || left_s <= 0) {
		layer->playing = false;
		return 0;
	}
	weight = *layer->is.weight;
	if (fade_s > 0) {
		weight *= ease_at(EASE_CUBIC, time_s / fade_s) *
			ease_at(EASE_CUBIC, left_s / fade_s);
	}
	return weight;
}

void character_layer_play(struct character_layer *layer)
{
	layer->playing = true;
	character_entry_begin(&layer->entry,
		*layer->rate < 0
			? (double)character_entry_duration_s(&layer->entry)
			: 0);
}

void character_layer_run(struct character *character, void *what)
{
	struct character_layer *layer = what;
	struct pose *pose = &character->instance->pose;
	enum clip_repeat repeat = layer->once ? CLIP_ONCE : CLIP_LOOP;
	bool played = layer->playing;
	float weight;

	if (layer->playing || !layer->once) {
		character_entry_move(&layer->entry,
			character->exact_s * (double)*layer->rate, NULL);
	}
	weight = weight_of(layer);
	layer->is.now = weight;
	if (weight == 0) {
		/* The frame in which it ends shows nothing but causes events. */
		if (played && !layer->playing && layer->entry.of->clip &&
			*layer->is.weight > 0) {
			character_entry_show(character, &layer->entry, repeat);
		}
		return;
	}
	if (layer->additive) {
		character_entry_sample(
			character, &layer->entry, repeat, &character->scratch);
		pose_add(pose, &character->scratch, &layer->reference, weight,
			layer->mask);
	} else {
		character_entry_mix(
			character, &layer->entry, repeat, weight, pose);
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

/*
 * Returns one coordinate, at s, of a Bezier curve from 0 to 1 whose inner
 * control points are a and b.
 */
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

float character_morph_curve(const void *user, float omega)
{
	const struct character_curve *curve = user;
	int last = curve->table_count - 1, at;

	if (curve->kind == CHARACTER_CURVE_BEZIER) {
		return bezier_at(curve->table, omega);
	}
	if (curve->kind != CHARACTER_CURVE_TABLE) {
		return omega;
	}
	omega *= (float)last;
	at = scalar_to_int((double)omega, 0, last - 1);
	omega -= (float)at;
	return curve->table[at] * (1 - omega) + curve->table[at + 1] * omega;
}

void character_morph_go(struct character_morph *morph, int key, double now_s)
{
	const struct character_curve *curve = &morph->curve[morph->chosen];
	float frames = (float)morph->frame_count / morph->pace;
	struct morph_motion motion = {
		.timing = morph->by_frames ? MORPH_BY_FRAMES : MORPH_OVER_TIME,
		.curve = curve->kind == CHARACTER_CURVE_TABLE ||
				curve->kind == CHARACTER_CURVE_BEZIER
			? MORPH_SHAPED
			: MORPH_LINEAR, /* a sine does not move the weights */
		.duration_ms = 1000 * morph->duration_s / morph->pace,
		.frame_count = scalar_to_int((double)frames + 0.5, 1, 1 << 20),
		.shape = character_morph_curve,
		.user = curve,
	};

	morph->before = morph->destiny;
	morph->destiny = key;
	morph_trigger(&morph->morph, morph->key[key], &motion, now_s * 1000);
}

float character_morph_omega(const struct character_morph *morph, double now_s)
{
	return morph_omega(&morph->morph, now_s * 1000);
}

/*
 * Adds the sine that is mounted on the line (AN4044, section 1.2.5), which is 0
 * at both ends. It moves the whole node, because the vertices cannot be bent
 * one by one.
 */
static void add_sine(const struct character_morph *morph,
	const struct morph_wave *wave, float omega, struct pose *pose)
{
	struct transform *local = &pose->local[morph->node];
	float moved[3];
	float size = wave->amplitude * scalar_sin(SCALAR_PI * omega);

	for (int i = 0; i < 3; i++) {
		moved[i] = wave->direction[i] * size * local->scale[i];
	}
	quat_rotate(local->rotation, moved, moved);
	vec_add_scaled(local->translation, moved, 1, local->translation);
	pose->animated[morph->node] = true;
}

void character_morph_run(struct character *character, void *what)
{
	struct character_morph *morph = what;
	const struct character_curve *curve = &morph->curve[morph->chosen];
	struct pose *pose = &character->instance->pose;
	int first = pose->model->node[morph->node].weight_offset;

	if (character->step_s > 0) {
		morph_update(&morph->morph, character->now_s * 1000);
	}
	for (int i = 0; i < morph->target_count; i++) {
		pose->weight[first + i] +=
			morph->morph.temporal[i / 3][i % 3] * *morph->weight;
	}
	if (curve->kind == CHARACTER_CURVE_SINE && morph->morph.running &&
		morph->bend.part_count == 0) {
		add_sine(morph, &curve->wave,
			character_morph_omega(morph, character->now_s), pose);
	}
}

void character_morph_bend(struct character_morph *morph, double now_s)
{
	bool sine = morph->curve[morph->chosen].kind == CHARACTER_CURVE_SINE;

	if (morph->bend.part_count > 0) {
		bend_update(&morph->bend,
			morph->turn_deg ? *morph->turn_deg * (SCALAR_PI / 180)
					: 0,
			sine && morph->morph.running
				? character_morph_omega(morph, now_s)
				: 0);
	}
}

void character_morph_use_curve(struct character_morph *morph, int curve)
{
	morph->chosen = curve;
	if (morph->curve[curve].kind == CHARACTER_CURVE_SINE) {
		bend_set_wave(&morph->bend, &morph->curve[curve].wave);
	}
}
