#include "tests/support/output_scene.h"

#include "tests/support/test.h"

#include <stdlib.h>
#include <sys/stat.h>

int output_scene_setup(void **state)
{
	struct output_scene *scene = calloc(1, sizeof(*scene));

	assert_non_null(scene);
	scene->folder = temp_dir_make();
	scene->path = path_join(&scene->folder, "file");
	scene->log = log_capture_begin(&scene->logged);
	output_file_prepare_process();
	*state = scene;
	return 0;
}

int output_scene_teardown(void **state)
{
	struct output_scene *scene = *state;

	(void)chmod(scene->folder.text, 0700);
	temp_dir_remove(&scene->folder);
	free(scene);
	return 0;
}

struct output_file *output_scene_begin(
	struct output_scene *scene, const char *path)
{
	struct output_file *file;

	assert_int_equal(output_file_create(path, &scene->log, &file), 0);
	assert_non_null(file);
	return file;
}

void output_scene_write(
	struct output_scene *scene, const char *path, const char *text)
{
	struct output_file *file = output_scene_begin(scene, path);

	assert_true(fputs(text, output_file_stream(file)) >= 0);
	assert_int_equal(output_file_commit(file), 0);
}

void output_scene_expect(const char *path, const char *text)
{
	char *content = file_read(path, NULL);

	assert_string_equal(content, text);
	free(content);
}

void output_scene_expect_refusal(struct output_scene *scene, const char *path,
	int error, const char *words)
{
	struct output_file *file;

	scene->logged.count = 0;
	assert_int_equal(output_file_create(path, &scene->log, &file), -error);
	assert_null(file);
	assert_int_equal(scene->logged.count, 1);
	assert_contains(scene->logged.sentence[0], path);
	assert_contains(scene->logged.sentence[0], words);
}

mode_t output_scene_mode(const char *path)
{
	struct stat status;

	assert_int_equal(lstat(path, &status), 0);
	return status.st_mode;
}
