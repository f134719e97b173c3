/*
 * fill_count.c's soft_count_band_c() for ARMv6: the same bytes. Offsets are those of
 * struct count_band. A pixel costs 9 instructions, a row 19.
 */
	.syntax unified
	.arch armv6
	.arm
	.text

#define ROWS 24
#define FROM 44
#define KIND 52

/* r0 band, of one row or more */
	.global	soft_count_band_arm
	.type	soft_count_band_arm, %function
soft_count_band_arm:
	ldrb	r1, [r0, #KIND]
	cmp	r1, #1
	beq	count_down
	bhi	4f

/*
 * r0 depth and r1 stencil of the row's column 0, r2, r3 edges, r4 z at column
 * 0, r5 z a pixel further, r6 one, r7 scratch, r8 rows, r9 band, r10 count,
 * r11 depth, r12 z, lr stencil
 */
	.macro	count	name, operation, where
\name:	push	{r4-r11, lr}
	mov	r9, r0
	ldr	r8, [r9, #ROWS]
	ldm	r9, {r0-r5}
	mov	r6, #1
1:	ldr	r11, [r9, #FROM]
	ldr	r10, [r9, #FROM + 4]
	cmp	r11, r2, asr #16
	movlt	r11, r2, asr #16
	cmp	r10, r3, asr #16
	movgt	r10, r3, asr #16
	subs	r10, r10, r11
	ble	3f
	mla	r12, r5, r11, r4
	add	lr, r1, r11
	add	r11, r0, r11, lsl #1

2:	ldrh	r7, [r11], #2
	cmp	r7, r12, lsr #10
	ldrb\where	r7, [lr]
	add	r12, r12, r5
	\operation\where	r7, r7, r6
	strb\where	r7, [lr]
	add	lr, lr, #1
	subs	r10, r10, #1
	bgt	2b

3:	add	r12, r9, #ROWS + 4
	ldm	r12, {r7, r10, r11, r12}
	add	r2, r2, r7
	add	r3, r3, r10
	add	r4, r4, r11
	add	r0, r0, r12, lsl #1
	add	r1, r1, r12
	subs	r8, r8, #1
	bgt	1b
	stm	r9, {r0-r4}
	str	r8, [r9, #ROWS]
	pop	{r4-r11, pc}
	.endm

	count	count_up, uqadd8, ls
	count	count_down, uqsub8, ls
4:	cmp	r1, #2
	bne	count_passed_down
	count	count_passed_up, uqadd8, hi
	count	count_passed_down, uqsub8, hi
	.size	soft_count_band_arm, . - soft_count_band_arm

	.section .note.GNU-stack, "", %progbits
