/*
 * conformance SAMPLES FOLDER COMMAND...: compares the poses that `COMMAND pose`
 * writes with reference poses.
 *
 * Each file SAMPLES/oracle/NAME@CLIP@TIME.json is one test. The vertices that
 * COMMAND writes into FOLDER for SAMPLES/models/NAME.glb or .gltf must be
 * within 1e-4 of the model's extent. CLIP is - for the rest pose. Prints TAP.
 * The tests are skipped when SAMPLES/oracle does not exist.
 */
#include "tests/conformance/posed.h"
#include "tests/support/run.h"
#include "tests/support/test.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum {
	PATH_BYTES = 1024,
	ARGUMENTS_MAX = 64,
	TIMEOUT_S = 120
};

static const double TOLERANCE = 1e-4; /* of the model's extent */

struct options {
	const char *samples, *folder;
	char **command;
};

/* A reference file; name, clip and time are parts of its name. */
struct reference {
	const struct options *options;
	char file[256];
	char name[256], clip[256], time[256];
};

static bool split_name(struct reference *reference)
{
	const char *file = reference->file;
	const char *clip = strchr(file, '@');
	const char *time = clip ? strchr(clip + 1, '@') : NULL;
	const char *end = time ? strstr(time + 1, ".json") : NULL;

	if (!end || end[strlen(".json")]) {
		return false;
	}
	snprintf(reference->name, sizeof(reference->name), "%.*s",
		(int)(clip - file), file);
	snprintf(reference->clip, sizeof(reference->clip), "%.*s",
		(int)(time - clip - 1), clip + 1);
	snprintf(reference->time, sizeof(reference->time), "%.*s",
		(int)(end - time - 1), time + 1);
	return true;
}

static void find_model(const struct reference *reference, char path[PATH_BYTES])
{
	static const char *const kinds[] = {"glb", "gltf"};

	for (size_t i = 0; i < 2; i++) {
		snprintf(path, PATH_BYTES, "%s/models/%s.%s",
			reference->options->samples, reference->name, kinds[i]);
		if (access(path, R_OK) == 0) {
			return;
		}
	}
	fail_msg("%s.glb and .gltf are missing in %s/models", reference->name,
		reference->options->samples);
}

static void run_pose(
	const struct reference *reference, const char *model, const char *obj)
{
	const char *argv[ARGUMENTS_MAX] = {NULL};
	const char *const parts[] = {"pose", model, "--time", reference->time,
		"-o", obj, "--clip", reference->clip};
	size_t part_count = strcmp(reference->clip, "-") ? 8 : 6;
	struct run_result result;
	size_t count = 0;

	while (reference->options->command[count]) {
		assert_true(count < ARGUMENTS_MAX - 9);
		argv[count] = reference->options->command[count];
		count++;
	}
	for (size_t i = 0; i < part_count; i++) {
		argv[count++] = parts[i];
	}
	remove(obj);
	result = run_command(argv, TIMEOUT_S);
	if (result.exit_code) {
		print_error("exit status %d: %s", result.exit_code, result.err);
		fail();
	}
	run_release(&result);
}

/* 0, or -1 with *error filled. *worst becomes a fraction of the extent. */
static int compare_files(const char *obj, const char *json, double *worst,
	struct posed_error *error)
{
	struct posed expected, actual;
	double extent;
	int failed;

	if (posed_read_reference(json, &expected, error)) {
		return -1;
	}
	failed = posed_read_obj(obj, &actual, error);
	if (failed) {
		goto release_expected;
	}
	extent = posed_extent(&expected);
	failed = posed_compare(
		&actual, &expected, TOLERANCE * extent, worst, error);
	if (extent > 0) {
		*worst /= extent;
	}
	posed_release(&actual);
release_expected:
	posed_release(&expected);
	return failed;
}

static void check_reference(void **state)
{
	const struct reference *reference = *state;
	char model[PATH_BYTES], json[PATH_BYTES], obj[PATH_BYTES];
	struct posed_error error;
	double worst;

	find_model(reference, model);
	snprintf(json, sizeof(json), "%s/oracle/%s",
		reference->options->samples, reference->file);
	snprintf(obj, sizeof(obj), "%s/%s.obj", reference->options->folder,
		reference->file);
	run_pose(reference, model, obj);
	if (compare_files(obj, json, &worst, &error)) {
		fail_msg("%s", error.text);
	}
	printf("# %s: worst %.2g of the extent\n", reference->file, worst);
	fflush(stdout);
}

static int is_reference(const struct dirent *entry)
{
	size_t length = strlen(entry->d_name);

	return length > 5 && !strcmp(entry->d_name + length - 5, ".json");
}

/* Runs one test for each reference. */
static int run_references(
	const struct options *options, struct dirent **entries, int count)
{
	struct CMUnitTest *tests = calloc((size_t)count + 1, sizeof(*tests));
	struct reference *references =
		calloc((size_t)count + 1, sizeof(*references));
	int failures = -1;

	if (!tests || !references) {
		goto release;
	}
	for (int i = 0; i < count; i++) {
		struct reference *reference = &references[i];

		reference->options = options;
		snprintf(reference->file, sizeof(reference->file), "%s",
			entries[i]->d_name);
		if (!split_name(reference)) {
			fprintf(stderr,
				"%s: the name is not NAME@CLIP@TIME.json\n",
				reference->file);
			goto release;
		}
		tests[i] = (struct CMUnitTest){
			.name = reference->file,
			.test_func = check_reference,
			.initial_state = reference,
		};
	}
	failures = _cmocka_run_group_tests(
		"conformance", tests, (size_t)count, NULL, NULL);
release:
	free(references);
	free(tests);
	return failures;
}

int main(int argc, char **argv)
{
	struct options options;
	struct dirent **entries;
	char folder[PATH_BYTES];
	int count, failures;

	if (argc < 4) {
		fprintf(stderr, "usage: %s SAMPLES FOLDER COMMAND...\n",
			argv[0]);
		return 2;
	}
	options = (struct options){argv[1], argv[2], argv + 3};
	snprintf(folder, sizeof(folder), "%s/oracle", options.samples);
	count = scandir(folder, &entries, is_reference, alphasort);
	if (count < 0) {
		printf("1..0 # SKIP %s has no sample models; make SAMPLES=DIR sets their folder\n",
			options.samples);
		return 0;
	}
	failures = run_references(&options, entries, count);
	for (int i = 0; i < count; i++) {
		free(entries[i]);
	}
	free(entries);
	return failures ? 1 : 0;
}
