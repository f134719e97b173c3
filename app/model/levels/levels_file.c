#include "app/model/levels/levels_file.h"

#include "app/model/levels/levels.h"
#include "app/model/little_endian.h"
#include "app/model/model_deltas.h"
#include "app/model/model_file.h"
#include "app/model/split/split.h"
#include "platform/base/file.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <string.h>

enum {
	/* "LLV" and the version of the format and of levels_make()'s lists. */
	FORMAT = 0x04564c4c,
	SHORT_MAX = 65536,
};

/* Kinds of lists. */
enum {
	SHADED,
	SHADOW,  /* model_lod.shadow_only */
	CORNERS, /* its numbers are those of model_lod.corner */
};

/* FNV-1a over words of 32 bits instead of bytes; zeros fill the last word. */
static uint32_t hash_bytes(uint32_t hash, const void *bytes, size_t size)
{
	const uint8_t *byte = bytes;
	size_t whole = size / 4 * 4;
	uint32_t word = 0;

	for (size_t at = 0; at < whole; at += 4) {
		memcpy(&word, byte + at, sizeof(word));
		hash = (hash ^ word) * 16777619u;
	}
	if (size > whole) {
		word = 0;
		memcpy(&word, byte + whole, size - whole);
		hash = (hash ^ word) * 16777619u;
	}
	return hash;
}

/* Hashes an array of the primitive, and whether there is one. */
static uint32_t hash_array(
	uint32_t hash, const void *array, size_t count, size_t each)
{
	uint32_t size = array ? (uint32_t)(count * each) : 0;

	hash = hash_bytes(hash, &size, sizeof(size));
	return array ? hash_bytes(hash, array, count * each) : hash;
}

static uint32_t hash_deltas(uint32_t hash, const struct model_deltas *deltas)
{
	size_t spans = (size_t)deltas->span_count;
	size_t span_bytes = spans * sizeof(*deltas->span);

	hash = hash_bytes(hash, &deltas->unit, sizeof(deltas->unit));
	hash = hash_array(hash, deltas->span, spans, sizeof(*deltas->span));
	return hash_array(hash, deltas->value, 1,
		model_deltas_bytes(deltas) - span_bytes);
}

/* The lists of the model's file; those that are made depend on them. */
static uint32_t hash_lists(
	uint32_t hash, const struct model_primitive *primitive)
{
	for (int i = 0; i < primitive->lod_count; i++) {
		const struct model_lod *lod = &primitive->lod[i];

		hash = hash_bytes(hash, &lod->error_m, sizeof(lod->error_m));
		hash = hash_array(hash, lod->index, (size_t)lod->index_count,
			sizeof(*lod->index));
	}
	return hash;
}

/* Hashes all that simplify.c reads. */
static uint32_t hash_primitive(uint32_t hash,
	const struct model_primitive *primitive, int target_count)
{
	size_t vertices = (size_t)primitive->vertex_count;
	size_t influences = vertices * (size_t)primitive->influences;

	hash = hash_array(hash, primitive->position, vertices,
		sizeof(*primitive->position));
	hash = hash_array(
		hash, primitive->normal, vertices, sizeof(*primitive->normal));
	hash = hash_array(hash, primitive->texcoord, vertices,
		sizeof(*primitive->texcoord));
	hash = hash_array(
		hash, primitive->color, vertices, sizeof(*primitive->color));
	hash = hash_array(
		hash, primitive->joint, influences, sizeof(*primitive->joint));
	hash = hash_array(hash, primitive->weight, influences,
		sizeof(*primitive->weight));
	for (int t = 0; t < target_count; t++) {
		hash = hash_deltas(hash, &primitive->target[t].position);
		hash = hash_deltas(hash, &primitive->target[t].normal);
	}
	hash = hash_array(hash, primitive->index,
		(size_t)primitive->index_count, sizeof(*primitive->index));
	return hash_lists(hash, primitive);
}

/* To be called before levels are made or read. */
static uint32_t hash_model(const struct model *model)
{
	uint32_t hash = 2166136261u;

	for (int m = 0; m < model->mesh_count; m++) {
		const struct model_mesh *mesh = &model->mesh[m];

		for (int p = 0; p < mesh->primitive_count; p++) {
			hash = hash_primitive(
				hash, &mesh->primitive[p], mesh->target_count);
		}
	}
	return hash;
}

static uint32_t count_primitives(const struct model *model)
{
	uint32_t count = 0;

	for (int m = 0; m < model->mesh_count; m++) {
		count += (uint32_t)model->mesh[m].primitive_count;
	}
	return count;
}

/* What a list's numbers are below: corners of the index, or vertices. */
static uint32_t number_limit(
	const struct model_primitive *primitive, bool corners)
{
	return (uint32_t)(corners ? primitive->index_count
				  : primitive->vertex_count);
}

