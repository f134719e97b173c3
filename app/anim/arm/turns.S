/*
 * The rotations of app/anim/turns.h for VFP11, in vectors of four.
 *
 * Operations whose result is in bank 0 (s0-s7) compute one number, all others a
 * quaternion. s8-s15 hold the two keys around the time, which are one load as
 * they lie side by side. s4 is u, the time's part of the way between the keys,
 * s5 is 1 - u, and s6 and s7 are u (u^2 - 1) and the same of 1 - u. They stay
 * from one rotation to the next if the key times are the same. Times are at
 * least 0, so their bits compare as integers.
 *
 * Every number is rounded as in inline_quat_slerp() and inline_quat_mix().
 */
	.syntax unified
	.arch armv6
	.fpu vfpv2
	.text

#define TURN   r0
#define COUNT  r1
#define TIME   r2
#define LOCAL  r3
#define TIMES  r4
#define VALUES r5
#define OFFSET r6
#define LAST   r7
#define KEY    r8
#define FROM   r9
#define TO     r10
#define BEFORE r11
#define AT     r12
#define FAR    lr

/* struct turn */
#define TURN_WEIGHT #12
#define TURN_KEY    #16
#define TURN_LAST   #20
#define TURN_SIZE   #24

	/* s0 = a . b */
	.macro	dot a0, a1, a2, a3, b0, b1, b2, b3
	vmul.f32	s0, \a0, \b0
	vmla.f32	s0, \a1, \b1
	vmla.f32	s0, \a2, \b2
	vmla.f32	s0, \a3, \b3
	.endm

	/* The vector out = a * from + b * to; `to` changes its sign if FROM,
	   which is the bits of a . b, is negative. */
	.macro	interpolate out, a, from, b, to, between:vararg
	cmp	FROM, #0x80000000
	vneghi.f32	\to, \to
	\between
	vmul.f32	\out, \a, \from
	vmla.f32	\out, \b, \to
	.endm

	.macro	turns mix
	push	{r4-r11, lr}
	sub	sp, sp, #4
	vpush	{s16-s28}
	sub	sp, sp, #4
	vmov	s20, TIME
	mov	AT, #0x3f800000		/* 1 */
	vmov	s21, AT
	ldr	AT, 90f
	vmov	s22, AT
	.if	\mix
	vldr	s23, [sp, #96]		/* amount */
	ldr	AT, 91f
	vmov	s28, AT
	.endif
	ldr	FAR, 92f
	mov	BEFORE, #0
	vmrs	AT, fpscr
	bic	AT, AT, #0x370000
	orr	AT, AT, #0x030000	/* vector length 4, stride 1 */
	vmsr	fpscr, AT
	cmp	COUNT, #0
	ble	9f

1:	ldm	TURN, {TIMES, VALUES, OFFSET}
	cmp	TIMES, BEFORE
	beq	4f
	ldr	KEY, [TURN, TURN_KEY]
	mov	BEFORE, TIMES
	add	AT, TIMES, KEY, lsl #2
	ldm	AT, {FROM, TO}
	cmp	TIME, TO
	bge	5f
	cmp	TIME, FROM
	blt	6f
2:	vmov	s0, s1, FROM, TO
	vsub.f32	s2, s20, s0
	vsub.f32	s3, s1, s0
3:	vdiv.f32	s4, s2, s3
	vsub.f32	s5, s21, s4
	vmul.f32	s6, s4, s4
	vmul.f32	s7, s5, s5
	vsub.f32	s6, s6, s21
	vsub.f32	s7, s7, s21
	vmul.f32	s6, s4, s6
	vmul.f32	s7, s5, s7
4:	add	AT, VALUES, KEY, lsl #4
	vldmia	AT, {s8-s15}
	dot	s8, s9, s10, s11, s12, s13, s14, s15
	vmov	FROM, s0
	vabs.f32	s1, s0
	vsub.f32	s1, s1, s21		/* x */
	vmov	TO, s1
	vmul.f32	s0, s1, s22
	vmov.f32	s2, s5
	vmov.f32	s3, s4
	cmp	TO, FAR			/* x <= -0.0025 */
	bhs	8f
	vmla.f32	s2, s7, s0
	vmla.f32	s3, s6, s0
7:	interpolate	s16, s8, s2, s12, s3, add AT, LOCAL, OFFSET
	.if	\mix
	vldmia	AT, {s24-s27}
	vldr	s2, [TURN, TURN_WEIGHT]
	dot	s16, s17, s18, s19, s24, s25, s26, s27
	vmul.f32	s2, s2, s23
	vsub.f32	s3, s21, s2
	vmov	FROM, s0
	interpolate	s24, s24, s3, s16, s2
	dot	s24, s25, s26, s27, s24, s25, s26, s27
	vadd.f32	s0, s0, s28
	vsqrt.f32	s0, s0
	vdiv.f32	s0, s21, s0
	vmul.f32	s24, s24, s0
	vstmia	AT, {s24-s27}
	.else
	vstmia	AT, {s16-s19}
	.endif
	subs	COUNT, COUNT, #1
	add	TURN, TURN, TURN_SIZE
	bgt	1b
9:	vmrs	AT, fpscr
	bic	AT, AT, #0x370000
	vmsr	fpscr, AT
	add	sp, sp, #4
	vpop	{s16-s28}
	add	sp, sp, #4
	pop	{r4-r11, pc}

	/* The time is beyond these keys: tries the next ones, then all. */
5:	ldr	LAST, [TURN, TURN_LAST]
	.irp	next, 8, 12, 16
	add	KEY, KEY, #1
	cmp	KEY, LAST
	bge	52f
	mov	FROM, TO
	ldr	TO, [AT, #\next]
	str	KEY, [TURN, TURN_KEY]
	cmp	TIME, TO
	blt	2b
	.endr
	b	6f
52:	sub	KEY, KEY, #1
	str	KEY, [TURN, TURN_KEY]
	/* At or behind the last key, u is 1. */
54:	vmov	s0, s1, FROM, TO
	vsub.f32	s2, s1, s0
	vsub.f32	s3, s1, s0
	b	3b
	/* Searches all keys. */
6:	ldr	LAST, [TURN, TURN_LAST]
	mov	KEY, #0
61:	add	AT, KEY, LAST
	mov	AT, AT, lsr #1
	cmp	AT, KEY
	beq	62f
	ldr	TO, [TIMES, AT, lsl #2]
	cmp	TIME, TO
	movge	KEY, AT
	movlt	LAST, AT
	b	61b
62:	str	KEY, [TURN, TURN_KEY]
	add	AT, TIMES, KEY, lsl #2
	ldm	AT, {FROM, TO}
	cmp	TIME, TO
	bge	54b
	cmp	TIME, FROM
	bge	2b
	/* Before the first key, u is 0. */
	vmov	s0, s1, FROM, TO
	vsub.f32	s2, s0, s0
	vsub.f32	s3, s1, s0
	b	3b

	/*
	 * Keys further apart: the weights by a longer series, as in
	 * quat_slerp_weights(), for 1 - u and u side by side.
	 */
8:	ldr	LAST, 93f
	cmp	TO, LAST		/* x <= -0.05 */
	bhs	81f
	adr	AT, 94f
	vldmia	AT, {s24-s27}
	vmov	AT, LAST, s4, s5
	vmov	s8, s9, LAST, AT
	vmov	s10, s11, LAST, AT
	vmul.f32	s12, s8, s8	/* t^2 */
	vmov.f32	s2, s27
	vmul.f32	s3, s1, s24
	vsub.f32	s16, s12, s2
	vmul.f32	s16, s16, s3
	vmov.f32	s2, s21
	vadd.f32	s16, s16, s2
	vmul.f32	s3, s1, s25
	vmov.f32	s1, s26
	vsub.f32	s24, s12, s1
	vmul.f32	s24, s24, s3
	vmul.f32	s24, s24, s16
	vadd.f32	s16, s24, s2
	vsub.f32	s12, s12, s2
	vmul.f32	s12, s12, s0
	vmul.f32	s12, s12, s16
	vadd.f32	s16, s12, s2
	vmul.f32	s16, s16, s8
	vmov.f32	s2, s16
	vmov.f32	s3, s17
	add	AT, VALUES, KEY, lsl #4
	vldmia	AT, {s8-s15}
	b	7b

	/* Keys far apart: the weights by sines. */
81:	push	{r0-r3, r12, lr}
	vpush	{s4-s7}
	sub	sp, sp, #8
	vmrs	TO, fpscr
	bic	LAST, TO, #0x370000
	vmsr	fpscr, LAST
	vmov	r0, s1
	vmov	r1, s4
	mov	r2, sp
	bl	quat_slerp_weights
	vmsr	fpscr, TO
	vldmia	sp!, {s2-s3}
	vpop	{s4-s7}
	pop	{r0-r3, r12, lr}
	vldmia	AT, {s8-s15}
	b	7b

90:	.word	0x3eaaaaab		/* 1/3 */
91:	.word	0x0da24260		/* 1e-30 */
92:	.word	0xbb23d70a		/* -0.0025 */
93:	.word	0xbd4ccccd		/* -0.05 */
94:	.word	0x3d430c31		/* 1/21 */
	.word	0x3dcccccd		/* 0.1 */
	.word	0x40800000		/* 4 */
	.word	0x41100000		/* 9 */
	.endm

	.global turns_set
	.hidden turns_set
	.type turns_set, %function
turns_set:
	turns	0
	.size turns_set, . - turns_set

	.global turns_mix
	.hidden turns_mix
	.type turns_mix, %function
turns_mix:
	turns	1
	.size turns_mix, . - turns_mix

	.section .note.GNU-stack, "", %progbits
