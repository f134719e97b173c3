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
	{2.444e+04, 1.992e+04}, /* frame */
	{1.013, 1.243},         /* pixel */
	{1.705e+04, 8086},      /* call */
	{169, 131.4},           /* listed */
	{0, 0},                 /* vertex */
	{902.2, 129.4},         /* shaded */
	{0.8123, 0},            /* hidden */
	{404.9, 0},             /* flat triangle */
	{1.844, 0},             /* flat row */
	{16.11, 26.33},         /* flat pixel */
	{762.6, 531.9},         /* plain triangle */
	{0, 15.53},             /* plain row */
	{18.09, 0.9767},        /* plain pixel */
	{1269, 646.1},          /* textured triangle */
	{167.4, 66.66},         /* textured row */
	{93.11, 70.33},         /* textured pixel */
	{5.746e+04, 4.133e+04}, /* ground triangle */
	{152.6, 0},             /* ground row */
	{6.649, 2.74},          /* ground pixel */
	{1801, 342.5},          /* spans triangle */
	{166.1, 107.8},         /* spans row */
	{26.86, 14.72},         /* spans pixel */
	{4188, 2400},           /* spans textured triangle */
	{408.8, 173.9},         /* spans textured row */
	{71.27, 46.48},         /* spans textured pixel */
	{3136, 2881},           /* spans divided triangle */
	{1947, 1221},           /* spans divided row */
	{101.2, 57.94},         /* spans divided pixel */
	{968.4, 766.9},         /* mixed triangle */
	{163.6, 28.86},         /* mixed row */
	{129.2, 78.8},          /* mixed pixel */
	{1973, 814.1},          /* mixed textured triangle */
	{1313, 860.4},          /* mixed textured row */
	{138, 89.9},            /* mixed textured pixel */
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
