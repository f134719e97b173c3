#include "tests/arm1136/core/memory.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#define L1_WAYS 4
#define L2_WAYS 8

static int cache_init(struct memory_cache *cache, int kib, uint32_t ways)
{
	uint32_t lines = ((uint32_t)kib * 1024) >> MEMORY_LINE_SHIFT;

	cache->ways = ways;
	cache->sets = lines / ways;
	cache->line = calloc(lines, sizeof(*cache->line));
	return cache->line ? 0 : -ENOMEM;
}

static void cache_empty(struct memory_cache *cache)
{
	memset(cache->line, 0,
		(size_t)cache->sets * cache->ways * sizeof(*cache->line));
}

static struct memory_line *set_of(
	const struct memory_cache *cache, uint32_t line)
{
	return cache->line + (size_t)(line & (cache->sets - 1)) * cache->ways;
}

static struct memory_line *cache_find(
	const struct memory_cache *cache, uint32_t line)
{
	struct memory_line *set = set_of(cache, line);

	for (uint32_t i = 0; i < cache->ways; i++) {
		if (set[i].valid && set[i].line == line) {
			return &set[i];
		}
	}
	return NULL;
}

/* Steps a linear feedback shift register, which the caches have, too. */
static uint32_t draw(struct memory *memory)
{
	uint32_t bit = memory->random & 1;

	memory->random = memory->random >> 1 ^ (bit ? 0xb400u : 0);
	return memory->random;
}

/* An invalid entry of the set, or a random one. */
static struct memory_line *cache_victim(
	struct memory *memory, const struct memory_cache *cache, uint32_t line)
{
	struct memory_line *set = set_of(cache, line);

	for (uint32_t i = 0; i < cache->ways; i++) {
		if (!set[i].valid) {
			return &set[i];
		}
	}
	return &set[draw(memory) & (cache->ways - 1)];
}

static int64_t later(int64_t a, int64_t b)
{
	return a > b ? a : b;
}

int memory_init(struct memory *memory, const struct params *params)
{
	int result;

	memset(memory, 0, sizeof(*memory));
	memory->params = params;
	memory->random = 0xace1;
	result = cache_init(&memory->l1i, params->l1i_kib, L1_WAYS);
	if (!result) {
		result = cache_init(&memory->l1d, params->l1d_kib, L1_WAYS);
	}
	if (!result) {
		result = cache_init(&memory->l2, params->l2_kib, L2_WAYS);
	}
	if (result) {
		memory_finish(memory);
	}
	return result;
}

void memory_finish(struct memory *memory)
{
	free(memory->l1i.line);
	free(memory->l1d.line);
	free(memory->l2.line);
	memory->l1i.line = memory->l1d.line = memory->l2.line = NULL;
}

void memory_flush(struct memory *memory, enum memory_level level)
{
	if (level == MEMORY_PAGES) {
		pages_forget_data(&memory->pages);
		return;
	}
	if (level == MEMORY_ALL) {
		pages_forget(&memory->pages);
	}
	cache_empty(&memory->l1d);
	if (level != MEMORY_L1_DATA) {
		cache_empty(&memory->l2);
	}
	if (level == MEMORY_ALL) {
		cache_empty(&memory->l1i);
	}
	memset(memory->miss_ends, 0, sizeof(memory->miss_ends));
	memset(memory->write_ends, 0, sizeof(memory->write_ends));
	memory->is_open = false;
	memory->l2_free = 0;
	memory->ddr_free = 0;
}

static int64_t write_to_ddr(struct memory *memory, int64_t now)
{
	int64_t start = later(now, memory->ddr_free);

	memory->ddr_free = start + memory->params->ddr_write;
	memory->counts.lines_written++;
	return memory->ddr_free;
}

