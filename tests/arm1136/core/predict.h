/*
 * Branch prediction: a dynamic predictor for direct branches that were executed
 * before, a static one for the others (backward branches are taken), and a
 * stack of three return addresses.
 */
#ifndef TESTS_ARM1136_CORE_PREDICT_H
#define TESTS_ARM1136_CORE_PREDICT_H

#include "tests/arm1136/core/insn.h"
#include "tests/arm1136/core/params.h"

#define PREDICT_MAX_ENTRIES 1024
#define PREDICT_RETURNS     3

struct predict_entry {
	uint32_t pc;
	bool valid;
	uint8_t state; /* 0, 1 not taken; 2, 3 taken */
};

struct predict {
	const struct params *params;
	struct predict_entry entry[PREDICT_MAX_ENTRIES];
	uint32_t returns[PREDICT_RETURNS];
	uint32_t return_top;
	uint32_t return_count;
};

enum prediction {
	PREDICT_NOT_BY_IT, /* a computed branch, which no predictor predicts */
	PREDICT_DYNAMIC,   /* the dynamic predictor was right */
	PREDICT_STATIC,    /* the static predictor was right */
	PREDICT_RETURN,    /* the return stack was right */
	PREDICT_NO_RETURN, /* the return stack was empty */
	PREDICT_WRONG,     /* one of the predictors was wrong */
	PREDICT_WRONG_RETURN /* the return stack was wrong */
};

void predict_init(struct predict *predict, const struct params *params);

/*
 * Compares the prediction with next, the address to which the branch went, and
 * updates the predictors.
 */
enum prediction predict_branch(
	struct predict *predict, const struct insn *insn, uint32_t next);

#endif
