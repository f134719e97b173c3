#include "tests/arm1136/core/core_parts.h"

#include <string.h>

/* A cycle before all others. */
#define NEVER (-1000)

int core_init(struct core *core, const struct params *params)
{
	memset(core, 0, sizeof(*core));
	core->params = params;
	core->flags_set = NEVER;
	core->fetched_line = UINT32_MAX;
	predict_init(&core->predict, params);
	return memory_init(&core->memory, params);
}

void core_finish(struct core *core)
{
	memory_finish(&core->memory);
}

void core_flush(struct core *core, enum memory_level level)
{
	memory_flush(&core->memory, level);
	core->fetched_line = UINT32_MAX;
}

struct core_totals core_totals(const struct core *core)
{
	struct core_totals totals = core->totals;

	totals.memory = core->memory.counts;
	totals.foretold = core->values.foretold;
	totals.mistaken = core->values.mistaken;
	return totals;
}

static void stall(
	struct core *core, struct insn *insn, enum cause cause, int64_t cycles)
{
	core->totals.stall[cause] += (uint64_t)cycles;
	if (core->counts_insns) {
		insn->counts.stall[cause] += (uint64_t)cycles;
	}
}

int64_t core_operand_ready(
	const struct core *core, unsigned int reg, enum need need)
{
	int64_t ready = core->ready[reg];

	switch (need) {
	case NEED_EARLY:
		return ready + 1;
	case NEED_ADDRESS:
		return core->base_ready[reg];
	case NEED_LATE:
		return ready - 1;
	case NEED_ACCUMULATOR:
		return core->maker[reg] == CAUSE_MULTIPLY ? ready - 1 : ready;
	case NEED_STORED:
		return reg >= REG_FP_FLAGS ? ready + 1 : ready - 1;
	default:
		return ready;
	}
}

static void wait_for_inputs(
	const struct core *core, const struct insn *insn, struct issue *issue)
{
	for (int i = 0; i < insn->input_count; i++) {
		unsigned int reg = insn->input[i].reg;

		issue_wait(issue,
			core_operand_ready(
				core, reg, (enum need)insn->input[i].need),
			(enum cause)core->maker[reg]);
	}
	/* A predicted branch does not wait for the flags. */
	if (insn->conditional && !insn_is_branch(insn)) {
		issue_wait(issue, core->ready[REG_FLAGS],
			(enum cause)core->maker[REG_FLAGS]);
	}
}

/* Waits for earlier instructions that still write, store or read the register. */
void core_wait_to_write(const struct core *core, struct issue *issue,
	unsigned int reg, int64_t latency)
{
	issue_wait(issue, core->unlocked[reg], CAUSE_LOCK);
	if (reg >= REG_S0) {
		issue_wait(issue, core->ready[reg], CAUSE_LOCK);
	} else {
		issue_wait(issue, core->ready[reg] - latency, CAUSE_LOCK);
	}
}

void core_write_register(
	struct core *core, unsigned int reg, int64_t ready, enum cause maker)
{
	core->ready[reg] = ready;
	core->maker[reg] = (uint8_t)maker;
	if (reg < 16) {
		core->base_ready[reg] = ready + 1;
	}
}

static enum cause maker_of(const struct insn *insn)
{
	switch (insn->unit) {
	case UNIT_MULTIPLY:
		return CAUSE_MULTIPLY;
	case UNIT_LOAD:
		return CAUSE_LOAD;
	case UNIT_VFP:
	case UNIT_VFP_DIVIDE:
	case UNIT_VFP_MOVE:
		return CAUSE_VFP;
	default:
		return CAUSE_ALU;
	}
}

static void write_outputs(struct core *core, const struct insn *insn, int64_t at)
{
	for (int i = 0; i < insn->output_count; i++) {
		unsigned int reg = insn->output[i].reg;

		core_write_register(core, reg, at + insn->output[i].latency,
			maker_of(insn));
		/* A load or store can use a written-back base at once. */
		if (insn_is_memory(insn) && reg == insn->base) {
			core->base_ready[reg] = at + insn->output[i].latency;
			core->maker[reg] = CAUSE_ALU;
		}
	}
	if (insn->sets_flags) {
		core->flags_set = at + insn->issue - 1;
		core_write_register(
			core, REG_FLAGS, at + insn->issue, CAUSE_ALU);
	} else if (insn->output_count && insn->output[0].reg == REG_FLAGS) {
		core->flags_set = at + insn->output[0].latency - 1;
	}
}

