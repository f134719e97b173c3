/*
 * What an EGL draws on without pixels of ours: a window or a whole screen.
 */
#ifndef PLATFORM_DISPLAY_SURFACE_H
#define PLATFORM_DISPLAY_SURFACE_H

#include <stdint.h>

/*
 * On bare framebuffers a window of 0 usually means all of the screen. What a
 * number means is between the person and the EGL: an X11 window's id, a
 * pointer.
 */
struct native_surface {
	uintptr_t window;
};

#endif
