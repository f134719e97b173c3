/*
 * Caches, address translation, write buffer, L2 and memory: computes the cycle at
 * which requested data arrives. A line has 32 bytes; addresses are the program's.
 */
#ifndef TESTS_ARM1136_CORE_MEMORY_H
#define TESTS_ARM1136_CORE_MEMORY_H

#include "tests/arm1136/core/insn.h"
#include "tests/arm1136/core/pages.h"
#include "tests/arm1136/core/params.h"

#define MEMORY_LINE_SHIFT 5
#define MEMORY_MAX_MISSES 8
#define MEMORY_MAX_WRITES 16

struct memory_line {
	uint32_t line; /* address >> MEMORY_LINE_SHIFT */
	bool valid;
	bool dirty;
	int64_t arrives; /* cycle */
	uint8_t from;    /* enum cause: the level that it comes from */
};

struct memory_cache {
	uint32_t sets;
	uint32_t ways;
	struct memory_line *line; /* [sets * ways] */
};

/* Numbers of lines. */
struct memory_counts {
	uint64_t fetches_missed; /* instruction lines not in L1 */
	uint64_t loads;          /* lines that loads request */
	uint64_t loads_missed;
	uint64_t loads_awaited; /* requested before, by a preload for instance */
	uint64_t stores;
	uint64_t stores_missed;
	uint64_t preloads;
	uint64_t preloads_dropped; /* the line was in L1 */
	uint64_t preloads_unknown; /* the model does not know the address */
	uint64_t l2_missed;
	uint64_t lines_written; /* to memory */
	uint64_t pages_missed;  /* not in a MicroTLB */
	uint64_t pages_walked;  /* not in the main TLB either */
};

struct memory {
	const struct params *params;
	struct memory_cache l1i, l1d, l2;
	struct pages pages;
	uint32_t random; /* state of the shift register that chooses victims */
	int64_t miss_ends[MEMORY_MAX_MISSES]; /* cycle of each line's arrival */
	int64_t write_ends[MEMORY_MAX_WRITES]; /* cycle each entry gets free */
	uint32_t next_write;                   /* the entry to use next */
	uint32_t open_line; /* the line that the write buffer still gathers */
	bool is_open;       /* there is an open line */
	int64_t l2_free, ddr_free; /* cycles from which they are free */
	struct memory_counts counts;
};

/* Returns 0 or -ENOMEM. memory_finish() frees the caches. */
int memory_init(struct memory *memory, const struct params *params);
void memory_finish(struct memory *memory);

/*
 * Empties the queues and caches: MEMORY_ALL all caches and the TLBs,
 * MEMORY_DATA L1's data cache and L2, MEMORY_L1_DATA L1's data cache alone.
 * MEMORY_PAGES empties the data TLBs and nothing else.
 */
enum memory_level {
	MEMORY_ALL,
	MEMORY_DATA,
	MEMORY_L1_DATA,
	MEMORY_PAGES
};
void memory_flush(struct memory *memory, enum memory_level level);

/* How a load or store that starts at cycle now differs from a hit in L1. */
struct memory_answer {
	int64_t delay;      /* extra cycles until the line arrives */
	enum cause cause;   /* of the delay */
	int64_t pipe_until; /* the load/store pipeline stops until then */
	enum cause pipe_cause;
};

struct memory_answer memory_load(
	struct memory *memory, uint32_t address, int64_t now);
struct memory_answer memory_preload(
	struct memory *memory, uint32_t address, int64_t now);
struct memory_answer memory_store(
	struct memory *memory, uint32_t address, int64_t now);

/* Extra cycles until the instructions of that line can issue. */
int64_t memory_fetch(struct memory *memory, uint32_t address, int64_t now);

#endif
