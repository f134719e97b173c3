/*
 * The program that runs in the model: its instructions, decoded once each and
 * kept by address, its functions, and the regions that are counted.
 */
#ifndef TESTS_ARM1136_PROGRAM_H
#define TESTS_ARM1136_PROGRAM_H

#include "tests/arm1136/core/core.h"
#include "tests/arm1136/symbols.h"

#define PROGRAM_MAX_REGIONS 512

struct region {
	uint32_t pc; /* of the marker that begins it */
	uint8_t id;
	uint64_t entries;
	uint64_t first, last, least, most; /* cycles of one pass */
	uint64_t cycles;
	struct core_totals totals;
};

struct program {
	const struct params *params;
	struct symbols symbols;

	struct insn **insn; /* open addressing by pc */
	size_t insn_room;
	size_t insn_count;

	struct region region[PROGRAM_MAX_REGIONS];
	size_t region_count;
};

int program_init(struct program *program, const struct params *params);
void program_finish(struct program *program);

/*
 * The instruction at pc. Another word there than before is another program's
 * code, and is decoded anew. NULL when out of memory.
 */
struct insn *program_insn(
	struct program *program, uint32_t pc, uint32_t word, bool *is_new);

/* The region that begins at pc; NULL when there are too many. */
struct region *program_region(struct program *program, uint32_t pc, uint8_t id);

/* Adds what happened between two moments to a region. */
void region_add(struct region *region, uint64_t cycles,
	const struct core_totals *before, const struct core_totals *after);

#endif
