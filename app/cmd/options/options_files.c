#include "app/cmd/options/options_files.h"

#include "app/compare/export/export.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

#include "platform/base/compiler.h"
#include "platform/base/output_path.h"

struct named_file {
	const char *option;
	const char *path; /* NULL when the option was not given */
};

static bool is_same(const struct stat *a, const struct stat *b)
{
	return a->st_dev == b->st_dev && a->st_ino == b->st_ino;
}

/* Returns the path's last part, and writes its folder with a final ".". */
static const char *split(const char *path, char folder[PATH_MAX + 1])
{
	const char *slash = strrchr(path, '/');
	size_t length = slash ? (size_t)(slash - path) + 1 : 0;

	if (length >= PATH_MAX) {
		length = 0;
	}
	memcpy(folder, path, length);
	strcpy(folder + length, ".");
	return slash ? slash + 1 : path;
}

static bool is_same_name(const char *a, const char *b)
{
	char folder_a[PATH_MAX + 1], folder_b[PATH_MAX + 1];
	const char *name_a = split(a, folder_a), *name_b = split(b, folder_b);
	struct stat status_a, status_b;

	return strcmp(name_a, name_b) == 0 && stat(folder_a, &status_a) == 0 &&
		stat(folder_b, &status_b) == 0 && is_same(&status_a, &status_b);
}

/*
 * Whether two paths of files that do not exist yet would create the same file,
 * also through links that lead to it.
 */
static bool is_same_place(const char *a, const char *b)
{
	char *target_a, *target_b;
	int descriptor;
	bool same = false;

	/* A path that cannot be followed cannot be written to either. */
	if (output_path_follow(a, &target_a, &descriptor) == 0) {
		if (output_path_follow(b, &target_b, &descriptor) == 0) {
			same = is_same_name(target_a, target_b);
			free(target_b);
		}
		free(target_a);
	}
	return same;
}

static bool is_same_file(const char *a, const char *b)
{
	struct stat status_a, status_b;
	bool exists = stat(a, &status_a) == 0;

	if (exists != (stat(b, &status_b) == 0)) {
		return false;
	}
	return exists
		? S_ISREG(status_a.st_mode) && is_same(&status_a, &status_b)
		: is_same_place(a, b);
}

/* Refuses a file to write that is one of the files before it in the array. */
static int check_file(const struct named_file *file,
	const struct named_file *first, const struct log *log)
{
	for (; first < file; first++) {
		if (first->path && is_same_file(file->path, first->path)) {
			log_error(log,
				"%s %s: %s names the same file: give another name",
				file->option, file->path, first->option);
			return -EINVAL;
		}
	}
	return 0;
}

static bool ends_in(const char *path, const char *ending)
{
	const size_t length = strlen(path), count = strlen(ending);

	return length > count && strcasecmp(path + length - count, ending) == 0;
}

/*
 * Refuses the ending of another kind of file: the user meant another command.
 */
static int check_ending(const struct named_file *file, enum command_bit command,
	const struct log *log)
{
	static const struct {
		enum command_bit command;
		const char *ending;
		const char *content;
	} written[] = {
		{FOR_POSE, ".obj", "a Wavefront OBJ file"},
		{FOR_EXPORT, ".c", "C source"},
		{FOR_CHARACTER, ".character", "a character file"},
		{FOR_LEVELS, ".levels", "a file of levels of detail"},
	};
	static const char *const endings[] = {".png", ".gif", ".y4m", ".jpg",
		".jpeg", ".svg", ".obj", ".c", ".cc", ".cpp", ".cxx", ".glb",
		".gltf", ".bin", ".x", ".character", ".levels", ".conf", ".fbx",
		".dae", ".stl", ".ply", ".blend", ".usd", ".usda", ".usdc",
		".usdz", ".3ds", ".abc", ".bvh", ".mp4", ".webm", ".avi",
		".webp", ".bmp", ".zip", ".json"};
	size_t kind = 0;

	while (kind < ARRAY_COUNT(written) && written[kind].command != command) {
		kind++;
	}
	if (kind == ARRAY_COUNT(written) ||
		ends_in(file->path, written[kind].ending)) {
		return 0;
	}
	for (size_t i = 0; i < ARRAY_COUNT(endings); i++) {
		if (ends_in(file->path, endings[i])) {
			log_error(log,
				"%s %s: this command writes %s: give a name that ends in %s",
				file->option, file->path, written[kind].content,
				written[kind].ending);
			return -EINVAL;
		}
	}
	return 0;
}

/* Refuses a folder where a file would be written over the model. */
static int check_export(const struct options *options, const struct log *log)
{
	const char *model = options->model_path;
	const char *folder = options->compare.export;
	char path[PATH_MAX + 1], beside[PATH_MAX + 1];
	const char *name = model ? split(model, beside) : "";
	int length = snprintf(
		path, sizeof(path), "%s/%s", folder ? folder : "", name);

	if (folder && length < (int)sizeof(path) && export_names(name) &&
		is_same_file(model, path)) {
		log_error(log,
			"--export %s: %s would be overwritten: give another folder",
			folder, model);
		return -EINVAL;
	}
	return 0;
}

/* Every file that an option names; those to write come last. */
enum {
	FILES_READ = 4,
	FILES = 12
};

static void list_files(
	const struct options *options, struct named_file files[FILES])
{
	const struct named_file all[FILES] = {
		{"MODEL", options->model_path},
		{"--config", options->common.config},
		{"--character", options->show.character},
		{"--script", options->input.script},
		{"--output", options->screen.output},
		{"--c", options->export.c},
		{"--plot", options->compare.plot},
		{"--record", options->show.record},
		{"--record-buttons", options->input.record_buttons},
		{"--stats", options->show.stats},
		{"--failsafe", options->show.failsafe},
		{"--watchdog", options->show.watchdog},
	};

	memcpy(files, all, sizeof(all));
}

static bool is_dash(const char *path)
{
	return path && strcmp(path, "-") == 0;
}

int options_read_dash(struct options *options, enum command_bit command,
	const struct log *log)
{
	struct named_file files[FILES];

	if (is_dash(options->screen.output) && command == FOR_POSE) {
		options->screen.output = "/dev/stdout";
	} else if (is_dash(options->screen.output) && command == FOR_CHARACTER) {
		options->screen.output = NULL;
	}
	list_files(options, files);
	for (int i = FILES_READ; i < FILES; i++) {
		if (is_dash(files[i].path)) {
			log_error(log,
				"%s -: only pose and character write to standard output: give the name of a file",
				files[i].option);
			return -EINVAL;
		}
	}
	return 0;
}

int options_check_files(const struct options *options, enum command_bit command,
	const struct log *log)
{
	struct named_file files[FILES];

	list_files(options, files);
	for (int i = FILES_READ; i < FILES; i++) {
		if (files[i].path &&
			(check_file(&files[i], files, log) != 0 ||
				check_ending(&files[i], command, log) != 0)) {
			return -EINVAL;
		}
	}
	return check_export(options, log);
}
