/*
 * The system calls of the V4L2 driver, as a table that tests can replace.
 */
#ifndef PLATFORM_CAMERA_V4L2_V4L2_CALLS_H
#define PLATFORM_CAMERA_V4L2_V4L2_CALLS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/*
 * Functions that return int return -errno when they fail. Calls that a signal
 * interrupts are repeated.
 */
struct v4l2_calls {
	/* Whether the device node exists. Does not call its driver. */
	bool (*exists)(void *user, const char *path);
	/* Opens a device with O_RDWR | O_NONBLOCK; returns the descriptor. */
	int (*open)(void *user, const char *path);
	void (*close)(void *user, int fd);
	int (*ioctl)(void *user, int fd, unsigned long request, void *argument);
	/* Maps a buffer, shared, for reading and writing; NULL on failure. */
	void *(*map)(void *user, int fd, size_t length, uint32_t offset);
	void (*unmap)(void *user, void *address, size_t length);
	/* Returns 1 when there may be a picture, 0 after timeout_ms. */
	int (*wait)(void *user, int fd, int timeout_ms);
	/* The time of a monotonic clock. */
	int64_t (*now_ms)(void *user);
	void *user; /* passed to every call */
};

/* The calls of the operating system. */
extern const struct v4l2_calls v4l2_calls_real;

#endif
