/*
 * The core: issues instructions in order, each as early as its operands and its
 * unit allow, and counts the cycles that it waited by their cause.
 */
#ifndef TESTS_ARM1136_CORE_CORE_H
#define TESTS_ARM1136_CORE_CORE_H

#include "tests/arm1136/core/insn.h"
#include "tests/arm1136/core/memory.h"
#include "tests/arm1136/core/params.h"
#include "tests/arm1136/core/predict.h"
#include "tests/arm1136/core/values.h"

/* Sums; cycles = executed - folded + all stalls. */
struct core_totals {
	uint64_t executed;
	uint64_t folded;
	uint64_t unknown; /* instructions that were not decoded */
	uint64_t stall[CAUSE_COUNT];
	uint64_t branches;
	uint64_t mispredicted;
	uint64_t foretold; /* addresses that values.c computed beforehand */
	uint64_t mistaken; /* how many of these were wrong */
	struct memory_counts memory;
};

struct core {
	const struct params *params;
	struct memory memory;
	struct predict predict;
	struct values values;

	/* Cycles. */
	int64_t now;         /* the next instruction issues no earlier */
	int64_t memory_free; /* the load/store pipeline is free from here on */
	enum cause memory_cause;     /* of a wait for memory_free */
	int64_t vfp_free;            /* the same for the VFP's FMAC pipeline */
	int64_t divide_free;         /* the same for its divide pipeline */
	int64_t flags_set;           /* last issue of what sets the flags */
	int64_t ready[REG_COUNT];    /* a normal operand can be read */
	int64_t base_ready[16];      /* an address can be read */
	int64_t unlocked[REG_COUNT]; /* the register may be written */
	uint8_t maker[REG_COUNT];    /* enum cause of a wait for the register */
	uint32_t fetched_line;       /* the line that was fetched last */

	bool counts_insns; /* counts into insn->counts, too */
	struct core_totals totals;
};

/* Returns 0 or -ENOMEM. core_finish() frees the memory. */
int core_init(struct core *core, const struct params *params);
void core_finish(struct core *core);

/* Empties the caches and queues down to a level; see memory_flush(). */
void core_flush(struct core *core, enum memory_level level);

/*
 * Executes an instruction. access holds its access_count memory accesses, which
 * is 0 when its condition failed; next is the instruction executed after it.
 */
void core_step(struct core *core, struct insn *insn,
	const struct access *access, int access_count, const struct insn *next);

/* The totals, including the counts of the memory. */
struct core_totals core_totals(const struct core *core);

#endif
