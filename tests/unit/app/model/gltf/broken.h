/*
 * Malformed glTF for the tests of its loader: each text must cause one error
 * that names the location in the file.
 */
#ifndef TESTS_UNIT_APP_MODEL_GLTF_BROKEN_H
#define TESTS_UNIT_APP_MODEL_GLTF_BROKEN_H

#include "app/model/model.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct broken {
	const char *text;     /* what follows "asset"; ' stands for " */
	const char *sentence; /* part of the error */
};

static void expect_code(const char *text, int code, const char *sentence)
{
	struct log_capture logged;
	struct model *model;
	int error = model_from_text(text, &logged, &model);

	if (error != code || !logged.count ||
		!strstr(logged.sentence[logged.count - 1], sentence)) {
		fail_msg("%s\n returns %d: %s\n instead of %d: %s", text, error,
			logged.count ? logged.sentence[logged.count - 1] : "",
			code, sentence);
	}
	assert_null(model);
	assert_int_equal(log_capture_count(&logged, LOG_ERROR), 1);
	assert_int_equal(strncmp(logged.sentence[logged.count - 1],
				 "t.gltf: ", strlen("t.gltf: ")),
		0);
}

static void expect_all(const struct broken *broken, size_t count)
{
	size_t i;

	for (i = 0; i < count; i++) {
		char text[2048];

		assert_true(strlen(broken[i].text) < sizeof(text) - 64);
		snprintf(text, sizeof(text), "{'asset':{'version':'2.0'},%s}",
			broken[i].text);
		expect_code(text, -EINVAL, broken[i].sentence);
	}
}

#define EXPECT_ALL(table) expect_all(table, sizeof(table) / sizeof((table)[0]))

/* Parts of the texts. Accessors without a bufferView are zeros. */
#define VIEW16                                                    \
	"'buffers':[{'byteLength':16,'uri':'data:;base64,"        \
	"AAAAAAAAAAAAAAAAAAAAAA=='}],'bufferViews':[{'buffer':0," \
	"'byteLength':16}]"
#define NAN_VIEW                                                      \
	"'buffers':[{'byteLength':4,'uri':'data:;base64,AADAfw=='}]," \
	"'bufferViews':[{'buffer':0,'byteLength':4}]"
#define ZEROS(type, component, count) \
	"{'type':'" type "','componentType':" component ",'count':" count "}"
#define ACCESSORS(list)    "'accessors':[" list "]"
#define VEC3               ZEROS("VEC3", "5126", "3")
#define VEC4               ZEROS("VEC4", "5126", "3")
#define PRIMITIVE(members) "'meshes':[{'primitives':[{" members "}]}]"
#define ATTRIBUTES(list)   PRIMITIVE("'attributes':{" list "}")

#endif
