/*
 * libFuzzer's mutation of inputs for targets that load models.
 */
#ifndef TESTS_FUZZ_GLTF_MUTATOR_H
#define TESTS_FUZZ_GLTF_MUTATOR_H

#include <stddef.h>
#include <stdint.h>

/* libFuzzer calls it; returns the new size, at most max_size. */
size_t LLVMFuzzerCustomMutator(
	uint8_t *data, size_t size, size_t max_size, unsigned int seed);

#endif
