#include "app/model/xfile/xfile_inflate.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#define ZLIB_CONST
#include <zlib.h>

enum {
	BLOCK_BYTES = 32 * 1024, /* unpacked, at most */
	HISTORY_BYTES = 32 * 1024,
	BLOCK_HEADER_BYTES = 6,
};

struct unpacking {
	const struct xfile_source *source;
	const uint8_t *begin; /* of the packed data, behind the header */
	const uint8_t *at;
	const uint8_t *end;
	z_stream stream;
	uint8_t *out;
	size_t used;
	size_t room;
	size_t promised; /* bytes of the unpacked body */
};

/* Places count in the packed file here, whatever it holds. */
static int fail_packed(const struct unpacking *unpacking, const char *reason)
{
	log_error(unpacking->source->log, "%s: byte %zu: %s",
		unpacking->source->path,
		XFILE_HEADER_BYTES + (size_t)(unpacking->at - unpacking->begin),
		reason);
	return -EINVAL;
}

static int make_room(struct unpacking *unpacking, size_t more)
{
	size_t room = unpacking->room ? unpacking->room : BLOCK_BYTES;
	uint8_t *out;

	while (room - unpacking->used < more) {
		room *= 2;
	}
	if (room == unpacking->room) {
		return 0;
	}
	out = realloc(unpacking->out, room);
	if (!out) {
		return xfile_no_memory(unpacking->source);
	}
	unpacking->out = out;
	unpacking->room = room;
	return 0;
}

static bool inflate_block(
	struct unpacking *unpacking, size_t packed_bytes, size_t bytes)
{
	z_stream *stream = &unpacking->stream;
	size_t history = unpacking->used < HISTORY_BYTES ? unpacking->used
							 : HISTORY_BYTES;

	if (inflateReset(stream) != Z_OK) {
		return false;
	}
	if (history &&
		inflateSetDictionary(stream,
			unpacking->out + unpacking->used - history,
			(uInt)history) != Z_OK) {
		return false;
	}
	stream->next_in = unpacking->at;
	stream->avail_in = (uInt)packed_bytes;
	stream->next_out = unpacking->out + unpacking->used;
	stream->avail_out = (uInt)bytes;
	return inflate(stream, Z_FINISH) == Z_STREAM_END && !stream->avail_out;
}

/* Takes one block, behind its header. */
static int unpack_block(
	struct unpacking *unpacking, size_t packed_bytes, size_t bytes)
{
	int error;

	if (bytes > BLOCK_BYTES) {
		return fail_packed(unpacking,
			"a compressed block holds more than 32,768 bytes");
	}
	if (bytes > unpacking->promised - unpacking->used) {
		return fail_packed(unpacking,
			"the compressed data is longer than it promises");
	}
	error = make_room(unpacking, bytes);
	if (error) {
		return error;
	}
	if (!inflate_block(unpacking, packed_bytes, bytes)) {
		return fail_packed(unpacking, "the compressed block is damaged");
	}
	unpacking->used += bytes;
	unpacking->at += packed_bytes;
	return 0;
}

static int unpack_next(struct unpacking *unpacking)
{
	const uint8_t *at = unpacking->at;
	size_t bytes, packed_bytes;

	if (unpacking->end - at < BLOCK_HEADER_BYTES) {
		return fail_packed(unpacking, "the compressed data ends early");
	}
	bytes = (size_t)at[0] | (size_t)at[1] << 8;
	packed_bytes = (size_t)at[2] | (size_t)at[3] << 8;
	if (at[4] != 'C' || at[5] != 'K') {
		return fail_packed(unpacking, "a compressed block is missing");
	}
	/* The packed size counts the letters. */
	if (packed_bytes < 2 ||
		packed_bytes - 2 >
			(size_t)(unpacking->end - at - BLOCK_HEADER_BYTES)) {
		return fail_packed(unpacking, "the compressed data ends early");
	}
	unpacking->at += BLOCK_HEADER_BYTES;
	return unpack_block(unpacking, packed_bytes - 2, bytes);
}

static int unpack_all(struct unpacking *unpacking)
{
	const uint8_t *at = unpacking->at;
	size_t total;
	int error = 0;

	if (unpacking->end - at < 4) {
		return fail_packed(unpacking, "the compressed data ends early");
	}
	total = (size_t)at[0] | (size_t)at[1] << 8 | (size_t)at[2] << 16 |
		(size_t)at[3] << 24;
	if (total < XFILE_HEADER_BYTES) {
		return fail_packed(unpacking, "the unpacked size is too small");
	}
	if (total > XFILE_UNPACKED_MAX) {
		log_error(unpacking->source->log,
			"%s: is %zu bytes unpacked; limber reads up to %d",
			unpacking->source->path, total, XFILE_UNPACKED_MAX);
		return -EFBIG;
	}
	unpacking->promised = total - XFILE_HEADER_BYTES;
	unpacking->at += 4;
	while (!error && unpacking->used < unpacking->promised) {
		error = unpack_next(unpacking);
	}
	return error;
}

int xfile_inflate(const struct xfile_source *source, const uint8_t *packed,
	size_t packed_size, uint8_t **out, size_t *out_size)
{
	struct unpacking unpacking = {
		.source = source,
		.begin = packed,
		.at = packed,
		.end = packed + packed_size,
	};
	int error;

	/* Negative window bits: deflate without zlib's own header. */
	if (inflateInit2(&unpacking.stream, -MAX_WBITS) != Z_OK) {
		return xfile_no_memory(source);
	}
	error = unpack_all(&unpacking);
	if (!error) {
		error = make_room(&unpacking, 1);
	}
	inflateEnd(&unpacking.stream);
	if (error) {
		free(unpacking.out);
		return error;
	}
	*out = unpacking.out;
	*out_size = unpacking.used;
	return 0;
}
