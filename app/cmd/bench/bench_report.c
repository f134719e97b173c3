#include "app/cmd/bench/bench_report.h"

#include "platform/base/json_memory.h"

#include <errno.h>
#include <string.h>

#include <jansson.h>

/* Returns the float kernel's result for this row, or NULL. */
static const struct bench_result *float_result(
	const struct bench_report *report, const struct bench_row *row)
{
	for (int i = 0; i < report->result_count; i++) {
		const struct bench_result *result = &report->result[i];

		if (result->row == row &&
			strcmp(result->kernel->name, "float") == 0) {
			return result;
		}
	}
	return NULL;
}

static void print_head(const struct bench_report *report, FILE *out)
{
	if (report->mesh) {
		fprintf(out, "%s: ", report->mesh);
	}
	fprintf(out,
		"nanoseconds a vertex on this machine, the median of %d runs\n"
		"warm: run after run; cold: after reading 32 MiB of other data; x: speed relative to float, warm\n\n",
		report->runs);
	fprintf(out, "%-37s%-8s", "", "");
	for (int s = 0; s < report->size_count; s++) {
		fprintf(out, "%12d vertices    ", report->vertex_count[s]);
	}
	fprintf(out, "\n%-37s%-8s", "", "");
	for (int s = 0; s < report->size_count; s++) {
		fprintf(out, "%9s%8s%8s", "warm", "cold", "x");
	}
	fprintf(out, "\n");
}

static void print_result(const struct bench_report *report,
	const struct bench_result *result, const char *title, FILE *out)
{
	const struct bench_result *base = float_result(report, result->row);

	fprintf(out, "%-37s%-8s", title, result->kernel->name);
	for (int s = 0; s < report->size_count; s++) {
		const struct bench_time *time = &result->time[s];

		fprintf(out, " %8.2f %7.2f", time->warm_ns, time->cold_ns);
		if (base && time->warm_ns > 0) {
			fprintf(out, "%8.2f",
				base->time[s].warm_ns / time->warm_ns);
		} else {
			fprintf(out, "%8s", "");
		}
	}
	fprintf(out, "\n");
}

void bench_print_text(const struct bench_report *report, FILE *out)
{
	const struct bench_row *last = NULL;

	print_head(report, out);
	for (int i = 0; i < report->result_count; i++) {
		const struct bench_result *result = &report->result[i];
		bool is_first = result->row != last;

		print_result(report, result, is_first ? result->row->title : "",
			out);
		last = result->row;
	}
}

/* json_array_append_new() and json_pack() accept NULL and then fail. */
static json_t *times(
	const struct bench_report *report, const struct bench_result *result)
{
	json_t *array = json_array();

	for (int s = 0; s < report->size_count; s++) {
		json_array_append_new(array,
			json_pack("{s:i, s:f, s:f}", "vertices",
				report->vertex_count[s], "warm_ns",
				result->time[s].warm_ns, "cold_ns",
				result->time[s].cold_ns));
	}
	return array;
}

static json_t *results(const struct bench_report *report)
{
	json_t *array = json_array();

	for (int i = 0; i < report->result_count; i++) {
		const struct bench_result *result = &report->result[i];

		json_array_append_new(array,
			json_pack("{s:s, s:s, s:s, s:o}", "name",
				result->row->name, "title", result->row->title,
				"kernel", result->kernel->name, "times",
				times(report, result)));
	}
	return array;
}

int bench_print_json(
	const struct bench_report *report, const struct log *log, FILE *out)
{
	json_t *root;
	bool dumped;

	json_memory_begin();
	root = json_pack("{s:s?, s:i, s:s, s:o}", "model", report->mesh, "runs",
		report->runs, "unit", "ns a vertex", "results", results(report));
	if (!json_memory_ok()) {
		log_error(log, "bench: there is not enough memory");
		json_decref(root);
		return -ENOMEM;
	}

	if (!root) {
		log_error(log,
			"bench: the model's file name is not UTF-8, or there is not enough memory: rename the file");
		return -EINVAL;
	}
	dumped = json_dumpf(root, out,
			 JSON_INDENT(2) | JSON_ENSURE_ASCII |
				 JSON_REAL_PRECISION(5)) == 0;
	fputc('\n', out);
	json_decref(root);
	if (!dumped && !ferror(out)) {
		log_error(log, "bench: there is not enough memory");
		return -ENOMEM;
	}
	return 0;
}
