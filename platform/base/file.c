#include "platform/base/file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
	PATH_ROOM = 1024
};

bool file_exists(const char *path)
{
	struct stat status;

	return stat(path, &status) == 0;
}

static int read_all(int fd, uint8_t *data, size_t size)
{
	size_t done = 0;

	while (done < size) {
		ssize_t count = read(fd, data + done, size - done);

		if (count < 0 && errno == EINTR) {
			continue;
		}
		if (count < 0) {
			return -errno;
		}
		if (count == 0) {
			return -EIO;
		}
		done += (size_t)count;
	}
	return 0;
}

/* The size of an open regular file, or -errno after a sentence. */
static int check_size(int fd, const char *path, size_t limit_bytes,
	const struct log *log, size_t *size)
{
	struct stat status;

	if (fstat(fd, &status) != 0) {
		int error = -errno;

		log_error(log, "%s: %s", path, strerror(-error));
		return error;
	}
	if (!S_ISREG(status.st_mode)) {
		log_error(log, "%s: %s, not a file", path,
			S_ISDIR(status.st_mode) ? "a folder" : "a device");
		return -EINVAL;
	}
	if ((uint64_t)status.st_size > limit_bytes) {
		log_error(log, "%s: larger than %zu MiB", path,
			limit_bytes >> 20);
		return -EFBIG;
	}
	*size = (size_t)status.st_size;
	return 0;
}

int file_read(const char *path, size_t limit_bytes, const struct log *log,
	uint8_t **data, size_t *size)
{
	uint8_t *bytes = NULL;
	int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
	int error;

	if (fd < 0) {
		error = -errno;
		log_error(log, "%s: %s", path, strerror(-error));
		return error;
	}
	error = check_size(fd, path, limit_bytes, log, size);
	if (error) {
		goto out;
	}
	bytes = malloc(*size + 1);
	if (!bytes) {
		error = -ENOMEM;
		log_error(log, "%s: not enough memory to read it", path);
		goto out;
	}
	error = read_all(fd, bytes, *size);
	if (error) {
		log_error(log, "%s: reading fails: %s", path, strerror(-error));
		free(bytes);
		goto out;
	}
	bytes[*size] = 0;
	*data = bytes;
out:
	close(fd);
	return error;
}

/* "FOLDER/NAME" if it is there; FOLDER is given with its length. */
static bool try_path(const char *folder, int length, const char *below,
	const char *name, char *path, size_t size)
{
	int needed =
		snprintf(path, size, "%.*s%s/%s", length, folder, below, name);

	return needed > 0 && (size_t)needed < size && file_exists(path);
}

int file_find_asset(
	const char *name, const struct log *log, char *path, size_t size)
{
	const char *folder = getenv("LIMBER_ASSETS");
	char program[PATH_ROOM];
	ssize_t length =
		readlink("/proc/self/exe", program, sizeof(program) - 1);

	if (folder &&
		try_path(folder, (int)strlen(folder), "", name, path, size)) {
		return 0;
	}
	/* From build/host/limber up, whatever the depth. */
	while (length > 0) {
		while (length > 0 && program[length - 1] != '/') {
			length--;
		}
		if (length > 0) {
			length--;
		}
		if (try_path(program, (int)length, "/assets", name, path, size) ||
			try_path(program, (int)length, "/share/limber", name,
				path, size)) {
			return 0;
		}
	}
	log_error(log,
		"%s: not found: set LIMBER_ASSETS to the folder that "
		"holds limber's models",
		name);
	return -ENOENT;
}
