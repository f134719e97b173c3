/*
 * Buttons: every source feeds one queue of {time, button, down}.
 *
 * The names are the i.MX31 PDK keypad's. A source that repeats or bounces is
 * cleaned here: the queue only passes changes on.
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
};

enum {
	BUTTON_QUEUE_CAPACITY = 64
};

/* What buttons_open() sets: longer than a switch bounces, shorter than a press. */
enum {
	BUTTON_DEBOUNCE_MS = 8
};

/* First in, first out; the oldest event is dropped when it overflows. */
struct button_queue {
	struct button_event event[BUTTON_QUEUE_CAPACITY];
	int first, count;
	bool down[BUTTON_COUNT];          /* as last passed on */
	bool held_back[BUTTON_COUNT];     /* it has changed again since */
	int64_t changed_ms[BUTTON_COUNT]; /* when down changed last */
	int debounce_ms[BUTTON_COUNT];    /* a change sooner than this after
					     the last is held back as bounce */
};

/* "UP" and so on; BUTTON_COUNT and NULL for what is none. */
const char *button_name(enum button button);
enum button button_from_name(const char *name);

/* Empties the queue; all buttons are up, with the same debounce time. */
void button_queue_init(struct button_queue *queue, int debounce_ms);

/*
 * Takes a raw report, in the order of time. Repeats are dropped. A change that
 * comes too soon is held back: one back again makes it a bounce and drops
 * both, otherwise it is passed on when debounce_ms have passed.
 */
void button_queue_push(struct button_queue *queue, struct button_event event);

/*
 * Passes on the changes held back whose time has come by now_ms, stamped with
 * that time. buttons_poll() does it after asking the sources.
 */
void button_queue_settle(struct button_queue *queue, int64_t now_ms);

/* The oldest event into *out, or false. */
bool button_queue_pop(struct button_queue *queue, struct button_event *out);

/* A place that buttons come from. */
struct button_source;

struct button_driver {
	const char *name;
	const char *summary;
	/*
	 * Reads the argument's words and opens nothing. 0, or -EINVAL after a
	 * sentence. Optional.
	 */
	int (*check)(const char *argument, const struct log *log);
	/*
	 * argument is what follows "NAME:" in --buttons, or NULL. 0, or
	 * -errno after a sentence: for wrong words and files. A device that is
	 * missing gets a warning and a source that waits for it or gives
	 * nothing. Mandatory.
	 */
	int (*create)(const char *argument, const struct log *log,
		struct button_source **out);
	/*
	 * Pushes all that happened up to now_ms, oldest first; never blocks.
	 * May set the queue's debounce_ms of its buttons. Mandatory.
	 */
	void (*poll)(struct button_source *source, int64_t now_ms,
		struct button_queue *queue);
	/* NULL is fine. Mandatory. */
	void (*destroy)(struct button_source *source);

	/*
	 * Says what there is to press, or that there is nothing; takes no
	 * device. Optional.
	 */
	void (*survey)(const struct survey *survey);
};

/* Built-in drivers, NULL at the end. */
extern const struct button_driver *const button_registry[];

/* A set of open sources that share one queue. */
enum {
	BUTTON_SOURCES_MAX = 8
};

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
 * "script:run.txt,evdev"; NULL or "" opens none. An item "BUTTON=..." goes on
 * with the source before it: "gpiod:UP=c/18,DOWN=c/19,evdev" is two sources.
 * 0, or -errno after a sentence with nothing left open. A window's keyboard
 * needs no source: the display pushes it. Set queue.debounce_ms afterwards for
 * other times than the usual.
 */
int buttons_open(
	struct buttons *buttons, const char *spec, const struct log *log);

/*
 * Reads a SPEC as buttons_open() does and opens nothing. 0, or -EINVAL after
 * a sentence.
 */
int buttons_check(const char *spec, const struct log *log);

/*
 * Adds one more source by driver name. 0, or -errno after a sentence: the
 * driver's, or the names there are.
 */
int buttons_add(struct buttons *buttons, const char *driver,
	const char *argument, const struct log *log);

/* Asks all sources what happened up to now_ms and settles the queue. */
void buttons_poll(struct buttons *buttons, int64_t now_ms);

/* Closes all sources; what the queue holds can still be popped. */
void buttons_close(struct buttons *buttons);

#endif
