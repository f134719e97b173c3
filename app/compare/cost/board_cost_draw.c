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
	{3.681e+04, 3.245e+04}, /* frame */
	{0.7863, 0.381},        /* pixel */
	{1.778e+04, 7761},      /* call */
	{213.3, 105.4},         /* listed */
	{93.58, 40.48},         /* vertex */
	{178.8, 122.8},         /* single */
	{727, 182.1},           /* shaded */
	{10.56, 9.517},         /* hidden */
	{3.89, 3.105},          /* fine */
	{197.3, 79.27},         /* flat triangle */
	{53.24, 34.48},         /* flat row */
	{10.35, 6.799},         /* flat pixel */
	{530.5, 349.2},         /* plain triangle */
	{0.1704, 13.4},         /* plain row */
	{28.38, 10.35},         /* plain pixel */
	{721.8, 308.4},         /* textured triangle */
	{337.9, 168.4},         /* textured row */
	{78.96, 56.49},         /* textured pixel */
	{4.559e+04, 2.245e+04}, /* backdrop triangle */
	{75.4, 36.87},          /* backdrop row */
	{2.872, 0.9206},        /* backdrop pixel */
	{4.559e+04, 2.245e+04}, /* ground triangle */
	{140.1, 85.98},         /* ground row */
	{8.707, 4.319},         /* ground pixel */
	{1186, 728},            /* spans triangle */
	{168.1, 103.5},         /* spans row */
	{30.09, 18.96},         /* spans pixel */
	{3198, 2294},           /* spans textured triangle */
	{525.4, 307.3},         /* spans textured row */
	{73.02, 37.69},         /* spans textured pixel */
	{4668, 3732},           /* spans divided triangle */
	{968.7, 547.4},         /* spans divided row */
	{106.2, 68.05},         /* spans divided pixel */
	{2628, 1588},           /* mixed triangle */
	{151.9, 76.56},         /* mixed row */
	{67.91, 42.79},         /* mixed pixel */
	{3130, 1230},           /* tested triangle */
	{251.2, 162.6},         /* tested row */
	{141.7, 100.7},         /* tested pixel */
	{3817, 2136},           /* tested spans triangle */
	{611.6, 347.6},         /* tested spans row */
	{184.7, 120.9},         /* tested spans pixel */
	{3000, 1500},           /* mixed textured triangle */
	{250, 190},             /* mixed textured row */
	{150, 97},              /* mixed textured pixel */
	{3633, 2336},           /* mixed spans triangle */
	{321.1, 184.2},         /* mixed spans row */
	{140.1, 91.77},         /* mixed spans pixel */
	{5136, 4154},           /* mixed divided triangle */
	{1890, 988.3},          /* mixed divided row */
	{137.8, 91.35},         /* mixed divided pixel */
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
