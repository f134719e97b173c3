/*
 * The governor keeps frames within a time budget by reducing quality.
 *
 * Its steps go from the least visible reduction to the most visible one:
 * triangles, influences, normals, the rate of poses. A step is taken when the
 * mean frame time has been above the budget for 0.2 s. It is taken back when
 * the mean plus the time that the step saves has been below 90% of the budget
 * for wait_s, which doubles, from 1 up to 30 s, whenever a step is taken again
 * soon. A frame in which the process was stopped for a second or more does not
 * count. The caller provides the time.
 */
#ifndef APP_CMD_SHOW_GOVERNOR_H
#define APP_CMD_SHOW_GOVERNOR_H

#include "app/demo/demo_env.h"
#include "app/scene/hud/hud.h"

enum {
	GOVERNOR_STEPS = 7
};

struct governor {
	float budget_ms; /* 0: no budget, so quality is never reduced */
	int level;       /* number of steps taken, 0 to GOVERNOR_STEPS */
	float last_ms;   /* time of the last frame */
	float mean_ms;   /* mean time of frames since the last step */
	int frames;      /* since the last step */
	float before_ms; /* the mean before the last step */
	bool measuring;  /* the last step's saving is not yet known */
	float saved_ms[GOVERNOR_STEPS + 1]; /* [level]: by the step to this level */
	/* Since when frames are above or below budget; -1: they are not. */
	double over_s, under_s;
	double restored_s; /* when a step was last taken back */
	double wait_s;     /* time below budget before a step is taken back */
	unsigned turn;     /* counts frames, see governor_poses() */
};

struct governor governor_begin(float budget_ms);

/*
 * Adds the time of a frame, which must not include waiting for the display.
 * Returns true if the level has changed.
 */
bool governor_feed(struct governor *governor, double now_s, float work_ms);

/* Returns the level's reduction, for demo_set_reduction(). */
struct demo_reduction governor_reduction(const struct governor *governor);

/* Call this once a frame. Returns whether the frame gets a new pose. */
bool governor_poses(struct governor *governor);

/* Returns the level's name, such as "2 influences"; NULL at level 0. */
const char *governor_text(const struct governor *governor);

/* Adds a label with budget, frame time and level, if there is a budget. */
void governor_label(const struct governor *governor, struct hud *hud);

#endif
