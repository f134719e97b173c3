/*
 * Predicts what a picture costs from what it consists of.
 */
#include "app/compare/cost/board_cost.h"

enum draw_work {
	DRAW_FRAME,
	DRAW_PIXEL, /* of the picture */
	DRAW_CALL,
	DRAW_LISTED,
	DRAW_VERTEX,
	DRAW_SHADED,
	DRAW_HIDDEN,
	DRAW_TRIANGLE, /* of each kind: its triangles, rows and pixels */
	DRAW_WORKS = DRAW_TRIANGLE + 3 * GL_WORK_KINDS
};

/* Cycles and instructions of each, which `make bench-draw-fit` writes. */
static const struct board_cost each[DRAW_WORKS] = {
	{2.597e+04, 2.198e+04}, /* frame */
	{0.7568, 0.4636},       /* pixel */
	{1.768e+04, 7654},      /* call */
	{261.9, 152.6},         /* listed */
	{0, 0},                 /* vertex */
	{869.5, 189.9},         /* shaded */
	{10.87, 9.188},         /* hidden */
	{0, 0},                 /* flat triangle */
	{0, 0},                 /* flat row */
	{11.85, 8.028},         /* flat pixel */
	{636.1, 475.8},         /* plain triangle */
	{0, 0},                 /* plain row */
	{20.61, 6.945},         /* plain pixel */
	{938, 5.948},           /* textured triangle */
	{315.2, 221},           /* textured row */
	{68.49, 42.37},         /* textured pixel */
	{6.779e+04, 4.181e+04}, /* ground triangle */
	{77.43, 0},             /* ground row */
	{6.767, 3.414},         /* ground pixel */
	{1336, 885.6},          /* spans triangle */
	{167.8, 106.1},         /* spans row */
	{27.58, 17.42},         /* spans pixel */
	{2789, 2865},           /* spans textured triangle */
	{862.9, 419.7},         /* spans textured row */
	{81.61, 43.96},         /* spans textured pixel */
	{4447, 5088},           /* spans divided triangle */
	{943.6, 522.7},         /* spans divided row */
	{107.9, 69.15},         /* spans divided pixel */
	{2273, 2027},           /* mixed triangle */
	{142.8, 6.136},         /* mixed row */
	{67.84, 47.5},          /* mixed pixel */
	{3175, 1355},           /* mixed textured triangle */
	{251.7, 194},           /* mixed textured row */
	{150.2, 96.84},         /* mixed textured pixel */
};

static void add_work(struct board_cost *sum, int work, double count)
{
	sum->cycles += each[work].cycles * count;
	sum->instructions += each[work].instructions * count;
}

struct board_cost board_cost_draw(const struct gl_counts *counts, double pixels)
{
	struct board_cost sum = {0.0, 0.0};

	add_work(&sum, DRAW_FRAME, 1.0);
	add_work(&sum, DRAW_PIXEL, pixels);
	add_work(&sum, DRAW_CALL, counts->calls);
	add_work(&sum, DRAW_LISTED, counts->listed);
	add_work(&sum, DRAW_VERTEX, counts->vertices);
	add_work(&sum, DRAW_SHADED, counts->shaded);
	add_work(&sum, DRAW_HIDDEN, counts->hidden);
	for (int i = 0; i < GL_WORK_KINDS; i++) {
		const struct gl_work *work = &counts->work[i];

		add_work(&sum, DRAW_TRIANGLE + 3 * i, work->triangles);
		add_work(&sum, DRAW_TRIANGLE + 3 * i + 1, work->rows);
		add_work(&sum, DRAW_TRIANGLE + 3 * i + 2, work->pixels);
	}
	return sum;
}
