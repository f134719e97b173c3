#include "app/cmd/options/options_table.h"

#include "app/cmd/time_text.h"
#include "app/compare/report/report.h"
#include "platform/base/output_path.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum {
	SIDE_MAX = 8192 /* pixels */
};

static bool set_size(struct options *options, const char *value)
{
	char *end;
	long width = strtol(value, &end, 10), height;

	if (end == value || *end != 'x') {
		return false;
	}
	value = end + 1;
	height = strtol(value, &end, 10);
	if (end == value || *end || width < 1 || height < 1 ||
		width > SIDE_MAX || height > SIDE_MAX) {
		return false;
	}
	options->screen.size =
		(struct options_size){(int)width, (int)height, true};
	return true;
}

static bool set_format(struct options *options, const char *value)
{
	options->screen.format_given = true;
	return pixel_format_parse(value, &options->screen.format);
}

static bool set_camera_use(struct options *options, const char *value)
{
	options->input.camera_use = live_use_find(value);
	return options->input.camera_use != LIVE_USES;
}

static bool set_overlays(struct options *options, const char *value)
{
	return overlay_choice_parse(value, &options->show.overlays);
}

static bool set_clock(struct options *options, const char *value)
{
	return clock_parse(value, &options->show.clock) == 0;
}

static bool set_time(struct options *options, const char *value)
{
	return time_parse(value, &options->motion.time_s) == 0;
}

static bool set_interpolation(struct options *options, const char *value)
{
	int found = clip_interpolation_find(value);

	options->motion.interpolation = (enum clip_interpolation)found;
	return found >= 0;
}

static bool set_repeat(struct options *options, const char *value)
{
	static const struct {
		const char *name;
		enum clip_repeat repeat;
	} kinds[] = {
		{"loop", CLIP_LOOP},
		{"ping-pong", CLIP_PING_PONG},
		{"once", CLIP_ONCE},
	};

	for (size_t i = 0; i < ARRAY_COUNT(kinds); i++) {
		if (strcmp(value, kinds[i].name) == 0) {
			options->motion.repeat = kinds[i].repeat;
			options->motion.all_loop = kinds[i].repeat == CLIP_LOOP;
			return true;
		}
	}
	return false;
}

static bool set_math(struct options *options, const char *value)
{
	bool fixed = strcmp(value, "fixed") == 0;

	options->vertices.math = fixed ? MATH_FIXED : MATH_FLOAT;
	return fixed || strcmp(value, "float") == 0;
}

static bool set_influences(struct options *options, const char *value)
{
	return influence_cap_parse(value, &options->vertices.influences);
}

static bool set_lod(struct options *options, const char *value)
{
	return lod_parse(value, &options->vertices.lod);
}

/*
 * Reads a number of bytes up to 4e9; a suffix k, m or g means KiB, MiB or GiB.
 */
static bool read_bytes(const char *value, size_t *out)
{
	static const char suffixes[] = "kmg";
	char *end;
	double bytes = strtod(value, &end);

	if (end == value || !(bytes >= 1.0) || bytes > 4e9) {
		return false;
	}
	for (size_t i = 0; suffixes[i]; i++) {
		if (*end == suffixes[i] || *end == suffixes[i] - 'a' + 'A') {
			bytes *= (double)((size_t)1 << (10 * (i + 1)));
			end++;
			break;
		}
	}
	if (*end != '\0' || bytes > 4e9) {
		return false;
	}
	*out = (size_t)bytes;
	return true;
}

static bool set_ram(struct options *options, const char *value)
{
	return read_bytes(value, &options->compare.ram_bytes);
}

static bool set_memory(struct options *options, const char *value)
{
	return read_bytes(value, &options->common.memory_bytes);
}

static bool set_report(struct options *options, const char *value)
{
	options->compare.format = value;
	return report_find(value) != NULL;
}

static bool set_board(struct options *options, const char *value)
{
	options->compare.board = board_profile_find(value);
	return options->compare.board != NULL;
}

