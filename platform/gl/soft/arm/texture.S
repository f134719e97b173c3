/*
 * band.c's soft_band_gray_c() for ARMv6, with the same results. A pixel costs 20
 * instructions, 6 where it is hidden.
 */
#include "platform/gl/soft/arm/offsets.h"

	.syntax unified
	.arch armv6
	.arm
	.text

/*
 * Blends the pixel in \wide, whose upper half is 0, as pixel.h does: the result
 * is (pixel * \fraction + \own) >> 5, where \own is wide and holds WIDE_ROUND.
 * \mask is WIDE_MASK.
 */
	.macro	mix_wide wide, fraction, own, mask
	orr	\wide, \wide, \wide, lsl #16
	and	\wide, \wide, \mask
	mla	\wide, \fraction, \wide, \own
	and	\wide, \mask, \wide, lsr #5
	orr	\wide, \wide, \wide, lsr #16
	.endm

/*
 * r1 the depth's address + 2 after its load, r2 z, r3 texel, r4 share above its
 * step, r6 z_right, r7 texel_right, r8 texel_mask, r9 texel_shift, r10 texels, r11
 * WIDE_MASK, r12 pixels, lr WIDE_ROUND. The jump relies on 20 instructions.
 */
	.macro	texture_pixel hidden
	ldrh	r5, [r1], #2
	cmp	r5, r2, lsr #16
	b\hidden	1f
	and	r5, r3, r8
	mov	r0, r2, lsr #16
	strh	r0, [r1, #-2]
	uxtb	r0, r5, ror #8
	add	r0, r0, r5, lsr r9
	add	r0, r10, r0, lsl #1
	ldrh	r0, [r0]
	mov	r5, r4, lsr #26
	mix_wide r0, r5, lr, r11
	strh	r0, [r1, r12]
1:	add	r2, r2, r6
	add	r3, r3, r7
	add	r4, r4, r4, lsl #16
	.endm

	.macro	band_gray name, hidden
	.global	\name
	.type	\name, %function
\name:
	push	{r4-r11, lr}
	ldr	r1, [r0, #BAND_ROWS]
	push	{r0, r1}

	/* r1 to r4: this row's values; stores the next row's */
.Lrow\@:
	add	lr, r0, #BAND_DOWN
	ldm	r0, {r1-r4}
	ldm	lr, {r5-r8}
	add	r5, r5, r1
	add	r6, r6, r2
	add	r7, r7, r3
	add	r8, r8, r4
	stm	r0, {r5-r8}
	ldrd	r10, [r0, #BAND_EDGE]
	ldrd	r8, [r0, #BAND_EDGE_STEP]
	mov	r12, r10, asr #16
	pld	[r5, r12, lsl #1]
	rsbs	r5, r12, r11, asr #16
	add	r10, r10, r8
	add	r11, r11, r9
	strd	r10, [r0, #BAND_EDGE]
	ble	.Lnext\@

	/* steps from column 0 to column r12; r5 is the number of pixels */
	ldrd	r6, [r0, #BAND_RIGHT]
	ldr	r8, [r0, #BAND_COLORS_RIGHT]
	mla	r2, r12, r6, r2
	mla	r3, r12, r7, r3
	mla	r4, r12, r8, r4
	add	r1, r1, r12, lsl #1
	pkhtb	r4, r4, r8, asr #16
	add	r0, r0, #BAND_MASK
	ldm	r0, {r8-r12, lr}
	rsb	r5, r5, #GRAY_PIXELS
	add	r5, r5, r5, lsl #2
	add	pc, pc, r5, lsl #4
	nop
	.rept	GRAY_PIXELS
	texture_pixel \hidden
	.endr

.Lnext\@:
	pop	{r0, r1}
	subs	r1, r1, #1
	pushne	{r0, r1}
	bne	.Lrow\@
	pop	{r4-r11, pc}
	.size	\name, . - \name
	.endm

	band_gray	soft_band_gray, ls
	band_gray	soft_band_gray_equal, lo

	.section .note.GNU-stack, "", %progbits
