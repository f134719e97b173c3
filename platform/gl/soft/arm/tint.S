/*
 * band.c's soft_band_tint_c() for ARMv6, with the same results.
 *
 * A row costs 40 instructions, a pixel 53, or 9 if it is hidden.
 */
#include "platform/gl/soft/arm/offsets.h"
	.syntax unified
	.arch armv6
	.arm
	.text

/* An offset in struct band while r0 has BAND_RIGHT added. */
#define BEHIND(offset) (offset) - BAND_RIGHT

	.macro	band_tint name, hidden
	.global	\name
	.type	\name, %function
\name:
	push	{r3-r11, lr}
	ldr	r11, =0x03E003E0
	ldr	r12, =0x07E007E0
.Lrow\@:	ldr	r6, [r0, #BAND_EDGE]
	ldr	r7, [r0, #BAND_EDGE + 4]
	mov	r6, r6, asr #16
	rsbs	r7, r6, r7, asr #16
	ble	.Lnext\@
	ldm	r0, {r1-r5}
	add	r0, r0, #BAND_RIGHT
	ldm	r0, {r8, r9, r10, lr}
	sub	r7, r7, #1
	add	r1, r1, r6, lsl #1
	mla	r2, r6, r8, r2
	mla	r3, r6, r9, r3
	mla	r4, r6, r10, r4
	mla	r5, r6, lr, r5
	pkhbt	r5, r5, r7, lsl #16

	/* r1 depth, r2 z, r3 texel, r4 red_blue, r5 green below the pixels left */
.Lpixel\@:
	ldrh	r6, [r1], #2
	cmp	r6, r2, lsr #16
	b\hidden	.Lskip\@
	mov	r6, r2, lsr #16
	strh	r6, [r1, #-2]

	/* filter weights: r8 of the two texels above, r9 of those below */
	ldrd	r6, [r0, #BEHIND(BAND_MASK)]
	mov	r8, r3, lsr #3
	and	r8, r8, #31
	rsb	r8, r8, r8, lsl #16
	add	r8, r8, #32
	uxtb	r9, r3, ror #16
	mul	r9, r8, r9
	and	lr, r3, r6
	add	r10, lr, #0x100
	rsb	r8, r9, r8, lsl #8
	adds	r10, r10, #0x1000000
	bicscc	r10, r10, r6
	bne	.Lacross\@
	mov	r10, lr, lsr r7
	uxtab	r10, r10, lr, ror #8
	ldrd	r6, [r0, #BEHIND(BAND_TEXELS)]
	add	r10, r6, r10, lsl #1
	ldr	r6, [r10]
	ldr	r7, [r10, r7]

	/* r6 two texels above, r7 below; lr red, r6 green, r10 blue */
.Lmix\@:	and	lr, r11, r6, lsr #6
	and	r10, r11, r6, lsl #5
	and	r6, r12, r6
	smuad	lr, lr, r8
	smuad	r10, r10, r8
	smuad	r6, r6, r8
	and	r8, r11, r7, lsr #6
	smlad	lr, r8, r9, lr
	and	r8, r11, r7, lsl #5
	smlad	r10, r8, r9, r10
	and	r8, r12, r7
	smlad	r6, r8, r9, r6
	ldrd	r8, [r0, #BEHIND(BAND_MORE)]
	smlawt	lr, lr, r4, r8
	smlawb	r10, r10, r4, r9
	ldrd	r8, [r0, #BEHIND(BAND_PIXELS)]
	smlawb	r6, r6, r5, r9
	usat	lr, #5, lr, asr #17
	usat	r6, #6, r6, asr #17
	usat	r10, #5, r10, asr #17
	orr	lr, r6, lr, lsl #6
	orr	lr, r10, lr, lsl #5
	strh	lr, [r1, r8]
.Lskip\@:	ldm	r0, {r6-r9}
	add	r2, r2, r6
	add	r3, r3, r7
	add	r4, r4, r8
	adds	r5, r5, r9
	bpl	.Lpixel\@
	sub	r0, r0, #BAND_RIGHT

.Lnext\@:	add	lr, r0, #BAND_DOWN
	ldm	r0, {r1-r5}
	ldm	lr!, {r6-r10}
	add	r1, r1, r6
	add	r2, r2, r7
	add	r3, r3, r8
	add	r4, r4, r9
	add	r5, r5, r10
	stm	r0, {r1-r5}
	ldm	lr, {r1-r5}
	add	r1, r1, r3
	add	r2, r2, r4
	stm	lr, {r1, r2}
	subs	r5, r5, #1
	str	r5, [lr, #BAND_ROWS - BAND_EDGE]
	bgt	.Lrow\@
	pop	{r3-r11, pc}

	/* texel lr lies at the level's edge */
.Lacross\@:
	sub	sp, sp, #8
	mov	r6, sp
	push	{r0-r3}
	sub	r0, r0, #BAND_RIGHT
	mov	r1, lr
	mov	r2, r6
	bl	soft_tint_across
	pop	{r0-r3}
	pop	{r6, r7}
	ldr	r12, =0x07E007E0
	b	.Lmix\@
	.ltorg
	.size	\name, . - \name
	.endm

	band_tint	soft_band_tint, ls
	band_tint	soft_band_tint_equal, lo

	.section .note.GNU-stack, "", %progbits
