/*
 * An arena allocator: many allocations, all released at once.
 *
 * A model lives in one arena, an instance in another. Blocks never move, so
 * pointers stay valid until arena_release(). Only a large allocation can be
 * freed on its own. AddressSanitizer reports accesses behind an allocation.
 */
#ifndef PLATFORM_BASE_ARENA_H
#define PLATFORM_BASE_ARENA_H

#include <stdbool.h>
#include <stddef.h>

struct arena_block;
struct memory_budget;

struct arena {
	struct arena_block *newest;
	size_t used_bytes; /* handed out, including alignment */
	/* The budget of the blocks' bytes, or NULL; it outlives the arena. */
	struct memory_budget *budget;
	/*
	 * The size of the blocks that small allocations share; 0 means 64 KiB.
	 * An allocation of at least an eighth of it gets a block of its own.
	 */
	size_t block_bytes;
};

/* Returns an empty arena. Allocates nothing yet. */
struct arena arena_empty(void);

/* Returns an empty arena that takes its blocks from a budget, which may be NULL. */
struct arena arena_within(struct memory_budget *budget);

/*
 * Gives a budget to an arena that has none: takes the bytes of the blocks that
 * the arena has from it, and later those of new blocks. The budget may lie in
 * the arena. Returns false if it is too small; the arena is then unchanged.
 */
bool arena_set_budget(struct arena *arena, struct memory_budget *budget);

/*
 * Allocates zeroed memory for count elements of size bytes, aligned to 16
 * bytes. Returns NULL when memory is short, the budget does not allow it or
 * count * size overflows. With a count of 0 the pointer is valid but must not
 * be dereferenced. The arena owns the memory.
 */
void *arena_alloc(struct arena *arena, size_t count, size_t size);

/*
 * Frees an allocation of that many bytes if it is large, that is, if it has a
 * block of its own. A smaller allocation stays until arena_release().
 */
void arena_free(struct arena *arena, const void *memory, size_t bytes);

/* Copies a string into the arena. Returns NULL when memory is short. */
char *arena_strdup(struct arena *arena, const char *text);

/* Releases all blocks and leaves the arena empty, with the same budget. */
void arena_release(struct arena *arena);

#define ARENA_NEW(arena, type) ((type *)arena_alloc((arena), 1, sizeof(type)))
#define ARENA_ARRAY(arena, type, count) \
	((type *)arena_alloc((arena), (size_t)(count), sizeof(type)))

#endif
