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
	DRAW_SHADED,
	DRAW_HIDDEN,
	DRAW_TRIANGLE, /* of each kind: its triangles, rows and pixels */
	DRAW_WORKS = DRAW_TRIANGLE + 3 * GL_WORK_KINDS
};

/* Cycles and instructions of each, which `make bench-draw-fit` writes. */
static const struct board_cost each[DRAW_WORKS] = {
	{2.55e+04, 2.214e+04},  /* frame */
	{0.9813, 0.9773},       /* pixel */
	{1.78e+04, 8232},       /* call */
	{208.4, 125.3},         /* listed */
	{0, 0},                 /* vertex */
	{862.4, 141.7},         /* shaded */
	{7.582, 0},             /* hidden */
	{269, 9.863},           /* flat triangle */
	{0, 0},                 /* flat row */
	{9.586, 25.55},         /* flat pixel */
	{754.6, 582.7},         /* plain triangle */
	{0, 7.375},             /* plain row */
	{17.98, 2.346},         /* plain pixel */
	{1241, 638.2},          /* textured triangle */
	{155.6, 78.09},         /* textured row */
	{100.9, 66.78},         /* textured pixel */
	{6.401e+04, 4.141e+04}, /* ground triangle */
	{127.2, 0},             /* ground row */
	{6.708, 2.963},         /* ground pixel */
	{1401, 451.7},          /* spans triangle */
	{158.8, 105.2},         /* spans row */
	{28.77, 14.95},         /* spans pixel */
	{4667, 2964},           /* spans textured triangle */
	{326.1, 86.97},         /* spans textured row */
	{79.72, 52.28},         /* spans textured pixel */
	{4387, 4660},           /* spans divided triangle */
	{955, 543.1},           /* spans divided row */
	{115.1, 66.52},         /* spans divided pixel */
	{2313, 1831},           /* mixed triangle */
	{137.5, 34.89},         /* mixed row */
	{66.29, 40.65},         /* mixed pixel */
	{1327, 0},              /* mixed textured triangle */
	{594.5, 420.4},         /* mixed textured row */
	{146.9, 92.95},         /* mixed textured pixel */
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
	add_work(&sum, DRAW_SHADED, counts->shaded);
	add_work(&sum, DRAW_HIDDEN, counts->hidden);
	for (int i = 0; i < GL_WORK_KINDS; i++) {
		const struct gl_work *work = &counts->work[i];

		add_work(&sum, DRAW_TRIANGLE + 3 * i, work->triangles);
		add_work(&sum, DRAW_TRIANGLE + 3 * i + 1, work->rows);
		add_work(&sum, DRAW_TRIANGLE + 3 * i + 2, work->pixels);
	}
	return sum;
}
