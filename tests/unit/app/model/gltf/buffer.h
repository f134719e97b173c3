/*
 * glTF files with a buffer of bytes, for the tests of its loader.
 */
#ifndef TESTS_UNIT_APP_MODEL_GLTF_BUFFER_H
#define TESTS_UNIT_APP_MODEL_GLTF_BUFFER_H

#include "app/model/model.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <stdio.h>

enum {
	BUFFER_TEXT = 4096 /* bytes of a file */
};

/* Writes bytes, of which there are a multiple of three, as base64. */
static void buffer_encode(const uint8_t *byte, size_t size, char *text)
{
	static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
				    "abcdefghijklmnopqrstuvwxyz0123456789+/";

	assert_int_equal(size % 3, 0);
	assert_true(size <= BUFFER_TEXT / 3);
	for (size_t i = 0; i < size; i += 3) {
		uint32_t bits = (uint32_t)byte[i] << 16 |
			(uint32_t)byte[i + 1] << 8 | byte[i + 2];

		for (int k = 0; k < 4; k++) {
			*text++ = digit[bits >> (18 - 6 * k) & 63];
		}
	}
	*text = '\0';
}

/*
 * Loads a file with a buffer of these bytes, one view of all of it, and more
 * members, in which ' stands for ". The file is valid.
 */
static struct model *buffer_model(
	const void *bytes, size_t size, const char *more)
{
	struct log_capture logged;
	struct model *model = NULL;
	char data[BUFFER_TEXT / 3 * 4 + 1], text[2 * BUFFER_TEXT];
	int length;

	buffer_encode(bytes, size, data);
	length = snprintf(text, sizeof(text),
		"{'asset':{'version':'2.0'},'buffers':[{'byteLength':%zu,"
		"'uri':'data:;base64,%s'}],'bufferViews':[{'buffer':0,"
		"'byteLength':%zu}],%s}",
		size, data, size, more);
	assert_in_range(length, 1, sizeof(text) - 1);
	if (model_from_text(text, &logged, &model) != 0) {
		fail_msg("%s", logged.sentence[0]);
	}
	return model;
}

#endif
