#include "tests/arm1136/micro/cases.h"

	/* Manual, 16.3: the next instruction can use an ALU result. */
	CASE alu_independent, 16
	BEGIN
	.rept 8
	add r2, r0, #1
	add r3, r0, #2
	.endr
	END

	CASE alu_dependent, 16
	BEGIN
	.rept 16
	add r0, r0, #1
	.endr
	END

	/* A register that is shifted is read a cycle early. */
	CASE alu_shifted_early, 24
	BEGIN
	.rept 8
	add r2, r3, r4
	add r5, r6, r2, lsl #1
	.endr
	END

	CASE alu_beside_shift, 16
	BEGIN
	.rept 8
	add r2, r3, r4
	add r5, r2, r6, lsl #1
	.endr
	END

	/* A shift by register issues for two cycles; its result comes after 2. */
	CASE alu_shift_by_register, 16
	BEGIN
	.rept 4
	add r2, r3, r4, lsl r5
	add r6, r3, r4, lsl r5
	.endr
	END

	CASE alu_shift_by_register_dependent, 16
	BEGIN
	.rept 8
	mov r2, r2, lsl r3
	.endr
	END

	CASE alu_shift_distance_early, 16
	BEGIN
	.rept 4
	add r5, r6, r7
	mov r2, r3, lsl r5
	.endr
	END

	/* A shift by register reads Rn late: LDR 3 - 1, then 2 issue cycles. */
	CASE alu_shift_by_register_late_operand, 16
	BEGIN
	.rept 4
	ldr r2, [r0]
	add r3, r2, r4, lsl r5
	.endr
	END

	CASE alu_flags_and_conditions, 16
	BEGIN
	.rept 4
	cmp r2, r3
	movlt r4, r5
	addge r4, r4, #1
	adc r6, r6, r7
	.endr
	END

	/* Saturation takes one more stage. */
	CASE alu_saturating_dependent, 12
	BEGIN
	.rept 4
	qadd16 r2, r3, r4
	add r5, r2, r6
	.endr
	END

	CASE alu_parallel_dependent, 8
	BEGIN
	.rept 8
	sadd16 r2, r2, r4
	.endr
	END

	CASE alu_pack_early, 12
	BEGIN
	.rept 4
	add r2, r3, r4
	pkhtb r5, r6, r2, asr #16
	.endr
	END

	CASE alu_extend_early, 12
	BEGIN
	.rept 4
	add r2, r3, r4
	sxth r5, r2
	.endr
	END
