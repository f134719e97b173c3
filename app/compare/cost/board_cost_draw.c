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
	{3.212e+04, 2.062e+04}, /* frame */
	{0.82, 0.3603},         /* pixel */
	{1.989e+04, 7430},      /* call */
	{95.67, 49.25},         /* listed */
	{332.3, 71.64},         /* vertex */
	{309.9, 143.5},         /* single */
	{299, 239},             /* shaded */
	{12.7, 13.04},          /* hidden */
	{1235, 479.2},          /* skipped */
	{4.79, 3.43},           /* fine */
	{193.4, 87.51},         /* flat triangle */
	{69.62, 42.68},         /* flat row */
	{12.15, 9.086},         /* flat pixel */
	{619.4, 199.5},         /* plain triangle */
	{11.27, 20.09},         /* plain row */
	{17.35, 7.437},         /* plain pixel */
	{611.5, 491},           /* textured triangle */
	{161.3, 27},            /* textured row */
	{84.07, 61.29},         /* textured pixel */
	{3.332e+04, 9917},      /* backdrop triangle */
	{68.9, 26.41},          /* backdrop row */
	{3.017, 0.7728},        /* backdrop pixel */
	{3.448e+04, 1.062e+04}, /* ground triangle */
	{115.1, 45.66},         /* ground row */
	{3.108, 0},             /* ground pixel */
	{1237, 671.4},          /* spans triangle */
	{203.4, 133.1},         /* spans row */
	{21.59, 14.71},         /* spans pixel */
	{2092, 1035},           /* spans textured triangle */
	{154.4, 88.79},         /* spans textured row */
	{104.8, 63.67},         /* spans textured pixel */
	{4740, 3932},           /* spans divided triangle */
	{749.8, 370.2},         /* spans divided row */
	{92.21, 57.77},         /* spans divided pixel */
	{2092, 1035},           /* spans nearest triangle */
	{154.4, 88.79},         /* spans nearest row */
	{60, 35},               /* spans nearest pixel */
	{2284, 1389},           /* mixed triangle */
	{210.4, 116.3},         /* mixed row */
	{49.41, 32.52},         /* mixed pixel */
	{3202, 1174},           /* tested triangle */
	{281.2, 180},           /* tested row */
	{155.8, 103.7},         /* tested pixel */
	{3804, 2480},           /* tested spans triangle */
	{470, 290},             /* tested spans row */
	{137.9, 87.41},         /* tested spans pixel */
	{3290, 1458},           /* mixed textured triangle */
	{254.9, 180.2},         /* mixed textured row */
	{140.5, 84.86},         /* mixed textured pixel */
	{3653, 2820},           /* mixed spans triangle */
	{243, 181.1},           /* mixed spans row */
	{137.2, 75.11},         /* mixed spans pixel */
	{5096, 4094},           /* mixed divided triangle */
	{1156, 599.5},          /* mixed divided row */
	{132.8, 85.7},          /* mixed divided pixel */
	{251.5, 100.4},         /* colored triangle */
	{0, 0},                 /* colored row */
	{6.414, 2.423},         /* colored pixel */
	{2224, 1146},           /* bent triangle */
	{282.1, 154.3},         /* bent row */
	{3.549, 2.31},          /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.001, 0.9966},        /* deep row */
	{1.62, 0.894},          /* deep pixel */
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
