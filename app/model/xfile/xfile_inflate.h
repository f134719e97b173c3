/*
 * Decompression of .x files. The body of a compressed file begins with the size
 * of the decompressed file in 4 bytes; MSZIP blocks follow. A block has its
 * decompressed size and its compressed size, 2 bytes each, the letters CK and a
 * deflate stream that may refer to the 32 KiB of data before it.
 */
#ifndef APP_MODEL_XFILE_XFILE_INFLATE_H
#define APP_MODEL_XFILE_XFILE_INFLATE_H

#include "app/model/xfile/xfile_reader.h"

enum {
	XFILE_UNPACKED_MAX = 256 * 1024 * 1024
};

struct xfile_unpacked {
	uint8_t *data;
	size_t size;
	size_t taken_bytes; /* taken from the context's budget */
};

/*
 * Decompresses what follows the 16-byte header. Returns 0, or after an error
 * -EINVAL for damaged data, -EFBIG beyond XFILE_UNPACKED_MAX, -ENOMEM. The
 * buffer grows with the decompressed data; the size that the file claims is not
 * trusted. After success the caller calls xfile_unpacked_release().
 */
int xfile_inflate(const struct xfile_context *context, const uint8_t *packed,
	size_t packed_size, struct xfile_unpacked *out);

/* Frees the bytes and gives them back to the context's budget. */
void xfile_unpacked_release(
	struct xfile_unpacked *unpacked, const struct xfile_context *context);

#endif
