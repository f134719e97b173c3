#include "app/compare/report.h"

/* AN4044, section 4. */
enum {
	DOCUMENT_KEYS = 20,
	DOCUMENT_VERTICES = 4000
};

static double kilobytes(size_t bytes)
{
	return (double)bytes / 1024.0;
}

static void print_head(const struct comparison *comparison, FILE *out)
{
	const struct reference *reference = comparison->reference;
	const char *name = reference->clip->name;

	fprintf(out,
		"%s, clip %d%s%s: %.2f s, %d frames at %g Hz; %d vertices, "
		"%d nodes\n",
		reference->model->path, reference->clip_index,
		name[0] ? " " : "", name, (double)reference->clip->duration_s,
		reference->frame_count, reference->rate_hz,
		reference->vertex_count, reference->model->node_count);
	fprintf(out,
		"Errors in pixels of a %dx%d screen; time a frame on this "
		"machine, kernel %s\n\n",
		comparison->screen.width, comparison->screen.height,
		comparison->request.kernel->name);
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
	const struct technique_rating *rating =
		&technique_rating[candidate->technique];

	fprintf(out, "%c %-24s %8.1f ", index == comparison->advised ? '>' : ' ',
		candidate->name, candidate->frame_us);
	print_instructions(candidate, out);
	fprintf(out, " %9.1f %9.1f %8.3f %8.3f  %-18s %-17s %s\n",
		kilobytes(candidate->memory_bytes),
		kilobytes(candidate->file_bytes),
		(double)candidate->error.peak_px,
		(double)candidate->error.mean_px, rating->control,
		rating->looks, rating->coding);
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
		"AN4044's example, %d key frames of %d vertices, is %d "
		"vertices; here %d of %d are %d.\n",
		DOCUMENT_KEYS, DOCUMENT_VERTICES,
		DOCUMENT_KEYS * DOCUMENT_VERTICES, DOCUMENT_KEYS,
		comparison->reference->vertex_count,
		DOCUMENT_KEYS * comparison->reference->vertex_count);
}

int report_print_text(const struct comparison *comparison, FILE *out)
{
	print_head(comparison, out);
	fprintf(out, "  %-24s %8s %9s %9s %9s %8s %8s  %-18s %-17s %s\n",
		"technique", "us/frame", "k instr.", "KiB RAM", "KiB file",
		"peak px", "mean px", "control over", "looks", "to program");
	for (int i = 0; i < comparison->candidate_count; i++) {
		if (comparison->candidate[i].listed) {
			print_row(comparison, i, out);
		}
	}
	print_advice(comparison, out);
	return 0;
}

static const char *const columns[] = {
	"technique",
	"kind",
	"us_per_frame",
	"instructions_per_frame",
	"ram_bytes",
	"file_bytes",
	"peak_px",
	"mean_px",
	"advised",
};

/* A line of cells, with between between them. */
static void print_cells(const struct comparison *comparison, int index,
	const char *between, const char *quote, FILE *out)
{
	const struct candidate *candidate = &comparison->candidate[index];

	fprintf(out, "%s%s%s%s%s%s%.2f%s", quote, candidate->name, quote,
		between, technique_rating[candidate->technique].name, between,
		candidate->frame_us, between);
	if (candidate->instructions >= 0.0) {
		fprintf(out, "%.0f", candidate->instructions);
	}
	fprintf(out, "%s%zu%s%zu%s%.4f%s%.4f%s%s", between,
		candidate->memory_bytes, between, candidate->file_bytes,
		between, (double)candidate->error.peak_px, between,
		(double)candidate->error.mean_px, between,
		index == comparison->advised ? "yes" : "no");
}

static void print_columns(const char *between, FILE *out)
{
	for (size_t i = 0; i < ARRAY_COUNT(columns); i++) {
		fprintf(out, "%s%s", i ? between : "", columns[i]);
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
