/*
 * The floor: tiled ground that fades into the background with distance.
 *
 * Level ground is drawn as two strips that cover what the camera sees of the
 * plane (floor_strips.h), uneven ground as a mesh of it (floor_mesh.h). Under a
 * figure that walks on the spot the floor scrolls: an offset moves its tiles
 * and heights.
 */
#ifndef APP_SCENE_STAGE_FLOOR_H
#define APP_SCENE_STAGE_FLOOR_H

#include "app/scene/instance/bounds.h"
#include "app/scene/stage/floor_mesh.h"
#include "app/scene/stage/floor_strips.h"
#include "platform/display/pixels.h"
#include "platform/gl/gl.h"

/* Lengths are in scene units. */
struct floor {
	float y;         /* the height of level ground */
	float center[2]; /* x, z */
	float way[2]; /* x, z; how far the middle has moved from the center */
	float radius;
	float tile;        /* side of a tile */
	float origin[2];   /* x, z of a corner of the pattern near the center */
	float offset[2];   /* x, z; how far the floor has scrolled */
	float wave_height; /* greatest distance from y; 0 means level ground */
	GLuint texture;
	uint16_t index[FLOOR_INDICES]; /* of the mesh */
};

/*
 * Makes level ground under the box with at least the given radius. The side of
 * a tile, which waves have too, is a round number of the model's units; unit is
 * one of these in scene units. Returns 0, or -ENOMEM after logging an error.
 * Release it with floor_finish().
 */
int floor_init(struct floor *floor, const struct gl *gl,
	const struct bounds *bounds, float unit, float min_radius,
	enum pixel_format target, const struct log *log);

void floor_finish(struct floor *floor, const struct gl *gl);

/* Scrolls the floor by a distance along x and z. */
void floor_scroll(struct floor *floor, float dx, float dz);

/* Makes the ground uneven, or level with 0. */
void floor_set_wave_height(struct floor *floor, float wave_height);

/* Returns the ground's height at a point, in scene units. */
float floor_height(const struct floor *floor, float x, float z);

/*
 * Returns how far the drawn surface may be from floor_height() at a point that
 * is seen from the eye: its triangles are flat, the ground between their
 * corners is not. Triangles are larger far away, and so is the error.
 */
float floor_mesh_error(
	const struct floor *floor, const float eye[3], float x, float z);

/*
 * Moves a point on the ground towards the eye, which leaves its place in the
 * picture as it is, so far that the mesh's triangles do not hide it. A shadow
 * drawn there with the depth test is hidden only by hills in front of it.
 */
void floor_lift(const struct floor *floor, const float eye[3], float point[3]);

/* What a camera sees of the ground: the strips, or the other members. */
struct floor_sight {
	struct floor_strips strips; /* of level ground */
	struct floor_mesh mesh;     /* of uneven ground */
	struct floor_order order;   /* of the mesh's triangles */
	uint8_t shade[FLOOR_VERTICES];
};

/*
 * Computes what a camera sees of the ground, and which triangles of the mesh
 * have to write depths for this content. Uneven ground may be anywhere in the
 * picture: its strips are empty and have a horizon at the picture's upper edge.
 */
void floor_find_sight(const struct floor *floor, const struct camera *camera,
	int width, int height, const struct floor_content *content,
	struct floor_sight *out);

/* Draws with the camera's model-view matrix loaded; leaves lighting off. */
void floor_draw(const struct floor *floor, const struct floor_sight *sight,
	const struct gl *gl);

#endif
