#include "platform/base/arena.h"

#include "platform/base/memory_budget.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#ifndef __has_feature /* of clang */
#define __has_feature(feature) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || __has_feature(address_sanitizer)
#include <sanitizer/asan_interface.h>
#define RED_ZONE 16
#else
#define ASAN_POISON_MEMORY_REGION(memory, bytes)
#define ASAN_UNPOISON_MEMORY_REGION(memory, bytes)
#define RED_ZONE 0
#endif

/* So that each allocation can fail alone, tests/faults gives it its own block. */
#ifdef ARENA_SINGLE
#define SHARES_BLOCKS false
#else
#define SHARES_BLOCKS true
#endif

enum {
	ALIGNMENT = 16,
	BLOCK_BYTES = 64 * 1024,
	LARGE_PART = 8 /* of a block */
};

struct arena_block {
	struct arena_block *older;
	size_t capacity;
	size_t used;
	size_t pad; /* keeps data[] on a 16-byte boundary on 32-bit hosts */
	_Alignas(ALIGNMENT) unsigned char data[];
};

struct arena arena_empty(void)
{
	return (struct arena){0};
}

struct arena arena_within(struct memory_budget *budget)
{
	return (struct arena){.budget = budget};
}

static size_t block_bytes(size_t capacity)
{
	return (sizeof(struct arena_block) + capacity + ALIGNMENT - 1) &
		~(size_t)(ALIGNMENT - 1);
}

static size_t all_bytes(const struct arena *arena)
{
	size_t bytes = 0;

	for (const struct arena_block *block = arena->newest; block;
		block = block->older) {
		bytes += block_bytes(block->capacity);
	}
	return bytes;
}

bool arena_set_budget(struct arena *arena, struct memory_budget *budget)
{
	if (!memory_budget_take(budget, all_bytes(arena))) {
		return false;
	}
	arena->budget = budget;
	return true;
}

static size_t room(const struct arena_block *block)
{
	return block ? block->capacity - block->used : 0;
}

/*
 * Adds a block with room for the bytes; a large allocation gets a block of its
 * own. The block with the most room left stays the newest, which the next small
 * allocations use.
 */
static struct arena_block *grow(struct arena *arena, size_t bytes)
{
	size_t usual = arena->block_bytes ? arena->block_bytes : BLOCK_BYTES;
	bool shared = SHARES_BLOCKS && bytes < usual / LARGE_PART;
	size_t capacity = shared ? usual : bytes;
	size_t total = block_bytes(capacity);
	struct arena_block *block;

	if (!memory_budget_take(arena->budget, total)) {
		return NULL;
	}
	block = aligned_alloc(ALIGNMENT, total);
	if (!block) {
		memory_budget_give_back(arena->budget, total);
		return NULL;
	}
	memset(block, 0, total);
	ASAN_POISON_MEMORY_REGION(block->data, capacity);
	block->capacity = capacity;
	if (room(arena->newest) > capacity - bytes) {
		block->older = arena->newest->older;
		arena->newest->older = block;
	} else {
		block->older = arena->newest;
		arena->newest = block;
	}
	return block;
}

static size_t aligned(size_t bytes)
{
	return (bytes + ALIGNMENT - 1) & ~(size_t)(ALIGNMENT - 1);
}

void *arena_alloc(struct arena *arena, size_t count, size_t size)
{
	struct arena_block *block = arena->newest;
	size_t bytes;
	void *memory;

	if (size && count > (SIZE_MAX / 2) / size) {
		(void)memory_budget_take(arena->budget, SIZE_MAX);
		return NULL;
	}
	bytes = aligned(count * size);
	if (!block || room(block) < bytes + RED_ZONE) {
		block = grow(arena, bytes + RED_ZONE);
		if (!block) {
			return NULL;
		}
	}
	memory = block->data + block->used;
	ASAN_UNPOISON_MEMORY_REGION(memory, count * size);
	block->used += bytes + RED_ZONE;
	arena->used_bytes += bytes;
	return memory;
}

void arena_free(struct arena *arena, const void *memory, size_t bytes)
{
	struct arena_block **link = &arena->newest;

	while (*link && (*link)->data != (const unsigned char *)memory) {
		link = &(*link)->older;
	}
	if (*link && aligned(bytes) + RED_ZONE == (*link)->capacity) {
		struct arena_block *block = *link;

		*link = block->older;
		arena->used_bytes -= aligned(bytes);
		memory_budget_give_back(
			arena->budget, block_bytes(block->capacity));
		free(block);
	}
}

char *arena_strdup(struct arena *arena, const char *text)
{
	size_t bytes = strlen(text) + 1;
	char *copy = arena_alloc(arena, bytes, 1);

	if (copy) {
		memcpy(copy, text, bytes);
	}
	return copy;
}

void arena_release(struct arena *arena)
{
	/* The budget may lie in a block (model.c), so it may be freed already
	 * if there is no block. */
	if (arena->newest) {
		memory_budget_give_back(arena->budget, all_bytes(arena));
	}
	while (arena->newest) {
		struct arena_block *block = arena->newest;

		arena->newest = block->older;
		free(block);
	}
	arena->used_bytes = 0;
}
