/* The buffers beside the picture: depth and stencil. */
#include "platform/gl/soft/soft.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static int grow_depth(struct soft *soft, size_t count)
{
	struct buffers *buffers = &soft->buffers;
	uint16_t *depth;

	if (count <= buffers->room) {
		return 0;
	}
	depth = calloc(count, sizeof(*depth));
	if (!depth) {
		log_error(&soft->log, "--gl soft: out of memory for depth");
		return -ENOMEM;
	}
	free(buffers->depth);
	buffers->depth = depth;
	buffers->room = count;
	return 0;
}

uint8_t *soft_stencil(struct soft *soft)
{
	struct buffers *buffers = &soft->buffers;

	if (!buffers->stencil) {
		size_t room = buffers->room ? buffers->room : 1;

		buffers->stencil = malloc(room);
		if (buffers->stencil) {
			memset(buffers->stencil, soft->fragment.stencil.clear,
				room);
			buffers->stencil_room = room;
		}
	}
	return buffers->stencil;
}

/* Once there is a stencil it keeps the size of the depth. */
static int grow_stencil(struct soft *soft)
{
	struct buffers *buffers = &soft->buffers;

	if (!buffers->stencil || buffers->stencil_room >= buffers->room) {
		return 0;
	}
	free(buffers->stencil);
	buffers->stencil = NULL;
	if (!soft_stencil(soft)) {
		log_error(&soft->log, "--gl soft: out of memory for stencil");
		return -ENOMEM;
	}
	return 0;
}

int soft_grow_buffers(struct soft *soft, size_t pixels)
{
	int error = grow_depth(soft, pixels);

	return error ? error : grow_stencil(soft);
}
