#include "app/character/sketch/sketch_names.h"

#include "platform/base/printable.h"

#include <string.h>

enum {
	NAME_BYTES = 64,
	/* 49 bytes without "state " and two quotation marks */
	HEADING_NAME = 41
};

void sketch_write_name(FILE *out, const char *name)
{
	bool plain = *name && !strpbrk(name, " \t,;\"#");

	fprintf(out, plain ? "%s" : "\"%s\"", name);
}

bool sketch_is_usable(const char *name)
{
	char shown[NAME_BYTES];

	if (!*name || strlen(name) >= sizeof(shown) ||
		strpbrk(name, "\"];\r\n")) {
		return false;
	}
	strcpy(shown, name);
	printable_make(shown);
	return strcmp(shown, name) == 0;
}

bool sketch_fits_heading(const char *name)
{
	return strlen(name) <= HEADING_NAME;
}
