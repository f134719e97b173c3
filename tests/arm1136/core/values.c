#include "tests/arm1136/core/values.h"

void values_forget(struct values *values)
{
	values->known = 0;
	values->fpscr = 0;
}

static void set(struct values *values, unsigned int reg, uint32_t value)
{
	if (reg < 15) {
		values->value[reg] = value;
		values->known |= 1u << reg;
	}
}

static void lose(struct values *values, unsigned int reg)
{
	if (reg < 15) {
		values->known &= ~(1u << reg);
	}
}

static bool get(const struct values *values, const struct insn *insn,
	unsigned int reg, uint32_t *out)
{
	if (reg == REG_PC) {
		*out = insn->pc + 8;
		return true;
	}
	*out = values->value[reg];
	return values->known >> reg & 1;
}

/*
 * Shifts by a constant. LSR #0 and ASR #0 encode shifts by 32. Returns false
 * for ROR #0, which encodes RRX: the carry is not known.
 */
static bool shift(uint32_t *value, unsigned int kind, unsigned int amount)
{
	switch (kind) {
	case 0:
		*value <<= amount;
		return true;
	case 1:
		*value = amount ? *value >> amount : 0;
		return true;
	case 2:
		*value = (uint32_t)((int32_t)*value >> (amount ? amount : 31));
		return true;
	default:
		*value = *value >> amount | *value << ((32 - amount) & 31);
		return amount != 0;
	}
}

static bool second_operand(
	const struct values *values, const struct insn *insn, uint32_t *out)
{
	if (insn->word >> 25 & 1) {
		unsigned int turn = insn_field(insn, 8, 4) * 2;
		uint32_t byte = insn_field(insn, 0, 8);

		*out = byte >> turn | byte << ((32 - turn) & 31);
		return true;
	}
	return get(values, insn, insn_field(insn, 0, 4), out) &&
		shift(out, insn_field(insn, 5, 2), insn_field(insn, 7, 5));
}

static bool compute(uint32_t opcode, uint32_t n, uint32_t m, uint32_t *out)
{
	switch (opcode) {
	case 0:
		*out = n & m;
		return true;
	case 1:
		*out = n ^ m;
		return true;
	case 2:
		*out = n - m;
		return true;
	case 3:
		*out = m - n;
		return true;
	case 4:
		*out = n + m;
		return true;
	case 12:
		*out = n | m;
		return true;
	case 13:
		*out = m;
		return true;
	case 14:
		*out = n & ~m;
		return true;
	case 15:
		*out = ~m;
		return true;
	default:
		return false;
	}
}

static void step_alu(struct values *values, const struct insn *insn)
{
	uint32_t opcode = insn_field(insn, 21, 4);
	uint32_t n = 0;
	uint32_t m;
	uint32_t result;
	bool moves = opcode == 13 || opcode == 15;

	if ((opcode & 0xc) == 8) {
		return;
	}
	if (second_operand(values, insn, &m) &&
		(moves || get(values, insn, insn_field(insn, 16, 4), &n)) &&
		compute(opcode, n, m, &result)) {
		set(values, insn_field(insn, 12, 4), result);
	} else {
		lose(values, insn_field(insn, 12, 4));
	}
}

static void step_multiply(struct values *values, const struct insn *insn)
{
	uint32_t m, s;
	uint32_t n = 0;
	bool adds = insn->word >> 21 & 1;

	if (get(values, insn, insn_field(insn, 0, 4), &m) &&
		get(values, insn, insn_field(insn, 8, 4), &s) &&
		(!adds || get(values, insn, insn_field(insn, 12, 4), &n))) {
		set(values, insn_field(insn, 16, 4), m * s + n);
	} else {
		lose(values, insn_field(insn, 16, 4));
	}
}

/* The offset that a single load or store adds to its base. */
static bool offset_of(
	const struct values *values, const struct insn *insn, uint32_t *out)
{
	bool single = insn_field(insn, 26, 2) == 1;
	bool constant =
		single ? !insn_field(insn, 25, 1) : insn_field(insn, 22, 1);
	bool known = true;

	if (!constant) {
		known = get(values, insn, insn_field(insn, 0, 4), out) &&
			(!single ||
				shift(out, insn_field(insn, 5, 2),
					insn_field(insn, 7, 5)));
	} else if (single) {
		*out = insn_field(insn, 0, 12);
	} else {
		*out = insn_field(insn, 8, 4) << 4 | insn_field(insn, 0, 4);
	}
	if (!insn_field(insn, 23, 1)) {
		*out = -*out;
	}
	return known;
}

