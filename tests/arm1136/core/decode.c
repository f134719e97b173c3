#include "tests/arm1136/core/decode_parts.h"

#include <string.h>

/* The kernel's user helpers; the emulator shows each as one instruction. */
#define KERNEL_PAGE 0xffff0000u

void insn_reads(struct insn *insn, unsigned int reg, enum need need)
{
	if (reg != REG_PC) {
		insn->input[insn->input_count].reg = (uint8_t)reg;
		insn->input[insn->input_count].need = (uint8_t)need;
		insn->input_count++;
	}
}

void insn_writes(struct insn *insn, unsigned int reg, unsigned int latency)
{
	if (reg != REG_PC) {
		insn->output[insn->output_count].reg = (uint8_t)reg;
		insn->output[insn->output_count].latency = (uint8_t)latency;
		insn->output_count++;
	}
}

static void mark(struct insn *insn)
{
	uint32_t d = insn_field(insn, 12, 4);
	uint32_t same = d << 16 | d << 12 | d;

	if (insn->word == (0xe1800000 | same)) {
		insn->marker = MARKER_BEGIN;
	} else if (insn->word == (0xe0000000 | same)) {
		insn->marker = MARKER_END;
	} else if (insn->word == (0xe3c00000 | (same & ~0xfu))) {
		insn->marker = MARKER_FLUSH;
	}
	insn->marker_id = (uint8_t)d;
}

/* Which kind of branch a data-processing instruction is whose result is pc. */
static void data_processing_to_pc(struct insn *insn)
{
	bool is_move = insn_field(insn, 21, 4) == 13;

	if (is_move && !insn_bit(insn, 25) && insn_field(insn, 0, 12) == REG_LR) {
		insn->branch = BRANCH_RETURN;
	} else {
		insn->branch = BRANCH_INDIRECT;
	}
}

static void data_processing(struct insn *insn)
{
	uint32_t opcode = insn_field(insn, 21, 4);
	bool tests = (opcode & 0xc) == 8;
	bool moves = opcode == 13 || opcode == 15;
	uint32_t n = insn_field(insn, 16, 4);
	uint32_t d = insn_field(insn, 12, 4);
	uint32_t m = insn_field(insn, 0, 4);
	bool by_register = !insn_bit(insn, 25) && insn_bit(insn, 4);
	unsigned int latency = by_register ? 2 : 1;

	insn->unit = UNIT_ALU;
	insn->value_rule = by_register ? VALUE_LOST : VALUE_ALU;
	insn->issue = (uint8_t)latency;
	insn->sets_flags = insn_bit(insn, 20);
	if (!moves) {
		insn_reads(insn, n, by_register ? NEED_LATE : NEED_NORMAL);
	}
	if (by_register) {
		insn_reads(insn, m, NEED_NORMAL);
		insn_reads(insn, insn_field(insn, 8, 4), NEED_EARLY);
	} else if (!insn_bit(insn, 25)) {
		insn_reads(insn, m,
			insn_field(insn, 4, 8) ? NEED_EARLY : NEED_NORMAL);
	}
	/* ADC, SBC, RSC and RRX read the carry. */
	if ((opcode >= 5 && opcode <= 7) ||
		(!insn_bit(insn, 25) && insn_field(insn, 4, 8) == 6)) {
		insn_reads(insn, REG_FLAGS, NEED_NORMAL);
	}
	if (tests) {
		return;
	}
	if (d == REG_PC) {
		data_processing_to_pc(insn);
	}
	insn_writes(insn, d, latency);
	mark(insn);
}

/* Products: d is in bits 19-16, n in 15-12, s in 11-8, m in 3-0. */
static void product(struct insn *insn, unsigned int issue, unsigned int latency,
	bool accumulates, enum need need)
{
	insn->unit = UNIT_MULTIPLY;
	insn->issue = (uint8_t)issue;
	insn_reads(insn, insn_field(insn, 0, 4), NEED_EARLY);
	insn_reads(insn, insn_field(insn, 8, 4), NEED_EARLY);
	if (accumulates) {
		insn_reads(insn, insn_field(insn, 12, 4), need);
	}
	insn_writes(insn, insn_field(insn, 16, 4), latency);
}

