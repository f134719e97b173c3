#include "tests/arm1136/micro/cases.h"

	/* Manual, 16.2 and 16.10; every access hits L1. */
	CASE ldr_independent, 8
	BEGIN
	.rept 4
	ldr r2, [r0]
	ldr r3, [r0, #4]
	.endr
	END

	CASE ldr_use, 16
	BEGIN
	.rept 4
	ldr r2, [r0]
	add r3, r4, r2
	.endr
	END

	/* Two loads in a chain take five cycles. data holds its own address. */
	CASE ldr_to_address, 20
	BEGIN
	.rept 4
	ldr r2, [r0]
	ldr r3, [r2]
	.endr
	END

	CASE alu_to_address, 12
	BEGIN
	.rept 4
	add r2, r0, #4
	ldr r3, [r2]
	.endr
	END

	CASE ldr_to_multiplier, 20
	BEGIN
	.rept 4
	ldr r2, [r0]
	smuad r3, r2, r4
	.endr
	END

	CASE ldr_to_shift, 20
	BEGIN
	.rept 4
	ldr r2, [r0]
	add r3, r4, r2, lsl #2
	.endr
	END

	/* A stored register is read late. */
	CASE ldr_to_str, 12
	BEGIN
	.rept 4
	ldr r2, [r0, #4]
	str r2, [r0, #8]
	.endr
	END

	CASE alu_to_str, 8
	BEGIN
	.rept 4
	add r2, r3, r4
	str r2, [r0, #8]
	.endr
	END

	/* Bytes and halfwords take one more cycle (GCC's description). */
	CASE ldrb_use, 20
	BEGIN
	.rept 4
	ldrb r2, [r0]
	add r3, r4, r2
	.endr
	END

	CASE ldrsh_use, 20
	BEGIN
	.rept 4
	ldrsh r2, [r0]
	add r3, r4, r2
	.endr
	END

	/* The next load, and the ALU, can use a written-back base at once. */
	CASE ldr_post_indexed, 8
	BEGIN
	.rept 8
	ldr r2, [r0], #4
	.endr
	END

	CASE ldr_post_indexed_base_to_alu, 8
	BEGIN
	.rept 4
	ldr r2, [r0], #4
	add r3, r0, #4
	.endr
	END

	CASE ldr_register_offset, 8
	mov r3, #8
	BEGIN
	.rept 4
	ldr r2, [r0, r3]
	ldr r4, [r0, r3, lsl #2]
	.endr
	END

	/* Other shifts and negative registers: two issue cycles, result + 1. */
	CASE ldr_odd_shift, 8
	mov r3, #8
	BEGIN
	.rept 4
	ldr r2, [r0, r3, lsl #1]
	.endr
	END

	CASE ldr_negative_register_use, 20
	mov r3, #8
	BEGIN
	.rept 4
	ldr r2, [r1, -r3]
	add r4, r5, r2
	.endr
	END

	/* Two memory cycles each; the second of the last one does not count. */
	CASE ldr_unaligned, 7
	BEGIN
	.rept 4
	ldr r2, [r0, #1]
	.endr
	END

	CASE ldr_unaligned_use, 20
	BEGIN
	.rept 4
	ldr r2, [r0, #1]
	add r3, r4, r2
	.endr
	END

	CASE ldrd_aligned, 4
	BEGIN
	.rept 4
	ldrd r2, r3, [r0, #8]
	.endr
	END

	CASE ldrd_unaligned, 7
	BEGIN
	.rept 4
	ldrd r2, r3, [r0, #4]
	.endr
	END

	CASE ldrd_use_second, 16
	BEGIN
	.rept 4
	ldrd r2, r3, [r0, #8]
	add r4, r5, r3
	.endr
	END

	CASE ldrd_unaligned_use_second, 20
	BEGIN
	.rept 4
	ldrd r2, r3, [r0, #4]
	add r4, r5, r3
	.endr
	END

	/* A failed condition costs one cycle, and nothing waits for a result. */
	CASE ldr_condition_fails, 12
	cmp r0, r0
	BEGIN
	.rept 6
	ldrne r2, [r0]
	add r2, r2, #1
	.endr
	END

	/* Literals are loaded as data. */
	CASE ldr_literal_use, 8
	BEGIN
	.rept 2
	ldr r2, =0x12345678
	add r3, r4, r2
	.endr
	END
