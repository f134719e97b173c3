/*
 * Base64 decoding, as data URIs need it (RFC 4648, section 4).
 */
#ifndef APP_MODEL_GLTF_BASE64_H
#define APP_MODEL_GLTF_BASE64_H

#include <stddef.h>
#include <stdint.h>

/* The largest number of bytes that length characters decode to. */
size_t base64_decoded_max(size_t length);

/*
 * Decodes length characters into out, which holds base64_decoded_max(length)
 * bytes; *size becomes the number written. Padding is optional. 0, or -EINVAL
 * for a character outside the alphabet and for an impossible length.
 */
int base64_decode(const char *text, size_t length, uint8_t *out, size_t *size);

#endif
