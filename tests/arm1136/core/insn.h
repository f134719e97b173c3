/*
 * An instruction as the model knows it, decoded once from its encoding: what it
 * reads and when, what it writes and how long that takes, and which unit it
 * occupies. figures.md names the sources of the numbers.
 *
 * ARM state of ARMv6 with VFPv2 only; anything else is UNIT_UNKNOWN.
 */
#ifndef TESTS_ARM1136_CORE_INSN_H
#define TESTS_ARM1136_CORE_INSN_H

#include <stdbool.h>
#include <stdint.h>

/* The scoreboard's numbers of registers. */
enum {
	REG_SP = 13,
	REG_LR = 14,
	REG_PC = 15,
	REG_FLAGS = 16,
	REG_FP_FLAGS = 17,
	REG_S0 = 32, /* s0-s31; a double is the two singles it lies over */
	REG_COUNT = 64
};

enum unit {
	UNIT_ALU,
	UNIT_MULTIPLY,
	UNIT_LOAD,
	UNIT_STORE,
	UNIT_PRELOAD,
	UNIT_BRANCH,
	UNIT_VFP,        /* the FMAC pipeline */
	UNIT_VFP_DIVIDE, /* the divide and square root pipeline */
	UNIT_VFP_MOVE,   /* between the register files */
	UNIT_SYSTEM,
	UNIT_UNKNOWN
};

/* Causes of stalls. CAUSE_ALU to CAUSE_VFP also name the unit of a result. */
enum cause {
	CAUSE_ALU,          /* waits for an ALU result */
	CAUSE_MULTIPLY,     /* waits for a product */
	CAUSE_LOAD,         /* waits for a load that hit */
	CAUSE_L2,           /* waits for a line from L2 */
	CAUSE_DDR,          /* waits for a line from memory */
	CAUSE_PAGE,         /* waits for the translation of an address */
	CAUSE_VFP,          /* waits for a VFP result */
	CAUSE_ISSUE,        /* takes more than one issue cycle */
	CAUSE_MEMORY_PIPE,  /* the load/store pipeline is busy */
	CAUSE_VFP_PIPE,     /* the VFP pipeline is busy */
	CAUSE_LOCK,         /* may not write a register yet */
	CAUSE_MISSES,       /* too many lines are being loaded */
	CAUSE_WRITE_BUFFER, /* the write buffer is full */
	CAUSE_FETCH,        /* the instruction is not in L1 */
	CAUSE_TAKEN,        /* taken branch, statically predicted */
	CAUSE_MISPREDICT,   /* mispredicted branch */
	CAUSE_INDIRECT,     /* return or computed branch */
	CAUSE_COUNT
};

/* When an operand must be ready, relative to the usual stage. */
enum need {
	NEED_NORMAL,
	NEED_EARLY,       /* a cycle earlier */
	NEED_ADDRESS,     /* a cycle earlier, unless written back as a base */
	NEED_LATE,        /* a cycle later */
	NEED_ACCUMULATOR, /* a cycle later if a multiplication made it */
	NEED_STORED,      /* a cycle later; VFP results a cycle earlier */
};

struct operand {
	uint8_t reg;
	uint8_t need;
};

struct result {
	uint8_t reg;
	uint8_t latency;
};

enum branch {
	BRANCH_NONE,
	BRANCH_DIRECT,
	BRANCH_CALL,
	BRANCH_CALL_INDIRECT,
	BRANCH_RETURN,   /* BX lr, MOV pc, lr */
	BRANCH_POP,      /* LDR or LDM from sp into pc */
	BRANCH_INDIRECT, /* any other */
	BRANCH_LOAD      /* a load into pc that is no return */
};

enum marker {
	MARKER_NONE,
	MARKER_BEGIN,
	MARKER_END,
	MARKER_FLUSH
};

enum vfp_form {
	VFP_NONE,
	VFP_SCALAR, /* never a vector: comparisons, conversions */
	VFP_ONE,    /* d = op m */
	VFP_TWO,    /* d = n op m */
	VFP_THREE   /* d = d op n op m */
};

/* How values.c computes the results. */
enum value_rule {
	VALUE_LOST,     /* results are unknown */
	VALUE_ALU,      /* a data-processing instruction, shift by a constant */
	VALUE_LOAD,     /* results are what was read */
	VALUE_MULTIPLY, /* MUL, MLA */
	VALUE_FROM_FPSCR,
	VALUE_TO_FPSCR,
};

struct insn_counts {
	uint64_t executed;
	uint64_t folded;
	uint64_t cycles;
	uint64_t stall[CAUSE_COUNT];
	uint64_t data_misses; /* loads that had to wait for a line */
};

struct insn {
	uint32_t pc;
	uint32_t word;
	uint8_t unit;
	uint8_t branch;
	uint8_t marker;
	uint8_t marker_id;
	uint8_t value_rule;
	uint8_t issue;    /* cycles */
	uint8_t busy;     /* cycles of an iteration in the VFP's pipeline */
	bool conditional; /* its inputs include REG_FLAGS */
	bool sets_flags;
	bool serializes_vfp;
	uint8_t input_count;
	uint8_t output_count; /* without the registers in list and range */
	struct operand input[6];
	struct result output[3];

	/* Loads and stores. list and range are in the order of addresses. */
	bool slow_address; /* negative register offset, odd shift */
	bool writeback;
	bool extends; /* byte or halfword load */
	uint8_t base;
	uint8_t access_bytes; /* of one register; what it is aligned to */
	uint16_t list;        /* core registers, a bit for each */
	uint8_t range_first;  /* VFP registers, as singles */
	uint8_t range_count;

	uint8_t vfp_form;
	bool is_double;
	uint8_t vfp_d, vfp_n, vfp_m; /* REG_S0 + ... */
	uint8_t vfp_latency;

	uint32_t target; /* of a direct branch */
	char *text;      /* disassembly, or NULL */

	struct insn_counts counts;
};

/* Fills in everything but text and counts. */
void insn_decode(struct insn *insn, uint32_t pc, uint32_t word);

static inline bool insn_is_memory(const struct insn *insn)
{
	return insn->unit == UNIT_LOAD || insn->unit == UNIT_STORE ||
		insn->unit == UNIT_PRELOAD;
}

static inline bool insn_is_branch(const struct insn *insn)
{
	return insn->branch != BRANCH_NONE;
}

static inline uint32_t insn_field(
	const struct insn *insn, unsigned int low, unsigned int bits)
{
	return insn->word >> low & ((1u << bits) - 1);
}

/* Takes the lowest register out of a list that is not empty. */
static inline unsigned int insn_take_register(unsigned int *list)
{
	unsigned int reg = (unsigned int)__builtin_ctz(*list);

	*list &= *list - 1;
	return reg;
}

static inline bool insn_bit(const struct insn *insn, unsigned int bit)
{
	return insn->word >> bit & 1;
}

#endif
