#include "tests/arm1136/core/decode_parts.h"

/* The register that a four-bit field and an extra bit name. */
static uint8_t vfp_register(
	const struct insn *insn, unsigned int low, unsigned int extra, bool dbl)
{
	uint32_t field = insn_field(insn, low, 4);

	/* VFPv2 has sixteen doubles, so the extra bit must be zero. */
	return (uint8_t)(REG_S0 + field * 2 + (dbl ? 0 : insn_bit(insn, extra)));
}

static void reads(struct insn *insn, uint8_t reg, bool dbl, enum need need)
{
	insn_reads(insn, reg, need);
	if (dbl) {
		insn_reads(insn, reg + 1u, need);
	}
}

static void writes(struct insn *insn, uint8_t reg, bool dbl, unsigned int after)
{
	insn_writes(insn, reg, after);
	if (dbl) {
		insn_writes(insn, reg + 1u, after);
	}
}

/* busy and latency are those of table 4.17 of the VFP11 manual. */
static void arithmetic(struct insn *insn, enum vfp_form form, unsigned int busy,
	unsigned int latency)
{
	insn->vfp_form = (uint8_t)form;
	insn->busy = (uint8_t)busy;
	insn->vfp_latency = (uint8_t)latency;
}

/* FSITO, FTOSI: the integer is always in a single register. */
static void convert_integer(struct insn *insn, bool to_integer)
{
	bool dbl = insn->is_double;

	arithmetic(insn, VFP_SCALAR, 1, 8);
	insn->vfp_d = vfp_register(insn, 12, 22, to_integer ? false : dbl);
	insn->vfp_m = vfp_register(insn, 0, 5, to_integer ? dbl : false);
	reads(insn, insn->vfp_m, to_integer && dbl, NEED_NORMAL);
	writes(insn, insn->vfp_d, !to_integer && dbl, 8);
}

static void convert_precision(struct insn *insn)
{
	bool dbl = insn->is_double;

	arithmetic(insn, VFP_SCALAR, 1, 4);
	insn->vfp_d = vfp_register(insn, 12, 22, !dbl);
	reads(insn, insn->vfp_m, dbl, NEED_STORED);
	writes(insn, insn->vfp_d, !dbl, 4);
}

static void compare(struct insn *insn, bool with_zero)
{
	arithmetic(insn, VFP_SCALAR, 1, 4);
	reads(insn, insn->vfp_d, insn->is_double, NEED_NORMAL);
	if (!with_zero) {
		reads(insn, insn->vfp_m, insn->is_double, NEED_NORMAL);
	}
	insn_writes(insn, REG_FP_FLAGS, 4);
}

static void divide(struct insn *insn, enum vfp_form form)
{
	insn->unit = UNIT_VFP_DIVIDE;
	arithmetic(insn, form, insn->is_double ? 29 : 15,
		insn->is_double ? 33 : 19);
}

/* Operations of one operand, m; the field of operand n selects which. */
static void extension(struct insn *insn)
{
	bool n = insn_bit(insn, 7);

	switch (insn_field(insn, 16, 4)) {
	case 0:
		arithmetic(insn, VFP_ONE, 1, 4);
		break;
	case 1:
		if (n) {
			divide(insn, VFP_ONE);
		} else {
			arithmetic(insn, VFP_ONE, 1, 4);
		}
		break;
	case 4:
	case 5:
		compare(insn, insn_field(insn, 16, 4) == 5);
		break;
	case 7:
		convert_precision(insn);
		break;
	case 8:
		convert_integer(insn, false);
		break;
	case 12:
	case 13:
		convert_integer(insn, true);
		break;
	default:
		insn->unit = UNIT_UNKNOWN;
		break;
	}
}

static void data_operation(struct insn *insn)
{
	bool dbl = insn->is_double;
	uint32_t opcode = insn_bit(insn, 23) << 3 | insn_bit(insn, 21) << 2 |
		insn_bit(insn, 20) << 1 | insn_bit(insn, 6);

	insn->unit = UNIT_VFP;
	insn->vfp_d = vfp_register(insn, 12, 22, dbl);
	insn->vfp_n = vfp_register(insn, 16, 7, dbl);
	insn->vfp_m = vfp_register(insn, 0, 5, dbl);
	if (opcode <= 3) {
		arithmetic(insn, VFP_THREE, dbl ? 2 : 1, dbl ? 9 : 8);
	} else if (opcode <= 5) {
		arithmetic(insn, VFP_TWO, dbl ? 2 : 1, dbl ? 9 : 8);
	} else if (opcode <= 7) {
		arithmetic(insn, VFP_TWO, 1, 8);
	} else if (opcode == 8) {
		divide(insn, VFP_TWO);
	} else if (opcode == 15) {
		extension(insn);
	} else {
		insn->unit = UNIT_UNKNOWN;
	}
}

