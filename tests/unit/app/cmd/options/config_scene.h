/*
 * A limber.conf in a folder of its own, for tests of how it is read.
 */
#ifndef TESTS_UNIT_APP_CMD_OPTIONS_CONFIG_SCENE_H
#define TESTS_UNIT_APP_CMD_OPTIONS_CONFIG_SCENE_H

#include "app/cmd/options/config.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

struct scene {
	struct test_path folder, path;
	struct config config;
	struct options options;
	struct log_capture logged;
	int error; /* of the last load */
};

static int setup(void **state)
{
	struct scene *scene = calloc(1, sizeof(*scene));

	assert_non_null(scene);
	scene->folder = temp_dir_make();
	scene->path = path_join(&scene->folder, "limber.conf");
	scene->config.arena = arena_empty();
	*state = scene;
	return 0;
}

static int teardown(void **state)
{
	struct scene *scene = *state;

	config_release(&scene->config);
	temp_dir_remove(&scene->folder);
	free(scene);
	return 0;
}

/* Writes the file and reads it over the default options. */
static int load_bytes(struct scene *scene, enum command_bit command,
	const char *text, size_t size)
{
	struct log log = log_capture_begin(&scene->logged);

	file_write(scene->path.text, text, size);
	scene->options = options_default();
	scene->error = config_load(&scene->config, scene->path.text, command,
		&scene->options, &log);
	return scene->error;
}

static int load(struct scene *scene, enum command_bit command, const char *text)
{
	return load_bytes(scene, command, text, strlen(text));
}

#endif
