/*
 * Warnings about a file. What is wrong in one place is often wrong in a
 * hundred: such warnings become one that lists some of the places, so that a
 * warning of another kind is seen between them.
 */
#include "app/model/gltf/gltf_internal.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	SENTENCE_BYTES = 1024,
	PLACE_BYTES = 160,
	PLACES_MAX = 3, /* that are listed after the first one */
};

struct gltf_warning {
	struct gltf_warning *next;
	const char *kind; /* the format of the sentence */
	int places;
	char sentence[SENTENCE_BYTES];
	char place[PLACES_MAX][PLACE_BYTES]; /* all but the first one */
};

static size_t print_path(const struct gltf_at *at, char *text, size_t size)
{
	size_t used;
	int printed;

	if (!at->up) {
		return 0;
	}
	used = print_path(at->up, text, size);
	if (at->key) {
		printed = snprintf(text + used, size - used, "/%s", at->key);
	} else {
		printed = snprintf(text + used, size - used, "/%d", at->index);
	}
	if (printed < 0) {
		return used;
	}
	used += (size_t)printed;
	return used < size ? used : size - 1;
}

void gltf_path(const struct gltf_at *at, char *text, size_t size)
{
	const char *name = at->gltf->source->name;
	int printed;

	if (!at->up) {
		snprintf(text, size, "%s", name);
		return;
	}
	printed = snprintf(text, size, "%s: ", name);
	if (printed >= 0 && (size_t)printed < size) {
		print_path(at, text + printed, size - (size_t)printed);
	}
}

static struct gltf_warning **find(struct gltf *gltf, const char *kind)
{
	struct gltf_warning **at = &gltf->warning;

	while (*at && strcmp((*at)->kind, kind) != 0) {
		at = &(*at)->next;
	}
	return at;
}

static void write_sentence(const struct gltf_at *at, const char *format,
	va_list arguments, char out[SENTENCE_BYTES])
{
	size_t used;

	gltf_path(at, out, SENTENCE_BYTES / 2);
	used = strlen(out);
	used += (size_t)snprintf(out + used, SENTENCE_BYTES - used, ": ");
	vsnprintf(out + used, SENTENCE_BYTES - used, format, arguments);
}

/* The path in the file, without the file's name. */
static void add_place(struct gltf_warning *warning, const struct gltf_at *at)
{
	const size_t name = strlen(at->gltf->source->name) + sizeof(": ") - 1;
	char path[SENTENCE_BYTES];
	int i = warning->places++ - 1;

	if (i < PLACES_MAX) {
		gltf_path(at, path, sizeof(path));
		snprintf(warning->place[i], PLACE_BYTES, "%.*s", PLACE_BYTES - 1,
			strlen(path) > name ? path + name : path);
	}
}

void gltf_warn(const struct gltf_at *at, const char *format, ...)
{
	struct gltf *gltf = at->gltf;
	struct gltf_warning **warning = find(gltf, format);
	char sentence[SENTENCE_BYTES];
	va_list arguments;

	if (*warning) {
		add_place(*warning, at);
		return;
	}
	va_start(arguments, format);
	write_sentence(at, format, arguments, sentence);
	va_end(arguments);
	*warning = calloc(1, sizeof(**warning));
	if (!*warning) {
		log_write(gltf->log, LOG_WARNING, "%s", sentence);
		return;
	}
	(*warning)->kind = format;
	(*warning)->places = 1;
	memcpy((*warning)->sentence, sentence, sizeof(sentence));
}

void gltf_warn_alone(const struct gltf_at *at, const char *format, ...)
{
	char sentence[SENTENCE_BYTES];
	va_list arguments;

	va_start(arguments, format);
	write_sentence(at, format, arguments, sentence);
	va_end(arguments);
	log_write(at->gltf->log, LOG_WARNING, "%s", sentence);
}

static void write_warning(
	const struct gltf_warning *warning, const struct log *log)
{
	int more = warning->places - 1;
	int listed = more < PLACES_MAX ? more : PLACES_MAX;
	char places[PLACES_MAX * (PLACE_BYTES + 2) + 32] = "";
	size_t used = 0;

	for (int i = 0; i < listed; i++) {
		used += (size_t)snprintf(places + used, sizeof(places) - used,
			"%s%s", i > 0 ? ", " : "", warning->place[i]);
	}
	if (more > listed) {
		snprintf(places + used, sizeof(places) - used, " and %d more",
			more - listed);
	}
	log_write(log, LOG_WARNING, more > 0 ? "%s (similar: %s)" : "%s%s",
		warning->sentence, places);
}

void gltf_write_warnings(struct gltf *gltf)
{
	while (gltf->warning) {
		struct gltf_warning *warning = gltf->warning;

		gltf->warning = warning->next;
		write_warning(warning, gltf->log);
		free(warning);
	}
}

int gltf_fail(const struct gltf_at *at, int code, const char *format, ...)
{
	char path[SENTENCE_BYTES / 2];
	char reason[SENTENCE_BYTES / 2];
	va_list arguments;

	gltf_write_warnings(at->gltf);
	va_start(arguments, format);
	gltf_path(at, path, sizeof(path));
	vsnprintf(reason, sizeof(reason), format, arguments);
	va_end(arguments);
	log_error(at->gltf->log, "%s: %s", path, reason);
	return code;
}
