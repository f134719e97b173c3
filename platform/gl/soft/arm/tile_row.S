/*
 * tile_row.c for ARMv6, with the same results. A filtered pixel costs 23
 * instructions, one or two from fine 11; the pixels of a patch cost 45, with fine
 * 60, and 3 for every eight of them.
 */
#include "platform/gl/soft/arm/offsets.h"
	.syntax unified
	.arch armv6
	.arm
	.text

/*
 * Fills the pixels from this one on that lie in the patch of quad r12, one or two
 * a step. to_32 is a shift of coordinates that makes the texture 2^32 wide. r2,
 * r7, r8, r11, r12, lr are overwritten; the flags become those of r1, the pixels
 * left. At sp + 12 is the address of tile_run.s_end.
 */
	.macro	fill_patch by_two, to_32:vararg
	ldr	lr, [sp, #12]
	uxtb	r11, r12, ror #8
	uxtb	r12, r12
	ldm	lr, {r2, r7, r8, lr}
	ldr	r12, [r9, r12, lsl #3]
	ldr	r2, [r2, r11, lsl #4]
	ldr	r7, [r7, r11, lsl #4]
	sub	r2, r2, r3 \to_32
	sub	r7, r7, r4 \to_32
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
	subs	r2, r2, #16
	mov	r7, r12
	mov	r8, r12
	mov	lr, r12
	blt	2f
1:	subs	r2, r2, #16
	stmia	r0!, {r7, r8, r12, lr}
	stmia	r0!, {r7, r8, r12, lr}
	bge	1b
2:	tst	r2, #8
	stmiane	r0!, {r7, r8, r12, lr}
	tst	r2, #4
	stmiane	r0!, {r7, r12}
	tst	r2, #2
	strne	r12, [r0], #4
	tst	r2, #1
	strhne	r12, [r0], #2
	cmp	r1, #0
	.endm

/*
 * r0 pixel, r1 count, r2 quads, r3 s, r4 t, r5 and r6 their steps, r7 the columns'
 * mask, r8 the rows' mask shifted to its place in an index, r9 shade, r10 16 -
 * side_log2: the shift from 16.16 to 2^32; the address of tile_run.s_end is at sp.
 */
	.global	soft_tile_row
	.type	soft_tile_row, %function
soft_tile_row:
	cmp	r1, #1
	mov	r12, r0
	add	r0, r0, #TILE_S_END
	push	{r0, r4-r11, lr}
	ldr	r9, [r12, #TILE_SHADE]
	ldr	r10, [r12, #TILE_SIDE_LOG2]
	ldm	r12, {r0-r6}
	beq	.Lplaces
	bhi	.Lfine
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
	fill_patch 0, , lsl r10
	pop	{r2, r7, r8}
	bne	.Lpixel
	pop	{r0, r4-r11, pc}

/*
 * The same from fine, two pixels a step or one: r2 is fine; in r3 to r6, 2^32 is
 * the whole texture; r7 and r10 are shifts from there to the column, and to the
 * row at its place in an index, whose mask is r8.
 */
	.macro	from_fine by_two
	ldr	r2, [r12, #TILE_FINE]
	rsb	r7, r10, #16
	mov	r3, r3, lsl r7
	mov	r4, r4, lsl r7
	mov	r5, r5, lsl r7
	mov	r6, r6, lsl r7
	add	r7, r7, #14
	add	r11, r10, #2
	mov	r8, #1
	rsb	r8, r8, r8, lsl r11
	mov	r8, r8, lsl r11
	sub	r10, r7, r11

3:	and	r12, r8, r4, lsr r10
	add	r12, r12, r3, lsr r7
	ldrb	r12, [r2, r12]
	add	r3, r3, r5
	add	r4, r4, r6
	cmp	r12, #255
	beq	4f
	ldr	r12, [r9, r12, lsl #2]
	.if	\by_two
	subs	r1, r1, #2
	strpl	r12, [r0], #4
	bgt	3b
	strhmi	r12, [r0]
	.else
	subs	r1, r1, #1
	strh	r12, [r0], #2
	bne	3b
	.endif
	pop	{r0, r4-r11, pc}

	/* in a patch: finds the quad, which has the patch's number */
4:	push	{r2, r7, r8}
	ldr	lr, [sp, #12]
	sub	r3, r3, r5
	sub	r4, r4, r6
	ldr	r2, [lr, #TILE_QUADS - TILE_S_END]
	ldr	lr, [lr, #TILE_SIDE_LOG2 - TILE_S_END]
	add	r7, r7, #2
	mov	r8, r4, lsr r7
	mov	r8, r8, lsl lr
	add	r12, r8, r3, lsr r7
	ldr	r12, [r2, r12, lsl #2]
	fill_patch \by_two
	pop	{r2, r7, r8}
	bne	3b
	pop	{r0, r4-r11, pc}
	.endm

.Lplaces:
	from_fine 0
.Lfine:	from_fine 1
	.size	soft_tile_row, . - soft_tile_row

	.section .note.GNU-stack, "", %progbits
