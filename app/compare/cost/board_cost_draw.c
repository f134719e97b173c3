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
	{3.492e+04, 2.714e+04}, /* frame */
	{0.7322, 0.3623},       /* pixel */
	{1.838e+04, 7124},      /* call */
	{169.9, 87.05},         /* listed */
	{169.3, 76.82},         /* vertex */
	{192.5, 122.9},         /* single */
	{787.3, 218.7},         /* shaded */
	{11.15, 10.13},         /* hidden */
	{9.436, 6.36},          /* fine */
	{214, 79.53},           /* flat triangle */
	{67.66, 40.92},         /* flat row */
	{11.81, 7.787},         /* flat pixel */
	{367.5, 236.2},         /* plain triangle */
	{9.607, 25.78},         /* plain row */
	{28.04, 10.5},          /* plain pixel */
	{678.6, 325.8},         /* textured triangle */
	{311.3, 151.6},         /* textured row */
	{80.04, 55.5},          /* textured pixel */
	{4.061e+04, 1.68e+04},  /* backdrop triangle */
	{73.92, 34.08},         /* backdrop row */
	{2.269, 0.804},         /* backdrop pixel */
	{4.111e+04, 1.714e+04}, /* ground triangle */
	{133.8, 73.78},         /* ground row */
	{3.798, 0.8781},        /* ground pixel */
	{797.4, 483},           /* spans triangle */
	{158.4, 99.28},         /* spans row */
	{31.45, 19.65},         /* spans pixel */
	{2697, 1529},           /* spans textured triangle */
	{298.1, 166.8},         /* spans textured row */
	{101.9, 66.05},         /* spans textured pixel */
	{4714, 3774},           /* spans divided triangle */
	{706.7, 364.6},         /* spans divided row */
	{103.9, 67.2},          /* spans divided pixel */
	{1863, 1064},           /* mixed triangle */
	{259.1, 136.6},         /* mixed row */
	{63.16, 42.22},         /* mixed pixel */
	{3147, 1042},           /* tested triangle */
	{278.9, 175.3},         /* tested row */
	{180.8, 124},           /* tested pixel */
	{4047, 2562},           /* tested spans triangle */
	{618.9, 385.5},         /* tested spans row */
	{152, 96.48},           /* tested spans pixel */
	{3291, 1469},           /* mixed textured triangle */
	{258.4, 184.9},         /* mixed textured row */
	{150.6, 91.44},         /* mixed textured pixel */
	{3872, 3025},           /* mixed spans triangle */
	{458.2, 308.3},         /* mixed spans row */
	{162.5, 92.83},         /* mixed spans pixel */
	{5193, 4189},           /* mixed divided triangle */
	{2361, 1143},           /* mixed divided row */
	{135, 90},              /* mixed divided pixel */
	{126.6, 34.56},         /* colored triangle */
	{0, 0},                 /* colored row */
	{6.619, 3.143},         /* colored pixel */
	{2307, 1186},           /* bent triangle */
	{269.1, 146.8},         /* bent row */
	{3.453, 2.273},         /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.003, 1.003},         /* deep row */
	{1.781, 1.273},         /* deep pixel */
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