/* Returns how many bytes a list's numbers take in the file. */
static size_t list_bytes(uint32_t limit, uint32_t index_count)
{
	size_t count = index_count;

	return limit <= SHORT_MAX ? (count + 1) / 2 * 4 : count * 4;
}

static void write_number(FILE *out, uint32_t value, int bytes)
{
	for (int i = 0; i < bytes; i++) {
		putc((int)(value >> 8 * i & 0xff), out);
	}
}

static void write_list(FILE *out, const struct model_primitive *primitive,
	const struct model_lod *lod)
{
	const uint32_t *list = lod->corner ? lod->corner : lod->index;
	int width = number_limit(primitive, lod->corner) <= SHORT_MAX ? 2 : 4;
	uint32_t error_bits;

	memcpy(&error_bits, &lod->error_m, sizeof(error_bits));
	write_number(out, error_bits, 4);
	write_number(out,
		lod->shadow_only      ? SHADOW
			: lod->corner ? CORNERS
				      : SHADED,
		4);
	write_number(out, (uint32_t)lod->index_count, 4);
	for (int i = 0; i < lod->index_count; i++) {
		write_number(out, list[i], width);
	}
	if (width == 2 && lod->index_count % 2) {
		write_number(out, 0, 2);
	}
}

int levels_write(struct model *model, FILE *out)
{
	uint32_t hash = hash_model(model);
	int error = levels_make_all(model);

	if (error) {
		return error;
	}
	write_number(out, FORMAT, 4);
	write_number(out, hash, 4);
	write_number(out, count_primitives(model), 4);
	for (int m = 0; m < model->mesh_count; m++) {
		for (int p = 0; p < model->mesh[m].primitive_count; p++) {
			const struct model_primitive *primitive =
				&model->mesh[m].primitive[p];

			write_number(out, (uint32_t)primitive->lod_count, 4);
			for (int i = 0; i < primitive->lod_count; i++) {
				write_list(out, primitive, &primitive->lod[i]);
			}
		}
	}
	return 0;
}

/* What is left to read. */
struct reader {
	const uint8_t *data;
	size_t size;
	bool failed;    /* the file has ended too early */
	bool no_memory; /* memory is short, or the budget refuses it */
};

static uint32_t read_number(struct reader *reader)
{
	uint32_t value;

	if (reader->size < 4) {
		reader->failed = true;
		return 0;
	}
	value = little_endian_u32(reader->data);
	reader->data += 4;
	reader->size -= 4;
	return value;
}

static bool read_numbers(
	const uint8_t *data, uint32_t limit, uint32_t *out, uint32_t count)
{
	for (uint32_t i = 0; i < count; i++) {
		out[i] = limit <= SHORT_MAX
			? little_endian_u16(data + 2 * (size_t)i)
			: little_endian_u32(data + 4 * (size_t)i);
		if (out[i] >= limit) {
			return false;
		}
	}
	return true;
}

/* Reads the numbers of a list, of which index_count is set. */
static bool read_index(struct reader *reader,
	const struct model_primitive *primitive, bool corners,
	struct arena *arena, struct model_lod *lod)
{
	size_t count = (size_t)lod->index_count;
	uint32_t limit = number_limit(primitive, corners);

	lod->index = ARENA_ARRAY(arena, uint32_t, count);
	lod->corner = corners ? ARENA_ARRAY(arena, uint32_t, count) : NULL;
	reader->no_memory = !lod->index || (corners && !lod->corner);
	if (reader->no_memory ||
		!read_numbers(reader->data, limit,
			corners ? lod->corner : lod->index, (uint32_t)count)) {
		return false;
	}
	for (size_t i = 0; corners && i < count; i++) {
		lod->index[i] = primitive->index[lod->corner[i]];
	}
	return true;
}

static bool read_list(struct reader *reader,
	const struct model_primitive *primitive, struct arena *arena,
	struct model_lod *lod)
{
	uint32_t error_bits = read_number(reader);
	uint32_t kind = read_number(reader);
	uint32_t count = read_number(reader);
	size_t bytes =
		list_bytes(number_limit(primitive, kind == CORNERS), count);

	*lod = (struct model_lod){0};
	memcpy(&lod->error_m, &error_bits, sizeof(error_bits));
	if (reader->failed || !isfinite(lod->error_m) || lod->error_m < 0.0f ||
		kind > CORNERS || (kind == CORNERS && primitive->normal) ||
		count == 0 || count % 3 ||
		count > (uint32_t)primitive->index_count ||
		bytes > reader->size) {
		return false;
	}
	lod->shadow_only = kind == SHADOW;
	lod->index_count = (int)count;
	if (!read_index(reader, primitive, kind == CORNERS, arena, lod)) {
		return false;
	}
	reader->data += bytes;
	reader->size -= bytes;
	return true;
}

