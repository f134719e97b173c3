/*
 * The rotations of app/anim/turns.h for VFP11, in vectors of four, under names
 * that end in _vfp (choose.c).
 *
 * Operations whose result is in bank 0 (s0-s7) compute one number, all others a
 * quaternion. s8-s15 hold the two keys around the time, which are one load as
 * they lie side by side. s4 is u, the time's part of the way between the keys,
 * s5 is 1 - u, and s6 and s7 are u (u^2 - 1) and the same of 1 - u. s4-s7 are
 * kept for the next rotation if it has the same key times. Times are at least
 * 0, so their bits compare as integers.
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

	/*
	 * Saves registers, makes `room` bytes on the stack, loads the constants
	 * and sets vectors of length 4.
	 */
	.macro	begin mix, room
	push	{r4-r11, lr}
	sub	sp, sp, #4
	vpush	{s16-s28}
	sub	sp, sp, #(4 + \room)
	vmov	s20, TIME
	mov	AT, #0x3f800000		/* 1 */
	vmov	s21, AT
	.if	\mix
	vldr	s23, [sp, #(96 + \room)] /* amount */
	ldr	AT, =0x0da24260		/* 1e-30 */
	vmov	s28, AT
	.endif
	mov	BEFORE, #0
	vmrs	AT, fpscr
	bic	AT, AT, #0x370000
	orr	AT, AT, #0x030000	/* vector length 4, stride 1 */
	vmsr	fpscr, AT
	.endm

	.macro	finish room
	vmrs	AT, fpscr
	bic	AT, AT, #0x370000
	vmsr	fpscr, AT
	add	sp, sp, #(4 + \room)
	vpop	{s16-s28}
	add	sp, sp, #4
	pop	{r4-r11, pc}
	.endm

	/*
	 * Finds KEY, so that u is s2 / s3. The macro search_keys has its slow
	 * paths.
	 */
	.macro	find_keys
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
3:
	.endm

	/* Mixes the rotation in s16-s19 into the one at `at`. */
	.macro	mix_into at
	vldmia	\at, {s24-s27}
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
	vstmia	\at, {s24-s27}
	.endm

	.macro	search_keys
	/*
	 * The time is beyond these keys: tries the next three, then searches
	 * all.
	 */
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
	.endm

	.macro	turns mix
	begin	\mix, 0
	ldr	AT, =0x3eaaaaab		/* 1/3 */
	vmov	s22, AT
	ldr	FAR, =0xbb23d70a	/* -0.0025 */
	cmp	COUNT, #0
	ble	9f

1:	ldm	TURN, {TIMES, VALUES, OFFSET}
	cmp	TIMES, BEFORE
	beq	4f
	find_keys
	vdiv.f32	s4, s2, s3
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
	mix_into	AT
	.else
	vstmia	AT, {s16-s19}
	.endif
	subs	COUNT, COUNT, #1
	add	TURN, TURN, TURN_SIZE
	bgt	1b
9:	finish	0

	search_keys

	/*
	 * Keys further apart: the weights by a longer series, as in
	 * quat_slerp_weights(), for 1 - u and u side by side.
	 */
8:	ldr	LAST, =0xbd4ccccd	/* -0.05 */
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

94:	.word	0x3d430c31		/* 1/21 */
	.word	0x3dcccccd		/* 0.1 */
	.word	0x40800000		/* 4 */
	.word	0x41100000		/* 9 */
	.ltorg
	.endm

	/*
	 * Packed keys. The stack has at sp struct packed_weights of
	 * ../portable/turns.c, which is key[0], key[1], curve[0], curve[1],
	 * then LOCAL, the bits of the float 3, and the time. r2 and r3 are the
	 * weights of both keys.
	 */
	.macro	turns_packed mix
	begin	\mix, 32
	ldr	AT, =0x40400000		/* 3 */
	str	LOCAL, [sp, #16]
	vmov	s7, AT
	str	AT, [sp, #20]
	str	TIME, [sp, #24]
	cmp	COUNT, #0
	ble	9f

1:	ldm	TURN, {TIMES, VALUES, OFFSET}
	cmp	TIMES, BEFORE
	beq	4f
	ldr	TIME, [sp, #24]
	find_keys
	vdiv.f32	s2, s2, s3
	adr	AT, 96f
	vldmia	AT!, {s8-s19}
	vldmia	AT, {s24-s27}
	vmla.f32	s12, s8, s2
	vmla.f32	s16, s12, s2
	vmla.f32	s24, s16, s2
	vcvt.s32.f32	s8, s24
	vcvt.s32.f32	s9, s25
	vcvt.s32.f32	s10, s26
	vcvt.s32.f32	s11, s27
	vstmia	sp, {s8-s11}
4:	add	AT, VALUES, KEY, lsl #3
	ldm	AT, {r7, r9, r10, r12}	/* x y and z w of both keys */
	ldm	sp, {r2-r5, lr}
	add	OFFSET, lr, OFFSET
	smuad	lr, r7, r10
	smlad	lr, r9, r12, lr
	smmls	r2, r4, lr, r2
	smmls	r3, r5, lr, r3
	cmp	lr, #0x3f800000
	blt	8f
7:	ldr	r4, [sp, #20]
	smlawb	r5, r2, r7, r4
	smlawt	lr, r2, r7, r4
	smlawb	r5, r3, r10, r5
	smlawt	lr, r3, r10, lr
	smlawb	r7, r2, r9, r4
	smlawt	r9, r2, r9, r4
	smlawb	r7, r3, r12, r7
	smlawt	r9, r3, r12, r9
	vmov	s8, s9, r5, lr
	vmov	s10, s11, r7, r9
	vsub.f32	s16, s8, s7
	.if	\mix
	mix_into	OFFSET
	.else
	vstmia	OFFSET, {s16-s19}
	.endif
	subs	COUNT, COUNT, #1
	add	TURN, TURN, TURN_SIZE
	bgt	1b
9:	finish	32

	search_keys

	/* Keys further apart: the second term of the series. */
8:	cmp	lr, #0x3c800000
	blt	81f
	rsb	lr, lr, #0x40000000
	mov	lr, lr, lsl #2
	smmul	lr, lr, lr
	ldr	BEFORE, =0x66666666	/* 0.4 */
	smmul	lr, lr, BEFORE
	.irp	key, 2, 3
	mov	BEFORE, r\key, lsl #7
	smmul	BEFORE, BEFORE, BEFORE
	rsb	BEFORE, BEFORE, #0x40000000
	.if	\key == 2
	smmul	BEFORE, r4, BEFORE
	.else
	smmul	BEFORE, r5, BEFORE
	.endif
	smmla	r\key, BEFORE, lr, r\key
	.endr
	ldr	BEFORE, [TURN]
	b	7b

	/* Keys far apart: the weights by sines. */
81:	push	{r0, r1, r4, r12}
	ldr	r0, [sp, #(16 + 4)]
	sub	sp, sp, #8
	sub	r0, r0, r5, asr #2
	add	r0, r0, r5, asr #16
	vmov	s0, s1, r0, lr
	vldr	s2, 95f
	vldr	s3, 95f + 4
	vcvt.f32.s32	s0, s0
	vcvt.f32.s32	s1, s1
	vmul.f32	s0, s0, s2
	vmul.f32	s1, s1, s3
	vsub.f32	s1, s1, s21
	vmov	r1, r0, s0, s1
	mov	r2, sp
	vmrs	BEFORE, fpscr
	bic	r3, BEFORE, #0x370000
	vmsr	fpscr, r3
	bl	quat_slerp_weights
	vmsr	fpscr, BEFORE
	vldmia	sp!, {s2-s3}
	vldr	s0, 95f + 8
	vmul.f32	s2, s2, s0
	vmul.f32	s3, s3, s0
	vcvt.s32.f32	s2, s2
	vcvt.s32.f32	s3, s3
	vmov	r2, r3, s2, s3
	pop	{r0, r1, r4, r12}
	ldr	r4, [sp, #20]
	vmov	s7, r4
	ldr	BEFORE, [TURN]
	b	7b

95:	.word	0x33fffe00	/* 32767 / 2^38 */
	.word	0x30800200	/* 1 / 32767^2 */
	.word	0x4b000100	/* 2^38 / 32767 */
	/* WEIGHT_TERMS of ../portable/turns.c */
96:	.word	0x4a2aa955, 0xca2aa955, 0x4b2aac00, 0xcb2aac00
	.word	0xcafffe00, 0x00000000, 0xcc000100, 0x00000000
	.word	0xca2ab155, 0x4b2aab55, 0x4baaac00, 0x4b2aac00
	.word	0x4b000100, 0x00000000, 0x00000000, 0x00000000
	.ltorg
	.endm

	.global turns_set_vfp
	.hidden turns_set_vfp
	.type turns_set_vfp, %function
turns_set_vfp:
	turns	0
	.size turns_set_vfp, . - turns_set_vfp

	.global turns_mix_vfp
	.hidden turns_mix_vfp
	.type turns_mix_vfp, %function
turns_mix_vfp:
	turns	1
	.size turns_mix_vfp, . - turns_mix_vfp

	.global turns_set_packed_vfp
	.hidden turns_set_packed_vfp
	.type turns_set_packed_vfp, %function
turns_set_packed_vfp:
	turns_packed	0
	.size turns_set_packed_vfp, . - turns_set_packed_vfp

	.global turns_mix_packed_vfp
	.hidden turns_mix_packed_vfp
	.type turns_mix_packed_vfp, %function
turns_mix_packed_vfp:
	turns_packed	1
	.size turns_mix_packed_vfp, . - turns_mix_packed_vfp

	.section .note.GNU-stack, "", %progbits
