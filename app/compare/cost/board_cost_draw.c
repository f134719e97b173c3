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
	{3.176e+04, 2.183e+04}, /* frame */
	{0.7934, 0.3695},       /* pixel */
	{1.6e+04, 5574},        /* call */
	{162.9, 80.17},         /* listed */
	{346.8, 66.72},         /* vertex */
	{310.3, 132.3},         /* single */
	{237.7, 235},           /* shaded */
	{15.56, 14.56},         /* hidden */
	{1181, 435.2},          /* skipped */
	{4.797, 3.191},         /* fine */
	{217.5, 85.67},         /* flat triangle */
	{71.82, 39.16},         /* flat row */
	{11.24, 7.987},         /* flat pixel */
	{537.5, 184.2},         /* plain triangle */
	{5.385, 15.18},         /* plain row */
	{17.5, 6.932},          /* plain pixel */
	{554.6, 442},           /* textured triangle */
	{213.3, 43.04},         /* textured row */
	{71.35, 56.3},          /* textured pixel */
	{3.312e+04, 1.13e+04},  /* backdrop triangle */
	{69.65, 29},            /* backdrop row */
	{2.904, 0.8308},        /* backdrop pixel */
	{3.364e+04, 1.183e+04}, /* ground triangle */
	{117.6, 53.64},         /* ground row */
	{3.318, 0},             /* ground pixel */
	{1420, 764.9},          /* spans triangle */
	{137.6, 94.19},         /* spans row */
	{21.89, 14.75},         /* spans pixel */
	{2926, 1568},           /* spans textured triangle */
	{217.8, 116.3},         /* spans textured row */
	{106.8, 65.11},         /* spans textured pixel */
	{4776, 3808},           /* spans divided triangle */
	{717.5, 381.6},         /* spans divided row */
	{91.27, 55.58},         /* spans divided pixel */
	{1298, 527.3},          /* mixed triangle */
	{225, 127},             /* mixed row */
	{51.42, 34.64},         /* mixed pixel */
	{2738, 847.7},          /* tested triangle */
	{264.2, 161},           /* tested row */
	{164.2, 112.5},         /* tested pixel */
	{3943, 2479},           /* tested spans triangle */
	{578.1, 356.8},         /* tested spans row */
	{136.8, 87.52},         /* tested spans pixel */
	{3096, 1407},           /* mixed textured triangle */
	{241.1, 170.1},         /* mixed textured row */
	{121.8, 72.52},         /* mixed textured pixel */
	{3820, 2954},           /* mixed spans triangle */
	{435, 288.8},           /* mixed spans row */
	{135.8, 76.85},         /* mixed spans pixel */
	{5145, 4150},           /* mixed divided triangle */
	{1945, 977.6},          /* mixed divided row */
	{121.8, 80.13},         /* mixed divided pixel */
	{206, 75.85},           /* colored triangle */
	{0, 0},                 /* colored row */
	{8.095, 3.08},          /* colored pixel */
	{2472, 1178},           /* bent triangle */
	{270.4, 143.5},         /* bent row */
	{3.405, 2.252},         /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.001, 0.9983},        /* deep row */
	{1.668, 1.101},         /* deep pixel */
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
