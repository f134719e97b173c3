#include "tests/arm1136/micro/cases.h"

	/* Manual, table 16-10. The last of a chain counts its issue only. */
	CASE mul_independent, 16
	BEGIN
	.rept 2
	mul r2, r6, r7
	mul r3, r6, r7
	mul r4, r6, r7
	mul r5, r6, r7
	.endr
	END

	/* The result comes after 4 and is read a cycle early: 7 x 5 + 2. */
	CASE mul_dependent, 37
	BEGIN
	.rept 8
	mul r2, r2, r3
	.endr
	END

	/* The accumulator is read late: 7 x 3 + 2. */
	CASE mla_chain, 23
	BEGIN
	.rept 8
	mla r2, r3, r4, r2
	.endr
	END

	CASE mul_to_alu, 20
	BEGIN
	.rept 4
	mul r2, r3, r4
	add r5, r2, r6
	.endr
	END

	CASE muls, 20
	BEGIN
	.rept 4
	muls r2, r3, r4
	.endr
	END

	CASE smlad_independent, 16
	BEGIN
	.rept 4
	smlad r2, r6, r7, r2
	smlad r3, r6, r7, r3
	smlad r4, r6, r7, r4
	smlad r5, r6, r7, r5
	.endr
	END

	/* The next accumulator can use the result after 2: 15 x 2 + 1. */
	CASE smlad_chain, 31
	BEGIN
	.rept 16
	smlad r2, r6, r7, r2
	.endr
	END

	CASE smlad_to_alu, 16
	BEGIN
	.rept 4
	smlad r2, r6, r7, r3
	add r4, r2, r5
	.endr
	END

	/* The result comes after 3 and is read early: 3 x 4 + 1. */
	CASE smuad_to_smuad, 13
	BEGIN
	.rept 4
	smuad r2, r2, r7
	.endr
	END

	CASE alu_to_smlad_early, 12
	BEGIN
	.rept 4
	add r6, r8, r9
	smlad r2, r6, r7, r3
	.endr
	END

	/* SMLAD reads a loaded accumulator at the normal stage. */
	CASE load_to_smlad_accumulator, 16
	BEGIN
	.rept 4
	ldr r2, [r0]
	smlad r3, r6, r7, r2
	.endr
	END

	CASE smlawb_chain, 15
	BEGIN
	.rept 8
	smlawb r2, r6, r7, r2
	.endr
	END

	CASE smlabb_and_smlatt_chain, 15
	BEGIN
	.rept 4
	smlabb r2, r6, r7, r2
	smlatt r2, r6, r7, r2
	.endr
	END

	CASE smulwt_independent, 8
	BEGIN
	.rept 4
	smulwt r2, r6, r7
	smulwt r3, r6, r7
	.endr
	END

	CASE smull_independent, 12
	BEGIN
	.rept 2
	smull r2, r3, r6, r7
	smull r4, r5, r6, r7
	.endr
	END

	CASE smull_low_to_alu, 20
	BEGIN
	.rept 4
	smull r2, r3, r6, r7
	add r4, r2, r5
	.endr
	END

	CASE smull_high_to_alu, 24
	BEGIN
	.rept 4
	smull r2, r3, r6, r7
	add r4, r3, r5
	.endr
	END

	CASE smlald_independent, 8
	BEGIN
	.rept 2
	smlald r2, r3, r6, r7
	smlald r4, r5, r6, r7
	.endr
	END

	/* The high half comes after 4 and is accumulated late: 3 x 3 + 2. */
	CASE smlald_chain, 11
	BEGIN
	.rept 4
	smlald r2, r3, r6, r7
	.endr
	END

	CASE smmul_to_alu, 20
	BEGIN
	.rept 4
	smmul r2, r6, r7
	add r3, r2, r4
	.endr
	END

	CASE usad8_to_alu, 16
	BEGIN
	.rept 4
	usad8 r2, r6, r7
	add r3, r2, r4
	.endr
	END
