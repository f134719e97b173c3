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
	{4.674e+04, 2.63e+04}, /* frame */
	{0.568, 0},            /* pixel */
	{1.775e+04, 5810},     /* call */
	{35.96, 6.705},        /* listed */
	{325.9, 127.5},        /* vertex */
	{196.7, 122.3},        /* again */
	{315.7, 152.5},        /* single */
	{498, 318.3},          /* shaded */
	{9.56, 14.73},         /* hidden */
	{1353, 634.8},         /* skipped */
	{4.41, 1.547},         /* fine */
	{294.2, 182.3},        /* flat triangle */
	{88.22, 27.21},        /* flat row */
	{27.87, 15.92},        /* flat pixel */
	{568.5, 338.6},        /* plain triangle */
	{31.11, 0},            /* plain row */
	{2.322, 4.128},        /* plain pixel */
	{833.5, 527.7},        /* textured triangle */
	{73.72, 0},            /* textured row */
	{84.73, 57.33},        /* textured pixel */
	{9741, 0},             /* backdrop triangle */
	{67.26, 10.99},        /* backdrop row */
	{1.832, 0.09038},      /* backdrop pixel */
	{6.909e+04, 1.63e+04}, /* ground triangle */
	{194.2, 48.84},        /* ground row */
	{5.409, 3.785},        /* ground pixel */
	{0, 0},                /* spans triangle */
	{230.8, 148.6},        /* spans row */
	{19.12, 12.31},        /* spans pixel */
	{0, 0},                /* spans textured triangle */
	{260.7, 150},          /* spans textured row */
	{75.64, 47.89},        /* spans textured pixel */
	{7545, 3842},          /* spans divided triangle */
	{692.4, 414.5},        /* spans divided row */
	{87.47, 53.74},        /* spans divided pixel */
	{2697, 1069},          /* spans nearest triangle */
	{310.5, 156.3},        /* spans nearest row */
	{35.86, 24.84},        /* spans nearest pixel */
	{1192, 737.1},         /* mixed triangle */
	{92, 44.87},           /* mixed row */
	{44.79, 24.08},        /* mixed pixel */
	{3305, 1165},          /* tested triangle */
	{371.3, 245.4},        /* tested row */
	{101.5, 65.68},        /* tested pixel */
	{1548, 1035},          /* tested spans triangle */
	{99.69, 104.3},        /* tested spans row */
	{169.2, 98.72},        /* tested spans pixel */
	{4498, 1945},          /* mixed textured triangle */
	{243.8, 164.3},        /* mixed textured row */
	{164.1, 104.3},        /* mixed textured pixel */
	{3866, 2993},          /* mixed spans triangle */
	{251.4, 194.7},        /* mixed spans row */
	{144.1, 82.26},        /* mixed spans pixel */
	{4994, 4055},          /* mixed divided triangle */
	{1237, 676.9},         /* mixed divided row */
	{130.1, 85.84},        /* mixed divided pixel */
	{0, 0},                /* colored triangle */
	{31.66, 23.24},        /* colored row */
	{1.911, 0},            /* colored pixel */
	{4877, 2903},          /* bent triangle */
	{299.2, 139.8},        /* bent row */
	{2.697, 1.773},        /* bent pixel */
	{1, 1},                /* deep triangle */
	{1.009, 0.999},        /* deep row */
	{0.9188, 0.4515},      /* deep pixel */
	{678.3, 343.4},        /* second triangle */
	{181.4, 79.35},        /* second row */
	{61.65, 25.27},        /* second pixel */
	{339.3, 263.1},        /* crossed triangle */
	{182.9, 95.8},         /* crossed row */
	{5.319, 4.785},        /* crossed pixel */
	{1, 1},                /* parted triangle */
	{200, 90},             /* parted row */
	{26, 14.6},            /* parted pixel */
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
