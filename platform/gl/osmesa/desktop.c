#include "platform/gl/osmesa/desktop.h"

#include <stdlib.h>

#include "platform/base/compiler.h"

/*
 * The desktop of the context that is current on this thread. GL calls have no
 * parameter for it, and the library's context cannot hold a pointer to it.
 */
static _Thread_local struct desktop *current;

const struct library_slot desktop_slots[] = {
#define DESKTOP_FUNCTION(result, name, parameters) \
	{"gl" #name, offsetof(struct desktop_gl, name)},
#include "platform/gl/osmesa/desktop_functions.h"
#undef DESKTOP_FUNCTION
};

const int desktop_slot_count = (int)ARRAY_COUNT(desktop_slots);

void desktop_make_current(struct desktop *desktop)
{
	current = desktop;
}

struct desktop *desktop_current(void)
{
	return current;
}

void desktop_release(struct desktop *desktop)
{
	for (int i = 0; i < DESKTOP_ARRAY_COUNT; i++) {
		free(desktop->array[i].floats);
	}
}
