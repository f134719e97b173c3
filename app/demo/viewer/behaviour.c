#include "app/demo/viewer/behaviour.h"

#include "app/character/character.h"
#include "app/character/run/feet.h"
#include "app/character/run/layers.h"
#include "app/character/sketch/character_sketch.h"
#include "app/character/state/machine.h"
#include "app/demo/viewer/behaviour_bounds.h"
#include "app/demo/viewer/behaviour_label.h"
#include "app/demo/viewer/behaviour_scene.h"
#include "platform/base/file.h"
#include "platform/buttons/gpio_output.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* Height of a sine in the graph of a morph's curve. */
static const float graph_wave = 0.35f;
static const float ease_per_s = 5.0f; /* of the camera to other clips' box */

bool behaviour_find_file(const struct demo_env *env, char *path, size_t size)
{
	const char *given = env->character;

	if (given) {
		int length = snprintf(path, size, "%s", given);

		return strcmp(given, "none") != 0 && length >= 0 &&
			(size_t)length < size;
	}
	/* A clip that is asked for plays by itself. */
	return !env->clip &&
		character_text_path_beside(env->model_path, path, size) &&
		file_exists(path);
}

/* Reads what `limber character` would write for the model. */
static int read_sketch(
	const struct demo_env *env, struct actor *actor, struct character **out)
{
	struct character_sketch_play play = {
		.rate = env->speed, .repeat = env->repeat};
	char *text = NULL;
	size_t size = 0;
	FILE *file;
	int error = model_choose_clip(
		actor->model, env->clip, 0, env->log, &play.clip);

	if (error) {
		return error;
	}
	error = -ENOMEM;
	file = open_memstream(&text, &size);
	if (file) {
		character_sketch(actor->model, &play, file);
		fclose(file);
	}
	file = text && size > 0 ? fmemopen(text, size, "r") : NULL;
	if (file) {
		error = character_read(
			file, env->model_path, actor->instance, env->log, out);
		fclose(file);
	} else {
		log_error(env->log, "%s: there is not enough memory",
			env->model_path);
	}
	free(text);
	return error;
}

static void drive(void *user, int output, bool on)
{
	struct behaviour *behaviour = user;

	gpio_output_set(behaviour->output[output], on);
}

/* The ground under a character, in metres; user is the behaviour. */
static float ground_height(void *user, float x, float z)
{
	const struct behaviour *behaviour = user;
	const struct floor *floor = behaviour->floor;
	float scale = behaviour->character->instance->unit_scale;

	return floor
		? (floor_height(floor, x * scale, z * scale) - floor->y) / scale
		: 0.0f;
}

void behaviour_suspend(struct behaviour *behaviour)
{
	for (int i = 0; i < CHARACTER_OUTPUTS_MAX; i++) {
		gpio_output_close(behaviour->output[i]);
		behaviour->output[i] = NULL;
	}
}

void behaviour_resume(struct behaviour *behaviour, const struct log *log)
{
	struct character *character = behaviour->character;

	for (int i = 0; i < character->output_count; i++) {
		const struct character_output *output = &character->output[i];
		char where[CHARACTER_PATH_BYTES + 64];

		snprintf(where, sizeof(where), "%s:%d: [output %s] line",
			output->file, output->number, output->name);
		if (!behaviour->output[i]) {
			behaviour->output[i] = gpio_output_open(
				where, output->name, output->line, log);
		}
	}
	character->drive = drive;
	character->ground_height = ground_height;
	character->drive_user = behaviour;
}

/* Whether the ground can be uneven. */
static bool has_waves(const struct character *character)
{
	float low, high;

	behaviour_range(character, character->scene.wave_m, &low, &high);
	return low != 0.0f || high != 0.0f;
}

static int load_character(
	const struct demo_env *env, struct actor *actor, struct behaviour *to)
{
	if (behaviour_find_file(env, to->path, sizeof(to->path))) {
		return character_load(
			to->path, actor->instance, env->log, &to->character);
	}
	to->path[0] = '\0';
	return read_sketch(env, actor, &to->character);
}

int behaviour_create(
	const struct demo_env *env, struct actor *actor, struct behaviour **out)
{
	struct behaviour *behaviour = calloc(1, sizeof(*behaviour));
	struct character *character;
	int error;

	*out = NULL;
	if (!behaviour) {
		log_error(env->log, "%s: there is not enough memory",
			env->model_path);
		return -ENOMEM;
	}
	error = load_character(env, actor, behaviour);
	character = behaviour->character;
	if (!error) {
		error = behaviour_bounds_init(&behaviour->bounds, character);
		if (error) {
			log_error(env->log, "%s: there is not enough memory",
				env->model_path);
		}
	}
	if (!error) {
		error = behaviour_scene_init(&behaviour->scene, actor->instance,
			has_waves(character), env->log);
	}
	if (error) {
		behaviour_destroy(behaviour);
		return error;
	}
	behaviour_resume(behaviour, env->log);
	behaviour->title = actor_technique(actor->instance);
	character->interpolation = env->interpolation;
	character->touring = env->unattended;
	character->tour_next = character->scene.tour;
	*out = behaviour;
	return 0;
}

