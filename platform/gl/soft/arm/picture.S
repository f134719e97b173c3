/* picture.c's soft_picture_copy_c() for ARMv6: 4.5 instructions a pixel. */
	.syntax unified
	.arch armv6
	.arm
	.text

	.macro	copy_two
	and	r12, r5, r3, lsr #15
	add	r3, r3, r4
	and	lr, r5, r3, lsr #15
	ldrh	r12, [r1, r12]
	ldrh	lr, [r1, lr]
	add	r3, r3, r4
	orr	r12, r12, lr, lsl #16
	str	r12, [r0], #4
	.endm

	.macro	copy_one
	and	r12, r5, r3, lsr #15
	ldrh	r12, [r1, r12]
	add	r3, r3, r4
	strh	r12, [r0], #2
	.endm

/* r0 pixel, r1 texels, r2 count, r3 s, r4 its step, r5 what keeps bytes even */
	.global	soft_picture_copy_arm
	.type	soft_picture_copy_arm, %function
soft_picture_copy_arm:
	push	{r4, r5, r6, lr}
	ldr	r4, [sp, #16]
	ldr	r5, =0x1FFFE
	cmp	r2, #0
	ble	4f
	tst	r0, #2
	beq	1f
	copy_one
	sub	r2, r2, #1
1:	subs	r2, r2, #4
	blt	3f
2:	copy_two
	copy_two
	subs	r2, r2, #4
	bge	2b
3:	tst	r2, #2
	beq	5f
	copy_two
5:	tst	r2, #1
	beq	4f
	copy_one
4:	pop	{r4, r5, r6, pc}
	.size	soft_picture_copy_arm, . - soft_picture_copy_arm

	.section .note.GNU-stack, "", %progbits
