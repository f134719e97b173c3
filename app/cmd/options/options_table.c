#include "app/cmd/options/options_table.h"

#include "app/compare/report/report.h"
#include "platform/base/time_text.h"

#include <errno.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum {
	SIDE_MAX = 8192,
	FRAMES_MAX = 1000000,
	RUNS_MAX = 1001,
	WALKERS_MAX = 50
};

static bool read_int(const char *text, int low, int high, int *out)
{
	char *end;
	long value;

	errno = 0;
	value = strtol(text, &end, 10);
	if (errno || end == text || *end || value < low || value > high) {
		return false;
	}
	*out = (int)value;
	return true;
}

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
	options->width = (int)width;
	options->height = (int)height;
	options->size_given = true;
	return true;
}

static bool set_format(struct options *options, const char *value)
{
	options->format_given = true;
	return pixel_format_parse(value, &options->format);
}

static bool set_fps(struct options *options, const char *value)
{
	char *end;

	options->fps = strtod(value, &end);
	return end != value && !*end && options->fps >= 1.0 &&
		options->fps <= 1000.0;
}

static bool set_buttons(struct options *options, const char *value)
{
	options->buttons = value;
	return true;
}

static bool set_camera_use(struct options *options, const char *value)
{
	options->camera_use = live_use_find(value);
	return options->camera_use != LIVE_USES;
}

static bool set_clock(struct options *options, const char *value)
{
	options->clock_given = true;
	return clock_parse(value, &options->clock) == 0;
}

static bool set_frames(struct options *options, const char *value)
{
	return read_int(value, 1, FRAMES_MAX, &options->frames);
}

static bool set_time(struct options *options, const char *value)
{
	options->time_given = true;
	return time_parse(value, &options->time_s) == 0;
}

static bool set_interpolation(struct options *options, const char *value)
{
	int found = clip_interpolation_find(value);

	options->interpolation = (enum clip_interpolation)found;
	return found >= 0;
}

static bool set_speed(struct options *options, const char *value)
{
	char *end;

	options->speed = strtof(value, &end);
	return end != value && !*end && options->speed >= -100.0f &&
		options->speed <= 100.0f;
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
			options->repeat = kinds[i].repeat;
			return true;
		}
	}
	return false;
}

static bool set_math(struct options *options, const char *value)
{
	options->math = strcmp(value, "fixed") == 0 ? MATH_FIXED : MATH_FLOAT;
	return options->math == MATH_FIXED || strcmp(value, "float") == 0;
}

static bool set_influences(struct options *options, const char *value)
{
	return influence_cap_parse(value, &options->influences);
}

static bool set_lod(struct options *options, const char *value)
{
	return lod_parse(value, &options->lod);
}

static bool set_runs(struct options *options, const char *value)
{
	return read_int(value, 1, RUNS_MAX, &options->runs);
}

static bool read_number(const char *text, double low, double high, double *out)
{
	char *end;

	*out = strtod(text, &end);
	return end != text && !*end && *out >= low && *out <= high;
}

static bool set_rate(struct options *options, const char *value)
{
	return read_number(value, 1.0, 240.0, &options->rate_hz);
}

static bool set_error(struct options *options, const char *value)
{
	double px;
	bool good = read_number(value, 0.001, 1000.0, &px);

	options->bound_px = (float)px;
	return good;
}

/* A number of bytes, or of KiB or MiB after k or m. */
static bool set_memory(struct options *options, const char *value)
{
	char *end;
	double bytes = strtod(value, &end);

	if (end == value || !(bytes >= 1.0) || bytes > 1e9) {
		return false;
	}
	if (*end == 'k' || *end == 'K') {
		bytes *= 1024.0;
		end++;
	} else if (*end == 'm' || *end == 'M') {
		bytes *= 1024.0 * 1024.0;
		end++;
	}
	options->memory_bytes = (size_t)bytes;
	return *end == '\0' && bytes <= 4e9;
}

static bool set_report(struct options *options, const char *value)
{
	options->report = value;
	return report_find(value) != NULL;
}

static bool set_budget(struct options *options, const char *value)
{
	double ms;
	bool good = read_number(value, 1.0, 1000.0, &ms);

	options->budget_ms = (float)ms;
	return good;
}

static bool set_record(struct options *options, const char *value)
{
	const char *dot = strrchr(value, '.');

	options->record = value;
	return dot && (strcmp(dot, ".gif") == 0 || strcmp(dot, ".y4m") == 0);
}

