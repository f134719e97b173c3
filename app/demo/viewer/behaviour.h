/*
 * A model that behaves as its character file says, in the viewer.
 *
 * The file lies beside the model (robot.character for robot.glb) or is named by
 * --character. Without one, the model has the behaviour that `limber character`
 * would write for it.
 */
#ifndef APP_DEMO_VIEWER_BEHAVIOUR_H
#define APP_DEMO_VIEWER_BEHAVIOUR_H

#include "app/character/character.h"
#include "app/demo/actor.h"
#include "app/demo/demo_env.h"
#include "app/demo/viewer/behaviour_bounds.h"
#include "app/demo/viewer/behaviour_scene.h"

struct gpio_output;

struct behaviour {
	struct character *character;
	const char *title;               /* the model's technique */
	char path[CHARACTER_PATH_BYTES]; /* "" without a file */
	struct behaviour_scene scene;
	struct behaviour_bounds bounds;
	bool framed; /* the camera shows what the first update played */
	struct gpio_output *output[CHARACTER_OUTPUTS_MAX]; /* or NULL */
	const struct floor *floor; /* of the stage, once it was updated */
};

/*
 * Writes the path of env's character file: --character, or the one beside the
 * model. False if there is none; with --clip a model plays without one.
 */
bool behaviour_find_file(const struct demo_env *env, char *path, size_t size);

/*
 * Makes the behaviour of a loaded actor. Returns 0, or -errno after logging an
 * error. Release it with behaviour_destroy() before the actor.
 */
int behaviour_create(const struct demo_env *env, struct actor *actor,
	struct behaviour **out);

void behaviour_destroy(struct behaviour *behaviour);

/*
 * Gives the GPIO lines back before the same file is loaded again, and takes
 * them again if that failed.
 */
void behaviour_suspend(struct behaviour *behaviour);
void behaviour_resume(struct behaviour *behaviour, const struct log *log);

/* A number that changes with the character's files; 0 without a file. */
uint64_t behaviour_stamp(
	const struct demo_env *env, const struct behaviour *behaviour);

/* The stage that the character asks for. */
int behaviour_init_stage(const struct behaviour *behaviour,
	struct demo_base *base, const struct demo_env *env, struct stage *stage);

/* Moves on, moves the camera, and updates the actor for a picture's height. */
void behaviour_update(
	struct behaviour *behaviour, struct demo_base *base, double time_s);

/* The period of the tour, or of the clip that plays. */
double behaviour_period_s(const struct behaviour *behaviour);

/* Describes what moves the figure, for overlays. */
void behaviour_get_motion(const struct behaviour *behaviour,
	const struct model *model, struct overlay_motion *out);

#endif
