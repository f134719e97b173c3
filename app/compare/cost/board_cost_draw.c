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
	{3.305e+04, 2.153e+04}, /* frame */
	{0.6623, 0.2468},       /* pixel */
	{1.823e+04, 6876},      /* call */
	{104.5, 50.74},         /* listed */
	{351.3, 77.47},         /* vertex */
	{125.2, 70.97},         /* again */
	{331.7, 155.1},         /* single */
	{267.7, 242.1},         /* shaded */
	{13.57, 14.11},         /* hidden */
	{1316, 484.9},          /* skipped */
	{3.897, 2.777},         /* fine */
	{192.2, 84.59},         /* flat triangle */
	{74.36, 45.84},         /* flat row */
	{15.47, 11.86},         /* flat pixel */
	{612.8, 223.9},         /* plain triangle */
	{26.03, 25.18},         /* plain row */
	{12.95, 5.293},         /* plain pixel */
	{683.7, 512.6},         /* textured triangle */
	{105.3, 0},             /* textured row */
	{101.2, 66.77},         /* textured pixel */
	{2.993e+04, 8037},      /* backdrop triangle */
	{66.89, 24.67},         /* backdrop row */
	{0.0589, 0},            /* backdrop pixel */
	{3.669e+04, 1.153e+04}, /* ground triangle */
	{124.4, 53.84},         /* ground row */
	{8.222, 1.306},         /* ground pixel */
	{458.1, 276.5},         /* spans triangle */
	{204.6, 135.7},         /* spans row */
	{22.48, 14.44},         /* spans pixel */
	{1687, 416.5},          /* spans textured triangle */
	{136.7, 28.04},         /* spans textured row */
	{78.56, 51.91},         /* spans textured pixel */
	{6395, 4214},           /* spans divided triangle */
	{714.7, 382.9},         /* spans divided row */
	{92.38, 55.94},         /* spans divided pixel */
	{3142, 1177},           /* spans nearest triangle */
	{324.1, 146.7},         /* spans nearest row */
	{38.12, 27.51},         /* spans nearest pixel */
	{3225, 1894},           /* mixed triangle */
	{209.6, 115.7},         /* mixed row */
	{50, 32.24},            /* mixed pixel */
	{3685, 1375},           /* tested triangle */
	{263.7, 155.8},         /* tested row */
	{121.1, 81.66},         /* tested pixel */
	{3414, 2221},           /* tested spans triangle */
	{351.3, 224.4},         /* tested spans row */
	{135, 80.98},           /* tested spans pixel */
	{3677, 956.8},          /* mixed textured triangle */
	{247, 113},             /* mixed textured row */
	{143.8, 100.8},         /* mixed textured pixel */
	{3380, 2156},           /* mixed spans triangle */
	{209.4, 142.7},         /* mixed spans row */
	{156.2, 87.47},         /* mixed spans pixel */
	{5099, 4108},           /* mixed divided triangle */
	{1178, 611.6},          /* mixed divided row */
	{133.9, 85.34},         /* mixed divided pixel */
	{254.1, 90},            /* colored triangle */
	{0, 0},                 /* colored row */
	{3.708, 1.32},          /* colored pixel */
	{2998, 1502},           /* bent triangle */
	{409.9, 241.7},         /* bent row */
	{3.971, 2.744},         /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.002, 0.9993},        /* deep row */
	{2.107, 1.731},         /* deep pixel */
	{659.8, 355.8},         /* second triangle */
	{162.5, 82.16},         /* second row */
	{45.6, 23.68},          /* second pixel */
	{314.6, 210.9},         /* crossed triangle */
	{185.4, 119.8},         /* crossed row */
	{3.342, 2.8},           /* crossed pixel */
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
