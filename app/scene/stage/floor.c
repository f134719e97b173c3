#include "app/scene/stage/floor.h"

#include "app/scene/draw/texture.h"
#include "app/scene/draw/triangle_list.h"
#include "platform/base/fixed.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum {
	TILE_TEXELS = 64,
	PERIOD_TILES = 8, /* the waves repeat after this many tiles */
};

static const float level_shade = 208.0f; /* of 255, on level ground */

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

/* Alpha falls linearly with the radius, which is the ring's square. */
static uint8_t alpha_at(int ring)
{
	const int end = FLOOR_RINGS * FLOOR_RINGS;
	const int fading = end - FLOOR_OPAQUE_RING * FLOOR_OPAQUE_RING;
	int left = end - ring * ring;

	return (uint8_t)(left >= fading ? 255 : 255 * left / fading);
}

/* Rings get wider outwards, so that the middle has more detail. */
static void place_vertices(struct floor *floor)
{
	for (int i = 0; i < FLOOR_VERTICES; i++) {
		int ring = i ? (i - 1) / FLOOR_SPOKES + 1 : 0;
		float fraction = (float)ring / FLOOR_RINGS;
		float angle = (float)((i + FLOOR_SPOKES - 1) % FLOOR_SPOKES) *
			(2.0f * SCALAR_PI / FLOOR_SPOKES);
		float out = floor->radius * fraction * fraction;
		float *p = floor->position[i];

		p[0] = floor->center[0] + out * scalar_cos(angle);
		p[2] = floor->center[1] + out * scalar_sin(angle);
		floor->texcoord[i][0] = p[0] / floor->tile;
		floor->texcoord[i][1] = p[2] / floor->tile;
		floor->color[i][3] = alpha_at(ring);
	}
}

/* Inner rings use fewer spokes, so that their triangles are not slivers. */
static int count_spokes(int ring)
{
	return ring <= FLOOR_QUARTER_RING ? FLOOR_SPOKES / 4
		: ring <= FLOOR_HALF_RING ? FLOOR_SPOKES / 2
					  : FLOOR_SPOKES;
}

/* The vertex of a ring at the n-th of its spokes; ring 0 is the middle. */
static uint16_t vertex_at(int ring, int n)
{
	int count = count_spokes(ring);

	return (uint16_t)(ring == 0 ? 0
				    : 1 + (ring - 1) * FLOOR_SPOKES +
				n % count * (FLOOR_SPOKES / count));
}

/* The triangles between a ring and the next one. */
static uint16_t *list_ring(uint16_t *next, int ring)
{
	int inner = ring == 0 ? 1 : count_spokes(ring);
	int outer = count_spokes(ring + 1), each = outer / inner;

	for (int i = 0; i < inner; i++) {
		int first = i * each, middle = first + each / 2;
		int a = vertex_at(ring, i), b = vertex_at(ring, i + 1);

		if (ring > 0) {
			next = triangle_list_add(
				next, a, b, vertex_at(ring + 1, middle));
		}
		for (int n = first; n < first + each; n++) {
			next = triangle_list_add(next, vertex_at(ring + 1, n),
				n < middle ? a : b, vertex_at(ring + 1, n + 1));
		}
	}
	return next;
}

