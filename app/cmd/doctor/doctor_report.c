#include "app/cmd/doctor/doctor_report.h"

#include "app/cmd/version.h"

#include <errno.h>
#include <string.h>

int doctor_report_begin(struct doctor_report *report, FILE *out, bool json,
	const struct log *log)
{
	*report = (struct doctor_report){.out = out, .json = json};
	if (json) {
		report->findings = json_array();
	} else {
		fprintf(out, "%s\n", version_text());
	}
	if (json && !report->findings) {
		log_error(log, "doctor: there is not enough memory");
		return -ENOMEM;
	}
	return 0;
}

void doctor_report_section(
	struct doctor_report *report, const char *title, const char *key)
{
	report->section = key;
	report->driver = NULL;
	if (!report->json) {
		fprintf(report->out, "\n%s\n", title);
	}
}

static void take_json(
	struct doctor_report *report, const struct survey_finding *finding)
{
	json_t *object = json_pack("{s:s, s:s*, s:s, s:s, s:s, s:s*}",
		"section", report->section, "driver", report->driver, "state",
		survey_state_name(finding->state), "subject", finding->subject,
		"text", finding->text, "remedy", finding->remedy);

	if (!object || json_array_append_new(report->findings, object) != 0) {
		report->failed = true;
	}
}

static void take_text(
	struct doctor_report *report, const struct survey_finding *finding)
{
	bool named =
		report->driver && strcmp(report->driver, finding->subject) != 0;

	fprintf(report->out, "  %-7s  %s%s%s: %s\n",
		survey_state_name(finding->state), named ? report->driver : "",
		named ? " " : "", finding->subject, finding->text);
	if (finding->remedy) {
		fprintf(report->out, "           -> %s\n", finding->remedy);
	}
}

static void take(void *user, const struct survey_finding *finding)
{
	struct doctor_report *report = user;

	report->works += finding->state == SURVEY_WORKS;
	if (report->json) {
		take_json(report, finding);
	} else {
		take_text(report, finding);
	}
}

struct survey doctor_report_survey(struct doctor_report *report)
{
	return (struct survey){take, report, "/sys"};
}

static void print_verdict(
	FILE *out, bool plays, const char *display, bool automatic)
{
	if (!display) {
		fputs("\nlimber cannot play here: no display works: limber render can write pictures to files\n",
			out);
	} else if (!plays) {
		fputs("\nlimber cannot play here: no GL driver works\n", out);
	} else if (automatic) {
		fprintf(out, "\nlimber plays here, on %s\n", display);
	} else {
		fprintf(out, "\nlimber plays here with --display %s\n", display);
	}
}

/* Returns false when there is not enough memory. */
static bool print_json(
	struct doctor_report *report, bool plays, const char *display)
{
	json_t *root = json_pack("{s:s, s:b, s:s?, s:O}", "version",
		version_text(), "plays", plays, "display", display, "findings",
		report->findings);
	bool fine = root && !report->failed &&
		(json_dumpf(root, report->out,
			 JSON_INDENT(2) | JSON_ENSURE_ASCII) == 0 ||
			ferror(report->out));

	fputc('\n', report->out);
	json_decref(root);
	return fine;
}

int doctor_report_end(struct doctor_report *report, bool plays,
	const char *display, bool automatic, const struct log *log)
{
	bool fine = true;

	if (report->json) {
		fine = print_json(report, plays, display);
		json_decref(report->findings);
	} else {
		print_verdict(report->out, plays, display, automatic);
	}
	if (!fine) {
		log_error(log, "doctor: there is not enough memory");
		return -ENOMEM;
	}
	return 0;
}
