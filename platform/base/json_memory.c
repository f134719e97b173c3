#include "platform/base/json_memory.h"

#include <stddef.h>
#include <stdlib.h>

#include <jansson.h>

/* An allocator of jansson can reach static variables only. */
static bool failed;

static void *allocate(size_t size)
{
	void *memory = malloc(size);

	failed = failed || !memory;
	return memory;
}

void json_memory_begin(void)
{
	failed = false;
	json_set_alloc_funcs(allocate, free);
}

bool json_memory_ok(void)
{
	return !failed;
}
