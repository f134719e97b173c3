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
	{3.403e+04, 2.763e+04}, /* frame */
	{0.773, 0.3752},        /* pixel */
	{1.718e+04, 7401},      /* call */
	{195.7, 94.21},         /* listed */
	{115, 54.11},           /* vertex */
	{175.9, 121.1},         /* single */
	{756.2, 196.8},         /* shaded */
	{10.52, 9.217},         /* hidden */
	{7.78, 6.21},           /* fine */
	{211.7, 87.59},         /* flat triangle */
	{57.58, 37.95},         /* flat row */
	{10.5, 6.924},          /* flat pixel */
	{458.9, 253},           /* plain triangle */
	{0.3409, 21.11},        /* plain row */
	{34.26, 13.64},         /* plain pixel */
	{724.5, 313.7},         /* textured triangle */
	{338.2, 167.4},         /* textured row */
	{80.42, 57.82},         /* textured pixel */
	{3.902e+04, 1.763e+04}, /* backdrop triangle */
	{73.62, 35.56},         /* backdrop row */
	{2.747, 0.8966},        /* backdrop pixel */
	{3.902e+04, 1.763e+04}, /* ground triangle */
	{133.9, 80.44},         /* ground row */
	{5.655, 1.846},         /* ground pixel */
	{1294, 830.7},          /* spans triangle */
	{166.4, 99.57},         /* spans row */
	{30.68, 19.58},         /* spans pixel */
	{3181, 2274},           /* spans textured triangle */
	{549.2, 324.9},         /* spans textured row */
	{76.96, 40.48},         /* spans textured pixel */
	{4729, 3813},           /* spans divided triangle */
	{949.2, 534},           /* spans divided row */
	{111.9, 72.08},         /* spans divided pixel */
	{2563, 1525},           /* mixed triangle */
	{149.8, 75.18},         /* mixed row */
	{70.85, 45},            /* mixed pixel */
	{3115, 1222},           /* tested triangle */
	{250.9, 162.4},         /* tested row */
	{142.7, 101.7},         /* tested pixel */
	{3797, 2118},           /* tested spans triangle */
	{610.9, 346},           /* tested spans row */
	{187.2, 122.8},         /* tested spans pixel */
	{3000, 1500},           /* mixed textured triangle */
	{250, 190},             /* mixed textured row */
	{150, 97},              /* mixed textured pixel */
	{3612, 2316},           /* mixed spans triangle */
	{314.6, 179.8},         /* mixed spans row */
	{141, 92.56},           /* mixed spans pixel */
	{5139, 4157},           /* mixed divided triangle */
	{1887, 984.3},          /* mixed divided row */
	{138.2, 91.58},         /* mixed divided pixel */
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
