/*
 * luminance.c's run_blocks() for ARMv6, opaque: the same pixels. Offsets are
 * those of struct shade_run. Blocks of equal texels cost 12 instructions once
 * they follow one another, other pixels 23.
 */
	.syntax unified
	.arch armv6
	.arm
	.text

#define PIXEL 0
#define COUNT 8
#define QUADS 12
#define WIDTH_LOG2 16
#define S 24
#define S_RIGHT 32
#define SHADE 56

/* r12 = the quad at s, t; r8 is lost */
	.macro	load_quad s, t
	mov	r12, \t, lsr r7
	mov	r8, \s, lsr r7
	add	r12, r8, r12, lsl r11
	ldr	r12, [r2, r12, lsl #2]
	.endm

/* s r5, t r6, steps r3, r4; r8, r10, r12 are lost */
	.macro	put_pixel
	load_quad r5, r6
	mov	r8, r5, lsl r11
	uxtb16	r10, r12
	uxtb16	r12, r12, ror #8
	mov	r8, r8, lsr #28
	sub	r12, r12, r10
	mul	r12, r8, r12
	mov	r8, r6, lsl r11
	mov	r8, r8, lsr #28
	add	r12, r12, r10, lsl #4
	rsb	r8, r8, r8, lsl #16
	add	r8, r8, #16
	smuad	r12, r12, r8
	add	r5, r5, r3
	add	r12, r12, #128
	mov	r12, r12, lsr #8
	ldr	r12, [r9, r12, lsl #2]
	add	r6, r6, r4
	orr	r12, r12, r12, lsr #16
	strh	r12, [r0], #2
	.endm

/*
 * r0 pixel, r1 count, r2 quads, r3 s, r4 t, r5, r6 their steps by block,
 * r7 what shifts them to whole texels, r9 shade, r10 quad at s, t, r11 the
 * sides' logarithm, lr two pixels; the run's address is at sp.
 */
	.macro	shade_blocks name, log2
	.global	\name
	.type	\name, %function
\name:
	push	{r0, r4-r11, lr}
	mov	r12, r0
	ldr	r1, [r12, #COUNT]
	ldr	r2, [r12, #QUADS]
	ldr	r11, [r12, #WIDTH_LOG2]
	rsb	r7, r11, #32
	ldr	r0, [r12, #PIXEL]
	ldr	r9, [r12, #SHADE]
	ldr	r3, [r12, #S]
	ldr	r4, [r12, #S + 4]
	ldr	r5, [r12, #S_RIGHT]
	ldr	r6, [r12, #S_RIGHT + 4]
	mov	r5, r5, lsl #\log2
	mov	r6, r6, lsl #\log2
	load_quad r3, r4
	mov	r10, r12
	b	3f

	/* a block like the one before */
1:	.rept	(1 << \log2) / 2
	str	lr, [r0], #4
	.endr
	subs	r1, r1, #1 << \log2
	blt	5f
	add	r3, r3, r5
	add	r4, r4, r6
	load_quad r3, r4
	cmp	r12, r10
	beq	1b
	b	4f

	/* any block */
3:	subs	r1, r1, #1 << \log2
	blt	5f
	add	r3, r3, r5
	add	r4, r4, r6
	load_quad r3, r4
	cmp	r12, r10
	cmpeq	r12, r12, ror #8
	bne	4f
	uxtb	lr, r12
	ldr	lr, [r9, lr, lsl #2]
	orr	lr, lr, lr, lsr #16
	pkhbt	lr, lr, lr, lsl #16
	b	1b

	/* pixel by pixel, from before r3, r4 */
4:	push	{r3-r6, r12}
	ldr	r12, [sp, #20]
	sub	r5, r3, r5
	sub	r6, r4, r6
	ldr	r3, [r12, #S_RIGHT]
	ldr	r4, [r12, #S_RIGHT + 4]
	.rept	1 << \log2
	put_pixel
	.endr
	pop	{r3-r6, r12}
	mov	r10, r12
	b	3b

	/* less than a block */
5:	adds	r1, r1, #1 << \log2
	beq	7f
	ldr	r12, [sp]
	mov	r5, r3
	mov	r6, r4
	ldr	r3, [r12, #S_RIGHT]
	ldr	r4, [r12, #S_RIGHT + 4]
6:	put_pixel
	subs	r1, r1, #1
	bne	6b
7:	pop	{r0, r4-r11, pc}
	.size	\name, . - \name
	.endm

	shade_blocks shade_four_arm, 2
	shade_blocks shade_two_arm, 1

	.section .note.GNU-stack, "", %progbits
