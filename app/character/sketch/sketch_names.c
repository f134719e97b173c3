#include "app/character/sketch/sketch_names.h"

#include "platform/base/printable.h"

#include <stdlib.h>
#include <string.h>

enum {
	NAME_BYTES = 64,
	NUMBER_BYTES = 24,
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

struct named {
	const char *name;
	int node;
};

/* By name; nodes of the same name by their numbers. */
static int compare_named(const void *a, const void *b)
{
	const struct named *one = a, *other = b;
	int order = strcmp(one->name, other->name);

	return order != 0 ? order : one->node - other->node;
}

bool *sketch_find_named_nodes(const struct model *model, struct arena *arena)
{
	const size_t count = (size_t)model->node_count;
	bool *named = ARENA_ARRAY(arena, bool, count);
	struct named *sorted = ARENA_ARRAY(arena, struct named, count);

	if (!named || !sorted) {
		return NULL;
	}
	for (size_t i = 0; i < count; i++) {
		sorted[i] = (struct named){model->node[i].name, (int)i};
	}
	qsort(sorted, count, sizeof(*sorted), compare_named);
	for (size_t i = 0; i < count; i++) {
		named[sorted[i].node] = sketch_is_usable(sorted[i].name) &&
			(i == 0 ||
				strcmp(sorted[i - 1].name, sorted[i].name) != 0);
	}
	return named;
}

/* Whether a file can hold the clip's name, and no earlier clip has it. */
static bool has_usable_name(const struct model *model, int clip)
{
	const char *name = model->clip[clip].name;

	return sketch_is_usable(name) && model_find_clip(model, name) == clip;
}

/* Zeros make a clip's number differ from the names that other clips have. */
static void find_number(
	const struct model *model, int clip, char out[NUMBER_BYTES])
{
	int digits = 0;

	do {
		snprintf(out, NUMBER_BYTES, "%0*d", ++digits, clip);
	} while (digits < NUMBER_BYTES - 1 &&
		model_find_clip(model, out) != clip);
}

void sketch_write_clip(FILE *out, const struct model *model, int clip)
{
	char number[NUMBER_BYTES];

	if (has_usable_name(model, clip)) {
		sketch_write_name(out, model->clip[clip].name);
	} else {
		find_number(model, clip, number);
		fputs(number, out);
	}
}

void sketch_write_heading(FILE *out, const struct model *model, int clip)
{
	const char *name = model->clip[clip].name;
	char number[NUMBER_BYTES];

	snprintf(number, sizeof(number), "clip %d", clip);
	if (has_usable_name(model, clip) && sketch_fits_heading(name)) {
		sketch_write_name(out, name);
	} else if (model_find_clip(model, number) >= 0) {
		find_number(model, clip, number);
		fputs(number, out);
	} else {
		sketch_write_name(out, number);
	}
}

/* Returns whether no target before the given one has this name. */
static bool is_first_target(
	const struct model_mesh *mesh, int target, const char *name)
{
	int i = 0;

	while (i < target && strcmp(mesh->target_name[i], name) != 0) {
		i++;
	}
	return i == target;
}

void sketch_write_target(FILE *out, const struct model_mesh *mesh, int target)
{
	const char *name = mesh->target_name[target];
	char number[NUMBER_BYTES];
	int digits = 0;

	if (sketch_is_usable(name) && is_first_target(mesh, target, name)) {
		sketch_write_name(out, name);
		return;
	}
	do {
		snprintf(number, sizeof(number), "%0*d", ++digits, target);
	} while (digits < NUMBER_BYTES - 1 &&
		!is_first_target(mesh, mesh->target_count, number));
	fputs(number, out);
}
