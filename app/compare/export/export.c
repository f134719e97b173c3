#include "app/compare/export/export.h"

#include "app/compare/export/export_bake.h"
#include "app/model/model_file.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Names a row's file; "" for the model itself, which is a file already. */
static void name_file(const struct comparison_row *row, char *text, size_t size)
{
	switch (row->kind) {
	case COMPARISON_MORPH:
		snprintf(text, size, "morph-%d.glb", row->total.key_count);
		break;
	case COMPARISON_MORPH_EVEN:
		snprintf(text, size, "morph-even-%d.glb", row->total.key_count);
		break;
	case COMPARISON_RIGID:
		snprintf(text, size, "rigid.glb");
		break;
	default:
		if (row->max_influences > 0) {
			snprintf(text, size, "skin-%d.glb", row->max_influences);
		} else {
			snprintf(text, size, "%s",
				row->targets ? "" : "skin.glb");
		}
		break;
	}
}

bool export_names(const char *name)
{
	static const char *const begin[] = {
		"morph-", "rigid.", "skin-", "skin."};
	const char *ending = strrchr(name, '.');

	for (size_t i = 0; i < ARRAY_COUNT(begin); i++) {
		if (strncmp(name, begin[i], strlen(begin[i])) == 0) {
			return strcmp(ending ? ending : "", ".glb") == 0;
		}
	}
	return false;
}

static int bake_rigid(struct glb *glb, const struct comparison *comparison,
	const struct log *log)
{
	struct candidate candidate;
	struct reference *reference;
	int error = reference_create(
		comparison->model, comparison->clip[0].clip, log, &reference);

	if (error) {
		return error;
	}
	error = candidate_rigid(&candidate, reference, log);
	if (!error) {
		export_rigid(glb, candidate_rigid_bake(&candidate), comparison);
	}
	candidate_destroy(&candidate);
	reference_destroy(reference);
	return error;
}

/* Adds all contents of a row's file. */
static int bake_row(struct glb *glb, const struct comparison *comparison,
	const struct comparison_row *row, const struct log *log)
{
	switch (row->kind) {
	case COMPARISON_ORIGINAL:
		export_skin(glb, comparison, row->max_influences, row->targets);
		return 0;
	case COMPARISON_RIGID:
		return bake_rigid(glb, comparison, log);
	default:
		return export_morph(glb, comparison, row, log);
	}
}

/* Replaces the pixels of shared_image(): the loader keeps used images alone. */
static void share_images(const struct model *from, struct model *to)
{
	for (int i = 0; i < to->image_count; i++) {
		to->image[i] = from->image[atoi(to->image[i].name)];
	}
}

int export_load(const struct comparison *comparison,
	const struct comparison_row *row, const struct log *log,
	struct model **out)
{
	const char *path = comparison->model->path;
	struct glb glb;
	uint8_t *data;
	size_t size;
	int error;

	glb_begin_memory(&glb);
	glb.shares_images = true;
	error = bake_row(&glb, comparison, row, log);
	if (error) {
		glb_discard(&glb);
		return error;
	}
	error = glb_write_memory(&glb, path, log, &data, &size);
	if (!error) {
		error = model_load_memory(data, size, path, log, out);
		free(data);
	}
	if (!error) {
		share_images(comparison->model, *out);
	}
	return error;
}

static int export_row(const struct comparison *comparison,
	const struct comparison_row *row, const char *path,
	const struct log *log)
{
	struct glb glb;
	int error;

	glb_begin(&glb);
	error = bake_row(&glb, comparison, row, log);
	if (error) {
		glb_discard(&glb);
		return error;
	}
	export_origin(&glb, comparison->model);
	return glb_write(&glb, path, log);
}

static int check_folder(const char *folder, const struct log *log)
{
	int error = access(folder, W_OK | X_OK) == 0 ? 0 : -errno;

	if (error) {
		log_error(log,
			"--export %s: the folder cannot be written: %s: choose one that you may write to",
			folder, strerror(-error));
	}
	return error;
}

int export_make_folder(const char *folder, const struct log *log)
{
	int error;

	if (mkdir(folder, 0777) == 0) {
		return 0;
	}
	error = -errno;
	if (error == -EEXIST) {
		struct stat found;

		if (stat(folder, &found) == 0 && S_ISDIR(found.st_mode)) {
			return check_folder(folder, log);
		}
		error = -ENOTDIR;
	}
	log_error(log,
		"--export %s: the folder cannot be made: %s: name another one, in a folder that exists",
		folder, strerror(-error));
	return error;
}

/* Warns about a file that limber would write but could not load. */
static bool is_too_large(const struct comparison_row *row, const char *folder,
	const char *name, const struct log *log)
{
	if (row->total.file_bytes <= MODEL_FILE_BYTES_MAX) {
		return false;
	}
	log_warning(log,
		"--export %s: %s is not written: it would have %zu MiB, and limber reads up to %d MiB: compare fewer clips, by --clip",
		folder, name, row->total.file_bytes >> 20,
		MODEL_FILE_BYTES_MAX >> 20);
	return true;
}

int export_comparison(const struct comparison *comparison, const char *folder,
	const struct log *log)
{
	int error = export_make_folder(folder, log);

	for (int i = 0; !error && i < comparison->row_count; i++) {
		const struct comparison_row *row = &comparison->row[i];
		char name[40], path[PATH_MAX];
		int length;

		name_file(row, name, sizeof(name));
		if (!row->listed || !name[0] ||
			is_too_large(row, folder, name, log)) {
			continue;
		}
		length = snprintf(path, sizeof(path), "%s/%s", folder, name);
		if ((size_t)length >= sizeof(path)) {
			log_error(log,
				"--export %s: the name is too long: choose a shorter one",
				folder);
			return -ENAMETOOLONG;
		}
		error = export_row(comparison, row, path, log);
	}
	return error;
}
