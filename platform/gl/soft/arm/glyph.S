/*
 * glyph.c for ARMv6: the same bytes. Offsets are those of struct glyph. A pixel
 * of a letter costs 17 instructions, 7 where nothing is; one of a panel 4.8.
 */
	.syntax unified
	.arch armv6
	.arm
	.text

/*
 * r0 pixel, r1 texel, r2 columns left, r3 rows left, r4 own, r5 alpha, r6 the
 * wide mask, r7 what rounds, r10 columns, r11, lr from a row's end to the next
 */
	.global	soft_glyph_draw_arm
	.type	soft_glyph_draw_arm, %function
soft_glyph_draw_arm:
	push	{r4-r11, lr}
	ldm	r0, {r0-r5, r7, r12}
	mov	r10, r2
	sub	r11, r4, r2, lsl #1
	sub	lr, r5, r2
	mov	r4, r7
	mov	r5, r12
	ldr	r6, =0x07E0F81F
	ldr	r7, =0x02008010
.Lletter:
	ldrb	r12, [r1], #1
	subs	r2, r2, #1
	add	r12, r12, #4
	mov	r12, r12, lsr #3
	mul	r12, r5, r12
	movs	r12, r12, lsr #5
	beq	1f
	ldrh	r8, [r0]
	orr	r8, r8, r8, lsl #16
	and	r8, r8, r6
	add	r9, r7, r8, lsl #5
	sub	r8, r4, r8
	mla	r8, r12, r8, r9
	and	r8, r6, r8, lsr #5
	orr	r8, r8, r8, lsr #16
	strh	r8, [r0]
1:	add	r0, r0, #2
	cmp	r2, #0
	bne	.Lletter
	add	r0, r0, r11
	add	r8, r0, r11
	add	r1, r1, lr
	pld	[r8, r10, lsl #1]
	mov	r2, r10
	subs	r3, r3, #1
	bne	.Lletter
	pop	{r4-r11, pc}
	.size	soft_glyph_draw_arm, . - soft_glyph_draw_arm

/*
 * r0 pixel, r1 count, r2 keep, r3 own, r4 the wide mask. Two pixels are two
 * wide ones, each with the other's green.
 */
	.macro	mix_two pixels, other
	and	\other, r4, \pixels, ror #16
	and	\pixels, r4, \pixels
	mla	\other, r2, \other, r3
	mla	\pixels, r2, \pixels, r3
	and	\other, r4, \other, lsr #5
	and	\pixels, r4, \pixels, lsr #5
	orr	\pixels, \pixels, \other, ror #16
	.endm

	.macro	mix_one
	ldrh	r5, [r0]
	orr	r5, r5, r5, lsl #16
	and	r5, r4, r5
	mla	r5, r2, r5, r3
	and	r5, r4, r5, lsr #5
	orr	r5, r5, r5, lsr #16
	strh	r5, [r0], #2
	.endm

	.global	soft_glyph_mix_arm
	.type	soft_glyph_mix_arm, %function
soft_glyph_mix_arm:
	cmp	r1, #0
	bxle	lr
	push	{r4-r8, lr}
	ldr	r4, =0x07E0F81F
	tst	r0, #2
	beq	1f
	mix_one
	sub	r1, r1, #1
1:	subs	r1, r1, #8
	blt	3f
2:	pld	[r0, #64]
	ldm	r0, {r5, r6, r7, r8}
	mix_two	r5, r12
	mix_two	r6, r12
	mix_two	r7, r12
	mix_two	r8, r12
	stmia	r0!, {r5, r6, r7, r8}
	subs	r1, r1, #8
	bge	2b
3:	adds	r1, r1, #8
	beq	5f
	subs	r1, r1, #2
	blt	6f
4:	ldr	r5, [r0]
	mix_two	r5, r12
	str	r5, [r0], #4
	subs	r1, r1, #2
	bge	4b
6:	tst	r1, #1
	beq	5f
	mix_one
5:	pop	{r4-r8, pc}
	.size	soft_glyph_mix_arm, . - soft_glyph_mix_arm

	.section .note.GNU-stack, "", %progbits
