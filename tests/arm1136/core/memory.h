/*
 * Caches, address translation, write buffer, L2 and memory: when data that is
 * asked for at some cycle arrives. Lines are 32 bytes; addresses are the
 * program's.
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
	uint8_t from;    /* enum cause: which level it comes from */
};

struct memory_cache {
	uint32_t sets;
	uint32_t ways;
	struct memory_line *line; /* [sets * ways] */
};

/* Lines by what happened to them. */
struct memory_counts {
	uint64_t fetches_missed; /* instruction lines not in L1 */
	uint64_t loads;          /* lines asked for by loads */
	uint64_t loads_missed;
	uint64_t loads_awaited; /* on their way, by a preload for instance */
	uint64_t stores;
	uint64_t stores_missed;
	uint64_t preloads;
	uint64_t preloads_dropped; /* the line was there */
	uint64_t preloads_unknown; /* the model does not know the address */
	uint64_t l2_missed;
	uint64_t lines_written; /* to memory */
	uint64_t pages_missed;  /* not in a MicroTLB */
	uint64_t pages_walked;  /* nor in the main TLB */
};

struct memory {
	const struct params *params;
	struct memory_cache l1i, l1d, l2;
	struct pages pages;
	uint32_t random;
	int64_t miss_ends[MEMORY_MAX_MISSES];
	int64_t write_ends[MEMORY_MAX_WRITES];
	uint32_t next_write;
	uint32_t open_line; /* what the write buffer still gathers */
	bool is_open;
	int64_t l2_free, ddr_free;
	struct memory_counts counts;
};

/* 0 or -ENOMEM. */
int memory_init(struct memory *memory, const struct params *params);
void memory_finish(struct memory *memory);

/*
 * Empties caches, down to and with some level, and all queues. MEMORY_ALL
 * forgets all translations, MEMORY_PAGES those of data and nothing else.
 */
enum memory_level {
	MEMORY_ALL,
	MEMORY_DATA,
	MEMORY_L1_DATA,
	MEMORY_PAGES
};
void memory_flush(struct memory *memory, enum memory_level level);

/* When the line of a load that starts at cycle now arrives, beside a hit. */
struct memory_answer {
	int64_t delay;      /* cycles after those of a hit */
	enum cause cause;   /* of the delay */
	int64_t pipe_until; /* the load/store pipeline is stopped until then */
	enum cause pipe_cause;
};

struct memory_answer memory_load(
	struct memory *memory, uint32_t address, int64_t now);
struct memory_answer memory_preload(
	struct memory *memory, uint32_t address, int64_t now);
struct memory_answer memory_store(
	struct memory *memory, uint32_t address, int64_t now);

/* Cycles until the instructions of that line can issue. */
int64_t memory_fetch(struct memory *memory, uint32_t address, int64_t now);

#endif
