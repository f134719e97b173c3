/*
 * The program that the model runs: its instructions by address, each decoded
 * once, its functions, and the regions that are counted.
 */
#ifndef TESTS_ARM1136_PROGRAM_H
#define TESTS_ARM1136_PROGRAM_H

#include "tests/arm1136/core/core.h"
#include "tests/arm1136/symbols.h"

#define PROGRAM_MAX_REGIONS 512

struct region {
	uint32_t pc; /* of the marker, or the function, that begins it */
	uint8_t id;  /* the marker's number */
	uint64_t entries;
	uint64_t first, last, least, most; /* cycles of one pass */
	uint64_t cycles;
	struct core_totals totals;
};

struct program {
	const struct params *params;
	struct symbols symbols;

	struct insn **insn; /* open addressing by pc */
	size_t insn_capacity;
	size_t insn_count;

	struct region region[PROGRAM_MAX_REGIONS];
	size_t region_count;
};

int program_init(struct program *program, const struct params *params);
void program_finish(struct program *program);

/*
 * Returns the instruction at pc, and decodes it if there was none or another
 * word; *is_new says whether it did. NULL when memory is short.
 */
struct insn *program_insn(
	struct program *program, uint32_t pc, uint32_t word, bool *is_new);

/* The region that begins at pc, made if needed; NULL when there are too many. */
struct region *program_region(struct program *program, uint32_t pc, uint8_t id);

/* Adds a pass to a region: its cycles, and the totals before and after it. */
void region_add(struct region *region, uint64_t cycles,
	const struct core_totals *before, const struct core_totals *after);

#endif
