/*
 * What a source read in one go, brought into the order of time.
 */
#ifndef PLATFORM_BUTTONS_BUTTON_BATCH_H
#define PLATFORM_BUTTONS_BUTTON_BATCH_H

#include "platform/buttons/buttons.h"

enum {
	BUTTON_BATCH_CAPACITY = 512
};

/* Begins zeroed. */
struct button_batch {
	struct button_event event[BUTTON_BATCH_CAPACITY];
	int count;
};

/* Adds an event; one that has no room takes the place of the last. */
void button_batch_add(struct button_batch *batch, struct button_event event);

/* Pushes all, oldest first, those of one time as they came; then empties. */
void button_batch_push(struct button_batch *batch, struct button_queue *queue);

#endif
