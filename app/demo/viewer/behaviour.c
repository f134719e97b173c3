#include "app/demo/viewer/behaviour.h"

#include "app/character/character.h"
#include "app/character/run/effects.h"
#include "app/character/run/feet.h"
#include "app/character/run/layers.h"
#include "app/character/sketch/character_sketch.h"
#include "app/character/state/machine.h"
#include "app/demo/viewer/behaviour_bounds.h"
#include "app/demo/viewer/behaviour_label.h"
#include "app/scene/draw/draw.h"
#include "app/scene/stage/ball.h"
#include "platform/base/file.h"
#include "platform/buttons/gpio_output.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* Height of a sine in the graph of a morph's curve. */
static const float graph_wave = 0.35f;

struct behaviour {
	struct character *character;
	const char *title;               /* the model's technique */
	char path[CHARACTER_PATH_BYTES]; /* "" for the default behaviour */
	struct ball ball;
	struct gpio_output *output[CHARACTER_OUTPUTS_MAX]; /* or NULL */
	const struct floor *floor; /* of the stage, once it was updated */
};

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

static bool needs_default(const struct demo_env *env, const struct model *model)
{
	return !env->clip && model->clip_count == 0 && model->weight_count > 0 &&
		!(env->character && strcmp(env->character, "none") == 0);
}

/* Reads what `limber character` would write for the model. */
static int read_default(
	struct actor *actor, const struct demo_env *env, struct character **out)
{
	char *text = NULL;
	size_t size = 0;
	FILE *file = open_memstream(&text, &size);
	int error = -ENOMEM;

