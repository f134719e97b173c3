/*
 * The state of one run of play or render, which these files share.
 *
 *	show.c        opens and closes everything
 *	show_loop.c   runs the frames: clock, pace, budget, watchdog
 *	show_input.c  buttons and what they do
 *	show_frame.c  draws a frame and keeps it in files
 */
#ifndef APP_CMD_SHOW_SHOW_STATE_H
#define APP_CMD_SHOW_SHOW_STATE_H

#include "app/cmd/show/film.h"
#include "app/cmd/show/frame_stats.h"
#include "app/cmd/show/frame_watch.h"
#include "app/cmd/show/governor.h"
#include "app/cmd/show/pace.h"
#include "app/cmd/show/program_keys.h"
#include "app/cmd/show/show.h"
#include "app/cmd/show/show_screen.h"
#include "app/cmd/show/snapshot.h"
#include "platform/base/output_file.h"
#include "platform/watchdog/watchdog.h"

#include <stdatomic.h>

struct show {
	const struct show_plan *plan;
	const struct options *options;
	const struct log *log;
	const struct log *caller_log; /* where log passes messages on to */
	atomic_bool heard_error;      /* since the first frame */
	atomic_bool opening;          /* the demo is being loaded */
	struct show_screen screen;
	struct camera_feed camera;
	struct demo *demo;
	struct hud *hud;
	struct watchdog watchdog;

	/* Time. */
	struct clock clock;
	struct pace pace;
	double now_s; /* of the current frame */
	int frames;   /* to show; 0: until closed; -1: a period of the demo */
	bool closed;  /* the user has asked to end the run */
	bool away;    /* the user looks at another console */
	struct frame_stats stats;
	struct frame_watch watch;
	struct governor governor;

	/* Input. */
	struct buttons buttons;
	struct output_file *record; /* of --record-buttons, or NULL */
	int64_t record_ms;          /* time of the last event in record */
	struct program_keys keys;
	bool pressed[BUTTON_COUNT]; /* not released yet; acted on */

	/* Files. */
	struct film film;
	int film_error;     /* 0 or the -errno that ended the film */
	bool keeps_picture; /* the current frame goes into a file */
	struct snapshot snapshot;

	bool lacks_memory; /* an incomplete picture has been logged */
};

/* Opens the sources of buttons. Returns 0, or -errno after logging an error. */
int show_input_open(struct show *show);

/*
 * Opens all keyboards, if the options name no source and the display, which is
 * open, reads no keys itself. Returns 0, or -errno after logging an error.
 */
int show_input_add_keyboards(struct show *show);

/*
 * Closes the sources and completes the file of --record-buttons. If the run
 * failed before any event, a file that existed before stays. Returns 0, or
 * -errno after logging an error.
 */
int show_input_close(struct show *show, int run_error);

/* Read the display's events, or the buttons up to now_ms, and act on them. */
void show_input_poll_display(struct show *show, int64_t now_ms);
void show_input_poll_buttons(struct show *show, int64_t now_ms);

/*
 * Reads the buttons while the user is away: releases count, presses do not, as
 * they may be what is typed on another console.
 */
void show_input_ignore_buttons(struct show *show, int64_t now_ms);

/*
 * Draws and shows one frame, and records it if asked to. Returns 0, or -errno
 * after logging an error.
 */
int show_frame_draw(struct show *show);

/* Runs all frames. Returns 0, or -errno after logging an error. */
int show_loop_run(struct show *show);

#endif
