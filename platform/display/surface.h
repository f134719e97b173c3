/*
 * A window or a whole screen that EGL draws on directly.
 */
#ifndef PLATFORM_DISPLAY_SURFACE_H
#define PLATFORM_DISPLAY_SURFACE_H

#include <stdint.h>

/*
 * window is EGL's EGLNativeWindowType. Its meaning depends on the EGL: the id
 * of an X11 window, or a pointer. On framebuffers without a window system, 0
 * usually means the whole screen.
 */
struct native_surface {
	uintptr_t window;
};

#endif
