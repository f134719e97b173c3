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
	{3.306e+04, 2.575e+04}, /* frame */
	{0.7295, 0.3591},       /* pixel */
	{1.826e+04, 7051},      /* call */
	{180.7, 88.83},         /* listed */
	{156.9, 73.75},         /* vertex */
	{195.2, 123.9},         /* single */
	{771.7, 216.5},         /* shaded */
	{12.15, 10.52},         /* hidden */
	{8.899, 6.169},         /* fine */
	{217.3, 71.48},         /* flat triangle */
	{66.08, 39.35},         /* flat row */
	{11.76, 7.765},         /* flat pixel */
	{395.4, 253.7},         /* plain triangle */
	{6.174, 23.39},         /* plain row */
	{26.59, 10.55},         /* plain pixel */
	{689.5, 329.8},         /* textured triangle */
	{310.1, 153.8},         /* textured row */
	{79.8, 54.8},           /* textured pixel */
	{3.619e+04, 1.537e+04}, /* backdrop triangle */
	{70.78, 33.23},         /* backdrop row */
	{2.233, 0.7875},        /* backdrop pixel */
	{3.672e+04, 1.575e+04}, /* ground triangle */
	{127.3, 71.41},         /* ground row */
	{4.057, 0.8627},        /* ground pixel */
	{954.5, 534.4},         /* spans triangle */
	{152.6, 97.19},         /* spans row */
	{31.24, 19.68},         /* spans pixel */
	{2641, 1443},           /* spans textured triangle */
	{264.2, 146.6},         /* spans textured row */
	{102.4, 67.77},         /* spans textured pixel */
	{4737, 3777},           /* spans divided triangle */
	{679.2, 353.8},         /* spans divided row */
	{103.4, 67.01},         /* spans divided pixel */
	{1828, 1069},           /* mixed triangle */
	{254.9, 135.8},         /* mixed row */
	{63.2, 42.28},          /* mixed pixel */
	{3112, 1032},           /* tested triangle */
	{279.1, 175},           /* tested row */
	{182.8, 123.9},         /* tested pixel */
	{4035, 2558},           /* tested spans triangle */
	{612.1, 383.7},         /* tested spans row */
	{149.6, 95.45},         /* tested spans pixel */
	{3259, 1464},           /* mixed textured triangle */
	{256.4, 184.5},         /* mixed textured row */
	{147.8, 91.27},         /* mixed textured pixel */
	{3867, 3026},           /* mixed spans triangle */
	{454.3, 307.7},         /* mixed spans row */
	{157.3, 90.9},          /* mixed spans pixel */
	{5187, 4187},           /* mixed divided triangle */
	{2329, 1136},           /* mixed divided row */
	{134.4, 89.78},         /* mixed divided pixel */
	{139.3, 38.69},         /* colored triangle */
	{0, 0},                 /* colored row */
	{6.973, 3.149},         /* colored pixel */
	{2320, 1177},           /* bent triangle */
	{271.8, 148.8},         /* bent row */
	{3.451, 2.286},         /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.002, 1.003},         /* deep row */
	{1.798, 1.283},         /* deep pixel */
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
