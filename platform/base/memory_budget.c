#include "platform/base/memory_budget.h"

#include <errno.h>

bool memory_budget_take(struct memory_budget *budget, size_t bytes)
{
	if (!budget) {
		return true;
	}
	if (bytes > budget->limit_bytes - budget->used_bytes) {
		budget->exceeded = true;
		return false;
	}
	budget->used_bytes += bytes;
	return true;
}

void memory_budget_give_back(struct memory_budget *budget, size_t bytes)
{
	if (budget) {
		budget->used_bytes -= bytes;
	}
}

int memory_budget_fail(const struct memory_budget *budget, const char *what,
	const struct log *log)
{
	bool small = budget && budget->limit_bytes < 1 << 20;

	if (!budget || !budget->exceeded) {
		log_error(log, "%s: there is not enough memory", what);
	} else {
		log_error(log,
			"%s: the model needs more than %zu %s of memory: allow more with --memory",
			what, budget->limit_bytes >> (small ? 10 : 20),
			small ? "KiB" : "MiB");
	}
	return -ENOMEM;
}
