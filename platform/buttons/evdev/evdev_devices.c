#include "platform/buttons/evdev/evdev_devices.h"

#include <dirent.h>
#include <errno.h>
#include <linux/input-event-codes.h>
#include <stdio.h>
#include <string.h>
#include <sys/inotify.h>
#include <unistd.h>

#include "platform/base/compiler.h"
#include "platform/buttons/device_access.h"
#include "platform/buttons/evdev/decode.h"
#include "platform/buttons/event_time.h"

enum {
	EVENTS_AT_ONCE = 24,
	READS_MAX = 32, /* of a device in a poll: one may never be empty */
	/* Changes of buttons by one read, and by the loss of a device. */
	READ_CHANGES = EVENTS_AT_ONCE + BUTTON_COUNT,
	LOSS_CHANGES = BUTTON_COUNT,
	/* Of the batch, for each device that has not been read in a poll. */
	SHARE = BUTTON_BATCH_CAPACITY / EVDEV_DEVICES_MAX
};

_Static_assert(READ_CHANGES + LOSS_CHANGES <= SHARE,
	"each device can be read once in a poll, and can be lost");

bool evdev_devices_are_one(const struct button_source *source)
{
	return source->wanted[0] == '/';
}

static bool has_button(
	const struct button_source *source, const uint8_t bits[EVDEV_KEY_BYTES])
{
	for (unsigned int code = 0; code < EVDEV_KEYS; code++) {
		if (evdev_key_bit(bits, code) &&
			evdev_keys_find(&source->keys, code) != BUTTON_COUNT) {
			return true;
		}
	}
	return false;
}

static bool is_open(const struct button_source *source, const char *path)
{
	for (int i = 0; i < source->count; i++) {
		if (strcmp(source->device[i].path, path) == 0) {
			return true;
		}
	}
	return false;
}

static bool is_wanted(const struct button_source *source,
	const struct evdev_description *description)
{
	if (source->wanted[0] && !evdev_devices_are_one(source) &&
		!strstr(description->name, source->wanted)) {
		return false;
	}
	return evdev_devices_are_one(source) ||
		has_button(source, description->keys);
}

/* A number that no open device has. */
static uint8_t free_holder(const struct button_source *source)
{
	bool used[EVDEV_DEVICES_MAX] = {false};
	uint8_t holder = 0;

	for (int i = 0; i < source->count; i++) {
		used[source->device[i].holder] = true;
	}
	while (used[holder]) {
		holder++;
	}
	return holder;
}

static void open_device(struct button_source *source, const char *path)
{
	struct evdev_description description;
	struct evdev_device *device = &source->device[source->count];
	int fd;

	if (source->count == EVDEV_DEVICES_MAX || is_open(source, path) ||
		strlen(path) >= sizeof(device->path)) {
		return;
	}
	fd = source->system->open(path);
	if ((fd == -EACCES || fd == -EPERM) && !source->denied_logged) {
		source->denied_logged = true;
		device_access_report_denied(&source->log, path);
	}
	if (fd < 0) {
		return;
	}
	if (source->system->describe(fd, &description) < 0 ||
		!is_wanted(source, &description)) {
		close(fd);
		return;
	}
	*device = (struct evdev_device){.holder = free_holder(source)};
	strcpy(device->path, path);
	memcpy(device->name, description.name, sizeof(device->name));
	device->name[sizeof(device->name) - 1] = '\0';
	source->fd[source->count++] = (struct pollfd){
		.fd = fd,
		.events = POLLIN,
	};
	log_note(&source->log, "%s: buttons of %s", path, device->name);
}

void evdev_devices_scan(struct button_source *source)
{
	DIR *directory;
	const struct dirent *entry;

	if (evdev_devices_are_one(source)) {
		open_device(source, source->wanted);
		return;
	}
	directory = opendir(source->system->directory);
	while (directory && (entry = readdir(directory))) {
		char path[EVDEV_PATH_BYTES];
		int length = snprintf(path, sizeof(path), "%s/%s",
			source->system->directory, entry->d_name);

		if (strncmp(entry->d_name, "event", 5) == 0 && length > 0 &&
			(size_t)length < sizeof(path)) {
			open_device(source, path);
		}
	}
	if (directory) {
		closedir(directory);
	}
}

