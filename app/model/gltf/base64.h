/*
 * Base64 as data URIs carry it (RFC 4648, section 4).
 */
#ifndef APP_MODEL_GLTF_BASE64_H
#define APP_MODEL_GLTF_BASE64_H

#include <stddef.h>
#include <stdint.h>

/* Bytes that length characters can at most decode to. */
size_t base64_room(size_t length);

/*
 * Decodes length characters; *size counts the bytes written to out, which has
 * base64_room(length). The padding may be left out. 0, or -EINVAL for any
 * other character and for a length that no bytes give.
 */
int base64_decode(const char *text, size_t length, uint8_t *out, size_t *size);

#endif
