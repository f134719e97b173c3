/*
 * An arena allocator: many allocations, all released at once.
 *
 * A model lives in one arena, an instance in another. Blocks never move, so
 * pointers stay valid until arena_release(). Only a large allocation can be
 * freed on its own. AddressSanitizer sees what is read or written behind one.
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
	/* What the blocks are taken from, or NULL; it outlives the arena. */
	struct memory_budget *budget;
	/*
	 * The bytes of a block that small allocations share; one of an eighth
	 * of that or more gets a block of its own size. 0 means 64 KiB.
	 */
	size_t block_bytes;
};

/* Returns an empty arena. Allocates nothing yet. */
struct arena arena_empty(void);

/* Returns an empty arena that takes its blocks from a budget, which may be NULL. */
struct arena arena_within(struct memory_budget *budget);

/*
 * Makes an arena without a budget take its blocks from one, those that it has
 * included. The budget may lie in the arena. False if it is too small for them.
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
 * Frees an allocation of that many bytes, if it has a block of its own, as
 * large allocations have. A smaller one stays until arena_release().
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
