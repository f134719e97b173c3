/*
 * Buttons on keyboards and keypads. Devices may be plugged in at any time: the
 * driver watches their folder or, without inotify, scans it once a second.
 */
#include <errno.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <sys/inotify.h>
#include <unistd.h>

#include "platform/buttons/evdev/evdev_devices.h"

static void evdev_poll(struct button_source *source, int64_t now_ms,
	struct button_queue *queue)
{
	if (!source->polled) {
		source->polled = true;
		source->polled_ms = now_ms;
		source->scan_ms = now_ms + EVDEV_SCAN_MS;
	}
	source->fd[source->count] = (struct pollfd){
		.fd = source->inotify,
		.events = POLLIN,
	};
	if (poll(source->fd, (nfds_t)source->count + 1, 0) > 0) {
		evdev_devices_read(source, now_ms);
		button_batch_push(&source->batch, queue);
	}
	if (now_ms >= source->scan_ms &&
		(source->watch < 0 ||
			(evdev_devices_are_one(source) && source->count == 0))) {
		source->scan_ms = now_ms + EVDEV_SCAN_MS;
		evdev_devices_watch(source);
		evdev_devices_scan(source);
	}
	source->polled_ms = now_ms;
}

static void evdev_destroy(struct button_source *source)
{
	if (!source) {
		return;
	}
	while (source->count > 0) {
		evdev_devices_close(source, source->count - 1);
	}
	if (source->inotify >= 0) {
		close(source->inotify);
	}
	free(source);
}

/* Reads a comma-separated list of DEVICE and BUTTON=KEY. */
static int read_argument(const char *argument, struct evdev_keys *keys,
	char wanted[EVDEV_PATH_BYTES], const struct log *log)
{
	*keys = evdev_keys_default();
	wanted[0] = '\0';
	while (argument && *argument) {
		size_t length = strcspn(argument, ",");
		char item[EVDEV_PATH_BYTES];
		int error = 0;

		if (length >= sizeof(item)) {
			log_error(log,
				"evdev: a name may have at most %zu characters",
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
	char wanted[EVDEV_PATH_BYTES];

	return read_argument(argument, &keys, wanted, log);
}

static void warn_if_absent(const struct button_source *source)
{
	if (source->count > 0 || source->denied_logged) {
		return;
	}
	if (source->wanted[0]) {
		log_warning(&source->log,
			"evdev:%s: there is no such device yet: its buttons work when it is plugged in",
			source->wanted);
	} else {
		log_warning(&source->log,
			"evdev: there is no keyboard or keypad in %s yet: its buttons work when it is plugged in",
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
	evdev_devices_watch(source);
	evdev_devices_scan(source);
	warn_if_absent(source);
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
