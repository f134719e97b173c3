#define _XOPEN_SOURCE 700

#include "tests/support/files.h"

#include "tests/support/test.h"

#include <dirent.h>
#include <errno.h>
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static struct test_path join(const char *directory, const char *name)
{
	struct test_path path;
	int length = snprintf(
		path.text, sizeof(path.text), "%s/%s", directory, name);

	if (length < 0 || (size_t)length >= sizeof(path.text)) {
		fail_msg("%s/%s: path too long", directory, name);
	}
	return path;
}

struct test_path fixture_path(const char *name)
{
	return join("tests/fixtures", name);
}

struct test_path path_beside_program(const char *name)
{
	struct test_path path = {""};
	ssize_t length =
		readlink("/proc/self/exe", path.text, sizeof(path.text) - 64);
	char *slash;

	assert_true(length > 0);
	path.text[length] = '\0';
	slash = strrchr(path.text, '/');
	assert_non_null(slash);
	snprintf(slash + 1, 63, "%s", name);
	return path;
}

struct test_path path_join(const struct test_path *directory, const char *name)
{
	return join(directory->text, name);
}

struct test_path temp_dir_make(void)
{
	const char *parent = getenv("TMPDIR");
	struct test_path path =
		join(parent && *parent ? parent : "/tmp", "limber-test-XXXXXX");

	if (!mkdtemp(path.text)) {
		fail_msg("%s: %s", path.text, strerror(errno));
	}
	return path;
}

int temp_dir_count(const struct test_path *directory)
{
	DIR *entries = opendir(directory->text);
	int count = -2; /* "." and ".." */

	if (!entries) {
		fail_msg("%s: %s", directory->text, strerror(errno));
	}
	while (readdir(entries)) {
		count++;
	}
	closedir(entries);
	return count;
}

static int remove_entry(const char *path, const struct stat *status, int kind,
	struct FTW *position)
{
	(void)status;
	(void)kind;
	(void)position;
	return remove(path);
}

void temp_dir_remove(const struct test_path *directory)
{
	if (nftw(directory->text, remove_entry, 8, FTW_DEPTH | FTW_PHYS)) {
		fail_msg("%s: %s", directory->text, strerror(errno));
	}
}

void file_write(const char *path, const void *data, size_t size)
{
	FILE *file = fopen(path, "wb");

	if (!file) {
		fail_msg("%s: %s", path, strerror(errno));
	}
	if (size && fwrite(data, size, 1, file) != 1) {
		fail_msg("%s: %s", path, strerror(errno));
	}
	if (fclose(file)) {
		fail_msg("%s: %s", path, strerror(errno));
	}
}

char *file_read(const char *path, size_t *size)
{
	enum {
		STEP = 64 * 1024
	};
	FILE *file = fopen(path, "rb");
	char *data = NULL;
	size_t used = 0;
	size_t got;

	if (!file) {
		fail_msg("%s: %s", path, strerror(errno));
	}
	do {
		char *grown = realloc(data, used + STEP + 1);

		assert_non_null(grown);
		data = grown;
		got = fread(data + used, 1, STEP, file);
		used += got;
	} while (got == STEP);
	if (ferror(file)) {
		fail_msg("%s: cannot be read", path);
	}
	fclose(file);
	data[used] = '\0';
	if (size) {
		*size = used;
	}
	return data;
}
