/*
 * Loads models from tests/fixtures and from text within a test.
 */
#ifndef TESTS_SUPPORT_MODEL_MODEL_FIXTURE_H
#define TESTS_SUPPORT_MODEL_MODEL_FIXTURE_H

#include "app/model/model.h"
#include "tests/support/log_capture.h"

/*
 * Loads tests/fixtures/NAME. Fails the running test, with the first sentence
 * that was logged, when the model cannot be loaded. heard keeps the sentences
 * and may be NULL. The caller ends with model_destroy().
 */
struct model *model_fixture(const char *name, struct log_capture *heard);

/*
 * Loads a .gltf file from text in which ' stands for ". Sentences call the file
 * "t.gltf". Returns what model_load_memory() returns.
 */
int model_from_text(
	const char *text, struct log_capture *heard, struct model **out);

/* The node that has this index in the file; it must exist. */
const struct model_node *fixture_node(const struct model *model, int file_index);

#endif
