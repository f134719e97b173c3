/*
 * Counts the lines of memory that a sequence of reads takes from the board's
 * second-level cache and from memory, as the timing model's caches do
 * (tests/arm1136/core/memory.c): 16 KiB of four ways, 128 KiB of eight, lines
 * of 32 bytes. In a full set, a shift register chooses the line that is replaced,
 * so that the counts are the same on every machine. Both caches are empty at first.
 */
#ifndef APP_COMPARE_COST_LINE_READS_H
#define APP_COMPARE_COST_LINE_READS_H

#include <stdint.h>

enum {
	LINE_READS_NEAR_SETS = 128,
	LINE_READS_NEAR_WAYS = 4,
	LINE_READS_FAR_SETS = 512,
	LINE_READS_FAR_WAYS = 8
};

struct line_reads {
	double cached; /* lines that the second-level cache had */
	double missed; /* lines that came from memory */
	uint32_t random;
	/* the lines, as numbers from 1 on; 0: none */
	uint32_t near[LINE_READS_NEAR_SETS][LINE_READS_NEAR_WAYS];
	uint32_t far[LINE_READS_FAR_SETS][LINE_READS_FAR_WAYS];
};

void line_reads_begin(struct line_reads *reads);

/*
 * Reads element number index of an array; no element lies in two lines. Arrays
 * are told apart by their numbers, from 0 to 15.
 */
void line_reads_add(struct line_reads *reads, uint32_t array, uint32_t index,
	uint32_t element_bytes);

#endif
