/*
 * The open keyboards and keypads of the evdev driver: finding them, reading
 * them, and noticing when they are plugged in and unplugged.
 */
#ifndef PLATFORM_BUTTONS_EVDEV_EVDEV_DEVICES_H
#define PLATFORM_BUTTONS_EVDEV_EVDEV_DEVICES_H

#include <poll.h>
#include <stdbool.h>

#include "platform/buttons/button_batch.h"
#include "platform/buttons/evdev/system.h"

enum {
	EVDEV_DEVICES_MAX = BUTTON_HOLDERS_MAX,
	EVDEV_PATH_BYTES = 256,
	EVDEV_SCAN_MS = 1000 /* between two scans where inotify is missing */
};

struct evdev_device {
	char path[EVDEV_PATH_BYTES];
	char name[80];
	uint8_t key[EVDEV_KEY_BYTES]; /* a bit for each key that is down */
	/* A bit for each that was pressed together with Ctrl or Alt. */
	uint8_t shortcut[EVDEV_KEY_BYTES];
	bool down[BUTTON_COUNT]; /* one of the button's keys is down */
	uint8_t holder;          /* its number in the queue */
	bool dropped; /* events were lost; ignore the rest of this report */
};

struct button_source {
	struct log log;
	const struct evdev_system *system;
	struct evdev_keys keys;
	char wanted[EVDEV_PATH_BYTES]; /* a path, part of a name, or "" */
	struct evdev_device device[EVDEV_DEVICES_MAX];
	struct pollfd fd[EVDEV_DEVICES_MAX + 1]; /* fd[count] is inotify */
	int count;
	int inotify, watch; /* -1: not available */
	bool polled;        /* polled_ms is set */
	bool denied_logged;
	int64_t polled_ms, scan_ms; /* times of the last poll and next scan */
	struct button_batch batch;
};

/* Whether the user named the path of one device. */
bool evdev_devices_are_one(const struct button_source *source);

/* Opens the wanted devices that are not open yet. */
void evdev_devices_scan(struct button_source *source);

/* Watches the devices' folder through inotify, where the kernel has it. */
void evdev_devices_watch(struct button_source *source);

/*
 * Reads the devices whose fd[].revents are set into the batch, closes those
 * that were unplugged, and scans when the watched folder has changed.
 */
void evdev_devices_read(struct button_source *source, int64_t now_ms);

/* Closes the device of that index. The last device takes its index. */
void evdev_devices_close(struct button_source *source, int index);

#endif
