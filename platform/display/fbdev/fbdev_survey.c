/* The framebuffers that limber doctor reports. */
#include "platform/display/fbdev/fbdev.h"

#include <errno.h>
#include <stdio.h>

#include "platform/display/console.h"
#include "platform/display/fbdev/fbdev_screen.h"

enum {
	SCREENS_MAX = 8
};

static void describe_layout(
	const struct fbdev_screen *screen, char *text, size_t size)
{
	const struct pixel_layout *layout = &screen->layout;

	if (screen->fix.visual == FB_VISUAL_PSEUDOCOLOR) {
		snprintf(text, size, "a palette");
	} else if (layout->gray) {
		snprintf(text, size, "gray");
	} else {
		snprintf(text, size, "r%d@%d g%d@%d b%d@%d", layout->red.length,
			layout->red.offset, layout->green.length,
			layout->green.offset, layout->blue.length,
			layout->blue.offset);
	}
}

static void report_screen(const struct device_calls *calls,
	const struct fbdev_screen *screen, const struct survey *survey)
{
	uint64_t page =
		(uint64_t)screen->stride_bytes * (uint64_t)screen->height;
	int pages = (int)(screen->fix.smem_len / page);
	char layout[64], text[160];

	describe_layout(screen, layout, sizeof(layout));
	snprintf(text, sizeof(text), "%.*s: %dx%d, %u bits (%s), %d page%s",
		(int)sizeof(screen->fix.id), screen->fix.id, screen->width,
		screen->height, screen->var.bits_per_pixel, layout, pages,
		pages == 1 ? "" : "s");
	if (console_is_in_use(calls)) {
		survey_report(survey, SURVEY_TAKEN, screen->path,
			console_in_use_remedy,
			"%s, another program uses it (X or Wayland)", text);
	} else {
		survey_report(
			survey, SURVEY_WORKS, screen->path, NULL, "%s", text);
	}
}

/* Reports the device of that number; false when there is none. */
static bool report_number(const struct device_calls *calls, int number,
	const struct survey *survey)
{
	struct survey_message message;
	struct log log = survey_log(&message);
	struct fbdev_screen screen;
	char path[FBDEV_PATH_BYTES], entry[64];
	int error;

	snprintf(path, sizeof(path), "/dev/fb%d", number);
	error = fbdev_screen_inspect(&screen, calls, path, &log);
	if (!error) {
		report_screen(calls, &screen, survey);
	} else if (error == -EACCES) {
		survey_report_denied(survey, path);
	} else if (error == -ENODEV) {
		snprintf(entry, sizeof(entry), "class/graphics/fb%d", number);
		return survey_report_no_node(survey, path, entry, -ENOENT);
	} else {
		survey_report_message(
			survey, SURVEY_BROKEN, path, &message, NULL);
	}
	return true;
}

void fbdev_survey_on(
	const struct device_calls *calls, const struct survey *survey)
{
	bool any = false;

	for (int i = 0; i < SCREENS_MAX; i++) {
		any = report_number(calls, i, survey) || any;
	}
	if (!any) {
		survey_report(survey, SURVEY_MISSING, "/dev/fb*",
			"load the screen's driver: sudo modprobe DRIVER, or use --display kms",
			"there is no framebuffer");
	}
}
