#include "app/cmd/info/info_report.h"
#include "app/cmd/time_text.h"
#include "platform/base/printable.h"

#include <errno.h>
#include <math.h>
#include <stdbool.h>

/* Prints a name, which may be empty, and the text after it. */
static void print_name(const char *name, const char *after, FILE *out)
{
	printable_put(name[0] ? name : "(unnamed)", out);
	fputs(after, out);
}

/* Prints each level's triangles and error. */
static void print_levels(const struct model_mesh *mesh, float unit_m, FILE *out)
{
	int count = model_level_count(mesh);

	for (int i = 0; i < count; i++) {
		struct model_level level = model_level(mesh, i);

		fprintf(out, "%s%d at %.3g mm%s",
			i ? ", " : "           levels: ", level.triangle_count,
			(double)(level.error_m * unit_m) * 1000.0,
			level.shadow_only ? " for shadows" : "");
	}
	if (count) {
		fprintf(out, "\n");
	}
}

static bool has_target_names(const struct model_mesh *mesh)
{
	for (int t = 0; t < mesh->target_count; t++) {
		if (mesh->target_name[t][0]) {
			return true;
		}
	}
	return false;
}

static void print_targets(const struct model_mesh *mesh, FILE *out)
{
	if (!has_target_names(mesh)) {
		return;
	}
	for (int t = 0; t < mesh->target_count; t++) {
		fputs(t ? ", " : "           targets: ", out);
		print_name(mesh->target_name[t], "", out);
	}
	fprintf(out, "\n");
}

static void print_meshes(const struct info_report *report, FILE *out)
{
	const struct model *model = report->model;

	fprintf(out, "\nmeshes     parts vertices triangles targets\n");
	for (int i = 0; i < model->mesh_count; i++) {
		const struct model_mesh *mesh = &model->mesh[i];
		struct model_stats stats = {0};

		model_stats_add_mesh(&stats, mesh);
		fprintf(out, "  %3d      %5d %8d %9d %7d  ", i,
			stats.primitive_count, stats.vertex_count,
			stats.triangle_count, mesh->target_count);
		print_name(mesh->name, "\n", out);
		print_targets(mesh, out);
		print_levels(mesh, report->unit_m[i], out);
	}
}

static void print_skins(const struct info_report *report, FILE *out)
{
	const struct model_stats *stats = &report->stats;
	const struct model *model = report->model;

	if (model->skin_count == 0) {
		return;
	}
	fprintf(out, "\nskins      joints\n");
	for (int i = 0; i < model->skin_count; i++) {
		fprintf(out, "  %3d      %6d  ", i, model->skin[i].joint_count);
		print_name(model->skin[i].name, "\n", out);
	}
	fprintf(out, "vertices by their number of influences:");
	for (int k = 1; k <= stats->max_influences; k++) {
		fprintf(out, " %s%d with %d", k > 1 ? "| " : "",
			stats->influence_histogram[k], k);
	}
	fprintf(out, "\n");
}

/* Returns how wide a column is that holds this value, at least least. */
static int column_width(double value, int decimals, int least)
{
	int length = snprintf(NULL, 0, "%.*f", decimals, value);

	return length > least ? length : least;
}

static void print_clips(const struct model *model, FILE *out)
{
	double longest_s = 0.0;
	int width[3]; /* of seconds, frames and ticks */

	if (model->clip_count == 0) {
		return;
	}
	for (int i = 0; i < model->clip_count; i++) {
		longest_s = fmax(longest_s, (double)model->clip[i].duration_s);
	}
	width[0] = column_width(longest_s, 2, 7);
	width[1] = column_width(longest_s * 30.0, 1, 6);
	width[2] = column_width(longest_s * TICKS_PER_SECOND, 0, 6);
	fprintf(out, "\nclips      %*s %*s %*s channels  keys\n", width[0],
		"seconds", width[1], "30 Hz", width[2], "ticks");
	for (int i = 0; i < model->clip_count; i++) {
		const struct model_clip *clip = &model->clip[i];
		double duration_s = (double)clip->duration_s;
		struct model_stats stats = {0};

		model_stats_add_clip(&stats, clip);
		fprintf(out, "  %3d      %*.2f %*.1f %*.0f %8d %5d  ", i,
			width[0], duration_s, width[1], duration_s * 30.0,
			width[2], duration_s * TICKS_PER_SECOND,
			stats.channel_count, stats.key_count);
		print_name(clip->name, "\n", out);
	}
}

static void print_images(const struct model *model, FILE *out)
{
	if (model->image_count == 0) {
		return;
	}
	fprintf(out, "\nimages     size\n");
	for (int i = 0; i < model->image_count; i++) {
		const struct model_image *image = &model->image[i];

		fprintf(out, "  %3d      %dx%d", i, image->file_width,
			image->file_height);
		if (image->width < image->file_width) {
			fprintf(out, " (read as %dx%d)", image->width,
				image->height);
		}
		fprintf(out, "%s  ", image->opaque ? "" : " with alpha");
		print_name(image->name, "\n", out);
	}
}

static void print_bytes_line(
	FILE *out, const char *what, size_t bytes, const char *remark)
{
	if (bytes > 0) {
		fprintf(out, "  %-13s %9zu  %s\n", what, bytes, remark);
	}
}

static void print_bytes(const struct info_report *report, FILE *out)
{
	const struct model_stats *stats = &report->stats;

	fprintf(out, "\nbytes in memory\n");
	print_bytes_line(out, "geometry", stats->geometry_bytes,
		"vertices and indices, the same for every technique");
	print_bytes_line(out, "hierarchical", report->hierarchical_bytes,
		"a transform and a matrix for each node");
	print_bytes_line(out, "morphing", report->morphing_bytes,
		"targets and morphed vertices");
	print_bytes_line(out, "skeletal", report->skeletal_bytes,
		"influences, palette and skinned vertices");
	print_bytes_line(out, "clips", stats->clip_bytes, "keys and times");
	print_bytes_line(out, "images", stats->image_bytes, "decoded");
}

static void print_count(int count, const char *one, const char *many, FILE *out)
{
	fprintf(out, ", %d %s", count, count == 1 ? one : many);
}

void info_print_text(const struct info_report *report, FILE *out)
{
	const struct model *model = report->model;
	const struct model_stats *stats = &report->stats;

	printable_put(model->path, out);
	fprintf(out, ": %s", model->format);
	print_count(model->node_count, "node", "nodes", out);
	print_count(stats->vertex_count, "vertex", "vertices", out);
	print_count(stats->triangle_count, "triangle", "triangles", out);
	print_count(model->material_count, "material", "materials", out);
	fprintf(out, "\n");
	print_meshes(report, out);
	print_skins(report, out);
	print_clips(model, out);
	print_images(model, out);
	print_bytes(report, out);
}
