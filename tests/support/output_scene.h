/*
 * A folder of a test's own for files that platform/base/output_file.h writes,
 * and a log that keeps what is said about them.
 */
#ifndef TESTS_SUPPORT_OUTPUT_SCENE_H
#define TESTS_SUPPORT_OUTPUT_SCENE_H

#include "platform/base/output_file.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"

#include <sys/types.h>

struct output_scene {
	struct test_path folder;
	struct test_path path; /* of a file in it that does not exist yet */
	struct log_capture logged;
	struct log log;
};

/* For cmocka: *state is a struct output_scene. */
int output_scene_setup(void **state);
int output_scene_teardown(void **state);

/* Begins to write a file; fails the test when that is refused. */
struct output_file *output_scene_begin(
	struct output_scene *scene, const char *path);

/* Writes a whole file and fails the test when that is refused. */
void output_scene_write(
	struct output_scene *scene, const char *path, const char *text);

/* Fails the test unless the file holds that text and nothing else. */
void output_scene_expect(const char *path, const char *text);

/*
 * Fails the test unless beginning the file returns -error and logs one sentence
 * that contains the path and the words.
 */
void output_scene_expect_refusal(struct output_scene *scene, const char *path,
	int error, const char *words);

/* The type and the permissions of path; a symbolic link is not followed. */
mode_t output_scene_mode(const char *path);

#endif