static bool ends_with(const char *value, const char *ending)
{
	const char *dot = strrchr(value, '.');

	return dot && strcmp(dot, ending) == 0;
}

static bool set_plot(struct options *options, const char *value)
{
	options->compare.plot = value;
	return ends_with(value, ".svg") || output_path_is_stream(value);
}

static bool set_record(struct options *options, const char *value)
{
	options->show.record = value;
	return ends_with(value, ".gif") || ends_with(value, ".y4m");
}

enum {
	FOR_SHOW = FOR_PLAY | FOR_RENDER,
	FOR_VERTICES = FOR_SHOW | FOR_POSE
};

#define MEMBER(what, name) \
	.kind = (what), .member = offsetof(struct options, name)
#define TEXT(name)   MEMBER(OPTION_TEXT, name)
#define SWITCH(name) MEMBER(OPTION_SWITCH, name)
#define INT(name, from, to) \
	MEMBER(OPTION_INT, name), .low = (from), .high = (to)
#define FLOAT(name, from, to) \
	MEMBER(OPTION_FLOAT, name), .low = (from), .high = (to)
#define DOUBLE(name, from, to) \
	MEMBER(OPTION_DOUBLE, name), .low = (from), .high = (to)
#define PARSED(function) .kind = OPTION_PARSED, .set = (function)

