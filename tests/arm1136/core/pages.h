/*
 * Address translation: the pages that the MicroTLBs and the main TLB hold.
 * Pages have 4 KiB, as Linux maps programs.
 */
#ifndef TESTS_ARM1136_CORE_PAGES_H
#define TESTS_ARM1136_CORE_PAGES_H

#include <stdbool.h>
#include <stdint.h>

#define PAGES_SHIFT 12
#define PAGES_MICRO 10
#define PAGES_SETS  32
#define PAGES_WAYS  2

enum pages_side {
	PAGES_CODE,
	PAGES_DATA,
	PAGES_SIDES
};

enum pages_found {
	PAGES_IN_MICRO,
	PAGES_IN_MAIN,
	PAGES_NOWHERE,
};

/* An entry is twice the number of a page plus 1, or 0 when it is empty. */
struct pages {
	uint32_t micro[PAGES_SIDES][PAGES_MICRO];
	uint32_t micro_next[PAGES_SIDES];
	uint32_t main[PAGES_SETS][PAGES_WAYS];
	uint32_t main_next[PAGES_SETS];
};

/* Returns where the page was; from then on both TLBs hold it. */
enum pages_found pages_look_up(
	struct pages *pages, enum pages_side side, uint32_t page);

/* Empties all TLBs but the MicroTLB of code; pages_forget() empties all. */
void pages_forget_data(struct pages *pages);
void pages_forget(struct pages *pages);

#endif
