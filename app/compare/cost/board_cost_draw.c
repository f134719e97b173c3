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
	{3.548e+04, 2.718e+04}, /* frame */
	{0.7643, 0.3768},       /* pixel */
	{1.882e+04, 7240},      /* call */
	{173.5, 73.03},         /* listed */
	{282.6, 70.31},         /* vertex */
	{300.3, 136.1},         /* single */
	{301.8, 267.6},         /* shaded */
	{11.74, 10.7},          /* hidden */
	{8.864, 6.145},         /* fine */
	{182.7, 78.81},         /* flat triangle */
	{67.15, 40.95},         /* flat row */
	{12.27, 8.023},         /* flat pixel */
	{481.3, 168.6},         /* plain triangle */
	{5.337, 22.1},          /* plain row */
	{24.05, 9.418},         /* plain pixel */
	{578.2, 495.6},         /* textured triangle */
	{327.7, 117.9},         /* textured row */
	{69.42, 56.61},         /* textured pixel */
	{4.21e+04, 1.682e+04},  /* backdrop triangle */
	{76.83, 34.76},         /* backdrop row */
	{2.61, 0.8585},         /* backdrop pixel */
	{4.243e+04, 1.718e+04}, /* ground triangle */
	{138.2, 74.9},          /* ground row */
	{4.072, 1.019},         /* ground pixel */
	{542.7, 384.6},         /* spans triangle */
	{138.8, 95.3},          /* spans row */
	{30.82, 19.5},          /* spans pixel */
	{2887, 1357},           /* spans textured triangle */
	{258.2, 158.6},         /* spans textured row */
	{99.47, 61.39},         /* spans textured pixel */
	{4790, 3834},           /* spans divided triangle */
	{692.7, 364.1},         /* spans divided row */
	{98.33, 62.26},         /* spans divided pixel */
	{1881, 1017},           /* mixed triangle */
	{245.2, 133.5},         /* mixed row */
	{61.2, 42.17},          /* mixed pixel */
	{3279, 1038},           /* tested triangle */
	{285.8, 173.2},         /* tested row */
	{170, 113.5},           /* tested pixel */
	{4047, 2547},           /* tested spans triangle */
	{624.3, 384.4},         /* tested spans row */
	{139.5, 88.81},         /* tested spans pixel */
	{3198, 1446},           /* mixed textured triangle */
	{253.6, 180.4},         /* mixed textured row */
	{145, 86.19},           /* mixed textured pixel */
	{3913, 3039},           /* mixed spans triangle */
	{474.6, 313.6},         /* mixed spans row */
	{145.6, 85.57},         /* mixed spans pixel */
	{5189, 4198},           /* mixed divided triangle */
	{2329, 1172},           /* mixed divided row */
	{129.3, 85.73},         /* mixed divided pixel */
	{183.5, 107},           /* colored triangle */
	{17.08, 4.349},         /* colored row */
	{7.156, 3.135},         /* colored pixel */
	{2623, 1235},           /* bent triangle */
	{291.3, 158.4},         /* bent row */
	{3.416, 2.317},         /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.003, 1.003},         /* deep row */
	{1.749, 1.233},         /* deep pixel */
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
