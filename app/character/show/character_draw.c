#include "app/character/show/character_draw.h"

#include "app/anim/math/matrix.h"
#include "app/character/run/effects.h"
#include "app/scene/draw/alpha.h"
#include "app/scene/draw/draw.h"
#include "app/scene/stage/light.h"
#include "platform/base/fixed.h"

#include <errno.h>

/*
 * How much larger the box is made, as a part of its extent: for rounding, and
 * for what bends and morph targets add.
 */
static const float beyond_box = 0.02f;

/* Cloth is in metres; the stage is in scene units. */
static int describe_capes(struct character_drawing *drawing)
{
	const struct character *character = drawing->character;
	struct instance *instance = character->instance;

	drawing->cloth = ARENA_ARRAY(&instance->arena, struct shadow_cloth,
		(size_t)character->cape_count);
	for (int i = 0; drawing->cloth && i < character->cape_count; i++) {
		const struct character_cape *cape = &character->cape[i];

		drawing->cloth[i] = (struct shadow_cloth){
			.position = (const float(*)[3])cape->cloth.position,
			.vertex_count = cape->cloth.count,
			.index_count = cape->index_count,
			.index = cape->index,
			.scale = instance->unit_scale,
		};
	}
	return drawing->cloth ? 0 : -ENOMEM;
}

/* Whether a cape casts a shadow; one that is half faded out casts none. */
static bool casts_shadow(const struct character_cape *cape)
{
	return cape->worn && cape->is.now > 0.5f;
}

/* Prepares the shadow on uneven ground. */
static int init_drape(struct character_drawing *drawing, const struct log *log)
{
	const struct shadow_relief *relief = &drawing->ground.relief;
	const struct character *character = drawing->character;

	if (relief->height) {
		return shadow_drape_init_on(&drawing->drape, character->instance,
			drawing->cloth, character->cape_count, relief, log);
	}
	return drawing->may_wave
		? shadow_drape_init(&drawing->drape, character->instance,
			  drawing->cloth, character->cape_count, log)
		: 0;
}

int character_draw_init(struct character_drawing *drawing,
	struct character *character, const struct shadow_ground *ground,
	const struct log *log)
{
	float low, high;
	int error;

	drawing->character = character;
	drawing->ground = *ground;
	ball_init(&drawing->ball);
	character_range(character, character->scene.wave_m, &low, &high);
	drawing->may_wave = low != 0.0f || high != 0.0f;
	error = character_bounds_init(&drawing->bounds, character);
	if (!error) {
		error = describe_capes(drawing);
	}
	if (!error && drawing->may_wave) {
		error = reach_init(&drawing->reach, character->instance);
	}
	if (error) {
		return memory_budget_fail(character->arena.budget,
			character->instance->model->path, log);
	}
	return init_drape(drawing, log);
}

/* Whether this frame's shadow lies on uneven ground of the model's own. */
static bool is_on_relief(
	const struct character_drawing *drawing, const struct stage *stage)
{
	return drawing->ground.relief.height &&
		stage->floor.wave_height == 0.0f && stage->has_stencil &&
		*drawing->character->scene.shadow > 0.0f;
}

void character_draw_update(
	struct character_drawing *drawing, const struct stage *stage)
{
	const struct character *character = drawing->character;
	struct instance *instance = character->instance;
	bool on_relief = is_on_relief(drawing, stage);
	struct shadow_light light = {
		.ground = &stage->floor,
		.relief = on_relief ? &drawing->ground.relief : NULL,
	};

	if (stage->floor.wave_height != 0.0f || on_relief) {
		light_direction(light.towards);
		camera_eye(&stage->camera, light.eye);
		for (int i = 0; i < character->cape_count; i++) {
			drawing->cloth[i].hidden =
				!casts_shadow(&character->cape[i]);
		}
		shadow_ground_hide(&drawing->ground, instance, on_relief);
		shadow_drape_update(&drawing->drape, instance, &light);
		shadow_ground_hide(&drawing->ground, instance, false);
	}
}

/* A ball is shown while its target is used. */
static bool shows_ball(const struct character_target *target)
{
	return target->radius_m > 0.0f && target->used;
}

static void ball_center(
	const struct character_target *target, float scale, float out[3])
{
	for (int axis = 0; axis < 3; axis++) {
		out[axis] = target->point[axis] * scale;
	}
}

