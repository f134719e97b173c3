#include "app/model/gltf/base64.h"

#include <errno.h>

size_t base64_decoded_max(size_t length)
{
	return length / 4 * 3 + 3;
}

static int digit(char c)
{
	if (c >= 'A' && c <= 'Z') {
		return c - 'A';
	}
	if (c >= 'a' && c <= 'z') {
		return c - 'a' + 26;
	}
	if (c >= '0' && c <= '9') {
		return c - '0' + 52;
	}
	if (c == '+') {
		return 62;
	}
	return c == '/' ? 63 : -1;
}

static size_t without_padding(const char *text, size_t length)
{
	int padding_max = length % 4 == 0 ? 2 : 0;

	while (padding_max > 0 && length > 0 && text[length - 1] == '=') {
		length--;
		padding_max--;
	}
	return length;
}

int base64_decode(const char *text, size_t length, uint8_t *out, size_t *size)
{
	uint32_t bits = 0;
	size_t done = 0;
	size_t i;

	length = without_padding(text, length);
	if (length % 4 == 1) {
		return -EINVAL;
	}
	for (i = 0; i < length; i++) {
		int value = digit(text[i]);

		if (value < 0) {
			return -EINVAL;
		}
		bits = (bits & 63) << 6 | (uint32_t)value;
		if (i % 4 == 1) {
			out[done++] = (uint8_t)(bits >> 4);
		} else if (i % 4 == 2) {
			out[done++] = (uint8_t)(bits >> 2);
		} else if (i % 4 == 3) {
			out[done++] = (uint8_t)bits;
		}
	}
	*size = done;
	return 0;
}
