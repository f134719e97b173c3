/*
 * fill_flat.c for ARMv6, of small triangles that a stencil lets draw each pixel
 * once: the same bytes. Offsets are those of struct fast_setup, struct setup and
 * struct flat_band.
 *
 * A triangle costs 75 instructions, a row 13, a pixel 14, or 6 unseen.
 */
#include "platform/gl/soft/arm/offsets.h"
#include "platform/gl/soft/arm/edge.h"
#include "platform/gl/soft/arm/blend_565.h"

	.syntax unified
	.arch armv6
	.arm
	.text

/* the stack; the first four are what a row adds to r0, r1, r5, r6 */
#define STENCIL_STRIDE 4
#define LEFT_STEP 8
#define RIGHT_STEP 12
#define LATER 16
#define SIDE 20
#define ROOM 28
/* and what is pushed first */
#define DRAW 28
#define SECOND 32
#define THIRD 36
#define MIDDLE 40

	.global	soft_fill_masked
	.type	soft_fill_masked, %function
soft_fill_masked:
	ldr	r2, [r1, #SETUP_FLAGS]
	tst	r2, #1 << 16
	beq	soft_fill_flat
	push	{r4-r11, lr}
	add	r1, r1, #SETUP_XY
	ldm	r1, {r4-r9}
	bl	.Lsorted
	pop	{r4-r11, pc}

/*
 * r0 draw, r4, r5, r6 struct cache_tag's xy by y, r7 to r9 the rows top, middle and
 * bottom; leaves r10 and r11.
 */
.Lsorted:
	push	{r0, r5, r6, r8, r10, r11, lr}
	sub	sp, sp, #ROOM
	ldr	lr, [r0, #FAST_SETUP_INVERSE]
	ldr	r0, [r0, #FAST_SETUP_FLAT]
	ssub16	r2, r5, r4
	ssub16	r3, r6, r4
	smusdx	r10, r2, r3
	mov	r1, r4
	mov	r2, r6
	mov	r3, r7
	find_edge
	str	r10, [sp, #SIDE]
	mov	r11, r1
	cmp	r10, #0
	strge	r2, [sp, #LEFT_STEP]
	strlt	r2, [sp, #RIGHT_STEP]

	/* the upper part, or the lower one where that is all; r9 its rows */
	sub	r3, r9, r8
	subs	r9, r8, r7
	moveq	r9, r3
	moveq	r3, #0
	moveq	r4, r5
	moveq	r5, r6
	str	r3, [sp, #LATER]
	mov	r1, r4
	mov	r2, r5
	mov	r3, r7
	find_edge
	ldr	r12, [sp, #DRAW]
	cmp	r10, #0
	strlt	r2, [sp, #LEFT_STEP]
	strge	r2, [sp, #RIGHT_STEP]
	movlt	r5, r1
	movlt	r6, r11
	movge	r5, r11
	movge	r6, r1

	ldrd	r2, [r12, #FAST_SETUP_STENCIL]
	ldrd	r10, [r12, #FAST_SETUP_DEPTH]
	ldr	r12, [r12, #FAST_SETUP_PIXELS]
	str	r3, [sp, #STENCIL_STRIDE]
	str	r11, [sp]
	mla	r1, r7, r3, r2
	mla	r10, r7, r11, r10
	ldrb	r8, [r0, #FLAT_NEXT]
	ldrb	r7, [r0, #FLAT_REFERENCE]
	add	r10, r10, #2
	ldr	r3, [r0, #FLAT_KEEP]
	ldr	r4, [r0, #FLAT_KEEP + 4]
	ldr	r2, =0x07E0F81F
	add	r0, r10, r12

	/* r0 pixels and r1 stencil of column 0, r5, r6 edges */
.Lrow:	mov	r11, r5, asr #16
	rsbs	r10, r11, r6, asr #16
	ble	.Lnext
	add	lr, r1, r11
	add	r11, r0, r11, lsl #1
1:	ldrb	r12, [lr], #1
	cmp	r12, r7
	addne	r11, r11, #2
	bne	2f
	ldrh	r12, [r11]
	strb	r8, [lr, #-1]
	mix_wide r12, r3, r4, r2
	strh	r12, [r11], #2
2:	subs	r10, r10, #1
	bne	1b
.Lnext:	ldm	sp, {r10, r11, r12, lr}
	add	r0, r0, r10
	add	r1, r1, r11
	add	r5, r5, r12
	add	r6, r6, lr
	subs	r9, r9, #1
	bne	.Lrow

	ldr	r9, [sp, #LATER]
	ldr	lr, [sp, #DRAW]
	cmp	r9, #0
	beq	.Ldone
	mov	r10, #0
	str	r10, [sp, #LATER]
	mov	r11, r3
	mov	r10, r1
	ldr	lr, [lr, #FAST_SETUP_INVERSE]
	ldr	r1, [sp, #SECOND]
	ldr	r2, [sp, #THIRD]
	ldr	r3, [sp, #MIDDLE]
	find_edge
	ldr	r12, [sp, #SIDE]
	mov	r3, r11
	cmp	r12, #0
	strlt	r2, [sp, #LEFT_STEP]
	strge	r2, [sp, #RIGHT_STEP]
	ldr	r2, =0x07E0F81F
	movlt	r5, r1
	movge	r6, r1
	mov	r1, r10
	b	.Lrow
.Ldone:	add	sp, sp, #ROOM
	pop	{r0, r5, r6, r8, r10, r11, pc}
	.size	soft_fill_masked, . - soft_fill_masked

	.section .note.GNU-stack, "", %progbits
