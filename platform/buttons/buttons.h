/*
 * Buttons: every source feeds one queue of {time, button, down}.
 *
 * The buttons are named after the keypad of the i.MX31 PDK. The queue drops
 * repeats and removes contact bounce, so it only passes on changes. A button
 * that several keys or lines press is up when the last of them is released.
 */
#ifndef PLATFORM_BUTTONS_BUTTONS_H
#define PLATFORM_BUTTONS_BUTTONS_H

#include <stdbool.h>
#include <stdint.h>

#include "platform/base/log.h"
#include "platform/base/survey.h"

enum button {
	BUTTON_UP,
	BUTTON_DOWN,
	BUTTON_LEFT,
	BUTTON_RIGHT,
	BUTTON_ENTER,
	BUTTON_F6,
	BUTTON_F8,
	BUTTON_F9,
	BUTTON_F10,
	BUTTON_COUNT,
};

struct button_event {
	int64_t time_ms; /* since the first frame */
	enum button button;
	bool down;
	/* For button_queue_push(): which of its source's devices or lines. */
	uint8_t holder;
};

enum {
	BUTTON_QUEUE_CAPACITY = 64,
	BUTTON_SOURCES_MAX = 8,
	BUTTON_HOLDERS_MAX = 16 /* devices or lines of a source */
};

/* The default of buttons_open(): longer than contacts bounce, shorter than a
 * person's press. */
enum {
	BUTTON_DEBOUNCE_MS = 8
};

/*
 * First in, first out. When it overflows, the oldest event is dropped whose
 * button has a later one, so that no button seems to stay down.
 */
struct button_queue {
	struct button_event event[BUTTON_QUEUE_CAPACITY];
	int first, count;
	/*
	 * The source that pushes: 0 for a window, 1 and more for those that
	 * buttons_poll() polls.
	 */
	int source;
	/* Its events are no contacts': none is held back as a bounce. */
	bool exact;
	/* By source, a bit for each holder that holds the button down. */
	uint16_t held[BUTTON_SOURCES_MAX + 1][BUTTON_COUNT];
	bool down[BUTTON_COUNT];          /* as in the last event queued */
	bool held_back[BUTTON_COUNT];     /* a later change is held back */
	int64_t changed_ms[BUTTON_COUNT]; /* time of the last event queued */
	int debounce_ms[BUTTON_COUNT];    /* a change within this time after
					     changed_ms may be a bounce */
};

/* "UP" and so on; NULL for BUTTON_COUNT and other values. */
const char *button_name(enum button button);

/* The button of that name, or BUTTON_COUNT. */
enum button button_from_name(const char *name);

/* Empties the queue. All buttons are up and have the same debounce time. */
void button_queue_init(struct button_queue *queue, int debounce_ms);

/*
 * Takes a raw event of one holder; events of a button must come in the order of
 * time. The button is down while any holder holds it. An event that changes
 * nothing is dropped. A change within the debounce time is held back, unless
 * its source is exact: if the button changes back, both are dropped as a
 * bounce, otherwise the change is queued at the end of the debounce time.
 */
void button_queue_push(struct button_queue *queue, struct button_event event);

/*
 * Queues the changes held back whose debounce time ends by now_ms, with the
 * time of that end. buttons_poll() calls it after polling the sources.
 */
void button_queue_settle(struct button_queue *queue, int64_t now_ms);

/* Takes the oldest event off the queue. Returns false when it is empty. */
bool button_queue_pop(struct button_queue *queue, struct button_event *out);

/* An open source of buttons; each driver defines its own. */
struct button_source;

struct button_driver {
	const char *name;
	const char *summary; /* one line for the help text */
	bool exact;          /* its events need no debouncing */
	/*
	 * Checks the syntax of the argument and opens nothing. Returns 0, or
	 * -EINVAL after logging an error. Optional.
	 */
	int (*check)(const char *argument, const struct log *log);
	/*
	 * Opens a source. argument is what follows "NAME:" in --buttons, or
	 * NULL. Returns 0, or -errno after logging an error: the argument is
	 * wrong, or its file cannot be read. A missing device is no failure:
	 * the driver logs a warning, and the source waits for the device or
	 * delivers nothing. Mandatory.
	 */
	int (*create)(const char *argument, const struct log *log,
		struct button_source **out);
	/*
	 * Pushes all events up to now_ms, the oldest first. Never blocks. May
	 * set the queue's debounce_ms of its buttons. Mandatory.
	 */
	void (*poll)(struct button_source *source, int64_t now_ms,
		struct button_queue *queue);
	/* NULL is fine. Mandatory. */
	void (*destroy)(struct button_source *source);

	/*
	 * Reports the devices that could serve as buttons, or that there are
	 * none. Takes no device. Optional.
	 */
	void (*survey)(const struct survey *survey);
};

/* Built-in drivers, NULL at the end. */
extern const struct button_driver *const button_registry[];

/* A set of open sources that feed one queue. */
struct buttons {
	struct button_queue queue;
	int source_count;
	struct {
		const struct button_driver *driver;
		struct button_source *source;
	} source[BUTTON_SOURCES_MAX];
};

/*
 * Empties the queue and opens the sources of a comma-separated SPEC such as
 * "script:run.txt,evdev"; NULL or "" opens none. An item "BUTTON=..." belongs
 * to the source before it: "gpiod:UP=c/18,DOWN=c/19,evdev" is two sources.
 * Returns 0, or -errno after logging an error, with nothing left open. The
 * keyboard of a window needs no source: the display pushes its events.
 */
int buttons_open(
	struct buttons *buttons, const char *spec, const struct log *log);

/*
 * Checks the syntax of a SPEC of buttons_open() and opens nothing. Returns 0,
 * or -EINVAL after logging an error.
 */
int buttons_check(const char *spec, const struct log *log);

/*
 * Opens one more source by its driver's name. Returns 0, or -errno after
 * logging an error.
 */
int buttons_add(struct buttons *buttons, const char *driver,
	const char *argument, const struct log *log);

/* Polls all sources for events up to now_ms and settles the queue. */
void buttons_poll(struct buttons *buttons, int64_t now_ms);

/* Closes all sources. Events in the queue can still be popped. */
void buttons_close(struct buttons *buttons);

#endif
