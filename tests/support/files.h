/*
 * Files for tests: the fixtures that come with them, and a folder of their own
 * to write into.
 *
 * Tests run from the checkout's top folder. A helper that cannot do its work
 * fails the running test.
 */
#ifndef TESTS_SUPPORT_FILES_H
#define TESTS_SUPPORT_FILES_H

#include <stddef.h>

struct test_path {
	char text[512];
};

/* tests/fixtures/NAME. */
struct test_path fixture_path(const char *name);

/* A fresh folder below $TMPDIR (/tmp), for temp_dir_remove() to take away. */
struct test_path temp_dir_make(void);

/* How many files and folders lie in it. */
int temp_dir_count(const struct test_path *directory);

/* Removes the folder and all in it. */
void temp_dir_remove(const struct test_path *directory);

/* DIRECTORY/NAME. */
struct test_path path_join(const struct test_path *directory, const char *name);

/* Creates or replaces a file. */
void file_write(const char *path, const void *data, size_t size);

/*
 * All of a file, with a zero byte behind it that does not count in *size (may
 * be NULL). The caller frees it.
 */
char *file_read(const char *path, size_t *size);

#endif
