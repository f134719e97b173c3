/*
 * Draws frames of a demo, or of the viewer with a model file, into a picture of
 * 480x640, to count what they cost.
 *
 *	demo_frames DEMO[@SECONDS] FRAMES [DRIVER [PICTURE.ppm [rgba]]]
 *	demo_frames MODEL.glb[@SECONDS] FRAMES [DRIVER [PICTURE.ppm [rgba]]]
 *
 * The demo's time begins at SECONDS, or at one second, and advances by 40 ms a
 * frame. The picture is RGB565 unless rgba follows. For the timing model
 * (tests/arm1136) the last frame is region 1.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <jansson.h>

#include "app/demo/demo_figures.h"
#include "platform/base/file.h"
#include "platform/gl/gl_context.h"
#include "tests/arm1136/marker.h"
#include "tests/bench/bench_picture.h"

enum {
	WIDTH = 480,
	HEIGHT = 640,
};

/* Cuts @SECONDS off a demo's name and returns them; -1 when they are wrong. */
static double find_start(char *name)
{
	char *at = strchr(name, '@'), *end;
	double start_s;

	if (!at) {
		return 1.0;
	}
	*at = '\0';
	start_s = strtod(at + 1, &end);
	return end > at + 1 && *end == '\0' && start_s >= 0.0 ? start_s : -1.0;
}

static void draw_frames(const struct demo_driver *driver, struct demo *demo,
	struct gl_context *context, struct pixels *pixels, double from_s,
	int frames)
{
	static struct hud hud;
	struct log log = log_to_stderr(LOG_WARNING);

	if (hud_init(&hud, &context->gl, &log) != 0) {
		exit(EXIT_FAILURE);
	}
	/* A second at a time, since a character takes no longer steps than ten. */
	for (double time_s = 1.0; time_s < from_s; time_s += 1.0) {
		driver->update(demo, time_s);
	}
	for (int frame = 0; frame < frames; frame++) {
		if (frame == frames - 1) {
			MARKER_BEGIN(1);
		}
		driver->update(demo, from_s + frame / 25.0);
		if (context->driver->begin_frame(context, pixels) != 0) {
			exit(EXIT_FAILURE);
		}
		demo_draw_stage(driver, demo, WIDTH, HEIGHT);
		hud_begin(&hud, WIDTH, HEIGHT);
		driver->label(demo, &hud);
		hud_end(&hud, &context->gl);
		context->driver->end_frame(context);
		MARKER_END(1);
	}
	hud_finish(&hud, &context->gl);
}

/* The demo of that name, or the viewer if the name is a file's. */
static const struct demo_driver *find_driver(
	const char *name, struct log *log, char *path, size_t size)
{
	const struct demo_driver *driver = demo_find(name);

	if (driver) {
		return file_find_asset(driver->asset, log, path, size) == 0
			? driver
			: NULL;
	}
	return (size_t)snprintf(path, size, "%s", name) < size
		? &demo_driver_viewer
		: NULL;
}

int main(int argc, char **argv)
{
	struct log log = log_to_stderr(LOG_WARNING);
	enum pixel_format format = argc > 5 && strcmp(argv[5], "rgba") == 0
		? PIXELS_RGBA8888
		: PIXELS_RGB565;
	double from_s = argc > 2 ? find_start(argv[1]) : -1.0;
	const struct demo_driver *driver = NULL;
	struct gl_context *context;
	struct pixels pixels;
	struct demo *demo;
	char path[1024];
	struct demo_env env = {
		.log = &log,
		.target = format,
		.kernel = kernel_registry[0],
		.width = WIDTH,
		.height = HEIGHT,
		.model_path = path,
		.speed = 1.0f,
		.unattended = true,
	};

	/* With a random seed, addresses would differ from run to run. */
	json_object_seed(1);
	if (from_s >= 0.0 && atoi(argv[2]) >= 1) {
		driver = find_driver(argv[1], &log, path, sizeof(path));
	}
	if (!driver) {
		fprintf(stderr,
			"usage: %s DEMO|MODEL.glb[@SECONDS] FRAMES "
			"[DRIVER [PICTURE.ppm [rgba]]]\n",
			argv[0]);
		return 2;
	}
	if (pixels_alloc(&pixels, WIDTH, HEIGHT, format, &log) != 0 ||
		gl_open(argc > 3 ? argv[3] : "soft",
			&(struct gl_request){.format = format, .log = &log},
			&context) != 0) {
		return EXIT_FAILURE;
	}
	env.gl = &context->gl;
	if (demo_create(driver, &env, &demo) != 0) {
		return EXIT_FAILURE;
	}
	draw_frames(driver, demo, context, &pixels, from_s, atoi(argv[2]));
	if (argc > 4) {
		bench_picture_write(argv[4], &pixels);
	}
	demo_destroy(driver, demo);
	context->driver->destroy(context);
	free(pixels.data);
	return EXIT_SUCCESS;
}
