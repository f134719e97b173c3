#include "app/compare/report/report.h"

#include "platform/base/json_memory.h"

#include <errno.h>

#include <jansson.h>

static json_t *matrix_json(const vec4 *matrix)
{
	json_t *array = json_array();

	for (int i = 0; i < 16; i++) {
		json_array_append_new(
			array, json_real((double)matrix[i / 4][i % 4]));
	}
	return array;
}

static json_t *times_json(const float *time_s, int count)
{
	json_t *array = json_array();

	for (int i = 0; i < count; i++) {
		json_array_append_new(array, json_real((double)time_s[i]));
	}
	return array;
}

static json_t *cost_json(const struct board_cost *cost)
{
	return json_pack("{s:f, s:f}", "us_per_frame", board_cost_us(cost),
		"instructions_per_frame", cost->instructions);
}

static void set_cost(
	json_t *json, double instructions, const struct board_cost *board)
{
	if (instructions >= 0.0) {
		json_object_set_new(json, "instructions_per_frame",
			json_real(instructions));
	}
	json_object_set_new(json, "arm11_predicted", cost_json(board));
}

static json_t *cell_json(const struct comparison_cell *cell)
{
	const struct candidate_error *error = &cell->error;
	struct board_cost board;
	json_t *json = json_pack(
		"{s:f, s:f, s:f, s:f, s:f, s:f, s:i, s:f, s:I, s:I, s:I, s:I}",
		"peak_px", (double)error->peak_px, "peak_s",
		(double)error->peak_s, "mean_px", (double)error->mean_px,
		"outline_px", (double)error->outline_px, "normal_deg",
		(double)error->normal_deg, "shade_steps",
		(double)error->shade_steps, "samples", error->samples,
		"us_per_frame", cell->time.frame_us, "ram_bytes_shared",
		(json_int_t)cell->bytes.shared, "ram_bytes_own",
		(json_int_t)cell->bytes.own, "file_bytes_shared",
		(json_int_t)cell->bytes.shared_file, "file_bytes_own",
		(json_int_t)cell->bytes.own_file);

	if (json) {
		board = board_frame_sum(&cell->board);
		set_cost(json, cell->time.instructions, &board);
		json_object_set_new(json, "arm11_split",
			json_pack("{s:o, s:o, s:o, s:o}", "sample",
				cost_json(&cell->board.sample), "matrices",
				cost_json(&cell->board.matrices), "vertices",
				cost_json(&cell->board.vertices), "draw",
				cost_json(&cell->board.draw)));
	}
	if (json && cell->keys.count > 0) {
		json_object_set_new(json, "key_times_s",
			times_json(cell->keys.time_s, cell->keys.count));
	}
	return json;
}

static json_t *row_json(const struct comparison *comparison, int index)
{
	const struct comparison_row *row = &comparison->row[index];
	const struct comparison_total *total = &row->total;
	const struct technique_rating *rating =
		&technique_ratings[row->technique];
	json_t *cells = json_array(), *json;

	for (int c = 0; c < comparison->clip_count; c++) {
		json_array_append_new(cells, cell_json(&row->cell[c]));
	}
	json = json_pack(
		"{s:s, s:s, s:b, s:b, s:b, s:f, s:I, s:I, s:i, s:f, s:f, s:f, s:f, s:f, s:i, s:s, s:s, s:s, s:o}",
		"name", row->name, "technique", rating->name, "listed",
		row->listed, "front", row->front, "advised",
		index == comparison->advised, "us_per_frame", total->frame_us,
		"ram_bytes", (json_int_t)total->memory_bytes, "file_bytes",
		(json_int_t)total->file_bytes, "vertices",
		row->cell[0].vertex_count, "peak_px", (double)total->peak_px,
		"mean_px", (double)total->mean_px, "outline_px",
		(double)total->outline_px, "normal_deg",
		(double)total->normal_deg, "shade_steps",
		(double)total->shade_steps, "keys", total->key_count, "control",
		rating->control, "looks", rating->looks, "coding",
		rating->coding, "clips", cells);
	if (json) {
		set_cost(json, total->instructions, &total->board);
		json_object_set_new(
			json, "arm11_drawing", cost_json(&total->draw));
	}
	return json;
}

static json_t *clip_json(const struct comparison *comparison, int index)
{
	const struct comparison_clip *clip = &comparison->clip[index];
	const struct model_clip *from = &comparison->model->clip[clip->clip];
	const struct screen_view *screen = &clip->screen;

	return json_pack("{s:i, s:s, s:f, s:s, s:o, s:{s:i, s:i, s:f, s:o}}",
		"clip", clip->clip, "name", from->name, "duration_s",
		(double)from->duration_s, "plan",
		comparison->row[clip->row].name, "times_s",
		times_json(clip->grid.time_s, clip->grid.count), "screen",
		"width", screen->width, "height", screen->height, "focal_px",
		(double)screen->focal_px, "view",
		matrix_json((const vec4 *)screen->view));
}

static json_t *report_json(const struct comparison *comparison)
{
	const struct comparison_request *request = &comparison->request;
	json_t *rows = json_array(), *clips = json_array();

	for (int i = 0; i < comparison->row_count; i++) {
		json_array_append_new(rows, row_json(comparison, i));
	}
	for (int c = 0; c < comparison->clip_count; c++) {
		json_array_append_new(clips, clip_json(comparison, c));
	}
	return json_pack(
		"{s:s, s:i, s:f, s:f, s:s, s:I, s:f, s:f, s:I, s:s, s:s, s:s, s:s, s:{s:b, s:I, s:f}, s:f, s:o, s:o}",
		"model", comparison->model->path, "vertices",
		comparison->vertex_count, "bound_px", (double)request->bound_px,
		"rate_hz", request->rate_hz, "board", request->board->name,
		"ram_limit_bytes", (json_int_t)comparison->memory_limit_bytes,
		"frame_limit_us", comparison->time_limit_us, "board_frame_ms",
		request->board->frame_ms, "bytes_per_percent",
		(json_int_t)request->board->bytes_per_percent, "kernel",
		request->kernel->name, "advice",
		comparison->row[comparison->advised].name, "reason",
		comparison->reason, "advised_by", "arm11_predicted",
		"mixed_plan", "better", comparison->mixed, "ram_bytes",
		(json_int_t)comparison->mixed_bytes, "us_per_frame",
		comparison->mixed_us, "compared_share",
		comparison->sampling.share, "clips", clips, "candidates", rows);
}

int report_print_json(const struct comparison *comparison, FILE *out)
{
	json_t *root;
	int failed;

	json_memory_begin();
	root = report_json(comparison);
	if (!root || !json_memory_ok()) {
		json_decref(root);
		/* With enough memory, only names that are not UTF-8 fail. */
		return json_memory_ok() ? -EINVAL : -ENOMEM;
	}
	failed = json_dumpf(root, out,
		JSON_INDENT(2) | JSON_ENSURE_ASCII | JSON_REAL_PRECISION(9));
	json_decref(root);
	fprintf(out, "\n");
	return failed && !ferror(out) ? -ENOMEM : 0;
}
