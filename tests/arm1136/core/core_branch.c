#include "tests/arm1136/core/core_parts.h"

/* Cycles of branches; figures.md names the sources. */
enum {
	TAKEN_CYCLES = 4,
	RETURN_CYCLES = 4,
	RETURN_EMPTY_CYCLES = 5,
	RETURN_WRONG_CYCLES = 7,
	POP_WRONG_CYCLES = 9,
	WRONG_MIN_CYCLES = 5,
	WRONG_MAX_CYCLES = 7,
	INDIRECT_CYCLES = 5,
	LOAD_PC_CYCLES = 8
};

static int64_t mispredicted_cycles(const struct core *core, int64_t at)
{
	int64_t distance = at - core->flags_set - 1;
	int64_t cycles = WRONG_MAX_CYCLES - distance;

	return cycles > WRONG_MIN_CYCLES ? cycles : WRONG_MIN_CYCLES;
}

/* All cycles of a return, by BX lr or by a load of pc from the stack. */
static int64_t return_cycles(
	const struct core *core, const struct insn *insn, enum prediction how)
{
	bool pops = insn->branch == BRANCH_POP;

	if (insn->conditional) {
		return pops ? POP_WRONG_CYCLES
			    : mispredicted_cycles(core, core->now);
	}
	if (how == PREDICT_RETURN) {
		return RETURN_CYCLES;
	}
	if (pops) {
		return POP_WRONG_CYCLES;
	}
	return how == PREDICT_NO_RETURN ? RETURN_EMPTY_CYCLES
					: RETURN_WRONG_CYCLES;
}

static int64_t indirect_cycles(
	const struct core *core, const struct insn *insn, enum prediction how)
{
	int64_t cycles = INDIRECT_CYCLES;

	switch (insn->branch) {
	case BRANCH_RETURN:
	case BRANCH_POP:
		return return_cycles(core, insn, how);
	case BRANCH_LOAD:
		return LOAD_PC_CYCLES + (insn->slow_address ? 1 : 0);
	default:
		if (insn->conditional) {
			cycles = mispredicted_cycles(core, core->now);
		}
		return cycles + insn->issue - 1;
	}
}

int64_t core_branch_cycles(struct core *core, const struct insn *insn,
	const struct insn *next, int64_t at, enum cause *cause)
{
	enum prediction how = predict_branch(&core->predict, insn, next->pc);

	core->totals.branches++;
	if (how == PREDICT_DYNAMIC) {
		bool folds = core->params->fold &&
			insn->branch == BRANCH_DIRECT && !insn_is_branch(next);

		return folds ? 0 : 1;
	}
	if (how == PREDICT_STATIC) {
		*cause = CAUSE_TAKEN;
		return next->pc == insn->pc + 4 ? 1 : TAKEN_CYCLES;
	}
	if (how == PREDICT_WRONG) {
		core->totals.mispredicted++;
		*cause = CAUSE_MISPREDICT;
		return mispredicted_cycles(core, at);
	}
	*cause = CAUSE_INDIRECT;
	if (next->pc == insn->pc + 4 && insn->conditional) {
		return 1;
	}
	if (how == PREDICT_WRONG_RETURN) {
		core->totals.mispredicted++;
	}
	return indirect_cycles(core, insn, how);
}
