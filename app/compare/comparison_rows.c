#include "app/compare/comparison_rows.h"

#include "app/model/model_stats.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

/* The bounds of morphs that are only plotted, as multiples of bound_px. */
static const float other_bounds[] = {0.25f, 0.5f, 2.0f, 4.0f};
static const int caps[] = {4, 2, 1};

bool comparison_rows_is_morph(const struct comparison_row *row)
{
	return row->kind == COMPARISON_MORPH ||
		row->kind == COMPARISON_MORPH_EVEN;
}

bool comparison_rows_show_inside(
	const struct comparison *comparison, int row, int clip)
{
	return comparison->clip[clip].turns &&
		comparison_rows_is_morph(&comparison->row[row]);
}

static bool has_targets(const struct model *model)
{
	for (int i = 0; i < model->mesh_count; i++) {
		if (model->mesh[i].target_count > 0) {
			return true;
		}
	}
	return false;
}

static bool moves_nodes(const struct model_clip *clip)
{
	for (int i = 0; i < clip->channel_count; i++) {
		if (clip->channel[i].path != MODEL_WEIGHTS &&
			!clip->channel[i].constant) {
			return true;
		}
	}
	return false;
}

/*
 * Whether rigid parts are a technique of their own: some node must move, and a
 * model that has only moving nodes consists of rigid parts already.
 */
static bool has_rigid_parts(const struct comparison *comparison)
{
	const struct model *model = comparison->model;

	if (model->skin_count == 0 && !has_targets(model)) {
		return false;
	}
	for (int c = 0; c < comparison->clip_count; c++) {
		if (moves_nodes(&model->clip[comparison->clip[c].clip])) {
			return true;
		}
	}
	return false;
}

static struct comparison_row *add_row(
	struct comparison *comparison, enum comparison_kind kind, bool listed)
{
	struct comparison_row *row = &comparison->row[comparison->row_count++];

	*row = (struct comparison_row){
		.kind = kind,
		.listed = listed,
		.technique = kind == COMPARISON_RIGID ? TECHNIQUE_HIERARCHICAL
						      : TECHNIQUE_MORPHING,
	};
	snprintf(row->name, sizeof(row->name), "%s",
		kind == COMPARISON_RIGID ? "rigid parts" : "morph");
	return row;
}

static enum technique technique_of(const struct model *model, bool targets)
{
	bool morphs = targets && has_targets(model);

	if (model->skin_count > 0) {
		return morphs ? TECHNIQUE_COMBINED : TECHNIQUE_SKELETAL;
	}
	return morphs ? TECHNIQUE_MORPHING : TECHNIQUE_HIERARCHICAL;
}

static void add_original(
	struct comparison *comparison, int max_influences, bool targets)
{
	static const char *const name[TECHNIQUE_COUNT] = {
		[TECHNIQUE_MORPHING] = "morph targets",
		[TECHNIQUE_HIERARCHICAL] = "nodes as they are",
		[TECHNIQUE_SKELETAL] = "skin",
		[TECHNIQUE_COMBINED] = "skin + morph",
	};
	struct comparison_row *row =
		add_row(comparison, COMPARISON_ORIGINAL, true);

	row->technique = technique_of(comparison->model, targets);
	row->max_influences = max_influences;
	row->targets = targets;
	if (max_influences > 0) {
		snprintf(row->name, sizeof(row->name), "%s, %d influence%s",
			name[row->technique], max_influences,
			max_influences > 1 ? "s" : "");
	} else {
		snprintf(row->name, sizeof(row->name), "%s",
			name[row->technique]);
	}
}

