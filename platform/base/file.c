#include "platform/base/file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
	PATH_BYTES = 1024
};

bool file_exists(const char *path)
{
	struct stat status;

	return stat(path, &status) == 0;
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
	char program[PATH_BYTES];
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
