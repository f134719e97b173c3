#include "tests/arm1136/core/pages.h"

#include <string.h>

static bool holds(const uint32_t *entry, uint32_t count, uint32_t tag)
{
	for (uint32_t i = 0; i < count; i++) {
		if (entry[i] == tag) {
			return true;
		}
	}
	return false;
}

/*
 * Replaces entries in turn. The MicroTLBs have such a mode; for the main TLB it
 * is an assumption.
 */
static void replace(
	uint32_t *entry, uint32_t count, uint32_t *next, uint32_t tag)
{
	entry[*next] = tag;
	*next = (*next + 1) % count;
}

enum pages_found pages_look_up(
	struct pages *pages, enum pages_side side, uint32_t page)
{
	uint32_t tag = page << 1 | 1;
	uint32_t set = page % PAGES_SETS;
	bool in_main;

	if (holds(pages->micro[side], PAGES_MICRO, tag)) {
		return PAGES_IN_MICRO;
	}
	replace(pages->micro[side], PAGES_MICRO, &pages->micro_next[side], tag);
	in_main = holds(pages->main[set], PAGES_WAYS, tag);
	if (!in_main) {
		replace(pages->main[set], PAGES_WAYS, &pages->main_next[set],
			tag);
	}
	return in_main ? PAGES_IN_MAIN : PAGES_NOWHERE;
}

void pages_forget_data(struct pages *pages)
{
	memset(pages->micro[PAGES_DATA], 0, sizeof(pages->micro[PAGES_DATA]));
	memset(pages->main, 0, sizeof(pages->main));
}

void pages_forget(struct pages *pages)
{
	memset(pages, 0, sizeof(*pages));
}
