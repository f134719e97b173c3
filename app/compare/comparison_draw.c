#include "app/compare/comparison_draw.h"

#include "app/compare/comparison_rows.h"
#include "app/compare/cost/drawing.h"
#include "app/compare/export/export.h"
#include "app/compare/export/export_keys.h"
#include "app/model/levels/levels.h"
#include "app/scene/instance/instance_play.h"

#include <cglm/cglm.h>

struct painter {
	struct comparison *comparison;
	const struct log *log;
	int row; /* that is drawn; 0 is the model itself */
	const struct model *model;
	struct instance *instance;
	struct clip_cursor cursor;
	struct drawing *drawing;
	float extent;
};

/*
 * Returns the number of the drawn model's clip for comparison->clip[index], or
 * -1. An exported model has only the compared clips, so that index is its clip.
 */
static int find_clip(const struct painter *painter, int index)
{
	const struct comparison *comparison = painter->comparison;
	int clip = painter->model == comparison->model
		? comparison->clip[index].clip
		: index;

	return clip < painter->model->clip_count ? clip : -1;
}

static void add_less(struct board_cost *saved, const struct board_cost *all,
	const struct board_cost *drawn)
{
	saved->cycles += all->cycles - drawn->cycles;
	saved->instructions += all->instructions - drawn->instructions;
}

/*
 * Adds what posing and gathering take less because the level of detail that is
 * drawn has fewer vertices than all triangles. Key frames are quoted without
 * gathering (candidate_morph.c), which each of their drawables takes.
 */
static void add_saved(const struct painter *painter, struct board_cost *saved)
{
	const struct instance *instance = painter->instance;
	bool keys = comparison_rows_is_morph(
		&painter->comparison->row[painter->row]);

	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];
		struct board_cost all = {0.0, 0.0}, drawn;

		if (keys || drawable->morphed || drawable->skin >= 0) {
			drawn = board_cost_gather_drawn(drawable);
			if (!keys) {
				all = board_cost_gather(drawable);
			}
			add_less(saved, &all, &drawn);
		}
		if (!keys && drawable->skin >= 0) {
			all = board_cost_skin_left_out(drawable);
			board_cost_add(saved, &all);
		}
	}
}

/* Draws the moment after this share of the clip, if there is one. */
static void draw_moment(
	struct painter *painter, const struct model_clip *clip, float share)
{
	struct instance *instance = painter->instance;

	if (clip) {
		clip_pose(clip, clip->duration_s * share, CLIP_AUTO,
			&painter->cursor, &instance->pose);
	}
	instance_update(instance);
	drawing_draw(painter->drawing, instance, painter->extent);
}

/*
 * Draws frames of a clip; both results are means of a frame. As in the player,
 * the clip's first picture chooses levels of detail, which the next ones keep
 * unless the distance changes much.
 */
static void count_clip(struct painter *painter, int index,
	struct board_cost *cost, struct board_cost *saved)
{
	struct instance *instance = painter->instance;
	int found = find_clip(painter, index);
	const struct model_clip *clip =
		found >= 0 ? &painter->model->clip[found] : NULL;
	const struct comparison_request *request = &painter->comparison->request;
	struct gl_counts counts = {0};
	struct drawing_shadow shadow = {0};
	struct board_cost laid;
	int frames = painter->comparison->sampling.drawn_frames;
	struct bounds box = bounds_of_clip(instance, found);

	*saved = (struct board_cost){0};
	drawing_frame(painter->drawing, &box);
	instance->lod_px_per_unit = 0.0f;
	draw_moment(painter, clip, 0.0f);
	drawing_count(painter->drawing, &counts, &shadow);
	for (int i = 0; i < frames; i++) {
		draw_moment(painter, clip, ((float)i + 0.5f) / (float)frames);
		add_saved(painter, saved);
	}
	saved->cycles /= frames;
	saved->instructions /= frames;
	drawing_count(painter->drawing, NULL, NULL);
	gl_counts_scale(&counts, 1.0 / frames);
	*cost = board_cost_draw(
		&counts, (double)request->width * (double)request->height);
	laid = board_cost_lay(shadow.points / frames, shadow.rays / frames);
	board_cost_add(cost, &laid);
}

