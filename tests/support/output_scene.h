/*
 * A folder to write files into through platform/base/output_file.h, and what is
 * logged about them.
 */
#ifndef TESTS_SUPPORT_OUTPUT_SCENE_H
#define TESTS_SUPPORT_OUTPUT_SCENE_H

#include "platform/base/output_file.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"

#include <sys/types.h>

struct output_scene {
	struct test_path folder;
	struct test_path path; /* "file" in it, which is not there yet */
	struct log_capture logged;
	struct log log;
};

/* For cmocka: *state is a struct output_scene. */
int output_scene_setup(void **state);
int output_scene_teardown(void **state);

/* Begins to write a file and fails the test when that fails. */
struct output_file *output_scene_begin(
	struct output_scene *scene, const char *path);

/* Writes a whole file. */
void output_scene_write(
	struct output_scene *scene, const char *path, const char *text);

/* The file holds that text and nothing else. */
void output_scene_expect(const char *path, const char *text);

/*
 * The file cannot be begun: -error, and one sentence with the path and the
 * words.
 */
void output_scene_expect_refusal(struct output_scene *scene, const char *path,
	int error, const char *words);

/* The type and the permissions of what lies at path, links not followed. */
mode_t output_scene_mode(const char *path);

#endif
