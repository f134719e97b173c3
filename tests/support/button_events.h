/* Raw events that are pushed into a queue of buttons, and what comes out. */
#ifndef TESTS_SUPPORT_BUTTON_EVENTS_H
#define TESTS_SUPPORT_BUTTON_EVENTS_H

#include "platform/buttons/buttons.h"

/* Pushes an event of the first holder. */
void button_push(
	struct button_queue *queue, int time_ms, enum button button, bool down);

/* Fails the test unless this is the next event. */
void button_expect(
	struct button_queue *queue, int time_ms, enum button button, bool down);

/* Fails the test if there is an event. */
void button_expect_nothing(struct button_queue *queue);

#endif