/* Products of 64 bits; late_is_high: the accumulator's high half is read late. */
static void long_product(struct insn *insn, unsigned int issue,
	unsigned int latency, bool accumulates, bool late_is_high)
{
	uint32_t low = insn_field(insn, 12, 4);
	uint32_t high = insn_field(insn, 16, 4);

	insn->unit = UNIT_MULTIPLY;
	insn->issue = (uint8_t)issue;
	insn_reads(insn, insn_field(insn, 0, 4), NEED_EARLY);
	insn_reads(insn, insn_field(insn, 8, 4), NEED_EARLY);
	if (accumulates) {
		insn_reads(
			insn, low, late_is_high ? NEED_ACCUMULATOR : NEED_LATE);
		insn_reads(insn, high,
			late_is_high ? NEED_LATE : NEED_ACCUMULATOR);
	}
	insn_writes(insn, low, latency);
	insn_writes(insn, high, latency + 1);
}

static void multiply(struct insn *insn)
{
	uint32_t opcode = insn_field(insn, 21, 3);
	bool sets = insn_bit(insn, 20);

	switch (opcode) {
	case 0:
	case 1:
		product(insn, sets ? 5 : 2, 4, opcode == 1, NEED_LATE);
		insn->value_rule = VALUE_MULTIPLY;
		break;
	case 2: /* UMAAL */
		long_product(insn, 3, 4, true, false);
		break;
	case 3:
		insn->unit = UNIT_UNKNOWN;
		return;
	default:
		long_product(insn, sets ? 6 : 3, 4, opcode & 1, false);
		break;
	}
	insn->sets_flags = sets;
}

/* SMLAxy, SMLAWy, SMULWy, SMLALxy, SMULxy. */
static void halfword_multiply(struct insn *insn)
{
	switch (insn_field(insn, 21, 2)) {
	case 0:
		product(insn, 1, 3, true, NEED_ACCUMULATOR);
		break;
	case 1:
		product(insn, 1, 3, !insn_bit(insn, 5), NEED_ACCUMULATOR);
		break;
	case 2:
		long_product(insn, 2, 3, true, true);
		break;
	default:
		product(insn, 1, 3, false, NEED_NORMAL);
		break;
	}
}

static void alu(struct insn *insn, uint32_t d, unsigned int latency)
{
	insn->unit = UNIT_ALU;
	insn_writes(insn, d, latency);
}

static void saturating_add(struct insn *insn)
{
	bool doubles = insn_bit(insn, 22);

	alu(insn, insn_field(insn, 12, 4), doubles ? 3 : 2);
	insn->issue = doubles ? 2 : 1;
	insn_reads(insn, insn_field(insn, 0, 4), NEED_NORMAL);
	insn_reads(insn, insn_field(insn, 16, 4),
		doubles ? NEED_EARLY : NEED_NORMAL);
}

static void branch_register(struct insn *insn, bool call)
{
	uint32_t m = insn_field(insn, 0, 4);

	insn->unit = UNIT_BRANCH;
	insn_reads(insn, m, NEED_NORMAL);
	if (call) {
		insn->branch = BRANCH_CALL_INDIRECT;
		insn_writes(insn, REG_LR, 1);
	} else {
		insn->branch = m == REG_LR ? BRANCH_RETURN : BRANCH_INDIRECT;
	}
}

static void status_move(struct insn *insn)
{
	insn->unit = UNIT_SYSTEM;
	if (insn_bit(insn, 21)) {
		insn_reads(insn, insn_field(insn, 0, 4), NEED_NORMAL);
		insn->sets_flags = true;
	} else {
		insn_reads(insn, REG_FLAGS, NEED_NORMAL);
		insn_writes(insn, insn_field(insn, 12, 4), 1);
	}
}

