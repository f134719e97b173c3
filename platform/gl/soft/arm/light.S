/*
 * light.c's soft_shade() and dir_lights.c for ARMv6: the same numbers. Offsets are
 * those of struct view, struct dir_lights and struct vertex.
 *
 * A vertex costs 79 instructions, normalising a normal of shorts included, each
 * light that it faces 18, with a highlight 36, and texture coordinates 20.
 */
#include "platform/gl/soft/arm/offsets.h"
	.syntax unified
	.arch armv6
	.fpu vfpv2
	.arm
	.text

/* of the draw */
#define DIR_LIGHTS 116

#define SQUARE_LEAST 32
#define SUMS 40

/* what is left of a light source behind its direction, its flag and its steps */
#define BEHIND_TOWARDS 52
#define BEHIND_SPEC_TABLES 36
#define BEHIND_STEPS 12

#define TEXCOORDS 580

/* of the stack */
#define LIGHT 0
#define VERTEX 4
#define OUT 8
#define COLOR 12
#define END 16
#define SIDES 20
#define FRAME 24

/* r0 draw, r1 vertex */
	.global	soft_shade
	.type	soft_shade, %function
soft_shade:
	ldrb	r2, [r1, #VERTEX_SHADED]
	ldr	r12, [r0, #DIR_LIGHTS]
	cmp	r2, #0
	bxne	lr
	cmp	r12, #0
	beq	soft_shade_c
	push	{r0, r1, r4-r11, lr}
	ldr	r2, [r1, #VERTEX_INDEX]
	add	r0, r0, r12
	ldmia	r0, {r3-r10}
	mla	r3, r2, r4, r3
	mla	r5, r2, r6, r5
	cmp	r10, #0
	add	r2, r1, #VERTEX_ATTRIBUTE
	pld	[r5]
	push	{r0, r1, r2, r5, r8, r9}
	bne	.Lfloats

	/* r9 the square, r10 its zeros, r1 the root; r4 r5 r6 are 2 c + 1 */
	ldrsh	r4, [r3]
	ldrsh	r5, [r3, #2]
	ldrsh	r6, [r3, #4]
	pld	[r3, #40]
	mov	r8, #1
	smlabb	r9, r4, r4, r8
	add	r4, r8, r4, lsl #1
	smlabb	r9, r5, r5, r9
	add	r5, r8, r5, lsl #1
	smlabb	r9, r6, r6, r9
	add	r6, r8, r6, lsl #1
	clz	r10, r9
	bic	r10, r10, #1
	lsl	r9, r9, r10
	lsr	r11, r9, #23
	bic	r11, r11, #1
	add	r11, r11, r7
	ldrh	r11, [r11, #-128]
	mov	r12, #14
	add	r12, r12, r10, lsr #1
	lsl	r11, r11, #13
	umull	r3, r1, r11, r11
	lsl	r4, r4, r12
	lsl	r5, r5, r12
	umull	r3, r2, r9, r1
	lsl	r6, r6, r12
	rsb	r2, r2, #3 << 24
	umull	r3, r1, r11, r2
	lsl	r1, r1, #8
	smmul	r12, r5, r1
	smmul	r5, r4, r1
	smmul	lr, r6, r1

	/* normal r5 r12 lr; dull r6 r7 r8, shine r9 r10 r11; r0 the light source */
.Lside:
	ldr	r4, [sp, #END]
	add	r0, r0, #SUMS
	ldmia	r0!, {r6-r11}
	cmp	r0, r4
	beq	.Lsum
.Llamp:
	ldmia	r0!, {r1-r3}
	smmul	r1, r1, r5
	smmla	r1, r2, r12, r1
	smmla	r1, r3, lr, r1
	cmp	r1, #0
	addle	r0, r0, #BEHIND_TOWARDS
	ble	.Lnext
	ldmia	r0!, {r2-r4}
	smmla	r6, r1, r2, r6
	smmla	r7, r1, r3, r7
	smmla	r8, r1, r4, r8
	ldr	r4, [r0], #4
	cmp	r4, #0
	addeq	r0, r0, #BEHIND_SPEC_TABLES
	beq	.Lnext
	ldmia	r0!, {r1-r3}
	smmul	r1, r1, r5
	smmla	r1, r2, r12, r1
	smmla	r1, r3, lr, r1
	ldmia	r0!, {r2-r4}
	subs	r1, r1, r2
	addle	r0, r0, #BEHIND_STEPS
	ble	.Lnext
	smmul	r1, r1, r3
	usat	r1, #14, r1
	lsr	r2, r1, #8
	add	r4, r4, r2, lsl #3
	ldrd	r2, [r4]
	and	r1, r1, #255
	mla	r1, r3, r1, r2
	ldmia	r0!, {r2-r4}
	smmla	r9, r1, r2, r9
	smmla	r10, r1, r3, r10
	smmla	r11, r1, r4, r11
.Lnext:
	ldr	r4, [sp, #END]
	cmp	r0, r4
	bne	.Llamp

.Lsum:
	ldr	r1, [sp, #COLOR]
	ldr	r4, [sp, #SIDES]
	ldr	r0, [sp, #OUT]
	ldr	r1, [r1]
	uxtb16	r2, r1
	uxtb16	r3, r1, ror #8
	smlawb	r6, r6, r2, r9
	smlawb	r7, r7, r3, r10
	smlawt	r8, r8, r2, r11
	mov	r1, #128
	usat	r6, #16, r6
	usat	r7, #16, r7
	usat	r8, #16, r8
	sub	r6, r6, r6, lsr #8
	sub	r7, r7, r7, lsr #8
	sub	r8, r8, r8, lsr #8
	add	r6, r6, r1
	add	r7, r7, r1
	add	r8, r8, r1
	add	r9, r1, r3, lsr #8
	stmia	r0, {r6-r9}
	cmp	r4, #0
	bne	.Lback
	ldr	r3, [sp, #LIGHT]
	ldr	r5, [sp, #VERTEX]
	mov	r4, #1
	ldr	r1, [r3, #TEXCOORDS]
	cmp	r1, #0
	beq	.Lrest
	ldr	r2, [r3, #TEXCOORDS + 4]
	ldr	r3, [r5, #VERTEX_INDEX]
	mla	r1, r2, r3, r1
	ldr	r2, [r1]
	ldr	r3, [r1, #4]
	pld	[r1, #40]
	/* below 2^14, without their signs */
	lsl	r1, r2, #1
	cmp	r1, #0x8D000000
	lsllo	r1, r3, #1
	cmplo	r1, #0x8D000000
	bhs	.Lother
	fmsr	s0, r2
	fmsr	s1, r3
	flds	s2, .Lone_q16
	fmuls	s0, s0, s2
	fmuls	s1, s1, s2
	ftosizs	s0, s0
	ftosizs	s1, s1
	fsts	s0, [r5, #VERTEX_TEX]
	fsts	s1, [r5, #VERTEX_TEX + 4]
.Lshaded:
	strb	r4, [r5, #VERTEX_SHADED]
	add	sp, sp, #FRAME + 8
	pop	{r4-r11, pc}

.Lrest:
	ldr	r3, [r3, #TEXCOORDS + 8]
	cmp	r3, #0
	beq	.Lshaded
	strb	r4, [r5, #VERTEX_SHADED]
	add	sp, sp, #FRAME
	pop	{r0, r1, r4-r11, lr}
	b	soft_shade_rest

.Lother:
	add	sp, sp, #FRAME
	pop	{r0, r1, r4-r11, lr}
	b	soft_shade_c

	/* the other side, once */
.Lback:
	mov	r4, #0
	str	r4, [sp, #SIDES]
	add	r0, r0, #VERTEX_BACK - VERTEX_ATTRIBUTE
	str	r0, [sp, #OUT]
	ldr	r0, [sp, #LIGHT]
	rsb	r5, r5, #0
	rsb	r12, r12, #0
	rsb	lr, lr, #0
	b	.Lside

.Lfloats:
	fldmias	r3, {s0-s2}
	flds	s3, .Lone_q28
	ldrd	r6, [r0, #SQUARE_LEAST]
	pld	[r3, #40]
	fmuls	s0, s0, s3
	fmuls	s1, s1, s3
	fmuls	s2, s2, s3
	ftosizs	s0, s0
	ftosizs	s1, s1
	ftosizs	s2, s2
	fmrs	r5, s0
	fmrs	r12, s1
	fmrs	lr, s2
	/* What is too large is the largest here, and so is its square. */
	smmul	r1, r5, r5
	smmla	r1, r12, r12, r1
	smmla	r1, lr, lr, r1
	sub	r1, r1, r6
	cmp	r1, r7
	blo	.Lside
	b	.Lother

.Lone_q28:
	.float	268435456.0
.Lone_q16:
	.float	65536.0
	.size	soft_shade, . - soft_shade

	.section .note.GNU-stack, "", %progbits
