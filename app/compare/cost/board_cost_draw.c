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
	{3.353e+04, 2.111e+04}, /* frame */
	{0.7595, 0.3395},       /* pixel */
	{1.736e+04, 6565},      /* call */
	{112.4, 59.59},         /* listed */
	{345.7, 74.23},         /* vertex */
	{150.9, 77.25},         /* again */
	{343.1, 159},           /* single */
	{222.9, 213.3},         /* shaded */
	{9.9, 11.35},           /* hidden */
	{1202, 461.1},          /* skipped */
	{4.11, 3.08},           /* fine */
	{227, 109},             /* flat triangle */
	{85.45, 57.25},         /* flat row */
	{16.96, 12.33},         /* flat pixel */
	{612.5, 187.7},         /* plain triangle */
	{20.32, 21.4},          /* plain row */
	{14.67, 6.262},         /* plain pixel */
	{747.7, 545.4},         /* textured triangle */
	{110.8, 0},             /* textured row */
	{100.6, 67.05},         /* textured pixel */
	{3.256e+04, 9453},      /* backdrop triangle */
	{70.87, 26.98},         /* backdrop row */
	{1.477, 0.5064},        /* backdrop pixel */
	{3.783e+04, 1.111e+04}, /* ground triangle */
	{123.9, 49.61},         /* ground row */
	{6.086, 0.4912},        /* ground pixel */
	{457.3, 337.4},         /* spans triangle */
	{204.9, 132.4},         /* spans row */
	{22.21, 14.64},         /* spans pixel */
	{2151, 1036},           /* spans textured triangle */
	{210.5, 79.43},         /* spans textured row */
	{78.77, 52.1},          /* spans textured pixel */
	{9740, 7340},           /* spans divided triangle */
	{691.1, 359.6},         /* spans divided row */
	{93.58, 58.11},         /* spans divided pixel */
	{2976, 1161},           /* spans nearest triangle */
	{311.4, 145.2},         /* spans nearest row */
	{39.13, 27.54},         /* spans nearest pixel */
	{2853, 1788},           /* mixed triangle */
	{203.8, 108.1},         /* mixed row */
	{49.63, 32.24},         /* mixed pixel */
	{3308, 1321},           /* tested triangle */
	{259.4, 157.1},         /* tested row */
	{126.3, 84.05},         /* tested pixel */
	{3761, 2464},           /* tested spans triangle */
	{415.2, 254.4},         /* tested spans row */
	{123.2, 78.26},         /* tested spans pixel */
	{4053, 1426},           /* mixed textured triangle */
	{287.2, 166.6},         /* mixed textured row */
	{131.2, 85.5},          /* mixed textured pixel */
	{3689, 2570},           /* mixed spans triangle */
	{151.5, 124},           /* mixed spans row */
	{152.6, 81.49},         /* mixed spans pixel */
	{5079, 4088},           /* mixed divided triangle */
	{1152, 597},            /* mixed divided row */
	{132.8, 85.73},         /* mixed divided pixel */
	{299, 123.5},           /* colored triangle */
	{0, 0},                 /* colored row */
	{3.39, 1.463},          /* colored pixel */
	{2580, 1316},           /* bent triangle */
	{352.8, 200.9},         /* bent row */
	{4.046, 2.734},         /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.002, 0.9976},        /* deep row */
	{1.859, 1.319},         /* deep pixel */
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