/* FMSR, FMRS, FMDLR and the like move one core register. */
static void move_one(struct insn *insn)
{
	bool to_core = insn_bit(insn, 20);
	uint32_t core = insn_field(insn, 12, 4);
	uint32_t opcode = insn_field(insn, 21, 3);
	uint8_t reg = vfp_register(insn, 16, 7, insn->is_double);

	insn->unit = UNIT_VFP_MOVE;
	if (opcode == 7) { /* FMXR, FMRX, FMSTAT */
		bool fpscr = insn_field(insn, 16, 4) == 1;

		if (to_core && core == REG_PC) {
			insn_reads(insn, REG_FP_FLAGS, NEED_STORED);
			insn_writes(insn, REG_FLAGS, 2);
			return;
		}
		insn->serializes_vfp = true;
		if (to_core) {
			insn_writes(insn, core, 2);
			insn->value_rule = fpscr ? VALUE_FROM_FPSCR : VALUE_LOST;
		} else {
			insn_reads(insn, core, NEED_NORMAL);
			insn_writes(insn, REG_FP_FLAGS, 4);
			insn->value_rule = fpscr ? VALUE_TO_FPSCR : VALUE_LOST;
		}
		return;
	}
	if (insn->is_double && opcode == 1) {
		reg++;
	}
	if (to_core) {
		insn_reads(insn, reg, NEED_STORED);
		insn_writes(insn, core, 2);
	} else {
		insn_reads(insn, core, NEED_NORMAL);
		insn_writes(insn, reg, 4);
	}
}

/* FMDRR, FMRRD, FMSRR, FMRRS. */
static void move_two(struct insn *insn)
{
	uint8_t reg = vfp_register(insn, 0, 5, insn->is_double);

	insn->unit = UNIT_VFP_MOVE;
	if (insn_bit(insn, 20)) {
		reads(insn, reg, true, NEED_STORED);
		insn_writes(insn, insn_field(insn, 12, 4), 2);
		insn_writes(insn, insn_field(insn, 16, 4), 2);
	} else {
		insn_reads(insn, insn_field(insn, 12, 4), NEED_NORMAL);
		insn_reads(insn, insn_field(insn, 16, 4), NEED_NORMAL);
		writes(insn, reg, true, 4);
	}
}

static void load_store(struct insn *insn)
{
	bool single = insn_bit(insn, 24) && !insn_bit(insn, 21);
	uint32_t words =
		single ? (insn->is_double ? 2 : 1) : insn_field(insn, 0, 8);

	insn->unit = insn_bit(insn, 20) ? UNIT_LOAD : UNIT_STORE;
	insn->base = (uint8_t)insn_field(insn, 16, 4);
	insn->writeback = !single && insn_bit(insn, 21);
	insn->access_bytes = 4;
	insn->range_first = vfp_register(insn, 12, 22, insn->is_double);
	/* FLDMX transfers a word more than its registers. */
	insn->range_count = (uint8_t)(insn->is_double ? words & ~1u : words);
	if (insn->range_count + insn->range_first > REG_COUNT) {
		insn->range_count = (uint8_t)(REG_COUNT - insn->range_first);
	}
	insn_reads(insn, insn->base, NEED_ADDRESS);
	if (insn->writeback) {
		insn_writes(insn, insn->base, 1);
	}
}

bool insn_decode_vfp(struct insn *insn)
{
	uint32_t group = insn_field(insn, 24, 4);
	uint32_t coprocessor = insn_field(insn, 8, 4);

	if ((coprocessor & 0xe) != 10 || group == 15) {
		return false;
	}
	insn->is_double = coprocessor == 11;
	if (group == 14) {
		if (insn_bit(insn, 4)) {
			move_one(insn);
		} else {
			data_operation(insn);
		}
	} else if (insn_field(insn, 21, 4) == 2) {
		move_two(insn);
	} else {
		load_store(insn);
	}
	return true;
}
