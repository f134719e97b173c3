#include "platform/display/window/sdl.h"

#include <errno.h>
#include <stddef.h>

#include "platform/process/library.h"

#define REMEDY                          \
	"install Debian's " SDL_PACKAGE \
	", choose another --display, or write a file with limber render"

static const struct library_slot slots[] = {
#define WINDOW_FUNCTION(name) {"SDL_" #name, offsetof(struct sdl, name)},
#include "platform/display/window/sdl_functions.h"
#undef WINDOW_FUNCTION
};

int sdl_load(struct sdl *sdl, const struct log *log)
{
	static const char *const names[] = {"libSDL2-2.0.so.0", NULL};
	const char *why = "";
	const char *missing;
	void *library = library_open(names, &why);

	if (!library) {
		log_error(log,
			"--display window: there is no %s on this machine (%s): " REMEDY,
			names[0], why);
		return -ENOENT;
	}
	*sdl = (struct sdl){NULL};
	missing = library_fill(
		sdl, slots, (int)ARRAY_COUNT(slots), library_find, library);
	if (missing) {
		log_error(log,
			"--display window: the machine's %s has no %s: " REMEDY,
			names[0], missing);
		return -ENOSYS;
	}
	return 0;
}
