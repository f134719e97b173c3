/*
 * The command line's options, for all commands.
 *
 * options_table.c lists them; limber.conf (config.h) sets the same members.
 */
#ifndef APP_CMD_OPTIONS_OPTIONS_H
#define APP_CMD_OPTIONS_OPTIONS_H

#include <stdbool.h>
#include <stdio.h>

#include "app/anim/clip.h"
#include "app/compare/board_profile.h"
#include "app/model/model.h"
#include "app/scene/instance/influence_cap.h"
#include "app/scene/instance/lod.h"
#include "app/scene/overlay/overlay_kind.h"
#include "app/scene/stage/live.h"
#include "platform/base/log.h"
#include "platform/buttons/buttons.h"
#include "platform/display/pixels.h"
#include "platform/process/clock.h"

/* One bit for each command; an option belongs to a set of them. */
enum command_bit {
	FOR_PLAY = 1,
	FOR_RENDER = 2,
	FOR_POSE = 4,
	FOR_INFO = 8,
	FOR_BENCH = 16,
	FOR_COMPARE = 32,
	FOR_DOCTOR = 64,
	FOR_EXPORT = 128,
	FOR_CHARACTER = 256,
	FOR_OPTIMIZE = 512,
	FOR_LEVELS = 1024,
	FOR_ALL = 2047,
};

/* The value of --math: which arithmetic computes the vertices. */
enum options_math {
	MATH_ANY, /* the best kernel of this build decides */
	MATH_FLOAT,
	MATH_FIXED,
};

/*
 * Each member is named as its option. A string is NULL and a number is 0 when
 * the option was not given, unless options_default() says otherwise.
 */

/* Options of all commands, or of most. */
struct options_common {
	const char *config;  /* a path or "none" */
	size_t memory_bytes; /* the limit of model_load_within() */
	bool json;
	bool nodes;
	bool verbose;
	bool help;
	bool version;
};

/* Which moment of which clip to pose, and how to read the clip. */
struct options_motion {
	const char *clip; /* a name, or a number from 0 */
	double time_s;
	enum clip_interpolation interpolation;
	float speed; /* of a model's clip; negative plays it backwards */
	enum clip_repeat repeat;
	bool all_loop; /* repeat is CLIP_LOOP because the user says so */
};

/* How to compute vertices, and at which level of detail. */
struct options_vertices {
	enum options_math math;
	const char *kernel;
	struct influence_cap influences;
	struct lod lod;
};

struct options_size {
	int width, height; /* pixels */
	bool given;
};

/* Where to show or write pictures, and what draws them. */
struct options_screen {
	const char *output;
	struct options_size size;
	enum pixel_format format;
	bool format_given;
	const char *gl;
	const char *egl_library, *gles_library;
	const char *display;
};

/* Buttons and cameras. */
struct options_input {
	const char *buttons;
	const char *script;
	const char *record_buttons;
	/* [button]: whose action it has ([actions]); BUTTON_COUNT: none. */
	enum button action[BUTTON_COUNT];
	const char *camera;
	enum live_use camera_use;
};

/* What play and render show, for how long, and which files they write. */
struct options_show {
	const char *demo;
	const char *character; /* a file or "none" */
	struct clock clock;
	int frames;
	double fps;
	float budget_ms;
	int walkers;
	const char *record;
	const char *stats;
	const char *watchdog;
	const char *failsafe;
	const char *user; /* to become this user once devices are open */
	bool no_labels;
	bool hud;
	struct overlay_choice overlays;
};

struct options_compare {
	double fps;
	float error_px;
	size_t ram_bytes;
	float ms;
	int jobs; /* threads; 0: one for each processor */
	const struct board_profile *board;
	const char *format; /* of the report */
	const char *plot;
	const char *export;
};

struct options_bench {
	int runs;
};

struct options_export {
	const char *c;
};

/* The strings belong to the caller. */
struct options {
	const char *model_path; /* the argument that is no option, or NULL */
	struct options_common common;
	struct options_motion motion;
	struct options_vertices vertices;
	struct options_screen screen;
	struct options_input input;
	struct options_show show;
	struct options_compare compare;
	struct options_bench bench;
	struct options_export export;
};

/* The options of an empty command line. */
struct options options_default(void);

/*
 * Reads the arguments that follow the command's name. Returns 0, or -EINVAL
 * after logging an error, which suggests an option if one is misspelt. The
 * strings of *options point into argv.
 */
int options_parse(struct options *options, enum command_bit command, int argc,
	char **argv, const struct log *log);

/*
 * Sets one option by its name without dashes; a switch takes "yes" or "no". An
 * option that the command does not have is checked, but not set. Returns 0, or
 * -EINVAL after logging an error. *options may keep the pointer value.
 */
int options_set(struct options *options, enum command_bit command,
	const char *name, const char *value, const struct log *log);

/* Whether the command has an option of that name. */
bool options_takes(enum command_bit command, const char *name);

/*
 * Writes up to capacity names of the command's options; returns their number.
 */
int options_names(enum command_bit command, const char **names, int capacity);

/* Prints the command's options for --help, one on each line. */
void options_list(FILE *out, enum command_bit command);

/*
 * Returns the candidate that is nearest to word: it differs by at most two
 * letters, or one for words of up to three letters. Returns NULL if there is
 * none. Ignores case. candidates ends with NULL.
 */
const char *options_closest(const char *word, const char *const *candidates);

/* A word that is not a valid name, and how to report it. */
struct options_unknown {
	const char *option; /* printed before the word: "--demo ", or "" */
	const char *word;
	const char *what;   /* "demo" */
	const char *prefix; /* printed before a suggested name: "--", or "" */
	const char *hint;   /* what to do if no name is similar */
};

/*
 * Logs an error about the word, which suggests a similar name or gives the
 * hint. names ends with NULL.
 */
void options_log_unknown(const struct log *log,
	const struct options_unknown *unknown, const char *const *names);

#endif
