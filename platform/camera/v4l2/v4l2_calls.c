#include "platform/camera/v4l2/v4l2_calls.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <unistd.h>

#include "platform/process/clock.h"

static bool real_exists(void *user, const char *path)
{
	(void)user;
	return access(path, F_OK) == 0;
}

static int real_open(void *user, const char *path)
{
	int fd;

	(void)user;
	do {
		fd = open(path, O_RDWR | O_NONBLOCK | O_CLOEXEC);
	} while (fd < 0 && errno == EINTR);
	return fd < 0 ? -errno : fd;
}

/* Not counted: the cameras of tests/board/test_camera.py come here. */
static void real_close(void *user, int fd)
{
	(void)user;
	close(fd);
}

static int real_ioctl(void *user, int fd, unsigned long request, void *argument)
{
	int result;

	(void)user;
	do {
		result = ioctl(fd, request, argument);
	} while (result < 0 && errno == EINTR);
	return result < 0 ? -errno : 0;
}

static void *real_map(void *user, int fd, size_t length, uint32_t offset)
{
	void *address = mmap(NULL, length, PROT_READ | PROT_WRITE, MAP_SHARED,
		fd, (off_t)offset);

	(void)user;
	return address == MAP_FAILED ? NULL : address;
}

static void real_unmap(void *user, void *address, size_t length)
{
	(void)user;
	munmap(address, length);
}

static int real_wait(void *user, int fd, int timeout_ms)
{
	struct pollfd waited = {.fd = fd, .events = POLLIN};
	int result = poll(&waited, 1, timeout_ms);

	(void)user;
	if (result < 0) {
		return errno == EINTR ? 0 : -errno;
	}
	return result;
}

static int64_t real_now_ms(void *user)
{
	(void)user;
	return clock_monotonic_ms();
}

const struct v4l2_calls v4l2_calls_real = {
	.exists = real_exists,
	.open = real_open,
	.close = real_close,
	.ioctl = real_ioctl,
	.map = real_map,
	.unmap = real_unmap,
	.wait = real_wait,
	.now_ms = real_now_ms,
};
