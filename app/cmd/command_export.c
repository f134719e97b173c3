#include "app/cmd/command.h"
#include "app/embed/embed.h"
#include "platform/base/output_file.h"
#include "platform/base/output_path.h"

#include <string.h>

enum {
	PREFIX_BYTES = 256
};

/* Makes the prefix of C names: "walker" for "out/walker.c". */
static void make_prefix(const char *path, char prefix[PREFIX_BYTES])
{
	const char *slash = strrchr(path, '/');

	snprintf(prefix, PREFIX_BYTES, "%s", slash ? slash + 1 : path);
	prefix[strcspn(prefix, ".")] = '\0';
}

static int write_source(const struct model *model, int clip, const char *path,
	const struct log *log, struct embed_size *size)
{
	char prefix[PREFIX_BYTES];
	struct output_file *file;
	int error = output_file_create_for("--c", path, log, &file);

	if (error) {
		return error;
	}
	/* A stream has no name to give them, so the model's is taken. */
	make_prefix(output_path_is_stream(path) ? model->path : path, prefix);
	error = embed_print(
		model, clip, prefix, log, output_file_stream(file), size);
	if (error) {
		output_file_discard(file);
		return error;
	}
	return output_file_commit(file);
}

static void print_result(const struct model *model, const char *path,
	const struct embed_size *size)
{
	FILE *out = output_path_report(path);

	fprintf(out, "%s: %zu bytes of tables (ROM), %zu bytes of state (RAM)\n",
		path, size->rom_bytes, size->ram_bytes);
	if (model->texture_count > 0) {
		fprintf(out, "%s: it leaves out the model's %d texture%s\n",
			path, model->texture_count,
			model->texture_count == 1 ? "" : "s");
	}
	if (size->dark_parts > 0) {
		fprintf(out,
			"%s: %d part%s no normals, so light leaves %s dark: export the model with normals, or draw without light\n",
			path, size->dark_parts,
			size->dark_parts == 1 ? " has" : "s have",
			size->dark_parts == 1 ? "it" : "them");
	}
}

static int run_with_model(const struct model *model,
	const struct options *options, const struct log *log)
{
	int first = model->clip_count > 0 ? 0 : -1;
	struct embed_size size;
	int clip;
	int error = model_choose_clip(
		model, options->motion.clip, first, log, &clip);

	if (!error) {
		error = write_source(model, clip, options->export.c, log, &size);
	}
	if (!error) {
		print_result(model, options->export.c, &size);
	}
	return error;
}

static int run(const struct options *options, const struct log *log)
{
	if (options->model_path && !options->export.c) {
		log_error(log,
			"export: there is no file to write: add --c FILE.c");
		return EXIT_USAGE;
	}
	return command_run_with_model(
		&command_export, options, log, run_with_model);
}

const struct command command_export = {
	.name = "export",
	.bit = FOR_EXPORT,
	.usage = "MODEL --c FILE.c",
	.summary = "write a model and a clip as C source",
	.detail =
		"limber writes const tables and a small player, for boards without a file system. The file\n"
		"needs nothing of limber, only <math.h>, <stdint.h> and <string.h>. limber prints how much ROM\n"
		"and RAM it takes. The source has vertices with normals and colours, materials' colours, skins,\n"
		"morph targets and one clip, but no textures.\n"
		"\n"
		"  limber export robot.glb --clip walk --c robot.c",
	.run = run,
};
