/*
 * Buttons on keyboards and keypads. Devices come and go: a watch on their
 * folder tells; where there is none, a look once a second.
 */
#include <dirent.h>
#include <errno.h>
#include <linux/input-event-codes.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/inotify.h>
#include <unistd.h>

#include "platform/buttons/button_batch.h"
#include "platform/buttons/device_access.h"
#include "platform/buttons/evdev/decode.h"
#include "platform/buttons/evdev/system.h"
#include "platform/buttons/event_time.h"

enum {
	DEVICES_MAX = 16,
	PATH_BYTES = 256,
	EVENTS_AT_ONCE = 24,
	LOOK_AGAIN_MS = 1000
};

struct device {
	char path[PATH_BYTES];
	char name[80];
	bool held[BUTTON_COUNT];
	bool dropped; /* events were lost: wait for the report's end */
};

struct button_source {
	struct log log;
	const struct evdev_system *system;
	struct evdev_keys keys;
	char wanted[PATH_BYTES]; /* a path, part of a name, or "": all */
	struct device device[DEVICES_MAX];
	struct pollfd fd[DEVICES_MAX + 1]; /* [count] is inotify */
	int count;
	int inotify, watch; /* -1: none */
	bool polled;        /* polled_ms is set */
	bool denied_said;
	int64_t polled_ms, look_ms;
	struct button_batch batch;
};

static bool wants_path(const struct button_source *source)
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
	if (source->wanted[0] && !wants_path(source) &&
		!strstr(description->name, source->wanted)) {
		return false;
	}
	return wants_path(source) || has_button(source, description->keys);
}