static bool draw_alike(const struct comparison *comparison, int a, int b)
{
	const struct comparison_row *one = &comparison->row[a];
	const struct comparison_row *other = &comparison->row[b];

	if (a == 0 || b == 0) {
		return a == b;
	}
	/* Morphs draw the same triangles, whatever their number of keys is. */
	if (comparison_rows_is_morph(one)) {
		return comparison_rows_is_morph(other);
	}
	return one->kind == other->kind &&
		one->max_influences == other->max_influences &&
		one->targets == other->targets;
}

static void take_saved(struct board_frame *frame, const struct board_cost *saved)
{
	frame->vertices.cycles -= saved->cycles;
	frame->vertices.instructions -= saved->instructions;
}

static void predict(struct painter *painter)
{
	struct comparison *comparison = painter->comparison;

	for (int c = 0; c < comparison->clip_count; c++) {
		struct board_cost cost, saved;

		count_clip(painter, c, &cost, &saved);
		for (int r = 0; r < comparison->row_count; r++) {
			struct comparison_row *row = &comparison->row[r];

			if (draw_alike(comparison, r, painter->row)) {
				row->cell[c].board.draw = cost;
				take_saved(&row->cell[c].board, &saved);
			}
		}
	}
}

static int begin_drawing(struct painter *painter)
{
	const struct comparison *comparison = painter->comparison;
	const struct comparison_request *request = &comparison->request;
	float unit = painter->instance->unit_scale;
	struct bounds box = comparison->box; /* in model units */

	glm_vec3_scale(box.low, unit, box.low);
	glm_vec3_scale(box.high, unit, box.high);
	painter->instance->normal_mapping = false;
	painter->extent = drawing_extent(painter->instance);
	return drawing_create(painter->instance, &box, request->width,
		request->height, painter->log, &painter->drawing);
}

static int draw_model(struct painter *painter)
{
	const struct model *model = painter->model;
	int error = instance_create_to_play(
		model, kernel_find("fixed"), painter->log, &painter->instance);

	if (error) {
		return error;
	}
	error = clip_cursor_init(
		&painter->cursor, model, &painter->instance->arena);
	if (error) {
		error = memory_budget_fail(
			model->budget, model->path, painter->log);
	}
	if (!error) {
		error = begin_drawing(painter);
	}
	if (!error && model == painter->comparison->model &&
		comparison_rows_is_morph(
			&painter->comparison->row[painter->row])) {
		drawing_show_keys(painter->drawing);
	}
	if (!error) {
		predict(painter);
	}
	drawing_destroy(painter->drawing);
	instance_destroy(painter->instance);
	return error;
}

/* Loads the row's file as it is drawn; *out stays NULL for the model itself. */
static int load_drawn(struct comparison *comparison, int row,
	const struct log *log, struct model **out)
{
	bool keys = comparison_rows_is_morph(&comparison->row[row]);
	int error;

	if (row == 0 || (keys && !export_keys_differ(comparison))) {
		return 0;
	}
	error = (keys ? export_keys_load : export_load)(
		comparison, &comparison->row[row], log, out);
	if (error) {
		return error;
	}
	return levels_make(*out) == 0
		? 0
		: memory_budget_fail((*out)->budget, (*out)->path, log);
}

/*
 * Draws a row. For key frames it draws the model where that looks the same, so
 * that none need be baked.
 */
static int draw_row(
	struct comparison *comparison, int row, const struct log *log)
{
	struct painter painter = {
		.comparison = comparison, .log = log, .row = row};
	struct model *exported = NULL;
	int error = load_drawn(comparison, row, log, &exported);

	if (!error) {
		painter.model = exported ? exported : comparison->model;
		error = draw_model(&painter);
	}
	if (exported) {
		model_destroy(exported);
	}
	return error;
}

static bool is_drawn_before(const struct comparison *comparison, int row)
{
	for (int i = 0; i < row; i++) {
		if (draw_alike(comparison, i, row)) {
			return true;
		}
	}
	return false;
}

int comparison_draw_predict(struct comparison *comparison, const struct log *log)
{
	/* The model's warnings were shown when it was loaded. */
	struct log errors = *log;
	int error = 0;

	errors.threshold = LOG_ERROR;
	for (int i = 0; i < comparison->row_count && !error; i++) {
		if (!is_drawn_before(comparison, i)) {
			error = draw_row(comparison, i, &errors);
		}
	}
	return error;
}