	if (file) {
		character_sketch(actor->model, file);
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

static void open_outputs(struct behaviour *behaviour, const struct log *log)
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

static void close_outputs(struct behaviour *behaviour)
{
	for (int i = 0; i < CHARACTER_OUTPUTS_MAX; i++) {
		gpio_output_close(behaviour->output[i]);
		behaviour->output[i] = NULL;
	}
}

void behaviour_suspend(struct behaviour *behaviour)
{
	if (behaviour) {
		close_outputs(behaviour);
	}
}

void behaviour_resume(struct behaviour *behaviour, const struct log *log)
{
	if (behaviour) {
		open_outputs(behaviour, log);
	}
}

int behaviour_create(
	const struct demo_env *env, struct actor *actor, struct behaviour **out)
{
	char path[CHARACTER_PATH_BYTES];
	bool has_file = behaviour_find_file(env, path, sizeof(path));
	struct behaviour *behaviour;
	int error;

	*out = NULL;
	if (!has_file && !needs_default(env, actor->model)) {
		return 0;
	}
	behaviour = calloc(1, sizeof(*behaviour));
	if (!behaviour) {
		log_error(env->log, "%s: there is not enough memory",
			env->model_path);
		return -ENOMEM;
	}
	if (has_file) {
		memcpy(behaviour->path, path, sizeof(path));
		error = character_load(
			path, actor->instance, env->log, &behaviour->character);
	} else {
		error = read_default(actor, env, &behaviour->character);
	}
	if (error) {
		free(behaviour);
		return error;
	}
	open_outputs(behaviour, env->log);
	ball_init(&behaviour->ball);
	behaviour->title = actor_technique(actor->instance);
	behaviour->character->touring = env->unattended;
	behaviour->character->tour_next = behaviour->character->scene.tour;
	*out = behaviour;
	return 0;
}

void behaviour_destroy(struct behaviour *behaviour)
{
	if (behaviour) {
		close_outputs(behaviour);
		character_destroy(behaviour->character);
		free(behaviour);
	}
}

uint64_t behaviour_stamp(
	const struct demo_env *env, const struct behaviour *behaviour)
{
	char path[CHARACTER_PATH_BYTES];

	if (behaviour && behaviour->path[0]) {
		return character_stamp(behaviour->character);
	}
	return behaviour_find_file(env, path, sizeof(path)) ? file_stamp(path)
							    : 0;
}

int behaviour_init_stage(const struct behaviour *behaviour,
	const struct demo_env *env, struct stage *stage)
{
	const struct character_scene *scene = &behaviour->character->scene;
	struct actor_framing framing = {.camera = {.yaw_rad = scene->yaw_rad,
						.pitch_rad = scene->pitch_rad,
						.margin = scene->margin,
						.follow = true}};
	struct bounds bounds = behaviour_bounds(behaviour->character);
	int error;

	behaviour_count_labels(behaviour->character, &framing);
	error = actor_init_stage(env, &bounds, &framing, stage);
	if (!error && scene->labels == CHARACTER_LABELS_RIGHT) {
		struct camera_region left = stage->camera.fit.region;

		camera_set_region(&stage->camera,
			&(struct camera_region){
				-left.right, -left.left, left.bottom, left.top},
			1.0f, (float)env->width / (float)env->height);
	}
	return error;
}

void behaviour_press(
	struct behaviour *behaviour, const struct button_event *event)
{
	character_press(behaviour->character, event);
}

void behaviour_update(struct behaviour *behaviour, struct demo_base *base,
	double time_s, int height)
{
	struct character *character = behaviour->character;
	struct camera *camera = &base->stage.camera;
	float scale = base->actor.instance->unit_scale;
	struct character_frame frame = {.time_s = time_s,
		.motion_level = live_controls_motion(&base->live)
			? base->live.smooth_level
			: 0.0f};

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
	floor_scroll(&base->stage.floor, character->motion.scroll[0] * scale,
		character->motion.scroll[1] * scale);
	actor_update(&base->actor, camera, height);
	character_bend(character);
}

static void draw_balls(
	const struct behaviour *behaviour, const struct demo_base *base)
{
	const struct character *character = behaviour->character;
	float scale = base->actor.instance->unit_scale;

	for (int i = 0; i < character->target_count; i++) {
		const struct character_target *target = &character->target[i];
		float center[3];

		if (target->radius_m <= 0.0f) {
			continue;
		}
		for (int axis = 0; axis < 3; axis++) {
			center[axis] = target->point[axis] * scale;
		}
		ball_draw(&behaviour->ball, base->gl, center,
			target->radius_m * scale, target->color);
	}
}

static void set_cape_material(
	const struct gl *gl, const struct character_cape *cape)
{
	static const GLfixed dull[4] = {0, 0, 0, FX16_ONE};

	gl->Enable(GL_LIGHTING);
	gl->Enable(GL_COLOR_MATERIAL);
	gl->LightModelx(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_SPECULAR, dull);
	if (cape->is.now < 1.0f) {
		gl->Enable(GL_BLEND);
		gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	} else {
		gl->Disable(GL_BLEND);
	}
	gl->Disable(GL_TEXTURE_2D);
	gl->Color4x(fx16_from_float(cape->color[0]),
		fx16_from_float(cape->color[1]),
		fx16_from_float(cape->color[2]), fx16_from_float(cape->is.now));
	gl->EnableClientState(GL_NORMAL_ARRAY);
	gl->NormalPointer(GL_FLOAT, 0, cape->cloth.normal);
}

/* Cloth is in metres; the stage is in scene units. */
static void draw_capes(const struct behaviour *behaviour,
	const struct demo_base *base, enum draw_pass pass)
{
	const struct gl *gl = base->gl;
	GLfixed scale = fx16_from_float(base->actor.instance->unit_scale);

	for (int i = 0; i < behaviour->character->cape_count; i++) {
		const struct character_cape *cape =
			&behaviour->character->cape[i];

		if (!cape->worn) {
			continue;
		}
		if (pass == DRAW_SHADED) {
			set_cape_material(gl, cape);
		} else {
			gl->DisableClientState(GL_NORMAL_ARRAY);
		}
		gl->Disable(GL_CULL_FACE);
		gl->EnableClientState(GL_VERTEX_ARRAY);
		gl->DisableClientState(GL_COLOR_ARRAY);
		gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
		gl->VertexPointer(3, GL_FLOAT, 0, cape->cloth.position);
		gl->PushMatrix();
		gl->Scalex(scale, scale, scale);
		gl->DrawElements(GL_TRIANGLES, cape->index_count,
			GL_UNSIGNED_SHORT, cape->index);
		gl->PopMatrix();
		gl->Disable(GL_BLEND);
	}
}

void behaviour_draw(struct behaviour *behaviour, struct demo_base *base,
	int width, int height)
{
	const struct gl *gl = base->gl;
	const struct actor *actor = &base->actor;

	stage_begin(&base->stage, gl, width, height);
	/* A flat shadow does not fit uneven ground. */
	if (behaviour->character->scene.shadow &&
		base->stage.floor.wave_height == 0.0f) {
		stage_shadow_begin(&base->stage, gl);
		draw_instance(
			gl, actor->instance, &actor->textures, DRAW_SHADOW);
		draw_capes(behaviour, base, DRAW_SHADOW);
		stage_shadow_end(&base->stage, gl);
	} else {
		stage_draw_monitor(&base->stage, gl);
	}
	draw_instance(gl, actor->instance, &actor->textures, DRAW_SHADED);
	draw_capes(behaviour, base, DRAW_SHADED);
	draw_balls(behaviour, base);
}

void behaviour_label(const struct behaviour *behaviour,
	const struct demo_base *base, struct hud *hud)
{
	behaviour_label_all(
		behaviour->character, behaviour->title, &base->actor, hud);
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

void behaviour_print_buttons(const struct behaviour *behaviour, FILE *out)
{
	character_print_buttons(behaviour->character, out);
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
		const struct character_morph *morph = &character->morph[0];
		bool sine = morph->curve[morph->chosen].kind ==
			CHARACTER_CURVE_SINE;

		out->morphing = true;
		out->node = morph->node;
		out->from = morph->before - 1;
		out->to = morph->destiny - 1;
		out->omega = character_morph_omega(morph, character->now_s);
		out->wave = sine ? graph_wave : 0.0f;
		out->shape = character_morph_curve;
		out->shape_user = &morph->curve[morph->chosen];
	}
	for (int i = 0; i < character->layer_count &&
		out->layer_count < (int)ARRAY_COUNT(out->layer);
		i++) {
		const struct character_layer *layer = &character->layer[i];

		if (layer->is.now > 0) {
			out->layer[out->layer_count].name = layer->is.name;
			out->layer[out->layer_count].weight = layer->is.now;
			out->layer[out->layer_count++].mask = layer->mask;
		}
	}
	if (inertia->running && out->layer_count < (int)ARRAY_COUNT(out->layer)) {
		out->layer[out->layer_count].name = "fade";
		out->layer[out->layer_count++].weight =
			inertia->elapsed_s / inertia->duration_s;
	}
}