/* Opcodes 10xx of data processing without S. */
static void miscellaneous(struct insn *insn)
{
	switch (insn_field(insn, 4, 4)) {
	case 0:
		status_move(insn);
		break;
	case 1:
		if (insn_field(insn, 21, 2) == 1) {
			branch_register(insn, false);
		} else {
			alu(insn, insn_field(insn, 12, 4), 1); /* CLZ */
			insn_reads(insn, insn_field(insn, 0, 4), NEED_NORMAL);
		}
		break;
	case 2:
		branch_register(insn, false);
		break;
	case 3:
		branch_register(insn, true);
		break;
	case 5:
		saturating_add(insn);
		break;
	default:
		if (insn_bit(insn, 7)) {
			halfword_multiply(insn);
		}
		break;
	}
}

/* Groups 000 and 001. */
static void data_group(struct insn *insn)
{
	bool immediate = insn_bit(insn, 25);

	if (!immediate && insn_field(insn, 4, 4) == 9) {
		if (insn_bit(insn, 24)) {
			insn_decode_exclusive(insn);
		} else {
			multiply(insn);
		}
	} else if (!immediate && insn_bit(insn, 7) && insn_bit(insn, 4)) {
		insn_decode_extra(insn);
	} else if (insn_field(insn, 23, 2) == 2 && !insn_bit(insn, 20)) {
		if (!immediate) {
			miscellaneous(insn);
		} else if (insn_bit(insn, 21)) {
			insn->unit = UNIT_SYSTEM; /* MSR, hints */
			insn->sets_flags = insn_bit(insn, 19);
		}
	} else {
		data_processing(insn);
	}
}

/* SADD16 and its family: prefix 1 S, 2 Q, 3 SH, 5 U, 6 UQ, 7 UH. */
static void parallel_add(struct insn *insn)
{
	uint32_t prefix = insn_field(insn, 20, 3);
	bool wraps = prefix == 1 || prefix == 5;

	alu(insn, insn_field(insn, 12, 4), wraps ? 1 : 2);
	insn_reads(insn, insn_field(insn, 16, 4), NEED_NORMAL);
	insn_reads(insn, insn_field(insn, 0, 4), NEED_NORMAL);
	insn->sets_flags = wraps; /* GE */
}

/* PKH, SEL, SSAT, USAT, SXT, REV. */
static void pack(struct insn *insn)
{
	uint32_t n = insn_field(insn, 16, 4);
	uint32_t m = insn_field(insn, 0, 4);
	uint32_t low = insn_field(insn, 5, 3);
	bool saturates = insn_bit(insn, 21) &&
		(!(low & 1) || (low == 1 && (insn_field(insn, 20, 2) == 2)));

	alu(insn, insn_field(insn, 12, 4), saturates ? 2 : 1);
	if (low == 5 && !insn_field(insn, 20, 3)) { /* SEL */
		insn_reads(insn, n, NEED_NORMAL);
		insn_reads(insn, m, NEED_NORMAL);
		insn_reads(insn, REG_FLAGS, NEED_NORMAL);
		return;
	}
	insn_reads(insn, m, saturates && low == 1 ? NEED_NORMAL : NEED_EARLY);
	if ((low == 3 && n != REG_PC) || (!insn_bit(insn, 21) && !(low & 1))) {
		insn_reads(insn, n, NEED_NORMAL); /* SXTA, PKH */
	}
}

/* SMLAD, SMLSD, SMLALD, SMLSLD, SMMLA, SMMLS. */
static void dual_multiply(struct insn *insn)
{
	bool accumulates = insn_field(insn, 12, 4) != REG_PC;

	switch (insn_field(insn, 20, 3)) {
	case 0:
		product(insn, 1, 3, accumulates, NEED_ACCUMULATOR);
		break;
	case 4:
		long_product(insn, 2, 3, true, true);
		break;
	case 5:
		product(insn, 2, 4, accumulates, NEED_LATE);
		break;
	default:
		insn->unit = UNIT_UNKNOWN;
		break;
	}
}

