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
	 * Called with amount when the button is pressed and, if held is set,
	 * when it is released: with the amount of another held button that
	 * calls it, or with 0. NULL: a press inverts the bool at offset
	 * inverts, in bytes, of the demo's struct.
	 */
	void (*run)(struct demo *demo, int amount);
	int amount;
	bool held;
	size_t inverts;
};

/* Actions: on a press, while a button is held, and one that inverts a bool. */
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
	const char *asset; /* the model, in assets/; NULL: the user's */
	bool any_model;    /* may show the user's model instead */
	const struct demo_action *action; /* ends with a NULL summary, or NULL */

	/* Size of the demo's struct, which begins with a struct demo_base. */
	size_t size;

	/*
	 * Called with a demo whose base has a loaded actor and whose other
	 * members are 0. Prepares the demo and, last, makes the stage. Returns
	 * 0, or -errno after logging an error.
	 */
	int (*prepare)(struct demo *demo, const struct demo_env *env);

	/* Releases what prepare() and actions allocated. Optional. */
	void (*finish)(struct demo *demo);

	/*
	 * press() takes a button event, print_buttons() prints what each button
	 * does. A demo has either these two or a table of actions.
	 */
	void (*press)(struct demo *demo, const struct button_event *event);
	void (*print_buttons)(const struct demo *demo, FILE *out);

	/* Goes on to time_s, which never decreases. Allocates nothing. */
	void (*update)(struct demo *demo, double time_s);

	/*
	 * Draws a frame of this size. Allocates nothing. Without this function,
	 * the stage and all figures with flat shadows are drawn.
	 */
	void (*draw)(struct demo *demo, int width, int height);

	/* Whether figures cast a shadow now. Without this function, they do. */
	bool (*casts_shadow)(const struct demo *demo);

	/* Returns the seconds after which an unattended run repeats. */
	double (*period_s)(const struct demo *demo);

	/*
	 * Returns the seconds after which each period of an unattended run is
	 * like the one before. Without this function, the first one is.
	 */
	double (*settled_s)(const struct demo *demo);

	/* Adds labels for the technique, clip, time, weight and so on. */
	void (*label)(const struct demo *demo, struct hud *hud);

	const char *technique; /* its name; NULL: the actor's technique */

	/*
	 * Describes figure number, counted from 0. Returns false if there is
	 * none. *out is the actor's instance at the origin beforehand, which is
	 * the only figure without this function.
	 */
	bool (*get_figure)(const struct demo *demo, int number,
		struct overlay_figure *out);

	/*
	 * Describes the clip and the layers that move the first figure. *out is
	 * overlay_motion_none() beforehand. Optional.
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

/* Sets by how much the demo reduces quality from its next update on. */
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
 * Draws a frame of this size with its overlays. Allocates nothing, unless the
 * model has been reloaded.
 */
void demo_draw(const struct demo_driver *driver, struct demo *demo, int width,
	int height);

/* Shows the next overlay, or none after the last one. */
void demo_show_next_overlay(const struct demo_driver *driver, struct demo *demo);

/* Overlays show the next (step 1) or previous (-1) joint, part or target. */
void demo_choose_joint(struct demo *demo, int step);

/* Adds labels of the demo, of the video camera and of the overlays. */
void demo_label(const struct demo_driver *driver, const struct demo *demo,
	struct hud *hud);

/* Returns what the demo shows now. */
struct demo_facts demo_get_facts(
	const struct demo_driver *driver, const struct demo *demo);

/* Runs the demo's action for the event's button, if it has one. */
void demo_press(const struct demo_driver *driver, struct demo *demo,
	const struct button_event *event);

/* Switches to the next enum live_use. Does nothing without a video camera. */
void demo_next_camera_use(struct demo *demo);

#endif
