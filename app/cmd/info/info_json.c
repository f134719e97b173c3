#include "app/cmd/info/info_report.h"

#include "platform/base/json_memory.h"

#include <errno.h>

#include <jansson.h>

/*
 * json_array_append_new() and json_pack() fail if a value is NULL, so values
 * are not checked one by one.
 */

static json_t *levels(const struct model_mesh *mesh, float unit_m)
{
	json_t *array = json_array();

	for (int i = 0; i < model_level_count(mesh); i++) {
		struct model_level level = model_level(mesh, i);

		json_array_append_new(array,
			json_pack("{s:i, s:f, s:b}", "triangles",
				level.triangle_count, "error_m",
				(double)(level.error_m * unit_m), "shape",
				level.shadow_only ? 1 : 0));
	}
	return array;
}

static json_t *meshes(const struct info_report *report)
{
	const struct model *model = report->model;
	json_t *array = json_array();

	for (int i = 0; i < model->mesh_count; i++) {
		const struct model_mesh *mesh = &model->mesh[i];
		struct model_stats stats = {0};
		json_t *targets = json_array();

		model_stats_add_mesh(&stats, mesh);
		for (int t = 0; t < mesh->target_count; t++) {
			json_array_append_new(
				targets, json_string(mesh->target_name[t]));
		}
		json_array_append_new(array,
			json_pack("{s:s, s:i, s:i, s:i, s:o, s:o}", "name",
				mesh->name, "primitives", stats.primitive_count,
				"vertices", stats.vertex_count, "triangles",
				stats.triangle_count, "targets", targets,
				"levels", levels(mesh, report->unit_m[i])));
	}
	return array;
}

static json_t *skins(const struct model *model)
{
	json_t *array = json_array();

	for (int i = 0; i < model->skin_count; i++) {
		json_array_append_new(array,
			json_pack("{s:s, s:i}", "name", model->skin[i].name,
				"joints", model->skin[i].joint_count));
	}
	return array;
}

static json_t *clips(const struct model *model)
{
	json_t *array = json_array();

	for (int i = 0; i < model->clip_count; i++) {
		const struct model_clip *clip = &model->clip[i];
		struct model_stats stats = {0};

		model_stats_add_clip(&stats, clip);
		json_array_append_new(array,
			json_pack("{s:s, s:f, s:i, s:i}", "name", clip->name,
				"duration_s", (double)clip->duration_s,
				"channels", stats.channel_count, "keys",
				stats.key_count));
	}
	return array;
}

static json_t *images(const struct model *model)
{
	json_t *array = json_array();

	for (int i = 0; i < model->image_count; i++) {
		json_array_append_new(array,
			json_pack("{s:s, s:i, s:i}", "name", model->image[i].name,
				"width", model->image[i].file_width, "height",
				model->image[i].file_height));
	}
	return array;
}

/* Parents come before their children; -1 is none. */
static json_t *hierarchy(const struct model *model)
{
	json_t *array = json_array();

	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];

		json_array_append_new(array,
			json_pack("{s:s, s:i, s:i}", "name", node->name,
				"parent", node->parent, "mesh", node->mesh));
	}
	return array;
}

/* Element k is the number of vertices with k influences. */
static json_t *influences(const struct model_stats *stats)
{
	json_t *array = json_array();

	for (int k = 0; k <= stats->max_influences; k++) {
		json_array_append_new(
			array, json_integer(stats->influence_histogram[k]));
	}
	return array;
}

static json_t *bytes(const struct info_report *report)
{
	const struct model_stats *stats = &report->stats;

	return json_pack("{s:I, s:I, s:I, s:I, s:I, s:I}", "geometry",
		(json_int_t)stats->geometry_bytes, "hierarchical",
		(json_int_t)report->hierarchical_bytes, "morphing",
		(json_int_t)report->morphing_bytes, "skeletal",
		(json_int_t)report->skeletal_bytes, "clips",
		(json_int_t)stats->clip_bytes, "images",
		(json_int_t)stats->image_bytes);
}

int info_print_json(const struct info_report *report, bool nodes,
	const struct log *log, FILE *out)
{
	const struct model *model = report->model;
	const struct model_stats *stats = &report->stats;
	json_t *root;
	int error = 0;

	json_memory_begin();
	root = json_pack(
		"{s:s, s:s, s:i, s:i, s:i, s:i, s:i, s:o, s:o, s:o, s:o, s:o, s:o, s:o*}",
		"file", model->path, "format", model->format, "nodes",
		model->node_count, "vertices", stats->vertex_count, "triangles",
		stats->triangle_count, "materials", model->material_count,
		"joints", report->joint_count, "meshes", meshes(report),
		"skins", skins(model), "influences", influences(stats), "clips",
		clips(model), "images", images(model), "bytes", bytes(report),
		"hierarchy", nodes ? hierarchy(model) : NULL);

	if (!json_memory_ok()) {
		log_error(log, "%s: there is not enough memory", model->path);
		json_decref(root);
		return -ENOMEM;
	}
	if (!root) {
		log_error(log,
			"%s: a name in it is not UTF-8, which JSON requires: use limber info without --json",
			model->path);
		return -EINVAL;
	}
	if (json_dumpf(root, out, JSON_INDENT(2) | JSON_ENSURE_ASCII) != 0 &&
		!ferror(out)) {
		log_error(log, "%s: there is not enough memory", model->path);
		error = -ENOMEM;
	}
	fputc('\n', out);
	json_decref(root);
	return error;
}
