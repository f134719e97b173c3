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
	{3.448e+04, 2.155e+04}, /* frame */
	{0.6578, 0.2476},       /* pixel */
	{1.922e+04, 7017},      /* call */
	{84.69, 49.2},          /* listed */
	{336.7, 75.62},         /* vertex */
	{150.9, 77.25},         /* again */
	{336.7, 155.5},         /* single */
	{272.8, 242.3},         /* shaded */
	{14.04, 14.4},          /* hidden */
	{1293, 493.8},          /* skipped */
	{3.729, 2.787},         /* fine */
	{169.1, 75.82},         /* flat triangle */
	{78.14, 46.34},         /* flat row */
	{15.71, 11.58},         /* flat pixel */
	{580.2, 211.8},         /* plain triangle */
	{36.78, 27.04},         /* plain row */
	{11.04, 4.958},         /* plain pixel */
	{741.4, 524.5},         /* textured triangle */
	{116.2, 0},             /* textured row */
	{98.12, 66.53},         /* textured pixel */
	{3.309e+04, 8068},      /* backdrop triangle */
	{69.27, 24.88},         /* backdrop row */
	{0, 0},                 /* backdrop pixel */
	{4.007e+04, 1.155e+04}, /* ground triangle */
	{129.5, 54.49},         /* ground row */
	{8.516, 1.326},         /* ground pixel */
	{633.4, 271.3},         /* spans triangle */
	{203.9, 134.7},         /* spans row */
	{21.82, 14.47},         /* spans pixel */
	{1563, 356.1},          /* spans textured triangle */
	{164.3, 40.72},         /* spans textured row */
	{78.19, 52.46},         /* spans textured pixel */
	{6559, 4096},           /* spans divided triangle */
	{643.8, 365.1},         /* spans divided row */
	{94.19, 58.17},         /* spans divided pixel */
	{3121, 1178},           /* spans nearest triangle */
	{321.5, 146.8},         /* spans nearest row */
	{37.93, 27.51},         /* spans nearest pixel */
	{3193, 1880},           /* mixed triangle */
	{210.6, 114.9},         /* mixed row */
	{49.5, 32.26},          /* mixed pixel */
	{3600, 1373},           /* tested triangle */
	{276.5, 158.8},         /* tested row */
	{126, 84.38},           /* tested pixel */
	{3660, 2412},           /* tested spans triangle */
	{393.9, 248.7},         /* tested spans row */
	{135.3, 83.62},         /* tested spans pixel */
	{3390, 1053},           /* mixed textured triangle */
	{241.6, 114.7},         /* mixed textured row */
	{144.2, 97.9},          /* mixed textured pixel */
	{3313, 2157},           /* mixed spans triangle */
	{237.9, 161},           /* mixed spans row */
	{151.7, 84.16},         /* mixed spans pixel */
	{5096, 4104},           /* mixed divided triangle */
	{1139, 603.4},          /* mixed divided row */
	{134.1, 86.23},         /* mixed divided pixel */
	{261.6, 96.29},         /* colored triangle */
	{0, 0},                 /* colored row */
	{3.476, 1.384},         /* colored pixel */
	{2749, 1367},           /* bent triangle */
	{388.5, 227.9},         /* bent row */
	{3.959, 2.701},         /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.003, 0.9994},        /* deep row */
	{2.128, 1.73},          /* deep pixel */
	{671.1, 360.2},         /* second triangle */
	{166, 83.03},           /* second row */
	{46.08, 23.51},         /* second pixel */
	{315.8, 211.9},         /* crossed triangle */
	{186.8, 120.2},         /* crossed row */
	{3.289, 2.669},         /* crossed pixel */
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
