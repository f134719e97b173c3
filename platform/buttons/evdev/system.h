/*
 * What the evdev driver asks of the system, so that tests can answer.
 */
#ifndef PLATFORM_BUTTONS_EVDEV_SYSTEM_H
#define PLATFORM_BUTTONS_EVDEV_SYSTEM_H

#include <sys/types.h>

#include "platform/buttons/buttons.h"
#include "platform/buttons/evdev/keys.h"

struct evdev_description {
	char name[80];
	uint8_t keys[EVDEV_KEY_BYTES]; /* a bit for each it has */
};

/* All give 0 or more, or -errno. */
struct evdev_system {
	const char *directory; /* where devices called event... appear */
	int (*open)(const char *path); /* a descriptor that never blocks */
	int (*describe)(int fd, struct evdev_description *out);
	int (*keys_down)(int fd, uint8_t bits[EVDEV_KEY_BYTES]);
	ssize_t (*read)(int fd, void *bytes, size_t size);
};

/* Linux, /dev/input. */
extern const struct evdev_system evdev_linux;

/*
 * The driver's create() on another system, which outlives the source; poll
 * and destroy as ever.
 */
int evdev_create_on(const struct evdev_system *system, const char *argument,
	const struct log *log, struct button_source **out);

/* The driver's survey(), likewise. */
void evdev_survey_on(
	const struct evdev_system *system, const struct survey *survey);

#endif
