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
	{3.144e+04, 2.188e+04}, /* frame */
	{0.7688, 0.3728},       /* pixel */
	{1.672e+04, 5683},      /* call */
	{207.4, 97.46},         /* listed */
	{326.5, 60.67},         /* vertex */
	{311.1, 133.9},         /* single */
	{237, 247.4},           /* shaded */
	{16.37, 14.69},         /* hidden */
	{5.059, 2.488},         /* fine */
	{165.4, 57.28},         /* flat triangle */
	{79.21, 44.04},         /* flat row */
	{12.86, 8.67},          /* flat pixel */
	{545.1, 172.9},         /* plain triangle */
	{0, 16.48},             /* plain row */
	{18.75, 5.799},         /* plain pixel */
	{387.1, 379.9},         /* textured triangle */
	{270.7, 62.76},         /* textured row */
	{65.85, 54.33},         /* textured pixel */
	{3.233e+04, 1.133e+04}, /* backdrop triangle */
	{66.53, 28.24},         /* backdrop row */
	{2.646, 0.8395},        /* backdrop pixel */
	{3.288e+04, 1.188e+04}, /* ground triangle */
	{112.3, 51.67},         /* ground row */
	{3.228, 0.8543},        /* ground pixel */
	{1354, 817},            /* spans triangle */
	{138, 92.77},           /* spans row */
	{21.73, 14.7},          /* spans pixel */
	{3107, 1692},           /* spans textured triangle */
	{181.1, 104.1},         /* spans textured row */
	{107.1, 65.15},         /* spans textured pixel */
	{4799, 3818},           /* spans divided triangle */
	{702.3, 374.6},         /* spans divided row */
	{91.47, 55.61},         /* spans divided pixel */
	{1554, 666.2},          /* mixed triangle */
	{264.1, 148.9},         /* mixed row */
	{55.76, 38.59},         /* mixed pixel */
	{3146, 965.1},          /* tested triangle */
	{278.5, 168.2},         /* tested row */
	{170, 112.7},           /* tested pixel */
	{4039, 2530},           /* tested spans triangle */
	{616.5, 379.2},         /* tested spans row */
	{138, 86.81},           /* tested spans pixel */
	{3180, 1430},           /* mixed textured triangle */
	{252.6, 178.1},         /* mixed textured row */
	{143.3, 83.6},          /* mixed textured pixel */
	{3907, 3035},           /* mixed spans triangle */
	{469.6, 311.3},         /* mixed spans row */
	{142.9, 82.47},         /* mixed spans pixel */
	{5186, 4193},           /* mixed divided triangle */
	{2229, 1117},           /* mixed divided row */
	{124.4, 82.06},         /* mixed divided pixel */
	{140.4, 40.74},         /* colored triangle */
	{0, 0},                 /* colored row */
	{8.302, 3.546},         /* colored pixel */
	{2545, 1202},           /* bent triangle */
	{277.6, 146.6},         /* bent row */
	{3.36, 2.222},          /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.001, 0.9979},        /* deep row */
	{1.699, 1.231},         /* deep pixel */
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
