#include "app/compare/cost/drawing.h"

#include "app/compare/measure/screen_view.h"
#include "app/scene/draw/alpha.h"
#include "app/scene/draw/draw.h"
#include "app/scene/draw/texture.h"
#include "app/scene/instance/lod.h"
#include "app/scene/shadow/shadow_figure.h"
#include "app/scene/stage/stage.h"
#include "platform/gl/gl_context.h"

#include <cglm/cglm.h>

#include <errno.h>
#include <stdlib.h>

struct drawing {
	struct gl_context *context;
	struct pixels pixels;
	struct texture_set textures;
	struct stage stage;
	struct bounds box;             /* framed by the camera */
	struct shadow_figure *figure;  /* on ground of its own, or NULL */
	struct drawing_shadow *shadow; /* counts; or NULL */
	bool keys;
};

static int open_picture(
	struct drawing *drawing, int width, int height, const struct log *log)
{
	const struct gl_request request = {.format = PIXELS_RGB565, .log = log};
	int error = pixels_alloc(
		&drawing->pixels, width, height, PIXELS_RGB565, log);

	return error ? error : gl_open("soft", &request, &drawing->context);
}

static int find_ground(struct drawing *drawing, struct instance *instance,
	const struct log *log)
{
	const struct model *model = instance->model;
	struct shadow_ground ground;

	if (shadow_ground_find(&ground, instance) != 0) {
		return memory_budget_fail(model->budget, model->path, log);
	}
	if (ground.in_plane) {
		stage_lower_floor(&drawing->stage, &drawing->box);
	}
	return shadow_figure_create(instance, &ground, log, &drawing->figure);
}

static int prepare(struct drawing *drawing, struct instance *instance,
	const struct bounds *box, const struct log *log)
{
	const struct gl *gl = &drawing->context->gl;
	struct bounds rest = bounds_of_clip(instance, -1);
	struct camera_framing framing = screen_view_played(&rest);
	int error = texture_set_create(
		&drawing->textures, instance->model, gl, PIXELS_RGB565, log);

	if (error) {
		return error;
	}
	framing.aspect =
		(float)drawing->pixels.width / (float)drawing->pixels.height;
	error = stage_init(&drawing->stage, gl, box, instance->unit_scale,
		&framing, PIXELS_RGB565, log);
	if (error) {
		texture_set_destroy(&drawing->textures, gl);
	}
	return error;
}

int drawing_create(struct instance *instance, const struct bounds *box,
	int width, int height, const struct log *log, struct drawing **out)
{
	const struct model *model = instance->model;
	struct drawing *drawing = calloc(1, sizeof(*drawing));
	int error;

	if (!drawing) {
		log_error(log, "%s: there is not enough memory to draw it",
			model->path);
		return -ENOMEM;
	}
	error = open_picture(drawing, width, height, log);
	if (error) {
		goto fail_picture;
	}
	drawing->box = *box;
	error = prepare(drawing, instance, box, log);
	if (error) {
		goto fail_context;
	}
	error = find_ground(drawing, instance, log);
	if (error) {
		drawing_destroy(drawing);
		return error;
	}
	*out = drawing;
	return 0;
fail_context:
	drawing->context->driver->destroy(drawing->context);
fail_picture:
	free(drawing->pixels.data);
	free(drawing);
	return error;
}

void drawing_destroy(struct drawing *drawing)
{
	if (!drawing) {
		return;
	}
	stage_finish(&drawing->stage, &drawing->context->gl);
	texture_set_destroy(&drawing->textures, &drawing->context->gl);
	drawing->context->driver->destroy(drawing->context);
	free(drawing->pixels.data);
	free(drawing);
}

void drawing_frame(struct drawing *drawing, const struct bounds *box)
{
	camera_ease_to(&drawing->stage.camera, box, 1.0f);
}

float drawing_extent(struct instance *instance)
{
	struct bounds rest = bounds_of_clip(instance, -1);

	return bounds_extent(&rest);
}

void drawing_show_keys(struct drawing *drawing)
{
	drawing->keys = true;
}

static float px_per_unit(const struct drawing *drawing,
	const struct instance *instance, float extent)
{
	const struct camera *camera = &drawing->stage.camera;
	int height = drawing->pixels.height;

	return drawing->keys
		? lod_px_per_unit_of_box(&drawing->box, camera, height)
		: lod_px_per_unit(instance, camera, extent, height);
}

/* With a grid, light is followed from its nodes and not from each point. */
static void count_shadow(
	const struct shadow_drape *drape, struct drawing_shadow *sum)
{
	int points = 0;

	for (int i = 0; i < drape->sheet_count; i++) {
		points += drape->sheet[i].vertex_count;
	}
	sum->points += points;
	sum->rays +=
		drape->grid.node_count > 0 ? drape->grid.node_count : points;
}

void drawing_draw(
	struct drawing *drawing, struct instance *instance, float extent)
{
	static const struct lod automatic = {.kind = LOD_AUTO};
	struct gl_context *context = drawing->context;
	struct stage *stage = &drawing->stage;
	const struct gl *gl = &context->gl;
	int width = drawing->pixels.width, height = drawing->pixels.height;
	mat4 place = GLM_MAT4_IDENTITY_INIT;
	float eye[3];

	lod_choose(instance, &automatic, px_per_unit(drawing, instance, extent));
	if (instance_is_stale(instance)) {
		instance_update(instance);
	}
	/* As large as the player shows it. */
	shadow_figure_lay(
		drawing->figure, stage, 0, instance, (const vec4 *)place);
	if (drawing->shadow && drawing->figure) {
		count_shadow(&drawing->figure->drape, drawing->shadow);
	}
	if (context->driver->begin_frame(context, &drawing->pixels) != 0) {
		return;
	}
	stage_begin(stage, gl, width, height);
	stage_shadow_begin(stage, gl);
	draw_instance(gl, instance, &drawing->textures, DRAW_SHADOW);
	stage_shadow_end(stage, gl);
	shadow_figure_draw(drawing->figure, stage, gl, instance,
		&drawing->textures, (const vec4 *)place);
	camera_eye(&stage->camera, eye);
	alpha_sort_blended(instance, eye);
	draw_instance(gl, instance, &drawing->textures, DRAW_SHADED);
	shadow_figure_end(drawing->figure, instance);
	context->driver->end_frame(context);
}

void drawing_count(struct drawing *drawing, struct gl_counts *counts,
	struct drawing_shadow *shadow)
{
	drawing->shadow = shadow;
	drawing->context->driver->count(drawing->context, counts);
}
