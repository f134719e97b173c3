#include "app/cmd/command.h"
#include "app/cmd/doctor/doctor_character.h"
#include "app/cmd/doctor/doctor_clips.h"
#include "app/cmd/doctor/doctor_machine.h"
#include "app/model/examine/examine.h"

#include <errno.h>
#include <jansson.h>
#include <stdio.h>

/* Prints findings as lines, or collects them for JSON. */
struct findings {
	int count;
	json_t *list; /* NULL: print lines */
	bool failed;  /* there was no memory for a finding */
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

/* Takes an error or warning of the character file as a finding. */
static void log_finding(
	void *context, enum log_level level, const char *sentence)
{
	(void)level;
	take_finding(context, sentence);
}

static int examine_character(const struct options *options,
	struct findings *findings, const struct log *log,
	struct doctor_character *out)
{
	const struct character_request request = {
		.model_path = options->model_path,
		.file = options->show.character,
	};
	const struct log taken = {.write = log_finding,
		.user = findings,
		.threshold = LOG_WARNING};

	return doctor_character_check(
		&request, options->common.memory_bytes, &taken, log, out);
}

/* Reports what the model's file shows, and which of its clips play once. */
static int examine_model(const struct options *options,
	const struct examiner *examiner, const struct log *log)
{
	size_t memory_bytes = options->common.memory_bytes;
	int error =
		model_examine(options->model_path, memory_bytes, examiner, log);

	return error ? error
		     : doctor_clips_check(options->model_path, memory_bytes,
			       examiner, log);
}

/* A character file that limber cannot play, as reported, fails the command. */
static int character_error(const struct doctor_character *character)
{
	return character->found && !character->right ? -EINVAL : 0;
}

static int examine_in_words(const struct options *options, const struct log *log)
{
	const char *path = options->model_path;
	struct doctor_character character;
	struct findings findings = {0};
	const struct examiner examiner = {take_finding, &findings};
	int error = examine_model(options, &examiner, log);

	if (!error && findings.count == 0) {
		printf("%s: it contains nothing that players are known to get wrong\n",
			path);
	}
	if (!error) {
		error = examine_character(options, &findings, log, &character);
	}
	if (!error && character.right) {
		printf("%s: it fits the model. States: %d, layers: %d, effects and expressions: %d, buttons: %d\n",
			character.path, character.states, character.layers,
			character.effects, character.buttons);
	}
	return error ? error : character_error(&character);
}

static int examine_in_json(const struct options *options, const struct log *log)
{
	const char *path = options->model_path;
	struct doctor_character character;
	struct findings findings = {.list = json_array()};
	const struct examiner examiner = {take_finding, &findings};
	json_t *root = json_pack(
		"{s:s, s:O}", "file", path, "findings", findings.list);
	int error = -ENOMEM;

	if (!root) {
		log_error(log,
			"%s: this name is not UTF-8, which JSON requires: rename the file",
			path);
		goto out;
	}
	error = examine_model(options, &examiner, log);
	if (!error) {
		error = examine_character(options, &findings, log, &character);
	}
	if (!error) {
		bool dumped = !findings.failed &&
			json_dumpf(root, stdout,
				JSON_INDENT(2) | JSON_ENSURE_ASCII) == 0;

		if (!dumped && !ferror(stdout)) {
			log_error(log, "%s: there is not enough memory", path);
			error = -ENOMEM;
		}
		putchar('\n');
		error = error ? error : character_error(&character);
	}
out:
	json_decref(root);
	json_decref(findings.list);
	return error;
}

static int run(const struct options *options, const struct log *log)
{
	const char *character = options->show.character;

	if (!options->model_path && character) {
		log_error(log,
			"doctor: --character %s: there is no model: use limber doctor MODEL --character FILE",
			character);
		return EXIT_USAGE;
	}
	if (!options->model_path) {
		return doctor_examine_machine(options, log);
	}
	command_confine(options, log);
	return command_exit_code(options->common.json
			? examine_in_json(options, log)
			: examine_in_words(options, log));
}

const struct command command_doctor = {
	.name = "doctor",
	.bit = FOR_DOCTOR,
	.usage = "[MODEL] [--json]",
	.summary = "check this machine, or a model, for problems",
	.detail =
		"Without a model, limber lists displays, GL drivers, kernels, GPIO lines, keyboards, cameras,\n"
		"watchdogs, limber.conf and the demos' files. Each of them works, is unused (limber has no use\n"
		"for it), is taken (by another program), is missing or is broken; for what is missing or\n"
		"broken, limber prints the command that repairs it. It starts and changes nothing. The exit\n"
		"status is 0 when limber can play: a display and a GL driver work.\n"
		"\n"
		"With a model, limber lists everything in the file that players are known to get wrong, and\n"
		"says what limber does there. It also checks the character file that lies beside the model,\n"
		"or that --character names: if limber cannot play it, the exit status is 1.\n"
		"\n"
		"  limber doctor\n"
		"  limber doctor --json | jq '.findings[] | select(.state != \"works\")'\n"
		"  limber doctor robot.glb\n"
		"  limber doctor robot.glb --character biped.character",
	.reads_config = true,
	.run = run,
};
