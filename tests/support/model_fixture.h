/*
 * Models from tests/fixtures, and from text within a test.
 */
#ifndef TESTS_SUPPORT_MODEL_FIXTURE_H
#define TESTS_SUPPORT_MODEL_FIXTURE_H

#include "app/model/model.h"
#include "tests/support/log_capture.h"

/*
 * Loads tests/fixtures/NAME; fails the running test with what was said when
 * that does not work. heard keeps the sentences and may be NULL. The caller
 * ends with model_destroy().
 */
struct model *model_fixture(const char *name, struct log_capture *heard);

/*
 * Loads a .gltf given as text, in which ' stands for ". Named "t.gltf" in
 * sentences. What model_load_memory() returns.
 */
int model_from_text(
	const char *text, struct log_capture *heard, struct model **out);

/* The node with the file's number, which must exist. */
const struct model_node *fixture_node(const struct model *model, int file_index);

#endif