/* Watches IN_ATTRIB, too: udev creates a device before it sets permissions. */
void evdev_devices_watch(struct button_source *source)
{
	if (source->inotify >= 0 && source->watch < 0) {
		source->watch = inotify_add_watch(source->inotify,
			source->system->directory, IN_CREATE | IN_ATTRIB);
	}
}

static void set_button(struct button_source *source, struct evdev_device *device,
	int64_t time_ms, enum button button, bool down)
{
	if (device->down[button] == down) {
		return;
	}
	device->down[button] = down;
	button_batch_add(&source->batch,
		(struct button_event){
			.time_ms = time_ms,
			.button = button,
			.down = down,
			.holder = device->holder,
		});
}

void evdev_devices_close(struct button_source *source, int index)
{
	close(source->fd[index].fd);
	source->count--;
	source->device[index] = source->device[source->count];
	source->fd[index] = source->fd[source->count];
}

static void lose_device(struct button_source *source, int index, int64_t now_ms)
{
	struct evdev_device *device = &source->device[index];

	log_warning(&source->log,
		"%s: %s was unplugged: its buttons work again when it is plugged in",
		device->path, device->name);
	for (int i = 0; i < BUTTON_COUNT; i++) {
		set_button(source, device, now_ms, (enum button)i, false);
	}
	evdev_devices_close(source, index);
	source->scan_ms = now_ms + EVDEV_SCAN_MS;
}

/*
 * Whether Ctrl or Alt is held on any keyboard, as the kernel sees it, too: the
 * keys that are pressed then switch consoles. A key that is a button is neither.
 */
static bool holds_modifier(const struct button_source *source)
{
	static const uint16_t modifiers[] = {
		KEY_LEFTCTRL, KEY_RIGHTCTRL, KEY_LEFTALT, KEY_RIGHTALT};

	for (size_t i = 0; i < ARRAY_COUNT(modifiers); i++) {
		if (evdev_keys_find(&source->keys, modifiers[i]) !=
			BUTTON_COUNT) {
			continue;
		}
		for (int k = 0; k < source->count; k++) {
			if (evdev_key_bit(source->device[k].key, modifiers[i])) {
				return true;
			}
		}
	}
	return false;
}

/* Takes over which keys are down. Those that are new may be shortcuts. */
static void set_keys(struct button_source *source, struct evdev_device *device,
	const uint8_t bits[EVDEV_KEY_BYTES])
{
	uint8_t pressed[EVDEV_KEY_BYTES];
	bool hides;

	for (int i = 0; i < EVDEV_KEY_BYTES; i++) {
		pressed[i] = (uint8_t)(bits[i] & ~device->key[i]);
		device->key[i] = bits[i];
	}
	hides = holds_modifier(source);
	for (int i = 0; i < EVDEV_KEY_BYTES; i++) {
		device->shortcut[i] = (uint8_t)(bits[i] &
			(device->shortcut[i] | (hides ? pressed[i] : 0)));
	}
}

/* Sets the buttons by the keys that are down: several may be one button. */
static void update_buttons(
	struct button_source *source, int index, int64_t time_ms)
{
	struct evdev_device *device = &source->device[index];
	bool down[BUTTON_COUNT + 1] = {false};

	for (unsigned int code = 0; code < EVDEV_KEYS; code++) {
		if (evdev_key_bit(device->key, code) &&
			!evdev_key_bit(device->shortcut, code)) {
			down[evdev_keys_find(&source->keys, code)] = true;
		}
	}
	for (int i = 0; i < BUTTON_COUNT; i++) {
		set_button(source, device, time_ms, (enum button)i, down[i]);
	}
}

