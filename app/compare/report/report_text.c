#include "app/compare/report/report.h"

#include "app/anim/kernel/arm11_cost.h"
#include "platform/base/printable.h"

#include <string.h>

/* The example in AN4044, section 4. */
enum {
	AN4044_KEYS = 20,
	AN4044_VERTICES = 4000
};

static double kilobytes(size_t bytes)
{
	return (double)bytes / 1024.0;
}

static const struct model_clip *clip_of(
	const struct comparison *comparison, int clip)
{
	return &comparison->model->clip[comparison->clip[clip].clip];
}

static void print_clip_name(
	const struct comparison *comparison, int clip, FILE *out)
{
	const char *name = clip_of(comparison, clip)->name;

	fprintf(out, "%d%s", comparison->clip[clip].clip, name[0] ? " " : "");
	printable_put(name, out);
}

static void print_sampling(const struct comparison *comparison, FILE *out)
{
	if (comparison->sampling.share < 1.0) {
		fprintf(out,
			"The clips are long together: errors are those of %.2g%% of their moments. Key frames\n"
			"are not fitted to an error, which needs all moments.%s\n",
			100.0 * comparison->sampling.share,
			comparison->clip_count > 1 ? " --clip compares one clip."
						   : "");
	}
}

static void print_head(const struct comparison *comparison, FILE *out)
{
	const struct comparison_request *request = &comparison->request;
	const struct board_profile *board = request->board;
	double seconds = 0.0;

	printable_put(comparison->model->path, out);
	if (comparison->clip_count == 1) {
		fprintf(out, ", clip ");
		print_clip_name(comparison, 0, out);
	} else {
		fprintf(out, ", %d clips", comparison->clip_count);
	}
	for (int c = 0; c < comparison->clip_count; c++) {
		seconds += (double)clip_of(comparison, c)->duration_s;
	}
	fprintf(out, ": %.2f s; %d %s, %d %s\n", seconds,
		comparison->vertex_count,
		comparison->vertex_count == 1 ? "vertex" : "vertices",
		comparison->model->node_count,
		comparison->model->node_count == 1 ? "node" : "nodes");
	fprintf(out,
		"\"ARM11\" is the whole frame without labels, which is posing and drawing, predicted\n"
		"for an ARM1136 at %d MHz by the timing model, not measured. Errors are in pixels\n"
		"of a %dx%d screen, normals in degrees, shades in 63rds of white.\n"
		"Board %s: %s; limits: %.0f KiB, %.3g ms, %g px.\n",
		ARM11_MHZ, request->width, request->height, board->name,
		board->summary, kilobytes(comparison->memory_limit_bytes),
		comparison->time_limit_us * 1e-3, (double)request->bound_px);
	print_sampling(comparison, out);
	fprintf(out, "\n");
}

static void print_instructions(double instructions, FILE *out)
{
	if (instructions < 0.0) {
		fprintf(out, "%8s", "-");
	} else {
		fprintf(out, "%8.0f", instructions / 1000.0);
	}
}

static void print_row(const struct comparison *comparison, int index, FILE *out)
{
	const struct comparison_row *row = &comparison->row[index];
	const struct comparison_total *total = &row->total;
	double us = board_cost_us(&total->board);
	double draw_us = board_cost_us(&total->draw);

	fprintf(out, "%c%c%-25s %8.0f %7.1f %8.0f %8.1f %8.1f %7.3f\n",
		index == comparison->advised ? '>' : ' ',
		row->front ? '*' : ' ', row->name, us, us - draw_us, draw_us,
		kilobytes(total->memory_bytes), kilobytes(total->file_bytes),
		(double)total->peak_px);
}

static void print_rows(const struct comparison *comparison, FILE *out)
{
	fprintf(out, "  %-25s %8s %7s %8s %8s %8s %7s\n", "a frame takes",
		"ARM11 us", "posing", "drawing", "KiB RAM", "KiB file",
		"peak px");
	for (int i = 0; i < comparison->row_count; i++) {
		if (comparison->row[i].listed) {
			print_row(comparison, i, out);
		}
	}
	fprintf(out,
		"  *: on the Pareto front: nothing else is better in time, memory and peak error\n");
}

static void print_looks(const struct comparison *comparison, FILE *out)
{
	fprintf(out, "\n  %-25s %8s %8s %7s %6s %8s %8s\n",
		"how it looks; posing here", "mean px", "outline", "normal",
		"shade", "us here", "k instr.");
	for (int i = 0; i < comparison->row_count; i++) {
		const struct comparison_row *row = &comparison->row[i];
		const struct comparison_total *total = &row->total;

		if (!row->listed) {
			continue;
		}
		fprintf(out, "  %-25s %8.3f %8.3f %7.2f %6.1f %8.1f ",
			row->name, (double)total->mean_px,
			(double)total->outline_px, (double)total->normal_deg,
			(double)total->shade_steps, total->frame_us);
		print_instructions(total->instructions, out);
		fprintf(out, "\n");
	}
	fprintf(out,
		"  us here: of posing, measured on this machine, kernel %s\n",
		comparison->request.kernel->name);
}

