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
	{3.317e+04, 2.145e+04}, /* frame */
	{0.3735, 0.06395},      /* pixel */
	{1.946e+04, 6681},      /* call */
	{73.02, 56.22},         /* listed */
	{347.3, 92.09},         /* vertex */
	{126.3, 78.6},          /* again */
	{355.6, 167.1},         /* single */
	{336.6, 255},           /* shaded */
	{14.76, 15.19},         /* hidden */
	{1496, 593.6},          /* skipped */
	{3.668, 3.045},         /* fine */
	{170.8, 65.73},         /* flat triangle */
	{78.21, 43.18},         /* flat row */
	{18.19, 13.1},          /* flat pixel */
	{676.9, 206.1},         /* plain triangle */
	{24.18, 22.32},         /* plain row */
	{9.579, 4.236},         /* plain pixel */
	{751.9, 583.2},         /* textured triangle */
	{137, 0.6196},          /* textured row */
	{78.88, 58.27},         /* textured pixel */
	{2.712e+04, 6237},      /* backdrop triangle */
	{63.39, 20.77},         /* backdrop row */
	{0, 0},                 /* backdrop pixel */
	{3.698e+04, 1.145e+04}, /* ground triangle */
	{137.5, 58.89},         /* ground row */
	{8.875, 1.051},         /* ground pixel */
	{149.1, 94.05},         /* spans triangle */
	{205.7, 129.3},         /* spans row */
	{20.53, 13.92},         /* spans pixel */
	{1847, 8.571},          /* spans textured triangle */
	{308.6, 154.5},         /* spans textured row */
	{71.27, 46.73},         /* spans textured pixel */
	{7542, 5290},           /* spans divided triangle */
	{673.5, 384.5},         /* spans divided row */
	{89.48, 54.34},         /* spans divided pixel */
	{3084, 1160},           /* spans nearest triangle */
	{308.9, 139.6},         /* spans nearest row */
	{35.04, 26.2},          /* spans nearest pixel */
	{3195, 1838},           /* mixed triangle */
	{213.3, 116.5},         /* mixed row */
	{47.39, 30.92},         /* mixed pixel */
	{3363, 1202},           /* tested triangle */
	{228.8, 145},           /* tested row */
	{134.4, 88.81},         /* tested pixel */
	{3094, 1873},           /* tested spans triangle */
	{323.7, 191.5},         /* tested spans row */
	{133.2, 81.51},         /* tested spans pixel */
	{3112, 843.5},          /* mixed textured triangle */
	{249.2, 120.4},         /* mixed textured row */
	{212.8, 144},           /* mixed textured pixel */
	{3703, 2602},           /* mixed spans triangle */
	{283.7, 166.4},         /* mixed spans row */
	{180.5, 106.5},         /* mixed spans pixel */
	{5058, 4066},           /* mixed divided triangle */
	{1331, 701},            /* mixed divided row */
	{151.7, 101.2},         /* mixed divided pixel */
	{225.2, 58.15},         /* colored triangle */
	{0, 4.708},             /* colored row */
	{4.411, 1.707},         /* colored pixel */
	{2808, 1481},           /* bent triangle */
	{319.6, 191.5},         /* bent row */
	{3.801, 2.702},         /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.004, 1.002},         /* deep row */
	{2.553, 2.378},         /* deep pixel */
	{671.2, 365.5},         /* second triangle */
	{169.5, 87.4},          /* second row */
	{48.55, 25.65},         /* second pixel */
	{320, 210.6},           /* crossed triangle */
	{199.5, 105.7},         /* crossed row */
	{4.189, 3.833},         /* crossed pixel */
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
