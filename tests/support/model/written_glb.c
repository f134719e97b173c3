#include "tests/support/model/written_glb.h"

#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <stdlib.h>

struct written_glb written_glb_take(struct glb *glb)
{
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct written_glb written;
	size_t size, length;

	assert_int_equal(
		glb_write_memory(glb, "t.glb", &log, &written.data, &size), 0);
	/* The JSON follows two headers, of 12 and 8 bytes. */
	length = (size_t)written.data[12] | (size_t)written.data[13] << 8;
	written.root =
		json_loadb((const char *)written.data + 20, length, 0, NULL);
	assert_non_null(written.root);
	written.binary = written.data + 20 + length + 8;
	return written;
}

void written_glb_release(struct written_glb *written)
{
	json_decref(written->root);
	free(written->data);
}

void written_glb_expect(
	const struct written_glb *written, const char *name, const char *wanted)
{
	json_t *member = json_object_get(written->root, name);
	char *text = member ? json_dumps(member, JSON_COMPACT | JSON_SORT_KEYS)
			    : NULL;

	for (char *at = text; at && *at; at++) {
		*at = *at == '"' ? '\'' : *at;
	}
	assert_string_equal(text ? text : "", wanted);
	free(text);
}
