#define _XOPEN_SOURCE 700 /* realpath() */

#include "app/model/model_file.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "platform/base/file.h"

static int read_all(int fd, size_t size, uint8_t *data)
{
	size_t done = 0;

	while (done < size) {
		ssize_t got = read(fd, data + done, size - done);

		if (got < 0 && errno == EINTR) {
			continue;
		}
		if (got <= 0) {
			return got < 0 ? -errno : -EIO;
		}
		done += (size_t)got;
	}
	return 0;
}

static int check_open(
	int fd, const char *where, const struct log *log, size_t *size)
{
	struct stat status;
	uint8_t byte;

	if (fstat(fd, &status) < 0) {
		int error = -errno;

		log_error(log, "%s: %s", where, strerror(-error));
		return error;
	}
	if (S_ISDIR(status.st_mode)) {
		log_error(log,
			"%s: this is a folder: give the name of a file in it",
			where);
		return -EISDIR;
	}
	if (!S_ISREG(status.st_mode)) {
		log_error(log,
			"%s: this is not a regular file: give the name of one",
			where);
		return -EINVAL;
	}
	if (status.st_size > MODEL_FILE_BYTES_MAX) {
		log_error(log,
			"%s: the file has %lld bytes; limber reads up to %d",
			where, (long long)status.st_size, MODEL_FILE_BYTES_MAX);
		return -EFBIG;
	}
	if (status.st_size == 0 && pread(fd, &byte, 1, 0) > 0) {
		log_error(log,
			"%s: the system does not tell the size of this file: give limber a copy of it",
			where);
		return -EINVAL;
	}
	*size = (size_t)status.st_size;
	return 0;
}

/*
 * Returns a file descriptor, or -errno after an error. O_NONBLOCK keeps open()
 * from waiting at a named pipe, which check_open() refuses.
 */
static int open_path(const char *path, const char *where, const struct log *log,
	size_t *size)
{
	int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
	int error;

	if (fd < 0) {
		error = -errno;
		log_error(log, "%s: %s%s", where, strerror(-error),
			file_open_advice(-error));
		return error;
	}
	error = check_open(fd, where, log, size);
	if (error) {
		close(fd);
		return error;
	}
	file_note_read(fd);
	return fd;
}

/* Allocates zeroed memory for a file of this size. */
static int allocate(size_t size, const char *where, struct memory_budget *budget,
	const struct log *log, struct model_file *out)
{
	uint8_t *data = NULL;

	if (!memory_budget_take(budget, size)) {
		return memory_budget_fail(budget, where, log);
	}
	data = calloc(size + 1, 1);
	if (!data) {
		memory_budget_give_back(budget, size);
		return memory_budget_fail(budget, where, log);
	}
	*out = (struct model_file){data, size, budget};
	return 0;
}

static int read_path(const char *path, const char *where,
	struct memory_budget *budget, const struct log *log,
	struct model_file *out)
{
	size_t size;
	int fd = open_path(path, where, log, &size);
	int error;

	*out = (struct model_file){0};
	if (fd < 0) {
		return fd;
	}
	error = allocate(size, where, budget, log, out);
	if (!error) {
		error = read_all(fd, size, out->data);
		if (error) {
			log_error(log, "%s: %s", where, strerror(-error));
			model_file_release(out);
		}
	}
	close(fd);
	return error;
}

int model_file_check(const char *path, const struct log *log)
{
	size_t size;
	int fd = open_path(path, path, log, &size);

	if (fd < 0) {
		return fd;
	}
	close(fd);
	return 0;
}

int model_file_read(const char *path, struct memory_budget *budget,
	const struct log *log, struct model_file *out)
{
	return read_path(path, path, budget, log, out);
}

static bool has_parent_folder(const char *relative)
{
	const char *step = relative;

	while (step) {
		if (strncmp(step, "..", 2) == 0 &&
			(step[2] == '/' || step[2] == '\0')) {
			return true;
		}
		step = strchr(step, '/');
		step = step ? step + 1 : NULL;
	}
	return false;
}

/* Returns what is wrong with a path, or NULL. */
static const char *find_problem(const char *relative)
{
	const char *at;

	if (relative[0] == '\0') {
		return "the path is empty";
	}
	if (relative[0] == '/') {
		return "the path is absolute";
	}
	for (at = relative; *at; at++) {
		if (*at == '\\') {
			return "the path contains a backslash";
		}
		if ((unsigned char)*at < 0x20 || *at == 0x7f) {
			return "the path contains a control character";
		}
	}
	return has_parent_folder(relative) ? "the path contains \"..\"" : NULL;
}

/*
 * Finds the real paths of the model's folder and of the file, which the caller
 * frees. Returns 0 or -errno, without a message.
 */
static int resolve(const struct model_source *source, const char *relative,
	char **folder, char **file)
{
	const char *slash = strrchr(source->name, '/');
	size_t length = slash ? (size_t)(slash - source->name) + 1 : 0;
	char path[PATH_MAX];
	int printed;

	if (length >= sizeof(path)) {
		return -ENAMETOOLONG;
	}
	snprintf(path, sizeof(path), "%.*s.", (int)length, source->name);
	*folder = realpath(path, NULL);
	if (!*folder) {
		return -errno;
	}
	printed = snprintf(path, sizeof(path), "%.*s%s", (int)length,
		source->name, relative);
	if (printed < 0 || (size_t)printed >= sizeof(path)) {
		return -ENAMETOOLONG;
	}
	*file = realpath(path, NULL);
	return *file ? 0 : -errno;
}

static bool is_inside(const char *folder, const char *file)
{
	size_t length = strlen(folder);

	if (length == 1) {
		return true;
	}
	return strncmp(folder, file, length) == 0 && file[length] == '/';
}

int model_file_read_beside(const struct model_source *source,
	const char *relative, const char *where, struct memory_budget *budget,
	const struct log *log, struct model_file *out)
{
	const char *problem = find_problem(relative);
	char *folder = NULL;
	char *file = NULL;
	char message_start[512];
	int error;

	*out = (struct model_file){0};
	if (!source->has_folder) {
		log_error(log,
			"%s: the model was not loaded from a folder, so it cannot refer to other files",
			where);
		return -EACCES;
	}
	if (problem) {
		log_error(log,
			"%s: %s; it must lead to a file in the model's folder",
			where, problem);
		return -EACCES;
	}
	snprintf(message_start, sizeof(message_start), "%s: %.200s", where,
		relative);
	error = resolve(source, relative, &folder, &file);
	if (error) {
		log_error(log, "%s: %s%s", message_start, strerror(-error),
			error == -ENOENT ? ": copy it to the model's folder"
					 : file_open_advice(-error));
	} else if (!is_inside(folder, file)) {
		error = -EACCES;
		log_error(log, "%s: the path leads outside the model's folder",
			message_start);
	} else {
		error = read_path(file, message_start, budget, log, out);
	}
	free(folder);
	free(file);
	return error;
}

void model_file_release(struct model_file *file)
{
	free(file->data);
	memory_budget_give_back(file->budget, file->size);
	*file = (struct model_file){0};
}
