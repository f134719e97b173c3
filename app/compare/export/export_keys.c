#include "app/compare/export/export_keys.h"

#include "app/compare/export/export.h"

#include <errno.h>
#include <stdlib.h>

enum {
	ENDS = 2,
	/* levels of detail take time for each key frame */
	KEYS_MAX = 64,
	KEY_VERTICES_MAX = 2 * 1024 * 1024
};

static bool may_have(const struct comparison *comparison, int keys_of_clip)
{
	double keys = (double)keys_of_clip * comparison->clip_count;

	return keys <= KEYS_MAX &&
		keys * comparison->vertex_count <= KEY_VERTICES_MAX;
}

static bool has_facets(const struct model *model)
{
	for (int m = 0; m < model->mesh_count; m++) {
		const struct model_mesh *mesh = &model->mesh[m];

		for (int p = 0; p < mesh->primitive_count; p++) {
			if (!mesh->primitive[p].normal) {
				return true;
			}
		}
	}
	return false;
}

bool export_keys_differ(const struct comparison *comparison)
{
	return has_facets(comparison->model) && may_have(comparison, ENDS);
}

/* The clip's ends, and the middles of so many parts. */
static int set_keys(struct fit_keys *keys, float duration_s, int parts)
{
	keys->time_s = malloc((size_t)(parts + ENDS) * sizeof(*keys->time_s));
	if (!keys->time_s) {
		return -ENOMEM;
	}
	keys->time_s[keys->count++] = 0.0f;
	for (int i = 0; i < parts; i++) {
		keys->time_s[keys->count++] =
			duration_s * ((float)i + 0.5f) / (float)parts;
	}
	keys->time_s[keys->count++] = duration_s;
	return 0;
}

static int set_all_keys(
	const struct comparison *comparison, struct comparison_row *row)
{
	int parts = comparison->sampling.drawn_frames;
	int error = 0;

	if (!may_have(comparison, parts + ENDS)) {
		parts = 0;
	}
	row->total.key_count = 0;
	for (int c = 0; !error && c < comparison->clip_count; c++) {
		const struct model_clip *clip =
			&comparison->model->clip[comparison->clip[c].clip];
		struct fit_keys *keys = &row->cell[c].keys;

		error = set_keys(keys, clip->duration_s, parts);
		row->total.key_count += keys->count;
	}
	return error;
}

int export_keys_load(const struct comparison *comparison,
	const struct comparison_row *row, const struct log *log,
	struct model **out)
{
	struct comparison_row drawn = *row;
	int error;

	drawn.cell = calloc((size_t)comparison->clip_count, sizeof(*drawn.cell));
	error = drawn.cell ? set_all_keys(comparison, &drawn) : -ENOMEM;
	if (error) {
		log_error(log, "%s: there is not enough memory for key frames",
			comparison->model->path);
	} else {
		error = export_load(comparison, &drawn, log, out);
	}
	for (int c = 0; drawn.cell && c < comparison->clip_count; c++) {
		fit_keys_release(&drawn.cell[c].keys);
	}
	free(drawn.cell);
	return error;
}
