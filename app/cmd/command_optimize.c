#include "app/character/text/character_text.h"
#include "app/cmd/command.h"
#include "app/cmd/progress.h"
#include "app/compare/optimize/optimize.h"
#include "app/model/model_file.h"
#include "platform/base/output_file.h"
#include "platform/base/output_path.h"
#include "platform/base/printable.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void show_progress(void *context, int done, int total)
{
	struct progress *progress = context;

	progress->total = total;
	progress_step(progress, done);
}

static bool is_binary(const struct model_file *file)
{
	return file->size >= 4 && memcmp(file->data, "glTF", 4) == 0;
}

static int write_file(const struct optimize_result *result, const char *path,
	const struct log *log)
{
	struct output_file *file;
	int error = output_file_create(path, log, &file);

	if (error) {
		return error;
	}
	fwrite(result->data, 1, result->after.file, output_file_stream(file));
	return output_file_commit(file);
}

/*
 * Takes the model's own file as the result, which it replaces, if that is a
 * .glb without other files and the result is larger: the members that limber
 * adds to a tiny file may take more bytes than it saves. Returns 0 or -errno,
 * with *kept.
 */
static int keep_smaller(struct optimize_result *result,
	const struct model *model, const struct log *log, bool *kept)
{
	struct model_file file = {NULL, 0, NULL};
	int error;

	*kept = false;
	if (result->after.file <= result->before.file) {
		return 0;
	}
	error = model_file_read(model->path, NULL, log, &file);
	if (!error && file.size == result->before.file && is_binary(&file)) {
		memcpy(result->data, file.data, file.size);
		result->after = result->before;
		result->peak_px = 0.0f;
		*kept = true;
	}
	model_file_release(&file);
	return error;
}

static void print_row(FILE *out, const char *name, size_t before, size_t after)
{
	fprintf(out, "  %-14s %10.1f %10.1f\n", name, (double)before / 1024.0,
		(double)after / 1024.0);
}

/* Says whether the file became smaller, if it did not. */
static void print_growth(
	FILE *out, const struct optimize_result *result, bool kept)
{
	if (kept) {
		fprintf(out,
			"limber found no smaller form: the file is written as it was.\n");
	} else if (result->after.file > result->before.file) {
		fprintf(out,
			"The file is %zu bytes larger than the model's, as that is so small.\n",
			result->after.file - result->before.file);
	}
}

/* Says that motion is left out which a program may need for a socket. */
static void print_idle(FILE *out, const struct optimize_idle *idle)
{
	if (idle->count == 0) {
		return;
	}
	fprintf(out, "The motion of nodes that move nothing (%d)", idle->count);
	if (idle->name[0]) {
		fputs(", such as ", out);
		printable_put(idle->name, out);
		fputc(',', out);
	}
	fputs(" is left out; give nodes extras to keep theirs.\n", out);
}

static void print_result(const struct optimize_result *result,
	const struct options *options, bool kept)
{
	const struct optimize_sizes *before = &result->before;
	const struct optimize_sizes *after = &result->after;
	FILE *out = output_path_report(options->screen.output);

	fprintf(out, "  %-14s %10s %10s\n", "KiB", "before", "after");
	print_row(out, "keys", before->keys, after->keys);
	print_row(out, "vertices", before->vertices, after->vertices);
	print_row(out, "indices", before->indices, after->indices);
	print_row(out, "all else", before->rest, after->rest);
	print_row(out, "the whole file", before->file, after->file);
	fprintf(out,
		"%ld of %ld keys are left. No vertex moves by more than %.3f px in %dx%d.\n",
		after->key_count, before->key_count, (double)result->peak_px,
		options->screen.size.width, options->screen.size.height);
	if (result->earlier_px > 0.0f) {
		fprintf(out,
			"An earlier run has used %g px of --error %g already.\n",
			(double)result->earlier_px,
			(double)options->compare.error_px);
	}
	if (!kept) {
		print_idle(out, &result->idle);
	}
	print_growth(out, result, kept);
}

static size_t text_bytes(const struct character_text *text)
{
	size_t bytes = 1;

	for (const struct character_section *section = text->first; section;
		section = section->next) {
		bytes += strlen(section->heading) + 1;
		for (const struct character_line *line = section->first; line;
			line = line->next) {
			bytes += strlen(line->key) + 1;
			for (int i = 0; i < line->word_count; i++) {
				bytes += strlen(line->word[i].text) + 1;
			}
		}
	}
	return bytes;
}

