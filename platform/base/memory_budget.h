/*
 * A limit on the memory of things that belong together, such as a model and all
 * its instances.
 *
 * A function that allocates first takes the bytes from the budget, and gives
 * them back after freeing. An arena with a budget (arena.h) does so by itself.
 * Only one thread may use a budget at a time.
 */
#ifndef PLATFORM_BASE_MEMORY_BUDGET_H
#define PLATFORM_BASE_MEMORY_BUDGET_H

#include <stdbool.h>
#include <stddef.h>

#include "platform/base/log.h"

struct memory_budget {
	size_t limit_bytes;
	size_t used_bytes; /* at most limit_bytes */
	bool exceeded;     /* memory_budget_take() has refused bytes */
};

/*
 * Takes bytes from the budget. When fewer are left it sets exceeded and returns
 * false. A budget of NULL has no limit.
 */
bool memory_budget_take(struct memory_budget *budget, size_t bytes);

/* Gives back bytes that were taken. */
void memory_budget_give_back(struct memory_budget *budget, size_t bytes);

/*
 * Logs an error about what, a file or a part of it: it needs more memory than
 * the budget allows, or the machine has no memory left. Returns -ENOMEM.
 */
int memory_budget_fail(const struct memory_budget *budget, const char *what,
	const struct log *log);

#endif
