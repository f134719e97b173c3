/*
 * The parts of URI syntax (RFC 3986) that references between files need.
 */
#ifndef APP_MODEL_GLTF_URI_H
#define APP_MODEL_GLTF_URI_H

#include <stdbool.h>

/* Whether a URI begins with "data:" in upper or lower case. */
bool uri_is_data(const char *uri);

/* Returns the text behind ";base64," in a data URI, or NULL without that. */
const char *uri_data_base64(const char *uri);

/* Whether a URI begins with a scheme ("http:", "file:"). */
bool uri_has_scheme(const char *uri);

/*
 * Decodes percent escapes into out, which has room for strlen(uri) + 1 bytes.
 * Returns 0, or -EINVAL for a malformed escape and for %00.
 */
int uri_unescape(const char *uri, char *out);

#endif