/* L2 keeps a written line that it holds; other lines go on to memory. */
static int64_t write_line(struct memory *memory, uint32_t line, int64_t now)
{
	struct memory_line *entry = cache_find(&memory->l2, line);

	if (!entry) {
		return write_to_ddr(memory, now);
	}
	entry->dirty = true;
	memory->l2_free = later(now, memory->l2_free) + memory->params->l2_busy;
	return memory->l2_free;
}

/* Gives a line to the write buffer. Returns the cycle at which it accepts it. */
static int64_t buffer_line(struct memory *memory, uint32_t line, int64_t now)
{
	int64_t *slot = &memory->write_ends[memory->next_write];
	int64_t start = later(now, *slot);

	*slot = write_line(memory, line, start);
	memory->next_write =
		(memory->next_write + 1) % (uint32_t)memory->params->writes;
	return start;
}

/*
 * Returns the cycle at which the line arrives in L1, and sets *from to the
 * level that it comes from. L2 keeps a copy.
 */
static int64_t fill(
	struct memory *memory, uint32_t line, int64_t now, uint8_t *from)
{
	const struct params *params = memory->params;
	int64_t start = later(now, memory->l2_free);
	struct memory_line *entry = cache_find(&memory->l2, line);

	memory->l2_free = start + params->l2_busy;
	if (entry) {
		*from = CAUSE_L2;
		return start + params->l2;
	}
	memory->counts.l2_missed++;
	*from = CAUSE_DDR;
	entry = cache_victim(memory, &memory->l2, line);
	start = later(start, memory->ddr_free);
	memory->ddr_free = start + params->ddr_busy;
	if (entry->valid && entry->dirty) {
		write_to_ddr(memory, start);
	}
	*entry = (struct memory_line){.line = line, .valid = true};
	return start + params->ddr;
}

/*
 * Reads a line of a page table, whose address is not one of the program's.
 * Returns the cycle at which it arrives. L2 caches page tables.
 */
static int64_t read_table(struct memory *memory, uint32_t line, int64_t now)
{
	uint8_t from;

	return fill(memory, line, now, &from);
}

/* Returns the extra cycles that the translation of the address takes. */
static int64_t translate(struct memory *memory, enum pages_side side,
	uint32_t address, int64_t now)
{
	const uint32_t first_level = 1u << 30, second_level = 1u << 29;
	uint32_t page = address >> PAGES_SHIFT;
	int64_t done = now + memory->params->tlb;
	enum pages_found found;

	if (!memory->params->pages) {
		return 0;
	}
	found = pages_look_up(&memory->pages, side, page);
	if (found == PAGES_IN_MICRO) {
		return 0;
	}
	memory->counts.pages_missed++;
	if (found == PAGES_NOWHERE) {
		/* The first-level entry of the megabyte, then the page's. */
		done = read_table(memory, first_level | page >> 11, done);
		done = read_table(memory, second_level | page >> 3, done);
		memory->counts.pages_walked++;
	}
	return done - now;
}

/*
 * Translates the address of a load or store and returns the cycle at which that
 * is done. No later load or store passes one that awaits its page.
 */
static int64_t translate_data(struct memory *memory, uint32_t address,
	int64_t now, struct memory_answer *answer)
{
	int64_t delay = translate(memory, PAGES_DATA, address, now);

	if (delay > 0) {
		*answer = (struct memory_answer){
			.delay = delay,
			.cause = CAUSE_PAGE,
			.pipe_until = now + delay,
			.pipe_cause = CAUSE_PAGE,
		};
	}
	return now + delay;
}

/* Evicts a line from an L1 cache and starts to fill its entry, which it returns. */
static struct memory_line *allocate(struct memory *memory,
	struct memory_cache *cache, uint32_t line, int64_t now)
{
	struct memory_line *entry = cache_victim(memory, cache, line);
	struct memory_line old = *entry;

	*entry = (struct memory_line){.line = line, .valid = true};
	entry->arrives = fill(memory, line, now, &entry->from);
	if (old.valid && old.dirty) {
		buffer_line(memory, old.line, now);
	}
	return entry;
}

