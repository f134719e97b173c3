/* Calls of files, devices, threads and libraries that fail. */
#include "faults.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

int faults_open(int folder, const char *path, int flags, mode_t mode)
{
	FAULTS_NEXT(openat)

	if (faults_next_fails(OPEN)) {
		errno = flags & O_CREAT ? ENOSPC : EMFILE;
		return -1;
	}
	return next(folder, path, flags, mode);
}

static mode_t mode_of(int flags, va_list arguments)
{
	return flags & (O_CREAT | O_TMPFILE) ? va_arg(arguments, mode_t) : 0;
}

#define OPEN_FUNCTION(name)                                      \
	int name(const char *path, int flags, ...)               \
	{                                                        \
		va_list arguments;                               \
		mode_t mode;                                     \
                                                                 \
		va_start(arguments, flags);                      \
		mode = mode_of(flags, arguments);                \
		va_end(arguments);                               \
		return faults_open(AT_FDCWD, path, flags, mode); \
	}

OPEN_FUNCTION(open)
OPEN_FUNCTION(open64)
int __open_2(const char *path, int flags);
int __open64_2(const char *path, int flags);

/* What open() becomes with _FORTIFY_SOURCE. */
int __open_2(const char *path, int flags)
{
	return faults_open(AT_FDCWD, path, flags, 0);
}

int __open64_2(const char *path, int flags)
{
	return faults_open(AT_FDCWD, path, flags, 0);
}

int fstat(int fd, struct stat *status)
{
	FAULTS_NEXT(fstat)

	if (faults_next_fails(STAT)) {
		errno = EIO;
		return -1;
	}
	return next(fd, status);
}

int fstat64(int fd, struct stat64 *status)
{
	FAULTS_NEXT(fstat64)

	if (faults_next_fails(STAT)) {
		errno = EIO;
		return -1;
	}
	return next(fd, status);
}

ssize_t read(int fd, void *bytes, size_t size)
{
	FAULTS_NEXT(read)

	if (faults_next_fails(READ)) {
		errno = EIO;
		return -1;
	}
	return next(fd, bytes,
		faults_next_fails(READ_SHORT) && size > 1 ? 1 : size);
}

ssize_t __read_chk(int fd, void *bytes, size_t size, size_t room);

ssize_t __read_chk(int fd, void *bytes, size_t size, size_t room)
{
	if (size > room) {
		abort();
	}
	return read(fd, bytes, size);
}

/* A sentence about a failure must not become a failure. */
ssize_t write(int fd, const void *bytes, size_t size)
{
	FAULTS_NEXT(write)
	ssize_t written;

	if (fd == STDERR_FILENO) {
		return next(fd, bytes, size);
	}
	if (faults_next_fails(WRITE) || (faults_disk_bytes == 0 && size > 0)) {
		errno = ENOSPC;
		return -1;
	}
	if (faults_disk_bytes >= 0 && size > (size_t)faults_disk_bytes) {
		size = (size_t)faults_disk_bytes;
	}
	written = next(fd, bytes,
		faults_next_fails(WRITE_SHORT) && size > 1 ? 1 : size);
	if (faults_disk_bytes >= 0 && written > 0) {
		faults_disk_bytes -= written;
	}
	return written;
}

int fsync(int fd)
{
	FAULTS_NEXT(fsync)

	if (faults_next_fails(FSYNC)) {
		errno = EIO;
		return -1;
	}
	return next(fd);
}

/* Closes the descriptor in any case, as Linux does. */
int close(int fd)
{
	FAULTS_NEXT(close)
	bool fault = faults_next_fails(CLOSE);
	int result = next(fd);

	if (fault) {
		errno = EIO;
		return -1;
	}
	return result;
}

int rename(const char *from, const char *to)
{
	FAULTS_NEXT(rename)

	if (faults_next_fails(RENAME)) {
		errno = EIO;
		return -1;
	}
	return next(from, to);
}

#define MMAP_FUNCTION(name, offset_type)                                     \
	void *name(void *at, size_t size, int protection, int flags, int fd, \
		offset_type offset)                                          \
	{                                                                    \
		FAULTS_NEXT(name)                                            \
                                                                             \
		if (faults_next_fails(MMAP)) {                               \
			errno = ENOMEM;                                      \
			return MAP_FAILED;                                   \
		}                                                            \
		return next(at, size, protection, flags, fd, offset);        \
	}

MMAP_FUNCTION(mmap, off_t)
MMAP_FUNCTION(mmap64, off64_t)

int ioctl(int fd, unsigned long request, ...)
{
	FAULTS_NEXT(ioctl)
	va_list arguments;
	void *argument;

	va_start(arguments, request);
	argument = va_arg(arguments, void *);
	va_end(arguments);
	if (faults_next_fails(IOCTL)) {
		errno = EIO;
		return -1;
	}
	return next(fd, request, argument);
}

int pthread_create(pthread_t *thread, const pthread_attr_t *attributes,
	void *(*run)(void *), void *user)
{
	FAULTS_NEXT(pthread_create)

	return faults_next_fails(THREAD) ? EAGAIN
					 : next(thread, attributes, run, user);
}

/* dlerror() then names a library that does not exist. */
void *dlopen(const char *path, int flags)
{
	FAULTS_NEXT(dlopen)

	if (faults_watches(__builtin_return_address(0)) &&
		faults_next_fails(LIBRARY)) {
		path = "libfault.so";
	}
	return next(path, flags);
}
