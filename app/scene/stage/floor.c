#include "app/scene/stage/floor.h"

#include "app/anim/math/vec.h"
#include "app/scene/draw/texture.h"
#include "platform/base/fixed.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	TILE_TEXELS = 64,
	PERIOD_TILES = 8, /* the waves repeat after this many tiles */
};

static const float level_shade = 208.0f; /* of level ground, of 255 */
/* the ground is opaque up to this part of its radius and fades beyond */
static const float opaque_part = 0.5625f;
/* What lies on the ground is lifted by this many times floor_mesh_error(), */
static const float lift_errors = 4.0f;
/* but by no less and no more than these parts of its distance from the eye. */
static const float lift_min = 0.004f, lift_max = 0.1f;

/* A tile in two shades with joints, which make motion visible. */
static int make_texture(
	struct floor *floor, const struct gl *gl, enum pixel_format target)
{
	const struct model_texture sampling = {
		.wrap_s = MODEL_REPEAT, .wrap_t = MODEL_REPEAT, .mipmap = true};
	struct model_image image = {
		.width = TILE_TEXELS, .height = TILE_TEXELS, .opaque = true};

	image.rgba = malloc(TILE_TEXELS * TILE_TEXELS * 4);
	if (!image.rgba) {
		return -ENOMEM;
	}
	for (int i = 0; i < TILE_TEXELS * TILE_TEXELS; i++) {
		int x = i % TILE_TEXELS, y = i / TILE_TEXELS;
		int half = TILE_TEXELS / 2;
		bool joint = x % half == 0 || y % half == 0;
		bool dark = (x < half) != (y < half);

		memset(image.rgba + i * 4, joint ? 192 : dark ? 233 : 252, 3);
		image.rgba[i * 4 + 3] = 255;
	}
	floor->texture = texture_upload(gl, &image, &sampling, target);
	free(image.rgba);
	return floor->texture ? 0 : -ENOMEM;
}

float floor_height(const struct floor *floor, float x, float z)
{
	float turn = 2.0f * SCALAR_PI / (PERIOD_TILES * floor->tile);
	float u = (x + floor->offset[0]) * turn;
	float v = (z + floor->offset[1]) * turn;

	if (floor->wave_height == 0.0f) {
		return floor->y;
	}
	return floor->y +
		0.5f * floor->wave_height *
		(scalar_sin(2.0f * v + scalar_sin(u)) + scalar_sin(u + 0.7f));
}

float floor_mesh_error(
	const struct floor *floor, const float eye[3], float x, float z)
{
	float dx = scalar_abs(x - eye[0]), dz = scalar_abs(z - eye[2]);
	/* At least the distance, at most 8% more. */
	float away = dx > dz ? dx + 0.4143f * dz : dz + 0.4143f * dx;
	float above = scalar_abs(eye[1] - floor->y) + 0.01f * away;
	/* The sides of a triangle, in tiles. */
	float across = 0.15f * (away + above) / floor->tile;
	float ahead = 0.04f * (away / above * away + above) / floor->tile;

	/* The factors were measured; test_floor.c checks them. */
	return floor->wave_height *
		scalar_clamp(
			0.15f * (across * across + ahead * ahead), 0.01f, 0.6f);
}

void floor_lift(const struct floor *floor, const float eye[3], float point[3])
{
	float error = floor_mesh_error(floor, eye, point[0], point[2]);
	float above = eye[1] - point[1], share = lift_max;

	if (above * lift_max > lift_errors * error) {
		share = scalar_clamp(
			lift_errors * error / above, lift_min, lift_max);
	}
	vec_mix(point, eye, share, point);
}

/* Slopes that face the light are brighter. */
static uint8_t find_shade(const struct floor *floor, const float p[3])
{
	float step = 0.02f * floor->tile;
	float slope =
		(floor_height(floor, p[0] + step, p[2] + step) - p[1]) / step;

	return (uint8_t)scalar_clamp(
		level_shade * (1.0f - 0.8f * slope), 90.0f, 255.0f);
}

/*
 * The largest 1, 2 or 5 times a power of ten that is at most 1% above the size.
 * Many models are a round number of metres wide, in one number format a bit
 * more and in another a bit less: both must get the same tiles.
 */
