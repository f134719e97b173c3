#include "app/cmd/show/failsafe.h"

#include "app/demo/demo.h"
#include "platform/base/file.h"
#include "platform/base/output_file.h"
#include "platform/base/output_path.h"
#include "platform/base/printable.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
	LINE_BYTES = 4400 /* room for a path and three numbers */
};

static const char mark[] = "limber failsafe ";

/* Identifies what is counted: a demo, or a model's path, size and mtime. */
static void describe(const char *model, const char *demo, char *out)
{
	struct stat status = {0};

	if (model && stat(model, &status) != 0) {
		status = (struct stat){0};
	}
	snprintf(out, LINE_BYTES, "%lld %lld %s\n", (long long)status.st_size,
		(long long)status.st_mtime, model ? model : demo);
}

/*
 * Returns the number of counted starts; 0 if the file does not exist, is empty,
 * or counts something else. Returns -errno if the file cannot be read or has
 * other content.
 */
static int read_count(const char *path, const char *described)
{
	char line[sizeof(mark) + 2 + LINE_BYTES] = "";
	FILE *file;
	int count;

	/* Opening a device may have effects: a watchdog starts. */
	if (output_path_is_stream(path)) {
		return -EINVAL;
	}
	file = file_open(path);
	if (!file) {
		return errno == ENOENT ? 0 : -errno;
	}
	if (!fgets(line, sizeof(line), file)) {
		count = ferror(file) ? -errno : 0;
	} else if (strncmp(line, mark, sizeof(mark) - 1) != 0) {
		count = -EINVAL;
	} else {
		count = line[sizeof(mark) - 1] - '0';
		if (count < 0 || count > FAILSAFE_STARTS ||
			strcmp(line + sizeof(mark) + 1, described) != 0) {
			count = 0;
		}
	}
	fclose(file);
	return count;
}

static int write_count(const char *path, int count, const char *described,
	const struct log *log)
{
	struct output_file *file;
	int error = output_file_edit("--failsafe", path, log, &file);

	if (error) {
		return error;
	}
	fprintf(output_file_stream(file), "%s%d %s", mark, count, described);
	return output_file_commit(file);
}

static void give_way(struct failsafe *failsafe, struct options *options)
{
	const char *model = options->model_path;
	const char *shown = model ? model : options->show.demo;
	const char *slash = model ? strrchr(model, '/') : NULL;

	failsafe->gives_way = true;
	snprintf(failsafe->name, sizeof(failsafe->name), "%s",
		slash ? slash + 1 : shown);
	printable_make(failsafe->name);
	log_warning(failsafe->log,
		"%s: it ended limber %d times within a minute of its start: limber shows its demo %s instead, until the file changes or you delete %s",
		shown, FAILSAFE_STARTS, demo_registry[0]->name, failsafe->path);
	options->model_path = NULL;
	options->motion.clip = NULL;
	options->show.demo = NULL;
	options->show.character = NULL;
}

struct failsafe failsafe_begin(
	struct options *options, int64_t now_ms, const struct log *log)
{
	struct failsafe failsafe = {
		.path = options->show.failsafe,
		.log = log,
		.began_ms = now_ms,
	};
	const char *demo = options->show.demo;
	char described[LINE_BYTES];
	int count;

	if (!failsafe.path ||
		(!options->model_path &&
			(!demo || strcmp(demo, demo_registry[0]->name) == 0))) {
		failsafe.path = NULL;
		return failsafe;
	}
	describe(options->model_path, demo, described);
	count = read_count(failsafe.path, described);
	if (count < 0) {
		log_warning(log, "--failsafe %s: %s: starts are not counted",
			failsafe.path,
			count == -EINVAL ? "limber did not write this file"
					 : strerror(-count));
		failsafe.path = NULL;
	} else if (count == FAILSAFE_STARTS) {
		give_way(&failsafe, options);
		failsafe.path = NULL;
	} else if (write_count(failsafe.path, count + 1, described, log) != 0) {
		failsafe.path = NULL;
	}
	return failsafe;
}

/*
 * Deletes the file, or empties the file that a link leads to. If this fails,
 * the count is too high at worst.
 */
static void forget(struct failsafe *failsafe)
{
	struct stat status;

	if (failsafe->path && lstat(failsafe->path, &status) == 0) {
		(void)(S_ISREG(status.st_mode) ? unlink(failsafe->path)
					       : truncate(failsafe->path, 0));
	}
	failsafe->path = NULL;
}

void failsafe_feed(struct failsafe *failsafe, int64_t now_ms)
{
	if (now_ms - failsafe->began_ms >= FAILSAFE_MS) {
		forget(failsafe);
	}
}

void failsafe_end(struct failsafe *failsafe, bool in_order)
{
	if (in_order) {
		forget(failsafe);
	}
}