static void media(struct insn *insn)
{
	switch (insn_field(insn, 23, 2)) {
	case 0:
		parallel_add(insn);
		break;
	case 1:
		pack(insn);
		break;
	case 2:
		dual_multiply(insn);
		break;
	default:
		if (insn_field(insn, 20, 3) == 0) { /* USAD8, USADA8 */
			product(insn, 1, 3, insn_field(insn, 12, 4) != REG_PC,
				NEED_ACCUMULATOR);
		}
		break;
	}
}

static void branch(struct insn *insn, bool call)
{
	uint32_t offset = insn_field(insn, 0, 24);

	insn->unit = UNIT_BRANCH;
	insn->branch = call ? BRANCH_CALL : BRANCH_DIRECT;
	insn->target = insn->pc + 8 + (uint32_t)((int32_t)(offset << 8) >> 6);
	if (call) {
		insn_writes(insn, REG_LR, 1);
	}
}

/* Other coprocessors: CP15 holds the thread pointer. */
static void coprocessor(struct insn *insn)
{
	if (insn_field(insn, 24, 4) == 15) { /* SVC */
		insn->unit = UNIT_SYSTEM;
		insn_writes(insn, 0, 1);
	} else if (insn_field(insn, 24, 4) == 14 && insn_bit(insn, 4)) {
		insn->unit = UNIT_SYSTEM;
		if (insn_bit(insn, 20)) {
			insn_writes(insn, insn_field(insn, 12, 4), 3);
		} else {
			insn_reads(insn, insn_field(insn, 12, 4), NEED_NORMAL);
		}
	}
}

static void unconditional(struct insn *insn)
{
	if ((insn->word & 0xfd70f000) == 0xf550f000) {
		insn_decode_preload(insn);
	} else if ((insn->word & 0xfe000000) == 0xfa000000) {
		branch(insn, true);
	} else if ((insn->word & 0xfff00000) == 0xf5700000 ||
		(insn->word & 0xfff10020) == 0xf1000000) {
		insn->unit = UNIT_SYSTEM; /* CLREX and barriers, CPS */
	}
}

static void conditional(struct insn *insn)
{
	switch (insn_field(insn, 25, 3)) {
	case 0:
	case 1:
		data_group(insn);
		break;
	case 2:
		insn_decode_single(insn);
		break;
	case 3:
		if (insn_bit(insn, 4)) {
			media(insn);
		} else {
			insn_decode_single(insn);
		}
		break;
	case 4:
		insn_decode_multiple(insn);
		break;
	case 5:
		branch(insn, insn_bit(insn, 24));
		break;
	default:
		if (!insn_decode_vfp(insn)) {
			coprocessor(insn);
		}
		break;
	}
}

void insn_decode(struct insn *insn, uint32_t pc, uint32_t word)
{
	uint32_t condition = word >> 28;

	memset(insn, 0, sizeof(*insn));
	insn->pc = pc;
	insn->word = word;
	insn->unit = UNIT_UNKNOWN;
	insn->issue = 1;
	if (pc >= KERNEL_PAGE) {
		insn->unit = UNIT_SYSTEM;
		insn->branch = BRANCH_RETURN;
		insn->issue = 4;
		insn_writes(insn, 0, 3);
		insn_writes(insn, 3, 3);
		insn_writes(insn, 12, 3);
		return;
	}
	if (condition == 15) {
		unconditional(insn);
		return;
	}
	insn->conditional = condition != 14;
	conditional(insn);
	if (insn->unit == UNIT_UNKNOWN) {
		insn->input_count = 0;
		insn->output_count = 0;
		insn->branch = BRANCH_NONE;
	}
}
