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
	{3.95e+04, 2.122e+04},  /* frame */
	{0.8121, 0},            /* pixel */
	{1.863e+04, 6478},      /* call */
	{89.74, 49.29},         /* listed */
	{396.2, 105.7},         /* vertex */
	{162.5, 92.61},         /* again */
	{293.4, 115.1},         /* single */
	{283.4, 251.5},         /* shaded */
	{13.06, 16.01},         /* hidden */
	{1475, 576.4},          /* skipped */
	{5.544, 2.474},         /* fine */
	{180.3, 97.97},         /* flat triangle */
	{84.93, 47.61},         /* flat row */
	{23.27, 14.31},         /* flat pixel */
	{643.6, 227.3},         /* plain triangle */
	{24.82, 15.47},         /* plain row */
	{8.892, 3.539},         /* plain pixel */
	{701.4, 577.8},         /* textured triangle */
	{158.7, 0},             /* textured row */
	{78.33, 57.68},         /* textured pixel */
	{1.922e+04, 9051},      /* backdrop triangle */
	{68.35, 15.39},         /* backdrop row */
	{1.264, 0},             /* backdrop pixel */
	{5.195e+04, 1.122e+04}, /* ground triangle */
	{153, 28.36},           /* ground row */
	{4.741, 1.322},         /* ground pixel */
	{877.8, 484.4},         /* spans triangle */
	{223.4, 144.4},         /* spans row */
	{20.54, 13.33},         /* spans pixel */
	{1627, 0},              /* spans textured triangle */
	{335.2, 171.8},         /* spans textured row */
	{70.69, 45.69},         /* spans textured pixel */
	{7112, 5000},           /* spans divided triangle */
	{725.5, 387.5},         /* spans divided row */
	{88.73, 54.44},         /* spans divided pixel */
	{2943, 1177},           /* spans nearest triangle */
	{303.9, 149},           /* spans nearest row */
	{38.73, 25.6},          /* spans nearest pixel */
	{2232, 1422},           /* mixed triangle */
	{131.3, 46.01},         /* mixed row */
	{43.82, 25.51},         /* mixed pixel */
	{3331, 1273},           /* tested triangle */
	{240.3, 162.9},         /* tested row */
	{136.1, 86.41},         /* tested pixel */
	{3067, 1851},           /* tested spans triangle */
	{305, 195.2},           /* tested spans row */
	{137.2, 82.24},         /* tested spans pixel */
	{5559, 1422},           /* mixed textured triangle */
	{243.4, 144.5},         /* mixed textured row */
	{170.3, 124.4},         /* mixed textured pixel */
	{2958, 2008},           /* mixed spans triangle */
	{190.3, 132.9},         /* mixed spans row */
	{180.3, 102.2},         /* mixed spans pixel */
	{4984, 4025},           /* mixed divided triangle */
	{1108, 620.3},          /* mixed divided row */
	{139.7, 92.25},         /* mixed divided pixel */
	{169.4, 24.96},         /* colored triangle */
	{16.12, 20.5},          /* colored row */
	{2.116, 0},             /* colored pixel */
	{2864, 1520},           /* bent triangle */
	{331.5, 196.3},         /* bent row */
	{3.75, 2.604},          /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.005, 0.9937},        /* deep row */
	{1.72, 2.608},          /* deep pixel */
	{708.9, 394.8},         /* second triangle */
	{173.5, 91.4},          /* second row */
	{52.45, 26.77},         /* second pixel */
	{316.4, 206},           /* crossed triangle */
	{251.6, 128.6},         /* crossed row */
	{4.005, 3.575},         /* crossed pixel */
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
