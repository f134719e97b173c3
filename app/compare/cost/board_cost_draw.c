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
	{6.066e+04, 3.254e+04}, /* frame */
	{2.329, 0},             /* pixel */
	{1.279e+04, 4490},      /* call */
	{0, 0},                 /* listed */
	{320.9, 83.44},         /* vertex */
	{180.8, 88.95},         /* again */
	{306.9, 110.5},         /* single */
	{467.2, 400.6},         /* shaded */
	{7.997, 14.87},         /* hidden */
	{1087, 703.1},          /* skipped */
	{4.65, 2.222},          /* fine */
	{782.4, 356.4},         /* flat triangle */
	{34.17, 14.34},         /* flat row */
	{27.64, 14.25},         /* flat pixel */
	{431.2, 219.6},         /* plain triangle */
	{35.31, 0},             /* plain row */
	{0, 3.274},             /* plain pixel */
	{138.2, 250},           /* textured triangle */
	{306.3, 85.68},         /* textured row */
	{56.22, 45.56},         /* textured pixel */
	{0, 0},                 /* backdrop triangle */
	{0, 0},                 /* backdrop row */
	{0, 0},                 /* backdrop pixel */
	{1.02e+05, 2.254e+04},  /* ground triangle */
	{119.6, 0},             /* ground row */
	{4.854, 2.317},         /* ground pixel */
	{0, 0},                 /* spans triangle */
	{209.5, 130.4},         /* spans row */
	{20.01, 13.64},         /* spans pixel */
	{1765, 2060},           /* spans textured triangle */
	{256.9, 129.9},         /* spans textured row */
	{79.89, 51.23},         /* spans textured pixel */
	{0, 0},                 /* spans divided triangle */
	{778.5, 424},           /* spans divided row */
	{69.89, 45.34},         /* spans divided pixel */
	{2319, 677.1},          /* spans nearest triangle */
	{331.7, 185.1},         /* spans nearest row */
	{36.21, 23.65},         /* spans nearest pixel */
	{756.8, 526.1},         /* mixed triangle */
	{96.35, 38.83},         /* mixed row */
	{44.53, 24.48},         /* mixed pixel */
	{517.6, 0},             /* tested triangle */
	{980.1, 439.9},         /* tested row */
	{33.01, 47.93},         /* tested pixel */
	{0, 0},                 /* tested spans triangle */
	{476.9, 336.5},         /* tested spans row */
	{123.6, 70.85},         /* tested spans pixel */
	{6315, 3007},           /* mixed textured triangle */
	{98.44, 40.31},         /* mixed textured row */
	{152, 103.8},           /* mixed textured pixel */
	{0, 0},                 /* mixed spans triangle */
	{302.1, 205.6},         /* mixed spans row */
	{145, 84.4},            /* mixed spans pixel */
	{0, 2172},              /* mixed divided triangle */
	{1032, 541.3},          /* mixed divided row */
	{106.4, 74.66},         /* mixed divided pixel */
	{0, 0},                 /* colored triangle */
	{52.09, 37.07},         /* colored row */
	{1.312, 0},             /* colored pixel */
	{1244, 604},            /* bent triangle */
	{31.6, 14.92},          /* bent row */
	{0.1002, 0.1006},       /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.012, 0.9702},        /* deep row */
	{0, 1.944},             /* deep pixel */
	{917.3, 445.4},         /* second triangle */
	{217.1, 92.54},         /* second row */
	{47.62, 17.74},         /* second pixel */
	{2728, 1253},           /* crossed triangle */
	{307.3, 213.7},         /* crossed row */
	{19.72, 6.331},         /* crossed pixel */
	{0.9982, 0.9957},       /* parted triangle */
	{0, 0},                 /* parted row */
	{39.34, 12.92},         /* parted pixel */
	{284.2, 148},           /* added triangle */
	{32.39, 39.59},         /* added row */
	{8.838, 3.889},         /* added pixel */
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
