/*
 * A limit on the memory that belongs together, such as that of a model and all
 * its instances.
 *
 * Whoever allocates takes bytes from the budget first and gives them back after
 * freeing them. An arena with a budget (arena.h) does so by itself. A budget is
 * not for use by several threads at once.
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
 * Takes bytes; false, and exceeded is set, when fewer than that are left. A
 * budget of NULL has no limit.
 */
bool memory_budget_take(struct memory_budget *budget, size_t bytes);

/* Gives back bytes that were taken. */
void memory_budget_give_back(struct memory_budget *budget, size_t bytes);

/*
 * Logs that what (a file, or a place in it) needs more memory than the budget
 * allows, or that the machine has no more, whichever is the case. Returns
 * -ENOMEM.
 */
int memory_budget_fail(const struct memory_budget *budget, const char *what,
	const struct log *log);

#endif
