/*
 * The command line: one table of options for all subcommands.
 */
#ifndef APP_CMD_OPTIONS_OPTIONS_H
#define APP_CMD_OPTIONS_OPTIONS_H

#include <stdbool.h>
#include <stdio.h>

#include "app/anim/clip.h"
#include "app/demo/live.h"
#include "app/scene/instance/influence_cap.h"
#include "app/scene/instance/lod.h"
#include "platform/base/log.h"
#include "platform/buttons/buttons.h"
#include "platform/display/pixels.h"
#include "platform/process/clock.h"

/* Which subcommands take an option. */
enum command_bit {
	FOR_PLAY = 1,
	FOR_RENDER = 2,
	FOR_POSE = 4,
	FOR_INFO = 8,
	FOR_BENCH = 16,
	FOR_COMPARE = 32,
	FOR_DOCTOR = 64,
	FOR_EXPORT = 128,
	FOR_ALL = 255,
};

/* How vertices are computed. */
enum math {
	MATH_ANY, /* as is best */
	MATH_FLOAT,
	MATH_FIXED,
};

struct options {
	const char *model_path; /* the word that is no option, or NULL */
	const char *demo;
	const char *output;
	const char *gl;
	const char *egl_library, *gles_library;
	const char *display;
	const char *watchdog;
	const char *buttons;
	const char *script;
	const char *record_buttons; /* a file for what is pressed, or NULL */
	const char *record;         /* a file for what is shown, or NULL */
	const char *config;         /* as given, or NULL */
	enum button action[BUTTON_COUNT]; /* whose action each does */
	const char *camera;
	enum live_use camera_use;
	const char *stats; /* a file for them, or NULL */
	const char *clip;
	const char *kernel; /* or NULL */
	enum math math;
	int width, height;
	bool size_given;
	enum pixel_format format;
	bool format_given;
	double fps; /* 0: not given */
	struct clock clock;
	bool clock_given;
	int frames; /* 0: not given */
	double time_s;
	bool time_given;
	enum clip_interpolation interpolation;
	float speed; /* of a model's clip */
	enum clip_repeat repeat;
	struct influence_cap influences; /* influences */
	struct lod lod;                  /* triangles */
	float budget_ms;                 /* of a frame; 0: none */
	int walkers;                     /* of a crowd; 0: not given */
	int runs;                        /* of each measurement */
	double rate_hz;                  /* frames a second that are compared */
	float bound_px;                  /* the error that may be */
	size_t memory_bytes;             /* that may be used; 0: any */
	const char *report;              /* the kind, of a comparison */
	const char *plot;
	const char *export_folder;
	const char *c_file; /* to export to */
	bool json;
	bool no_labels;
	bool hud; /* the graph of frame times */
	bool verbose;
	bool help;
	bool version;
};

struct options options_default(void);

/*
 * Reads the words after the subcommand. 0, or -EINVAL after a sentence that
 * says what is wrong and, for a misspelt option, what it may have been. The
 * strings stay argv's.
 */
int options_parse(struct options *options, enum command_bit command, int argc,
	char **argv, const struct log *log);

/*
 * Sets one option by its name as in "--name value"; a switch takes yes or no.
 * One that the command has not is checked and left alone. 0, or -EINVAL after
 * a sentence. The value stays the caller's.
 */
int options_set(struct options *options, enum command_bit command,
	const char *name, const char *value, const struct log *log);

/* Whether the command has an option of that name. */
bool options_takes(enum command_bit command, const char *name);

/* The names of the command's options, at most room; their number. */
int options_names(enum command_bit command, const char **names, int room);

/* The options of a subcommand, a line each. */
void options_list(FILE *out, enum command_bit command);

/*
 * The candidate that word was probably meant to be, or NULL: at most two
 * letters off. candidates ends with NULL.
 */
const char *options_closest(const char *word, const char *const *candidates);

#endif
