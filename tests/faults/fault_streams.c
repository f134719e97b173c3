/*
 * Streams whose reads and writes can fail: the C library's own call no function
 * that could be replaced.
 */
#include "faults.h"

#include <fcntl.h>
#include <string.h>
#include <unistd.h>

static ssize_t read_cookie(void *cookie, char *bytes, size_t size)
{
	return read((int)(long)cookie, bytes, size);
}

static ssize_t write_cookie(void *cookie, const char *bytes, size_t size)
{
	size_t done = 0;

	while (done < size) {
		ssize_t count =
			write((int)(long)cookie, bytes + done, size - done);

		if (count <= 0) {
			return (ssize_t)done;
		}
		done += (size_t)count;
	}
	return (ssize_t)size;
}

static int close_cookie(void *cookie)
{
	return close((int)(long)cookie);
}

FILE *faults_open_stream(const char *path, const char *mode)
{
	int fd = mode[0] == 'r' && !strchr(mode, '+')
		? faults_open(AT_FDCWD, path, O_RDONLY | O_CLOEXEC, 0)
		: faults_open(AT_FDCWD, path,
			  O_WRONLY | O_CREAT | O_CLOEXEC |
				  (mode[0] == 'a' ? O_APPEND : O_TRUNC),
			  0666);
	FILE *file;

	if (fd < 0) {
		return NULL;
	}
	file = fopencookie((void *)(long)fd, mode,
		(cookie_io_functions_t){.read = read_cookie,
			.write = write_cookie,
			.close = close_cookie});
	if (!file) {
		close(fd);
	}
	return file;
}

FILE *fopen(const char *path, const char *mode)
{
	return faults_open_stream(path, mode);
}

FILE *fopen64(const char *path, const char *mode)
{
	return faults_open_stream(path, mode);
}

void faults_watch_stdout(void)
{
	stdout = fopencookie((void *)STDOUT_FILENO, "w",
		(cookie_io_functions_t){.write = write_cookie});
}