static char *append(char *to, const char *word)
{
	char *end = stpcpy(to, word);

	*end = ' ';
	return end + 1;
}

/* Returns all words of a character in one string, or NULL without memory. */
static const char *join_words(
	const struct character_text *text, struct arena *arena)
{
	char *words = ARENA_ARRAY(arena, char, text_bytes(text)), *to = words;
	const struct character_section *section = words ? text->first : NULL;

	for (; section; section = section->next) {
		to = append(to, section->heading);
		for (const struct character_line *line = section->first; line;
			line = line->next) {
			to = append(to, line->key);
			for (int i = 0; i < line->word_count; i++) {
				to = append(to, line->word[i].text);
			}
		}
	}
	if (words) {
		*to = '\0';
	}
	return words;
}

/*
 * Reads the character file beside the model and those that it includes: their
 * targets and anchors may be nodes that nothing drawn follows. *named is NULL
 * if there is none. The arena has the text. Returns 0, or -errno after logging
 * an error.
 */
static int read_character(const char *model_path, struct arena *arena,
	const struct log *log, const char **named)
{
	struct character_text text;
	char path[PATH_MAX];
	int error;

	*named = NULL;
	if (!character_text_path_beside(model_path, path, sizeof(path)) ||
		access(path, F_OK) != 0) {
		return 0;
	}
	error = character_text_load(&text, arena, path, log);
	if (!error) {
		*named = join_words(&text, arena);
		error = *named ? 0 : memory_budget_fail(NULL, path, log);
	}
	return error;
}

static int run_with_model(const struct model *model,
	const struct options *options, const struct log *log)
{
	struct progress progress = progress_begin(2, "steps", stderr);
	struct optimize_request request = {
		.bound_px = options->compare.error_px,
		.width = options->screen.size.width,
		.height = options->screen.size.height,
		.memory_bytes = options->common.memory_bytes,
		.progress = show_progress,
		.progress_context = &progress,
	};
	struct optimize_result result = {.data = NULL};
	struct arena arena = arena_empty();
	const char *output = options->screen.output;
	int error = output_file_try(NULL, output, log);
	bool kept = false;

	if (error) {
		return error;
	}
	error = read_character(model->path, &arena, log, &request.named);
	if (!error) {
		error = optimize_model(model, &request, log, &result);
		progress_end(&progress);
	}
	arena_release(&arena);
	if (!error) {
		error = keep_smaller(&result, model, log, &kept);
	}
	if (!error) {
		error = write_file(&result, output, log);
	}
	if (!error) {
		print_result(&result, options, kept);
	}
	free(result.data);
	return error;
}

static bool is_glb(const char *path)
{
	size_t length = strlen(path);

	return output_path_is_stream(path) ||
		(length > 4 && strcmp(path + length - 4, ".glb") == 0);
}

static int run(const struct options *options, const struct log *log)
{
	const char *output = options->screen.output;

	if (options->model_path && (!output || !is_glb(output))) {
		log_error(log,
			output ? "optimize: -o %s: the name of the file to write shall end in .glb"
			       : "optimize: there is no file to write: add -o FILE.glb",
			output);
		return EXIT_USAGE;
	}
	return command_run_with_model(
		&command_optimize, options, log, run_with_model);
}

const struct command command_optimize = {
	.name = "optimize",
	.bit = FOR_OPTIMIZE,
	.usage = "MODEL -o FILE.glb",
	.summary = "write a smaller glTF file",
	.detail =
		"limber leaves out keys that lie between others, stores numbers as integers where they suffice,\n"
		"puts vertices and triangles into the order that caches like, and removes what nothing uses. It\n"
		"plays the new file beside the old one: no vertex moves by more than --error pixels, between\n"
		"keys too. Names, materials, cameras, scenes and extras stay. A .glb that would grow is copied.\n"
		"\n"
		"The file states the error in asset.extras.limber_error_px, so that running limber optimize\n"
		"on it again with the same --error changes nothing.\n"
		"\n"
		"  limber optimize robot.glb -o small.glb\n"
		"  limber optimize robot.gltf --error 0.1 -o exact.glb",
	.run = run,
};
