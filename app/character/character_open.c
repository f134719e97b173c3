#include "app/character/character_open.h"

#include "app/character/sketch/character_sketch.h"
#include "platform/base/file.h"

#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

bool character_open_path(
	const struct character_request *request, char *path, size_t size)
{
	const char *given = request->file;

	if (given) {
		int length = snprintf(path, size, "%s", given);

		return strcmp(given, "none") != 0 && length >= 0 &&
			(size_t)length < size;
	}
	return !request->clip &&
		character_text_path_beside(request->model_path, path, size) &&
		file_exists(path);
}

static int open_sketch(const struct character_request *request,
	struct instance *instance, const struct log *log, struct character **out)
{
	struct character_sketch_play play = {.rate = request->rate,
		.repeat = request->repeat,
		.all_loop = request->all_loop};
	char *text = NULL;
	size_t size = 0;
	FILE *file;
	bool complete = false;
	int error = model_choose_clip(
		instance->model, request->clip, 0, log, &play.clip);

	if (error) {
		return error;
	}
	if (instance->model->clip_count > CHARACTER_SKETCH_CLIPS) {
		log_warning(log,
			"%s: buttons reach %d of the %d clips: --clip chooses with which one they begin",
			request->model_path, CHARACTER_SKETCH_CLIPS,
			instance->model->clip_count);
	}
	error = -ENOMEM;
	file = open_memstream(&text, &size);
	if (file) {
		complete = character_sketch(instance->model, &play, file) == 0 &&
			ferror(file) == 0;
		complete = fclose(file) == 0 && complete;
	}
	file = complete && text && size > 0 ? fmemopen(text, size, "r") : NULL;
	if (file) {
		error = character_read(
			file, request->model_path, instance, log, out);
		fclose(file);
	} else {
		log_error(log, "%s: there is not enough memory",
			request->model_path);
	}
	free(text);
	return error;
}

int character_open(const struct character_request *request,
	struct instance *instance, const struct log *log, struct character **out)
{
	char path[PATH_MAX];

	*out = NULL;
	return character_open_path(request, path, sizeof(path))
		? character_load(path, instance, log, out)
		: open_sketch(request, instance, log, out);
}

uint64_t character_open_stamp(const struct character_request *request,
	const struct character *character)
{
	char path[PATH_MAX];

	if (character->text.is_file) {
		return character_stamp(character);
	}
	return character_open_path(request, path, sizeof(path))
		? file_stamp(path)
		: 0;
}
