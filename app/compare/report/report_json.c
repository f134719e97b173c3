#include "app/compare/report/report.h"

#include "platform/base/json_memory.h"

#include "app/compare/candidate_morph.h"

#include <errno.h>

#include <jansson.h>

/* The member of a candidate that holds the cost. */
static const char *const cost_names[COMPARISON_COSTS] = {
	[COMPARISON_COST_PREDICTED] = "arm11_predicted",
	[COMPARISON_COST_INSTRUCTIONS] = "instructions_per_frame",
	[COMPARISON_COST_TIME] = "us_per_frame",
};

static json_t *matrix_json(const vec4 *matrix)
{
	json_t *array = json_array();

	for (int i = 0; i < 16; i++) {
		json_array_append_new(
			array, json_real((double)matrix[i / 4][i % 4]));
	}
	return array;
}

static json_t *keys_json(
	const struct comparison *comparison, const struct candidate *candidate)
{
	json_t *array = json_array();

	for (int i = 0; i < candidate->key_count; i++) {
		int frame = candidate_morph_keys(candidate)[i];

		json_array_append_new(array,
			json_real((double)comparison->reference->time_s[frame]));
	}
	return array;
}

static json_t *candidate_json(const struct comparison *comparison, int index)
{
	const struct candidate *candidate = &comparison->candidate[index];
	const struct technique_rating *rating =
		&technique_ratings[candidate->technique];
	json_t *json = json_pack(
		"{s:s, s:s, s:b, s:b, s:f, s:I, s:I, s:i, s:f, s:f, s:f, s:s, s:s, s:s}",
		"name", candidate->name, "technique", rating->name, "listed",
		candidate->listed, "advised", index == comparison->advised,
		"us_per_frame", candidate->frame_us, "ram_bytes",
		(json_int_t)candidate->memory_bytes, "file_bytes",
		(json_int_t)candidate->file_bytes, "vertices",
		candidate->vertex_count, "peak_px",
		(double)candidate->error.peak_px, "peak_s",
		(double)comparison->reference->time_s[candidate->error.peak_frame],
		"mean_px", (double)candidate->error.mean_px, "control",
		rating->control, "looks", rating->looks, "coding",
		rating->coding);

	if (json && candidate->instructions >= 0.0) {
		json_object_set_new(json, "instructions_per_frame",
			json_real(candidate->instructions));
	}
	if (json) {
		json_object_set_new(json, "arm11_predicted",
			json_pack("{s:f, s:f}", "us_per_frame",
				board_cost_us(&candidate->board),
				"instructions_per_frame",
				candidate->board.instructions));
	}
	if (json && candidate->key_count > 0) {
		json_object_set_new(
			json, "key_times_s", keys_json(comparison, candidate));
	}
	return json;
}

int report_print_json(const struct comparison *comparison, FILE *out)
{
	const struct reference *reference = comparison->reference;
	const struct screen_view *screen = &comparison->screen;
	json_t *candidates, *times, *root;
	int failed;

	json_memory_begin();
	candidates = json_array();
	times = json_array();
	for (int i = 0; i < comparison->candidate_count; i++) {
		json_array_append_new(candidates, candidate_json(comparison, i));
	}
	for (int i = 0; i < reference->frame_count; i++) {
		json_array_append_new(
			times, json_real((double)reference->time_s[i]));
	}
	root = json_pack(
		"{s:s, s:i, s:s, s:i, s:f, s:I, s:s, s:{s:i, s:i, s:f, s:o}, s:o, s:s, s:s, s:s, s:o}",
		"model", reference->model->path, "clip", reference->clip_index,
		"clip_name", reference->clip->name, "vertices",
		reference->vertex_count, "bound_px",
		(double)comparison->request.bound_px, "ram_limit_bytes",
		(json_int_t)comparison->request.memory_bytes, "kernel",
		comparison->request.kernel->name, "screen", "width",
		screen->width, "height", screen->height, "focal_px",
		(double)screen->focal_px, "view",
		matrix_json((const vec4 *)screen->view), "times_s", times,
		"advice", comparison->candidate[comparison->advised].name,
		"reason", comparison->reason, "advised_by",
		cost_names[comparison->cost], "candidates", candidates);
	if (!root) {
		return -ENOMEM;
	}
	if (!json_memory_ok()) {
		json_decref(root);
		return -ENOMEM;
	}
	failed = json_dumpf(root, out,
		JSON_INDENT(2) | JSON_ENSURE_ASCII | JSON_REAL_PRECISION(9));
	json_decref(root);
	fprintf(out, "\n");
	return failed && !ferror(out) ? -ENOMEM : 0;
}
