/*
 * fill_narrow.c's draw_rows() for ARMv6: the same bytes. A row costs 15
 * instructions, a pixel 9, whether it is seen or not.
 */
#include "platform/gl/soft/arm/narrow.h"

	.syntax unified
	.arch armv6
	.arm
	.text

#define COLUMNS 24

/* r1 behind the depth, r2 z, r3 packed; the jump to them knows their 9. */
	.macro	see_pixel
	ldrh	r12, [r1], #2
	cmp	r2, r12, lsl #16
	movlo	r12, r2, lsr #16
	strhlo	r12, [r1, #-2]
	andlo	r12, r8, r3, ror #5
	orrlo	r12, r12, r12, lsr #16
	strhlo	r12, [r1, r9]
	.endm

/* r2 rows, of 1 or more; leaves all at the row after them. */
	.global	narrow_rows_arm
	.type	narrow_rows_arm, %function
narrow_rows_arm:
	str	lr, [sp, #RETURN]
	ldr	r3, [sp, #CHUNK]
.Lsegment:
	cmp	r3, #0
	beq	.Lafresh
.Lrows:	cmp	r2, r3
	movle	lr, r2
	movgt	lr, r3
	sub	r2, r2, lr
	sub	r3, r3, lr
	strd	r2, [sp, #REST]

.Lrow:	mov	r12, r10, asr #16
	mla	r2, r12, r6, r4
	mla	r3, r12, r7, r5
	add	r1, r0, r12, lsl #1
	sub	r12, r12, r11, asr #16
	cmp	r12, #COLUMNS - 1
	addls	r12, r12, r12, lsl #3
	addls	pc, pc, r12, lsl #2
	b	.Lnext
	.rept	COLUMNS - 1
	see_pixel
	add	r2, r2, r6
	add	r3, r3, r7
	.endr
	see_pixel
.Lnext:	ldm	sp, {r1, r2, r3, r12}
	add	r0, r0, r1
	ldr	r1, [sp, #RIGHT_STEP]
	add	r4, r4, r2
	add	r5, r5, r3
	add	r10, r10, r12
	add	r11, r11, r1
	subs	lr, lr, #1
	bne	.Lrow

	ldrd	r2, [sp, #REST]
	cmp	r2, #0
	bne	.Lsegment
	ldr	pc, [sp, #RETURN]

	/* The colour of this row, where the last one was 8 rows above. */
.Lafresh:
	ldr	r1, [sp, #RED]
	ldr	r3, [sp, #RED + 4]
	ldr	r12, [sp, #GREEN]
	ldr	lr, [sp, #GREEN + 4]
	add	r1, r1, r3, lsl #2
	str	r1, [sp, #RED]
	ldr	r3, [sp, #BLUE]
	ldr	r5, [sp, #BLUE + 4]
	add	r12, r12, lr, lsl #2
	str	r12, [sp, #GREEN]
	add	r3, r3, r5, lsl #2
	str	r3, [sp, #BLUE]
	mov	r1, r1, asr #12
	mov	r12, r12, asr #12
	mov	r3, r3, asr #13
	ldr	lr, [sp, #COLUMN]
	add	r3, r3, r1, lsl #10
	add	r3, r3, r12, lsl #21
	mla	r5, r7, lr, r3
	mov	r3, #8
	b	.Lrows
	.size	narrow_rows_arm, . - narrow_rows_arm

	.section .note.GNU-stack, "", %progbits