static void list_triangles(struct floor *floor)
{
	uint16_t *next = floor->index;

	for (int ring = 0; ring < FLOOR_RINGS; ring++) {
		next = list_ring(next, ring);
	}
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

float floor_mesh_error(const struct floor *floor, float x, float z)
{
	float dx = scalar_abs(x - floor->center[0]);
	float dz = scalar_abs(z - floor->center[1]);
	/* At least the distance from the centre, at most 8% more. */
	float out = dx > dz ? dx + 0.4143f * dz : dz + 0.4143f * dx;
	float share = 0.06f * floor->radius + 0.7f * out;

	/* The factors were measured; test_floor.c holds them. */
	return share < 0.4f * floor->radius
		? floor->wave_height * share / floor->radius
		: 0.4f * floor->wave_height;
}

/* Whether triangles have this vertex: inner rings do not use all spokes. */
static bool is_used(int vertex)
{
	int ring = vertex ? (vertex - 1) / FLOOR_SPOKES + 1 : 0;
	int each = FLOOR_SPOKES / count_spokes(ring);

	return vertex == 0 || (vertex - 1) % FLOOR_SPOKES % each == 0;
}

/* Heights, and shades in which slopes that face the light are brighter. */
static void update_surface(struct floor *floor)
{
	float step = 0.02f * floor->tile;

	for (int i = 0; i < FLOOR_VERTICES; i++) {
		float *p = floor->position[i];
		float slope, value;

		if (!is_used(i)) {
			continue;
		}
		p[1] = floor_height(floor, p[0], p[2]);
		slope = floor->wave_height == 0.0f
			? 0.0f
			: (floor_height(floor, p[0] + step, p[2] + step) - p[1]) /
				step;
		value = scalar_clamp(
			level_shade * (1.0f - 0.8f * slope), 90.0f, 255.0f);
		memset(floor->color[i], (uint8_t)value, 3);
	}
}

/* The largest 1, 2 or 5 times a power of ten that is not above the size. */
static float round_down(float size)
{
	float step = 1.0f;

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

int floor_init(struct floor *floor, const struct gl *gl,
	const struct bounds *bounds, float min_radius, enum pixel_format target,
	const struct log *log)
{
	float middle[3], extent = bounds_extent(bounds);

	extent = extent > 1e-9f ? extent : 1.0f;
	bounds_center(bounds, middle);
	*floor = (struct floor){
		.y = bounds_is_empty(bounds) ? 0.0f : bounds->low[1],
		.center = {middle[0], middle[2]},
		.radius =
			2.2f * extent > min_radius ? 2.2f * extent : min_radius,
		.tile = round_down(0.5f * extent),
	};
	place_vertices(floor);
	list_triangles(floor);
	update_surface(floor);
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
	/* Steps that do not fit the pattern would not get smaller. */
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
	if (floor->wave_height != 0.0f && (dx != 0.0f || dz != 0.0f)) {
		update_surface(floor);
	}
}

void floor_set_wave_height(struct floor *floor, float wave_height)
{
	if (wave_height != floor->wave_height) {
		floor->wave_height = wave_height;
		update_surface(floor);
	}
}

void floor_visible_strips(const struct floor *floor, const struct camera *camera,
	int width, int height, struct floor_strips *out)
{
	const float opaque_fraction =
		(float)(FLOOR_OPAQUE_RING * FLOOR_OPAQUE_RING) /
		(FLOOR_RINGS * FLOOR_RINGS);
	float sine = scalar_sin(camera->yaw_rad);
	float cosine = scalar_cos(camera->yaw_rad);
	/* The floor extends at least to below a distant camera. */
	float min_radius = 1.1f * camera->distance;
	float radius = floor->radius > min_radius ? floor->radius : min_radius;
	float eye[3], ahead;

	if (floor->wave_height != 0.0f) {
		*out = (struct floor_strips){.horizon_px = height};
		return;
	}
	camera_eye(camera, eye);
	ahead = (eye[0] - floor->center[0]) * sine +
		(eye[2] - floor->center[1]) * cosine;
	floor_strips_find(out, camera, width, height, floor->y,
		ahead + opaque_fraction * radius, ahead + radius);
}

static void draw_disc(const struct floor *floor, const struct gl *gl)
{
	gl->VertexPointer(3, GL_FLOAT, 0, floor->position);
	gl->TexCoordPointer(2, GL_FLOAT, 0, floor->texcoord);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, floor->color);
	gl->DrawElements(GL_TRIANGLES, FLOOR_OPAQUE_INDICES, GL_UNSIGNED_SHORT,
		floor->index);
	gl->Enable(GL_BLEND);
	gl->DrawElements(GL_TRIANGLES, FLOOR_INDICES - FLOOR_OPAQUE_INDICES,
		GL_UNSIGNED_SHORT, floor->index + FLOOR_OPAQUE_INDICES);
}

/* Level ground hides none of itself, so no depth test is needed. */
static void draw_strips(const struct floor *floor,
	const struct floor_strips *strips, const struct gl *gl)
{
	float texcoord[6][2];
	uint8_t color[6][4];

	for (int i = 0; i < 6; i++) {
		texcoord[i][0] = strips->position[i][0] / floor->tile;
		texcoord[i][1] = strips->position[i][2] / floor->tile;
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

void floor_draw(const struct floor *floor, const struct floor_strips *strips,
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
		draw_disc(floor, gl);
	} else {
		draw_strips(floor, strips, gl);
	}
	gl->Disable(GL_BLEND);
	gl->Disable(GL_TEXTURE_2D);
	gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
}
