/*
 * Internals of the core: core.c issues instructions and counts, core_memory.c
 * executes loads and stores, core_vfp.c the VFP, and core_branch.c knows what
 * branches cost.
 */
#ifndef TESTS_ARM1136_CORE_CORE_PARTS_H
#define TESTS_ARM1136_CORE_CORE_PARTS_H

#include "tests/arm1136/core/core.h"

/* The earliest cycle at which an instruction can issue, as far as is known. */
struct issue {
	int64_t at;
	enum cause cause; /* of the wait until then */
};

static inline void issue_wait(
	struct issue *issue, int64_t when, enum cause cause)
{
	if (when > issue->at) {
		issue->at = when;
		issue->cause = cause;
	}
}

/* The cycle from which an instruction with that need of the register can issue. */
int64_t core_operand_ready(
	const struct core *core, unsigned int reg, enum need need);

/* Delays the issue until a result of that latency may be written. */
void core_wait_to_write(const struct core *core, struct issue *issue,
	unsigned int reg, int64_t latency);

void core_write_register(
	struct core *core, unsigned int reg, int64_t ready, enum cause maker);

/* Delays the issue for the registers that the instruction loads or stores. */
void core_wait_for_registers(
	const struct core *core, const struct insn *insn, struct issue *issue);

/* Execute a load or store, or a preload, that issues at that cycle. */
void core_execute_memory(struct core *core, struct insn *insn,
	const struct access *access, int access_count, int64_t at);
void core_execute_preload(
	struct core *core, const struct insn *insn, int64_t at);

/* VFP arithmetic: delays the issue for all iterations' registers; executes. */
void core_wait_for_vfp(
	struct core *core, const struct insn *insn, struct issue *issue);
void core_execute_vfp(struct core *core, const struct insn *insn, int64_t at);

/*
 * Returns all cycles of a branch, 0 for one that was folded, and sets *cause to
 * the cause of the cycles beyond the first.
 */
int64_t core_branch_cycles(struct core *core, const struct insn *insn,
	const struct insn *next, int64_t at, enum cause *cause);

#endif
