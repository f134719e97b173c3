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
	{3.329e+04, 2.188e+04}, /* frame */
	{0.6, 0.2097},          /* pixel */
	{1.91e+04, 6614},       /* call */
	{92.85, 48.54},         /* listed */
	{347.3, 87.61},         /* vertex */
	{122.2, 76.42},         /* again */
	{329.4, 157.1},         /* single */
	{305.9, 249.6},         /* shaded */
	{15.73, 16.65},         /* hidden */
	{1309, 486.6},          /* skipped */
	{4.078, 2.769},         /* fine */
	{195.7, 105},           /* flat triangle */
	{78.23, 44.87},         /* flat row */
	{15.81, 11.92},         /* flat pixel */
	{594.3, 218.4},         /* plain triangle */
	{27.16, 22.72},         /* plain row */
	{9.979, 4.526},         /* plain pixel */
	{717.3, 485.5},         /* textured triangle */
	{93.64, 0},             /* textured row */
	{100.2, 65.4},          /* textured pixel */
	{3.014e+04, 8322},      /* backdrop triangle */
	{66.24, 24.07},         /* backdrop row */
	{0, 0},                 /* backdrop pixel */
	{3.726e+04, 1.188e+04}, /* ground triangle */
	{127.3, 55.4},          /* ground row */
	{8.235, 1.315},         /* ground pixel */
	{425.9, 171.3},         /* spans triangle */
	{206.2, 134.3},         /* spans row */
	{22.19, 14.24},         /* spans pixel */
	{1252, 0},              /* spans textured triangle */
	{312.2, 165.5},         /* spans textured row */
	{72.52, 47.16},         /* spans textured pixel */
	{6773, 4621},           /* spans divided triangle */
	{676.9, 390.2},         /* spans divided row */
	{92.39, 55.67},         /* spans divided pixel */
	{3097, 1176},           /* spans nearest triangle */
	{317.7, 144.4},         /* spans nearest row */
	{37.42, 26.93},         /* spans nearest pixel */
	{3290, 1895},           /* mixed triangle */
	{204.4, 112.1},         /* mixed row */
	{49.83, 31.92},         /* mixed pixel */
	{3687, 1305},           /* tested triangle */
	{253.4, 158.9},         /* tested row */
	{121.5, 81.58},         /* tested pixel */
	{3512, 2078},           /* tested spans triangle */
	{411.7, 229},           /* tested spans row */
	{133.2, 81.96},         /* tested spans pixel */
	{4059, 1136},           /* mixed textured triangle */
	{279.2, 145.8},         /* mixed textured row */
	{192.8, 132.1},         /* mixed textured pixel */
	{3708, 2501},           /* mixed spans triangle */
	{314.2, 190.4},         /* mixed spans row */
	{186.2, 109.8},         /* mixed spans pixel */
	{5094, 4093},           /* mixed divided triangle */
	{1385, 711.7},          /* mixed divided row */
	{151.2, 100.2},         /* mixed divided pixel */
	{261.9, 77.38},         /* colored triangle */
	{0.1189, 0},            /* colored row */
	{4.826, 1.967},         /* colored pixel */
	{3119, 1599},           /* bent triangle */
	{372.6, 214.8},         /* bent row */
	{3.928, 2.721},         /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.003, 0.9999},        /* deep row */
	{2.196, 1.868},         /* deep pixel */
	{671.1, 368.1},         /* second triangle */
	{165.5, 84.64},         /* second row */
	{45.7, 23.25},          /* second pixel */
	{319.3, 210.3},         /* crossed triangle */
	{176.5, 92.2},          /* crossed row */
	{3.598, 3.135},         /* crossed pixel */
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
