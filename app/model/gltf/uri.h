/*
 * The little of URIs (RFC 3986) that a model's references need.
 */
#ifndef APP_MODEL_GLTF_URI_H
#define APP_MODEL_GLTF_URI_H

#include <stdbool.h>

/* Whether it begins with "data:", in any case. */
bool uri_is_data(const char *uri);

/* The base64 text of a data URI, or NULL when it is not base64. */
const char *uri_data_base64(const char *uri);

/* Whether it begins with a scheme ("http:", "file:"). */
bool uri_has_scheme(const char *uri);

/*
 * Decodes percent escapes into out, which has room for the URI's own length
 * and its zero. 0, or -EINVAL for a broken escape and for %00.
 */
int uri_unescape(const char *uri, char *out);

#endif
