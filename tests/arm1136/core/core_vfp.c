#include "tests/arm1136/core/core_parts.h"

/* The register of an iteration of a short vector; it wraps in a bank of 8. */
static unsigned int iterate(const struct insn *insn, unsigned int reg,
	unsigned int iteration, unsigned int stride)
{
	unsigned int size = insn->is_double ? 2 : 1;
	unsigned int index = reg - REG_S0;
	unsigned int in_bank = index % 8 + iteration * stride * size;

	return REG_S0 + index / 8 * 8 + in_bank % 8;
}

/* The iterations of an operation: 1, or those of a short vector. */
struct vector {
	unsigned int length;
	unsigned int stride;   /* registers from one iteration to the next */
	unsigned int m_length; /* 1 when the second operand is a scalar */
};

static struct vector vector_of(const struct core *core, const struct insn *insn)
{
	struct vector vector = {1, 1, 1};

	/* A destination in the first bank is always a scalar. */
	if (insn->vfp_form != VFP_SCALAR && insn->vfp_d >= REG_S0 + 8) {
		vector.length = values_vector_length(&core->values);
		vector.stride = values_vector_stride(&core->values);
		vector.m_length = insn->vfp_m >= REG_S0 + 8 ? vector.length : 1;
	}
	return vector;
}

typedef void (*vfp_visit_t)(struct core *core, struct issue *issue,
	unsigned int reg, unsigned int iteration);

static void visit(struct core *core, const struct insn *insn,
	const struct vector *vector, unsigned int reg, unsigned int length,
	vfp_visit_t visitor, struct issue *issue)
{
	for (unsigned int i = 0; i < length; i++) {
		unsigned int first = iterate(insn, reg, i, vector->stride);

		visitor(core, issue, first, i);
		if (insn->is_double) {
			visitor(core, issue, first + 1, i);
		}
	}
}

static void visit_wait(struct core *core, struct issue *issue, unsigned int reg,
	unsigned int iteration)
{
	(void)iteration;
	issue_wait(issue, core->ready[reg], (enum cause)core->maker[reg]);
}

static void visit_wait_to_write(struct core *core, struct issue *issue,
	unsigned int reg, unsigned int iteration)
{
	(void)iteration;
	core_wait_to_write(core, issue, reg, 0);
}

static void visit_lock(struct core *core, struct issue *issue, unsigned int reg,
	unsigned int iteration)
{
	core->unlocked[reg] = issue->at + 1 + iteration;
}

static void visit_sources(struct core *core, const struct insn *insn,
	const struct vector *vector, vfp_visit_t visitor, struct issue *issue)
{
	visit(core, insn, vector, insn->vfp_m, vector->m_length, visitor, issue);
	if (insn->vfp_form != VFP_ONE) {
		visit(core, insn, vector, insn->vfp_n, vector->length, visitor,
			issue);
	}
	if (insn->vfp_form == VFP_THREE) {
		visit(core, insn, vector, insn->vfp_d, vector->length, visitor,
			issue);
	}
}

/* The first iteration waits for the registers of all iterations. */
void core_wait_for_vfp(
	struct core *core, const struct insn *insn, struct issue *issue)
{
	struct vector vector = vector_of(core, insn);

	if (insn->vfp_form != VFP_SCALAR) {
		visit_sources(core, insn, &vector, visit_wait, issue);
		visit(core, insn, &vector, insn->vfp_d, vector.length,
			visit_wait_to_write, issue);
	}
	issue_wait(issue, core->vfp_free, CAUSE_VFP_PIPE);
	if (insn->unit == UNIT_VFP_DIVIDE) {
		issue_wait(issue, core->divide_free, CAUSE_VFP_PIPE);
	}
}

void core_execute_vfp(struct core *core, const struct insn *insn, int64_t at)
{
	struct vector vector = vector_of(core, insn);
	struct issue issue = {.at = at};
	int64_t busy = (int64_t)insn->busy * vector.length;

	if (insn->unit == UNIT_VFP_DIVIDE) {
		/* The next operation issues after the last iteration has begun. */
		core->vfp_free = at + 1 + busy - insn->busy;
		core->divide_free = at + busy;
	} else {
		core->vfp_free = at + busy;
	}
	if (insn->vfp_form == VFP_SCALAR) {
		return;
	}
	visit_sources(core, insn, &vector, visit_lock, &issue);
	for (unsigned int i = 0; i < vector.length; i++) {
		unsigned int reg = iterate(insn, insn->vfp_d, i, vector.stride);
		int64_t ready = at + (int64_t)i * insn->busy + insn->vfp_latency;

		core_write_register(core, reg, ready, CAUSE_VFP);
		if (insn->is_double) {
			core_write_register(core, reg + 1, ready, CAUSE_VFP);
		}
	}
}
