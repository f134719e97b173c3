#include "tests/arm1136/core/predict.h"

#include <string.h>

void predict_init(struct predict *predict, const struct params *params)
{
	memset(predict, 0, sizeof(*predict));
	predict->params = params;
}

static void push_return(struct predict *predict, uint32_t address)
{
	predict->return_top = (predict->return_top + 1) % PREDICT_RETURNS;
	predict->returns[predict->return_top] = address;
	if (predict->return_count < PREDICT_RETURNS) {
		predict->return_count++;
	}
}

static enum prediction predict_return(struct predict *predict, uint32_t next)
{
	uint32_t address = predict->returns[predict->return_top];

	if (predict->return_count == 0) {
		return PREDICT_NO_RETURN;
	}
	predict->return_count--;
	predict->return_top =
		(predict->return_top + PREDICT_RETURNS - 1) % PREDICT_RETURNS;
	return address == next ? PREDICT_RETURN : PREDICT_WRONG_RETURN;
}

/* The two instructions of an aligned doubleword share an entry. */
static struct predict_entry *entry_of(struct predict *predict, uint32_t pc)
{
	uint32_t mask = (uint32_t)predict->params->predictor - 1;

	return &predict->entry[pc >> 3 & mask];
}

/* A new branch enters as weakly predicted; the manual does not say how. */
static void learn(struct predict_entry *entry, uint32_t pc, bool taken)
{
	if (!entry->valid || entry->pc != pc) {
		*entry = (struct predict_entry){
			.pc = pc, .valid = true, .state = taken ? 2 : 1};
	} else if (taken && entry->state < 3) {
		entry->state++;
	} else if (!taken && entry->state > 0) {
		entry->state--;
	}
}

static enum prediction predict_direct(
	struct predict *predict, const struct insn *insn, bool taken)
{
	struct predict_entry *entry = entry_of(predict, insn->pc);
	bool is_known = entry->valid && entry->pc == insn->pc;
	bool guess = is_known ? entry->state >= 2
			      : !insn->conditional || insn->target <= insn->pc;

	learn(entry, insn->pc, taken);
	if (guess != taken) {
		return PREDICT_WRONG;
	}
	return is_known ? PREDICT_DYNAMIC : PREDICT_STATIC;
}

enum prediction predict_branch(
	struct predict *predict, const struct insn *insn, uint32_t next)
{
	bool taken = next != insn->pc + 4 || !insn->conditional;

	switch (insn->branch) {
	case BRANCH_CALL:
		if (taken) {
			push_return(predict, insn->pc + 4);
		}
		return predict_direct(predict, insn, taken);
	case BRANCH_DIRECT:
		return predict_direct(predict, insn, taken);
	case BRANCH_CALL_INDIRECT:
		if (taken) {
			push_return(predict, insn->pc + 4);
		}
		return PREDICT_NOT_BY_IT;
	case BRANCH_RETURN:
	case BRANCH_POP:
		return taken ? predict_return(predict, next) : PREDICT_NOT_BY_IT;
	default:
		return PREDICT_NOT_BY_IT;
	}
}
