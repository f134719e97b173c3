/*
 * A model that acts as a character file says, for tests.
 */
#ifndef TESTS_SUPPORT_MODEL_ACTING_H
#define TESTS_SUPPORT_MODEL_ACTING_H

#include "app/character/character.h"
#include "tests/support/log_capture.h"

struct character_sketch_play;

struct acting {
	struct model *model;
	struct instance *instance;
	struct character *character; /* NULL if the text was refused */
	struct log_capture logged;
	int error;
	double now_s;
};

/* Loads the model file. Fails the test if that is not possible. */
void acting_begin(struct acting *acting, const char *model_path);

/* The character file that limber sketches for a model; the caller frees it. */
char *acting_sketch(
	const struct model *model, const struct character_sketch_play *play);

/* Replaces the character by that of a text named "test.character". */
void acting_read(struct acting *acting, const char *text);

/* The same, and fails the test with the error if the text is refused. */
void acting_expect(struct acting *acting, const char *text);

/* The same for a file. */
void acting_load(struct acting *acting, const char *path);

/* Updates rate_hz times a second up to time_s. */
void acting_run_to(struct acting *acting, double time_s, double rate_hz);

void acting_press(struct acting *acting, enum button button);
void acting_release(struct acting *acting, enum button button);

/* Presses a button, updates for held_s seconds, and releases it. */
void acting_tap(struct acting *acting, enum button button, double held_s,
	double rate_hz);

/* The value of a parameter, by its name. */
float acting_value(const struct acting *acting, const char *parameter);

/* The name of the state that plays. */
const char *acting_state(const struct acting *acting);

/* The world position of a node after the last update. */
void acting_place(const struct acting *acting, const char *node, float out[3]);

void acting_end(struct acting *acting);

#endif
