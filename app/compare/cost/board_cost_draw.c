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
	DRAW_FINE,
	DRAW_TRIANGLE, /* of each kind: its triangles, rows and pixels */
	DRAW_WORKS = DRAW_TRIANGLE + 3 * GL_WORK_KINDS
};

/* Cycles and instructions of each, which `make bench-draw-fit` writes. */
static const struct board_cost each[DRAW_WORKS] = {
	{3.606e+04, 2.804e+04}, /* frame */
	{0.7615, 0.3722},       /* pixel */
	{1.873e+04, 7211},      /* call */
	{184.7, 75.63},         /* listed */
	{267.3, 67.34},         /* vertex */
	{280.7, 129.5},         /* single */
	{332.9, 276.5},         /* shaded */
	{13.46, 12.26},         /* hidden */
	{8.506, 5.897},         /* fine */
	{208.1, 90.88},         /* flat triangle */
	{71.17, 42.28},         /* flat row */
	{11.34, 7.37},          /* flat pixel */
	{495.7, 183.3},         /* plain triangle */
	{7.792, 20.32},         /* plain row */
	{24.03, 9.412},         /* plain pixel */
	{584.5, 473.8},         /* textured triangle */
	{334.6, 124.1},         /* textured row */
	{67.9, 55.38},          /* textured pixel */
	{4.349e+04, 1.769e+04}, /* backdrop triangle */
	{79.13, 36},            /* backdrop row */
	{2.599, 0.8432},        /* backdrop pixel */
	{4.381e+04, 1.804e+04}, /* ground triangle */
	{146.7, 81.64},         /* ground row */
	{4.136, 1.089},         /* ground pixel */
	{923.5, 666.9},         /* spans triangle */
	{162.9, 102.8},         /* spans row */
	{25.12, 16.39},         /* spans pixel */
	{2890, 1369},           /* spans textured triangle */
	{265.1, 157.2},         /* spans textured row */
	{99.9, 61.49},          /* spans textured pixel */
	{4867, 3911},           /* spans divided triangle */
	{721, 383.6},           /* spans divided row */
	{92.55, 58.86},         /* spans divided pixel */
	{1962, 1037},           /* mixed triangle */
	{258.7, 138},           /* mixed row */
	{58.24, 40.35},         /* mixed pixel */
	{3194, 1039},           /* tested triangle */
	{279.7, 172.7},         /* tested row */
	{168.7, 113.2},         /* tested pixel */
	{4057, 2550},           /* tested spans triangle */
	{627.4, 385.5},         /* tested spans row */
	{138.9, 88.4},          /* tested spans pixel */
	{3197, 1448},           /* mixed textured triangle */
	{253.4, 180.4},         /* mixed textured row */
	{144.7, 85.88},         /* mixed textured pixel */
	{3922, 3038},           /* mixed spans triangle */
	{480.1, 314.2},         /* mixed spans row */
	{148.3, 84.79},         /* mixed spans pixel */
	{5194, 4201},           /* mixed divided triangle */
	{2284, 1142},           /* mixed divided row */
	{125.2, 82.57},         /* mixed divided pixel */
	{190, 99.78},           /* colored triangle */
	{1.473, 0},             /* colored row */
	{7.908, 3.499},         /* colored pixel */
	{2546, 1220},           /* bent triangle */
	{284.6, 156.1},         /* bent row */
	{3.401, 2.308},         /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.004, 1.005},         /* deep row */
	{1.757, 1.257},         /* deep pixel */
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
	add_work(&sum, DRAW_FINE, counts->fine);
	for (int i = 0; i < GL_WORK_KINDS; i++) {
		const struct gl_work *work = &counts->work[i];

		add_work(&sum, DRAW_TRIANGLE + 3 * i, work->triangles);
		add_work(&sum, DRAW_TRIANGLE + 3 * i + 1, work->rows);
		add_work(&sum, DRAW_TRIANGLE + 3 * i + 2, work->pixels);
	}
	return sum;
}
