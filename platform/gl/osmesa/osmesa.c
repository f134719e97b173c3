/*
 * Mesa's off-screen library: desktop OpenGL that the processor draws directly
 * into the target's memory.
 */
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/compiler.h"
#include "platform/gl/gl_context.h"
#include "platform/gl/loader.h"
#include "platform/gl/osmesa/desktop.h"

/* From OSMesa's interface, so that its header is not needed to build. */
#define OSMESA_RGBA       0x1908
#define OSMESA_RGB_565    0x0005
#define OSMESA_ROW_LENGTH 0x0010
#define OSMESA_Y_UP       0x0011

/* The context needs a picture before the first frame; nothing is drawn in it. */
enum {
	SCRATCH_SIZE = 16
};

struct osmesa_api {
	void *(*CreateContextExt)(GLenum format, GLint depth_bits,
		GLint stencil_bits, GLint accumulation_bits, void *share);
	void (*DestroyContext)(void *handle);
	GLboolean (*MakeCurrent)(void *handle, void *buffer, GLenum type,
		GLsizei width, GLsizei height);
	void (*PixelStore)(GLint name, GLint value);
};

static const struct library_slot osmesa_slots[] = {
	{"OSMesaCreateContextExt", offsetof(struct osmesa_api, CreateContextExt)},
	{"OSMesaDestroyContext", offsetof(struct osmesa_api, DestroyContext)},
	{"OSMesaMakeCurrent", offsetof(struct osmesa_api, MakeCurrent)},
	{"OSMesaPixelStore", offsetof(struct osmesa_api, PixelStore)},
};

extern const struct gl_driver gl_driver_osmesa;

struct osmesa_context {
	struct gl_context base; /* first: the two share their address */
	struct osmesa_api api;
	struct desktop desktop;
	struct log log;
	enum pixel_format format;
	void *handle;
	int width, height; /* of the last frame */
	char description[128];
	uint32_t scratch[SCRATCH_SIZE * SCRATCH_SIZE];
};

static int load_functions(struct osmesa_context *osmesa)
{
	static const char *const names[] = {
		"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so", NULL};
	const char *missing;
	const char *why = "";
	void *library;

	library = gl_library_open(names, &why);
	if (!library) {
		log_error(&osmesa->log,
			"--gl osmesa: there is no libOSMesa.so.8 on this machine (%s): install Debian's libosmesa6, or choose another --gl",
			why);
		return -ENOENT;
	}
	missing = library_fill(&osmesa->api, osmesa_slots,
		(int)ARRAY_COUNT(osmesa_slots), library_find, library);
	if (!missing) {
		missing = library_fill(&osmesa->desktop.gl, desktop_slots,
			desktop_slot_count, library_find, library);
	}
	if (!missing) {
		desktop_set_fixed_shims(&osmesa->base.gl);
		desktop_set_array_shims(&osmesa->base.gl);
		missing = library_fill(&osmesa->base.gl, gl_slots,
			gl_slot_count, library_find, library);
	}
	if (missing) {
		log_error(&osmesa->log,
			"--gl osmesa: the machine's libOSMesa has no %s: choose another --gl",
			missing);
		return -ENOSYS;
	}
	return 0;
}

static bool make_current(struct osmesa_context *osmesa, void *data, int width,
	int height, int row_pixels)
{
	GLenum type = osmesa->format == PIXELS_RGB565 ? GL_UNSIGNED_SHORT_5_6_5
						      : GL_UNSIGNED_BYTE;

	if (!osmesa->api.MakeCurrent(osmesa->handle, data, type, width, height)) {
		return false;
	}
	osmesa->api.PixelStore(OSMESA_Y_UP, 0);
	osmesa->api.PixelStore(OSMESA_ROW_LENGTH, row_pixels);
	desktop_make_current(&osmesa->desktop);
	return true;
}

