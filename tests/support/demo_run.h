/*
 * A demo without a picture: a script of buttons in, recorded GL calls out.
 */
#ifndef TESTS_SUPPORT_DEMO_RUN_H
#define TESTS_SUPPORT_DEMO_RUN_H

#include "app/demo/demo.h"

struct demo_press {
	double time_s; /* when it goes down; it comes up 0.1 s later */
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
 * The demo of that name, or a model of assets/ in the viewer, attended: only
 * what is pressed happens. Fails the running test if it cannot begin.
 */
void demo_run_begin(struct demo_run *run, const char *name);

/* The same with another kernel than float. */
void demo_run_begin_by(
	struct demo_run *run, const char *name, const char *kernel);

/* Updates up to time_s at rate_hz, with the presses that are due. */
void demo_run_to(struct demo_run *run, double time_s, double rate_hz,
	const struct demo_press *press, int press_count);

/* Draws one frame into the recorder, see gl_recorder_result(). */
void demo_run_draw(struct demo_run *run);

void demo_run_end(struct demo_run *run);

#endif
