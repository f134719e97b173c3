/*
 * Runs a whole command on any bytes as a model: loads it, poses it, draws it
 * with the soft driver, compares or exports it. A hash of the bytes chooses the
 * command and its options, so that a file repeats its run. What a command writes
 * as input for limber is read again: an optimized model, and a character.
 */
#define _GNU_SOURCE /* memfd_create() */

#include "app/cmd/command.h"
#include "app/model/gltf/gltf.h"
#include "app/model/xfile/xfile.h"
#include "platform/process/confine.h"
#include "tests/fuzz/fuzz_expect.h"

#include <stdio.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

/* Replaces limber's: the fuzzer runs many commands, and writes files. */
struct confinement confine_process(
	const struct confine_request *request, const struct log *log)
{
	(void)request;
	(void)log;
	return (struct confinement){false, false};
}

static const struct command *const commands[] = {&command_play, &command_render,
	&command_pose, &command_info, &command_compare, &command_doctor,
	&command_export, &command_optimize, &command_character, &command_levels,
	NULL};

/* Each run takes one value of each row; "" leaves the option out. */
static const char *const option_values[][9] = {
	{"--size", "32x32", "1x1", "33x17", "8x96", "64x48"},
	{"--time", "", "0", "0.5", "2.25", "30", "7f@30"},
	{"--clip", "", "", "0", "1"},
	{"--interpolation", "", "", "step", "linear", "cubic", "nearest"},
	{"--repeat", "", "ping-pong", "once"},
	{"--speed", "", "", "-1", "0.01", "7"},
	{"--math", "", "float", "fixed"},
	{"--influences", "", "", "1", "3", "auto", "budget:200"},
	{"--lod", "", "", "auto", "off", "level:1", "3"},
	{"--format", "", "rgb565", "rgba8888"},
	{"--show", "", "", "skeleton,weights,wireframe",
		"keys,pivots,curve,layers"},
};

static char film[64], optimized[64], behaviour[64]; /* names of files */

static const char *const command_lines[][12] = {
	{"render", "--frames", "2", "-o", film},
	{"play", "--display", "null", "--clock", "fixed:5", "--frames", "9",
		"--script", "/proc/self/fd/100"},
	{"pose", "-o", "/dev/null"},
	{"info", "--json"},
	{"info"},
	{"doctor"},
	{"doctor", "--json"},
	{"compare", "--fps", "3", "--format", "json"},
	{"export", "--c", "/dev/null"},
	{"optimize", "-o", optimized},
	{"character", "-o", behaviour},
	{"levels", "-o", "/dev/null"},
	{"play", "--demo", "crowd", "--walkers", "3", "--display", "null",
		"--clock", "fixed:5", "--frames", "3"},
	{"play", "--demo", "duel", "--display", "null", "--clock", "fixed:5",
		"--frames", "3"},
	{"play", "--demo", "tuner", "--display", "null", "--clock", "fixed:5",
		"--frames", "3"},
};

/* F8 while F9 is held would keep pictures in this folder. */
static const char script[] =
	"0 UP down\n100 UP up\n200 RIGHT down\n600 F6 down\n650 F6 up\n"
	"700 F9 down\n900 F9 up\n920 F10 down\n940 F10 up\n1000 F8 down\n1300 ENTER down\n";

enum {
	COMMAND_LINES = sizeof(command_lines) / sizeof(command_lines[0]),
	OPTIONS = sizeof(option_values) / sizeof(option_values[0]),
	SCRIPT_FD = 100
};

static uint64_t hash(const uint8_t *data, size_t size)
{
	uint64_t value = 0xcbf29ce484222325u;

	for (size_t i = 0; i < size; i++) {
		value = (value ^ data[i]) * 0x100000001b3u;
	}
	return value ^ value >> 31;
}

static bool draws(const char *command)
{
	return strcmp(command, "render") == 0 || strcmp(command, "play") == 0;
}

