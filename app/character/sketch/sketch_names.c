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

/* Whether a file can hold the clip's name, and no earlier clip has it. */
static bool has_usable_name(const struct model *model, int clip)
{
	const char *name = model->clip[clip].name;

	return sketch_is_usable(name) && model_find_clip(model, name) == clip;
}

void sketch_write_clip(FILE *out, const struct model *model, int clip)
{
	if (has_usable_name(model, clip)) {
		sketch_write_name(out, model->clip[clip].name);
	} else {
		fprintf(out, "%d", clip);
	}
}

void sketch_write_heading(FILE *out, const struct model *model, int clip)
{
	const char *name = model->clip[clip].name;
	char number[24];

	snprintf(number, sizeof(number), "clip %d", clip);
	if (has_usable_name(model, clip) && sketch_fits_heading(name)) {
		sketch_write_name(out, name);
	} else if (model_find_clip(model, number) >= 0) {
		fprintf(out, "%d", clip);
	} else {
		sketch_write_name(out, number);
	}
}
