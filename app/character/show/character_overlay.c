#include "app/character/show/character_overlay.h"

#include "app/character/show/label_name.h"

#include "app/character/run/layers.h"
#include "app/character/state/machine.h"
#include "platform/base/scalar.h"

#include <string.h>

/* The height of a sine in the graph of a morph's curve. */
static const float graph_wave = 0.35f;

static void add_layer(
	struct overlay_motion *motion, const struct overlay_layer *layer)
{
	if (motion->layer_count < OVERLAY_LAYERS_MAX) {
		motion->layer[motion->layer_count++] = *layer;
	}
}

/* Adds the clips that a state blends as layers. */
static void add_clips(
	const struct character *character, struct overlay_motion *out)
{
	const struct character_machine *machine = &character->machine;
	const struct character_state *state = &machine->state[machine->current];

	for (int i = 0; i < state->entry_count && state->entry_count > 1; i++) {
		const struct character_entry *entry = &state->entry[i];
		const struct model_clip *clip = entry->of->clip;

		if (entry->weight > 0) {
			add_layer(out,
				&(struct overlay_layer){
					clip ? clip->name : "rest", "clip",
					clip ? (int)(clip -
						       character->instance
							       ->model->clip)
					     : 0,
					entry->weight, NULL});
		}
	}
}

static void describe_morph(const struct character_morph *morph, double now_s,
	struct overlay_motion *out)
{
	const struct character_curve *curve = &morph->curve[morph->chosen];

	out->morphing = true;
	out->node = morph->node;
	out->from = morph->before - 1;
	out->to = morph->destiny - 1;
	out->omega = character_morph_omega(morph, now_s);
	out->wave = curve->kind == CHARACTER_CURVE_SINE ? graph_wave : 0.0f;
	out->shape = character_morph_curve;
	out->shape_user = curve;
}

/*
 * Describes how a clip goes from one key frame to the next: the weights are 0
 * but for one target, or for two whose sum is 1. Of a clip that mixes its
 * targets in another way there is nothing to say.
 */
static void describe_key_frames(const struct character *character,
	const struct model_clip *clip, struct overlay_motion *out)
{
	const struct model *model = character->instance->model;
	int node = model_find_morphed(model), count = 0, from = -1, to = -1;
	const float *weight;
	float sum = 0;

	if (node < 0 || !clip || !model_clip_moves_weights(clip, node)) {
		return;
	}
	weight = character->instance->pose.weight +
		model->node[node].weight_offset;
	for (int i = 0; i < model->mesh[model->node[node].mesh].target_count;
		i++) {
		if (weight[i] != 0) {
			count++;
			from = to;
			to = i;
			sum += weight[i];
		}
	}
	if (count > 2 || (count == 2 && scalar_abs(sum - 1) > 1e-3f)) {
		return;
	}
	out->morphing = true;
	out->node = node;
	out->from = from;
	out->to = to;
	out->omega = count > 0 ? weight[to] : 0;
}

void character_overlay_describe(
	const struct character *character, struct overlay_motion *out)
{
	const struct model *model = character->instance->model;
	const struct character_entry *entry = character_machine_entry(character);
	const struct inertia *inertia = &character->machine.inertia;

	out->clip = entry->of->clip ? (int)(entry->of->clip - model->clip) : -1;
	out->time_s = entry->shown_s;
	out->interpolation = character->interpolation;
	out->traveller = character->motion.root;
	out->travel = out->traveller >= 0 ? entry->of->travel : NULL;
	if (character->morph_count > 0 && character->morph[0].plain_keys) {
		describe_morph(&character->morph[0], character->now_s, out);
	} else {
		describe_key_frames(character, entry->of->clip, out);
	}
	add_clips(character, out);
	for (int i = 0; i < character->layer_count; i++) {
		const struct character_layer *layer = &character->layer[i];

		if (layer->is.now > 0) {
			add_layer(out,
				&(struct overlay_layer){layer->is.name, "layer",
					i + 1, layer->is.now, layer->mask});
		}
	}
	for (int i = 0; i < character->switch_count; i++) {
		const struct character_switch *is = character->switches[i];

		if (is->now > 0 && !is->unlabelled &&
			strcmp(is->kind, "layer") != 0) {
			add_layer(out,
				&(struct overlay_layer){is->name, is->kind,
					label_name_rank(character, i), is->now,
					NULL});
		}
	}
	if (inertia->running) {
		add_layer(out,
			&(struct overlay_layer){.name = "fade",
				.weight = inertia->elapsed_s /
					inertia->duration_s});
	}
}