/* Adds where a ball's shadow may lie at any height of the ground. */
static void add_ball_shadow(const struct floor *floor, const float center[3],
	float radius, struct bounds *out)
{
	float light[3];

	light_direction(light);
	for (int i = -1; i <= 1; i += 2) {
		float y = floor->y + (float)i * floor->wave_height;
		float fall = (center[1] - y) / light[1];
		struct bounds shadow;

		for (int axis = 0; axis < 3; axis++) {
			float at = center[axis] - light[axis] * fall;

			/* The light is so high that three radii suffice. */
			shadow.low[axis] = at - 3.0f * radius;
			shadow.high[axis] = at + 3.0f * radius;
		}
		bounds_join(out, &shadow);
	}
}

static void add_balls(const struct character *character, mat4 view,
	const struct floor *floor, struct floor_content *out)
{
	float scale = character->instance->unit_scale;

	for (int i = 0; i < character->target_count; i++) {
		const struct character_target *target = &character->target[i];
		float center[3], radius = target->radius_m * scale;
		struct bounds ball;

		if (!shows_ball(target)) {
			continue;
		}
		ball_center(target, scale, center);
		add_ball_shadow(floor, center, radius, &out->lying);
		matrix_apply(view, center, center);
		for (int axis = 0; axis < 3; axis++) {
			ball.low[axis] = center[axis] - radius;
			ball.high[axis] = center[axis] + radius;
		}
		bounds_join(&out->standing, &ball);
	}
}

static void add_capes(
	const struct character *character, mat4 view, struct bounds *out)
{
	float scale = character->instance->unit_scale;

	for (int i = 0; i < character->cape_count; i++) {
		const struct character_cape *cape = &character->cape[i];

		for (int v = 0; cape->worn && v < cape->cloth.count; v++) {
			float at[3];

			for (int axis = 0; axis < 3; axis++) {
				at[axis] = cape->cloth.position[v][axis] * scale;
			}
			matrix_apply(view, at, at);
			bounds_add(out, at);
		}
	}
}

struct floor_content character_draw_content(
	const struct character_drawing *drawing, const struct stage *stage)
{
	struct floor_content content = {.bounded = drawing->may_wave};
	float margin;
	mat4 view;

	if (!content.bounded) {
		return content;
	}
	camera_view(&stage->camera, view);
	content.standing = reach_now(&drawing->reach,
		drawing->character->instance, (const vec4 *)view);
	content.lying = drawing->drape.box;
	add_capes(drawing->character, view, &content.standing);
	add_balls(drawing->character, view, &stage->floor, &content);
	margin = beyond_box * bounds_extent(&content.standing);
	for (int axis = 0; axis < 3; axis++) {
		content.standing.low[axis] -= margin;
		content.standing.high[axis] += margin;
	}
	return content;
}

static void draw_ball_shadows(const struct character *character,
	const struct stage *stage, const struct gl *gl)
{
	float scale = character->instance->unit_scale;

	for (int i = 0; i < character->target_count; i++) {
		const struct character_target *target = &character->target[i];
		float center[3];

		if (shows_ball(target)) {
			ball_center(target, scale, center);
			ball_draw_shadow(
				gl, center, target->radius_m * scale, stage);
		}
	}
}

