/* portable/loops.c for ARMv6: 9 instructions for three floats. */
	.syntax unified
	.arch armv6
	.arm
	.text

	.macro	larger value
	cmp	r12, \value, lsl #1
	movlo	r12, \value, lsl #1
	.endm

	.macro	larger_vertex
	ldmia	r0, {r3-r5}
	pld	[r0, #96]
	add	r0, r0, r1
	larger	r3
	larger	r4
	larger	r5
	.endm

/* r0 address, r1 stride in bytes, r2 count; 9 instructions each */
	.global	soft_largest_aligned_float
	.type	soft_largest_aligned_float, %function
soft_largest_aligned_float:
	push	{r4, r5}
	mov	r12, #0
	subs	r2, r2, #4
	blo	2f
1:	.rept	4
	larger_vertex
	.endr
	subs	r2, r2, #4
	bhs	1b
2:	adds	r2, r2, #4
	beq	4f
3:	larger_vertex
	subs	r2, r2, #1
	bne	3b
4:	mov	r0, r12
	pop	{r4, r5}
	bx	lr
	.size	soft_largest_aligned_float, . - soft_largest_aligned_float

	.section .note.GNU-stack, "", %progbits