enum {
	CLIP_NAME_MIN = 17,
	CLIP_NAME_MAX = 40
};

/*
 * The bytes of the longest clip name, between CLIP_NAME_MIN and CLIP_NAME_MAX.
 */
static int clip_name_width(const struct comparison *comparison)
{
	size_t width = CLIP_NAME_MIN;

	for (int c = 0; c < comparison->clip_count; c++) {
		size_t length = strlen(clip_of(comparison, c)->name);

		width = length > width ? length : width;
	}
	return width < CLIP_NAME_MAX ? (int)width : (int)CLIP_NAME_MAX;
}

static void print_clips(const struct comparison *comparison, FILE *out)
{
	int width = clip_name_width(comparison);

	if (comparison->clip_count == 1) {
		return;
	}
	fprintf(out, "\n  %-*s %8s %8s %8s  %s\n", width + 3, "clip", "seconds",
		"ARM11 us", "peak px",
		comparison->mixed ? "technique in the mixed plan" : "technique");
	for (int c = 0; c < comparison->clip_count; c++) {
		const struct model_clip *clip = clip_of(comparison, c);
		const struct comparison_row *row =
			&comparison->row[comparison->clip[c].row];
		const struct comparison_cell *cell = &row->cell[c];
		struct board_cost board = board_frame_sum(&cell->board);
		int length = (int)strlen(clip->name);

		fprintf(out, "  %2d ", comparison->clip[c].clip);
		printable_put(clip->name, out);
		fprintf(out, "%*s %8.2f %8.0f %8.3f  %s\n",
			length < width ? width - length : 0, "",
			(double)clip->duration_s, board_cost_us(&board),
			(double)cell->error.peak_px, row->name);
	}
}

static void print_ratings(const struct comparison *comparison, FILE *out)
{
	fprintf(out, "\n  %-19s  %-18s  %-18s  %s\n", "AN4044 rates them",
		"control over", "looks", "to program");
	for (int t = 0; t < TECHNIQUE_COUNT; t++) {
		const struct technique_rating *rating = &technique_ratings[t];

		if (comparison_has(comparison, (enum technique)t)) {
			fprintf(out, "  %-19s  %-18s  %-18s  %s\n", rating->name,
				rating->control, rating->looks, rating->coding);
		}
	}
}

/* Prints the steps' times of the recommended row, as means over the clips. */
static void print_steps(const struct comparison *comparison, FILE *out)
{
	const struct comparison_row *row = &comparison->row[comparison->advised];
	double us[4] = {0.0, 0.0, 0.0, 0.0};

	for (int c = 0; c < comparison->clip_count; c++) {
		const struct board_frame *frame = &row->cell[c].board;

		us[0] += board_cost_us(&frame->sample);
		us[1] += board_cost_us(&frame->matrices);
		us[2] += board_cost_us(&frame->vertices);
		us[3] += board_cost_us(&frame->draw);
	}
	for (int i = 0; i < 4; i++) {
		us[i] /= (double)comparison->clip_count;
	}
	fprintf(out,
		"On the ARM1136 its frame takes %.0f us to sample the clip, %.0f us for matrices,\n"
		"%.0f us for vertices and %.0f us to draw it.\n",
		us[0], us[1], us[2], us[3]);
}

static void print_advice(const struct comparison *comparison, FILE *out)
{
	fprintf(out, "\nTake \"%s\"%s: %s.\n",
		comparison->row[comparison->advised].name,
		comparison->clip_count > 1 ? " for all clips" : "",
		comparison->reason);
	print_steps(comparison, out);
	if (comparison->mixed) {
		fprintf(out,
			"A mixed plan, with the technique that the clips' table names for each, takes %.0f us and %.0f KiB.\n",
			comparison->mixed_us,
			kilobytes(comparison->mixed_bytes));
	}
	fprintf(out,
		"AN4044's example, %d key frames of %d vertices, is %d vertices;\n"
		"here %d key frames of %d are %d.\n",
		AN4044_KEYS, AN4044_VERTICES, AN4044_KEYS * AN4044_VERTICES,
		AN4044_KEYS, comparison->vertex_count,
		AN4044_KEYS * comparison->vertex_count);
}

int report_print_text(const struct comparison *comparison, FILE *out)
{
	print_head(comparison, out);
	print_rows(comparison, out);
	print_looks(comparison, out);
	print_clips(comparison, out);
	print_ratings(comparison, out);
	print_advice(comparison, out);
	return 0;
}