/* Whether the command takes the option; wrong usage would test nothing. */
static bool takes(const char *command, const char *option)
{
	if (draws(command)) {
		return true;
	}
	if (strcmp(command, "pose") == 0) {
		return strcmp(option, "--time") == 0 ||
			strcmp(option, "--clip") == 0 ||
			strcmp(option, "--interpolation") == 0 ||
			strcmp(option, "--math") == 0 ||
			strcmp(option, "--influences") == 0;
	}
	if (strcmp(command, "optimize") == 0) {
		return strcmp(option, "--size") == 0;
	}
	return (strcmp(command, "compare") == 0 &&
		       (strcmp(option, "--size") == 0 ||
			       strcmp(option, "--clip") == 0)) ||
		(strcmp(command, "export") == 0 && strcmp(option, "--clip") == 0);
}

static int add_options(const char **argv, int argc, uint64_t choice)
{
	const char *command = argv[1];

	for (int i = 0; i < OPTIONS; i++) {
		const char *const *row = option_values[i];
		int count = 1;

		while (count < 9 && row[count]) {
			count++;
		}
		row += 1 + choice % (uint64_t)(count - 1);
		choice /= (uint64_t)(count - 1);
		if (**row && takes(command, option_values[i][0])) {
			argv[argc++] = option_values[i][0];
			argv[argc++] = *row;
		}
	}
	if (draws(command)) {
		argv[argc++] = "--gl";
		argv[argc++] = "soft";
		argv[argc++] = "--config";
		argv[argc++] = "none";
	}
	argv[argc++] = "--memory";
	argv[argc++] = "48m";
	return argc;
}

/* Returns the status of a command line that ends with NULL. */
static int status_of(const char **argv)
{
	int argc = 0;

	while (argv[argc]) {
		argc++;
	}
	return command_dispatch(commands, argc, (char **)argv);
}

static int play_with(const char *model, const char *character)
{
	return status_of((const char *[]){"limber", "play", "--display", "null",
		"--clock", "fixed:5", "--frames", "3", "--size", "8x8",
		"--config", "none", "--character", character, model, NULL});
}

/* limber reads what it has written. */
static void read_again(const char *command, const char *model)
{
	if (strcmp(command, "optimize") == 0) {
		fuzz_expect(status_of((const char *[]){"limber", "info",
				    optimized, NULL}) == EXIT_OK);
	} else if (strcmp(command, "character") == 0) {
		fuzz_expect(play_with(model, behaviour) ==
			play_with(model, "none"));
	}
}

static void run(const char *model, uint64_t choice)
{
	const char *const *line = command_lines[choice % COMMAND_LINES];
	const char *argv[64] = {"limber"};
	int argc = 1;
	int status;

	while (argc < 12 && line[argc - 1]) {
		argv[argc] = line[argc - 1];
		argc++;
	}
	argc = add_options(argv, argc, choice / COMMAND_LINES);
	argv[argc++] = model;
	status = command_dispatch(commands, argc, (char **)argv);
	for (int i = 0; status != EXIT_OK && status != EXIT_FAILED && i < argc;
		i++) {
		dprintf(STDERR_FILENO, "%s ", argv[i]);
	}
	fuzz_expect(status == EXIT_OK || status == EXIT_FAILED);
	if (status == EXIT_OK) {
		read_again(line[0], model);
	}
}

/* A file in memory with the content, or -1. */
static int file_of(const void *data, size_t size)
{
	int fd = memfd_create("limber-fuzz", 0);

	if (fd >= 0 && write(fd, data, size) != (ssize_t)size) {
		close(fd);
		return -1;
	}
	return fd;
}

static void name_file(char name[64], const char *ending)
{
	snprintf(name, 64, "/tmp/limber-fuzz-%d.%s", (int)getpid(), ending);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
	char model[32];
	int fd;

	if (!gltf_recognise(data, size) && !xfile_recognise(data, size)) {
		return 0;
	}
	if (lseek(SCRIPT_FD, 0, SEEK_SET) != 0) {
		fd = file_of(script, sizeof(script) - 1);
		dup2(fd, SCRIPT_FD);
		name_file(film, "gif");
		name_file(optimized, "glb");
		name_file(behaviour, "character");
		close(fd);
		/* Not freopen(): the sanitizers write to the descriptor. */
		stdout = fopen("/dev/null", "w");
		stderr = fopen("/dev/null", "w");
	}
	fd = file_of(data, size);
	if (fd < 0) {
		return 0;
	}
	snprintf(model, sizeof(model), "/proc/self/fd/%d", fd);
	run(model, hash(data, size));
	close(fd);
	unlink(film);
	unlink(optimized);
	unlink(behaviour);
	return 0;
}
