#include "platform/base/output_path.h"

#include "platform/base/compiler.h"

#include <errno.h>
#include <limits.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum {
	LINKS_MAX = 40,  /* as many as Linux follows */
	NAME_KEPT = 200, /* bytes of the name: fits NAME_MAX with the suffix */
	DESCRIPTOR_DIGITS = 7
};

/* The number of bytes of path up to and including its last slash. */
static size_t folder_length(const char *path)
{
	const char *slash = strrchr(path, '/');

	return slash ? (size_t)(slash - path) + 1 : 0;
}

/* The descriptor that a path such as "/dev/fd/3" names, or -1. */
static int descriptor_of(const char *path)
{
	static const char *const folders[] = {"/dev/fd/", "/proc/self/fd/"};

	if (strcmp(path, "/dev/stdout") == 0) {
		return STDOUT_FILENO;
	}
	if (strcmp(path, "/dev/stderr") == 0) {
		return STDERR_FILENO;
	}
	for (size_t i = 0; i < ARRAY_COUNT(folders); i++) {
		size_t length = strlen(folders[i]);
		size_t digits;

		if (strncmp(path, folders[i], length) != 0) {
			continue;
		}
		digits = strspn(path + length, "0123456789");
		if (digits > 0 && digits <= DESCRIPTOR_DIGITS &&
			path[length + digits] == '\0') {
			return atoi(path + length);
		}
	}
	return -1;
}

/* Reads the path that a link leads to; the caller frees it. 0 or -errno. */
static int read_link(const char *path, char **out)
{
	char link[PATH_MAX];
	ssize_t length = readlink(path, link, sizeof(link) - 1);
	size_t folder, size;

	if (length < 0) {
		return -errno;
	}
	link[length] = '\0';
	folder = link[0] == '/' ? 0 : folder_length(path);
	size = folder + (size_t)length + 1;
	*out = malloc(size);
	if (!*out) {
		return -ENOMEM;
	}
	snprintf(*out, size, "%.*s%s", (int)folder, path, link);
	return 0;
}

int output_path_follow(const char *path, char **target, int *descriptor)
{
	char *at = strdup(path);
	int error = at ? 0 : -ENOMEM;

	*target = NULL;
	for (int links = 0; !error; links++) {
		struct stat status;
		char *next;

		*descriptor = descriptor_of(at);
		if (*descriptor >= 0 || lstat(at, &status) != 0 ||
			!S_ISLNK(status.st_mode)) {
			*target = at;
			return 0;
		}
		error = links < LINKS_MAX ? read_link(at, &next) : -ELOOP;
		if (!error) {
			free(at);
			at = next;
		}
	}
	free(at);
	return error;
}

enum output_kind output_path_kind(const char *path)
{
	struct stat status;
	char *target;
	int descriptor;

	if (output_path_follow(path, &target, &descriptor) != 0) {
		return OUTPUT_NEW;
	}
	free(target);
	if (descriptor >= 0) {
		return descriptor == STDOUT_FILENO ? OUTPUT_STDOUT
						   : OUTPUT_STREAM;
	}
	if (stat(path, &status) != 0) {
		return OUTPUT_NEW;
	}
	return S_ISREG(status.st_mode)    ? OUTPUT_FILE
		: S_ISDIR(status.st_mode) ? OUTPUT_FOLDER
					  : OUTPUT_STREAM;
}

bool output_path_is_stream(const char *path)
{
	enum output_kind kind = output_path_kind(path);

	return kind == OUTPUT_STREAM || kind == OUTPUT_STDOUT;
}

FILE *output_path_report(const char *path)
{
	return path && output_path_kind(path) == OUTPUT_STDOUT ? stderr : stdout;
}

/* The finalizer of SplitMix64: every bit of x affects every bit of the result. */
static uint64_t mix(uint64_t x)
{
	x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
	x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
	return x ^ (x >> 31);
}

char *output_path_temporary(const char *target, unsigned attempt)
{
	struct timespec now = {0, 0};
	size_t size = strlen(target) + sizeof(".XXXXXXXX.part");
	size_t folder = folder_length(target);
	char *path = malloc(size);
	uint64_t seed;

	clock_gettime(CLOCK_MONOTONIC, &now);
	seed = mix((uint64_t)now.tv_sec << 30 ^ (uint64_t)now.tv_nsec) ^
		mix((uint64_t)getpid() << 32 | attempt) ^ (uintptr_t)&now;
	if (path) {
		snprintf(path, size, "%.*s%.*s.%08x.part", (int)folder, target,
			NAME_KEPT, target + folder, (unsigned)mix(seed));
	}
	return path;
}
