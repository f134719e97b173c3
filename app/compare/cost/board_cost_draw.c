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
	{3.386e+04, 2.193e+04}, /* frame */
	{0.5199, 0.1332},       /* pixel */
	{1.955e+04, 6770},      /* call */
	{80.23, 44.06},         /* listed */
	{347.9, 92.75},         /* vertex */
	{136.3, 86},            /* again */
	{334.5, 160.5},         /* single */
	{301.3, 254.4},         /* shaded */
	{14.82, 15.15},         /* hidden */
	{1511, 557.4},          /* skipped */
	{3.702, 2.86},          /* fine */
	{176.9, 90},            /* flat triangle */
	{76.67, 38.69},         /* flat row */
	{16.79, 12.45},         /* flat pixel */
	{623.2, 229.2},         /* plain triangle */
	{25.78, 26.75},         /* plain row */
	{9.008, 4.591},         /* plain pixel */
	{744.7, 479.6},         /* textured triangle */
	{79.85, 0},             /* textured row */
	{101.2, 66.16},         /* textured pixel */
	{3.065e+04, 7702},      /* backdrop triangle */
	{64.75, 20.72},         /* backdrop row */
	{0, 0},                 /* backdrop pixel */
	{3.86e+04, 1.193e+04},  /* ground triangle */
	{129.9, 51.31},         /* ground row */
	{8.749, 1.174},         /* ground pixel */
	{134.9, 22.65},         /* spans triangle */
	{208.8, 136.5},         /* spans row */
	{21.17, 14.1},          /* spans pixel */
	{1078, 0},              /* spans textured triangle */
	{300.6, 165.4},         /* spans textured row */
	{72.59, 47.14},         /* spans textured pixel */
	{6647, 4554},           /* spans divided triangle */
	{681.8, 397.1},         /* spans divided row */
	{90.53, 54.98},         /* spans divided pixel */
	{3185, 1226},           /* spans nearest triangle */
	{316.2, 145.8},         /* spans nearest row */
	{34.24, 26.01},         /* spans nearest pixel */
	{3410, 1942},           /* mixed triangle */
	{201, 117.1},           /* mixed row */
	{48.48, 31.4},          /* mixed pixel */
	{3599, 1288},           /* tested triangle */
	{251.2, 155.2},         /* tested row */
	{121.7, 82.46},         /* tested pixel */
	{3191, 1916},           /* tested spans triangle */
	{306.3, 188.4},         /* tested spans row */
	{139, 84.63},           /* tested spans pixel */
	{4284, 1163},           /* mixed textured triangle */
	{275.6, 140.8},         /* mixed textured row */
	{198.2, 136.8},         /* mixed textured pixel */
	{3676, 2525},           /* mixed spans triangle */
	{315.2, 187.4},         /* mixed spans row */
	{179, 108.6},           /* mixed spans pixel */
	{5082, 4082},           /* mixed divided triangle */
	{1391, 712.5},          /* mixed divided row */
	{147.8, 98.71},         /* mixed divided pixel */
	{251.1, 57.16},         /* colored triangle */
	{4.627, 0},             /* colored row */
	{4.812, 1.888},         /* colored pixel */
	{3235, 1660},           /* bent triangle */
	{381.4, 218.3},         /* bent row */
	{3.89, 2.705},          /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.003, 0.9994},        /* deep row */
	{2.337, 2.136},         /* deep pixel */
	{675.5, 369.5},         /* second triangle */
	{166.3, 84.66},         /* second row */
	{45.53, 23.01},         /* second pixel */
	{324.7, 217.6},         /* crossed triangle */
	{150.5, 89.52},         /* crossed row */
	{3.542, 3.202},         /* crossed pixel */
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
