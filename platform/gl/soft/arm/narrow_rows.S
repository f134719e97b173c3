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

/*
 * A pixel: r1 the depth's address, r12 the depth, r2 z, r3 the packed colour.
 * Loads the next depth, which takes as long as the rest; 9 instructions, which
 * the jump to them knows.
 */
	.macro	pixel
	cmp	r2, r12, lsl #16
	ldrh	r12, [r1, #2]!
	movlo	lr, r2, lsr #16
	strhlo	lr, [r1, #-2]
	andlo	lr, r8, r3, ror #5
	add	r2, r2, r6
	orrlo	lr, lr, lr, lsr #16
	strhlo	lr, [r1, r9]
	add	r3, r3, r7
	.endm

/* The last of a row. */
	.macro	last_pixel
	cmp	r2, r12, lsl #16
	movlo	lr, r2, lsr #16
	strhlo	lr, [r1], #2
	andlo	lr, r8, r3, ror #5
	orrlo	lr, lr, lr, lsr #16
	strhlo	lr, [r1, r9]
	.endm

/* r2 rows, of 1 or more; leaves all at the row after them. */
	.global	soft_narrow_rows
	.type	soft_narrow_rows, %function
soft_narrow_rows:
	str	lr, [sp, #RETURN]
	ldr	r3, [sp, #CHUNK]
.Lsegment:
	cmp	r3, #0
	beq	.Lafresh
.Lrows:	cmp	r2, r3
	movle	r12, r2
	movgt	r12, r3
	ldr	r1, [sp, #STRIDE]
	sub	r2, r2, r12
	sub	r3, r3, r12
	strd	r2, [sp, #REST]
	mla	r1, r12, r1, r0
	str	r1, [sp, #END]

.Lrow:	mov	lr, r10, asr #16
	mla	r2, lr, r6, r4
	add	r1, r0, lr, lsl #1
	mla	r3, lr, r7, r5
	ldrh	r12, [r1]
	sub	lr, lr, r11, asr #16
	cmp	lr, #COLUMNS - 1
	addls	lr, lr, lr, lsl #3
	addls	pc, pc, lr, lsl #2
	b	.Lnext
	.rept	COLUMNS - 1
	pixel
	.endr
	last_pixel
.Lnext:	ldm	sp, {r1, r2, r3, r12, lr}
	add	r0, r0, r1
	ldr	r1, [sp, #END]
	add	r4, r4, r2
	add	r5, r5, r3
	add	r10, r10, r12
	add	r11, r11, lr
	cmp	r0, r1
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
	.size	soft_narrow_rows, . - soft_narrow_rows

	.section .note.GNU-stack, "", %progbits
