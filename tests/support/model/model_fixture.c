#include "tests/support/model/model_fixture.h"

#include "tests/support/files.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

struct model *model_fixture(const char *name, struct log_capture *heard)
{
	struct test_path path = fixture_path(name);
	struct log_capture own;
	struct model *model;
	struct log log;

	heard = heard ? heard : &own;
	log = log_capture_begin(heard);
	if (model_load(path.text, &log, &model) != 0) {
		fail_msg("%s",
			heard->count ? heard->sentence[0] : "no sentence");
	}
	return model;
}

int model_from_text(
	const char *text, struct log_capture *heard, struct model **out)
{
	struct log log = log_capture_begin(heard);
	size_t size = strlen(text);
	/* Without a final zero, so that the sanitizers notice a read past it. */
	char *json = malloc(size);
	int error;
	size_t i;

	assert_non_null(json);
	for (i = 0; i < size; i++) {
		json[i] = (char)(text[i] == '\'' ? '"' : text[i]);
	}
	error = model_load_memory(json, size, "t.gltf", &log, out);
	free(json);
	return error;
}

const struct model_node *fixture_node(const struct model *model, int file_index)
{
	int i;

	for (i = 0; i < model->node_count; i++) {
		if (model->node[i].file_index == file_index) {
			return &model->node[i];
		}
	}
	fail_msg("no node has the number %d", file_index);
	return NULL;
}
