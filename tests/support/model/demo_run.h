/*
 * Runs a demo without drawing: a test presses buttons and reads the GL calls
 * that the demo made.
 */
#ifndef TESTS_SUPPORT_MODEL_DEMO_RUN_H
#define TESTS_SUPPORT_MODEL_DEMO_RUN_H

#include "app/demo/demo.h"

struct demo_press {
	double time_s; /* when the button goes down, for 0.1 s */
	enum button button;
};

struct demo_run {
	const struct demo_driver *driver;
	struct demo *demo;
	struct log log;
	struct gl gl;
	double now_s;
};

/*
 * Begins the demo of that name or, where there is none, the viewer with the
 * model assets/NAME. The demo is not unattended, so it does nothing by itself,
 * and it writes no file. Fails the test if the demo cannot begin.
 */
void demo_run_begin(struct demo_run *run, const char *name);

/* The same with the vertex kernel of that name instead of "float". */
void demo_run_begin_by(
	struct demo_run *run, const char *name, const char *kernel);

/* The same with a demo whose buttons may write files, as those of play may. */
void demo_run_begin_saving(struct demo_run *run, const char *name);

/* Updates the demo rate_hz times a second until time_s, pressing what is due. */
void demo_run_to(struct demo_run *run, double time_s, double rate_hz,
	const struct demo_press *press, int press_count);

/* Draws one frame, which gl_recorder_result() then holds. */
void demo_run_draw(struct demo_run *run);

void demo_run_end(struct demo_run *run);

#endif
