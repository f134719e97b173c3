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
	{2.529e+04, 2.218e+04}, /* frame */
	{0.9446, 0.9984},       /* pixel */
	{1.751e+04, 8221},      /* call */
	{207.5, 123.2},         /* listed */
	{0, 0},                 /* vertex */
	{896.6, 130.4},         /* shaded */
	{4.735, 0},             /* hidden */
	{285, 0},               /* flat triangle */
	{7.904, 0},             /* flat row */
	{10.8, 23.51},          /* flat pixel */
	{698, 549},             /* plain triangle */
	{0, 16.41},             /* plain row */
	{18.85, 1.294},         /* plain pixel */
	{1236, 663.7},          /* textured triangle */
	{158, 68.99},           /* textured row */
	{92.39, 69.02},         /* textured pixel */
	{6.231e+04, 4.182e+04}, /* ground triangle */
	{108.5, 0},             /* ground row */
	{6.728, 2.936},         /* ground pixel */
	{1279, 482.5},          /* spans triangle */
	{166.5, 106.7},         /* spans row */
	{28.19, 15.47},         /* spans pixel */
	{4298, 2928},           /* spans textured triangle */
	{335.3, 111.1},         /* spans textured row */
	{86.69, 54.79},         /* spans textured pixel */
	{4322, 4743},           /* spans divided triangle */
	{908.1, 535},           /* spans divided row */
	{115.3, 67.18},         /* spans divided pixel */
	{2221, 1969},           /* mixed triangle */
	{157, 20.23},           /* mixed row */
	{64.95, 42.29},         /* mixed pixel */
	{374, 0},               /* mixed textured triangle */
	{908.1, 582.6},         /* mixed textured row */
	{141.7, 92.07},         /* mixed textured pixel */
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
