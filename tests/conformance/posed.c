#include "tests/conformance/posed.h"

#include <errno.h>
#include <jansson.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define fail_with(error, ...) \
	(snprintf((error)->text, sizeof((error)->text), __VA_ARGS__), -1)

void posed_release(struct posed *posed)
{
	for (size_t i = 0; i < posed->count; i++) {
		free(posed->part[i].position);
	}
	free(posed->part);
	*posed = (struct posed){0};
}

static struct posed_part *add_part(struct posed *posed)
{
	struct posed_part *grown =
		realloc(posed->part, (posed->count + 1) * sizeof(*posed->part));

	if (!grown) {
		abort();
	}
	posed->part = grown;
	grown[posed->count] = (struct posed_part){0};
	return &grown[posed->count++];
}

static void add_position(struct posed_part *part, const double position[3])
{
	/* The capacity doubles when the count is a power of two. */
	if ((part->count & (part->count - 1)) == 0) {
		size_t capacity = part->count ? 2 * part->count : 1;
		double(*grown)[3] =
			realloc(part->position, capacity * sizeof(*grown));

		if (!grown) {
			abort();
		}
		part->position = grown;
	}
	memcpy(part->position[part->count++], position, 3 * sizeof(double));
}

static int read_reference_mesh(
	const json_t *mesh, struct posed *out, struct posed_error *error)
{
	const json_t *node = json_object_get(mesh, "node");
	const json_t *primitive = json_object_get(mesh, "primitive");
	const json_t *positions = json_object_get(mesh, "positions");
	struct posed_part *part = add_part(out);
	const json_t *row;
	size_t i;

	if (!json_is_integer(node) || !json_is_integer(primitive) ||
		!json_is_array(positions)) {
		return fail_with(
			error, "a mesh lacks node, primitive or positions");
	}
	snprintf(part->name, sizeof(part->name), "node%d_prim%d",
		(int)json_integer_value(node),
		(int)json_integer_value(primitive));
	json_array_foreach(positions, i, row)
	{
		double position[3];

		for (size_t k = 0; k < 3; k++) {
			const json_t *number = json_array_get(row, k);

			if (!json_is_number(number)) {
				return fail_with(error,
					"%s: position %zu does not have three numbers",
					part->name, i);
			}
			position[k] = json_number_value(number);
		}
		add_position(part, position);
	}
	return 0;
}

int posed_read_reference(
	const char *path, struct posed *out, struct posed_error *error)
{
	json_error_t cause;
	json_t *root = json_load_file(path, 0, &cause);
	const json_t *mesh;
	size_t i;
	int failed = 0;

	*out = (struct posed){0};
	if (!root) {
		return fail_with(error, "%s: %s", path, cause.text);
	}
	json_array_foreach(json_object_get(root, "meshes"), i, mesh)
	{
		if (!failed) {
			failed = read_reference_mesh(mesh, out, error);
		}
	}
	json_decref(root);
	if (!failed && !out->count) {
		failed = fail_with(error, "%s: the file has no meshes", path);
	}
	if (failed) {
		posed_release(out);
	}
	return failed;
}

/* Reads three numbers; anything else is an error. */
static int read_vertex(const char *text, double position[3])
{
	char *end;

	for (int k = 0; k < 3; k++) {
		position[k] = strtod(text, &end);
		if (end == text || !isfinite(position[k])) {
			return -1;
		}
		text = end;
	}
	return text[strspn(text, " \r\n")] ? -1 : 0;
}

/* Reads three vertex numbers, each from first to last. */
static int read_face(const char *text, size_t first, size_t last)
{
	for (int k = 0; k < 3; k++) {
		char *end;
		long index = strtol(text, &end, 10);

		if (end == text || index < (long)first || index > (long)last) {
			return -1;
		}
		text = end + strcspn(end, " \r\n"); /* skips /texture/normal */
	}
	return text[strspn(text, " \r\n")] ? -1 : 0;
}

static const struct posed_part *find_part(
	const struct posed *posed, const char *name)
{
	for (size_t i = 0; i < posed->count; i++) {
		if (!strcmp(posed->part[i].name, name)) {
			return &posed->part[i];
		}
	}
	return NULL;
}

struct obj_reader {
	struct posed *out;
	struct posed_part *part; /* the current object */
	size_t vertices;         /* in the objects before it */
	size_t faces;            /* of the current object */
};

static int end_object(struct obj_reader *reader, struct posed_error *error)
{
	if (reader->part && !reader->faces) {
		return fail_with(error, "%s has no faces", reader->part->name);
	}
	return 0;
}

static int begin_object(
	struct obj_reader *reader, const char *name, struct posed_error *error)
{
	size_t length = strcspn(name, "\r\n");
	char text[sizeof(reader->part->name)] = {0};

