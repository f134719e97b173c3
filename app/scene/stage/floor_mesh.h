/*
 * The part of uneven ground that a camera sees, as a mesh.
 *
 * Its rows and columns are regular in the picture, the rows denser towards the
 * horizon, so that triangles are about equally large wherever the camera is,
 * and none is out of view. Like the strips of level ground, the near rows are
 * opaque and the far ones fade out.
 */
#ifndef APP_SCENE_STAGE_FLOOR_MESH_H
#define APP_SCENE_STAGE_FLOOR_MESH_H

#include "app/scene/instance/bounds.h"
#include "app/scene/stage/camera.h"

enum {
	FLOOR_OPAQUE_ROWS = 12,
	FLOOR_FADING_ROWS = 3,
	FLOOR_ROWS = FLOOR_OPAQUE_ROWS + FLOOR_FADING_ROWS,
	FLOOR_COLUMNS = 4,
	FLOOR_VERTICES = (FLOOR_ROWS + 1) * (FLOOR_COLUMNS + 1),
	FLOOR_FADING_INDICES = FLOOR_FADING_ROWS * FLOOR_COLUMNS * 6,
	FLOOR_OPAQUE_INDICES = FLOOR_OPAQUE_ROWS * FLOOR_COLUMNS * 6,
	FLOOR_INDICES = FLOOR_FADING_INDICES + FLOOR_OPAQUE_INDICES,
	FLOOR_RUNS_MAX = 2 * FLOOR_ROWS,
};

struct floor_mesh {
	bool seen;                         /* the rest is valid */
	float position[FLOOR_VERTICES][3]; /* scene units */
	uint8_t alpha[FLOOR_VERTICES];
};

/* Where the ground is; lengths are in scene units. */
struct floor_mesh_ground {
	float y;           /* the height of level ground */
	float wave_height; /* greatest distance from y */
	/* Level distances ahead of the eye: where it fades, where it ends. */
	float opaque_end, end;
};

/*
 * What is drawn after the ground and tested against its depths: what is in
 * these boxes, each of which may be empty, or, if it is not bounded, anything
 * anywhere.
 */
struct floor_content {
	bool bounded;
	struct bounds standing; /* along the axes of the camera's view */
	struct bounds lying;    /* on the ground, in scene units */
};

/* Triangles that are drawn in one call; each is whole. */
struct floor_run {
	int index_count;
	bool fading;
	bool with_depth; /* their depths may matter */
};

/* All triangles of the mesh, of far rows first. */
struct floor_order {
	int run_count, index_count;
	struct floor_run run[FLOOR_RUNS_MAX];
	uint16_t index[FLOOR_INDICES];
};

/*
 * Computes the vertices of the level mesh: at every height up to wave_height
 * above or below it, they still surround what the camera sees. A camera in or
 * under the waves may see where the mesh begins.
 */
void floor_mesh_find(struct floor_mesh *mesh, const struct camera *camera,
	int width, int height, const struct floor_mesh_ground *ground);

/*
 * Writes the triangles' corners, of far rows first: in this order near hills
 * cover what is behind them without a depth test. The fading ones come first.
 */
void floor_mesh_list(uint16_t index[FLOOR_INDICES]);

/*
 * Whether a hill may hide, from the eye, something of what lies on the ground in
 * a box: a triangle of the mesh with its heights faces away from the eye, and is
 * not beyond the box or beside it. What is hidden has such a triangle before it.
 */
bool floor_mesh_may_hide(const struct floor_mesh *mesh,
	const uint16_t index[FLOOR_INDICES], const float eye[3],
	const struct bounds *box);

/*
 * Orders the triangles of floor_mesh_list() for drawing the mesh with its
 * heights. The depths of those that do not touch the picture of the content need
 * not be written. What lies on the ground counts only where a hill may hide it.
 */
void floor_mesh_order(const struct floor_mesh *mesh,
	const uint16_t index[FLOOR_INDICES], const struct camera *camera,
	const struct floor_content *content, struct floor_order *out);

#endif
