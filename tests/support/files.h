/*
 * Files for tests: the fixtures, and a folder of its own that a test may write
 * into.
 *
 * Tests run from the top folder of the source tree. Each function fails the
 * running test when it cannot do its work.
 */
#ifndef TESTS_SUPPORT_FILES_H
#define TESTS_SUPPORT_FILES_H

#include <stddef.h>

struct test_path {
	char text[512];
};

/* tests/fixtures/NAME. */
struct test_path fixture_path(const char *name);

/*
 * Makes a folder below $TMPDIR, or below /tmp where that is not set. The caller
 * ends with temp_dir_remove().
 */
struct test_path temp_dir_make(void);

/* How many files and folders lie in it. */
int temp_dir_count(const struct test_path *directory);

/* Removes the folder with its contents. */
void temp_dir_remove(const struct test_path *directory);

/* The file of that name in the test program's folder. */
struct test_path path_beside_program(const char *name);

/* DIRECTORY/NAME. */
struct test_path path_join(const struct test_path *directory, const char *name);

/* Creates a file, or replaces its contents. */
void file_write(const char *path, const void *data, size_t size);

/*
 * Returns the contents of a file, followed by a zero byte that *size does not
 * count. size may be NULL. The caller frees the result.
 */
char *file_read(const char *path, size_t *size);

#endif
