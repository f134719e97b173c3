#include "app/demo/viewer/behaviour_scene.h"

#include "app/anim/math/matrix.h"
#include "app/character/run/effects.h"
#include "app/scene/draw/draw.h"
#include "app/scene/stage/light.h"

static const float shadow_strength = 0.375f;

int behaviour_scene_init(struct behaviour_scene *scene,
	struct instance *instance, bool has_waves, const struct log *log)
{
	ball_init(&scene->ball);
	return has_waves ? shadow_drape_init(&scene->drape, instance, log) : 0;
}

void behaviour_scene_update(
	struct behaviour_scene *scene, const struct demo_base *base)
{
	const struct stage *stage = &base->stage;
	struct shadow_light light = {
		.ground = &stage->floor,
	};

	if (stage->floor.wave_height != 0.0f) {
		light_direction(light.towards);
		camera_eye(&stage->camera, light.eye);
		camera_near_plane(&stage->camera, light.near_plane);
		shadow_drape_update(&scene->drape, base->actor.instance, &light);
	}
}

/* A ball is shown while something is done with it. */
static bool shows_ball(const struct character_target *target)
{
	return target->radius_m > 0.0f && target->used;
}

static void ball_center(const struct demo_base *base,
	const struct character_target *target, float out[3])
{
	for (int axis = 0; axis < 3; axis++) {
		out[axis] =
			target->point[axis] * base->actor.instance->unit_scale;
	}
}

static void draw_ball_shadows(
	const struct character *character, const struct demo_base *base)
{
	for (int i = 0; i < character->target_count; i++) {
		const struct character_target *target = &character->target[i];
		float center[3];

		if (shows_ball(target)) {
			ball_center(base, target, center);
			ball_draw_shadow(base->gl, center,
				target->radius_m *
					base->actor.instance->unit_scale,
				&base->stage);
		}
	}
}

static void draw_balls(const struct behaviour_scene *scene,
	const struct character *character, const struct demo_base *base)
{
	float scale = base->actor.instance->unit_scale;

	for (int i = 0; i < character->target_count; i++) {
		const struct character_target *target = &character->target[i];
		float center[3];

		if (!shows_ball(target)) {
			continue;
		}
		ball_center(base, target, center);
		ball_draw(&scene->ball, base->gl, center,
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
static void draw_capes(const struct character *character,
	const struct demo_base *base, enum draw_pass pass)
{
	const struct gl *gl = base->gl;
	GLfixed scale = fx16_from_float(base->actor.instance->unit_scale);

	for (int i = 0; i < character->cape_count; i++) {
		const struct character_cape *cape = &character->cape[i];

		if (!cape->worn ||
			(pass == DRAW_SHADOW && cape->is.now <= 0.5f)) {
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

static void draw_shadows(const struct behaviour_scene *scene,
	const struct character *character, const struct demo_base *base)
{
	const struct gl *gl = base->gl;
	const struct actor *actor = &base->actor;

	if (*character->scene.shadow <= 0.0f) {
		stage_draw_monitor(&base->stage, gl);
		return;
	}
	if (base->stage.floor.wave_height != 0.0f && base->stage.has_stencil) {
		shadow_drape_draw(&scene->drape, gl, shadow_strength);
	} else {
		stage_shadow_begin(&base->stage, gl);
		draw_instance(
			gl, actor->instance, &actor->textures, DRAW_SHADOW);
		draw_capes(character, base, DRAW_SHADOW);
		stage_shadow_end(&base->stage, gl);
	}
	draw_ball_shadows(character, base);
}

/* The corners of a node's top and their box; false if it is not level. */
static bool find_top(const float top[5], int node,
	const struct instance *instance, float corner[4][3], struct bounds *box)
{
	const float local[4][3] = {{top[1], top[0], top[2]},
		{top[3], top[0], top[2]}, {top[3], top[0], top[4]},
		{top[1], top[0], top[4]}};
	float extent;

	*box = bounds_empty();
	for (int i = 0; i < 4; i++) {
		matrix_apply(instance->world[node], local[i], corner[i]);
		for (int axis = 0; axis < 3; axis++) {
			corner[i][axis] *= instance->unit_scale;
		}
		bounds_add(box, corner[i]);
	}
	extent = bounds_extent(box);
	return extent > 0.0f && box->high[1] - box->low[1] < 0.02f * extent;
}

/* Whether the shadow of a drawable above a top may reach it. */
static bool casts_on(const struct behaviour_bounds *bounds,
	const struct instance *instance, int drawable, const struct bounds *top)
{
	struct bounds shadow = bounds_empty();
	float light[3];

	light_direction(light);
	behaviour_bounds_add(bounds, instance, drawable, top->low[1],
		(float[2]){-light[0] / light[1], -light[2] / light[1]}, &shadow);
	return shadow.low[1] > top->low[1] - 0.02f * bounds_extent(top) &&
		shadow.low[0] < top->high[0] && shadow.high[0] > top->low[0] &&
		shadow.low[2] < top->high[2] && shadow.high[2] > top->low[2];
}

/* Draws the shadows of other nodes on a node's top. */
static void draw_top_shadow(const float top[5], int node,
	const struct behaviour_bounds *bounds, const struct demo_base *base)
{
	struct instance *instance = base->actor.instance;
	float corner[4][3];
	struct bounds box;
	bool begun = false;

	if (!find_top(top, node, instance, corner, &box)) {
		return;
	}
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];

		if (drawable->hidden || drawable->node == node ||
			!casts_on(bounds, instance, i, &box)) {
			continue;
		}
		if (!begun) {
			stage_top_begin(&base->stage, base->gl, corner);
			begun = true;
		}
		draw_instance_part(base->gl, instance, drawable,
			&base->actor.textures, DRAW_SHADOW);
	}
	if (begun) {
		stage_top_end(base->gl);
	}
}

static void draw_top_shadows(const struct character *character,
	const struct behaviour_bounds *bounds, const struct demo_base *base)
{
	if (!base->stage.has_stencil || *character->scene.shadow <= 0.0f) {
		return;
	}
	for (int i = 0; i < character->part_count; i++) {
		const struct character_part *part = &character->part[i];

		for (int k = 0; k < part->top_count; k++) {
			draw_top_shadow(part->top[k], part->node, bounds, base);
		}
	}
}

void behaviour_scene_draw(const struct behaviour_scene *scene,
	const struct character *character, const struct behaviour_bounds *bounds,
	const struct demo_base *base, int width, int height)
{
	const struct gl *gl = base->gl;
	const struct actor *actor = &base->actor;

	stage_begin(&base->stage, gl, width, height);
	draw_shadows(scene, character, base);
	draw_instance(gl, actor->instance, &actor->textures, DRAW_SHADED);
	draw_top_shadows(character, bounds, base);
	draw_capes(character, base, DRAW_SHADED);
	draw_balls(scene, character, base);
}
