#include "app/scene/shadow/shadow_figure.h"

#include "app/scene/draw/draw.h"
#include "app/scene/instance/lod.h"
#include "app/scene/stage/light.h"

#include <cglm/cglm.h>

/* The length of edges in the picture up to which they are not divided. */
static const float undivided_px = 8.0f;

int shadow_figure_create(struct instance *instance,
	const struct shadow_ground *ground, const struct log *log,
	struct shadow_figure **out)
{
	const struct shadow_relief *relief = &ground->relief;
	struct shadow_figure *figure;
	int error;

	*out = NULL;
	if (ground->count == 0) {
		return 0;
	}
	figure = ARENA_ARRAY(&instance->arena, struct shadow_figure, 1);
	if (!figure) {
		return memory_budget_fail(
			instance->arena.budget, instance->model->path, log);
	}
	figure->ground = *ground;
	*out = figure;
	if (!relief->height) {
		return 0;
	}
	error = shadow_drape_init_on(
		&figure->drape, instance, NULL, 0, relief, log);
	figure->longest = figure->drape.longest;
	return error;
}

/* The light and the eye as the figure's own space has them. */
static struct shadow_light light_at(const struct stage *stage, const vec4 *place)
{
	struct shadow_light light = {.ground = &stage->floor};
	mat4 stands, into;

	light_direction(light.towards);
	camera_eye(&stage->camera, light.eye);
	memcpy(stands, place, sizeof(stands));
	glm_mat4_inv_fast(stands, into);
	glm_mat4_mulv3(into, light.towards, 0.0f, light.towards);
	glm_vec3_normalize(light.towards);
	glm_mat4_mulv3(into, light.eye, 1.0f, light.eye);
	return light;
}

void shadow_figure_lay(struct shadow_figure *figure, const struct stage *stage,
	int height, struct instance *instance, const mat4 place)
{
	struct shadow_light light;
	float px;

	if (!figure || !figure->ground.relief.height || !stage->has_stencil) {
		return;
	}
	light = light_at(stage, place);
	light.relief = &figure->ground.relief;
	figure->drape.longest = figure->longest;
	if (height > 0) {
		px = lod_px_per_unit_at(
			&stage->camera, glm_vec3_norm(light.eye), height);
		figure->drape.longest = glm_max(
			figure->longest, undivided_px / glm_max(px, 1e-6f));
	}
	shadow_ground_hide(&figure->ground, instance, true);
	shadow_drape_update(&figure->drape, instance, &light);
	shadow_ground_hide(&figure->ground, instance, false);
}

void shadow_figure_draw(const struct shadow_figure *figure,
	const struct stage *stage, const struct gl *gl,
	struct instance *instance, const struct texture_set *textures,
	const mat4 place)
{
	struct shadow_light light;

	if (!figure) {
		return;
	}
	light = light_at(stage, place);
	if (!shadow_ground_begin(&figure->ground, stage, gl, light.towards,
		    instance, textures)) {
		return;
	}
	if (figure->ground.relief.height) {
		shadow_drape_draw(&figure->drape, gl, DRAW_SHADOW_ALPHA,
			STAGE_GROUND_MARK, true);
	} else {
		draw_instance(gl, instance, textures, DRAW_SHADOW);
		stage_top_end(gl);
	}
}

void shadow_figure_end(
	const struct shadow_figure *figure, struct instance *instance)
{
	if (figure) {
		shadow_ground_hide(&figure->ground, instance, false);
	}
}