static bool are_shadows_last(const struct model_lod *lod, int count)
{
	for (int i = 1; i < count; i++) {
		if (lod[i - 1].shadow_only && !lod[i].shadow_only) {
			return false;
		}
	}
	return true;
}

static bool read_lists(struct reader *reader,
	const struct model_primitive *primitive, struct arena *arena,
	struct model_primitive *out)
{
	uint32_t count = read_number(reader);

	*out = (struct model_primitive){0};
	/* A list has at least its three numbers. */
	if (reader->failed || count > reader->size / 12) {
		return false;
	}
	out->lod = count ? ARENA_ARRAY(arena, struct model_lod, count) : NULL;
	reader->no_memory = count && !out->lod;
	for (uint32_t i = 0; i < count; i++) {
		if (!out->lod ||
			!read_list(reader, primitive, arena, &out->lod[i])) {
			return false;
		}
	}
	out->lod_count = (int)count;
	return are_shadows_last(out->lod, out->lod_count);
}

static bool read_all(struct model *model, struct reader *reader,
	struct model_primitive *read)
{
	for (int m = 0; m < model->mesh_count; m++) {
		for (int p = 0; p < model->mesh[m].primitive_count; p++) {
			if (!read_lists(reader, &model->mesh[m].primitive[p],
				    &model->arena, read++)) {
				return false;
			}
		}
	}
	return reader->size == 0;
}

static void take_all(struct model *model, const struct model_primitive *read)
{
	for (int m = 0; m < model->mesh_count; m++) {
		for (int p = 0; p < model->mesh[m].primitive_count; p++) {
			struct model_primitive *primitive =
				&model->mesh[m].primitive[p];

			primitive->lod = read->lod;
			primitive->lod_count = read++->lod_count;
		}
	}
}

int levels_read(struct model *model, const uint8_t *data, size_t size)
{
	struct reader reader = {.data = data, .size = size};
	struct arena scratch = arena_within(model->budget);
	uint32_t format = read_number(&reader);
	uint32_t hash = read_number(&reader);
	uint32_t count = read_number(&reader);
	struct model_primitive *read = NULL;
	int error = -EINVAL;

	if (!reader.failed && format == FORMAT &&
		count == count_primitives(model) && hash == hash_model(model)) {
		read = ARENA_ARRAY(&scratch, struct model_primitive, count);
		reader.no_memory = !read;
	}
	if (read && read_all(model, &reader, read)) {
		take_all(model, read);
		error = 0;
	}
	arena_release(&scratch);
	return reader.no_memory ? -ENOMEM : error;
}

/* Writes "robot.levels" for "robot.glb". Returns false if that does not fit. */
static bool path_beside(const char *model_path, char *path, size_t size)
{
	const char *slash = strrchr(model_path, '/');
	const char *dot = strrchr(slash ? slash : model_path, '.');
	size_t stem = dot ? (size_t)(dot - model_path) : strlen(model_path);
	int length = snprintf(path, size, "%.*s.levels", (int)stem, model_path);

	return length > 0 && (size_t)length < size;
}

/* Levels are optional, so an error of their file is a warning. */
static void write_warning(void *user, enum log_level level, const char *sentence)
{
	log_write(
		user, level == LOG_ERROR ? LOG_WARNING : level, "%s", sentence);
}

static int read_file(
	struct model *model, const char *path, const struct log *log)
{
	const struct log lenient = {
		.write = write_warning,
		.user = (void *)log,
		.threshold = log->threshold,
	};
	struct model_file file;
	int error = model_file_read(path, model->budget, &lenient, &file);

	if (error) {
		return error;
	}
	error = levels_read(model, file.data, file.size);
	model_file_release(&file);
	if (error == -ENOMEM) {
		(void)memory_budget_fail(model->budget, path, &lenient);
	} else if (error) {
		log_warning(log,
			"%s: these are not the levels of %s: limber makes them anew, and limber levels writes them",
			path, model->path);
	}
	return error;
}

/*
 * Returns 0, or -errno if the levels must be made. A warning about the file has
 * been logged then. Too small a budget for them is no failure of the model.
 */
static int read_beside(
	struct model *model, const char *path, const struct log *log)
{
	struct memory_budget *budget = model->budget;
	bool exceeded = budget && budget->exceeded;
	int error;

	if (budget) {
		budget->exceeded = false;
	}
	error = read_file(model, path, log);
	if (budget) {
		budget->exceeded = exceeded;
	}
	return error;
}

int levels_prepare(struct model *model, const struct log *log)
{
	char path[PATH_MAX];

	if (!path_beside(model->path, path, sizeof(path)) ||
		!file_exists(path) || read_beside(model, path, log) != 0) {
		if (levels_make(model) != 0) {
			return memory_budget_fail(
				model->budget, model->path, log);
		}
	}
	split_drop_unused(model);
	return 0;
}
