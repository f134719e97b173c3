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
	{3.2e+04, 2.181e+04},   /* frame */
	{0.7941, 0.3658},       /* pixel */
	{1.616e+04, 5544},      /* call */
	{157.9, 80.91},         /* listed */
	{332.1, 69.85},         /* vertex */
	{309, 140.6},           /* single */
	{274.6, 226.2},         /* shaded */
	{13.74, 13.68},         /* hidden */
	{1244, 486.4},          /* skipped */
	{5.391, 3.343},         /* fine */
	{213, 67.64},           /* flat triangle */
	{68.04, 36.35},         /* flat row */
	{11.22, 8.099},         /* flat pixel */
	{486.5, 193.9},         /* plain triangle */
	{8.387, 14.88},         /* plain row */
	{20.19, 8.204},         /* plain pixel */
	{601.5, 414.5},         /* textured triangle */
	{202.3, 50.2},          /* textured row */
	{78.76, 57.66},         /* textured pixel */
	{3.296e+04, 1.103e+04}, /* backdrop triangle */
	{69.21, 28.25},         /* backdrop row */
	{2.813, 0.8033},        /* backdrop pixel */
	{3.421e+04, 1.181e+04}, /* ground triangle */
	{116.9, 51.12},         /* ground row */
	{2.974, 0},             /* ground pixel */
	{1115, 604.4},          /* spans triangle */
	{206.9, 133.3},         /* spans row */
	{22.11, 14.71},         /* spans pixel */
	{2100, 1002},           /* spans textured triangle */
	{111.9, 50.99},         /* spans textured row */
	{116.3, 71.2},          /* spans textured pixel */
	{4717, 3835},           /* spans divided triangle */
	{711.9, 364.5},         /* spans divided row */
	{93.1, 57.81},          /* spans divided pixel */
	{2225, 1276},           /* mixed triangle */
	{208.2, 113.2},         /* mixed row */
	{49.63, 32.63},         /* mixed pixel */
	{3379, 1136},           /* tested triangle */
	{279.7, 177.2},         /* tested row */
	{153.4, 103.2},         /* tested pixel */
	{3932, 2497},           /* tested spans triangle */
	{508.1, 304.5},         /* tested spans row */
	{135.7, 85.04},         /* tested spans pixel */
	{3365, 1469},           /* mixed textured triangle */
	{254.3, 179.7},         /* mixed textured row */
	{132.9, 81.83},         /* mixed textured pixel */
	{3633, 2850},           /* mixed spans triangle */
	{363.2, 248.6},         /* mixed spans row */
	{130.5, 71.22},         /* mixed spans pixel */
	{5155, 4145},           /* mixed divided triangle */
	{1994, 963.4},          /* mixed divided row */
	{123.5, 81.41},         /* mixed divided pixel */
	{212.2, 83.78},         /* colored triangle */
	{0, 0},                 /* colored row */
	{6.665, 2.53},          /* colored pixel */
	{2211, 1071},           /* bent triangle */
	{292.9, 160.9},         /* bent row */
	{3.53, 2.312},          /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.001, 0.9977},        /* deep row */
	{1.65, 1.025},          /* deep pixel */
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
