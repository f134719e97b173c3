/*
 * The system calls of the evdev driver, as a table that tests can replace.
 */
#ifndef PLATFORM_BUTTONS_EVDEV_SYSTEM_H
#define PLATFORM_BUTTONS_EVDEV_SYSTEM_H

#include <sys/types.h>

#include "platform/buttons/buttons.h"
#include "platform/buttons/evdev/keys.h"

struct evdev_description {
	char name[80];                 /* describe() terminates it */
	uint8_t keys[EVDEV_KEY_BYTES]; /* a bit for each key it has */
};

/* All calls return 0 or more, or -errno. */
struct evdev_system {
	const char *directory;         /* of the devices event0, event1 ... */
	int (*open)(const char *path); /* opens a device with O_NONBLOCK */
	int (*describe)(int fd, struct evdev_description *out);
	int (*keys_down)(int fd, uint8_t bits[EVDEV_KEY_BYTES]);
	ssize_t (*read)(int fd, void *bytes, size_t size);
};

/* The calls of Linux, with /dev/input. */
extern const struct evdev_system evdev_linux;

/*
 * The driver's create() with other system calls, which must outlive the source.
 */
int evdev_create_on(const struct evdev_system *system, const char *argument,
	const struct log *log, struct button_source **out);

/* The driver's survey() with other system calls. */
void evdev_survey_on(
	const struct evdev_system *system, const struct survey *survey);

#endif
