/*
 * The events that a source reads in one poll, which it sorts by time before
 * pushing them into the queue.
 */
#ifndef PLATFORM_BUTTONS_BUTTON_BATCH_H
#define PLATFORM_BUTTONS_BUTTON_BATCH_H

#include "platform/buttons/buttons.h"

enum {
	BUTTON_BATCH_CAPACITY = 1024
};

/* Initialize it with zeros. */
struct button_batch {
	struct button_event event[BUTTON_BATCH_CAPACITY];
	int count;
};

/* Adds an event. A full batch replaces its last event. */
void button_batch_add(struct button_batch *batch, struct button_event event);

/*
 * Pushes all events, the oldest first and events of the same time in the order
 * they were added, then empties the batch.
 */
void button_batch_push(struct button_batch *batch, struct button_queue *queue);

#endif
