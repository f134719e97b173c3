/*
 * Draws key frames (overlay.h): those of a clip as onion skins, and the shapes
 * of a morphed model as a row of small pictures.
 */
#include "app/anim/math/vec.h"
#include "app/scene/draw/matrix_gl.h"
#include "app/scene/overlay/overlay.h"
#include "platform/base/fixed.h"

#include <string.h>

enum {
	ROW_MAX = 12,    /* pictures in a row */
	ROW_FRACTION = 5 /* a picture's width is at most 1/5 of the whole */
};

/* leaves room around each shape of the row for the frame that marks it */
static const float row_margin = 1.15f;
/*
 * Ghosts are moved away by this part of the extent, so that the figure covers a
 * ghost with which it nearly coincides.
 */
static const float ghost_farther = 0.025f;
/* least time between onion skins, as a part of the clip's duration */
static const float ghost_gap = 0.08f;
static const float before_color[4] = {0.30f, 0.62f, 1.0f, 0.36f};
static const float after_color[4] = {1.0f, 0.66f, 0.22f, 0.36f};

void overlay_push_place(const struct overlay *overlay,
	const struct overlay_figure *figure, float nearer)
{
	const struct camera *camera = overlay->camera;
	GLfixed scale = fx16_from_float(
		1.0f - nearer * overlay->subject.extent / camera->distance);
	mat4 view;

	overlay->gl->MatrixMode(GL_MODELVIEW);
	overlay->gl->PushMatrix();
	if (nearer != 0.0f) {
		camera_view(camera, view);
		overlay->gl->LoadIdentity();
		overlay->gl->Scalex(scale, scale, scale);
		matrix_gl_multiply(overlay->gl, (const vec4 *)view);
	}
	matrix_gl_multiply(overlay->gl, (const vec4 *)figure->place);
}

static void draw_ghost(struct overlay *overlay,
	const struct overlay_motion *motion, float time_s, const float color[4])
{
	const struct model_clip *clip =
		&overlay->subject.instance->model->clip[motion->clip];
	struct pose *pose = &overlay->ghost.instance->pose;
	struct clip_cursor none = {0};

	pose_rest(pose, overlay->subject.instance->model);
	clip_sample_as(clip, time_s, motion->interpolation, &none, pose);
	if (motion->travel) {
		float *at = pose->local[motion->traveller].translation;

		vec_add_scaled(
			at, motion->travel, -clip_share(clip, time_s), at);
	}
	overlay_ghost_draw(
		&overlay->ghost, overlay->gl, overlay->subject.textures, color);
}

/*
 * Returns the time of the next key frame; at an end of the clip the search goes
 * on from the clip's other end.
 */
static float next_key(const struct model_clip *clip, float time_s, float gap_s)
{
	float key_s = overlay_ghost_key_time(clip, time_s, gap_s);

	if (key_s < 0.0f) {
		time_s += gap_s > 0.0f ? -clip->duration_s : clip->duration_s;
		key_s = overlay_ghost_key_time(clip, time_s, gap_s);
	}
	return key_s;
}

/* Draws two key frames before the present moment and two after it. */
static void draw_ghosts(
	struct overlay *overlay, const struct overlay_motion *motion)
{
	const struct model_clip *clip =
		&overlay->subject.instance->model->clip[motion->clip];
	float gap_s = clip->duration_s * ghost_gap;

	for (int side = -1; side <= 1; side += 2) {
		float color[4], at_s = motion->time_s;

		memcpy(color, side < 0 ? before_color : after_color,
			sizeof(color));
		for (int i = 0; i < 2; i++) {
			at_s = next_key(clip, at_s, gap_s * (float)side);
			if (at_s < 0.0f) {
				break;
			}
			draw_ghost(overlay, motion, at_s, color);
			color[3] *= 0.6f;
		}
	}
}

struct overlay_row overlay_row_of(
	const struct overlay *overlay, int width, int height)
{
	struct overlay_row row = {.count = overlay->target_count + 1};

	row.count = row.count > ROW_MAX ? ROW_MAX : row.count;
	row.width = width / row.count;
	if (row.width > width / ROW_FRACTION) {
		row.width = width / ROW_FRACTION;
	}
	row.height = height * row.width / width;
	return row;
}

