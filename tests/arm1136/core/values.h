/*
 * What the model knows of the contents of the core's registers.
 *
 * The plugin interface shows no registers, and a preload makes no memory
 * access, so its address has to be worked out: from constants, plain
 * arithmetic, what loads read, and the bases of accesses that are seen. What
 * it cannot follow is unknown until the register is used as a base.
 */
#ifndef TESTS_ARM1136_CORE_VALUES_H
#define TESTS_ARM1136_CORE_VALUES_H

#include "tests/arm1136/core/insn.h"

struct values {
	uint32_t value[16];
	uint32_t known; /* a bit a register */
	uint32_t fpscr; /* without its flags; 0 when nobody set it */

	/* Addresses of loads and stores that were known before they were seen. */
	uint64_t foretold;
	uint64_t mistaken;
};

/* One access as QEMU reports it; the value of a word that was read. */
struct access {
	const struct insn *insn;
	uint32_t address;
	uint32_t value;
	uint8_t bytes;
	bool is_store;
	bool has_value;
};

/* Nothing is known any more; the counts stay. */
void values_forget(struct values *values);

/* Follows an instruction whose condition passed, as far as is known. */
void values_step(struct values *values, const struct insn *insn,
	const struct access *access, int access_count);

/* The address of a preload; false when it is unknown. */
bool values_address(
	const struct values *values, const struct insn *insn, uint32_t *out);

/* LEN and STRIDE of FPSCR: iterations of a short vector, and their step. */
static inline unsigned int values_vector_length(const struct values *values)
{
	return (values->fpscr >> 16 & 7) + 1;
}

static inline unsigned int values_vector_stride(const struct values *values)
{
	return (values->fpscr >> 20 & 3) == 3 ? 2 : 1;
}

#endif
