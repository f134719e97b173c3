/*
 * Base64 decoding, as data URIs need it (RFC 4648, section 4).
 */
#ifndef APP_MODEL_GLTF_BASE64_H
#define APP_MODEL_GLTF_BASE64_H

#include <stddef.h>
#include <stdint.h>

/* Returns the largest number of bytes to which length characters may decode. */
size_t base64_decoded_max(size_t length);

/*
 * Decodes length characters into out, which has room for
 * base64_decoded_max(length) bytes, and sets *size to the number written.
 * Padding is optional. Returns 0, or -EINVAL for a character outside the
 * alphabet or an impossible length.
 */
int base64_decode(const char *text, size_t length, uint8_t *out, size_t *size);

#endif
