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
	{3.352e+04, 2.677e+04}, /* frame */
	{0.7481, 0.3634},       /* pixel */
	{1.884e+04, 7740},      /* call */
	{146.4, 79.75},         /* listed */
	{163.1, 71.03},         /* vertex */
	{223.3, 137.7},         /* single */
	{748.7, 210.7},         /* shaded */
	{10.9, 10.19},          /* hidden */
	{9.303, 6.508},         /* fine */
	{189.2, 50.49},         /* flat triangle */
	{61.44, 37.53},         /* flat row */
	{11.36, 7.615},         /* flat pixel */
	{365.2, 228.4},         /* plain triangle */
	{4.489, 21.33},         /* plain row */
	{30.11, 12.27},         /* plain pixel */
	{622.2, 308.2},         /* textured triangle */
	{299.4, 152.6},         /* textured row */
	{79.83, 55.09},         /* textured pixel */
	{3.708e+04, 1.634e+04}, /* backdrop triangle */
	{71.94, 34.11},         /* backdrop row */
	{2.406, 0.8049},        /* backdrop pixel */
	{3.781e+04, 1.677e+04}, /* ground triangle */
	{130.7, 75.59},         /* ground row */
	{4.828, 1.592},         /* ground pixel */
	{913.1, 676.3},         /* spans triangle */
	{156.7, 99.17},         /* spans row */
	{32.22, 19.87},         /* spans pixel */
	{2632, 1484},           /* spans textured triangle */
	{334.2, 186.3},         /* spans textured row */
	{106.1, 67.72},         /* spans textured pixel */
	{4715, 3769},           /* spans divided triangle */
	{676.1, 360.4},         /* spans divided row */
	{104, 67.09},           /* spans divided pixel */
	{2756, 1627},           /* mixed triangle */
	{241.2, 120},           /* mixed row */
	{52.76, 35.88},         /* mixed pixel */
	{2428, 870.2},          /* tested triangle */
	{238.2, 139},           /* tested row */
	{179.1, 123.4},         /* tested pixel */
	{3480, 2013},           /* tested spans triangle */
	{502.1, 337.2},         /* tested spans row */
	{147.7, 95.94},         /* tested spans pixel */
	{3000, 1500},           /* mixed textured triangle */
	{250, 190},             /* mixed textured row */
	{150, 97},              /* mixed textured pixel */
	{3438, 2282},           /* mixed spans triangle */
	{302.2, 218.2},         /* mixed spans row */
	{142.9, 84.85},         /* mixed spans pixel */
	{5119, 4123},           /* mixed divided triangle */
	{1885, 928.6},          /* mixed divided row */
	{128, 85.56},           /* mixed divided pixel */
	{128.3, 31.47},         /* colored triangle */
	{0, 0},                 /* colored row */
	{6.233, 2.994},         /* colored pixel */
	{1780, 924.7},          /* bent triangle */
	{223.7, 125.9},         /* bent row */
	{3.42, 2.255},          /* bent pixel */
	{0, 0},                 /* deep triangle */
	{0, 0},                 /* deep row */
	{0, 0},                 /* deep pixel */
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
