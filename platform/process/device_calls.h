/*
 * What drivers of device files ask of the system, so that tests can stand in
 * for a device. All return what their namesakes return, with errno.
 */
#ifndef PLATFORM_PROCESS_DEVICE_CALLS_H
#define PLATFORM_PROCESS_DEVICE_CALLS_H

#include <stddef.h>
#include <sys/types.h>

struct device_calls {
	int (*open)(const char *path, int flags);
	int (*close)(int fd);
	ssize_t (*write)(int fd, const void *data, size_t size);
	int (*ioctl)(int fd, unsigned long request, void *argument);
	/* Shared, to be read and written; MAP_FAILED when it fails. */
	void *(*map)(int fd, size_t size, off_t offset);
	int (*unmap)(void *address, size_t size);
};

/* The system's own. */
extern const struct device_calls device_calls_system;

/* ioctl() again as long as a signal interrupts it. */
int device_control(const struct device_calls *calls, int fd,
	unsigned long request, void *argument);

#endif
