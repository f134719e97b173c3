/*
 * A model that behaves as its character file says, in the viewer.
 *
 * The file lies beside the model (robot.character for robot.glb) or is named by
 * --character. Without one, a model that has morph targets and no clip gets the
 * behaviour that `limber character` would write; any other one gets none.
 */
#ifndef APP_DEMO_VIEWER_BEHAVIOUR_H
#define APP_DEMO_VIEWER_BEHAVIOUR_H

#include "app/demo/actor.h"
#include "app/demo/demo_env.h"
#include "platform/buttons/buttons.h"

#include <stdio.h>

struct behaviour;

/*
 * Writes the path of env's character file: --character, or the one beside the
 * model. False if there is none; with --clip a model plays without one.
 */
bool behaviour_find_file(const struct demo_env *env, char *path, size_t size);

/*
 * Makes the behaviour of a loaded actor. Returns 0, or -errno after logging an
 * error. *out is NULL if the model has none. Release it with
 * behaviour_destroy() before the actor.
 */
int behaviour_create(const struct demo_env *env, struct actor *actor,
	struct behaviour **out);

void behaviour_destroy(struct behaviour *behaviour);

/*
 * Gives the GPIO lines back before the same file is loaded again, and takes
 * them again if that failed. NULL is fine.
 */
void behaviour_suspend(struct behaviour *behaviour);
void behaviour_resume(struct behaviour *behaviour, const struct log *log);

/* A number that changes with the character's files; 0 for no behaviour. */
uint64_t behaviour_stamp(
	const struct demo_env *env, const struct behaviour *behaviour);

/* The stage that the character asks for. */
int behaviour_init_stage(const struct behaviour *behaviour,
	const struct demo_env *env, struct stage *stage);

void behaviour_press(
	struct behaviour *behaviour, const struct button_event *event);

/* Moves on, moves the camera, and updates the actor for a picture's height. */
void behaviour_update(struct behaviour *behaviour, struct demo_base *base,
	double time_s, int height);

/* Draws a frame: stage, shadows, the actor and what the character looks at. */
void behaviour_draw(struct behaviour *behaviour, struct demo_base *base,
	int width, int height);

void behaviour_label(const struct behaviour *behaviour,
	const struct demo_base *base, struct hud *hud);

/* The period of the tour, or of the clip that plays. */
double behaviour_period_s(const struct behaviour *behaviour);

/* Prints what each button does. */
void behaviour_print_buttons(const struct behaviour *behaviour, FILE *out);

/* Describes what moves the figure, for overlays. */
void behaviour_get_motion(const struct behaviour *behaviour,
	const struct model *model, struct overlay_motion *out);

#endif