void behaviour_destroy(struct behaviour *behaviour)
{
	if (behaviour) {
		behaviour_suspend(behaviour);
		character_destroy(behaviour->character);
		free(behaviour);
	}
}

uint64_t behaviour_stamp(
	const struct demo_env *env, const struct behaviour *behaviour)
{
	char path[CHARACTER_PATH_BYTES];

	if (behaviour->path[0]) {
		return character_stamp(behaviour->character);
	}
	return behaviour_find_file(env, path, sizeof(path)) ? file_stamp(path)
							    : 0;
}

int behaviour_init_stage(const struct behaviour *behaviour,
	struct demo_base *base, const struct demo_env *env, struct stage *stage)
{
	const struct character_scene *scene = &behaviour->character->scene;
	struct actor_framing framing = {.camera = {.yaw_rad = scene->yaw_rad,
						.pitch_rad = scene->pitch_rad,
						.margin = scene->margin,
						.follow = true},
		.labels_right = scene->labels == CHARACTER_LABELS_RIGHT};
	struct bounds box = behaviour->bounds.all;

	behaviour_count_labels(behaviour->character, &framing);
	box.low[1] = behaviour_bounds_ground(&behaviour->bounds,
		behaviour->character->instance->model->clip_count);
	return actor_init_stage(base, env, &box, &framing, stage);
}

void behaviour_update(
	struct behaviour *behaviour, struct demo_base *base, double time_s)
{
	struct character *character = behaviour->character;
	struct camera *camera = &base->stage.camera;
	float scale = base->actor.instance->unit_scale;
	struct character_frame frame = {.time_s = time_s,
		.motion_level = live_controls_motion(&base->live)
			? base->live.smooth_level
			: 0.0f};

	struct bounds now;

	character->ground_m = base->stage.floor.y / scale;
	behaviour->floor = &base->stage.floor;
	floor_set_wave_height(&base->stage.floor,
		*character->scene.wave_m * scale *
			(character->feet ? character->feet->is.now : 1.0f));
	camera_eye(camera, frame.eye);
	for (int i = 0; i < 3; i++) {
		frame.eye[i] /= scale;
	}
	character_update(character, &frame);
	camera_orbit(camera, character->camera_turn, character->camera_tilt);
	camera_zoom(camera, 1.0f + character->camera_zoom);
	now = behaviour_bounds_now(&behaviour->bounds, character);
	camera_ease_to(camera, &now,
		behaviour->framed
			? 1.0f - scalar_exp(-ease_per_s * character->real_s)
			: 1.0f);
	behaviour->framed = true;
	floor_scroll(&base->stage.floor, character->motion.scroll[0] * scale,
		character->motion.scroll[1] * scale);
	base->actor.instance->normal_mapping = *character->scene.relief > 0.0f;
	actor_update(&base->actor, camera, base->height);
	character_bend(character);
	behaviour_scene_update(&behaviour->scene, base);
}

double behaviour_period_s(const struct behaviour *behaviour)
{
	const struct character *character = behaviour->character;
	const struct model_clip *clip =
		character_machine_entry(character)->of->clip;

	if (character->scene.tour_s > 0.0) {
		return character->scene.tour_s;
	}
	return clip && clip->duration_s > 0.0f ? clip->duration_s : 1.0;
}

static void add_layer(struct overlay_motion *motion, const char *name,
	float weight, const float *mask)
{
	if (motion->layer_count < OVERLAY_LAYERS_MAX) {
		motion->layer[motion->layer_count++] =
			(struct overlay_layer){name, weight, mask};
	}
}

/* The clips that a state blends. */
static void add_clips(
	const struct character *character, struct overlay_motion *out)
{
	const struct character_machine *machine = &character->machine;
	const struct character_state *state = &machine->state[machine->current];

	for (int i = 0; i < state->entry_count && state->entry_count > 1; i++) {
		const struct character_entry *entry = &state->entry[i];

		if (entry->weight > 0) {
			add_layer(out,
				entry->of->clip ? entry->of->clip->name : "rest",
				entry->weight, NULL);
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

void behaviour_get_motion(const struct behaviour *behaviour,
	const struct model *model, struct overlay_motion *out)
{
	const struct character *character = behaviour->character;
	const struct character_entry *entry = character_machine_entry(character);
	const struct inertia *inertia = &character->machine.inertia;

	out->clip = entry->of->clip ? (int)(entry->of->clip - model->clip) : -1;
	out->time_s = entry->shown_s;
	if (character->morph_count > 0 && character->morph[0].plain_keys) {
		describe_morph(&character->morph[0], character->now_s, out);
	}
	add_clips(character, out);
	for (int i = 0; i < character->layer_count; i++) {
		const struct character_layer *layer = &character->layer[i];

		if (layer->is.now > 0) {
			add_layer(out, layer->is.name, layer->is.now,
				layer->mask);
		}
	}
	for (int i = 0; i < character->switch_count; i++) {
		const struct character_switch *is = character->switches[i];

		if (is->now > 0 && !is->unlabelled &&
			strcmp(is->kind, "layer") != 0) {
			add_layer(out, is->name, is->now, NULL);
		}
	}
	if (inertia->running) {
		add_layer(out, "fade", inertia->elapsed_s / inertia->duration_s,
			NULL);
	}
}
