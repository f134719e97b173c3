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
	{3.915e+04, 2.087e+04}, /* frame */
	{0.7724, 0},            /* pixel */
	{1.892e+04, 6458},      /* call */
	{73.86, 50.5},          /* listed */
	{386.5, 104.5},         /* vertex */
	{161.4, 90.68},         /* again */
	{370.2, 169.9},         /* single */
	{288.4, 251.2},         /* shaded */
	{13.49, 15.79},         /* hidden */
	{1474, 574.9},          /* skipped */
	{5.437, 2.515},         /* fine */
	{193.2, 99.54},         /* flat triangle */
	{79.35, 49.87},         /* flat row */
	{23.63, 14.16},         /* flat pixel */
	{647.5, 228.4},         /* plain triangle */
	{22.01, 16.63},         /* plain row */
	{8.911, 3.515},         /* plain pixel */
	{749.7, 583},           /* textured triangle */
	{151.5, 0},             /* textured row */
	{79.07, 57.7},          /* textured pixel */
	{2.032e+04, 8529},      /* backdrop triangle */
	{66.8, 16.16},          /* backdrop row */
	{1.422, 0},             /* backdrop pixel */
	{5.113e+04, 1.087e+04}, /* ground triangle */
	{149.6, 30.37},         /* ground row */
	{4.713, 1.375},         /* ground pixel */
	{899, 460.4},           /* spans triangle */
	{228.7, 145.7},         /* spans row */
	{19.97, 13.33},         /* spans pixel */
	{1512, 0},              /* spans textured triangle */
	{339.4, 174.1},         /* spans textured row */
	{70.18, 45.61},         /* spans textured pixel */
	{7199, 5036},           /* spans divided triangle */
	{704.5, 386.8},         /* spans divided row */
	{88.75, 54.47},         /* spans divided pixel */
	{3090, 1209},           /* spans nearest triangle */
	{313.9, 151.1},         /* spans nearest row */
	{38.16, 25.44},         /* spans nearest pixel */
	{2999, 1878},           /* mixed triangle */
	{236.9, 119.6},         /* mixed row */
	{47.35, 31.07},         /* mixed pixel */
	{3406, 1264},           /* tested triangle */
	{243.4, 162.1},         /* tested row */
	{135.5, 86.66},         /* tested pixel */
	{3088, 1848},           /* tested spans triangle */
	{323.3, 195.8},         /* tested spans row */
	{137.2, 82.2},          /* tested spans pixel */
	{3170, 903},            /* mixed textured triangle */
	{256.5, 141.4},         /* mixed textured row */
	{214.2, 139.2},         /* mixed textured pixel */
	{3658, 2593},           /* mixed spans triangle */
	{394.8, 233.3},         /* mixed spans row */
	{176.3, 104.1},         /* mixed spans pixel */
	{5055, 4066},           /* mixed divided triangle */
	{1451, 755.3},          /* mixed divided row */
	{150.4, 100.6},         /* mixed divided pixel */
	{195.7, 23.78},         /* colored triangle */
	{18.78, 19.23},         /* colored row */
	{1.726, 0},             /* colored pixel */
	{2888, 1510},           /* bent triangle */
	{333.3, 195.2},         /* bent row */
	{3.727, 2.609},         /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.005, 0.9941},        /* deep row */
	{1.775, 2.561},         /* deep pixel */
	{701, 390.7},           /* second triangle */
	{172.3, 90.46},         /* second row */
	{52.72, 26.68},         /* second pixel */
	{317.4, 205.9},         /* crossed triangle */
	{239.2, 128.3},         /* crossed row */
	{3.987, 3.579},         /* crossed pixel */
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
