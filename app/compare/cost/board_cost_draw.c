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
	{3.328e+04, 2.577e+04}, /* frame */
	{0.7265, 0.3586},       /* pixel */
	{1.773e+04, 6983},      /* call */
	{168.6, 88.03},         /* listed */
	{169.9, 78.07},         /* vertex */
	{221.5, 135},           /* single */
	{824.2, 222.9},         /* shaded */
	{11.63, 10.36},         /* hidden */
	{8.899, 6.151},         /* fine */
	{193.3, 68.38},         /* flat triangle */
	{65.11, 39.21},         /* flat row */
	{11.66, 7.701},         /* flat pixel */
	{432.1, 255.5},         /* plain triangle */
	{7.839, 23.32},         /* plain row */
	{26.82, 10.57},         /* plain pixel */
	{658.5, 324.9},         /* textured triangle */
	{306.2, 151.2},         /* textured row */
	{79.82, 55.1},          /* textured pixel */
	{3.674e+04, 1.539e+04}, /* backdrop triangle */
	{71.02, 33.24},         /* backdrop row */
	{2.226, 0.7859},        /* backdrop pixel */
	{3.723e+04, 1.577e+04}, /* ground triangle */
	{127.8, 71.48},         /* ground row */
	{4.068, 0.8852},        /* ground pixel */
	{988.9, 588.1},         /* spans triangle */
	{152.2, 96.97},         /* spans row */
	{31.24, 19.7},          /* spans pixel */
	{2696, 1442},           /* spans textured triangle */
	{287.6, 145.9},         /* spans textured row */
	{104, 67.32},           /* spans textured pixel */
	{4731, 3775},           /* spans divided triangle */
	{644.3, 343.3},         /* spans divided row */
	{103.3, 66.93},         /* spans divided pixel */
	{1927, 1129},           /* mixed triangle */
	{257, 136.6},           /* mixed row */
	{62.79, 42.2},          /* mixed pixel */
	{3082, 1018},           /* tested triangle */
	{274, 173.7},           /* tested row */
	{182.6, 124},           /* tested pixel */
	{4037, 2554},           /* tested spans triangle */
	{605.3, 382},           /* tested spans row */
	{147.8, 95.2},          /* tested spans pixel */
	{3257, 1463},           /* mixed textured triangle */
	{255.5, 184.1},         /* mixed textured row */
	{146, 90.68},           /* mixed textured pixel */
	{3861, 3022},           /* mixed spans triangle */
	{453.1, 306.8},         /* mixed spans row */
	{159.1, 90.85},         /* mixed spans pixel */
	{5186, 4184},           /* mixed divided triangle */
	{2320, 1128},           /* mixed divided row */
	{134, 89.64},           /* mixed divided pixel */
	{151.8, 41.53},         /* colored triangle */
	{0, 0},                 /* colored row */
	{6.965, 3.169},         /* colored pixel */
	{2184, 1170},           /* bent triangle */
	{253.6, 147.3},         /* bent row */
	{3.432, 2.283},         /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.002, 1.003},         /* deep row */
	{1.803, 1.287},         /* deep pixel */
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
