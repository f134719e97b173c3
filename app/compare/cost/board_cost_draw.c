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
	DRAW_SINGLE,
	DRAW_SHADED,
	DRAW_HIDDEN,
	DRAW_SKIPPED,
	DRAW_FINE,
	DRAW_TRIANGLE, /* of each kind: its triangles, rows and pixels */
	DRAW_WORKS = DRAW_TRIANGLE + 3 * GL_WORK_KINDS
};

/* Cycles and instructions of each, which `make bench-draw-fit` writes. */
static const struct board_cost each[DRAW_WORKS] = {
	{3.179e+04, 2.223e+04}, /* frame */
	{0.78, 0.3777},         /* pixel */
	{1.668e+04, 5644},      /* call */
	{177, 83.35},           /* listed */
	{336.9, 65.3},          /* vertex */
	{312.4, 136.2},         /* single */
	{220.1, 237.4},         /* shaded */
	{15.91, 14.54},         /* hidden */
	{1200, 439.8},          /* skipped */
	{4.852, 2.408},         /* fine */
	{203, 83.36},           /* flat triangle */
	{74.2, 41.59},          /* flat row */
	{11.5, 7.927},          /* flat pixel */
	{565.2, 175.2},         /* plain triangle */
	{0, 16.13},             /* plain row */
	{17.99, 5.682},         /* plain pixel */
	{514.7, 436.6},         /* textured triangle */
	{220.5, 42.17},         /* textured row */
	{70.81, 56.56},         /* textured pixel */
	{3.32e+04, 1.172e+04},  /* backdrop triangle */
	{68.6, 29.11},          /* backdrop row */
	{2.776, 0.8647},        /* backdrop pixel */
	{3.371e+04, 1.223e+04}, /* ground triangle */
	{116.3, 54.09},         /* ground row */
	{3.393, 0.9561},        /* ground pixel */
	{1432, 860.2},          /* spans triangle */
	{136.5, 92.19},         /* spans row */
	{21.68, 14.74},         /* spans pixel */
	{2930, 1574},           /* spans textured triangle */
	{197.4, 115},           /* spans textured row */
	{106.6, 64.78},         /* spans textured pixel */
	{4789, 3815},           /* spans divided triangle */
	{702.5, 374.6},         /* spans divided row */
	{91.31, 55.6},          /* spans divided pixel */
	{1576, 672.5},          /* mixed triangle */
	{263.7, 148.8},         /* mixed row */
	{55.79, 38.68},         /* mixed pixel */
	{2951, 894.2},          /* tested triangle */
	{272.9, 164.2},         /* tested row */
	{167.3, 113.4},         /* tested pixel */
	{4028, 2526},           /* tested spans triangle */
	{622.8, 382.6},         /* tested spans row */
	{135.6, 86.38},         /* tested spans pixel */
	{3146, 1419},           /* mixed textured triangle */
	{251.3, 177.2},         /* mixed textured row */
	{142.7, 83.31},         /* mixed textured pixel */
	{3933, 3052},           /* mixed spans triangle */
	{480.8, 315.8},         /* mixed spans row */
	{141.8, 82.27},         /* mixed spans pixel */
	{5185, 4193},           /* mixed divided triangle */
	{2222, 1116},           /* mixed divided row */
	{124.4, 82.15},         /* mixed divided pixel */
	{204.3, 75.55},         /* colored triangle */
	{0, 0},                 /* colored row */
	{8.066, 3.408},         /* colored pixel */
	{2598, 1220},           /* bent triangle */
	{284.2, 148.4},         /* bent row */
	{3.392, 2.244},         /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.001, 0.9984},        /* deep row */
	{1.691, 1.222},         /* deep pixel */
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
	add_work(&sum, DRAW_SINGLE, counts->single);
	add_work(&sum, DRAW_SHADED, counts->shaded);
	add_work(&sum, DRAW_HIDDEN, counts->hidden);
	add_work(&sum, DRAW_SKIPPED, counts->skipped);
	add_work(&sum, DRAW_FINE, counts->fine);
	for (int i = 0; i < GL_WORK_KINDS; i++) {
		const struct gl_work *work = &counts->work[i];

		add_work(&sum, DRAW_TRIANGLE + 3 * i, work->triangles);
		add_work(&sum, DRAW_TRIANGLE + 3 * i + 1, work->rows);
		add_work(&sum, DRAW_TRIANGLE + 3 * i + 2, work->pixels);
	}
	return sum;
}
