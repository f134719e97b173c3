/* The driver: its context, its frames and its buffers. */
#include "platform/gl/soft/soft.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/vertex/draw.h"

extern const struct gl_driver gl_driver_soft;

static void soft_destroy(struct gl_context *context)
{
	struct soft *soft = (struct soft *)context;

	if (!soft) {
		return;
	}
	if (soft_current() == soft) {
		soft_make_current(NULL);
	}
	soft_release_textures(soft);
	free(soft->buffers.depth);
	free(soft->buffers.stencil);
	free(soft->draw);
	free(soft);
}

static int soft_create(const struct gl_request *request, struct gl_context **out)
{
	const struct log *log = request->log;
	struct soft *soft = calloc(1, sizeof(*soft));
	struct draw *draw = aligned_alloc(_Alignof(struct draw), sizeof(*draw));

	if (!soft || !draw) {
		log_error(log, "--gl soft: out of memory");
		free(soft);
		free(draw);
		return -ENOMEM;
	}
	memset(draw, 0, sizeof(*draw));
	draw->soft = soft;
	soft_init_scratch(draw);
	soft->draw = draw;
	soft->base.driver = &gl_driver_soft;
	soft->base.description = "limber's own, fixed point, OpenGL ES-CL 1.1";
	soft->log = *log;
	soft->format = request->format;
	soft_init_state(soft);
	soft_make_current(soft);
	*out = &soft->base;
	return 0;
}

/* Makes room in the depth buffer and, if there is one, in the stencil buffer. */
static int grow_buffers(struct soft *soft, size_t count)
{
	struct buffers *buffers = &soft->buffers;
	const bool stencil = buffers->stencil != NULL;

	if (count <= buffers->room) {
		return 0;
	}
	free(buffers->depth);
	free(buffers->stencil);
	buffers->stencil = NULL;
	buffers->depth = calloc(count, sizeof(*buffers->depth));
	buffers->room = buffers->depth ? count : 0;
	if (!buffers->depth || (stencil && !soft_stencil(soft))) {
		log_error(&soft->log, "--gl soft: out of memory for %s",
			buffers->depth ? "stencil" : "depth");
		return -ENOMEM;
	}
	return 0;
}

/* The last address of four pixels. */
static uintptr_t find_last(const struct pixels *target)
{
	const int last_row = target->stride_bytes < 0 ? 0 : target->height - 1;

	return (uintptr_t)pixel_at(target, target->width, last_row) -
		4 * (uintptr_t)pixel_bytes(target->format);
}

static int soft_begin_frame(
	struct gl_context *context, const struct pixels *target)
{
	struct soft *soft = (struct soft *)context;
	struct buffers *buffers = &soft->buffers;
	int error;

	soft_make_current(soft);
	if (target->format != soft->format ||
		target->stride_bytes % pixel_bytes(soft->format) != 0) {
		log_error(&soft->log,
			"--gl soft: cannot draw into a picture of another format than the context's");
		return -EINVAL;
	}
	if (target->width < 1 || target->height < 1 ||
		target->width > PIXELS_SIZE_MAX ||
		target->height > PIXELS_SIZE_MAX) {
		log_error(&soft->log, "--gl soft: cannot draw %dx%d pixels",
			target->width, target->height);
		return -EINVAL;
	}
	/* the last depths are read as four */
	error = grow_buffers(
		soft, (size_t)target->width * (size_t)target->height + 3);
	if (error) {
		return error;
	}
	/* Between frames others use the cache: see is_read_again() in counts.c. */
	if (soft->counts) {
		memset(soft->draw->recent, 0, sizeof(soft->draw->recent));
	}
	if (target->width != buffers->width ||
		target->height != buffers->height) {
		const struct rectangle all = {
			0, 0, target->width, target->height};

		soft->fragment.viewport = all;
		soft->fragment.scissor = all;
		buffers->width = target->width;
		buffers->height = target->height;
	}
	buffers->target = *target;
	soft->draw->spans.run.last = find_last(target);
	return 0;
}

/* After this the driver does not touch the target. */
static int soft_end_frame(struct gl_context *context)
{
	struct soft *soft = (struct soft *)context;

	soft->buffers.target.data = NULL;
	return 0;
}

static void soft_count(struct gl_context *context, struct gl_counts *counts)
{
	struct soft *soft = (struct soft *)context;

	soft->counts = counts;
	soft->changed = GROUP_ALL;
}

const struct gl_driver gl_driver_soft = {
	.name = "soft",
	.summary = "limber's own fixed-point OpenGL, for boards without a GPU",
	.create = soft_create,
	.begin_frame = soft_begin_frame,
	.end_frame = soft_end_frame,
	.count = soft_count,
	.destroy = soft_destroy,
};