/* After lost events the device is asked which keys are down. */
static void resynchronize(
	struct button_source *source, int index, int64_t time_ms)
{
	struct evdev_device *device = &source->device[index];
	uint8_t bits[EVDEV_KEY_BYTES];

	device->dropped = false;
	if (source->system->keys_down(source->fd[index].fd, bits) < 0) {
		return;
	}
	set_keys(source, device, bits);
	update_buttons(source, index, time_ms);
}

static void handle_event(struct button_source *source, int index,
	const struct evdev_event *event, int64_t time_ms)
{
	struct evdev_device *device = &source->device[index];

	if (event->type == EV_SYN && event->code == SYN_DROPPED) {
		device->dropped = true;
	} else if (device->dropped) {
		if (event->type == EV_SYN && event->code == SYN_REPORT) {
			resynchronize(source, index, time_ms);
		}
	} else if (event->type == EV_KEY && event->code < EVDEV_KEYS &&
		(event->value == 0 || event->value == 1)) {
		uint8_t bit = (uint8_t)(1u << event->code % 8);
		uint8_t bits[EVDEV_KEY_BYTES];

		memcpy(bits, device->key, sizeof(bits));
		bits[event->code / 8] &= (uint8_t)~bit;
		bits[event->code / 8] |= event->value ? bit : 0;
		set_keys(source, device, bits);
		update_buttons(source, index, time_ms);
	}
}

/* Reads some events of a device. Returns what system.read() returns. */
static ssize_t read_some(struct button_source *source, int index,
	const struct event_clocks *clocks, int64_t now_ms)
{
	unsigned char bytes[EVENTS_AT_ONCE * EVDEV_SIZE];
	ssize_t count = source->system->read(
		source->fd[index].fd, bytes, sizeof(bytes));

	for (ssize_t at = 0; at + EVDEV_SIZE <= count; at += EVDEV_SIZE) {
		struct evdev_event event = evdev_decode(bytes + at, EVDEV_SIZE);

		handle_event(source, index, &event,
			event_time_ms(clocks, event.stamp_ns,
				source->polled_ms + 1, now_ms));
	}
	return count;
}

/*
 * Whether the batch has room for another read of a device without taking the
 * share of the devices with lower indices, which are read after it.
 */
static bool has_room(const struct button_source *source, int index)
{
	return source->batch.count + READ_CHANGES + LOSS_CHANGES <=
		BUTTON_BATCH_CAPACITY - index * SHARE;
}

/*
 * Reads the waiting events of a device, which may be many: the sticks of a
 * gamepad move a thousand times a second. What there is no room for is read in
 * the next poll. Returns false if the device is gone.
 */
static bool read_device(struct button_source *source, int index,
	const struct event_clocks *clocks, int64_t now_ms)
{
	ssize_t count = 1;

	for (int i = 0; i < READS_MAX && count > 0 && has_room(source, index);
		i++) {
		count = read_some(source, index, clocks, now_ms);
	}
	return count > 0 || count == -EAGAIN || count == -EINTR;
}

static void read_inotify(struct button_source *source)
{
	union {
		struct inotify_event event;
		char bytes[4096];
	} buffer;
	ssize_t count = read(source->inotify, &buffer, sizeof(buffer));
	ssize_t at = 0;

	while (at + (ssize_t)sizeof(buffer.event) <= count) {
		struct inotify_event event;

		memcpy(&event, buffer.bytes + at, sizeof(event));
		if (event.mask & IN_IGNORED) {
			source->watch = -1;
		}
		at += (ssize_t)sizeof(event) + (ssize_t)event.len;
	}
	evdev_devices_scan(source);
}

void evdev_devices_read(struct button_source *source, int64_t now_ms)
{
	struct event_clocks clocks = event_clocks_now();
	bool changed = source->fd[source->count].revents;

	for (int i = source->count - 1; i >= 0; i--) {
		if (source->fd[i].revents &&
			!read_device(source, i, &clocks, now_ms)) {
			lose_device(source, i, now_ms);
		}
	}
	if (changed) {
		read_inotify(source);
	}
}