/* LDM and STM: computes the base from the lowest address. */
static void step_base_multiple(struct values *values, const struct insn *insn,
	const struct access *access, uint32_t words)
{
	bool before = insn_field(insn, 24, 1);
	bool up = insn_field(insn, 23, 1);
	uint32_t low = access->address;
	uint32_t base = up ? low - (before ? 4 : 0)
			   : low + words * 4 - (before ? 0 : 4);

	if (insn->writeback) {
		base = up ? base + words * 4 : base - words * 4;
	}
	set(values, insn->base, base);
}

static void step_base_vfp(struct values *values, const struct insn *insn,
	const struct access *access)
{
	uint32_t bytes = insn_field(insn, 0, 8) * 4;
	bool before = insn_field(insn, 24, 1);
	bool up = insn_field(insn, 23, 1);
	uint32_t base = access->address;

	if (before && !insn->writeback) { /* FLD, FST */
		base = up ? base - bytes : base + bytes;
	} else if (!before && insn->writeback) {
		base += bytes;
	}
	set(values, insn->base, base);
}

static void step_base(struct values *values, const struct insn *insn,
	const struct access *access)
{
	uint32_t offset = 0;
	uint32_t group = insn_field(insn, 25, 3);
	bool pre = insn_field(insn, 24, 1);

	/* LDREX, STREX and SWP have no offset in that field. */
	if (insn->base == REG_PC || (group == 0 && insn_field(insn, 4, 4) == 9)) {
		return;
	}
	if (group == 4) {
		step_base_multiple(values, insn, access,
			(uint32_t)__builtin_popcount(insn->list));
		return;
	}
	if (group == 6) {
		step_base_vfp(values, insn, access);
		return;
	}
	if (!offset_of(values, insn, &offset)) {
		if (insn->writeback && pre) {
			set(values, insn->base, access->address);
		} else if (insn->writeback) {
			lose(values, insn->base);
		}
	} else if (pre) {
		set(values, insn->base,
			insn->writeback ? access->address
					: access->address - offset);
	} else {
		set(values, insn->base, access->address + offset);
	}
}

/* Compares the address that follows from a known base with the real one. */
static void check(struct values *values, const struct insn *insn,
	const struct access *access)
{
	uint32_t group = insn_field(insn, 25, 3);
	uint32_t base;
	uint32_t offset = 0;

	if (group > 3 || (group == 0 && insn_field(insn, 4, 4) == 9) ||
		!get(values, insn, insn->base, &base) ||
		(insn_field(insn, 24, 1) && !offset_of(values, insn, &offset))) {
		return;
	}
	values->foretold++;
	values->mistaken += base + offset != access->address;
}

static void step_loaded(struct values *values, const struct insn *insn,
	const struct access *access, int count)
{
	int index = 0;

	for (unsigned int list = insn->list; list;) {
		unsigned int reg = insn_take_register(&list);

		if (index < count && access[index].has_value &&
			insn->value_rule == VALUE_LOAD) {
			set(values, reg, access[index].value);
		} else {
			lose(values, reg);
		}
		index++;
	}
}

void values_step(struct values *values, const struct insn *insn,
	const struct access *access, int access_count)
{
	uint32_t fpscr;

	if (insn_is_memory(insn) && insn->unit != UNIT_PRELOAD) {
		if (access_count == 0) {
			return; /* the condition failed */
		}
		check(values, insn, access);
		step_base(values, insn, access);
		if (insn->unit == UNIT_LOAD) {
			step_loaded(values, insn, access, access_count);
		} else if (!insn->writeback && insn->output_count) {
			lose(values, insn->output[0].reg); /* STREX */
		}
		return;
	}
	if (insn->conditional) {
		for (int i = 0; i < insn->output_count; i++) {
			lose(values, insn->output[i].reg);
		}
		return;
	}
	switch (insn->value_rule) {
	case VALUE_ALU:
		step_alu(values, insn);
		break;
	case VALUE_MULTIPLY:
		step_multiply(values, insn);
		break;
	case VALUE_FROM_FPSCR:
		set(values, insn_field(insn, 12, 4), values->fpscr);
		break;
	case VALUE_TO_FPSCR:
		if (get(values, insn, insn_field(insn, 12, 4), &fpscr)) {
			values->fpscr = fpscr;
		}
		break;
	default:
		for (int i = 0; i < insn->output_count; i++) {
			lose(values, insn->output[i].reg);
		}
		break;
	}
	if (insn->branch == BRANCH_CALL) {
		set(values, REG_LR, insn->pc + 4);
	}
}

bool values_address(
	const struct values *values, const struct insn *insn, uint32_t *out)
{
	uint32_t base;
	uint32_t offset;

	if (!get(values, insn, insn->base, &base) ||
		!offset_of(values, insn, &offset)) {
		return false;
	}
	*out = base + offset;
	return true;
}
