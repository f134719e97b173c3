/*
 * band.c for ARMv6: the same bytes. Offsets are those of struct band.
 *
 * A row costs 31 instructions, a pixel 9, whether it is seen or not.
 */
#include "platform/gl/soft/arm/depth_tested.h"

	.syntax unified
	.arch armv6
	.arm
	.text

#define DOWN 16
#define RIGHT 32
#define COLOR_RIGHT 40
#define EDGE 48
#define EDGE_STEP 56
#define MASK_PIXELS 64
#define ROWS 72

	.global	soft_band_color_arm
	.type	soft_band_color_arm, %function
soft_band_color_arm:
	push	{r4-r11, lr}
	ldrd	r6, [r0, #RIGHT]
	ldrd	r10, [r0, #EDGE]
	ldr	lr, [r0, #ROWS]

	/* this row's values; the next one's go back at once */
.Lrow:
	ldmia	r0!, {r1-r4}
	ldmia	r0, {r5, r8, r9, r12}
	add	r5, r5, r1
	add	r8, r8, r2
	add	r9, r9, r3
	add	r12, r12, r4
	stmdb	r0!, {r5, r8, r9, r12}
	mov	r12, r10, asr #16
	rsbs	r5, r12, r11, asr #16
	ldrd	r8, [r0, #EDGE_STEP]
	add	r10, r10, r8
	add	r11, r11, r9
	ble	.Lnext

	/* from column 0 to column r12; r5 pixels are left */
.Lbegin:
	ldrd	r8, [r0, #COLOR_RIGHT]
	mla	r2, r12, r6, r2
	mla	r3, r12, r8, r3
	mla	r4, r12, r9, r4
	add	r1, r1, r12, lsl #1
	mov	r8, r3, lsr #21
	mov	r4, r4, lsr #21
	mov	r3, r3, lsl #16
	orr	r8, r8, r4, lsl #11
	mov	r3, r3, lsr #22
	orr	r3, r3, r8, lsl #10
	ldrh	r4, [r1]
	ldrd	r8, [r0, #MASK_PIXELS]
	cmp	r5, #16
	bgt	.Llong
	rsb	r5, r5, #16
	add	r5, r5, r5, lsl #3
	add	pc, pc, r5, lsl #2
	nop
	.rept	15
	depth_tested_pixel r4, r12
	.endr
	see_last r4, r12

.Lnext:
	subs	lr, lr, #1
	bne	.Lrow
	strd	r10, [r0, #EDGE]
	pop	{r4-r11, pc}

	/* 16 of more; then the row's values again, which are one row back */
.Llong:
	push	{r5, r12}
	mov	r5, #4
.Lfour:
	.rept	4
	depth_tested_pixel r4, r12
	.endr
	subs	r5, r5, #1
	bne	.Lfour
	pop	{r5, r12}
	ldmia	r0!, {r1-r4}
	ldmia	r0, {r6-r9}
	sub	r0, r0, #DOWN
	sub	r1, r1, r6
	sub	r2, r2, r7
	sub	r3, r3, r8
	sub	r4, r4, r9
	ldrd	r6, [r0, #RIGHT]
	sub	r5, r5, #16
	add	r12, r12, #16
	b	.Lbegin
	.size	soft_band_color_arm, . - soft_band_color_arm

	.section .note.GNU-stack, "", %progbits
