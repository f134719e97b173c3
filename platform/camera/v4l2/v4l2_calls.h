/*
 * The system calls that a V4L2 device is used through, so that tests can play
 * a device.
 */
#ifndef PLATFORM_CAMERA_V4L2_V4L2_CALLS_H
#define PLATFORM_CAMERA_V4L2_V4L2_CALLS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Errors are -errno; what signals interrupt is begun again. */
struct v4l2_calls {
	/* Whether there is such a device; asks no driver. */
	bool (*exists)(void *user, const char *path);
	/* For reading and writing, without blocking: a descriptor. */
	int (*open)(void *user, const char *path);
	void (*close)(void *user, int fd);
	int (*ioctl)(void *user, int fd, unsigned long request, void *argument);
	/* Shared, for reading and writing; NULL when it fails. */
	void *(*map)(void *user, int fd, size_t length, uint32_t offset);
	void (*unmap)(void *user, void *address, size_t length);
	/* 1 when there may be a picture, 0 when the time is over. */
	int (*wait)(void *user, int fd, int timeout_ms);
	/* A clock that only goes forward. */
	int64_t (*now_ms)(void *user);
	void *user; /* passed through */
};

/* The machine's. */
extern const struct v4l2_calls v4l2_calls_real;

#endif
