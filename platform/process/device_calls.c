#include "platform/process/device_calls.h"

#include <errno.h>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

static int system_open(const char *path, int flags)
{
	return open(path, flags);
}

static int system_ioctl(int fd, unsigned long request, void *argument)
{
	return ioctl(fd, request, argument);
}

static void *system_map(int fd, size_t size, off_t offset)
{
	return mmap(NULL, size, PROT_READ | PROT_WRITE, MAP_SHARED, fd, offset);
}

const struct device_calls device_calls_system = {
	.open = system_open,
	.close = close,
	.write = write,
	.ioctl = system_ioctl,
	.map = system_map,
	.unmap = munmap,
};

int device_control(const struct device_calls *calls, int fd,
	unsigned long request, void *argument)
{
	int result;

	do {
		result = calls->ioctl(fd, request, argument);
	} while (result < 0 && errno == EINTR);
	return result;
}
