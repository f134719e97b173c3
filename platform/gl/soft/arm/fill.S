/* band.c's band_fill_c() for ARMv6: 16 pixels in three instructions. */
	.syntax unified
	.arch armv6
	.arm
	.text

/* r0 address, r1 count, r2 value */
	.global	band_fill_arm
	.type	band_fill_arm, %function
band_fill_arm:
	tst	r0, #2
	beq	1f
	subs	r1, r1, #1
	bxlt	lr
	strh	r2, [r0], #2
1:	subs	r1, r1, #16
	blt	3f
	push	{r4-r9}
	pkhbt	r2, r2, r2, lsl #16
	mov	r3, r2
	mov	r4, r2
	mov	r5, r2
	mov	r6, r2
	mov	r7, r2
	mov	r8, r2
	mov	r9, r2
2:	stmia	r0!, {r2-r9}
	subs	r1, r1, #16
	bge	2b
	pop	{r4-r9}
3:	adds	r1, r1, #16
	bxeq	lr
4:	strh	r2, [r0], #2
	subs	r1, r1, #1
	bgt	4b
	bx	lr
	.size	band_fill_arm, . - band_fill_arm

	.section .note.GNU-stack, "", %progbits