static int open_context(struct osmesa_context *osmesa)
{
	GLenum format =
		osmesa->format == PIXELS_RGB565 ? OSMESA_RGB_565 : OSMESA_RGBA;

	osmesa->handle = osmesa->api.CreateContextExt(format, 24, 8, 0, NULL);
	if (!osmesa->handle ||
		!make_current(osmesa, osmesa->scratch, SCRATCH_SIZE,
			SCRATCH_SIZE, SCRATCH_SIZE)) {
		log_error(&osmesa->log,
			"--gl osmesa: the library cannot create a context for %s pictures: choose another --gl",
			osmesa->format == PIXELS_RGB565 ? "RGB565" : "RGBA8888");
		return -EIO;
	}
	return 0;
}

static void osmesa_destroy(struct gl_context *context)
{
	struct osmesa_context *osmesa = (struct osmesa_context *)context;

	if (!osmesa) {
		return;
	}
	if (osmesa->handle) {
		/* The last target may be freed, and destroying may flush to it. */
		make_current(osmesa, osmesa->scratch, SCRATCH_SIZE,
			SCRATCH_SIZE, SCRATCH_SIZE);
		desktop_make_current(NULL);
		osmesa->api.DestroyContext(osmesa->handle);
	}
	desktop_release(&osmesa->desktop);
	free(osmesa);
}

static int osmesa_create(
	const struct gl_request *request, struct gl_context **out)
{
	const struct log *log = request->log;
	struct osmesa_context *osmesa = calloc(1, sizeof(*osmesa));
	const struct gl *gl;
	int error;

	if (!osmesa) {
		log_error(log, "--gl osmesa: out of memory");
		return -ENOMEM;
	}
	osmesa->base.driver = &gl_driver_osmesa;
	osmesa->log = *log;
	osmesa->format = request->format;
	error = load_functions(osmesa);
	if (!error) {
		error = open_context(osmesa);
	}
	if (error) {
		osmesa_destroy(&osmesa->base);
		return error;
	}
	gl = &osmesa->base.gl;
	snprintf(osmesa->description, sizeof(osmesa->description), "%s, %s",
		(const char *)gl->GetString(GL_RENDERER),
		(const char *)gl->GetString(GL_VERSION));
	osmesa->base.description = osmesa->description;
	*out = &osmesa->base;
	return 0;
}

static int osmesa_begin_frame(
	struct gl_context *context, const struct pixels *target)
{
	struct osmesa_context *osmesa = (struct osmesa_context *)context;
	int pixel = pixel_bytes(osmesa->format);

	if (target->format != osmesa->format ||
		target->stride_bytes % pixel != 0) {
		log_error(&osmesa->log,
			"--gl osmesa: the picture and the context have different formats");
		return -EINVAL;
	}
	if (!make_current(osmesa, target->data, target->width, target->height,
		    target->stride_bytes / pixel)) {
		log_error(&osmesa->log,
			"--gl osmesa: cannot draw a picture of %dx%d",
			target->width, target->height);
		return -EIO;
	}
	if (target->width != osmesa->width || target->height != osmesa->height) {
		osmesa->width = target->width;
		osmesa->height = target->height;
		context->gl.Viewport(0, 0, target->width, target->height);
		context->gl.Scissor(0, 0, target->width, target->height);
	}
	return 0;
}

static int osmesa_end_frame(struct gl_context *context)
{
	context->gl.Finish();
	return 0;
}

/* Never chosen by auto: it is the reference, and too slow. */
static bool osmesa_probe(void)
{
	return false;
}

const struct gl_driver gl_driver_osmesa = {
	.name = "osmesa",
	.summary = "Mesa's off-screen OpenGL, drawn by the processor",
	.packages = "libosmesa6",
	.probe = osmesa_probe,
	.create = osmesa_create,
	.begin_frame = osmesa_begin_frame,
	.end_frame = osmesa_end_frame,
	.destroy = osmesa_destroy,
};
