#include "app/model/xfile/xfile.h"

#include "app/model/split/split.h"
#include "app/model/xfile/xfile_build.h"
#include "app/model/xfile/xfile_inflate.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The header has four bytes each: "xof ", version, format, bits of a float. */
static const char magic[] = "xof ";

struct header {
	char version[5];
	bool binary;
	bool packed;
	int float_bytes;
};

bool xfile_recognise(const uint8_t *data, size_t size)
{
	return size >= 4 && !memcmp(data, magic, 4);
}

static bool read_format(const uint8_t *format, struct header *out)
{
	static const struct {
		char name[5];
		bool binary;
		bool packed;
	} formats[] = {
		{"txt ", false, false},
		{"bin ", true, false},
		{"tzip", false, true},
		{"bzip", true, true},
	};

	for (size_t i = 0; i < ARRAY_COUNT(formats); i++) {
		if (!memcmp(format, formats[i].name, 4)) {
			out->binary = formats[i].binary;
			out->packed = formats[i].packed;
			return true;
		}
	}
	return false;
}

/*
 * Copies four bytes to buffer and returns it; bytes that cannot be printed
 * become "?".
 */
static const char *printable(const uint8_t *text, char buffer[5])
{
	for (int i = 0; i < 4; i++) {
		buffer[i] =
			text[i] >= ' ' && text[i] <= '~' ? (char)text[i] : '?';
	}
	buffer[4] = '\0';
	return buffer;
}

static int fail_header(const struct model_source *source, const struct log *log,
	int error, const char *what, const uint8_t *found)
{
	char buffer[5];

	log_error(log, "%s: byte %d: the %s in the header is \"%s\"",
		source->name, (int)(found - source->data), what,
		printable(found, buffer));
	return error;
}

static int read_header(const struct model_source *source, const struct log *log,
	struct header *out)
{
	const uint8_t *data = source->data;

	if (source->size < XFILE_HEADER_BYTES) {
		log_error(log, "%s: byte %zu: the file ends within its header",
			source->name, source->size);
		return -EINVAL;
	}
	printable(data + 4, out->version);
	if (memcmp(data + 4, "0303", 4) != 0 &&
		memcmp(data + 4, "0302", 4) != 0) {
		return fail_header(source, log, -ENOTSUP,
			"version, which must be 0302 or 0303,", data + 4);
	}
	if (!read_format(data + 8, out)) {
		return fail_header(source, log, -EINVAL,
			"format, which must be txt, bin, tzip or bzip,",
			data + 8);
	}
	if (memcmp(data + 12, "0032", 4) != 0 &&
		memcmp(data + 12, "0064", 4) != 0) {
		return fail_header(source, log, -EINVAL,
			"float size, which must be 0032 or 0064,", data + 12);
	}
	out->float_bytes = data[14] == '3' ? 4 : 8;
	return 0;
}

static struct model *make_model(const struct model_source *source,
	const struct header *header, const struct log *log)
{
	char format[64];

	snprintf(format, sizeof(format), "DirectX .x %.2s.%.2s (%s%s)",
		header->version, header->version + 2,
		header->binary ? "binary" : "text",
		header->packed ? ", compressed" : "");
	return model_create(source, format, log);
}

static int load_body(const struct model_source *source,
	const struct header *header, const struct xfile_context *context,
	const uint8_t *body, size_t size, struct model *model)
{
	struct arena scratch = arena_within(model->budget);
	struct xfile_scene scene = {0};
	struct xfile_build build = {
		.source = source,
		.context = context,
		.log = context->log,
		.scratch = &scratch,
		.scene = &scene,
		.model = model,
	};
	struct xfile_reader reader = {
		.context = *context,
		.scratch = &scratch,
		.scan = header->binary ? xfile_scan_binary : xfile_scan_text,
		.float_bytes = header->float_bytes,
	};
	int error = xfile_reader_begin(&reader, body, size);

	if (!error) {
		error = xfile_parse(&reader, &scene);
	}
	if (!error) {
		error = xfile_build(&build);
	}
	if (!error && split_primitives(model, &scratch) != 0) {
		error = xfile_no_memory(context);
	}
	arena_release(&scratch);
	return error;
}

/* Reads the body, which may be compressed. */
static int load_rest(const struct model_source *source,
	const struct header *header, const struct log *log, struct model *model)
{
	const struct xfile_context context = {
		.path = source->name,
		.log = log,
		.budget = model->budget,
		.binary = header->binary,
		.unpacked = header->packed,
	};
	const uint8_t *body = source->data + XFILE_HEADER_BYTES;
	size_t size = source->size - XFILE_HEADER_BYTES;
	struct xfile_unpacked unpacked;
	int error;

	if (!header->packed) {
		return load_body(source, header, &context, body, size, model);
	}
	error = xfile_inflate(&context, body, size, &unpacked);
	if (!error) {
		error = load_body(source, header, &context, unpacked.data,
			unpacked.size, model);
		xfile_unpacked_release(&unpacked, &context);
	}
	return error;
}

int xfile_load(const struct model_source *source, const struct log *log,
	struct model **out)
{
	struct header header;
	struct model *model;
	int error = read_header(source, log, &header);

	*out = NULL;
	if (error) {
		return error;
	}
	model = make_model(source, &header, log);
	if (!model) {
		return -ENOMEM;
	}
	error = load_rest(source, &header, log, model);
	if (error) {
		model_destroy(model);
		return error;
	}
	*out = model;
	return 0;
}

int xfile_examine(const struct model_source *source,
	const struct examiner *examiner, const struct log *log)
{
	struct model *model;
	int error = xfile_load(source, log, &model);

	if (error) {
		return error;
	}
	examine_report(examiner,
		"DirectX .x is left-handed with row vectors; limber negates z, transposes matrices and reverses the triangles");
	model_prepare_clips(model);
	error = examine_clips(model, examiner, log);
	error = error ? error : examine_skins(model, examiner, log);
	error = error ? error : examine_still_clips(model, examiner, log);
	error = error ? error : examine_spare(model, examiner, log);
	model_destroy(model);
	return error;
}
