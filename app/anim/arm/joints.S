/*
 * app/anim/joints.h for VFP11, under names that end in _vfp (choose.c).
 *
 * joints_to_matrices() keeps a transform and its whole matrix in registers and
 * stores the matrix at once, in 39 instructions. The compiler's code takes 62.
 *
 * joints_multiply() computes three rows at a time as VFP short vectors of
 * three. Bank 0 (s0-s7) holds elements of b, which the hardware treats as
 * scalars. The four columns of the result are summed in turn, because VFP11
 * needs 8 to 10 cycles before it can add to the same sum again. Three columns
 * are in s20-s31, of which every fourth register stays 0 and is stored with
 * them as the fourth row. The fourth column overwrites a's first one, which it
 * reads last, and a's fourth column is loaded late into the registers of the
 * second. Each element is ((a0 * b0 + a1 * b1) + a2 * b2) + a3, rounded after
 * each operation, as in transform_inline.h. That takes 38 instructions. The
 * compiler's code takes 86.
 */
	.syntax unified
	.arch armv6
	.fpu vfpv2
	.text

#define LOCAL  r0
#define N      r1
#define PLACED r2
#define ONE_   r3

	.global joints_to_matrices_vfp
	.hidden joints_to_matrices_vfp
	.type joints_to_matrices_vfp, %function
joints_to_matrices_vfp:
	mov	ONE_, #0
	vpush	{s16-s31}
	vmov	s19, ONE_
	vmov	s23, ONE_
	vmov	s27, ONE_
	mov	ONE_, #0x3f800000	/* 1.0f */
	vmov	s31, ONE_
	subs	N, N, #1
	blt	2f
1:	vldmia	LOCAL!, {s0-s9}		/* t x y z, q x y z w, s x y z */
	vadd.f32	s10, s3, s3
	vadd.f32	s11, s4, s4
	vadd.f32	s12, s5, s5
	vmul.f32	s13, s3, s10	/* xx */
	vmul.f32	s28, s6, s10	/* wx */
	vmul.f32	s14, s4, s11	/* yy */
	vmul.f32	s20, s3, s11	/* xy */
	vmul.f32	s29, s6, s11	/* wy */
	vmul.f32	s15, s5, s12	/* zz */
	vmul.f32	s24, s3, s12	/* xz */
	vmul.f32	s25, s4, s12	/* yz */
	vmul.f32	s30, s6, s12	/* wz */
	vadd.f32	s10, s14, s15
	vadd.f32	s11, s13, s15
	vadd.f32	s12, s13, s14
	vsub.f32	s18, s24, s29
	vadd.f32	s24, s24, s29
	vadd.f32	s22, s25, s28
	vsub.f32	s25, s25, s28
	vadd.f32	s17, s20, s30
	vsub.f32	s20, s20, s30
	vsub.f32	s16, s31, s10
	vsub.f32	s21, s31, s11
	vsub.f32	s26, s31, s12
	vmul.f32	s18, s18, s7
	vmul.f32	s24, s24, s9
	vmul.f32	s22, s22, s8
	vmul.f32	s25, s25, s9
	vmul.f32	s17, s17, s7
	vmul.f32	s20, s20, s8
	vmul.f32	s16, s16, s7
	vmul.f32	s21, s21, s8
	vmul.f32	s26, s26, s9
	subs	N, N, #1
	vstmia	PLACED!, {s16-s27}
	vstmia	PLACED!, {s0-s2}
	str	ONE_, [PLACED], #4
	bge	1b
2:	vpop	{s16-s31}
	bx	lr
	.size joints_to_matrices_vfp, . - joints_to_matrices_vfp

#define A      r0
#define INDEX  r1
#define STRIDE r2
#define B      r3
#define OUT    r4
#define COUNT  r5
#define STATUS r6
#define ONE    r7
#define I      r12

	.global joints_multiply_vfp
	.hidden joints_multiply_vfp
	.type joints_multiply_vfp, %function
joints_multiply_vfp:
	push	{r4-r8, lr}
	ldr	OUT, [sp, #24]
	ldr	COUNT, [sp, #28]
	vpush	{s16-s31}
	vmrs	STATUS, fpscr
	mov	ONE, #0
	vmov	s23, ONE
	vmov	s27, ONE
	vmov	s31, ONE
	mov	ONE, #0x3f800000	/* 1.0f */
	bic	I, STATUS, #0x370000
	orr	I, I, #0x020000		/* vector length 3, stride 1 */
	vmsr	fpscr, I
	subs	COUNT, COUNT, #1
	blt	3f
1:	ldr	I, [INDEX], STRIDE
	vldr	s0, [B]
	vldr	s1, [B, #16]
	vldr	s2, [B, #32]
	cmp	I, #0
	blt	4f
	add	I, A, I, lsl #6
	vldmia	I!, {s8-s19}
	vldr	s3, [B, #48]
	vmul.f32	s20, s8, s0
	vldr	s4, [B, #4]
	vldr	s5, [B, #20]
	vmul.f32	s24, s8, s1
	vldr	s6, [B, #36]
	vldr	s7, [B, #52]
	vmul.f32	s28, s8, s2
	vmul.f32	s8, s8, s3
	vldr	s0, [B, #8]
	vldr	s1, [B, #24]
	vmla.f32	s20, s12, s4
	vldr	s2, [B, #40]
	vldr	s3, [B, #56]
	vmla.f32	s24, s12, s5
	vmla.f32	s28, s12, s6
	vmla.f32	s8, s12, s7
	vldmia	I, {s12-s14}
	vmla.f32	s20, s16, s0
	vmla.f32	s24, s16, s1
	vmla.f32	s8, s16, s3
	vmla.f32	s28, s16, s2
	add	B, B, #64
	vadd.f32	s8, s8, s12
	vstmia	OUT!, {s20-s31}
	vstmia	OUT!, {s8-s10}
	str	ONE, [OUT], #4
2:	subs	COUNT, COUNT, #1
	bge	1b
3:	vmsr	fpscr, STATUS
	vpop	{s16-s31}
	pop	{r4-r8, pc}
4:	add	B, B, #64
	add	OUT, OUT, #64
	b	2b
	.size joints_multiply_vfp, . - joints_multiply_vfp

	.section .note.GNU-stack, "", %progbits