static bool set_walkers(struct options *options, const char *value)
{
	return read_int(value, 1, WALKERS_MAX, &options->walkers);
}

enum {
	FOR_SHOW = FOR_PLAY | FOR_RENDER
};

#define AS_IS(member) NULL, offsetof(struct options, member)

/* clang-format off */
const struct option_entry option_entries[] = {
	{'o', "output", "FILE", FOR_RENDER | FOR_POSE | FOR_PLAY,
		"the file to write", "a file name", AS_IS(output)},
	{0, "demo", "NAME", FOR_SHOW,
		"a built-in demo, no model: walker, arm, face, "
		"crowd, duel or tuner",
		"a demo's name", AS_IS(demo)},
	{0, "clip", "NAME", FOR_SHOW | FOR_POSE | FOR_COMPARE | FOR_EXPORT,
		"an animation of the model, by name or number (0 is the first)",
		"a clip's name or number", AS_IS(clip)},
	{0, "time", "T", FOR_SHOW | FOR_POSE,
		"the moment to show or begin at: seconds, 45f@30 (frames) or "
		"7200t (ticks)",
		"seconds such as 1.5, frames such as 45f@30 or ticks such as "
		"7200t, from 0 to 86400 s", set_time, 0},
	{0, "interpolation", "MODE", FOR_SHOW | FOR_POSE,
		"between keys: auto (as the file says), nearest, step, linear "
		"or cubic", "auto, nearest, step, linear or cubic",
		set_interpolation, 0},
	{0, "speed", "X", FOR_SHOW,
		"play a model's clip X times as fast, backwards if negative",
		"a number from -100 to 100", set_speed, 0},
	{0, "repeat", "KIND", FOR_SHOW,
		"how a model's clip goes on: loop, ping-pong or once (loop)",
		"loop, ping-pong or once", set_repeat, 0},
	{0, "frames", "N", FOR_SHOW,
		"stop after N frames", "a number from 1 to 1000000", set_frames, 0},
	{0, "size", "WxH", FOR_SHOW | FOR_COMPARE,
		"size of the picture in pixels (480x640, or the whole screen)",
		"width x height such as 480x640, up to 8192x8192", set_size, 0},
	{0, "format", "NAME", FOR_SHOW,
		"pixels drawn: rgb565 or rgba8888 (as suits the display)",
		"rgb565 or rgba8888", set_format, 0},
	{0, "gl", "NAME", FOR_SHOW,
		"the GL driver: auto, gles1, soft or osmesa",
		"a driver's name", AS_IS(gl)},
	{0, "egl-library", "FILE", FOR_SHOW | FOR_DOCTOR,
		"the vendor's EGL, for gles1", "a library's file name",
		AS_IS(egl_library)},
	{0, "gles-library", "FILE", FOR_SHOW | FOR_DOCTOR,
		"the vendor's OpenGL ES 1.1, for gles1",
		"a library's file name", AS_IS(gles_library)},
	{0, "display", "NAME", FOR_PLAY,
		"where pictures go: auto, window, kms, fbdev, egl, image or null",
		"a display's name", AS_IS(display)},
	{0, "fps", "N", FOR_PLAY,
		"at most N frames a second (as the screen can, or 60)",
		"a number from 1 to 1000", set_fps, 0},
	{0, "watchdog", "DEVICE", FOR_PLAY,
		"restart the board when pictures stop, such as /dev/watchdog",
		"a device such as /dev/watchdog", AS_IS(watchdog)},
	{0, "buttons", "SPEC", FOR_SHOW,
		"where buttons come from besides the window, such as "
		"script:FILE", "sources such as script:FILE", set_buttons, 0},
	{0, "script", "FILE", FOR_SHOW,
		"buttons from a file with lines TIME_MS BUTTON down|up",
		"a file name", AS_IS(script)},
	{0, "record", "FILE", FOR_PLAY,
		"keep what is shown as a film: .gif or .y4m",
		"a file name that ends in .gif or .y4m", set_record, 0},
	{0, "record-buttons", "FILE", FOR_PLAY,
		"write down what is pressed, for --script", "a file name",
		AS_IS(record_buttons)},
	{0, "config", "FILE", FOR_SHOW | FOR_POSE | FOR_DOCTOR,
		"options from this file instead of limber.conf; none: from no "
		"file", "a file name or none", AS_IS(config)},
	{0, "camera", "SPEC", FOR_SHOW,
		"live pictures: /dev/video0, auto or pattern; with ,320x240 "
		"for a size", "a camera such as auto or /dev/video0",
		AS_IS(camera)},
	{0, "camera-use", "USE", FOR_SHOW,
		"what they are for: background, screen, motion or off (F10 "
		"changes it)",
		"background, screen, motion or off", set_camera_use, 0},
	{0, "stats", "FILE", FOR_SHOW,
		"write at the end how long frames took, as JSON",
		"a file name", AS_IS(stats)},
	{0, "clock", "KIND", FOR_SHOW,
		"real, or fixed:FPS for the same times in every run",
		"real or fixed:FPS, FPS up to 1000", set_clock, 0},
	{0, "math", "KIND", FOR_SHOW | FOR_POSE,
		"how vertices are computed: float or fixed", "float or fixed",
		set_math, 0},
	{0, "kernel", "NAME", FOR_SHOW | FOR_POSE | FOR_BENCH | FOR_COMPARE,
		"which vertex loops: float, fixed, an4044 or armv6 (on ARM)",
		"a kernel's name", AS_IS(kernel)},
	{0, "influences", "N", FOR_SHOW | FOR_POSE,
		"at most N joints a vertex; auto: fewer on small figures; "
		"budget:N",
		"a number from 1 to 8, auto or budget:N",
		set_influences, 0},
	{0, "lod", "PX", FOR_SHOW,
		"coarser triangles, off by at most PX pixels (auto: 1); level:N "
		"or off",
		"auto, off, a number of pixels up to 100 or level:N", set_lod,
		0},
	{0, "no-labels", NULL, FOR_SHOW,
		"leave out the text on the picture", NULL, AS_IS(no_labels)},
	{0, "budget-ms", "N", FOR_PLAY,
		"keep frames within N ms: leave out triangles, influences, "
		"normals, poses",
		"a number from 1 to 1000", set_budget, 0},
	{0, "walkers", "N", FOR_SHOW,
		"how many walkers the demo crowd begins with (12)",
		"a number from 1 to 50", set_walkers, 0},
	{0, "hud", NULL, FOR_SHOW,
		"show how long frames take, as F9 held and H in a window do",
		NULL, AS_IS(hud)},
	{0, "runs", "N", FOR_BENCH,
		"time everything N times and take the median (15)",
		"a number from 1 to 1001", set_runs, 0},
	{0, "fps", "F", FOR_COMPARE,
		"compare F frames a second of the clip (60)",
		"a number from 1 to 240", set_rate, 0},
	{0, "error", "PX", FOR_COMPARE,
		"the error that may be, in pixels (0.5)",
		"a number from 0.001 to 1000", set_error, 0},
	{0, "ram", "BYTES", FOR_COMPARE,
		"the memory that may be used, such as 200000, 512k or 2m",
		"a number of bytes such as 200000, 512k or 2m", set_memory, 0},
	{0, "format", "KIND", FOR_COMPARE,
		"how to print: text, json, csv or md (text)", "text, json, csv or md",
		set_report, 0},
	{0, "plot", "FILE.svg", FOR_COMPARE,
		"draw error against cost, a curve a technique", "a file name",
		AS_IS(plot)},
	{0, "c", "FILE.c", FOR_EXPORT,
		"the C source to write; its name becomes the functions' prefix",
		"a file name", AS_IS(c_file)},
	{0, "export", "DIR", FOR_COMPARE,
		"keep the baked models as glTF in this folder",
		"a folder's name", AS_IS(export_folder)},
	{0, "json", NULL, FOR_INFO | FOR_BENCH | FOR_DOCTOR,
		"print JSON", NULL, AS_IS(json)},
	{'v', "verbose", NULL, FOR_ALL,
		"say more on the way", NULL, AS_IS(verbose)},
	{'h', "help", NULL, FOR_ALL,
		"print this help", NULL, AS_IS(help)},
	{0, "version", NULL, FOR_ALL,
		"print the version", NULL, AS_IS(version)},
	{0, NULL, NULL, 0, NULL, NULL, NULL, 0},
};
/* clang-format on */

_Static_assert(ARRAY_COUNT(option_entries) <= OPTIONS_MAX, "room for the names");
