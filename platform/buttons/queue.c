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

static struct button_event *event_at(struct button_queue *queue, int number)
{
	return &queue->event[(queue->first + number) % BUTTON_QUEUE_CAPACITY];
}

/* Whether a later event in the queue has the same button. */
static bool is_followed(struct button_queue *queue, int number)
{
	enum button button = event_at(queue, number)->button;

	for (int i = number + 1; i < queue->count; i++) {
		if (event_at(queue, i)->button == button) {
			return true;
		}
	}
	return false;
}

/*
 * Drops the oldest event that is not the last one of its button: a full queue
 * has more events than there are buttons. Those before it move up.
 */
static void drop_one(struct button_queue *queue)
{
	int number = 0;

	while (!is_followed(queue, number)) {
		number++;
	}
	for (; number > 0; number--) {
		*event_at(queue, number) = *event_at(queue, number - 1);
	}
	queue->first = (queue->first + 1) % BUTTON_QUEUE_CAPACITY;
	queue->count--;
}

static void pass_on(struct button_queue *queue, struct button_event event)
{
	int last;

	queue->down[event.button] = event.down;
	queue->changed_ms[event.button] = event.time_ms;
	queue->held_back[event.button] = false;
	if (queue->count == BUTTON_QUEUE_CAPACITY) {
		drop_one(queue);
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

/* Notes what one holder does. Returns whether any holds the button then. */
static bool hold(struct button_queue *queue, const struct button_event *event)
{
	uint16_t bit = (uint16_t)(1u << event->holder);
	uint16_t *own = &queue->held[queue->source][event->button];
	bool held = false;

	*own = (uint16_t)(event->down ? *own | bit : *own & ~bit);
	for (int i = 0; i <= BUTTON_SOURCES_MAX; i++) {
		held = held || queue->held[i][event->button];
	}
	return held;
}

void button_queue_push(struct button_queue *queue, struct button_event event)
{
	int64_t since_ms;

	if ((unsigned int)event.button >= BUTTON_COUNT ||
		event.holder >= BUTTON_HOLDERS_MAX) {
		return;
	}
	event.down = hold(queue, &event);
	event.holder = 0;
	button_queue_settle(queue, event.time_ms);
	if (event.down == queue->down[event.button]) {
		queue->held_back[event.button] = false;
		return;
	}
	since_ms = event.time_ms - queue->changed_ms[event.button];
	if (!queue->exact && since_ms < queue->debounce_ms[event.button] &&
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
