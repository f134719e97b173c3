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
	{3.346e+04, 2.704e+04}, /* frame */
	{0.7559, 0.3817},       /* pixel */
	{1.754e+04, 7370},      /* call */
	{185.4, 96.9},          /* listed */
	{130.7, 61.36},         /* vertex */
	{183.5, 122.9},         /* single */
	{748.3, 195.6},         /* shaded */
	{10.08, 9.282},         /* hidden */
	{9.289, 6.24},          /* fine */
	{203.6, 84.34},         /* flat triangle */
	{58.82, 38.21},         /* flat row */
	{10.32, 7.135},         /* flat pixel */
	{419.1, 241.3},         /* plain triangle */
	{3.915, 20.54},         /* plain row */
	{37.02, 14.32},         /* plain pixel */
	{701.2, 316.9},         /* textured triangle */
	{336.6, 168.6},         /* textured row */
	{80.69, 57.21},         /* textured pixel */
	{3.765e+04, 1.704e+04}, /* backdrop triangle */
	{74.66, 35.9},          /* backdrop row */
	{2.587, 0.9238},        /* backdrop pixel */
	{3.765e+04, 1.704e+04}, /* ground triangle */
	{135.1, 78.85},         /* ground row */
	{5.004, 1.864},         /* ground pixel */
	{1224, 836.8},          /* spans triangle */
	{164.8, 102},           /* spans row */
	{31.95, 19.47},         /* spans pixel */
	{3366, 2292},           /* spans textured triangle */
	{613.8, 328.1},         /* spans textured row */
	{74.15, 38.53},         /* spans textured pixel */
	{4655, 3718},           /* spans divided triangle */
	{646.4, 342.6},         /* spans divided row */
	{107.9, 68.88},         /* spans divided pixel */
	{2686, 1569},           /* mixed triangle */
	{156.5, 76.62},         /* mixed row */
	{70.13, 44.51},         /* mixed pixel */
	{3037, 1130},           /* tested triangle */
	{253.9, 155.8},         /* tested row */
	{143.4, 106.9},         /* tested pixel */
	{4074, 2083},           /* tested spans triangle */
	{646.3, 346},           /* tested spans row */
	{184.4, 119.4},         /* tested spans pixel */
	{3000, 1500},           /* mixed textured triangle */
	{250, 190},             /* mixed textured row */
	{150, 97},              /* mixed textured pixel */
	{3536, 2271},           /* mixed spans triangle */
	{331.8, 183.9},         /* mixed spans row */
	{136.3, 91.53},         /* mixed spans pixel */
	{5120, 4123},           /* mixed divided triangle */
	{1880, 925.6},          /* mixed divided row */
	{128.1, 85.51},         /* mixed divided pixel */
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
