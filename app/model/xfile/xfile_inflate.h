/*
 * Decompression of .x files. The body of a compressed file is the size of the
 * decompressed file in 4 bytes, then MSZIP blocks. A block is its decompressed
 * size and its compressed size, 2 bytes each, the letters CK and a deflate
 * stream that may refer to the 32 KiB before it.
 */
#ifndef APP_MODEL_XFILE_XFILE_INFLATE_H
#define APP_MODEL_XFILE_XFILE_INFLATE_H

#include "app/model/xfile/xfile_reader.h"

enum {
	XFILE_UNPACKED_MAX = 256 * 1024 * 1024
};

/*
 * Decompresses what follows the 16-byte header into memory that the caller
 * frees. 0, or after an error -EINVAL for damaged data, -EFBIG beyond
 * XFILE_UNPACKED_MAX, -ENOMEM. The buffer grows with the decompressed data, not
 * to the size that the file claims.
 */
int xfile_inflate(const struct xfile_context *context, const uint8_t *packed,
	size_t packed_size, uint8_t **out, size_t *out_size);

#endif
