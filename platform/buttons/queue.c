#include "platform/buttons/buttons.h"

#include <string.h>

/* A time longer ago than every debounce time. Differences from it cannot
 * overflow while times stay below 2^62 ms. */
#define LONG_AGO_MS (INT64_MIN / 2)

static const char *const names[BUTTON_COUNT] = {
	[BUTTON_UP] = "UP",
	[BUTTON_DOWN] = "DOWN",
	[BUTTON_LEFT] = "LEFT",
	[BUTTON_RIGHT] = "RIGHT",
	[BUTTON_ENTER] = "ENTER",
	[BUTTON_F6] = "F6",
	[BUTTON_F8] = "F8",
	[BUTTON_F9] = "F9",
	[BUTTON_F10] = "F10",
};

const char *button_name(enum button button)
{
	return (unsigned int)button < BUTTON_COUNT ? names[button] : NULL;
}

enum button button_from_name(const char *name)
{
	int button = 0;

	while (button < BUTTON_COUNT && strcmp(name, names[button]) != 0) {
		button++;
	}
	return (enum button)button;
}

void button_queue_init(struct button_queue *queue, int debounce_ms)
{
	*queue = (struct button_queue){.count = 0};
	for (int i = 0; i < BUTTON_COUNT; i++) {
		queue->debounce_ms[i] = debounce_ms;
		queue->changed_ms[i] = LONG_AGO_MS;
	}
}

static void pass_on(struct button_queue *queue, struct button_event event)
{
	int last;

	queue->down[event.button] = event.down;
	queue->changed_ms[event.button] = event.time_ms;
	queue->held_back[event.button] = false;
	if (queue->count == BUTTON_QUEUE_CAPACITY) {
		queue->first = (queue->first + 1) % BUTTON_QUEUE_CAPACITY;
		queue->count--;
	}
	last = (queue->first + queue->count) % BUTTON_QUEUE_CAPACITY;
	queue->event[last] = event;
	queue->count++;
}

/*
 * The button whose held-back change is due earliest, among those due by now_ms,
 * or BUTTON_COUNT.
 */
static int find_due(const struct button_queue *queue, int64_t now_ms)
{
	int64_t first_ms = INT64_MAX;
	int due = BUTTON_COUNT;

	for (int i = 0; i < BUTTON_COUNT; i++) {
		int64_t due_ms = queue->changed_ms[i] + queue->debounce_ms[i];

		if (queue->held_back[i] && due_ms <= now_ms &&
			due_ms < first_ms) {
			first_ms = due_ms;
			due = i;
		}
	}
	return due;
}

void button_queue_settle(struct button_queue *queue, int64_t now_ms)
{
	int due;

	while ((due = find_due(queue, now_ms)) != BUTTON_COUNT) {
		pass_on(queue,
			(struct button_event){
				.time_ms = queue->changed_ms[due] +
					queue->debounce_ms[due],
				.button = (enum button)due,
				.down = !queue->down[due],
			});
	}
}

void button_queue_push(struct button_queue *queue, struct button_event event)
{
	int64_t since_ms;

	if ((unsigned int)event.button >= BUTTON_COUNT) {
		return;
	}
	button_queue_settle(queue, event.time_ms);
	if (event.down == queue->down[event.button]) {
		queue->held_back[event.button] = false;
		return;
	}
	since_ms = event.time_ms - queue->changed_ms[event.button];
	if (since_ms < queue->debounce_ms[event.button] &&
		queue->debounce_ms[event.button] > 0) {
		queue->held_back[event.button] = true;
		return;
	}
	pass_on(queue, event);
}

bool button_queue_pop(struct button_queue *queue, struct button_event *out)
{
	if (queue->count == 0) {
		return false;
	}
	*out = queue->event[queue->first];
	queue->first = (queue->first + 1) % BUTTON_QUEUE_CAPACITY;
	queue->count--;
	return true;
}