static void draw_balls(
	const struct character_drawing *drawing, const struct gl *gl)
{
	const struct character *character = drawing->character;
	float scale = character->instance->unit_scale;

	for (int i = 0; i < character->target_count; i++) {
		const struct character_target *target = &character->target[i];
		float center[3];

		if (!shows_ball(target)) {
			continue;
		}
		ball_center(target, scale, center);
		ball_draw(&drawing->ball, gl, center, target->radius_m * scale,
			target->color);
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
static void draw_capes(const struct character *character, const struct gl *gl,
	enum draw_pass pass)
{
	GLfixed scale = fx16_from_float(character->instance->unit_scale);

	for (int i = 0; i < character->cape_count; i++) {
		const struct character_cape *cape = &character->cape[i];

		if (pass == DRAW_SHADOW ? !casts_shadow(cape) : !cape->worn) {
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

static void draw_shadows(const struct character_drawing *drawing,
	const struct stage *stage, const struct texture_set *textures,
	const struct gl *gl)
{
	const struct character *character = drawing->character;

	if (*character->scene.shadow <= 0.0f) {
		stage_draw_monitor(stage, gl);
		return;
	}
	if (stage->floor.wave_height != 0.0f && stage->has_stencil) {
		const struct shadow_drape *drape = &drawing->drape;

		shadow_drape_draw(drape, gl, DRAW_SHADOW_ALPHA, 0,
			stage_may_hide(stage, &drape->box));
	} else {
		stage_shadow_begin(stage, gl);
		draw_instance(gl, character->instance, textures, DRAW_SHADOW);
		draw_capes(character, gl, DRAW_SHADOW);
		stage_shadow_end(stage, gl);
	}
	draw_ball_shadows(character, stage, gl);
}

/* Finds a node's top: its corners and box. Returns false if it is not level. */
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
	return box->high[1] - box->low[1] < 0.02f * extent;
}

/* Returns true if the shadow of a drawable above a top may reach the top. */
static bool casts_on(const struct character_bounds *bounds,
	const struct instance *instance, int drawable, const struct bounds *top)
{
	struct bounds shadow = bounds_empty();
	float light[3];

	light_direction(light);
	character_bounds_add(bounds, instance, drawable, top->low[1],
		(float[2]){-light[0] / light[1], -light[2] / light[1]}, &shadow);
	return shadow.low[1] > top->low[1] - 0.02f * bounds_extent(top) &&
		shadow.low[0] < top->high[0] && shadow.high[0] > top->low[0] &&
		shadow.low[2] < top->high[2] && shadow.high[2] > top->low[2];
}

/* Draws the shadows of other nodes on a node's top. */
static void draw_top_shadow(const struct character_drawing *drawing,
	const float top[5], int node, const struct stage *stage,
	const struct texture_set *textures, const struct gl *gl)
{
	struct instance *instance = drawing->character->instance;
	float corner[4][3];
	struct bounds box;
	bool begun = false;

	if (!find_top(top, node, instance, corner, &box)) {
		return;
	}
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];

		if (drawable->hidden || drawable->node == node ||
			!casts_on(&drawing->bounds, instance, i, &box)) {
			continue;
		}
		if (!begun) {
			stage_top_begin(stage, gl, corner);
			begun = true;
		}
		draw_instance_part(
			gl, instance, drawable, textures, DRAW_SHADOW);
	}
	if (begun) {
		stage_top_end(gl);
	}
}

static void draw_top_shadows(const struct character_drawing *drawing,
	const struct stage *stage, const struct texture_set *textures,
	const struct gl *gl)
{
	const struct character *character = drawing->character;

	if (!stage->has_stencil || *character->scene.shadow <= 0.0f) {
		return;
	}
	for (int i = 0; i < character->part_count; i++) {
		const struct character_part *part = &character->part[i];

		for (int k = 0; k < part->top_count; k++) {
			draw_top_shadow(drawing, part->top[k], part->node,
				stage, textures, gl);
		}
	}
}

/* Draws ground of the model's own, and shadows on it. */
static void draw_ground(const struct character_drawing *drawing,
	const struct stage *stage, const struct texture_set *textures,
	const struct gl *gl)
{
	const struct character *character = drawing->character;
	float light[3];

	light_direction(light);
	if (*character->scene.shadow <= 0.0f ||
		stage->floor.wave_height != 0.0f ||
		!shadow_ground_begin(&drawing->ground, stage, gl, light,
			character->instance, textures)) {
		return;
	}
	if (drawing->ground.relief.height) {
		shadow_drape_draw(&drawing->drape, gl, DRAW_SHADOW_ALPHA,
			STAGE_GROUND_MARK, true);
	} else {
		draw_instance(gl, character->instance, textures, DRAW_SHADOW);
		draw_capes(character, gl, DRAW_SHADOW);
		stage_top_end(gl);
	}
}

void character_draw(const struct character_drawing *drawing,
	const struct stage *stage, const struct texture_set *textures,
	const struct gl *gl)
{
	const struct character *character = drawing->character;
	float eye[3];

	draw_shadows(drawing, stage, textures, gl);
	draw_ground(drawing, stage, textures, gl);
	camera_eye(&stage->camera, eye);
	alpha_sort_blended(character->instance, eye);
	draw_instance(gl, character->instance, textures, DRAW_SHADED);
	shadow_ground_hide(&drawing->ground, character->instance, false);
	draw_top_shadows(drawing, stage, textures, gl);
	draw_capes(character, gl, DRAW_SHADED);
	draw_balls(drawing, gl);
}
