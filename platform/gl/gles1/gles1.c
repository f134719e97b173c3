/*
 * OpenGL ES 1.1 through EGL, on a native surface or into a pbuffer whose pixels
 * are read back.
 */
#include <errno.h>
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/gl/gl_context.h"
#include "platform/gl/gles1/gles1_egl.h"
#include "platform/gl/loader.h"

/* The context needs a surface before the first frame; nothing is drawn on it. */
enum {
	FIRST_SIZE = 16
};

extern const struct gl_driver gl_driver_gles1;

struct gles1_context {
	struct gl_context base; /* first: the two share their address */
	struct egl egl;
	struct log log;
	enum pixel_format format;
	bool on_surface;
	struct pixels target;
	int width, height; /* of the viewport */
	uint8_t *rgba;     /* the pixels read back, bottom row first */
	char description[128];
};

static void gles1_destroy(struct gl_context *context)
{
	struct gles1_context *gles1 = (struct gles1_context *)context;

	if (gles1) {
		egl_close(&gles1->egl);
		free(gles1->rgba);
		free(gles1);
	}
}

/* GL does not say whether it is accelerated, so the renderer's name decides. */
static bool is_software(const char *renderer)
{
	static const char *const names[] = {
		"llvmpipe", "softpipe", "swrast", "Software Rasterizer", NULL};

	for (int i = 0; names[i]; i++) {
		if (strstr(renderer, names[i])) {
			return true;
		}
	}
	return false;
}

static void describe(struct gles1_context *gles1)
{
	const struct gl *gl = &gles1->base.gl;
	const char *renderer = (const char *)gl->GetString(GL_RENDERER);
	const char *version = (const char *)gl->GetString(GL_VERSION);

	renderer = renderer ? renderer : "unnamed";
	snprintf(gles1->description, sizeof(gles1->description), "%s, %s",
		renderer, version ? version : "OpenGL ES");
	gles1->base.description = gles1->description;
	gles1->base.accelerated = !is_software(renderer);
}

static int open_context(
	struct gles1_context *gles1, const struct gl_request *request)
{
	struct gl *gl = &gles1->base.gl;
	const char *missing;
	int error = egl_open(&gles1->egl, request);

	if (!error) {
		error = request->surface
			? egl_make_current(&gles1->egl)
			: egl_set_pbuffer(&gles1->egl, FIRST_SIZE, FIRST_SIZE);
	}
	if (error) {
		return error;
	}
	missing = library_fill(
		gl, gl_slots, gl_slot_count, egl_get_function, &gles1->egl);
	if (missing) {
		log_error(&gles1->log,
			"--gl gles1: the machine's OpenGL ES has no %s: choose another --gl",
			missing);
		return -ENOSYS;
	}
	describe(gles1);
	if (request->surface) {
		egl_set_swap_interval(&gles1->egl);
		egl_get_size(
			&gles1->egl, &gles1->base.width, &gles1->base.height);
	}
	return 0;
}

static int gles1_create(
	const struct gl_request *request, struct gl_context **out)
{
	const struct log *log = request->log;
	struct gles1_context *gles1 = calloc(1, sizeof(*gles1));
	int error;

	if (!gles1) {
		log_error(log, "--gl gles1: out of memory");
		return -ENOMEM;
	}
	gles1->base.driver = &gl_driver_gles1;
	gles1->log = *log;
	gles1->format = request->format;
	gles1->on_surface = request->surface != NULL;
	error = open_context(gles1, request);
	if (error) {
		gles1_destroy(&gles1->base);
		return error;
	}
	*out = &gles1->base;
	return 0;
}

static void set_size(struct gles1_context *gles1, int width, int height)
{
	gles1->width = width;
	gles1->height = height;
	gles1->base.gl.Viewport(0, 0, width, height);
	gles1->base.gl.Scissor(0, 0, width, height);
}

static int resize(struct gles1_context *gles1, int width, int height)
{
	uint8_t *rgba = malloc((size_t)width * (size_t)height * 4);
	int error;

	if (!rgba) {
		log_error(&gles1->log,
			"--gl gles1: out of memory for a picture of %dx%d",
			width, height);
		return -ENOMEM;
	}
	error = egl_set_pbuffer(&gles1->egl, width, height);
	if (error) {
		free(rgba);
		return error;
	}
	free(gles1->rgba);
	gles1->rgba = rgba;
	set_size(gles1, width, height);
	return 0;
}

