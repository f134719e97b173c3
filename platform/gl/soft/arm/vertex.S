/*
 * soft_transform_c() for ARMv6, with the same results, for three shorts or floats;
 * it calls the C function for other positions and for vertices outside.
 *
 * A vertex of three shorts costs 70 instructions, one of three floats 81.
 */
#include "platform/gl/soft/arm/offsets.h"
	.syntax unified
	.arch armv6
	.fpu vfpv2
	.arm
	.text

#define MATRIX_SIZE 64 /* of struct view's first members; r0 is past them then */

/* r0 draw, r1 index, r2 vertex */
	.global	soft_transform
	.type	soft_transform, %function
soft_transform:
	ldr	r12, [r0, #VIEW_KIND]
	push	{r2, r4-r11, lr}
	/* Stores allocate no line: without preloads the readers wait for memory. */
	pld	[r2, #VERTEX_CLIP]
	ldrd	r4, [r0, #VIEW_POSITIONS]
	cmp	r12, #1
	str	r1, [r2, #VERTEX_INDEX]
	mla	r3, r1, r5, r4
	bhi	.Lother
	beq	.Lfloats

	/* clip coordinates: r1 x, r4 y, r12 z, lr w; position: r3 x and y, r11 z */
	ldrsh	r11, [r3, #4]
	pld	[r3, #64]
	ldr	r3, [r3]
	ldmia	r0!, {r1, r4-r10}
	smlawb	r1, r5, r3, r1
	smlawb	r4, r8, r3, r4
	smlawt	r1, r6, r3, r1
	smlawt	r4, r9, r3, r4
	smlawb	r1, r7, r11, r1
	smlawb	r4, r10, r11, r4
	ldmia	r0!, {r5-r10, r12, lr}
	smlawb	lr, r8, r3, lr
	smlawb	r12, r5, r3, r12
	smlawt	lr, r9, r3, lr
	smlawt	r12, r6, r3, r12
	smlawb	lr, r10, r11, lr
	smlawb	r12, r7, r11, r12

	/* |coordinates| < 2^29, so comparisons with w and -w cannot overflow. */
.Lclip:
	pld	[r2, #32]
	cmp	lr, #1
	cmpge	lr, r1
	cmpge	lr, r4
	cmpge	lr, r12
	cmnge	lr, r1
	cmnge	lr, r4
	cmnge	lr, r12
	add	r3, r2, #VERTEX_CLIP
	stmia	r3, {r1, r4, r12, lr}
	blt	.Loutside

	/* r6 inverse_w_q30, r7 w_zeros */
	ldr	r11, [r0, #VIEW_RECIPROCALS - MATRIX_SIZE]
	clz	r7, lr
	pld	[r2]
	lsl	r8, lr, r7
	lsl	r9, r8, #1
	lsr	r9, r9, #23
	bic	r9, r9, #1
	ldrh	r10, [r11, r9]
	lsl	r10, r10, #15
	umull	r3, r5, r8, r10
	rsb	r5, r5, #0x80000000
	umull	r3, r10, r5, r10
	lsl	r10, r10, #2
	umull	r3, r5, r8, r10
	rsb	r5, r5, #0x80000000
	umull	r3, r6, r5, r10
	lsls	r6, r6, #2
	mvnmi	r6, #0x80000000

	/* r8 x / w, r9 y / w, r10 z / w */
	sub	r5, r7, #1
	lsl	r8, r1, r5
	lsl	r9, r4, r5
	lsl	r10, r12, r5
	smmul	r8, r8, r6
	smmul	r9, r9, r6
	smmul	r10, r10, r6
	add	r0, r0, #VIEW_CENTER - MATRIX_SIZE
	ldmia	r0, {r0, r1, r3, r4, r5, r11}
	smmla	r8, r8, r3, r0
	smmla	r9, r9, r4, r1
	smmla	r10, r10, r11, r5
	str	r6, [r2, #VERTEX_INVERSE_W]
	asr	r8, r8, #4
	asr	r9, r9, #4
	/* sets outcode and shaded to 0: they are the upper bytes of w_zeros' word */
	stmia	r2, {r7-r10}
	pop	{r2, r4-r11, pc}

.Lfloats:
	fldmias	r3, {s0-s2}
	flds	s3, [r0, #VIEW_SCALE]
	pld	[r3, #64]
	ldmia	r0!, {r1, r4-r10}
	fmuls	s0, s0, s3
	fmuls	s1, s1, s3
	fmuls	s2, s2, s3
	ftosizs	s0, s0
	ftosizs	s1, s1
	ftosizs	s2, s2
	fmrs	r3, s0
	fmrs	r11, s1
	fmrs	r2, s2
	smmla	r1, r5, r3, r1
	smmla	r4, r8, r3, r4
	smmla	r1, r6, r11, r1
	smmla	r4, r9, r11, r4
	smmla	r1, r7, r2, r1
	smmla	r4, r10, r2, r4
	ldmia	r0!, {r5-r10, r12, lr}
	smmla	lr, r8, r3, lr
	smmla	r12, r5, r3, r12
	smmla	lr, r9, r11, lr
	smmla	r12, r6, r11, r12
	smmla	lr, r10, r2, lr
	smmla	r12, r7, r2, r12
	ldr	r2, [sp]
	b	.Lclip

	/* Outside: C computes all again, and the outcode. */
.Loutside:
	ldr	r1, [r2, #VERTEX_INDEX]
	sub	r0, r0, #MATRIX_SIZE
.Lother:
	pop	{r2, r4-r11, lr}
	b	soft_transform_c
	.size	soft_transform, . - soft_transform

	.section .note.GNU-stack, "", %progbits