static void add_rows(struct comparison *comparison)
{
	const struct model *model = comparison->model;
	float bound_px = comparison->request.bound_px;
	/* Key frames are fitted to all moments. */
	bool fits = comparison->sampling.share >= 1.0;
	struct model_stats stats;

	model_measure(model, &stats);
	add_original(comparison, 0, true);
	if (has_targets(model) && model->skin_count > 0) {
		add_original(comparison, 0, false);
	}
	for (size_t i = 0; i < ARRAY_COUNT(caps); i++) {
		if (caps[i] < stats.max_influences) {
			add_original(comparison, caps[i], true);
		}
	}
	if (fits) {
		add_row(comparison, COMPARISON_MORPH, true)->bound_px = bound_px;
	}
	add_row(comparison, COMPARISON_MORPH_EVEN, true);
	if (has_rigid_parts(comparison)) {
		add_row(comparison, COMPARISON_RIGID, true);
	}
	for (size_t i = 0; fits && i < ARRAY_COUNT(other_bounds); i++) {
		add_row(comparison, COMPARISON_MORPH, false)->bound_px =
			bound_px * other_bounds[i];
	}
}

int comparison_rows_choose(struct comparison *comparison)
{
	add_rows(comparison);
	for (int i = 0; i < comparison->row_count; i++) {
		struct comparison_row *row = &comparison->row[i];

		row->cell = calloc(
			(size_t)comparison->clip_count, sizeof(*row->cell));
		if (!row->cell) {
			return -ENOMEM;
		}
	}
	return 0;
}

static void take_larger(float *most, float value)
{
	*most = value > *most ? value : *most;
}

static void add_error(struct comparison_total *total,
	const struct candidate_error *error, int clip, float share)
{
	if (error->peak_px > total->peak_px) {
		total->peak_px = error->peak_px;
		total->peak_clip = clip;
	}
	total->mean_px += error->mean_px * share;
	take_larger(&total->outline_px, error->outline_px);
	take_larger(&total->normal_deg, error->normal_deg);
	take_larger(&total->shade_steps, error->shade_steps);
}

size_t comparison_rows_weight_bytes(int key_count)
{
	return (size_t)key_count * (size_t)key_count * sizeof(float);
}

static void add_weights(struct comparison_total *total)
{
	size_t keys = (size_t)total->key_count;

	total->memory_bytes += comparison_rows_weight_bytes(total->key_count);
	/* The file stores weights that are not 0, with their indices. */
	total->file_bytes += keys * (sizeof(uint32_t) + sizeof(uint8_t));
}

static void sum_up(
	const struct comparison *comparison, struct comparison_row *row)
{
	struct comparison_total *total = &row->total;
	float share = 1.0f / (float)comparison->clip_count;

	*total = (struct comparison_total){0};
	for (int c = 0; c < comparison->clip_count; c++) {
		const struct comparison_cell *cell = &row->cell[c];
		struct board_cost board = board_frame_sum(&cell->board);

		add_error(total, &cell->error, c, share);
		total->frame_us += cell->time.frame_us * (double)share;
		total->instructions += cell->time.instructions * (double)share;
		board.cycles *= (double)share;
		board.instructions *= (double)share;
		board_cost_add(&total->board, &board);
		board = cell->board.draw;
		board.cycles *= (double)share;
		board.instructions *= (double)share;
		board_cost_add(&total->draw, &board);
		if (c == 0) {
			total->memory_bytes = cell->bytes.shared;
			total->file_bytes = cell->bytes.shared_file;
		}
		total->memory_bytes += cell->bytes.own;
		total->file_bytes += cell->bytes.own_file;
		total->key_count += cell->keys.count;
	}
	if (total->key_count > 0) {
		add_weights(total);
		snprintf(row->name, sizeof(row->name), "morph, %d keys%s",
			total->key_count,
			row->kind == COMPARISON_MORPH && row->listed &&
					total->peak_px <= row->bound_px
				? " fitted"
				: "");
	}
}

void comparison_rows_sum_up(struct comparison *comparison)
{
	for (int i = 0; i < comparison->row_count; i++) {
		sum_up(comparison, &comparison->row[i]);
	}
}
