/*
 * The system calls that drivers use device files through, as a table, so that
 * tests can replace a device. Each call returns what the system call of that
 * name returns, and sets errno.
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
	/* mmap() with MAP_SHARED for reading and writing. */
	void *(*map)(int fd, size_t size, off_t offset);
	int (*unmap)(void *address, size_t size);
};

/* The calls of the operating system. */
extern const struct device_calls device_calls_system;

/* Calls ioctl(), and repeats it while a signal interrupts it (EINTR). */
int device_control(const struct device_calls *calls, int fd,
	unsigned long request, void *argument);

#endif
