/* portable/loops.c for ARMv6: 64 pixels in six instructions. */
	.syntax unified
	.arch armv6
	.arm
	.text

/*
 * r0 address, r1 count, r2 value. soft_fill_some is for tile_row.S: a count of at
 * least 1, the value in both halves; r0 becomes the end, r1 and r12 are overwritten.
 */
	.global	soft_fill_pixels, soft_fill_some
	.type	soft_fill_pixels, %function
soft_fill_pixels:
	cmp	r1, #0
	bxle	lr
	pkhbt	r2, r2, r2, lsl #16
soft_fill_some:
	tst	r0, #2
	strhne	r2, [r0], #2
	subne	r1, r1, #1
	mov	r12, r2
	subs	r1, r1, #16
	blt	3f
	push	{r4-r9}
	mov	r4, r2
	mov	r5, r2
	mov	r6, r2
	mov	r7, r2
	mov	r8, r2
	mov	r9, r2
	subs	r1, r1, #48
	blt	2f
1:	stmia	r0!, {r2, r4-r9, r12}
	subs	r1, r1, #64
	stmia	r0!, {r2, r4-r9, r12}
	stmia	r0!, {r2, r4-r9, r12}
	stmia	r0!, {r2, r4-r9, r12}
	bge	1b
2:	adds	r1, r1, #48
	stmiage	r0!, {r2, r4-r9, r12}
	subsge	r1, r1, #16
	stmiage	r0!, {r2, r4-r9, r12}
	subsge	r1, r1, #16
	stmiage	r0!, {r2, r4-r9, r12}
	pop	{r4-r9}
	/* from bit 3 down: the carry flag has a bit, the sign the next one */
3:	movs	r1, r1, lsl #29
	stmiacs	r0!, {r2, r12}
	stmiacs	r0!, {r2, r12}
	stmiami	r0!, {r2, r12}
	movs	r1, r1, lsl #2
	strcs	r2, [r0], #4
	strhmi	r2, [r0], #2
	bx	lr
	.size	soft_fill_pixels, . - soft_fill_pixels

	.section .note.GNU-stack, "", %progbits
