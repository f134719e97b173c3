/*
 * Model files for tests: those of the project and the sample models, which are
 * not part of it. The environment variable SAMPLES names the samples' folder;
 * without it, they are expected in ../shared.
 */
#ifndef TESTS_SUPPORT_MODEL_SAMPLES_H
#define TESTS_SUPPORT_MODEL_SAMPLES_H

#include "tests/support/files.h"

/* SAMPLES/models/NAME; the file may be missing. */
struct test_path samples_path(const char *name);

/* Skips the running test when the file or folder SAMPLES/models/NAME is missing. */
void samples_require(const char *name);

/*
 * Calls use() with the path of each .glb, .gltf and .x file in a folder and
 * returns their number, which is 0 when there is no such folder.
 */
int samples_each_model(const char *folder, void (*use)(const char *path));

#endif
