/*
 * ground.c's soft_ground_shade_c() and soft_ground_depth_c() for ARMv6: the same pixels.
 * Offsets are those of struct shade_run. Where the texels around a pixel are all
 * the same it costs 18 instructions, in blocks of four of one texel 10, else
 * 30; its depth 7.
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
#define SHARE 60
#define SHARE_RIGHT 64

/*
 * r1 pixels one by one; the share's step is at sp + step. r8, r10, r12 are
 * lost.
 */
	.macro	put_each step
11:	mov	r12, r6, lsr r7
	mov	r8, r5, lsr r7
	add	r12, r8, r12, lsl r11
	ldr	r12, [r2, r12, lsl #2]
	mov	r8, lr, lsr #8
	cmp	r12, r12, ror #8
	bne	13f
	uxtb	r12, r12
	mul	r12, r8, r12
	mov	r12, r12, lsr #16
12:	ldr	r12, [r9, r12, lsl #2]
	ldr	r8, [sp, #\step]
	add	r5, r5, r3
	add	r6, r6, r4
	strh	r12, [r0], #2
	add	lr, lr, r8
	subs	r1, r1, #1
	bgt	11b
	b	14f

13:	mov	r8, r5, lsl r11
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
	mov	r8, lr, lsr #8
	mul	r12, r8, r12
	mov	r12, r12, lsr #24
	b	12b
14:
	.endm

/*
 * r0 pixel, r1 count, r2 quads, r3, r4 steps of s and t, r5 s, r6 t, r7 what
 * shifts them to whole texels, r9 shade, r10 quad at s, t, r11 the side's
 * logarithm, lr share; its step is at sp. r8, r12 are lost.
 */
	.global	soft_ground_shade_arm
	.type	soft_ground_shade_arm, %function
soft_ground_shade_arm:
	push	{r4-r11, lr}
	ldr	r12, [r0, #SHARE_RIGHT]
	push	{r12}
	mov	r12, r0
	ldr	r1, [r12, #COUNT]
	ldr	r2, [r12, #QUADS]
	ldr	r11, [r12, #WIDTH_LOG2]
	ldr	r0, [r12, #PIXEL]
	ldr	r9, [r12, #SHADE]
	ldr	lr, [r12, #SHARE]
	add	r12, r12, #S
	ldm	r12, {r5, r6}
	ldr	r3, [r12, #S_RIGHT - S]
	ldr	r4, [r12, #S_RIGHT - S + 4]
	rsb	r7, r11, #32
	mov	r10, r6, lsr r7
	mov	r8, r5, lsr r7
	add	r10, r8, r10, lsl r11
	ldr	r10, [r2, r10, lsl #2]

	/* are texels two pixels wide? */
	eor	r8, r3, r3, asr #31
	sub	r8, r8, r3, asr #31
	eor	r12, r4, r4, asr #31
	sub	r12, r12, r4, asr #31
	orr	r8, r8, r12
	rsb	r12, r11, #31
	movs	r8, r8, lsr r12
	bne	6f
	subs	r1, r1, #4
	blt	5f

	/* the quad behind the next four */
1:	add	r8, r5, r3, lsl #2
	add	r12, r6, r4, lsl #2
	mov	r8, r8, lsr r7
	mov	r12, r12, lsr r7
	add	r12, r8, r12, lsl r11
	ldr	r12, [r2, r12, lsl #2]
	cmp	r12, r10
	cmpeq	r12, r12, ror #8
	bne	4f
	add	r5, r5, r3, lsl #2
	add	r6, r6, r4, lsl #2
	uxtb	r10, r10
	.rept	4
	mov	r12, lr, lsr #8
	mul	r12, r10, r12
	ldr	r8, [sp]
	mov	r12, r12, lsr #16
	ldr	r12, [r9, r12, lsl #2]
	add	lr, lr, r8
	strh	r12, [r0], #2
	.endr
	orr	r10, r10, r10, lsl #8
	orr	r10, r10, r10, lsl #16
	subs	r1, r1, #4
	bge	1b
	b	5f

	/* four pixels of their own, then blocks again */
4:	push	{r1, r12}
	mov	r1, #4
	put_each 8
	pop	{r1, r10}
	subs	r1, r1, #4
	bge	1b

	/* less than a block */
5:	add	r1, r1, #4
6:	cmp	r1, #0
	ble	7f
	put_each 0
7:	pop	{r12}
	pop	{r4-r11, pc}
	.size	soft_ground_shade_arm, . - soft_ground_shade_arm

/* r0 depth, r1 count, r2 z, r3 z a pixel further; r12 is lost */
	.macro	depth_one
	ldrh	r12, [r0]
	cmp	r12, r2, lsr #10
	mov	r12, r2, lsr #10
	bls	2f
	strh	r12, [r0], #2
	add	r2, r2, r3
	.endm

	.global	soft_ground_depth_arm
	.type	soft_ground_depth_arm, %function
soft_ground_depth_arm:
	push	{r0, lr}
	subs	r1, r1, #2
	blt	1f
3:	depth_one
	depth_one
	subs	r1, r1, #2
	bge	3b
1:	adds	r1, r1, #2
	ble	2f
	depth_one
2:	pop	{r1, lr}
	sub	r0, r0, r1
	mov	r0, r0, lsr #1
	bx	lr
	.size	soft_ground_depth_arm, . - soft_ground_depth_arm

	.section .note.GNU-stack, "", %progbits
