#include "platform/base/json_memory.h"

#include <setjmp.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

/*
 * The allocations that jansson holds during a load: a hash set of their
 * addresses, with open addressing and linear probing.
 */
struct held {
	void **slot;  /* [room], NULL where it is free */
	size_t room;  /* a power of two, or 0 */
	size_t count; /* at most three quarters of room */
};

/* An allocator of jansson can reach static variables only. */
static bool failed;
static bool loading;
static struct held held;
static jmp_buf out_of_memory;

static size_t home_of(const struct held *table, const void *memory)
{
	uint64_t hash = (uint64_t)(uintptr_t)memory * 0x9e3779b97f4a7c15u;

	hash ^= hash >> 32;
	hash *= 0x9e3779b97f4a7c15u;
	return (size_t)(hash >> 32) & (table->room - 1);
}

static void insert(struct held *table, void *memory)
{
	size_t at = home_of(table, memory);

	while (table->slot[at]) {
		at = (at + 1) & (table->room - 1);
	}
	table->slot[at] = memory;
	table->count++;
}

static bool grow(void)
{
	struct held wider = {.room = held.room ? held.room * 2 : 1024};

	wider.slot = calloc(wider.room, sizeof(*wider.slot));
	if (!wider.slot) {
		return false;
	}
	for (size_t i = 0; i < held.room; i++) {
		if (held.slot[i]) {
			insert(&wider, held.slot[i]);
		}
	}
	free(held.slot);
	held = wider;
	return true;
}

/*
 * Removes an address from the set. Later entries of the same run move into the
 * hole if it lies between their home slot and their present one.
 */
static void forget(const void *memory)
{
	size_t mask = held.room - 1;
	size_t hole = held.room ? home_of(&held, memory) : 0;

	while (held.room && held.slot[hole] && held.slot[hole] != memory) {
		hole = (hole + 1) & mask;
	}
	if (!held.room || !held.slot[hole]) {
		return; /* it was allocated before the load began */
	}
	for (size_t at = (hole + 1) & mask; held.slot[at]; at = (at + 1) & mask) {
		size_t home = home_of(&held, held.slot[at]);

		if (((at - home) & mask) >= ((at - hole) & mask)) {
			held.slot[hole] = held.slot[at];
			hole = at;
		}
	}
	held.slot[hole] = NULL;
	held.count--;
}

static void *allocate(size_t size)
{
	void *memory = malloc(size);

	failed = failed || !memory;
	if (!loading) {
		return memory;
	}
	if (!failed && held.count >= held.room / 4 * 3) {
		failed = !grow();
	}
	if (failed) {
		free(memory);
		longjmp(out_of_memory, 1);
	}
	insert(&held, memory);
	return memory;
}

static void release(void *memory)
{
	if (loading && memory) {
		forget(memory);
	}
	free(memory);
}

void json_memory_begin(void)
{
	failed = false;
	json_set_alloc_funcs(allocate, release);
}

bool json_memory_ok(void)
{
	return !failed;
}

/* Ends a load. If it was abandoned, frees all memory that jansson held. */
static void end_load(bool abandoned)
{
	for (size_t i = 0; abandoned && i < held.room; i++) {
		free(held.slot[i]);
	}
	free(held.slot);
	held = (struct held){0};
	loading = false;
}

json_t *json_memory_load(
	const char *text, size_t size, size_t flags, json_error_t *error)
{
	json_t *volatile value = NULL;

	json_memory_begin();
	loading = true;
	if (setjmp(out_of_memory) == 0) {
		value = json_loadb(text, size, flags, error);
	}
	end_load(failed);
	return value;
}
