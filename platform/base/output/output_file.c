#define _GNU_SOURCE /* fopencookie(), memfd_create() */

#include "platform/base/output_file.h"

#include "platform/base/file.h"
#include "platform/base/output_path.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

struct output_file {
	struct log log;
	char *path;         /* as the caller named it */
	const char *option; /* the option that named the file, or NULL */
	char *target;       /* the file to replace, with links followed */
	char *temporary;    /* NULL: the file is written under its own name */
	FILE *stream;
	int fd;
	int error;     /* errno of the first write that failed */
	bool reported; /* the failure has been logged */
	bool edits;    /* the file may be one that the program has read */
	bool begun;    /* the first bytes have been written */
};

static const char *advice(int error)
{
	switch (error) {
	case ENOSPC:
	case EDQUOT:
		return ": free some space, or write to another disk";
	case EFBIG:
		return ": it would be larger than ulimit -f or the disk allows";
	case EACCES:
	case EPERM:
	case EROFS:
		return ": choose a folder and a file that you may write to";
	case ENOENT:
	case ENOTDIR:
		return ": create its folder first, or choose another one";
	case ENAMETOOLONG:
		return ": give a shorter name";
	case EISDIR:
		return ": name a file in it";
	case ETXTBSY:
		return ": give another name";
	case EPIPE:
		return ": the program that reads it has ended";
	default:
		return "";
	}
}

static void log_failure(
	const struct log *log, const char *option, const char *path, int error)
{
	log_error(log, "%s%s%s: cannot be written: %s%s", option ? option : "",
		option ? " " : "", path,
		error == ETXTBSY ? "limber reads this file" : strerror(error),
		advice(error));
}

/* Returns 0, or ETXTBSY if the output would replace a file that was read. */
static int check_unread(const struct output_file *file)
{
	return file->temporary && !file->edits && file_was_read(file->target)
		? ETXTBSY
		: 0;
}

/*
 * The stream's write function, which keeps the cause of the first failure; a
 * plain FILE would lose it. EINTR is a failure, too: the only signals that can
 * interrupt it are those that end the program.
 */
static ssize_t write_bytes(void *cookie, const char *bytes, size_t size)
{
	struct output_file *file = cookie;
	size_t written = 0;

	if (!file->begun && !file->error) {
		file->begun = true;
		file->error = check_unread(file);
	}
	while (written < size && !file->error) {
		ssize_t count = write(file->fd, bytes + written, size - written);

		if (count > 0) {
			written += (size_t)count;
		} else {
			file->error = count < 0 ? errno : EIO;
		}
	}
	return (ssize_t)written;
}

/*
 * The new file must not become readable for more users than the old one. Where
 * the group cannot be kept, the group therefore gets the rights of others.
 */
static void keep_permissions(int fd, const struct stat *old)
{
	mode_t mode = old->st_mode & 0777;

	if (fchown(fd, old->st_uid, old->st_gid) != 0 &&
		fchown(fd, (uid_t)-1, old->st_gid) != 0) {
		mode = (mode & 0707) | (mode & 0007) << 3;
	}
	/* Fails only on file systems that have no permissions. */
	(void)fchmod(fd, mode);
}

/* old is the file to replace, or NULL. */
static int create_temporary(struct output_file *file, const struct stat *old)
{
	int error = 0;

	if (old && access(file->target, W_OK) != 0) {
		return -errno;
	}
	for (unsigned attempt = 0; attempt < 100; attempt++) {
		file->temporary = output_path_temporary(file->target, attempt);
		if (!file->temporary) {
			return -ENOMEM;
		}
		file->fd = open(file->temporary,
			O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC,
			old ? 0600 : 0666);
		if (file->fd >= 0) {
			if (old) {
				keep_permissions(file->fd, old);
			}
			return 0;
		}
		error = -errno;
		free(file->temporary);
		file->temporary = NULL;
		if (error != -EEXIST) {
			break;
		}
	}
	return error;
}

static int open_in_place(struct output_file *file, const char *path)
{
	file->fd = open(path, O_WRONLY | O_CLOEXEC | O_NOCTTY);
	return file->fd < 0 ? -errno : 0;
}

/* The content continues behind what the program has printed so far. */
static int open_descriptor(struct output_file *file, int descriptor)
{
	fflush(stdout);
	file->fd = fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
	return file->fd < 0 ? -errno : 0;
}

static int open_path(struct output_file *file)
{
	struct stat status;
	int descriptor;
	int error = output_path_follow(file->path, &file->target, &descriptor);

	if (error) {
		return error;
	}
	if (file->path[0] == '\0') {
		return -ENOENT;
	}
	if (descriptor >= 0) {
		return open_descriptor(file, descriptor);
	}
	if (stat(file->path, &status) != 0) {
		return errno == ENOENT ? create_temporary(file, NULL) : -errno;
	}
	if (S_ISDIR(status.st_mode)) {
		return -EISDIR;
	}
	if (!S_ISREG(status.st_mode)) {
		return open_in_place(file, file->path);
	}
	error = create_temporary(file, &status);
	return error ? error : -check_unread(file);
}

