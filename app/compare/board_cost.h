/*
 * What a technique would take on the board, predicted: vertices and joints
 * times the cycles that the timing model of the board's core counted for its
 * loops (app/anim/kernel/arm11_cost.h). Nothing here ran on hardware, and it
 * is the same on every machine.
 *
 * Left out is what hangs on neither: a few hundred cycles a frame. Meshes that
 * the model ran in whole are within 5% of this
 * (tests/unit/app/compare/test_board_cost.c).
 */
#ifndef APP_COMPARE_BOARD_COST_H
#define APP_COMPARE_BOARD_COST_H

#include "app/compare/reference.h"

struct board_cost {
	double cycles, instructions; /* a frame */
};

/* Microseconds on the board. */
double board_cost_us(const struct board_cost *cost);

void board_cost_add(struct board_cost *cost, const struct board_cost *more);

/*
 * Sampling a clip, world matrices and palettes of a model's joints, or of its
 * nodes where it has no skin.
 */
struct board_cost board_cost_pose(const struct model *model);

/*
 * Skinning a primitive that has influences, at most max_influences a vertex
 * (0: all), with normals where it has them; the matrices of its joints in
 * fixed point included.
 */
struct board_cost board_cost_skin(
	const struct model_primitive *primitive, int max_influences);

/* Vertices on their way between two key frames. */
struct board_cost board_cost_lerp(int vertex_count, bool normals);

/*
 * Weighted targets, two by two: moves is how many vertices all pairs together
 * move.
 */
struct board_cost board_cost_targets(double moves, bool normals);

/*
 * All of an instance that plays the reference's clip, at most max_influences a
 * vertex (0: all): poses, targets as their weights change, skins. Leaves the
 * instance in some pose.
 */
struct board_cost board_cost_clip(const struct reference *reference,
	struct instance *instance, struct clip_cursor *cursor,
	int max_influences);

#endif
