/*
 * What the parts of the core share: core.c issues and keeps account,
 * core_memory.c moves registers to and from memory, core_vfp.c runs the VFP,
 * core_branch.c says what branches cost.
 */
#ifndef TESTS_ARM1136_CORE_CORE_PARTS_H
#define TESTS_ARM1136_CORE_CORE_PARTS_H

#include "tests/arm1136/core/core.h"

/* Where an instruction stands on its way to issue. */
struct issue {
	int64_t at;
	enum cause cause; /* of waiting until then */
};

static inline void issue_wait(
	struct issue *issue, int64_t when, enum cause cause)
{
	if (when > issue->at) {
		issue->at = when;
		issue->cause = cause;
	}
}

/* From when on a register can be read as need says. */
int64_t core_operand_ready(
	const struct core *core, unsigned int reg, enum need need);

/* Waits until a result with that latency may be written. */
void core_wait_to_write(const struct core *core, struct issue *issue,
	unsigned int reg, int64_t latency);

void core_write_register(
	struct core *core, unsigned int reg, int64_t ready, enum cause maker);

/* For the registers that an instruction loads or stores. */
void core_wait_for_registers(
	const struct core *core, const struct insn *insn, struct issue *issue);

/* A load or store, or a preload, that issues at that cycle. */
void core_execute_memory(struct core *core, struct insn *insn,
	const struct access *access, int access_count, int64_t at);
void core_execute_preload(
	struct core *core, const struct insn *insn, int64_t at);

/* VFP arithmetic: all registers of all iterations, then the operation. */
void core_wait_for_vfp(
	struct core *core, const struct insn *insn, struct issue *issue);
void core_execute_vfp(struct core *core, const struct insn *insn, int64_t at);

/* Cycles of a branch in all, 0 when it was folded; sets the cause of more. */
int64_t core_branch_cycles(struct core *core, const struct insn *insn,
	const struct insn *next, int64_t at, enum cause *cause);

#endif