static float round_down(float size)
{
	float step = 1.0f;

	size *= 1.01f;
	while (step * 10.0f <= size) {
		step *= 10.0f;
	}
	while (step > size) {
		step *= 0.1f;
	}
	return size >= step * 5.0f    ? step * 5.0f
		: size >= step * 2.0f ? step * 2.0f
				      : step;
}

/*
 * Returns the coordinate, between 0 and center, where the period of the pattern
 * of tiles and waves begins that contains center.
 */
static float find_origin(float center, float tile)
{
	float length = PERIOD_TILES * tile;
	float periods = center / length;

	return scalar_abs(periods) < 8388608.0f
		? (float)(int32_t)periods * length
		: 0.0f;
}

int floor_init(struct floor *floor, const struct gl *gl,
	const struct bounds *bounds, float unit, float min_radius,
	enum pixel_format target, const struct log *log)
{
	float middle[3], extent = bounds_extent(bounds);

	extent = extent > 1e-9f ? extent : 1.0f;
	bounds_center(bounds, middle);
	*floor = (struct floor){
		.y = bounds_ground(bounds),
		.center = {middle[0], middle[2]},
		.radius =
			2.2f * extent > min_radius ? 2.2f * extent : min_radius,
		.tile = unit * round_down(0.5f * extent / unit),
	};
	floor->origin[0] = find_origin(middle[0], floor->tile);
	floor->origin[1] = find_origin(middle[2], floor->tile);
	floor_mesh_list(floor->index);
	if (make_texture(floor, gl, target) != 0) {
		log_error(log,
			"there is not enough memory for the floor's texture");
		return -ENOMEM;
	}
	return 0;
}

void floor_finish(struct floor *floor, const struct gl *gl)
{
	if (floor->texture) {
		gl->DeleteTextures(1, &floor->texture);
		floor->texture = 0;
	}
}

/* The pattern repeats, so the offset can be kept small. */
static float wrap(float offset, float length)
{
	/* A huge offset would not change when a length is subtracted. */
	if (!(scalar_abs(offset) < 1000.0f * length)) {
		return 0.0f;
	}
	while (offset >= length) {
		offset -= length;
	}
	while (offset < 0.0f) {
		offset += length;
	}
	return offset;
}

void floor_scroll(struct floor *floor, float dx, float dz)
{
	float length = PERIOD_TILES * floor->tile;

	floor->offset[0] = wrap(floor->offset[0] + dx, length);
	floor->offset[1] = wrap(floor->offset[1] + dz, length);
}

void floor_set_wave_height(struct floor *floor, float wave_height)
{
	floor->wave_height = wave_height;
}

/*
 * Computes the mesh, its vertices' heights and shades, and its drawing order.
 */
static void find_mesh(const struct floor *floor, const struct camera *camera,
	int width, int height, const struct floor_mesh_ground *ground,
	const struct floor_content *content, struct floor_sight *out)
{
	floor_mesh_find(&out->mesh, camera, width, height, ground);
	for (int i = 0; out->mesh.seen && i < FLOOR_VERTICES; i++) {
		float *p = out->mesh.position[i];

		p[1] = floor_height(floor, p[0], p[2]);
		out->shade[i] = find_shade(floor, p);
	}
	if (out->mesh.seen) {
		floor_mesh_order(
			&out->mesh, floor->index, camera, content, &out->order);
	}
}

void floor_find_sight(const struct floor *floor, const struct camera *camera,
	int width, int height, const struct floor_content *content,
	struct floor_sight *out)
{
	float sine = scalar_sin(camera->yaw_rad);
	float cosine = scalar_cos(camera->yaw_rad);
	/* The floor extends at least to below a distant camera. */
	float min_radius = 1.1f * camera->distance;
	float radius = scalar_max(floor->radius, min_radius) +
		CAMERA_RISE_AHEAD * camera->rise;
	/* Ground has to fade before the far plane cuts it off. */
	float far = 0.95f *
		fx16_to_float(camera_frustum(camera, width, height).far);
	float eye[3], ahead;
	struct floor_mesh_ground ground = {
		.y = floor->y, .wave_height = floor->wave_height};

	camera_eye(camera, eye);
	ahead = (eye[0] - floor->center[0] - floor->way[0]) * sine +
		(eye[2] - floor->center[1] - floor->way[1]) * cosine;
	ground.opaque_end = ahead + opaque_part * radius;
	ground.end = ahead + radius;
	if (ground.end > far) {
		ground.end = far;
		ground.opaque_end = ground.opaque_end < opaque_part * far
			? ground.opaque_end
			: opaque_part * far;
	}
	if (floor->wave_height != 0.0f) {
		out->strips = (struct floor_strips){
			.horizon_px = height, .end_px = height};
		find_mesh(floor, camera, width, height, &ground, content, out);
	} else {
		floor_strips_find(&out->strips, camera, width, height, floor->y,
			ground.opaque_end, ground.end);
	}
}