static int open_stream(struct output_file *file)
{
	const cookie_io_functions_t functions = {.write = write_bytes};

	file->stream = fopencookie(file, "w", functions);
	return file->stream ? 0 : -ENOMEM;
}

static int create(const char *option, const char *path, bool edits,
	const struct log *log, struct output_file **out)
{
	struct output_file *file = calloc(1, sizeof(*file));
	int error = -ENOMEM;

	*out = NULL;
	if (file) {
		file->log = *log;
		file->option = option;
		file->edits = edits;
		file->fd = -1;
		file->path = strdup(path);
		error = file->path ? open_path(file) : -ENOMEM;
	}
	if (!error) {
		error = open_stream(file);
	}
	if (error) {
		log_failure(log, option, path, -error);
		output_file_discard(file);
		return error;
	}
	*out = file;
	return 0;
}

int output_file_create(
	const char *path, const struct log *log, struct output_file **out)
{
	return create(NULL, path, false, log, out);
}

int output_file_create_for(const char *option, const char *path,
	const struct log *log, struct output_file **out)
{
	return create(option, path, false, log, out);
}

int output_file_edit(const char *option, const char *path,
	const struct log *log, struct output_file **out)
{
	return create(option, path, true, log, out);
}

int output_file_try(const char *option, const char *path, const struct log *log)
{
	struct output_file *file;
	int error;

	if (output_path_is_stream(path)) {
		return 0;
	}
	error = create(option, path, false, log, &file);
	output_file_discard(file);
	return error;
}

FILE *output_file_stream(const struct output_file *file)
{
	return file->stream;
}

int output_file_failed(struct output_file *file, const char *reason)
{
	file->reported = true;
	if (file->error) {
		log_failure(&file->log, file->option, file->path, file->error);
		return -file->error;
	}
	log_error(&file->log, "%s: cannot be written: %s", file->path, reason);
	file->error = EIO;
	return -EIO;
}

static int move_into_place(struct output_file *file)
{
	int error = check_unread(file);

	if (error || !file->temporary) {
		return -error;
	}
	if (rename(file->temporary, file->target) != 0) {
		return -errno;
	}
	free(file->temporary);
	file->temporary = NULL;
	return 0;
}

int output_file_publish(struct output_file *file)
{
	if (fflush(file->stream) != 0) {
		file->error = file->error ? file->error : EIO;
	}
	return file->error ? -file->error : move_into_place(file);
}

/* Pipes, terminals and some file systems do not support fsync(). */
static int wait_for_disk(int fd)
{
	if (fsync(fd) == 0 || errno == EINVAL || errno == ENOTSUP ||
		errno == ENOSYS) {
		return 0;
	}
	return errno;
}

static void remove_temporary(struct output_file *file)
{
	if (file->temporary) {
		unlink(file->temporary);
		free(file->temporary);
		file->temporary = NULL;
	}
}

static void release(struct output_file *file)
{
	if (file->stream) {
		/* Keeps write_bytes() from writing what is still buffered. */
		file->error = ECANCELED;
		fclose(file->stream);
	}
	if (file->fd >= 0) {
		close(file->fd);
	}
	remove_temporary(file);
	free(file->target);
	free(file->path);
	free(file);
}

/* 0 or errno. */
static int complete(struct output_file *file)
{
	int fd = file->fd;
	int error;

	if (fclose(file->stream) != 0 && !file->error) {
		file->error = EIO;
	}
	file->stream = NULL;
	error = file->error ? file->error : wait_for_disk(fd);
	file->fd = -1;
	if (close(fd) != 0 && !error) {
		error = errno;
	}
	return error ? error : -move_into_place(file);
}

int output_file_commit(struct output_file *file)
{
	int error = complete(file);

	/* Before logging, which may end the program by SIGPIPE. */
	remove_temporary(file);
	if (error && !file->reported) {
		log_failure(&file->log, file->option, file->path, error);
	}
	release(file);
	return -error;
}

void output_file_discard(struct output_file *file)
{
	if (file) {
		release(file);
	}
}

FILE *output_file_scratch(void)
{
	int fd = memfd_create("limber", MFD_CLOEXEC);
	FILE *file = fd < 0 ? NULL : fdopen(fd, "w+");

	if (fd >= 0 && !file) {
		close(fd);
	}
	return file;
}

void output_file_prepare_process(void)
{
	signal(SIGXFSZ, SIG_IGN);
	for (int fd = 0; fd <= STDERR_FILENO; fd++) {
		/* open() returns the lowest number that is free, which is fd. */
		if (fcntl(fd, F_GETFD) < 0 && errno == EBADF &&
			open("/", O_PATH) < 0) {
			return;
		}
	}
}

int output_file_flush_stdout(const struct log *log)
{
	int error = ferror(stdout) ? EIO : 0;

	if (fflush(stdout) != 0) {
		error = errno;
	}
	if (error) {
		log_failure(log, NULL, "standard output", error);
	}
	return -error;
}
