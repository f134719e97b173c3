/*
 * Skinning for ARMv6. Results equal those of skin() in fixed_loops.c bit for
 * bit. ../figures.md says how the schedule was found.
 *
 * void kernel_armv6_skin(const struct fixed_group *group, int group_count,
 *	const struct fixed_base *base, const struct fixed_matrix *palette,
 *	struct fixed_vector *out);
 *
 * A run's matrices are copied to the stack, so that no register has to point to
 * them. Registers in the loops:
 *
 *   r0  base vectors     r4 r5  row x: m0 m1, m2 t     r3   sum x
 *   r1  out              r6 r7  row y                  r12  sum y
 *   r2  vertices left    r8 r9  row z                  lr   sum z
 *   r10 r11  a base vector: x y, z w
 */
	.syntax	unified
	.arch	armv6
	.arm
	.text

#define MATRICES   0            /* 8 * 32 bytes */
#define GROUP      256
#define GROUPS     260
#define RUN        264
#define RUNS       268
#define PALETTE    272
#define INFLUENCES 276
#define FRAME      280
#define OUT        (FRAME + 40) /* the fifth argument */
/* With 128, vertices of 8 influences took 41% longer; others take as long. */
#define AHEAD      160

/*
 * One influence: multiplies its matrix by its base vector while it loads those
 * of the next influence. `matrix` is the offset of the next matrix on the
 * stack, or -1 if the next influence has the same matrix; `vector` is the
 * offset of the next base vector from r0.
 */
	.macro	influence first, matrix, vector
	.if	\first
	smuad	r3, r10, r4
	smuad	r12, r10, r6
	smlad	r3, r11, r5, r3
	smuad	lr, r10, r8
	.else
	smlad	r3, r10, r4, r3
	smlad	r12, r10, r6, r12
	smlad	r3, r11, r5, r3
	smlad	lr, r10, r8, lr
	.endif
	smlad	r12, r11, r7, r12
	.if	\matrix >= 0
	ldrd	r4, r5, [sp, #\matrix]
	.endif
	smlad	lr, r11, r9, lr
	ldrd	r10, r11, [r0, #\vector]
	.if	\matrix >= 0
	ldrd	r6, r7, [sp, #\matrix + 8]
	ldrd	r8, r9, [sp, #\matrix + 16]
	.endif
	.endm

/* Stores a vertex: one word is x and its fraction, the other one y and z. */
	.macro	store
	pkhtb	lr, lr, r12, asr #16
	stmia	r1!, {r3, lr}
	.endm

/*
 * The loop for runs with `count` influences, two vertices at a time. The
 * influences of the second vertex go from the last to the first. So the matrix
 * does not change between the two vertices, nor from one pass of the loop to
 * the next.
 */
	.macro	run count
	.set	last, \count - 1
	ldrd	r4, r5, [sp, #0]
	ldrd	r6, r7, [sp, #8]
	ldrd	r8, r9, [sp, #16]
	ldrd	r10, r11, [r0]
	subs	r2, r2, #2
	blo	2f
1:
	.set	i, 0
	.rept	\count
	.if	i < last
	influence (i == 0), (i + 1) * 32, (i + 1) * 8
	.else
	influence (i == 0), -1, (last + \count) * 8
	.endif
	.set	i, i + 1
	.endr
	pld	[r0, #AHEAD]
	store
	.set	i, last
	.rept	\count
	.if	i > 0
	influence (i == last), (i - 1) * 32, (i - 1 + \count) * 8
	.if	(i & 1) == 0
	pld	[r0, #AHEAD + 16 * i]
	.endif
	.else
	influence (i == last), -1, 2 * \count * 8
	.endif
	.set	i, i - 1
	.endr
	add	r0, r0, #2 * \count * 8
	store
	subs	r2, r2, #2
	bhs	1b
2:	adds	r2, r2, #1
	bmi	next_run
	.set	i, 0
	.rept	\count
	.if	i < last
	influence (i == 0), (i + 1) * 32, (i + 1) * 8
	.else
	influence (i == 0), -1, (i + 1) * 8
	.endif
	.set	i, i + 1
	.endr
	add	r0, r0, #\count * 8
	store
	b	next_run
	.endm

	.global	kernel_armv6_skin
	.type	kernel_armv6_skin, %function
kernel_armv6_skin:
	push	{r3-r11, lr}
	sub	sp, sp, #FRAME
	str	r3, [sp, #PALETTE]
	mov	r4, r0
	mov	r5, r1
	mov	r0, r2
	ldr	r1, [sp, #OUT]

next_group:
	subs	r5, r5, #1
	bmi	done
	ldmia	r4!, {r6, r7, r8}	/* influences, runs, run */
	str	r4, [sp, #GROUP]
	str	r5, [sp, #GROUPS]
	str	r6, [sp, #INFLUENCES]
	str	r7, [sp, #RUNS]
	str	r8, [sp, #RUN]

next_run:
	ldr	r3, [sp, #RUNS]
	ldr	r12, [sp, #RUN]
	subs	r3, r3, #1
	bmi	end_of_group
	str	r3, [sp, #RUNS]
	ldr	r3, [sp, #INFLUENCES]
	ldr	lr, [sp, #PALETTE]
	ldr	r2, [r12], #4		/* vertices */
	mov	r11, sp
	mov	r10, r3
copy_matrix:
	ldr	r4, [r12], #4
	add	r4, r4, lr
	subs	r10, r10, #1
	ldmia	r4, {r4-r9}
	stmia	r11!, {r4-r9}
	add	r11, r11, #8
	bne	copy_matrix
	str	r12, [sp, #RUN]
	add	pc, pc, r3, lsl #2
	nop
	nop				/* 0 influences: does not occur */
	b	run1
	b	run2
	b	run3
	b	run4
	b	run5
	b	run6
	b	run7
	b	run8

end_of_group:
	ldr	r4, [sp, #GROUP]
	ldr	r5, [sp, #GROUPS]
	b	next_group

done:
	add	sp, sp, #FRAME
	pop	{r3-r11, pc}

run1:	run	1
run2:	run	2
run3:	run	3
run4:	run	4
run5:	run	5
run6:	run	6
run7:	run	7
run8:	run	8
	.size	kernel_armv6_skin, . - kernel_armv6_skin

	.section .note.GNU-stack, "", %progbits
