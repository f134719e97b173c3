#include "app/character/sketch/character_sketch.h"
#include "app/cmd/command.h"
#include "platform/base/output_file.h"
#include "platform/base/output_path.h"

#include <errno.h>
#include <sys/stat.h>

/* Whether the file exists with content, which may have been edited by hand. */
static bool would_replace(const char *path)
{
	struct stat status;

	return output_path_kind(path) == OUTPUT_FILE &&
		stat(path, &status) == 0 && status.st_size > 0;
}

static int write_sketch(
	const struct model *model, const char *path, const struct log *log)
{
	struct output_file *file;
	int error;

	if (would_replace(path)) {
		log_error(log,
			"%s: this file exists and may have been edited: give another name, or remove it first",
			path);
		return -EEXIST;
	}
	error = output_file_create(path, log, &file);
	if (error) {
		return error;
	}
	error = character_sketch(model, NULL, output_file_stream(file));
	if (error) {
		output_file_discard(file);
		return memory_budget_fail(model->budget, model->path, log);
	}
	return output_file_commit(file);
}

static int run_with_model(const struct model *model,
	const struct options *options, const struct log *log)
{
	if (options->screen.output) {
		return write_sketch(model, options->screen.output, log);
	}
	return character_sketch(model, NULL, stdout) == 0
		? 0
		: memory_budget_fail(model->budget, model->path, log);
}

static int run(const struct options *options, const struct log *log)
{
	return command_run_with_model(
		&command_character, options, log, run_with_model);
}

const struct command command_character = {
	.name = "character",
	.bit = FOR_CHARACTER,
	.usage = "MODEL [-o FILE]",
	.summary = "write a first character file for a model",
	.detail =
		"A character file says how a model behaves: its states, layers, morphs, parts, effects and what\n"
		"each button does. limber play finds it beside the model: robot.character for robot.glb. This\n"
		"command makes one from what the model holds, to be edited: clips become states, morph targets\n"
		"become shapes, parts and chains of bones become suggestions. Without -o it prints the file. A\n"
		"file that exists is not replaced, as it may have been edited.\n"
		"\n"
		"  limber character robot.glb -o robot.character\n"
		"  limber doctor robot.glb        # checks it\n"
		"  limber play robot.glb          # plays it, and anew when it changes",
	.run = run,
};
