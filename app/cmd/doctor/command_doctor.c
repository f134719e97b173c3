#include "app/cmd/command.h"
#include "app/cmd/doctor/doctor_machine.h"
#include "app/model/examine/examine.h"

#include <errno.h>
#include <jansson.h>
#include <stdio.h>

/* Counts what is said on its way to the user. */
struct findings {
	int count;
	json_t *list; /* instead of lines, or NULL */
	bool failed;
};

static void take_finding(void *context, const char *sentence)
{
	struct findings *findings = context;

	findings->count++;
	if (!findings->list) {
		printf("- %s\n", sentence);
	} else if (json_array_append_new(
			   findings->list, json_string(sentence)) != 0) {
		findings->failed = true;
	}
}

static int examine_in_words(const char *path, const struct log *log)
{
	struct findings findings = {0};
	const struct examiner examiner = {take_finding, &findings};
	int error = model_examine(path, &examiner, log);

	if (!error && findings.count == 0) {
		printf("%s: nothing in it that players get wrong\n", path);
	}
	return error;
}

static int examine_in_json(const char *path, const struct log *log)
{
	struct findings findings = {.list = json_array()};
	const struct examiner examiner = {take_finding, &findings};
	json_t *root = json_pack(
		"{s:s, s:O}", "file", path, "findings", findings.list);
	int error = -ENOMEM;

	if (!root) {
		log_error(log, "%s: its name is no UTF-8, which JSON needs",
			path);
		goto out;
	}
	error = model_examine(path, &examiner, log);
	if (!error) {
		bool dumped = !findings.failed &&
			json_dumpf(root, stdout, JSON_INDENT(2)) == 0;

		if (!dumped && !ferror(stdout)) {
			log_error(log, "%s: out of memory", path);
			error = -ENOMEM;
		}
		putchar('\n');
	}
out:
	json_decref(root);
	json_decref(findings.list);
	return error;
}

static int run(const struct options *options, const struct log *log)
{
	const char *path = options->model_path;

	if (!path) {
		return doctor_examine_machine(options, log);
	}
	return command_exit_code(options->common.json
			? examine_in_json(path, log)
			: examine_in_words(path, log));
}

const struct command command_doctor = {
	.name = "doctor",
	.bit = FOR_DOCTOR,
	.usage = "[MODEL] [--json]",
	.summary = "tell what works here, or what is odd in a model",
	.detail = "Without a model: lists displays, GL drivers, vertex kernels, "
		  "GPIO lines, keyboards,\ncameras, watchdogs, limber.conf and "
		  "the demos' files. Each line says works, unused\n(nothing "
		  "limber could use), taken (by another program), missing or "
		  "broken, and\nbelow it the command that mends it. Nothing is "
		  "started or changed. Exit status 0\nwhen limber can play: "
		  "some display and some GL driver work.\n\n"
		  "With a model: lists each thing in the file that players are "
		  "known to get wrong,\nwith what limber does there.\n\n"
		  "  limber doctor\n"
		  "  limber doctor --json | jq '.findings[] | "
		  "select(.state != \"works\")'\n"
		  "  limber doctor robot.glb",
	.reads_config = true,
	.run = run,
};
