#include "app/compare/report/report.h"

#include "platform/base/printable.h"

#include "app/anim/kernel/arm11_cost.h"

/* The example in AN4044, section 4. */
enum {
	AN4044_KEYS = 20,
	AN4044_VERTICES = 4000
};

static double kilobytes(size_t bytes)
{
	return (double)bytes / 1024.0;
}

static void print_head(const struct comparison *comparison, FILE *out)
{
	const struct reference *reference = comparison->reference;
	const char *name = reference->clip->name;

	printable_put(reference->model->path, out);
	fprintf(out, ", clip %d%s", reference->clip_index, name[0] ? " " : "");
	printable_put(name, out);
	fprintf(out, ": %.2f s, %d frames at %g Hz; %d vertices, %d nodes\n",
		(double)reference->clip->duration_s, reference->frame_count,
		reference->rate_hz, reference->vertex_count,
		reference->model->node_count);
	fprintf(out,
		"Errors are in pixels of a %dx%d screen. \"here\": measured on this machine, kernel %s.\n"
		"\"ARM11\": predicted for an ARM1136 at %d MHz by the timing model, not measured.\n\n",
		comparison->screen.width, comparison->screen.height,
		comparison->request.kernel->name, ARM11_MHZ);
}

static void print_instructions(const struct candidate *candidate, FILE *out)
{
	if (candidate->instructions < 0.0) {
		fprintf(out, "%9s", "-");
	} else {
		fprintf(out, "%9.0f", candidate->instructions / 1000.0);
	}
}

static void print_row(const struct comparison *comparison, int index, FILE *out)
{
	const struct candidate *candidate = &comparison->candidate[index];

	fprintf(out, "%c %-26s %8.1f %8.1f ",
		index == comparison->advised ? '>' : ' ', candidate->name,
		board_cost_us(&candidate->board), candidate->frame_us);
	print_instructions(candidate, out);
	fprintf(out, " %9.1f %9.1f %8.3f %8.3f\n",
		kilobytes(candidate->memory_bytes),
		kilobytes(candidate->file_bytes),
		(double)candidate->error.peak_px,
		(double)candidate->error.mean_px);
}

static void print_ratings(const struct comparison *comparison, FILE *out)
{
	fprintf(out, "\n  %-26s %-20s %-20s %s\n", "AN4044 rates them",
		"control over", "looks", "to program");
	for (int t = 0; t < TECHNIQUE_COUNT; t++) {
		const struct technique_rating *rating = &technique_ratings[t];

		if (comparison_has(comparison, (enum technique)t)) {
			fprintf(out, "  %-26s %-20s %-20s %s\n", rating->name,
				rating->control, rating->looks, rating->coding);
		}
	}
}

static void print_advice(const struct comparison *comparison, FILE *out)
{
	const struct comparison_request *request = &comparison->request;

	fprintf(out, "\nWithin %g px", (double)request->bound_px);
	if (request->memory_bytes > 0) {
		fprintf(out, " and %.1f KiB", kilobytes(request->memory_bytes));
	}
	fprintf(out, " take \"%s\": %s.\n",
		comparison->candidate[comparison->advised].name,
		comparison->reason);
	fprintf(out,
		"AN4044's example, %d key frames of %d vertices, is %d vertices; here %d key frames of %d are %d.\n",
		AN4044_KEYS, AN4044_VERTICES, AN4044_KEYS * AN4044_VERTICES,
		AN4044_KEYS, comparison->reference->vertex_count,
		AN4044_KEYS * comparison->reference->vertex_count);
}

int report_print_text(const struct comparison *comparison, FILE *out)
{
	print_head(comparison, out);
	fprintf(out, "  %-26s %8s %8s %9s %9s %9s %8s %8s\n", "a frame takes",
		"ARM11 us", "us here", "k instr.", "KiB RAM", "KiB file",
		"peak px", "mean px");
	for (int i = 0; i < comparison->candidate_count; i++) {
		if (comparison->candidate[i].listed) {
			print_row(comparison, i, out);
		}
	}
	print_ratings(comparison, out);
	print_advice(comparison, out);
	return 0;
}

static const char *const columns[] = {
	"technique",
	"kind",
	"us_per_frame",
	"instructions_per_frame",
	"arm11_us_predicted",
	"arm11_instructions_predicted",
	"ram_bytes",
	"file_bytes",
	"peak_px",
	"mean_px",
	"advised",
};

/* Prints a row of cells, each after the first preceded by separator. */
static void print_cells(const struct comparison *comparison, int index,
	const char *separator, const char *quote, FILE *out)
{
	const struct candidate *candidate = &comparison->candidate[index];

	fprintf(out, "%s%s%s%s%s%s%.2f%s", quote, candidate->name, quote,
		separator, technique_ratings[candidate->technique].name,
		separator, candidate->frame_us, separator);
	if (candidate->instructions >= 0.0) {
		fprintf(out, "%.0f", candidate->instructions);
	}
	fprintf(out, "%s%.2f%s%.0f%s%zu%s%zu%s%.4f%s%.4f%s%s", separator,
		board_cost_us(&candidate->board), separator,
		candidate->board.instructions, separator,
		candidate->memory_bytes, separator, candidate->file_bytes,
		separator, (double)candidate->error.peak_px, separator,
		(double)candidate->error.mean_px, separator,
		index == comparison->advised ? "yes" : "no");
}

static void print_columns(const char *separator, FILE *out)
{
	for (size_t i = 0; i < ARRAY_COUNT(columns); i++) {
		fprintf(out, "%s%s", i ? separator : "", columns[i]);
	}
}

int report_print_csv(const struct comparison *comparison, FILE *out)
{
	print_columns(",", out);
	fprintf(out, "\r\n"); /* RFC 4180 */
	for (int i = 0; i < comparison->candidate_count; i++) {
		if (comparison->candidate[i].listed) {
			print_cells(comparison, i, ",", "\"", out);
			fprintf(out, "\r\n");
		}
	}
	return 0;
}

int report_print_markdown(const struct comparison *comparison, FILE *out)
{
	fprintf(out, "| ");
	print_columns(" | ", out);
	fprintf(out, " |\n");
	for (size_t i = 0; i < ARRAY_COUNT(columns); i++) {
		fprintf(out, "|%s", i < 2 ? "---" : "---:");
	}
	fprintf(out, "|\n");
	for (int i = 0; i < comparison->candidate_count; i++) {
		if (comparison->candidate[i].listed) {
			fprintf(out, "| ");
			print_cells(comparison, i, " | ", "", out);
			fprintf(out, " |\n");
		}
	}
	return 0;
}
