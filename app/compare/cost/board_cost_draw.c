/*
 * Predicts the cost of a picture from counts of its parts (gl_counts.h).
 */
#include "app/compare/cost/board_cost.h"

enum draw_work {
	DRAW_FRAME,
	DRAW_PIXEL, /* of the picture */
	DRAW_CALL,
	DRAW_LISTED,
	DRAW_VERTEX,
	DRAW_AGAIN,
	DRAW_SINGLE,
	DRAW_SHADED,
	DRAW_HIDDEN,
	DRAW_SKIPPED,
	DRAW_FINE,
	DRAW_TRIANGLE, /* for each kind: triangles, rows, pixels */
	DRAW_WORKS = DRAW_TRIANGLE + 3 * GL_WORK_KINDS
};

/* Cycles and instructions of each; `make bench-draw-fit` writes this table. */
static const struct board_cost each[DRAW_WORKS] = {
	{3.978e+04, 2.204e+04}, /* frame */
	{0.8401, 0.1648},       /* pixel */
	{1.709e+04, 5781},      /* call */
	{96.2, 34.71},          /* listed */
	{393.1, 121.1},         /* vertex */
	{185.6, 95.55},         /* again */
	{293.4, 90.04},         /* single */
	{347.7, 274.1},         /* shaded */
	{8.195, 12.55},         /* hidden */
	{1083, 495.5},          /* skipped */
	{5.269, 1.609},         /* fine */
	{280.4, 164.9},         /* flat triangle */
	{87.77, 45.19},         /* flat row */
	{23.65, 13.56},         /* flat pixel */
	{535, 319.7},           /* plain triangle */
	{27.56, 6.994},         /* plain row */
	{6.022, 4.024},         /* plain pixel */
	{637.4, 511.4},         /* textured triangle */
	{114.6, 0},             /* textured row */
	{80.57, 57.45},         /* textured pixel */
	{1.362e+04, 0},         /* backdrop triangle */
	{75.88, 24.25},         /* backdrop row */
	{1.68, 0.01051},        /* backdrop pixel */
	{5.263e+04, 1.204e+04}, /* ground triangle */
	{178.6, 55.63},         /* ground row */
	{5.425, 3.507},         /* ground pixel */
	{0, 0},                 /* spans triangle */
	{207.2, 149.2},         /* spans row */
	{21.1, 13.31},          /* spans pixel */
	{1456, 0},              /* spans textured triangle */
	{325.1, 193.5},         /* spans textured row */
	{71.6, 46.01},          /* spans textured pixel */
	{6913, 4347},           /* spans divided triangle */
	{714.8, 419.5},         /* spans divided row */
	{88.41, 53.89},         /* spans divided pixel */
	{2779, 1006},           /* spans nearest triangle */
	{305, 146},             /* spans nearest row */
	{37.1, 26.6},           /* spans nearest pixel */
	{2005, 1409},           /* mixed triangle */
	{84.89, 32.78},         /* mixed row */
	{46.07, 24.94},         /* mixed pixel */
	{3921, 1343},           /* tested triangle */
	{359, 240.9},           /* tested row */
	{103.8, 67.7},          /* tested pixel */
	{2495, 1601},           /* tested spans triangle */
	{225.2, 165.5},         /* tested spans row */
	{163.4, 95.37},         /* tested spans pixel */
	{4576, 1783},           /* mixed textured triangle */
	{269.5, 176.6},         /* mixed textured row */
	{175.2, 106.3},         /* mixed textured pixel */
	{3793, 2852},           /* mixed spans triangle */
	{270.8, 196.1},         /* mixed spans row */
	{142, 82.95},           /* mixed spans pixel */
	{4978, 3997},           /* mixed divided triangle */
	{1227, 668.9},          /* mixed divided row */
	{131.5, 86.45},         /* mixed divided pixel */
	{60.59, 0},             /* colored triangle */
	{44.3, 18.58},          /* colored row */
	{1.275, 0},             /* colored pixel */
	{4063, 2169},           /* bent triangle */
	{339, 169.6},           /* bent row */
	{3.143, 2.017},         /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.007, 0.9994},        /* deep row */
	{0.9081, 0.4333},       /* deep pixel */
	{653, 329.2},           /* second triangle */
	{176.3, 76.06},         /* second row */
	{62.21, 25.19},         /* second pixel */
	{323.6, 218.5},         /* crossed triangle */
	{229.1, 144.1},         /* crossed row */
	{3.649, 3.142},         /* crossed pixel */
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
	add_work(&sum, DRAW_AGAIN, counts->again);
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
