#include "tests/arm1136/core/core_parts.h"

/* The memory cycle of a transfer, from 0 on, in which that word is moved. */
static int64_t memory_cycle(int word, uint32_t first_address)
{
	return (word + (int)(first_address >> 2 & 1)) / 2;
}

static uint32_t lowest_address(const struct access *access, int count)
{
	uint32_t lowest = access[0].address;

	for (int i = 1; i < count; i++) {
		if (access[i].address < lowest) {
			lowest = access[i].address;
		}
	}
	return lowest;
}

/* Cycles that the transfer occupies the load/store pipeline. */
static int64_t transfer_cycles(
	const struct insn *insn, uint32_t address, int words)
{
	int64_t cycles = memory_cycle(words - 1, address) + 1;

	if (words == 1 && (address & (insn->access_bytes - 1u))) {
		cycles = 2;
	}
	if (insn->branch != BRANCH_NONE && words > 1) {
		cycles++;
	}
	return cycles + (insn->slow_address ? 1 : 0);
}

static int words_of(const struct insn *insn)
{
	int words = insn->range_count ? insn->range_count
				      : __builtin_popcount(insn->list);

	return words ? words : 1;
}

/* A load or store in progress. memory.c is asked once for each of its lines. */
struct transfer {
	struct core *core;
	uint32_t address;            /* the lowest */
	uint32_t line;               /* the line accessed last */
	struct memory_answer answer; /* for that line */
	bool missed;                 /* a load had to wait for a line */
};

static void occupy(struct core *core, int64_t until, enum cause cause)
{
	core->memory_free = until;
	core->memory_cause = cause;
}

/* Occupies the pipeline while misses, writes or the page must be waited for. */
static void stop(struct core *core, const struct memory_answer *answer)
{
	if (answer->pipe_until > core->memory_free) {
		occupy(core, answer->pipe_until, answer->pipe_cause);
	}
}

static void transfer_word(struct transfer *transfer, const struct insn *insn,
	int word, int64_t at)
{
	uint32_t address = transfer->address + (uint32_t)word * 4;
	uint32_t line = address >> MEMORY_LINE_SHIFT;
	struct core *core = transfer->core;
	int64_t when = at + memory_cycle(word, transfer->address);

	if (line == transfer->line) {
		return;
	}
	transfer->line = line;
	if (insn->unit == UNIT_LOAD) {
		transfer->answer = memory_load(&core->memory, address, when);
		transfer->missed |= transfer->answer.delay > 0;
	} else {
		transfer->answer = memory_store(&core->memory, address, when);
	}
	stop(core, &transfer->answer);
}

static void load_word(struct core *core, const struct insn *insn,
	const struct transfer *transfer, unsigned int reg, int word, int64_t at)
{
	int64_t ready = at + 3 + memory_cycle(word, transfer->address) +
		transfer->answer.delay;
	enum cause maker = transfer->answer.delay > 0 ? transfer->answer.cause
						      : CAUSE_LOAD;

	if (insn->slow_address) {
		ready++;
	}
	if (reg >= REG_S0) {
		ready++;
	} else if (insn->extends) {
		ready += core->params->byte_extra;
	}
	if (insn->access_bytes <= 4 && words_of(insn) == 1 &&
		(transfer->address & (insn->access_bytes - 1u))) {
		ready++;
	}
	if (insn->branch != BRANCH_NONE) {
		ready++;
	}
	core_write_register(core, reg, ready, maker);
}

/* Transfers the registers of an instruction that issued at that cycle. */
static void move_registers(struct core *core, const struct insn *insn,
	struct transfer *transfer, int64_t at)
{
	int word = 0;

	for (unsigned int list = insn->list; list;) {
		unsigned int reg = insn_take_register(&list);

		transfer_word(transfer, insn, word, at);
		if (insn->unit == UNIT_STORE) {
			core->unlocked[reg] = at + 1 + (word + 1) / 2;
		} else if (reg != REG_PC) {
			load_word(core, insn, transfer, reg, word, at);
		}
		word++;
	}
	for (int i = 0; i < insn->range_count; i++) {
		unsigned int reg = insn->range_first + (unsigned int)i;

		transfer_word(transfer, insn, i, at);
		if (insn->unit == UNIT_STORE) {
			core->unlocked[reg] =
				at + 1 + memory_cycle(i, transfer->address);
		} else {
			load_word(core, insn, transfer, reg, i, at);
		}
	}
}

void core_wait_for_registers(
	const struct core *core, const struct insn *insn, struct issue *issue)
{
	bool many = (insn->list & (insn->list - 1)) != 0;

	for (unsigned int list = insn->list & ~(1u << REG_PC); list;) {
		unsigned int reg = insn_take_register(&list);

		if (insn->unit == UNIT_LOAD) {
			core_wait_to_write(core, issue, reg, 3);
		} else if (many) {
			issue_wait(issue, core->ready[reg],
				(enum cause)core->maker[reg]);
		}
	}
	for (int i = 0; i < insn->range_count; i++) {
		unsigned int reg = insn->range_first + (unsigned int)i;

		if (insn->unit == UNIT_LOAD) {
			core_wait_to_write(core, issue, reg, 0);
		} else {
			issue_wait(issue,
				core_operand_ready(core, reg, NEED_STORED),
				(enum cause)core->maker[reg]);
		}
	}
}

void core_execute_memory(struct core *core, struct insn *insn,
	const struct access *access, int access_count, int64_t at)
{
	int words = words_of(insn);
	struct transfer transfer = {.core = core, .line = UINT32_MAX};

	transfer.address = lowest_address(access, access_count);
	occupy(core, at + transfer_cycles(insn, transfer.address, words),
		CAUSE_MEMORY_PIPE);
	move_registers(core, insn, &transfer, at);
	/* An unaligned word or halfword can cross a line. */
	if (words == 1) {
		uint32_t last = transfer.address + insn->access_bytes - 1;

		if (last >> MEMORY_LINE_SHIFT != transfer.line) {
			transfer.address = last & ~3u;
			transfer_word(&transfer, insn, 0, at + 1);
		}
	}
	if (transfer.missed && core->counts_insns) {
		insn->counts.data_misses++;
	}
}

void core_execute_preload(struct core *core, const struct insn *insn, int64_t at)
{
	uint32_t address;
	struct memory_answer answer;

	occupy(core, at + 1, CAUSE_MEMORY_PIPE);
	if (!values_address(&core->values, insn, &address)) {
		core->memory.counts.preloads_unknown++;
		return;
	}
	answer = memory_preload(&core->memory, address, at);
	stop(core, &answer);
}
