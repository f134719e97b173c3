/*
 * Internals of the decoder: decode.c hands coprocessors 10 and 11 to
 * decode_vfp.c, and the core's loads and stores to decode_memory.c.
 */
#ifndef TESTS_ARM1136_CORE_DECODE_PARTS_H
#define TESTS_ARM1136_CORE_DECODE_PARTS_H

#include "tests/arm1136/core/insn.h"

void insn_reads(struct insn *insn, unsigned int reg, enum need need);
void insn_writes(struct insn *insn, unsigned int reg, unsigned int latency);

/* Returns whether the instruction is one of the VFP's. */
bool insn_decode_vfp(struct insn *insn);

void insn_decode_single(struct insn *insn);    /* LDR, LDRB, STR, STRB */
void insn_decode_extra(struct insn *insn);     /* halfwords, signed, doubles */
void insn_decode_exclusive(struct insn *insn); /* LDREX, STREX, SWP */
void insn_decode_multiple(struct insn *insn);  /* LDM, STM */
void insn_decode_preload(struct insn *insn);

#endif
