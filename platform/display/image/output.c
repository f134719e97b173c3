#include "platform/display/image/output.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void release(struct output *output)
{
	free(output->path);
	free(output->part);
	*output = (struct output){.log = output->log};
}

int output_open(struct output *output, const char *path, const struct log *log)
{
	static const char suffix[] = ".part";
	size_t length = strlen(path);
	struct stat status;
	int error;

	*output = (struct output){.log = *log};
	if (stat(path, &status) == 0 && S_ISDIR(status.st_mode)) {
		log_error(log, "%s: this is a directory: name a file", path);
		return -EISDIR;
	}
	output->path = malloc(length + 1);
	output->part = malloc(length + sizeof(suffix));
	if (!output->path || !output->part) {
		log_error(log, "%s: out of memory", path);
		release(output);
		return -ENOMEM;
	}
	memcpy(output->path, path, length + 1);
	memcpy(output->part, path, length);
	memcpy(output->part + length, suffix, sizeof(suffix));
	output->file = fopen(output->part, "wb");
	if (!output->file) {
		error = -errno;
		log_error(log, "%s: cannot be written: %s", path,
			strerror(-error));
		release(output);
		return error;
	}
	return 0;
}

int output_failed(
	const struct output *output, int errno_value, const char *reason)
{
	log_error(&output->log, "%s: writing failed: %s", output->path,
		errno_value ? strerror(errno_value) : reason);
	return errno_value ? -errno_value : -EIO;
}

int output_commit(struct output *output)
{
	int error = 0;

	errno = 0;
	if (ferror(output->file)) {
		error = EIO;
	}
	if (fclose(output->file) != 0 && !error) {
		error = errno ? errno : EIO;
	}
	output->file = NULL;
	if (!error && rename(output->part, output->path) != 0) {
		error = errno;
	}
	if (error) {
		error = output_failed(output, error, NULL);
		unlink(output->part);
	}
	release(output);
	return error;
}

void output_discard(struct output *output)
{
	if (output->file) {
		fclose(output->file);
		unlink(output->part);
		release(output);
	}
}
