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
	{5.825e+04, 3.115e+04}, /* frame */
	{2.613, 0},             /* pixel */
	{1.651e+04, 5555},      /* call */
	{0, 0},                 /* listed */
	{297.1, 79.93},         /* vertex */
	{167.1, 85.69},         /* again */
	{302.6, 111.8},         /* single */
	{515.2, 402.3},         /* shaded */
	{5.836, 13.99},         /* hidden */
	{1128, 682.7},          /* skipped */
	{4.513, 2.183},         /* fine */
	{712.2, 360.1},         /* flat triangle */
	{49.47, 15.34},         /* flat row */
	{28.85, 14.73},         /* flat pixel */
	{539.9, 232.9},         /* plain triangle */
	{20.42, 0},             /* plain row */
	{2.613, 3.562},         /* plain pixel */
	{194.3, 262.3},         /* textured triangle */
	{287.2, 83.1},          /* textured row */
	{57.38, 45.74},         /* textured pixel */
	{0, 0},                 /* backdrop triangle */
	{0, 0},                 /* backdrop row */
	{0, 0},                 /* backdrop pixel */
	{9.633e+04, 2.115e+04}, /* ground triangle */
	{78.67, 0},             /* ground row */
	{4.557, 2.434},         /* ground pixel */
	{0, 0},                 /* spans triangle */
	{216.1, 132.4},         /* spans row */
	{19.75, 13.56},         /* spans pixel */
	{2377, 2193},           /* spans textured triangle */
	{248.5, 128.7},         /* spans textured row */
	{79.46, 51.16},         /* spans textured pixel */
	{1411, 0},              /* spans divided triangle */
	{760.2, 427.5},         /* spans divided row */
	{70.27, 45.16},         /* spans divided pixel */
	{2287, 686.8},          /* spans nearest triangle */
	{333.3, 186.6},         /* spans nearest row */
	{35.86, 23.51},         /* spans nearest pixel */
	{787.8, 532.5},         /* mixed triangle */
	{97.07, 40.12},         /* mixed row */
	{44.36, 24.36},         /* mixed pixel */
	{0, 0},                 /* tested triangle */
	{1087, 449.3},          /* tested row */
	{27.11, 48.04},         /* tested pixel */
	{0, 0},                 /* tested spans triangle */
	{595.6, 365.8},         /* tested spans row */
	{113.9, 69.02},         /* tested spans pixel */
	{6118, 3196},           /* mixed textured triangle */
	{199.4, 37.22},         /* mixed textured row */
	{146.8, 103.6},         /* mixed textured pixel */
	{0, 333.5},             /* mixed spans triangle */
	{309, 207.6},           /* mixed spans row */
	{149, 85.24},           /* mixed spans pixel */
	{339.8, 2227},          /* mixed divided triangle */
	{1042, 541.9},          /* mixed divided row */
	{107.8, 75.23},         /* mixed divided pixel */
	{0, 0},                 /* colored triangle */
	{49.49, 35.55},         /* colored row */
	{1.196, 0},             /* colored pixel */
	{1237, 602.4},          /* bent triangle */
	{31.55, 14.93},         /* bent row */
	{0.1002, 0.1006},       /* bent pixel */
	{1, 1},                 /* deep triangle */
	{1.006, 0.964},         /* deep row */
	{0, 1.816},             /* deep pixel */
	{937.1, 457.6},         /* second triangle */
	{222.6, 95.6},          /* second row */
	{48.34, 17.95},         /* second pixel */
	{2185, 1080},           /* crossed triangle */
	{274, 209.3},           /* crossed row */
	{20.22, 6.773},         /* crossed pixel */
	{1, 0.9984},            /* parted triangle */
	{0, 0},                 /* parted row */
	{37.37, 10.67},         /* parted pixel */
	{286.5, 148.2},         /* added triangle */
	{39.12, 40.28},         /* added row */
	{7.532, 3.377},         /* added pixel */
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
