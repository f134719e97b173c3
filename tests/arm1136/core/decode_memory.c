#include "tests/arm1136/core/decode_parts.h"

/* LSL #2, the only shift of an offset without extra cycles. */
#define LSL_2 (2u << 2)

/* Reads the base, offset and write-back of a single load or store. */
static void address(struct insn *insn, bool by_register, bool odd_shift)
{
	uint32_t n = insn_field(insn, 16, 4);
	bool pre = insn_bit(insn, 24);

	insn->base = (uint8_t)n;
	insn->writeback = !pre || insn_bit(insn, 21);
	insn->slow_address = by_register && (!insn_bit(insn, 23) || odd_shift);
	insn->issue = insn->slow_address ? 2 : 1;
	insn_reads(insn, n, insn->slow_address ? NEED_NORMAL : NEED_ADDRESS);
	if (by_register) {
		insn_reads(insn, insn_field(insn, 0, 4), NEED_ADDRESS);
	}
	if (insn->writeback) {
		insn_writes(insn, n, 1);
	}
}

static void load(struct insn *insn, uint32_t d)
{
	insn->unit = UNIT_LOAD;
	insn->value_rule = VALUE_LOAD;
	insn->list = (uint16_t)(1u << d);
	if (d == REG_PC) {
		insn->branch = insn->base == REG_SP && !insn->slow_address
			? BRANCH_POP
			: BRANCH_LOAD;
	}
}

static void store(struct insn *insn, uint32_t d)
{
	insn->unit = UNIT_STORE;
	insn->list = (uint16_t)(1u << d);
	insn_reads(insn, d, NEED_STORED);
}

void insn_decode_single(struct insn *insn)
{
	bool by_register = insn_bit(insn, 25);
	uint32_t shift = insn_field(insn, 5, 7); /* amount and kind */
	bool byte = insn_bit(insn, 22);

	insn->access_bytes = byte ? 1 : 4;
	address(insn, by_register, shift != 0 && shift != LSL_2);
	if (insn_bit(insn, 20)) {
		insn->extends = byte;
		load(insn, insn_field(insn, 12, 4));
	} else {
		store(insn, insn_field(insn, 12, 4));
	}
}

void insn_decode_extra(struct insn *insn)
{
	uint32_t d = insn_field(insn, 12, 4);
	uint32_t kind = insn_field(insn, 5, 2);

	address(insn, !insn_bit(insn, 22), false);
	if (insn_bit(insn, 20)) {
		insn->access_bytes = kind == 2 ? 1 : 2;
		insn->extends = true;
		load(insn, d);
	} else if (kind == 1) {
		insn->access_bytes = 2;
		store(insn, d);
	} else {
		insn->access_bytes = 8;
		if (kind == 2) {
			load(insn, d);
		} else {
			store(insn, d);
			insn_reads(insn, d + 1, NEED_STORED);
		}
		insn->list = (uint16_t)(3u << d);
	}
}

void insn_decode_exclusive(struct insn *insn)
{
	uint32_t width = insn_field(insn, 21, 2);
	uint32_t d = insn_field(insn, 12, 4);

	insn->base = (uint8_t)insn_field(insn, 16, 4);
	insn_reads(insn, insn->base, NEED_ADDRESS);
	insn->access_bytes = (uint8_t)(width == 3 ? 2
			: width == 2              ? 1
			: width == 1              ? 8
						  : 4);
	if (!insn_bit(insn, 23)) {
		insn->access_bytes = insn_bit(insn, 22) ? 1 : 4;
		insn->issue = 2;
		insn_reads(insn, insn_field(insn, 0, 4), NEED_NORMAL);
		load(insn, d);
		insn->value_rule = VALUE_LOST;
	} else if (insn_bit(insn, 20)) {
		load(insn, d);
		insn->list = (uint16_t)(width == 1 ? 3u << d : 1u << d);
	} else {
		store(insn, insn_field(insn, 0, 4));
		insn_writes(insn, d, 3);
	}
}

void insn_decode_multiple(struct insn *insn)
{
	uint32_t n = insn_field(insn, 16, 4);
	uint32_t list = insn_field(insn, 0, 16);

	insn->base = (uint8_t)n;
	insn->writeback = insn_bit(insn, 21);
	insn->list = (uint16_t)list;
	insn->access_bytes = 4;
	insn_reads(insn, n, NEED_ADDRESS);
	if (insn->writeback) {
		insn_writes(insn, n, 1);
	}
	if (!insn_bit(insn, 20)) {
		insn->unit = UNIT_STORE;
		return;
	}
	insn->unit = UNIT_LOAD;
	insn->value_rule = VALUE_LOAD;
	if (list >> REG_PC & 1) {
		insn->branch = n == REG_SP ? BRANCH_POP : BRANCH_LOAD;
	}
}

void insn_decode_preload(struct insn *insn)
{
	uint32_t shift = insn_field(insn, 5, 7);

	insn->unit = UNIT_PRELOAD;
	address(insn, insn_bit(insn, 25), shift != 0 && shift != LSL_2);
	insn->writeback = false;
}