static void fetch(struct core *core, struct insn *insn)
{
	uint32_t line = insn->pc >> MEMORY_LINE_SHIFT;
	int64_t cycles;

	if (line == core->fetched_line) {
		return;
	}
	core->fetched_line = line;
	cycles = memory_fetch(&core->memory, insn->pc, core->now);
	stall(core, insn, CAUSE_FETCH, cycles);
	core->now += cycles;
}

static void wait_for_all(
	struct core *core, const struct insn *insn, struct issue *issue)
{
	wait_for_inputs(core, insn, issue);
	for (int i = 0; i < insn->output_count; i++) {
		core_wait_to_write(core, issue, insn->output[i].reg,
			insn->output[i].latency);
	}
	if (insn_is_memory(insn)) {
		core_wait_for_registers(core, insn, issue);
		issue_wait(issue, core->memory_free, core->memory_cause);
	}
	if (insn->unit == UNIT_VFP || insn->unit == UNIT_VFP_DIVIDE) {
		core_wait_for_vfp(core, insn, issue);
	}
	if (insn->serializes_vfp) {
		for (unsigned int reg = REG_S0; reg < REG_COUNT; reg++) {
			issue_wait(issue, core->ready[reg], CAUSE_VFP);
		}
		issue_wait(issue, core->vfp_free, CAUSE_VFP_PIPE);
		issue_wait(issue, core->divide_free, CAUSE_VFP_PIPE);
	}
}

static void execute(struct core *core, struct insn *insn,
	const struct access *access, int access_count, int64_t at)
{
	switch (insn->unit) {
	case UNIT_LOAD:
	case UNIT_STORE:
		core_execute_memory(core, insn, access, access_count, at);
		break;
	case UNIT_PRELOAD:
		core_execute_preload(core, insn, at);
		break;
	case UNIT_VFP:
	case UNIT_VFP_DIVIDE:
		core_execute_vfp(core, insn, at);
		break;
	case UNIT_UNKNOWN:
		core->totals.unknown++;
		break;
	default:
		break;
	}
	write_outputs(core, insn, at);
}

static bool condition_failed(const struct insn *insn, int access_count)
{
	return (insn->unit == UNIT_LOAD || insn->unit == UNIT_STORE) &&
		access_count == 0;
}

/* Advances the time by an issued instruction's cycles; all but one are stalls. */
static void advance(struct core *core, struct insn *insn,
	const struct insn *next, bool failed)
{
	int64_t cycles = failed ? 1 : insn->issue;
	enum cause cause = CAUSE_ISSUE;

	if (insn_is_branch(insn)) {
		cycles = core_branch_cycles(core, insn, next, core->now, &cause);
	}
	if (cycles == 0) {
		core->totals.folded++;
		insn->counts.folded += core->counts_insns;
		return;
	}
	stall(core, insn, cause, cycles - 1);
	core->now += cycles;
}

void core_step(struct core *core, struct insn *insn,
	const struct access *access, int access_count, const struct insn *next)
{
	int64_t began = core->now;
	bool failed = condition_failed(insn, access_count);
	struct issue issue = {.cause = CAUSE_ALU};

	fetch(core, insn);
	issue.at = core->now;
	if (failed) {
		issue_wait(&issue, core->ready[REG_FLAGS], CAUSE_ALU);
	} else {
		wait_for_all(core, insn, &issue);
	}
	stall(core, insn, issue.cause, issue.at - core->now);
	core->now = issue.at;
	if (!failed) {
		execute(core, insn, access, access_count, issue.at);
		values_step(&core->values, insn, access, access_count);
	}
	advance(core, insn, next, failed);
	core->totals.executed++;
	if (core->counts_insns) {
		insn->counts.executed++;
		insn->counts.cycles += (uint64_t)(core->now - began);
	}
}
