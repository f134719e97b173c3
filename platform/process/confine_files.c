#define _GNU_SOURCE /* O_PATH, syscall() */

#include "platform/process/confine_files.h"

#include "platform/base/output_path.h"
#include "platform/process/shortage.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/landlock.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

/* Everything that changes files or runs them, as of the first Landlock. */
static const uint64_t handled = LANDLOCK_ACCESS_FS_EXECUTE |
	LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR |
	LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_CHAR |
	LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG |
	LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO |
	LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM;

/* The rights that output_file.h needs in the folder of an output. */
static const uint64_t of_folder = LANDLOCK_ACCESS_FS_WRITE_FILE |
	LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_DIR |
	LANDLOCK_ACCESS_FS_MAKE_REG;

/* Removes slashes at the end of a folder's name, except that of the root. */
static void drop_last_slashes(char *path)
{
	size_t length = strlen(path);

	while (length > 1 && path[length - 1] == '/') {
		path[--length] = '\0';
	}
}

/*
 * Finds the path that must get a rule so that the output can be written, and
 * the rights of that rule. The path is NULL if the output needs no rule, such
 * as /dev/stdout, since descriptors that are open can be written. The caller
 * frees the path. Returns 0 or -errno.
 */
static int covering_path(const char *output, char **path, uint64_t *access)
{
	struct stat status;
	char *slash;
	int descriptor;
	int error = output_path_follow(output, path, &descriptor);

	if (error || descriptor >= 0) {
		free(*path);
		*path = NULL;
		return error;
	}
	if (stat(*path, &status) != 0) {
		drop_last_slashes(*path);
	} else if (!S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) {
		*access = LANDLOCK_ACCESS_FS_WRITE_FILE;
		return 0;
	}
	*access = of_folder;
	slash = strrchr(*path, '/');
	if (!slash) {
		free(*path);
		*path = strdup(".");
		return *path ? 0 : -ENOMEM;
	}
	slash[slash == *path] = '\0';
	return 0;
}

/*
 * Adds a rule for an output. An output that cannot be reached gets none, and
 * writing it will fail. Returns 0 or -errno.
 */
static int allow(int rules, const char *output)
{
	struct landlock_path_beneath_attr beneath = {.parent_fd = -1};
	uint64_t access = 0;
	char *path;
	int error = covering_path(output, &path, &access);

	if (!error && !path) {
		return 0;
	}
	if (!error) {
		beneath.allowed_access = access;
		beneath.parent_fd = open(path, O_PATH | O_CLOEXEC);
		error = beneath.parent_fd < 0 ? -errno : 0;
	}
	free(path);
	if (error) {
		return shortage_is(-error) ? error : 0;
	}
	if (syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH,
		    &beneath, 0) != 0) {
		error = -errno;
	}
	close(beneath.parent_fd);
	return error;
}

int confine_files(const char *const *output)
{
	const struct landlock_ruleset_attr attributes = {
		.handled_access_fs = handled};
	int rules = (int)syscall(SYS_landlock_create_ruleset, &attributes,
		sizeof(attributes), 0);
	int error = 0;

	if (rules < 0) {
		return -errno;
	}
#ifdef COUNTERS /* make coverage writes its counters when a program ends */
	error = allow(rules, COUNTERS);
#endif
	for (; !error && *output; output++) {
		error = allow(rules, *output);
	}
	if (!error && syscall(SYS_landlock_restrict_self, rules, 0) != 0) {
		error = -errno;
	}
	close(rules);
	return error;
}