/*
 * Counts from the floor's origin, so that the coordinates are small wherever
 * the floor is: GL has few bits for them.
 */
static void find_texcoord(
	const struct floor *floor, const float position[3], float out[2])
{
	out[0] = (position[0] - floor->origin[0]) / floor->tile;
	out[1] = (position[2] - floor->origin[1]) / floor->tile;
}

static void draw_runs(const struct floor_order *order, const struct gl *gl)
{
	const uint16_t *index = order->index;

	for (int i = 0; i < order->run_count; i++) {
		const struct floor_run *run = &order->run[i];

		if (run->fading) {
			gl->Enable(GL_BLEND);
		} else {
			gl->Disable(GL_BLEND);
		}
		gl->DepthMask(run->with_depth);
		gl->DrawElements(GL_TRIANGLES, run->index_count,
			GL_UNSIGNED_SHORT, index);
		index += run->index_count;
	}
	gl->DepthMask(GL_TRUE);
}

/* From far to near, so no depth test is needed. */
static void draw_mesh(const struct floor *floor,
	const struct floor_sight *sight, const struct gl *gl)
{
	float texcoord[FLOOR_VERTICES][2];
	uint8_t color[FLOOR_VERTICES][4];

	if (!sight->mesh.seen) {
		return;
	}
	for (int i = 0; i < FLOOR_VERTICES; i++) {
		const float *p = sight->mesh.position[i];

		find_texcoord(floor, p, texcoord[i]);
		memset(color[i], sight->shade[i], 3);
		color[i][3] = sight->mesh.alpha[i];
	}
	gl->VertexPointer(3, GL_FLOAT, 0, sight->mesh.position);
	gl->TexCoordPointer(2, GL_FLOAT, 0, texcoord);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, color);
	gl->DepthFunc(GL_ALWAYS);
	draw_runs(&sight->order, gl);
	gl->DepthFunc(GL_LESS);
}

/* Level ground hides none of itself, so no depth test is needed. */
static void draw_strips(const struct floor *floor,
	const struct floor_strips *strips, const struct gl *gl)
{
	float texcoord[6][2];
	uint8_t color[6][4];

	for (int i = 0; i < 6; i++) {
		find_texcoord(floor, strips->position[i], texcoord[i]);
		memset(color[i], (uint8_t)level_shade, 3);
		color[i][3] = strips->alpha[i];
	}
	gl->VertexPointer(3, GL_FLOAT, 0, strips->position);
	gl->TexCoordPointer(2, GL_FLOAT, 0, texcoord);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, color);
	gl->DepthFunc(GL_ALWAYS);
	if (strips->opaque) {
		gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
	}
	gl->Enable(GL_BLEND);
	if (strips->fading) {
		/* Fading ground does not hide what lies below it. */
		gl->DepthMask(GL_FALSE);
		gl->DrawArrays(GL_TRIANGLE_STRIP, 2, 4);
		gl->DepthMask(GL_TRUE);
	}
	gl->DepthFunc(GL_LESS);
}

void floor_draw(const struct floor *floor, const struct floor_sight *sight,
	const struct gl *gl)
{
	gl->Disable(GL_BLEND);
	gl->Disable(GL_LIGHTING);
	gl->Disable(GL_CULL_FACE);
	gl->Enable(GL_TEXTURE_2D);
	gl->BindTexture(GL_TEXTURE_2D, floor->texture);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
	gl->MatrixMode(GL_TEXTURE);
	gl->LoadIdentity();
	gl->Translatex(fx16_from_float(floor->offset[0] / floor->tile),
		fx16_from_float(floor->offset[1] / floor->tile), 0);
	gl->MatrixMode(GL_MODELVIEW);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->DisableClientState(GL_NORMAL_ARRAY);
	if (floor->wave_height != 0.0f) {
		draw_mesh(floor, sight, gl);
	} else {
		draw_strips(floor, &sight->strips, gl);
	}
	gl->Disable(GL_BLEND);
	gl->Disable(GL_TEXTURE_2D);
	gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
}
