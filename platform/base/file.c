#define _GNU_SOURCE /* statx() */

#include "platform/base/file.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

bool file_exists(const char *path)
{
	struct stat status;

	return stat(path, &status) == 0;
}

enum {
	NONE_YET = 256 /* differs from every byte and from EOF */
};

/*
 * Reads the first byte of a non-blocking pipe. Returns EOF if no program has
 * opened the pipe for writing, or NONE_YET if nothing has been written yet.
 */
static int first_of_pipe(int fd)
{
	unsigned char byte;
	ssize_t count = read(fd, &byte, 1);

	return count > 0 ? byte : count == 0 ? EOF : NONE_YET;
}

FILE *file_open(const char *path)
{
	int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
	struct stat status;
	FILE *file = NULL;
	int first = NONE_YET;

	if (fd < 0) {
		return NULL;
	}
	if (fstat(fd, &status) == 0 && S_ISFIFO(status.st_mode)) {
		first = first_of_pipe(fd);
	}
	if (first == EOF) {
		errno = EPIPE;
	} else if (fcntl(fd, F_SETFL, 0) == 0) {
		file = fdopen(fd, "r");
	}
	if (!file) {
		int error = errno;

		close(fd);
		errno = error;
	} else {
		file_note_read(fd);
		if (first != NONE_YET) {
			ungetc(first, file);
		}
	}
	return file;
}

const char *file_open_advice(int error)
{
	switch (error) {
	case ENOENT:
	case ENOTDIR:
		return ": check the name and its folder";
	case EACCES:
	case EPERM:
		return ": let this user read it and enter its folder";
	case ELOOP:
		return ": give the name of the file itself";
	case ENAMETOOLONG:
		return ": give a shorter name";
	case EPIPE:
		return ": start the program that writes to it first";
	default:
		return "";
	}
}

FILE *file_open_logged(const char *path, const struct log *log)
{
	FILE *file = file_open(path);
	int error = errno;

	if (!file) {
		log_error(log, "%s: cannot be read: %s%s", path,
			strerror(error), file_open_advice(error));
		errno = error;
	}
	return file;
}

/* A file system may give the inode of a deleted file to a new one. */
struct identity {
	uint64_t inode;
	int64_t born_ns; /* 0 where the file system does not tell */
	uint32_t major, minor;
};

static pthread_mutex_t noted_lock = PTHREAD_MUTEX_INITIALIZER;
static struct identity noted[FILES_NOTED];
static unsigned noted_count; /* ever; the oldest ones are overwritten */

/* Of the file at path or, if path is "", of the open file. */
static bool identify(int fd, const char *path, struct identity *out)
{
	struct statx status;

	if (statx(fd, path, AT_EMPTY_PATH, STATX_INO | STATX_BTIME, &status) !=
		0) {
		return false;
	}
	*out = (struct identity){
		.inode = status.stx_ino,
		.major = status.stx_dev_major,
		.minor = status.stx_dev_minor,
	};
	if (status.stx_mask & STATX_BTIME) {
		out->born_ns = status.stx_btime.tv_sec * 1000000000 +
			status.stx_btime.tv_nsec;
	}
	return true;
}

/* The caller holds the lock. */
static bool is_noted(const struct identity *file)
{
	for (unsigned i = 0; i < FILES_NOTED && i < noted_count; i++) {
		if (memcmp(&noted[i], file, sizeof(*file)) == 0) {
			return true;
		}
	}
	return false;
}

void file_note_read(int fd)
{
	struct identity file;

	if (!identify(fd, "", &file)) {
		return;
	}
	pthread_mutex_lock(&noted_lock);
	if (!is_noted(&file)) {
		memcpy(&noted[noted_count++ % FILES_NOTED], &file, sizeof(file));
	}
	pthread_mutex_unlock(&noted_lock);
}

bool file_was_read(const char *path)
{
	struct identity file;
	bool found;

	if (!identify(AT_FDCWD, path, &file)) {
		return false;
	}
	pthread_mutex_lock(&noted_lock);
	found = is_noted(&file);
	pthread_mutex_unlock(&noted_lock);
	return found;
}

/* FNV-1a, with the lowest bit set so that it is never 0. */
uint64_t file_stamp(const char *path)
{
	struct stat status;
	uint64_t parts[4], stamp = 14695981039346656037u;

	if (stat(path, &status) != 0) {
		return 0;
	}
	parts[0] = (uint64_t)status.st_mtim.tv_sec;
	parts[1] = (uint64_t)status.st_mtim.tv_nsec;
	parts[2] = (uint64_t)status.st_size;
	parts[3] = (uint64_t)status.st_ino;
	for (int i = 0; i < 4; i++) {
		stamp = (stamp ^ parts[i]) * 1099511628211u;
	}
	return stamp | 1u;
}

/*
 * Writes the path of name in the folder below under folder (length bytes of it)
 * to path. Returns whether that file exists.
 */
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
	char program[PATH_MAX];
	ssize_t length =
		readlink("/proc/self/exe", program, sizeof(program) - 1);

	if (folder &&
		try_path(folder, (int)strlen(folder), "", name, path, size)) {
		return 0;
	}
	/* From the executable's folder up to the root. */
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
		"%s: not found: set LIMBER_ASSETS to the folder with limber's models",
		name);
	return -ENOENT;
}
