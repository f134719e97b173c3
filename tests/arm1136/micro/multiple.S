#include "tests/arm1136/micro/cases.h"

	/*
	 * Manual, 16.12: one issue cycle, then half as many memory cycles as
	 * registers. The load behind it shows when the pipeline is free.
	 */
	.macro MULTIPLE op, offset, registers:vararg
	add r0, r0, #\offset
	BEGIN
	\op r0, {\registers}
	ldr r12, [r1]
	END
	.endm

	CASE ldm2_aligned, 2
	MULTIPLE ldmia, 0, r2-r3
	CASE ldm3_aligned, 3
	MULTIPLE ldmia, 0, r2-r4
	CASE ldm4_aligned, 3
	MULTIPLE ldmia, 0, r2-r5
	CASE ldm5_aligned, 4
	MULTIPLE ldmia, 0, r2-r6
	CASE ldm6_aligned, 4
	MULTIPLE ldmia, 0, r2-r7
	CASE ldm7_aligned, 5
	MULTIPLE ldmia, 0, r2-r8
	CASE ldm8_aligned, 5
	MULTIPLE ldmia, 0, r2-r9

	CASE ldm2_unaligned, 3
	MULTIPLE ldmia, 4, r2-r3
	CASE ldm3_unaligned, 3
	MULTIPLE ldmia, 4, r2-r4
	CASE ldm4_unaligned, 4
	MULTIPLE ldmia, 4, r2-r5
	CASE ldm5_unaligned, 4
	MULTIPLE ldmia, 4, r2-r6
	CASE ldm6_unaligned, 5
	MULTIPLE ldmia, 4, r2-r7
	CASE ldm7_unaligned, 5
	MULTIPLE ldmia, 4, r2-r8
	CASE ldm8_unaligned, 6
	MULTIPLE ldmia, 4, r2-r9

	CASE stm4_aligned, 3
	MULTIPLE stmia, 0, r2-r5
	CASE stm8_aligned, 5
	MULTIPLE stmia, 0, r2-r9
	CASE stm8_unaligned, 6
	MULTIPLE stmia, 4, r2-r9

	/* Examples of the manual. */
	CASE ldm7_use_third, 5
	BEGIN
	ldmia r0, {r2-r8}
	add r12, r12, r4
	END

	CASE stm7_lock, 5
	BEGIN
	stmia r0, {r2-r8}
	add r7, r12, r12
	END

	/* Results come after 3, 3, 4, 4, 5, 5; a product reads them early. */
	CASE ldm6_use_last, 6
	BEGIN
	ldmia r0, {r2-r7}
	add r12, r12, r7
	END

	CASE ldm6_unaligned_use_last, 7
	add r0, r0, #4
	BEGIN
	ldmia r0, {r2-r7}
	add r12, r12, r7
	END

	CASE ldm4_to_products, 8
	BEGIN
	ldmia r0, {r2-r5}
	smuad r6, r2, r2
	smuad r7, r3, r3
	smuad r8, r4, r4
	smuad r9, r5, r5
	END

	/* Instructions that need neither memory nor the results go on. */
	CASE ldm8_beside_alu, 5
	mov r12, #0
	BEGIN
	ldmia r0, {r2-r9}
	.rept 3
	add r12, r12, #1
	.endr
	ldr r1, [r1]
	END

	CASE ldm_write_back_chain, 9
	BEGIN
	.rept 4
	ldmia r0!, {r2-r5}
	.endr
	ldr r12, [r1]
	END

	/* STM begins when all of its registers are ready. */
	CASE ldr_to_stm, 4
	BEGIN
	ldr r3, [r1]
	stmia r0, {r2-r3}
	END
