#include "app/model/gltf/uri.h"

#include <errno.h>
#include <stddef.h>
#include <string.h>
#include <strings.h>

static bool is_letter(char c)
{
	return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

static int hex_digit(char c)
{
	if (c >= '0' && c <= '9') {
		return c - '0';
	}
	if (c >= 'a' && c <= 'f') {
		return c - 'a' + 10;
	}
	return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

bool uri_is_data(const char *uri)
{
	return strncasecmp(uri, "data:", 5) == 0;
}

const char *uri_data_base64(const char *uri)
{
	static const char marker[] = ";base64";
	const char *comma = strchr(uri, ',');
	size_t length = sizeof(marker) - 1;

	if (!comma || comma - uri < (ptrdiff_t)length ||
		strncasecmp(comma - length, marker, length) != 0) {
		return NULL;
	}
	return comma + 1;
}

bool uri_has_scheme(const char *uri)
{
	const char *at = uri;

	if (!is_letter(*at)) {
		return false;
	}
	while (is_letter(*at) || (*at >= '0' && *at <= '9') || *at == '+' ||
		*at == '-' || *at == '.') {
		at++;
	}
	return *at == ':';
}

int uri_unescape(const char *uri, char *out)
{
	while (*uri) {
		int high, low;

		if (*uri != '%') {
			*out++ = *uri++;
			continue;
		}
		high = hex_digit(uri[1]);
		low = high < 0 ? high : hex_digit(uri[2]);
		if (low < 0 || (high == 0 && low == 0)) {
			return -EINVAL;
		}
		*out++ = (char)(high << 4 | low);
		uri += 3;
	}
	*out = '\0';
	return 0;
}
