#include "tests/arm1136/program.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#define FIRST_ROOM 4096u

int program_init(struct program *program, const struct params *params)
{
	memset(program, 0, sizeof(*program));
	program->params = params;
	program->insn_capacity = FIRST_ROOM;
	program->insn = calloc(FIRST_ROOM, sizeof(struct insn *));
	return program->insn ? 0 : -ENOMEM;
}

void program_finish(struct program *program)
{
	for (size_t i = 0; i < program->insn_capacity; i++) {
		if (program->insn[i]) {
			free(program->insn[i]->text);
			free(program->insn[i]);
		}
	}
	free(program->insn);
	program->insn = NULL;
	program->insn_capacity = 0;
	symbols_finish(&program->symbols);
}

static struct insn **slot_of(struct insn **table, size_t capacity, uint32_t pc)
{
	size_t i = (pc >> 2) * 2654435761u & (capacity - 1);

	while (table[i] && table[i]->pc != pc) {
		i = (i + 1) & (capacity - 1);
	}
	return &table[i];
}

static bool grow(struct program *program)
{
	size_t capacity = program->insn_capacity * 2;
	struct insn **table = calloc(capacity, sizeof(struct insn *));

	if (!table) {
		return false;
	}
	for (size_t i = 0; i < program->insn_capacity; i++) {
		if (program->insn[i]) {
			*slot_of(table, capacity, program->insn[i]->pc) =
				program->insn[i];
		}
	}
	free(program->insn);
	program->insn = table;
	program->insn_capacity = capacity;
	return true;
}

struct insn *program_insn(
	struct program *program, uint32_t pc, uint32_t word, bool *is_new)
{
	struct insn **slot;

	*is_new = false;
	if (program->insn_count * 2 > program->insn_capacity && !grow(program)) {
		return NULL;
	}
	slot = slot_of(program->insn, program->insn_capacity, pc);
	if (*slot && (*slot)->word == word) {
		return *slot;
	}
	*is_new = true;
	if (!*slot) {
		*slot = malloc(sizeof(**slot));
		if (!*slot) {
			return NULL;
		}
		program->insn_count++;
	} else {
		free((*slot)->text);
	}
	insn_decode(*slot, pc, word);
	return *slot;
}

struct region *program_region(struct program *program, uint32_t pc, uint8_t id)
{
	struct region *region;

	for (size_t i = 0; i < program->region_count; i++) {
		if (program->region[i].pc == pc) {
			return &program->region[i];
		}
	}
	if (program->region_count == PROGRAM_MAX_REGIONS) {
		return NULL;
	}
	region = &program->region[program->region_count++];
	region->pc = pc;
	region->id = id;
	region->least = UINT64_MAX;
	return region;
}

/* struct core_totals consists of 64-bit counters alone. */
static void add_difference(void *sum, const void *before, const void *after)
{
	for (size_t i = 0; i < sizeof(struct core_totals) / sizeof(uint64_t);
		i++) {
		((uint64_t *)sum)[i] += ((const uint64_t *)after)[i] -
			((const uint64_t *)before)[i];
	}
}

void region_add(struct region *region, uint64_t cycles,
	const struct core_totals *before, const struct core_totals *after)
{
	if (region->entries++ == 0) {
		region->first = cycles;
	}
	region->last = cycles;
	region->least = cycles < region->least ? cycles : region->least;
	region->most = cycles > region->most ? cycles : region->most;
	region->cycles += cycles;
	add_difference(&region->totals, before, after);
}
