/*
 * band.c's soft_band_flat_c() for ARMv6, blended: the same bytes. Offsets are those
 * of struct flat_band. A pixel costs 9 instructions, 13 with a stencil; where
 * that is as it should not be, one of eight.
 */
#include "platform/gl/soft/arm/blend_565.h"

	.syntax unified
	.arch armv6
	.arm
	.text

#define STRIDES 8
#define ROWS 16
#define EDGE 20
#define EDGE_STEP 28
#define FROM 36
#define TO 40
#define REFERENCE 44
#define NEXT 45
#define UNLIKE 46
#define KEEP 48

/* r12 = a pixel blended, at r11 */
	.macro	blend
	ldrh	r12, [r11]
	mix_wide r12, r3, r4, r2
	strh	r12, [r11], #2
	.endm

/*
 * r0 pixels and r1 stencil of the row's column 0, r2 mask, r3 keep, r4 own,
 * r5, r6 edges, r7 what the stencil has, r8 what it gets, r9 band, r10 count,
 * r11 pixel, lr stencil
 */
	.global	soft_band_flat_arm
	.type	soft_band_flat_arm, %function
soft_band_flat_arm:
	push	{r4-r11, lr}
	mov	r9, r0
	ldr	r2, =0x07E0F81F
	ldr	r3, [r9, #KEEP]
	ldr	r4, [r9, #KEEP + 4]
	ldr	r5, [r9, #EDGE]
	ldr	r6, [r9, #EDGE + 4]
	ldrb	r7, [r9, #REFERENCE]
	ldrb	r8, [r9, #NEXT]
	orr	r10, r7, r7, lsl #8
	ldm	r9, {r0, r1}
	ldrb	r12, [r9, #UNLIKE]
	cmp	r12, #0
	orrne	r7, r10, r10, lsl #16

.Lrow:	ldr	r12, [r9, #FROM]
	ldr	lr, [r9, #TO]
	mov	r11, r5, asr #16
	mov	r10, r6, asr #16
	cmp	r11, r12
	movlt	r11, r12
	cmp	r10, lr
	movgt	r10, lr
	subs	r10, r10, r11
	ble	.Lnext
	cmp	r1, #0
	add	lr, r1, r11
	add	r11, r0, r11, lsl #1
	beq	.Lfree
	ldrb	r12, [r9, #UNLIKE]
	cmp	r12, #0
	bne	.Lunlike

.Ltest:	ldrb	r12, [lr], #1
	cmp	r12, r7
	addne	r11, r11, #2
	bne	1f
	strb	r8, [lr, #-1]
	blend
1:	subs	r10, r10, #1
	bne	.Ltest

.Lnext:	ldr	r12, [r9, #STRIDES]
	ldr	lr, [r9, #STRIDES + 4]
	ldr	r10, [r9, #EDGE_STEP]
	ldr	r11, [r9, #EDGE_STEP + 4]
	add	r0, r0, r12
	cmp	r1, #0
	addne	r1, r1, lr
	ldr	r12, [r9, #ROWS]
	add	r5, r5, r10
	add	r6, r6, r11
	subs	r12, r12, #1
	str	r12, [r9, #ROWS]
	bgt	.Lrow
	stm	r9, {r0, r1}
	str	r5, [r9, #EDGE]
	str	r6, [r9, #EDGE + 4]
	pop	{r4-r11, pc}

.Lfree:	tst	r10, #1
	beq	2f
	blend
	subs	r10, r10, #1
	beq	.Lnext
2:	blend
	blend
	subs	r10, r10, #2
	bne	2b
	b	.Lnext
/* r7 what the stencil must not have, four times; r8 pixels up to a word's */
.Lunlike:
	rsb	r8, lr, #0
	and	r8, r8, #3
	cmp	r8, r10
	movgt	r8, r10
	sub	r10, r10, r8
	cmp	r8, #0
	beq	.Lwords
.Leach:	ldrb	r12, [lr], #1
	eor	r12, r12, r7
	tst	r12, #255
	addeq	r11, r11, #2
	beq	1f
	blend
1:	subs	r8, r8, #1
	bne	.Leach
.Lwords:
	subs	r10, r10, #8
	blt	1f
	ldm	lr!, {r8, r12}
	cmp	r8, r7
	cmpeq	r12, r7
	addeq	r11, r11, #16
	beq	.Lwords
	sub	lr, lr, #8
	mov	r8, #8
	b	.Leach
1:	adds	r8, r10, #8
	mov	r10, #0
	bne	.Leach
	b	.Lnext
	.size	soft_band_flat_arm, . - soft_band_flat_arm

	.section .note.GNU-stack, "", %progbits
