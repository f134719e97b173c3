/*
 * Predicts what a technique costs on the board.
 *
 * The cost of posing is the number of vertices, joints, nodes and channels
 * times cycles that the timing model of the board's core counted
 * (app/anim/kernel/arm11_cost.h and board_cost.c), with the data of each frame
 * in memory. The cost of drawing is what a picture consists of (cost/drawing.h)
 * times its cycles (board_cost_draw.c). Nothing was measured on hardware. The
 * result is the same on every machine, and within 10% of what the timing model
 * counts when limber plays the files on it (tests/bench/play_check.py).
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
	struct board_cost sample;   /* sampling the clip's channels */
	struct board_cost matrices; /* world matrices and joint palettes */
	struct board_cost vertices; /* morphing, skinning; palette to fixed point */
	struct board_cost draw;     /* the picture without labels */
};

/* Converts cycles to microseconds at the board's clock rate. */
double board_cost_us(const struct board_cost *cost);

/* Adds more to *cost. */
void board_cost_add(struct board_cost *cost, const struct board_cost *more);

/* The sums of all steps, and of those before drawing. */
struct board_cost board_frame_sum(const struct board_frame *frame);
struct board_cost board_frame_posing(const struct board_frame *frame);

/* The cost of sampling a clip of a model with node_count nodes. */
struct board_cost board_cost_sample(
	const struct model_clip *clip, int node_count);

/* The same for the weights of a morph: one node with key_count targets. */
struct board_cost board_cost_sample_keys(int key_count);

/*
 * The cost of the nodes' world matrices, of which so many have no parent, and
 * of the joints' palette matrices.
 */
struct board_cost board_cost_matrices(
	int node_count, int root_count, int joint_count);

/* The number of the model's nodes without a parent. */
int board_cost_count_roots(const struct model *model);

/* The cost of drawables without skin and morph, which move with their nodes. */
struct board_cost board_cost_solid(int drawable_count);

/*
 * The cost of skinning a primitive that has influences, at most max_influences
 * a vertex (0: all), and its normals if it has any. This includes converting
 * the matrices of its joints to fixed point. It leaves out the cost of each run
 * of vertices with the same joints.
 */
struct board_cost board_cost_skin(
	const struct model_primitive *primitive, int max_influences);

/*
 * The same of these vertices alone (NULL: the first ones), without matrices.
 */
struct board_cost board_cost_skin_vertices(
	const struct model_primitive *primitive, const uint32_t *vertex,
	int count, int max_influences);

/*
 * The cost of the skinned vertices, and of their runs, that the drawable's last
 * update left out (instance_create_for_drawing()). 0 if it is posed in float.
 */
struct board_cost board_cost_skin_left_out(const struct drawable *drawable);

/*
 * The cost of interpolating a drawable's vertices between two of its key
 * frames, which are found by searching key_count weights.
 */
struct board_cost board_cost_keys(int vertex_count, bool normals, int key_count);

/*
 * The cost of copying a drawable's posed vertices for GL and, if it has no
 * normals, of computing a normal for each facet. 0 if its batches draw the
 * posed vertices directly (app/scene/instance/batch/batch.h).
 */
struct board_cost board_cost_gather(const struct drawable *drawable);

/* The same for the lists that the drawable's level of detail has. */
struct board_cost board_cost_gather_drawn(const struct drawable *drawable);

/* The cost of drawing what is counted, in a picture of so many pixels. */
struct board_cost board_cost_draw(const struct gl_counts *counts, double pixels);

/*
 * The cost of laying a shadow on uneven ground of the model's own: points that
 * are listed, and rays of light that are followed to the ground
 * (cost/drawing.h).
 */
struct board_cost board_cost_lay(double points, double rays);

/* Work of weighted targets in an average frame, summed over attributes. */
struct board_targets {
	double weights; /* targets */
	double copied;  /* vertices that no target with a weight moves */
	double paired;  /* vertices that a single pair of targets moves */
	double spans;   /* of this pair */
	double begun;   /* vertices initialised for several pairs */
	double visits; /* chunks of vertices, times pairs, with weights or not */
	/* chunks times pairs with weights, and steps to find their first spans */
	double searches, steps;
	double pieces;  /* spans of several pairs, cut at chunk ends */
	double added;   /* vertices that each of several pairs moves */
	double rebased; /* base vectors of skin influences rewritten */
};

struct board_cost board_cost_targets(const struct board_targets *targets);

/*
 * The cost of posing an instance in an average frame of the clip at rate_hz
 * frames a second, with at most max_influences a vertex (0: all); draw is 0.
 * Changes the instance's pose and its cap on influences.
 */
struct board_frame board_cost_clip(const struct model_clip *clip,
	struct instance *instance, struct clip_cursor *cursor,
	int max_influences, double rate_hz);

#endif
