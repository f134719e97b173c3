#include "platform/buttons/evdev/system.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/input.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

static int open_device(const char *path)
{
	int fd = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);

	return fd < 0 ? -errno : fd;
}

/* Not counted: the keyboards of tests/board/test_keys.py come here. */
static int describe(int fd, struct evdev_description *out)
{
	int clock = CLOCK_MONOTONIC;

	memset(out, 0, sizeof(*out));
	if (ioctl(fd, EVIOCGBIT(EV_KEY, sizeof(out->keys)), out->keys) < 0) {
		return -errno;
	}
	if (ioctl(fd, EVIOCGNAME(sizeof(out->name) - 1), out->name) < 0) {
		strcpy(out->name, "no name");
	}
	/* On failure the stamps are real time, which event_time.c handles. */
	(void)ioctl(fd, EVIOCSCLOCKID, &clock);
	return 0;
}

static int keys_down(int fd, uint8_t bits[EVDEV_KEY_BYTES])
{
	memset(bits, 0, EVDEV_KEY_BYTES);
	return ioctl(fd, EVIOCGKEY(EVDEV_KEY_BYTES), bits) < 0 ? -errno : 0;
}

static ssize_t read_device(int fd, void *bytes, size_t size)
{
	ssize_t count = read(fd, bytes, size);

	return count < 0 ? -errno : count;
}

const struct evdev_system evdev_linux = {
	.directory = "/dev/input",
	.open = open_device,
	.describe = describe,
	.keys_down = keys_down,
	.read = read_device,
};
