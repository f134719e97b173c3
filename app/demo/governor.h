/*
 * A budget for the frame: what to leave out so that frames take no longer.
 *
 * Steps go from what is hardly seen to what is: triangles, then influences,
 * then normals, then how often there is a pose. A step is taken when the mean
 * has been over the budget for a moment, and taken back when what it saved, as
 * measured then, would fit again for a while; a step that did not last makes
 * that while longer. Time comes from the caller.
 */
#ifndef APP_DEMO_GOVERNOR_H
#define APP_DEMO_GOVERNOR_H

#include "app/demo/demo.h"

enum {
	GOVERNOR_STEPS = 7
};

struct governor {
	float budget_ms; /* 0: there is none, and nothing is ever left out */
	int level;       /* steps taken, 0 to GOVERNOR_STEPS */
	float mean_ms;   /* of the last frames since the step */
	int frames;      /* since then */
	float before_ms; /* the mean when the step was taken */
	bool weighing;   /* what the step saves is not known yet */
	float saved_ms[GOVERNOR_STEPS + 1]; /* by the step to this level */
	double over_s, under_s;             /* since when; below 0: it is not */
	double restored_s; /* when a step was last taken back */
	double wait_s;     /* with room, before one is taken back */
	unsigned turn;     /* of the poses */
};

struct governor governor_begin(float budget_ms);

/* A frame took this long, without waiting. True where the level changed. */
bool governor_feed(struct governor *governor, double now_s, float work_ms);

/* What demo_set_reduction() is to be told. */
struct demo_reduction governor_reduction(const struct governor *governor);

/* Once a frame: whether it gets a new pose. */
bool governor_poses(struct governor *governor);

/* "2 influences", or NULL where nothing is left out. */
const char *governor_text(const struct governor *governor);

/* Says on the picture what is left out; nothing without a budget. */
void governor_label(const struct governor *governor, struct hud *hud);

#endif