struct camera overlay_row_camera(
	const struct overlay_row *row, const struct camera *camera)
{
	static const struct camera_region whole = {-1.0f, 1.0f, -1.0f, 1.0f};
	struct camera own = *camera;

	camera_zoom(&own, 1.0f / own.fit.zoom);
	camera_set_region(&own, &whole, row_margin,
		(float)row->width / (float)row->height);
	return own;
}

/* Poses the ghost with one target at full weight; -1 is the base. */
static void pose_target(struct overlay *overlay, int target)
{
	const struct model *model = overlay->subject.instance->model;
	struct pose *pose = &overlay->ghost.instance->pose;

	pose_copy(pose, &overlay->subject.instance->pose);
	memset(pose->weight, 0,
		(size_t)pose->weight_count * sizeof(*pose->weight));
	for (int n = 0; target >= 0 && n < model->node_count; n++) {
		int mesh = model->node[n].mesh;

		if (mesh >= 0 && target < model->mesh[mesh].target_count) {
			pose->weight[model->node[n].weight_offset + target] =
				1.0f;
		}
	}
}

/* Returns a camera that shows the neutral shape alone, from the front. */
static struct camera camera_alone(
	struct overlay *overlay, const struct overlay_row *row)
{
	struct camera camera = camera_default();
	struct bounds box;

	pose_target(overlay, -1);
	instance_update(overlay->ghost.instance);
	box = bounds_of_instance(overlay->ghost.instance);
	camera_frame(&camera, &box,
		&(struct camera_framing){
			.aspect = (float)row->width / (float)row->height,
			.yaw_rad = camera.yaw_rad,
			.pitch_rad = camera.pitch_rad,
			.margin = row_margin,
			.follow = true,
		});
	return camera;
}

static void draw_pictures(struct overlay *overlay,
	const struct overlay_figure *figure, const struct overlay_row *row)
{
	const struct gl *gl = overlay->gl;
	struct camera camera = figure->among_others
		? camera_alone(overlay, row)
		: overlay_row_camera(row, overlay->camera);

	camera_apply(&camera, gl, row->width, row->height);
	if (!figure->among_others) {
		matrix_gl_multiply(gl, (const vec4 *)figure->place);
	}
	for (int i = 0; i < row->count; i++) {
		gl->Viewport(i * row->width, 0, row->width, row->height);
		pose_target(overlay, i - 1);
		overlay_ghost_draw_solid(
			&overlay->ghost, gl, overlay->subject.textures);
	}
}

static void draw_row(struct overlay *overlay,
	const struct overlay_figure *figure, int width, int height)
{
	const struct gl *gl = overlay->gl;
	struct overlay_row row = overlay_row_of(overlay, width, height);

	if (row.width == 0 || row.height == 0) {
		return;
	}
	gl->Enable(GL_SCISSOR_TEST);
	gl->Scissor(0, 0, row.width * row.count, row.height);
	gl->ClearColorx(FX16_ONE / 8, FX16_ONE / 7, FX16_ONE / 6, FX16_ONE);
	gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	draw_pictures(overlay, figure, &row);
	gl->Viewport(0, 0, width, height);
	gl->ClearColorx(0, 0, 0, 0);
	gl->Disable(GL_SCISSOR_TEST);
	camera_apply(overlay->camera, gl, width, height);
}

void overlay_draw_keys(struct overlay *overlay,
	const struct overlay_motion *motion,
	const struct overlay_figure *figure, int width, int height)
{
	if (!overlay_shows(overlay, OVERLAY_KEYS)) {
		return;
	}
	if (overlay->chooses_target) {
		draw_row(overlay, figure, width, height);
	} else if (motion->clip >= 0) {
		overlay_push_place(overlay, figure, -ghost_farther);
		draw_ghosts(overlay, motion);
		overlay->gl->PopMatrix();
	}
}
