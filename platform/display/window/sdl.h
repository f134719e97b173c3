/*
 * SDL, which limber opens with its first window: the library needs 45
 * others, which would take most of the time of a start.
 */
#ifndef PLATFORM_DISPLAY_WINDOW_SDL_H
#define PLATFORM_DISPLAY_WINDOW_SDL_H

#include <SDL.h>

#include "platform/base/compiler.h"
#include "platform/base/log.h"

/* Debian's package of the library. */
#define SDL_PACKAGE "libsdl2-2.0-0"

/* SDL_Name() is the member Name. */
struct sdl {
#define WINDOW_FUNCTION(name) POINTER_TO(SDL_##name) name;
#include "platform/display/window/sdl_functions.h"
#undef WINDOW_FUNCTION
};

/*
 * Fills *sdl. The library stays open. Returns 0, or after logging an error
 * -ENOENT when the library cannot be opened or -ENOSYS when it lacks a function.
 */
int sdl_load(struct sdl *sdl, const struct log *log);

#endif
