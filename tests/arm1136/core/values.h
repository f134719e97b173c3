/*
 * The values of the core's registers, as far as the model knows them.
 *
 * QEMU 7.2 does not show registers to a plugin, and a preload makes no memory
 * access. So the address of a preload is computed from constants, arithmetic,
 * loaded values and the bases of accesses. A register that cannot be followed
 * is unknown until an access uses it as its base.
 */
#ifndef TESTS_ARM1136_CORE_VALUES_H
#define TESTS_ARM1136_CORE_VALUES_H

#include "tests/arm1136/core/insn.h"

struct values {
	uint32_t value[16];
	uint32_t known; /* one bit for each register */
	uint32_t fpscr; /* without its flags; 0 until it is set */

	uint64_t foretold; /* addresses computed before the access was seen */
	uint64_t mistaken; /* how many of these were wrong */
};

/* One access as QEMU reports it. */
struct access {
	const struct insn *insn;
	uint32_t address;
	uint32_t value; /* the word that a load read, if has_value */
	uint8_t bytes;
	bool is_store;
	bool has_value;
};

/* Makes all registers unknown; the counts stay. */
void values_forget(struct values *values);

/* Computes the results of an instruction whose condition passed. */
void values_step(struct values *values, const struct insn *insn,
	const struct access *access, int access_count);

/* Computes the address of a preload; returns false when it is unknown. */
bool values_address(
	const struct values *values, const struct insn *insn, uint32_t *out);

/* LEN and STRIDE of FPSCR: the iterations of a short vector, and the step. */
static inline unsigned int values_vector_length(const struct values *values)
{
	return (values->fpscr >> 16 & 7) + 1;
}

static inline unsigned int values_vector_stride(const struct values *values)
{
	return (values->fpscr >> 20 & 3) == 3 ? 2 : 1;
}

#endif
