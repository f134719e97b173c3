/*
 * Predicts what a technique costs on the board.
 *
 * The cost is the number of vertices, joints, nodes and channels times the
 * cycles that the timing model of the board's core counted
 * (app/anim/kernel/arm11_cost.h and board_cost.c), with the data of each frame
 * in memory; and what a picture consists of (cost/drawing.h) times its cycles
 * (board_cost_draw.c). Nothing was measured on hardware. The result is the same
 * on every machine. It is within 10% of what the model counts when it plays the
 * files (tests/bench/play_check.py).
 */
#ifndef APP_COMPARE_COST_BOARD_COST_H
#define APP_COMPARE_COST_BOARD_COST_H

#include "app/anim/clip.h"
#include "app/scene/instance/instance.h"
#include "platform/gl/gl_counts.h"

struct board_cost {
	double cycles, instructions; /* a frame */
};

/* The steps of a frame. */
struct board_frame {
	struct board_cost sample;   /* the clip's values at a time */
	struct board_cost matrices; /* of nodes, and palettes of skins */
	struct board_cost vertices; /* the loops, and converting palettes */
	struct board_cost draw;     /* without labels */
};

/* Converts cycles to microseconds at the board's clock rate. */
double board_cost_us(const struct board_cost *cost);

/* Adds more to *cost. */
void board_cost_add(struct board_cost *cost, const struct board_cost *more);

/* All steps together; and those before the frame is drawn. */
struct board_cost board_frame_sum(const struct board_frame *frame);
struct board_cost board_frame_posing(const struct board_frame *frame);

/* The cost of sampling a clip whose values are written to so many nodes. */
struct board_cost board_cost_sample(
	const struct model_clip *clip, int node_count);

/* The same for weights of a number of key frames of a morph's single node. */
struct board_cost board_cost_sample_keys(int key_count);

/* The cost of matrices of nodes, and of the palettes of joints. */
struct board_cost board_cost_matrices(int node_count, int joint_count);

/* The cost of drawables whose vertices stay as they are in their node. */
struct board_cost board_cost_solid(int drawable_count);

/*
 * The cost of skinning a primitive that has influences, at most max_influences
 * a vertex (0: all), and its normals if it has any. This includes converting
 * the matrices of its joints to fixed point. It leaves out what depends on the
 * number of runs.
 */
struct board_cost board_cost_skin(
	const struct model_primitive *primitive, int max_influences);

/*
 * The cost of interpolating a drawable's vertices between two of its key
 * frames, which are found by their weights.
 */
struct board_cost board_cost_keys(int vertex_count, bool normals, int key_count);

/*
 * The cost of copying a drawable's posed vertices for GL, and of the normals of
 * its facets: of one without normals (app/scene/instance/batch.h). 0 of others.
 */
struct board_cost board_cost_gather(const struct drawable *drawable);

/* The cost of drawing what is counted, in a picture of so many pixels. */
struct board_cost board_cost_draw(const struct gl_counts *counts, double pixels);

/* What weighted targets do in an average frame, over all attributes. */
struct board_targets {
	double weights; /* targets */
	double copied;  /* vertices that no target with a weight moves */
	double paired;  /* vertices that a single pair of targets moves */
	double begun;   /* vertices, if several pairs have weights */
	double visits;  /* of the chunks of these, by each pair */
	double pieces;  /* spans of pairs with weights, cut at chunks */
	double added;   /* of these vertices, by each pair that moves them */
	double rebased; /* influences of a skin that are rewritten */
};

struct board_cost board_cost_targets(const struct board_targets *targets);

/*
 * The cost of everything an instance does in an average frame of the clip at
 * rate_hz frames a second, with at most max_influences a vertex (0: all). It
 * changes the instance's pose and its cap.
 */
struct board_frame board_cost_clip(const struct model_clip *clip,
	struct instance *instance, struct clip_cursor *cursor,
	int max_influences, double rate_hz);

#endif
