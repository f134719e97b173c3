#include "app/model/xfile/xfile_inflate.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#define ZLIB_CONST
#include <zlib.h>

enum {
	BLOCK_BYTES = 32 * 1024, /* the most that a block has decompressed */
	HISTORY_BYTES = 32 * 1024,
	BLOCK_HEADER_BYTES = 6,
};

struct inflater {
	const struct xfile_context *context;
	const uint8_t *begin; /* the compressed data, behind the header */
	const uint8_t *at;
	const uint8_t *end;
	z_stream stream;
	uint8_t *out;
	size_t used;
	size_t capacity;
	size_t expected; /* bytes of the decompressed body */
};

/* Logs an error with the offset in the compressed file; returns -EINVAL. */
static int fail_packed(const struct inflater *inflater, const char *reason)
{
	log_error(inflater->context->log, "%s: byte %zu: %s",
		inflater->context->path,
		XFILE_HEADER_BYTES + (size_t)(inflater->at - inflater->begin),
		reason);
	return -EINVAL;
}

static int reserve(struct inflater *inflater, size_t more)
{
	size_t capacity = inflater->capacity ? inflater->capacity : BLOCK_BYTES;
	uint8_t *out;

	while (capacity - inflater->used < more) {
		capacity *= 2;
	}
	if (capacity == inflater->capacity) {
		return 0;
	}
	if (!memory_budget_take(
		    inflater->context->budget, capacity - inflater->capacity)) {
		return xfile_no_memory(inflater->context);
	}
	out = realloc(inflater->out, capacity);
	if (!out) {
		memory_budget_give_back(inflater->context->budget,
			capacity - inflater->capacity);
		return xfile_no_memory(inflater->context);
	}
	inflater->out = out;
	inflater->capacity = capacity;
	return 0;
}

static bool inflate_block(
	struct inflater *inflater, size_t packed_bytes, size_t bytes)
{
	z_stream *stream = &inflater->stream;
	size_t history =
		inflater->used < HISTORY_BYTES ? inflater->used : HISTORY_BYTES;

	if (inflateReset(stream) != Z_OK) {
		return false;
	}
	if (history &&
		inflateSetDictionary(stream,
			inflater->out + inflater->used - history,
			(uInt)history) != Z_OK) {
		return false;
	}
	stream->next_in = inflater->at;
	stream->avail_in = (uInt)packed_bytes;
	stream->next_out = inflater->out + inflater->used;
	stream->avail_out = (uInt)bytes;
	return inflate(stream, Z_FINISH) == Z_STREAM_END && !stream->avail_out;
}

/* Decompresses one block; inflater->at is behind the block's header. */
static int unpack_block(
	struct inflater *inflater, size_t packed_bytes, size_t bytes)
{
	int error;

	if (bytes > BLOCK_BYTES) {
		return fail_packed(inflater,
			"a compressed block has more than 32768 bytes");
	}
	if (bytes > inflater->expected - inflater->used) {
		return fail_packed(inflater,
			"the compressed data is longer than the header claims");
	}
	error = reserve(inflater, bytes);
	if (error) {
		return error;
	}
	if (!inflate_block(inflater, packed_bytes, bytes)) {
		return fail_packed(inflater, "the compressed block is damaged");
	}
	inflater->used += bytes;
	inflater->at += packed_bytes;
	return 0;
}

static int unpack_next(struct inflater *inflater)
{
	const uint8_t *at = inflater->at;
	size_t bytes, packed_bytes;

	if (inflater->end - at < BLOCK_HEADER_BYTES) {
		return fail_packed(inflater, "the compressed data is truncated");
	}
	bytes = (size_t)at[0] | (size_t)at[1] << 8;
	packed_bytes = (size_t)at[2] | (size_t)at[3] << 8;
	if (at[4] != 'C' || at[5] != 'K') {
		return fail_packed(
			inflater, "a compressed block does not begin with CK");
	}
	/* The compressed size includes the letters CK. */
	if (packed_bytes < 2 ||
		packed_bytes - 2 >
			(size_t)(inflater->end - at - BLOCK_HEADER_BYTES)) {
		return fail_packed(inflater, "the compressed data is truncated");
	}
	inflater->at += BLOCK_HEADER_BYTES;
	return unpack_block(inflater, packed_bytes - 2, bytes);
}

static int unpack_all(struct inflater *inflater)
{
	const uint8_t *at = inflater->at;
	size_t total;
	int error = 0;

	if (inflater->end - at < 4) {
		return fail_packed(inflater, "the compressed data is truncated");
	}
	total = (size_t)at[0] | (size_t)at[1] << 8 | (size_t)at[2] << 16 |
		(size_t)at[3] << 24;
	if (total < XFILE_HEADER_BYTES) {
		return fail_packed(inflater,
			"the decompressed size is smaller than a header");
	}
	if (total > XFILE_UNPACKED_MAX) {
		log_error(inflater->context->log,
			"%s: the decompressed file has %zu bytes; limber reads up to %d",
			inflater->context->path, total, XFILE_UNPACKED_MAX);
		return -EFBIG;
	}
	inflater->expected = total - XFILE_HEADER_BYTES;
	inflater->at += 4;
	while (!error && inflater->used < inflater->expected) {
		error = unpack_next(inflater);
	}
	return error;
}

int xfile_inflate(const struct xfile_context *context, const uint8_t *packed,
	size_t packed_size, struct xfile_unpacked *out)
{
	struct inflater inflater = {
		.context = context,
		.begin = packed,
		.at = packed,
		.end = packed + packed_size,
	};
	int error;

	/* Negative window bits mean a deflate stream without a zlib header. */
	if (inflateInit2(&inflater.stream, -MAX_WBITS) != Z_OK) {
		return xfile_no_memory(context);
	}
	error = unpack_all(&inflater);
	if (!error) {
		error = reserve(&inflater, 1);
	}
	inflateEnd(&inflater.stream);
	*out = (struct xfile_unpacked){
		inflater.out, inflater.used, inflater.capacity};
	if (error) {
		xfile_unpacked_release(out, context);
	}
	return error;
}

void xfile_unpacked_release(
	struct xfile_unpacked *unpacked, const struct xfile_context *context)
{
	free(unpacked->data);
	memory_budget_give_back(context->budget, unpacked->taken_bytes);
	*unpacked = (struct xfile_unpacked){0};
}
