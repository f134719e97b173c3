/*
 * Prints the listed rows as CSV and Markdown.
 */
#include "app/compare/report/report.h"

static const char *const columns[] = {
	"technique",
	"kind",
	"us_per_frame",
	"instructions_per_frame",
	"arm11_us_predicted",
	"arm11_instructions_predicted",
	"arm11_drawing_us_predicted",
	"ram_bytes",
	"file_bytes",
	"peak_px",
	"mean_px",
	"outline_px",
	"normal_deg",
	"shade_steps",
	"front",
	"advised",
};

/*
 * Prints a row's cells with separators between them; quotes enclose the name.
 */
static void print_cells(const struct comparison *comparison, int index,
	const char *separator, const char *quote, FILE *out)
{
	const struct comparison_row *row = &comparison->row[index];
	const struct comparison_total *total = &row->total;

	fprintf(out, "%s%s%s%s%s%s%.2f%s", quote, row->name, quote, separator,
		technique_ratings[row->technique].name, separator,
		total->frame_us, separator);
	if (total->instructions >= 0.0) {
		fprintf(out, "%.0f", total->instructions);
	}
	fprintf(out, "%s%.2f%s%.0f%s%.2f%s%zu%s%zu%s%.4f%s%.4f", separator,
		board_cost_us(&total->board), separator,
		total->board.instructions, separator,
		board_cost_us(&total->draw), separator, total->memory_bytes,
		separator, total->file_bytes, separator, (double)total->peak_px,
		separator, (double)total->mean_px);
	fprintf(out, "%s%.4f%s%.3f%s%.2f%s%s%s%s", separator,
		(double)total->outline_px, separator, (double)total->normal_deg,
		separator, (double)total->shade_steps, separator,
		row->front ? "yes" : "no", separator,
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
	for (int i = 0; i < comparison->row_count; i++) {
		if (comparison->row[i].listed) {
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
	for (int i = 0; i < comparison->row_count; i++) {
		if (comparison->row[i].listed) {
			fprintf(out, "| ");
			print_cells(comparison, i, " | ", "", out);
			fprintf(out, " |\n");
		}
	}
	return 0;
}
