/*
 * Predicts what a technique costs on the board.
 *
 * The cost is the number of vertices and joints times the cycles that the
 * timing model of the board's core counted for each loop
 * (app/anim/kernel/arm11_cost.h). Nothing was measured on hardware. The result
 * is the same on every machine.
 *
 * It leaves out a few hundred cycles a frame that depend on neither. It is
 * within 5% of the meshes that the timing model ran as a whole
 * (tests/unit/app/compare/test_board_cost.c).
 */
#ifndef APP_COMPARE_COST_BOARD_COST_H
#define APP_COMPARE_COST_BOARD_COST_H

#include "app/anim/clip.h"
#include "app/scene/instance/instance.h"

struct board_cost {
	double cycles, instructions; /* a frame */
};

/* Converts cycles to microseconds at the board's clock rate. */
double board_cost_us(const struct board_cost *cost);

/* Adds more to *cost. */
void board_cost_add(struct board_cost *cost, const struct board_cost *more);

/*
 * The cost of sampling a clip and of computing world matrices and palettes, for
 * the joints of a model, or for its nodes when it has no skin.
 */
struct board_cost board_cost_pose(const struct model *model);

/* The same for a number of joints or nodes. */
struct board_cost board_cost_joints(int count);

/*
 * The cost of skinning a primitive that has influences, at most max_influences
 * a vertex (0: all), and its normals if it has any. This includes converting
 * the matrices of its joints to fixed point.
 */
struct board_cost board_cost_skin(
	const struct model_primitive *primitive, int max_influences);

/* The cost of interpolating vertices between two key frames. */
struct board_cost board_cost_keys(int vertex_count, bool normals);

/*
 * The cost of adding weighted targets, which the loops take in pairs. moves is
 * the number of vertices that each pair moves, summed over all pairs.
 */
struct board_cost board_cost_targets(double moves, bool normals);

/*
 * The cost of everything an instance does in an average frame of the clip at
 * rate_hz frames a second, with at most max_influences a vertex (0: all). It
 * changes the instance's pose.
 */
struct board_cost board_cost_clip(const struct model_clip *clip,
	struct instance *instance, struct clip_cursor *cursor,
	int max_influences, double rate_hz);

#endif