/* clang-format off */
const struct option_entry option_entries[] = {
	{'o', "output", "FILE", FOR_RENDER | FOR_POSE | FOR_PLAY | FOR_CHARACTER |
		FOR_OPTIMIZE | FOR_LEVELS,
		"write to this file",
		"the name of a file", TEXT(screen.output)},
	{0, "demo", "NAME", FOR_SHOW,
		"show a built-in demo: walker, arm, face, crowd, duel or tuner",
		"the name of a demo", TEXT(show.demo)},
	{0, "character", "FILE", FOR_SHOW | FOR_DOCTOR,
		"take the behaviour from this file; the default is MODEL's .character",
		"the name of a character file, or none", TEXT(show.character)},
	{0, "clip", "NAME", FOR_VERTICES | FOR_COMPARE | FOR_EXPORT,
		"use this animation of the model, by its name or its number from 0",
		"the name or the number of a clip", TEXT(motion.clip)},
	{0, "time", "T", FOR_VERTICES,
		"begin at this moment: 1.5 (seconds), 45f@30 (frames) or 7200t (ticks)",
		"seconds such as 1.5, frames such as 45f@30 or ticks such as 7200t, from 0 to 86400 s",
		PARSED(set_time)},
	{0, "interpolation", "MODE", FOR_VERTICES,
		"interpolate keys as: auto (the file says), nearest, step, linear or cubic",
		"auto, nearest, step, linear or cubic", PARSED(set_interpolation)},
	{0, "speed", "X", FOR_SHOW,
		"play a model's clip X times as fast, and backwards if X is negative",
		"a number from -100 to 100", FLOAT(motion.speed, -100, 100)},
	{0, "repeat", "KIND", FOR_SHOW,
		"play clips as: loop, ping-pong or once; by default as each clip ends",
		"loop, ping-pong or once", PARSED(set_repeat)},
	{0, "frames", "N", FOR_SHOW,
		"stop after N frames",
		"a number from 1 to 1000000", INT(show.frames, 1, 1000000)},
	{0, "size", "WxH", FOR_SHOW | FOR_COMPARE | FOR_OPTIMIZE,
		"the picture's size in pixels; the default is 480x640 or the whole screen",
		"a width and a height such as 480x640, up to 8192x8192",
		PARSED(set_size)},
	{0, "format", "NAME", FOR_SHOW,
		"draw in this pixel format: rgb565 or rgba8888; the display has a default",
		"rgb565 or rgba8888", PARSED(set_format)},
	{0, "gl", "NAME", FOR_SHOW,
		"draw with this GL driver: auto, gles1, soft or osmesa",
		"the name of a GL driver", TEXT(screen.gl)},
	{0, "egl-library", "FILE", FOR_SHOW | FOR_DOCTOR,
		"load EGL from this library of the GPU's vendor, for --gl gles1",
		"the file name of a library", TEXT(screen.egl_library)},
	{0, "gles-library", "FILE", FOR_SHOW | FOR_DOCTOR,
		"load OpenGL ES 1.1 from this library of the GPU's vendor",
		"the file name of a library", TEXT(screen.gles_library)},
	{0, "display", "NAME", FOR_PLAY,
		"show pictures on: auto, window, kms, fbdev, egl, image or null",
		"the name of a display", TEXT(screen.display)},
	{0, "fps", "N", FOR_PLAY,
		"show at most N frames a second; the default is the screen's rate or 60",
		"a number from 1 to 1000", DOUBLE(show.fps, 1, 1000)},
	{0, "watchdog", "DEVICE", FOR_PLAY,
		"let this device, such as /dev/watchdog, reset the board when frames stop",
		"a device such as /dev/watchdog", TEXT(show.watchdog)},
	{0, "failsafe", "FILE", FOR_PLAY,
		"count bad starts in this file: after two, show a demo for the model",
		"the name of a file", TEXT(show.failsafe)},
	{0, "user", "NAME", FOR_PLAY,
		"as root, become this user once the devices are open",
		"the name of a user", TEXT(show.user)},
	{0, "buttons", "SPEC", FOR_SHOW,
		"read buttons from these sources, such as evdev or script:FILE",
		"sources such as evdev or script:FILE", TEXT(input.buttons)},
	{0, "script", "FILE", FOR_SHOW,
		"press the buttons that this file lists in lines TIME_MS BUTTON down|up",
		"the name of a file", TEXT(input.script)},
	{0, "record", "FILE", FOR_PLAY,
		"record what is shown as a film in this .gif or .y4m file",
		"a file name that ends in .gif or .y4m", PARSED(set_record)},
	{0, "record-buttons", "FILE", FOR_PLAY,
		"write down what you press, in the form that --script reads",
		"the name of a file", TEXT(input.record_buttons)},
	{0, "config", "FILE", FOR_VERTICES | FOR_DOCTOR,
		"read options from this file instead of limber.conf; none reads no file",
		"the name of a file, or none", TEXT(common.config)},
	{0, "camera", "SPEC", FOR_SHOW,
		"show live pictures of /dev/video0, auto or pattern; ,320x240 sets a size",
		"a camera such as auto or /dev/video0", TEXT(input.camera)},
	{0, "camera-use", "USE", FOR_SHOW,
		"use live pictures as: background, screen, motion or off; F10 changes it",
		"background, screen, motion or off", PARSED(set_camera_use)},
	{0, "stats", "FILE", FOR_SHOW,
		"write the frame times to this file at the end, as JSON",
		"the name of a file", TEXT(show.stats)},
	{0, "clock", "KIND", FOR_SHOW,
		"follow the clock real, or fixed:FPS for the same times in every run",
		"real or fixed:FPS, with FPS from 0.001 to 1000", PARSED(set_clock)},
	{0, "math", "KIND", FOR_VERTICES,
		"compute vertices in: float or fixed",
		"float or fixed", PARSED(set_math)},
	{0, "kernel", "NAME", FOR_VERTICES | FOR_BENCH | FOR_COMPARE,
		"run these vertex loops: float, fixed, an4044 or armv6 (on ARM only)",
		"the name of a kernel", TEXT(vertices.kernel)},
	{0, "influences", "N", FOR_VERTICES,
		"let at most N joints move a vertex; auto: by size on screen; or budget:N",
		"a number from 1 to 8, auto or budget:N", PARSED(set_influences)},
	{0, "lod", "PX", FOR_SHOW,
		"draw fewer triangles, up to PX pixels off; auto (1.5), level:N or off",
		"auto, off, a number of pixels up to 100 or level:N", PARSED(set_lod)},
	{0, "no-labels", NULL, FOR_SHOW,
		"draw no text on the picture",
		NULL, SWITCH(show.no_labels)},
	{0, "budget-ms", "N", FOR_PLAY,
		"reduce detail as far as frames need it to take at most N ms",
		"a number from 1 to 1000", FLOAT(show.budget_ms, 1, 1000)},
	{0, "walkers", "N", FOR_SHOW,
		"begin the demo crowd with N walkers; the default is 12",
		"a number from 1 to 50", INT(show.walkers, 1, 50)},
	{0, "hud", NULL, FOR_SHOW,
		"show the graph of frame times, as holding F9 does (H in a window)",
		NULL, SWITCH(show.hud)},
	{0, "show", "LIST", FOR_SHOW,
		"show skeleton, weights[:JOINT], wireframe, keys, pivots, curve, layers",
		"names from skeleton, weights[:JOINT], wireframe, keys, pivots, curve and layers, separated by commas, or all or none",
		PARSED(set_overlays)},
	{0, "runs", "N", FOR_BENCH,
		"measure everything N times and print the median; the default is 15",
		"a number from 1 to 1001", INT(bench.runs, 1, 1001)},
	{0, "fps", "F", FOR_COMPARE,
		"the rate at which clips are played, in frames a second; the default is 60",
		"a number from 1 to 240", DOUBLE(compare.fps, 1, 240)},
	{0, "error", "PX", FOR_COMPARE | FOR_OPTIMIZE,
		"accept an error of up to PX pixels; the default is 0.5",
		"a number from 0.001 to 1000", FLOAT(compare.error_px, 0.001, 1000)},
	{0, "ram", "BYTES", FOR_COMPARE,
		"accept up to this much memory, such as 512k; the board sets the default",
		"a number of bytes such as 200000, 512k or 2m", PARSED(set_ram)},
	{0, "ms", "N", FOR_COMPARE,
		"accept frames of up to N ms, with drawing; the board sets the default",
		"a number from 0.001 to 1000", FLOAT(compare.ms, 0.001, 1000)},
	{0, "board", "NAME", FOR_COMPARE,
		"take the limits of this board: imx31-pdk",
		"the name of a board: imx31-pdk", PARSED(set_board)},
	{0, "jobs", "N", FOR_COMPARE,
		"measure in N threads; the default is one for each processor",
		"a number from 1 to 64", INT(compare.jobs, 1, 64)},
	{0, "format", "KIND", FOR_COMPARE,
		"print the report as: text, json, csv or md; the default is text",
		"text, json, csv or md", PARSED(set_report)},
	{0, "plot", "FILE.svg", FOR_COMPARE,
		"draw error against cost into this file, with a curve for each technique",
		"a file name that ends in .svg", PARSED(set_plot)},
	{0, "c", "FILE.c", FOR_EXPORT,
		"write the C source to this file; its functions get the file's name",
		"the name of a file", TEXT(export.c)},
	{0, "export", "DIR", FOR_COMPARE,
		"write the baked models into this folder as glTF",
		"the name of a folder", TEXT(compare.export)},
	{0, "memory", "BYTES", FOR_ALL,
		"let a model take up to this much memory; the default is 256m",
		"a number of bytes such as 200000, 512k, 64m or 2g, up to 4e9",
		PARSED(set_memory)},
	{0, "nodes", NULL, FOR_INFO,
		"print the names of all nodes, each below its parent, too",
		NULL, SWITCH(common.nodes)},
	{0, "json", NULL, FOR_INFO | FOR_BENCH | FOR_DOCTOR,
		"print JSON",
		NULL, SWITCH(common.json)},
	{'v', "verbose", NULL, FOR_ALL,
		"print notes about what limber does",
		NULL, SWITCH(common.verbose)},
	{'h', "help", NULL, FOR_ALL,
		"print this help",
		NULL, SWITCH(common.help)},
	{0, "version", NULL, FOR_ALL,
		"print the version",
		NULL, SWITCH(common.version)},
	{.name = NULL},
};
/* clang-format on */

_Static_assert(ARRAY_COUNT(option_entries) <= OPTIONS_MAX,
	"arrays of OPTIONS_MAX names hold every option");
