/*
 * Demos: interactive programs of motion.
 *
 * A demo owns the model it shows and draws it on a stage. Its only inputs are
 * the time and button events; it knows nothing of the display. A run with equal
 * inputs therefore gives equal frames on every machine. Each demo has a file of
 * its own, and demo.c lists them.
 */
#ifndef APP_DEMO_DEMO_H
#define APP_DEMO_DEMO_H

#include "app/demo/demo_env.h"
#include "app/scene/hud/hud.h"
#include "app/scene/overlay/overlay.h"
#include "platform/buttons/buttons.h"

#include <stddef.h>
#include <stdio.h>

struct demo;

/* What a demo shows, for the display of frame times. */
struct demo_facts {
	const char *technique; /* such as "Skeletal" */
	long triangles;        /* of the models as drawn, without shadows */
};

/* What a button does. */
struct demo_action {
	enum button button;
	const char *summary;
	/*
	 * Called with the amount when the button is pressed and, if it is held,
	 * with 0 when it is released. NULL: a press inverts a bool that lies
	 * this many bytes behind the demo's start.
	 */
	void (*run)(struct demo *demo, int amount);
	int amount;
	bool held;
	size_t inverts;
};

/* Actions of a press, of a button that is held, and of one that inverts. */
#define DEMO_PRESS(name, text, function, with)                             \
	{                                                                  \
		.button = BUTTON_##name, .summary = text, .run = function, \
		.amount = with                                             \
	}
#define DEMO_HOLD(name, text, function, with)                              \
	{                                                                  \
		.button = BUTTON_##name, .summary = text, .run = function, \
		.amount = with, .held = true                               \
	}
#define DEMO_INVERT(name, text, member)                   \
	{                                                 \
		.button = BUTTON_##name, .summary = text, \
		.inverts = offsetof(struct demo, member)  \
	}

/* The interface of one demo. */
struct demo_driver {
	const char *name;
	const char *summary;
	const char *asset; /* a file in assets/; NULL: the user's model */
	bool any_model;    /* shows the user's model in place of the asset */
	const struct demo_action *action; /* ends with a NULL summary, or NULL */

	/* Size of the demo's struct, which begins with a struct demo_base. */
	size_t size;

	/*
	 * Called with a loaded actor and all else zero. Prepares the demo and,
	 * last, makes the stage. Returns 0, or -errno after logging an error.
	 */
	int (*prepare)(struct demo *demo, const struct demo_env *env);

	/* Releases what prepare() and actions allocated. Optional. */
	void (*finish)(struct demo *demo);

	/*
	 * Takes a button event, and prints what each button does. A demo has
	 * these two or a table of actions.
	 */
	void (*press)(struct demo *demo, const struct button_event *event);
	void (*print_buttons)(const struct demo *demo, FILE *out);

	/* Moves on to time_s, which never decreases. Allocates nothing. */
	void (*update)(struct demo *demo, double time_s);

	/*
	 * Draws a frame of this size. Allocates nothing. Optional: the stage
	 * with a flat shadow and a model for each figure.
	 */
	void (*draw)(struct demo *demo, int width, int height);

	/* Whether figures cast a shadow now. Optional: they do. */
	bool (*casts_shadow)(const struct demo *demo);

	/* Returns the seconds after which an unattended run repeats. */
	double (*period_s)(const struct demo *demo);

	/* Adds labels for the technique, clip, time, weight and so on. */
	void (*label)(const struct demo *demo, struct hud *hud);

	const char *technique; /* for facts; NULL: the actor's */

	/*
	 * Describes the figure of this number, from 0. Returns false where
	 * there is none. Optional: the actor's instance stands at the origin.
	 */
	bool (*get_figure)(const struct demo *demo, int number,
		struct overlay_figure *out);

	/*
	 * Describes what moves the first figure. *out describes nothing yet.
	 * Optional.
	 */
	void (*get_motion)(const struct demo *demo, struct overlay_motion *out);
};

/* All demos, ended by NULL; the first one is the default. */
extern const struct demo_driver *const demo_registry[];

/* Shows any model. It is not in the registry because it needs a file name. */
extern const struct demo_driver demo_driver_viewer;

/* Returns the demo of that name, or NULL. */
const struct demo_driver *demo_find(const char *name);

/*
 * Loads the model and prepares the demo. Returns 0, or -errno after logging an
 * error; then nothing is left to release. Release it with demo_destroy().
 */
int demo_create(const struct demo_driver *driver, const struct demo_env *env,
	struct demo **out);

/* Frees the demo; NULL is allowed. */
void demo_destroy(const struct demo_driver *driver, struct demo *demo);

/* Sets what the demo leaves out from its next update on. */
void demo_set_reduction(
	struct demo *demo, const struct demo_reduction *reduction);

/* Sets the frame rate that labels show; 0 if unknown. */
void demo_set_rate(struct demo *demo, float frames_per_s);

/*
 * Takes the video camera's image for the frame at time_s with this size. Call
 * it before draw(). Does nothing without a camera.
 */
void demo_update_live(struct demo *demo, double time_s, int width, int height);

/*
 * Draws a frame of this size, with the overlays that are shown. Allocates
 * nothing, unless the model has been loaded anew.
 */
void demo_draw(const struct demo_driver *driver, struct demo *demo, int width,
	int height);

/* Shows the next overlay, or none after the last one. */
void demo_show_next_overlay(const struct demo_driver *driver, struct demo *demo);

/*
 * Chooses the next joint, part or morph target for overlays; the one before
 * with step -1.
 */
void demo_choose_joint(struct demo *demo, int step);

/* Adds labels of the demo, of the camera's use and of overlays. */
void demo_label(const struct demo_driver *driver, const struct demo *demo,
	struct hud *hud);

/* Returns what the demo shows now. */
struct demo_facts demo_get_facts(
	const struct demo_driver *driver, const struct demo *demo);

/* Runs the demo's action for the event's button, if it has one. */
void demo_press(const struct demo_driver *driver, struct demo *demo,
	const struct button_event *event);

/* The next of enum live_use; without a camera it does nothing. */
void demo_next_camera_use(struct demo *demo);

#endif