static void open_device(struct button_source *source, const char *path)
{
	struct evdev_description description;
	struct device *device = &source->device[source->count];
	int fd;

	if (source->count == DEVICES_MAX || is_open(source, path) ||
		strlen(path) >= sizeof(device->path)) {
		return;
	}
	fd = source->system->open(path);
	if ((fd == -EACCES || fd == -EPERM) && !source->denied_said) {
		source->denied_said = true;
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
	*device = (struct device){.dropped = false};
	strcpy(device->path, path);
	memcpy(device->name, description.name, sizeof(device->name));
	device->name[sizeof(device->name) - 1] = '\0';
	source->fd[source->count++] = (struct pollfd){
		.fd = fd,
		.events = POLLIN,
	};
	log_note(&source->log, "%s: buttons of %s", path, device->name);
}

static void look_around(struct button_source *source)
{
	DIR *directory;
	const struct dirent *entry;

	if (wants_path(source)) {
		open_device(source, source->wanted);
		return;
	}
	directory = opendir(source->system->directory);
	while (directory && (entry = readdir(directory))) {
		char path[PATH_BYTES];
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

/* Attributes change when the system gives a new device its permissions. */
static void watch_directory(struct button_source *source)
{
	if (source->inotify >= 0 && source->watch < 0) {
		source->watch = inotify_add_watch(source->inotify,
			source->system->directory, IN_CREATE | IN_ATTRIB);
	}
}

static void hold(struct button_source *source, struct device *device,
	int64_t time_ms, enum button button, bool down)
{
	if (device->held[button] == down) {
		return;
	}
	device->held[button] = down;
	button_batch_add(&source->batch,
		(struct button_event){
			.time_ms = time_ms, .button = button, .down = down});
}

static void close_device(struct button_source *source, int index)
{
	close(source->fd[index].fd);
	source->count--;
	source->device[index] = source->device[source->count];
	source->fd[index] = source->fd[source->count];
}

static void lose_device(struct button_source *source, int index, int64_t now_ms)
{
	struct device *device = &source->device[index];

	log_warning(&source->log,
		"%s: %s is gone: its buttons work again when it is back",
		device->path, device->name);
	for (int i = 0; i < BUTTON_COUNT; i++) {
		hold(source, device, now_ms, (enum button)i, false);
	}
	close_device(source, index);
	source->look_ms = now_ms + LOOK_AGAIN_MS;
}

/* Events were lost: what is down now is asked for. */
static void catch_up(struct button_source *source, int index, int64_t time_ms)
{
	struct device *device = &source->device[index];
	bool down[BUTTON_COUNT] = {false};
	uint8_t bits[EVDEV_KEY_BYTES];

	device->dropped = false;
	if (source->system->keys_down(source->fd[index].fd, bits) < 0) {
		return;
	}
	for (unsigned int code = 0; code < EVDEV_KEYS; code++) {
		enum button button = evdev_keys_find(&source->keys, code);

		if (button != BUTTON_COUNT && evdev_key_bit(bits, code)) {
			down[button] = true;
		}
	}
	for (int i = 0; i < BUTTON_COUNT; i++) {
		hold(source, device, time_ms, (enum button)i, down[i]);
	}
}

static void take_event(struct button_source *source, int index,
	const struct evdev_event *event, int64_t time_ms)
{
	struct device *device = &source->device[index];

	if (event->type == EV_SYN && event->code == SYN_DROPPED) {
		device->dropped = true;
	} else if (device->dropped) {
		if (event->type == EV_SYN && event->code == SYN_REPORT) {
			catch_up(source, index, time_ms);
		}
	} else if (event->type == EV_KEY &&
		(event->value == 0 || event->value == 1)) {
		enum button button = evdev_keys_find(&source->keys, event->code);

		if (button != BUTTON_COUNT) {
			hold(source, device, time_ms, button, event->value);
		}
	}
}

/* False when the device is gone. */
static bool read_device(struct button_source *source, int index,
	const struct event_clocks *clocks, int64_t now_ms)
{
	unsigned char bytes[EVENTS_AT_ONCE * EVDEV_SIZE];
	ssize_t count = source->system->read(
		source->fd[index].fd, bytes, sizeof(bytes));

	if (count == -EAGAIN || count == -EINTR) {
		return true;
	}
	for (ssize_t at = 0; at + EVDEV_SIZE <= count; at += EVDEV_SIZE) {
		struct evdev_event event = evdev_decode(bytes + at, EVDEV_SIZE);

		take_event(source, index, &event,
			event_time_ms(clocks, event.stamp_ns,
				source->polled_ms + 1, now_ms));
	}
	return count > 0;
}

static void read_watch(struct button_source *source)
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
	look_around(source);
}

static void read_all(struct button_source *source, int64_t now_ms)
{
	struct event_clocks clocks = event_clocks_now();
	bool news = source->fd[source->count].revents;

	for (int i = source->count - 1; i >= 0; i--) {
		if (source->fd[i].revents &&
			!read_device(source, i, &clocks, now_ms)) {
			lose_device(source, i, now_ms);
		}
	}
	if (news) {
		read_watch(source);
	}
}

static void evdev_poll(struct button_source *source, int64_t now_ms,
	struct button_queue *queue)
{
	if (!source->polled) {
		source->polled = true;
		source->polled_ms = now_ms;
		source->look_ms = now_ms + LOOK_AGAIN_MS;
	}
	source->fd[source->count] = (struct pollfd){
		.fd = source->inotify,
		.events = POLLIN,
	};
	if (poll(source->fd, (nfds_t)source->count + 1, 0) > 0) {
		read_all(source, now_ms);
		button_batch_push(&source->batch, queue);
	}
	if (now_ms >= source->look_ms &&
		(source->watch < 0 ||
			(wants_path(source) && source->count == 0))) {
		source->look_ms = now_ms + LOOK_AGAIN_MS;
		watch_directory(source);
		look_around(source);
	}
	source->polled_ms = now_ms;
}

static void evdev_destroy(struct button_source *source)
{
	if (!source) {
		return;
	}
	while (source->count > 0) {
		close_device(source, source->count - 1);
	}
	if (source->inotify >= 0) {
		close(source->inotify);
	}
	free(source);
}

/* "DEVICE", "BUTTON=KEY" and more of the latter, parted by commas. */
static int read_argument(const char *argument, struct evdev_keys *keys,
	char wanted[PATH_BYTES], const struct log *log)
{
	*keys = evdev_keys_default();
	wanted[0] = '\0';
	while (argument && *argument) {
		size_t length = strcspn(argument, ",");
		char item[PATH_BYTES];
		int error = 0;

		if (length >= sizeof(item)) {
			log_error(log, "evdev: a name of more than %zu letters",
				sizeof(item) - 1);
			return -EINVAL;
		}
		memcpy(item, argument, length);
		item[length] = '\0';
		if (strchr(item, '=')) {
			error = evdev_keys_read(keys, item, log);
		} else {
			memcpy(wanted, item, length + 1);
		}
		if (error) {
			return error;
		}
		argument += length + (argument[length] == ',');
	}
	return 0;
}

static int evdev_check(const char *argument, const struct log *log)
{
	struct evdev_keys keys;
	char wanted[PATH_BYTES];

	return read_argument(argument, &keys, wanted, log);
}

static void say_absent(const struct button_source *source)
{
	if (source->count > 0 || source->denied_said) {
		return;
	}
	if (source->wanted[0]) {
		log_warning(&source->log,
			"evdev:%s: no such device yet: its buttons work when "
			"it is plugged in",
			source->wanted);
	} else {
		log_warning(&source->log,
			"evdev: no keyboard or keypad in %s yet: its buttons "
			"work when it is plugged in",
			source->system->directory);
	}
}

int evdev_create_on(const struct evdev_system *system, const char *argument,
	const struct log *log, struct button_source **out)
{
	struct button_source *source = calloc(1, sizeof(*source));
	int error;

	if (!source) {
		log_error(log, "evdev: out of memory");
		return -ENOMEM;
	}
	error = read_argument(argument, &source->keys, source->wanted, log);
	if (error) {
		free(source);
		return error;
	}
	source->log = *log;
	source->system = system;
	source->watch = -1;
	source->inotify = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
	watch_directory(source);
	look_around(source);
	say_absent(source);
	*out = source;
	return 0;
}

static int evdev_create(
	const char *argument, const struct log *log, struct button_source **out)
{
	return evdev_create_on(&evdev_linux, argument, log, out);
}

static void evdev_survey(const struct survey *survey)
{
	evdev_survey_on(&evdev_linux, survey);
}

const struct button_driver button_driver_evdev = {
	.name = "evdev",
	.summary = "evdev[:DEVICE][,BUTTON=KEY...], keyboards and keypads",
	.check = evdev_check,
	.create = evdev_create,
	.poll = evdev_poll,
	.destroy = evdev_destroy,
	.survey = evdev_survey,
};
