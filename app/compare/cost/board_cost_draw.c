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
	{3.948e+04, 2.088e+04}, /* frame */
	{0.7657, 0},            /* pixel */
	{1.872e+04, 6470},      /* call */
	{81.83, 49.7},          /* listed */
	{393.2, 105.5},         /* vertex */
	{163.7, 91.93},         /* again */
	{292.8, 115.1},         /* single */
	{288.9, 251.2},         /* shaded */
	{13.08, 15.93},         /* hidden */
	{1488, 576.5},          /* skipped */
	{5.65, 2.527},          /* fine */
	{194.4, 96.33},         /* flat triangle */
	{78.68, 49.6},          /* flat row */
	{23.28, 14.18},         /* flat pixel */
	{662.1, 230.5},         /* plain triangle */
	{18.12, 15.59},         /* plain row */
	{9.419, 3.526},         /* plain pixel */
	{694.3, 580.7},         /* textured triangle */
	{155.5, 0},             /* textured row */
	{78.73, 57.65},         /* textured pixel */
	{2.199e+04, 8513},      /* backdrop triangle */
	{67.97, 15.92},         /* backdrop row */
	{1.4, 0},               /* backdrop pixel */
	{5.191e+04, 1.088e+04}, /* ground triangle */
	{151.5, 30.03},         /* ground row */
	{4.643, 1.337},         /* ground pixel */
	{842.3, 467.7},         /* spans triangle */
	{230.7, 144.7},         /* spans row */
	{20.06, 13.34},         /* spans pixel */
	{1582, 0},              /* spans textured triangle */
	{331.6, 172.3},         /* spans textured row */
	{70.71, 45.67},         /* spans textured pixel */
	{7088, 5012},           /* spans divided triangle */
	{722.1, 387.7},         /* spans divided row */
	{88.61, 54.44},         /* spans divided pixel */
	{2923, 1183},           /* spans nearest triangle */
	{302.8, 149.1},         /* spans nearest row */
	{38.94, 25.51},         /* spans nearest pixel */
	{2958, 1879},           /* mixed triangle */
	{229.2, 119.1},         /* mixed row */
	{46.89, 31.06},         /* mixed pixel */
	{3314, 1278},           /* tested triangle */
	{239.5, 162.9},         /* tested row */
	{136.3, 86.39},         /* tested pixel */
	{3065, 1852},           /* tested spans triangle */
	{305.4, 195.8},         /* tested spans row */
	{136.8, 82.22},         /* tested spans pixel */
	{3149, 920.5},          /* mixed textured triangle */
	{252.5, 142.2},         /* mixed textured row */
	{211.3, 139.2},         /* mixed textured pixel */
	{3635, 2596},           /* mixed spans triangle */
	{372.4, 232.4},         /* mixed spans row */
	{177.2, 104.1},         /* mixed spans pixel */
	{5047, 4065},           /* mixed divided triangle */
	{1402, 754.1},          /* mixed divided row */
	{150, 100.6},           /* mixed divided pixel */
	{174.7, 21.97},         /* colored triangle */
	{20.66, 20.22},         /* colored row */
	{1.582, 0},             /* colored pixel */
	{2848, 1523},           /* bent triangle */
	{332.5, 195.9},         /* bent row */
	{3.747, 2.603},         /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.005, 0.9941},        /* deep row */
	{1.777, 2.584},         /* deep pixel */
	{708.4, 395.4},         /* second triangle */
	{173.6, 91.49},         /* second row */
	{52.55, 26.75},         /* second pixel */
	{316.1, 206},           /* crossed triangle */
	{249, 128.7},           /* crossed row */
	{4.016, 3.575},         /* crossed pixel */
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
