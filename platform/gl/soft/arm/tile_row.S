/*
 * tile_row.c for ARMv6: the same bytes. Offsets are those of struct tile_run.
 * A pixel of its own costs 23 instructions, two from fine 12, those in a patch
 * 45, or 60, and 3 for eight of them.
 */
#include "platform/gl/soft/arm/offsets.h"
	.syntax unified
	.arch armv6
	.arm
	.text

/*
 * Pixels in the patch of quad r12, this one and those that are inside as well,
 * one or two a step;
 * r2, r7, r8, r11, r12, lr are lost. The run's address is at sp + 12.
 */
	.macro	fill_patch by_two
	ldr	lr, [sp, #12]
	uxtb	r11, r12, ror #8
	uxtb	r12, r12
	add	lr, lr, #TILE_S_END
	ldm	lr, {r2, r7, r8, lr}
	ldr	r12, [r9, r12, lsl #3]
	ldr	r2, [r2, r11, lsl #4]
	ldr	r7, [r7, r11, lsl #4]
	sub	r2, r2, r3, lsl r10
	sub	r7, r7, r4, lsl r10
	eor	r2, r2, r5, asr #31
	eor	r7, r7, r6, asr #31
	umull	r11, r2, r8, r2
	umull	r11, r7, lr, r7
	cmp	r2, r7
	movhi	r2, r7
	.if	\by_two
	add	r11, r1, #1
	mov	r11, r11, lsr #1
	cmp	r2, r11
	subhs	r2, r11, #1
	.else
	cmp	r2, r1
	subhs	r2, r1, #1
	.endif
	add	r2, r2, #1
	mla	r3, r2, r5, r3
	mla	r4, r2, r6, r4
	.if	\by_two
	mov	r2, r2, lsl #1
	cmp	r2, r1
	movhi	r2, r1
	.endif
	sub	r1, r1, r2
	tst	r0, #2
	strhne	r12, [r0], #2
	subne	r2, r2, #1
	subs	r2, r2, #8
	mov	r7, r12
	blt	2f
	mov	r8, r12
	mov	lr, r12
1:	subs	r2, r2, #8
	stmia	r0!, {r7, r8, r12, lr}
	bge	1b
2:	tst	r2, #4
	stmiane	r0!, {r7, r12}
	tst	r2, #2
	strne	r12, [r0], #4
	tst	r2, #1
	strhne	r12, [r0], #2
	.endm

/*
 * r0 pixel, r1 count, r2 quads, r3 s, r4 t, r5, r6 their steps, r7 the columns'
 * mask, r8 the rows' where it lies in an index, r9 shade, r10 from 16.16 to
 * 2^32; the run's address is at sp.
 */
	.global	soft_tile_row
	.type	soft_tile_row, %function
soft_tile_row:
	push	{r0, r4-r11, lr}
	mov	r12, r0
	ldr	r9, [r0, #TILE_SHADE]
	ldr	r10, [r0, #TILE_WIDTH_LOG2]
	ldm	r12, {r0-r6}
	mov	r7, #1
	rsb	r7, r7, r7, lsl r10
	mov	r8, r7, lsl r10
	rsb	r10, r10, #16

.Lpixel:
	and	r12, r8, r4, lsr r10
	and	r11, r7, r3, lsr #16
	add	r12, r12, r11
	ldr	r12, [r2, r12, lsl #2]
	uxtb	lr, r3, ror #8
	cmp	r12, #0
	bmi	.Lpatch
	uxtb16	r11, r12
	uxtb16	r12, r12, ror #8
	sub	r12, r12, r11
	mul	r12, lr, r12
	uxtb	lr, r4, ror #8
	rsb	lr, lr, lr, lsl #16
	add	lr, lr, #256
	add	r12, r12, r11, lsl #8
	smuad	r12, r12, lr
	add	r3, r3, r5
	add	r4, r4, r6
	mov	r12, r12, lsr #15
	ldr	r12, [r9, r12, lsl #2]
	subs	r1, r1, #1
	strh	r12, [r0], #2
	bne	.Lpixel
	pop	{r0, r4-r11, pc}

.Lpatch:
	push	{r2, r7, r8}
	fill_patch 0
	pop	{r2, r7, r8}
	cmp	r1, #0
	bne	.Lpixel
	pop	{r0, r4-r11, pc}
	.size	soft_tile_row, . - soft_tile_row

/* The same, but r2 fine, and masks and r10, 4 less, are for its index. */
	.global	soft_tile_fine
	.type	soft_tile_fine, %function
soft_tile_fine:
	push	{r0, r4-r11, lr}
	mov	r12, r0
	ldr	r9, [r0, #TILE_SHADE]
	ldr	r10, [r0, #TILE_WIDTH_LOG2]
	ldm	r12, {r0-r6}
	ldr	r2, [r12, #TILE_FINE]
	mov	r7, #4
	rsb	r7, r7, r7, lsl r10
	orr	r7, r7, #3
	add	r10, r10, #2
	mov	r8, r7, lsl r10
	rsb	r10, r10, #14

.Lplace:
	and	r11, r7, r3, lsr #14
	and	r12, r8, r4, lsr r10
	add	r12, r12, r11
	ldrb	r12, [r2, r12]
	add	r3, r3, r5
	add	r4, r4, r6
	cmp	r12, #255
	beq	.Lwithin
	ldr	r12, [r9, r12, lsl #2]
	subs	r1, r1, #2
	strpl	r12, [r0], #4
	bgt	.Lplace
	strhmi	r12, [r0]
	pop	{r0, r4-r11, pc}

	/* the quad, whose index has neither's lower two bits */
.Lwithin:
	push	{r2, r7, r8}
	ldr	lr, [sp, #12]
	sub	r3, r3, r5
	sub	r4, r4, r6
	add	r10, r10, #4
	ldr	r2, [lr, #TILE_QUADS]
	mov	r7, r7, lsr #2
	and	r8, r7, r4, lsr #16
	ldr	lr, [lr, #TILE_WIDTH_LOG2]
	and	r7, r7, r3, lsr #16
	add	r12, r7, r8, lsl lr
	ldr	r12, [r2, r12, lsl #2]
	fill_patch 1
	pop	{r2, r7, r8}
	sub	r10, r10, #4
	cmp	r1, #0
	bne	.Lplace
	pop	{r0, r4-r11, pc}
	.size	soft_tile_fine, . - soft_tile_fine

	.section .note.GNU-stack, "", %progbits
