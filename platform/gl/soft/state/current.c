/* The context that calls of GL work on, its error, and its stencil. */
#include <stdlib.h>
#include <string.h>

#include "platform/gl/soft/state/parameter.h"

/* What GL's calls on this thread work on: they have no parameter to say it. */
static _Thread_local struct soft *current;

struct soft *soft_current(void)
{
	return current;
}

void soft_make_current(struct soft *soft)
{
	current = soft;
}

void soft_set_error(struct soft *soft, GLenum error)
{
	if (soft->error == GL_NO_ERROR) {
		soft->error = error;
	}
}

bool soft_is_one_of(GLenum value, const GLenum *known, size_t count)
{
	for (size_t i = 0; i < count; i++) {
		if (known[i] == value) {
			return true;
		}
	}
	return false;
}

/* It keeps the size of the depth. */
uint8_t *soft_stencil(struct soft *soft)
{
	struct buffers *buffers = &soft->buffers;
	size_t room = buffers->room ? buffers->room : 1;

	if (buffers->stencil_room < room) {
		free(buffers->stencil);
		buffers->stencil = malloc(room);
		buffers->stencil_room = buffers->stencil ? room : 0;
		if (buffers->stencil) {
			memset(buffers->stencil, soft->fragment.stencil.clear,
				room);
		}
	}
	return buffers->stencil;
}