static int begin_on_surface(struct gles1_context *gles1)
{
	struct gl_context *base = &gles1->base;
	int error = egl_make_current(&gles1->egl);

	if (error) {
		return error;
	}
	egl_get_size(&gles1->egl, &base->width, &base->height);
	if (base->width < 1 || base->height < 1) {
		log_error(&gles1->log,
			"--display egl: EGL does not tell the size of its surface: choose another --display");
		return -EIO;
	}
	if (base->width != gles1->width || base->height != gles1->height) {
		set_size(gles1, base->width, base->height);
	}
	return 0;
}

static int gles1_begin_frame(
	struct gl_context *context, const struct pixels *target)
{
	struct gles1_context *gles1 = (struct gles1_context *)context;

	if (gles1->on_surface) {
		return begin_on_surface(gles1);
	}
	if (target->format != gles1->format) {
		log_error(&gles1->log,
			"--gl gles1: the picture and the context have different formats");
		return -EINVAL;
	}
	gles1->target = *target;
	if (target->width != gles1->width || target->height != gles1->height) {
		return resize(gles1, target->width, target->height);
	}
	return egl_make_current(&gles1->egl);
}

/* Rounding to nearest restores the exact values of a 565 surface. */
static void copy_565(uint8_t *out, const uint8_t *rgba, int width)
{
	for (int x = 0; x < width; x++, rgba += 4, out += 2) {
		unsigned int red = (rgba[0] * 31u + 127) / 255;
		unsigned int green = (rgba[1] * 63u + 127) / 255;
		unsigned int blue = (rgba[2] * 31u + 127) / 255;
		uint16_t pixel = (uint16_t)(red << 11 | green << 5 | blue);

		memcpy(out, &pixel, 2);
	}
}

static void read_back(struct gles1_context *gles1)
{
	const struct gl_context *context = &gles1->base;
	const struct pixels *target = &gles1->target;
	size_t row_bytes = (size_t)target->width * 4;
	GLint alignment = 4;

	context->gl.GetIntegerv(GL_PACK_ALIGNMENT, &alignment);
	context->gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
	context->gl.ReadPixels(0, 0, target->width, target->height, GL_RGBA,
		GL_UNSIGNED_BYTE, gles1->rgba);
	context->gl.PixelStorei(GL_PACK_ALIGNMENT, alignment);
	for (int y = 0; y < target->height; y++) {
		const uint8_t *row = gles1->rgba +
			(size_t)(target->height - 1 - y) * row_bytes;
		uint8_t *out = target->data + y * target->stride_bytes;

		if (target->format == PIXELS_RGB565) {
			copy_565(out, row, target->width);
		} else {
			memcpy(out, row, row_bytes);
		}
	}
}

static int gles1_end_frame(struct gl_context *context)
{
	struct gles1_context *gles1 = (struct gles1_context *)context;

	if (gles1->on_surface) {
		return egl_swap(&gles1->egl);
	}
	read_back(gles1);
	return 0;
}

/*
 * Opening EGL takes time, so "auto" only does it if there is the device file of
 * a graphics processor, or the user names a library.
 */
static bool gles1_probe(void)
{
	static const char *const devices[] = {"/dev/dri/renderD*", "/dev/pvr*",
		"/dev/mali*", "/dev/galcore", "/dev/kgsl*", "/dev/nvidia0",
		NULL};
	const char *library = getenv("LIMBER_EGL");
	bool found = library && library[0];

	for (int i = 0; !found && devices[i]; i++) {
		glob_t list = {0};

		found = glob(devices[i], 0, NULL, &list) == 0;
		globfree(&list);
	}
	return found;
}

const struct gl_driver gl_driver_gles1 = {
	.name = "gles1",
	.summary = "OpenGL ES 1.1 through EGL",
	.surface = true,
	.probe = gles1_probe,
	.accelerates = true,
	.packages = "libegl1 libegl-mesa0 libgles1 libgl1-mesa-dri",
	.create = gles1_create,
	.begin_frame = gles1_begin_frame,
	.end_frame = gles1_end_frame,
	.destroy = gles1_destroy,
	.find_screen = egl_find_screen,
};