/* The entry of the miss that ends first, which holds the cycle of its end. */
static int64_t *free_miss(struct memory *memory)
{
	int64_t *first = &memory->miss_ends[0];

	for (int i = 1; i < memory->params->misses; i++) {
		if (memory->miss_ends[i] < *first) {
			first = &memory->miss_ends[i];
		}
	}
	return first;
}

static struct memory_line *start_miss(struct memory *memory, uint32_t line,
	int64_t now, struct memory_answer *answer)
{
	int64_t *slot = free_miss(memory);
	int64_t start = later(now, *slot);
	struct memory_line *entry = allocate(memory, &memory->l1d, line, start);

	if (start > now) {
		answer->pipe_until = start;
		answer->pipe_cause = CAUSE_MISSES;
	}
	*slot = entry->arrives;
	return entry;
}

struct memory_answer memory_load(
	struct memory *memory, uint32_t address, int64_t began)
{
	struct memory_answer answer = {.cause = CAUSE_LOAD};
	uint32_t line = address >> MEMORY_LINE_SHIFT;
	struct memory_line *entry;
	int64_t now;

	memory->counts.loads++;
	if (memory->params->ideal) {
		return answer;
	}
	now = translate_data(memory, address, began, &answer);
	entry = cache_find(&memory->l1d, line);
	if (!entry) {
		memory->counts.loads_missed++;
		/* Data just written to that line is sent first. */
		if (memory->is_open && memory->open_line == line) {
			buffer_line(memory, line, now);
			memory->is_open = false;
		}
		entry = start_miss(memory, line, now, &answer);
	} else if (entry->arrives > now) {
		memory->counts.loads_awaited++;
	}
	if (entry->arrives > now) {
		answer.delay = entry->arrives - began;
		answer.cause = (enum cause)entry->from;
	}
	return answer;
}

struct memory_answer memory_preload(
	struct memory *memory, uint32_t address, int64_t now)
{
	struct memory_answer answer = {.cause = CAUSE_LOAD};
	uint32_t line = address >> MEMORY_LINE_SHIFT;

	memory->counts.preloads++;
	if (!memory->params->ideal) {
		now = translate_data(memory, address, now, &answer);
	}
	if (memory->params->ideal || cache_find(&memory->l1d, line)) {
		memory->counts.preloads_dropped++;
	} else {
		start_miss(memory, line, now, &answer);
	}
	return answer;
}

struct memory_answer memory_store(
	struct memory *memory, uint32_t address, int64_t now)
{
	struct memory_answer answer = {.cause = CAUSE_WRITE_BUFFER};
	uint32_t line = address >> MEMORY_LINE_SHIFT;
	struct memory_line *entry;

	memory->counts.stores++;
	if (memory->params->ideal) {
		return answer;
	}
	now = translate_data(memory, address, now, &answer);
	entry = cache_find(&memory->l1d, line);
	if (entry) {
		entry->dirty = true;
		return answer;
	}
	memory->counts.stores_missed++;
	if (memory->is_open && memory->open_line == line) {
		return answer;
	}
	if (memory->is_open) {
		int64_t accepted = buffer_line(memory, memory->open_line, now);

		if (accepted > now) {
			answer.pipe_until = accepted;
			answer.pipe_cause = CAUSE_WRITE_BUFFER;
		}
	}
	memory->is_open = true;
	memory->open_line = line;
	return answer;
}

int64_t memory_fetch(struct memory *memory, uint32_t address, int64_t now)
{
	uint32_t line = address >> MEMORY_LINE_SHIFT;
	struct memory_line *entry;
	int64_t delay;

	if (memory->params->ideal) {
		return 0;
	}
	delay = translate(memory, PAGES_CODE, address, now);
	if (cache_find(&memory->l1i, line)) {
		return delay;
	}
	memory->counts.fetches_missed++;
	entry = allocate(memory, &memory->l1i, line, now + delay);
	return entry->arrives - now;
}