	if (end_object(reader, error)) {
		return -1;
	}
	if (length >= sizeof(text)) {
		return fail_with(error, "the name of the object is too long");
	}
	memcpy(text, name, length);
	if (find_part(reader->out, text)) {
		return fail_with(
			error, "the file has the object %s twice", text);
	}
	if (reader->part) {
		reader->vertices += reader->part->count;
	}
	reader->part = add_part(reader->out);
	reader->faces = 0;
	memcpy(reader->part->name, text, sizeof(text));
	return 0;
}

static int read_obj_line(
	struct obj_reader *reader, const char *line, struct posed_error *error)
{
	double position[3];

	if (line[0] == '#' || line[strspn(line, " \r\n")] == '\0') {
		return 0;
	}
	if (!strncmp(line, "o ", 2)) {
		return begin_object(reader, line + 2, error);
	}
	if (!reader->part) {
		return fail_with(
			error, "the line comes before the first object");
	}
	if (!strncmp(line, "v ", 2)) {
		if (read_vertex(line + 2, position)) {
			return fail_with(error,
				"the vertex does not have three finite numbers");
		}
		add_position(reader->part, position);
		return 0;
	}
	if (!strncmp(line, "f ", 2)) {
		if (read_face(line + 2, reader->vertices + 1,
			    reader->vertices + reader->part->count)) {
			return fail_with(error,
				"the face is not a triangle of vertices of %s",
				reader->part->name);
		}
		reader->faces++;
		return 0;
	}
	return fail_with(error, "the line begins with neither o, v nor f");
}

int posed_read_obj(
	const char *path, struct posed *out, struct posed_error *error)
{
	struct obj_reader reader = {.out = out};
	FILE *file = fopen(path, "r");
	char line[512];
	int number = 0;
	int failed = 0;

	*out = (struct posed){0};
	if (!file) {
		return fail_with(error, "%s: %s", path, strerror(errno));
	}
	while (!failed && fgets(line, sizeof(line), file)) {
		struct posed_error cause = {""};

		number++;
		if (read_obj_line(&reader, line, &cause)) {
			failed = fail_with(error, "%s, line %d: %.180s", path,
				number, cause.text);
		}
	}
	fclose(file);
	failed = failed ? failed : end_object(&reader, error);
	if (failed) {
		posed_release(out);
	}
	return failed;
}

double posed_extent(const struct posed *posed)
{
	double extent = 0;

	for (int k = 0; k < 3; k++) {
		double low = INFINITY;
		double high = -INFINITY;

		for (size_t i = 0; i < posed->count; i++) {
			const struct posed_part *part = &posed->part[i];

			for (size_t j = 0; j < part->count; j++) {
				low = fmin(low, part->position[j][k]);
				high = fmax(high, part->position[j][k]);
			}
		}
		extent = fmax(extent, high - low);
	}
	return extent;
}

static int compare_part(const struct posed_part *actual,
	const struct posed_part *reference, double distance, double *worst,
	struct posed_error *error)
{
	size_t wrong = 0;
	size_t first = 0;

	if (actual->count != reference->count) {
		return fail_with(error, "%s has %zu vertices instead of %zu",
			reference->name, actual->count, reference->count);
	}
	for (size_t i = 0; i < reference->count; i++) {
		double difference = 0;

		for (int k = 0; k < 3; k++) {
			difference = fmax(difference,
				fabs(actual->position[i][k] -
					reference->position[i][k]));
		}
		*worst = fmax(*worst, difference);
		if (!(difference <= distance)) {
			first = wrong++ ? first : i;
		}
	}
	if (wrong) {
		const double *a = actual->position[first];
		const double *r = reference->position[first];

		return fail_with(error,
			"%s: %zu of %zu vertices differ by more than %.3g; the first is %zu: (%g %g %g) instead of (%g %g %g)",
			reference->name, wrong, reference->count, distance,
			first, a[0], a[1], a[2], r[0], r[1], r[2]);
	}
	return 0;
}

int posed_compare(const struct posed *actual, const struct posed *reference,
	double distance, double *worst, struct posed_error *error)
{
	*worst = 0;
	for (size_t i = 0; i < reference->count; i++) {
		const struct posed_part *expected = &reference->part[i];
		const struct posed_part *part =
			find_part(actual, expected->name);

		if (!part) {
			return fail_with(error, "the object %s is missing",
				expected->name);
		}
		if (compare_part(part, expected, distance, worst, error)) {
			return -1;
		}
	}
	for (size_t i = 0; i < actual->count; i++) {
		if (!find_part(reference, actual->part[i].name)) {
			return fail_with(error, "the reference has no object %s",
				actual->part[i].name);
		}
	}
	return 0;
}
