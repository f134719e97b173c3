#include "platform/process/library.h"

#include <dlfcn.h>
#include <string.h>

void *library_open(const char *const *names, const char **why)
{
	for (; *names; names++) {
		void *library =
			dlopen(*names, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);

		if (library) {
			return library;
		}
		if (why) {
			*why = dlerror();
		}
	}
	return NULL;
}

library_function library_find(void *library, const char *name)
{
	void *address = dlsym(library, name);
	library_function function;

	/* ISO C cannot convert a data pointer to a function pointer, but POSIX
	 * guarantees that both have the same representation. */
	memcpy(&function, &address, sizeof(function));
	return function;
}

const char *library_fill(void *table, const struct library_slot *slots,
	int slot_count, library_function (*find)(void *user, const char *name),
	void *user)
{
	for (int i = 0; i < slot_count; i++) {
		char *member = (char *)table + slots[i].offset;
		library_function function;

		memcpy(&function, member, sizeof(function));
		if (function) {
			continue;
		}
		function = find(user, slots[i].name);
		if (!function) {
			return slots[i].name;
		}
		memcpy(member, &function, sizeof(function));
	}
	return NULL;
}
