#include "app/compare/cost/line_reads.h"

#include <stdbool.h>
#include <string.h>

enum {
	LINE_BYTES = 32,
	/* lines of an array's room; arrays do not begin in the same set */
	ARRAY_LINES = 1 << 27,
	ARRAY_OFFSET = 37
};

void line_reads_begin(struct line_reads *reads)
{
	memset(reads, 0, sizeof(*reads));
	reads->random = 0xace1;
}

/* Steps a linear feedback shift register, which the board's caches have, too. */
static uint32_t step(uint32_t random)
{
	return random >> 1 ^ (random & 1 ? 0xb400u : 0);
}

/* Returns whether the set has the line; if not, it takes a random one's place. */
static bool read_line(
	struct line_reads *reads, uint32_t *set, uint32_t ways, uint32_t line)
{
	uint32_t at = 0;

	while (at < ways && set[at] != line && set[at] != 0) {
		at++;
	}
	if (at < ways && set[at] == line) {
		return true;
	}
	if (at == ways) {
		reads->random = step(reads->random);
		at = reads->random & (ways - 1);
	}
	set[at] = line;
	return false;
}

void line_reads_add(struct line_reads *reads, uint32_t array, uint32_t index,
	uint32_t element_bytes)
{
	uint32_t line = 1 + array * (ARRAY_LINES + ARRAY_OFFSET) +
		(uint32_t)((uint64_t)index * element_bytes / LINE_BYTES);

	if (read_line(reads, reads->near[line % LINE_READS_NEAR_SETS],
		    LINE_READS_NEAR_WAYS, line)) {
		return;
	}
	if (read_line(reads, reads->far[line % LINE_READS_FAR_SETS],
		    LINE_READS_FAR_WAYS, line)) {
		reads->cached += 1.0;
	} else {
		reads->missed += 1.0;
	}
}
