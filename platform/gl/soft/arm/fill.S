/* portable/loops.c for ARMv6: 64 pixels in six instructions. */
	.syntax unified
	.arch armv6
	.arm
	.text

/* r0 address, r1 count, r2 value */
	.global	soft_fill_pixels
	.type	soft_fill_pixels, %function
soft_fill_pixels:
	cmp	r1, #0
	bxle	lr
	tst	r0, #2
	strhne	r2, [r0], #2
	subne	r1, r1, #1
	pkhbt	r2, r2, r2, lsl #16
	mov	r3, r2
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
1:	stmia	r0!, {r2-r9}
	subs	r1, r1, #64
	stmia	r0!, {r2-r9}
	stmia	r0!, {r2-r9}
	stmia	r0!, {r2-r9}
	bge	1b
2:	adds	r1, r1, #48
	stmiage	r0!, {r2-r9}
	subsge	r1, r1, #16
	stmiage	r0!, {r2-r9}
	subsge	r1, r1, #16
	stmiage	r0!, {r2-r9}
	pop	{r4-r9}
3:	tst	r1, #8
	stmiane	r0!, {r2, r3}
	stmiane	r0!, {r2, r3}
	tst	r1, #4
	stmiane	r0!, {r2, r3}
	tst	r1, #2
	strne	r2, [r0], #4
	tst	r1, #1
	strhne	r2, [r0], #2
	bx	lr
	.size	soft_fill_pixels, . - soft_fill_pixels

	.section .note.GNU-stack, "", %progbits
