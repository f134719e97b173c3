/*
 * The body of a compressed .x file: a 4-byte size of the whole file unpacked,
 * then MSZIP blocks. A block is its unpacked and packed sizes, 2 bytes each,
 * the letters CK and a deflate stream that may refer to 32 KiB before it.
 */
#ifndef APP_MODEL_XFILE_XFILE_INFLATE_H
#define APP_MODEL_XFILE_XFILE_INFLATE_H

#include "app/model/xfile/xfile_reader.h"

enum {
	XFILE_UNPACKED_MAX = 256 * 1024 * 1024
};

/*
 * Unpacks what follows the 16-byte header into memory that the caller frees.
 * 0, or -EINVAL for damaged data, -EFBIG beyond XFILE_UNPACKED_MAX or -ENOMEM
 * after a sentence. Memory grows with what is really there, not with what the
 * file promises.
 */
int xfile_inflate(const struct xfile_source *source, const uint8_t *packed,
	size_t packed_size, uint8_t **out, size_t *out_size);

#endif
