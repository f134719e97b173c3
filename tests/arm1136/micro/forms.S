#include "tests/arm1136/micro/cases.h"

	/*
	 * One of every instruction form that the compiler makes for this core, to
	 * check that all of them are decoded. Their cycles are not compared.
	 */
	.macro FORMS name
	.section cases, "a"
	.word \name
	.text
	.balign 32
	.type \name, %function
\name :
	add r0, r0, #1024
	add r1, r1, #2048
	.endm

	FORMS forms_data
	BEGIN
	.irp op, and, eor, sub, rsb, add, adc, sbc, rsc, orr, bic
	\op r2, r3, #1
	\op r2, r3, r4
	\op\()s r2, r3, r4, lsl #3
	\op r2, r3, r4, lsr #3
	\op r2, r3, r4, asr r5
	\op r2, r3, r4, ror r5
	\op r2, r3, r4, rrx
	.endr
	.irp op, tst, teq, cmp, cmn
	\op r3, #1
	\op r3, r4
	\op r3, r4, lsl #3
	\op r3, r4, lsl r5
	.endr
	.irp op, mov, mvn
	\op r2, #1
	\op r2, r4
	\op\()s r2, r4, rrx
	\op r2, r4, lsl r5
	.endr
	clz r2, r3
	mrs r2, cpsr
	msr cpsr_f, r2
	msr cpsr_f, #0
	msr cpsr_s, r2
	END

	FORMS forms_media
	BEGIN
	.irp sign, s, q, sh, u, uq, uh
	.irp op, add16, sub16, add8, sub8, asx, sax
	\sign\op r2, r3, r4
	.endr
	.endr
	.irp op, qadd, qsub, qdadd, qdsub
	\op r2, r3, r4
	.endr
	.irp op, sxtb, sxth, sxtb16, uxtb, uxth, uxtb16
	\op r2, r3
	\op r2, r3, ror #8
	.endr
	.irp op, sxtab, sxtah, sxtab16, uxtab, uxtah, uxtab16
	\op r2, r3, r4
	\op r2, r3, r4, ror #16
	.endr
	pkhbt r2, r3, r4
	pkhbt r2, r3, r4, lsl #16
	pkhtb r2, r3, r4, asr #16
	sel r2, r3, r4
	ssat r2, #16, r3
	ssat r2, #16, r3, asr #14
	usat r2, #8, r3
	usat r2, #8, r3, lsl #2
	ssat16 r2, #12, r3
	usat16 r2, #12, r3
	rev r2, r3
	rev16 r2, r3
	revsh r2, r3
	usad8 r2, r3, r4
	usada8 r2, r3, r4, r5
	END

	FORMS forms_multiply
	BEGIN
	mul r2, r3, r4
	muls r2, r3, r4
	mla r2, r3, r4, r5
	mlas r2, r3, r4, r5
	.irp op, smull, umull, smlal, umlal
	\op r2, r3, r4, r5
	\op\()s r2, r3, r4, r5
	.endr
	umaal r2, r3, r4, r5
	.irp xy, bb, bt, tb, tt
	smul\xy r2, r3, r4
	smla\xy r2, r3, r4, r5
	smlal\xy r2, r3, r4, r5
	.endr
	.irp y, b, t
	smulw\y r2, r3, r4
	smlaw\y r2, r3, r4, r5
	.endr
	.irp op, smuad, smuadx, smusd, smusdx, smmul, smmulr
	\op r2, r3, r4
	.endr
	.irp op, smlad, smladx, smlsd, smlsdx, smmla, smmlar, smmls, smmlsr
	\op r2, r3, r4, r5
	.endr
	.irp op, smlald, smlaldx, smlsld, smlsldx
	\op r2, r3, r4, r5
	.endr
	END

	FORMS forms_memory
	mov r9, #4
	BEGIN
	.irp size, , b
	ldr\size r2, [r0]
	ldr\size r2, [r0, #8]
	ldr\size r2, [r1, #-8]
	ldr\size r2, [r0, r9]
	ldr\size r2, [r1, -r9]
	ldr\size r2, [r0, r9, lsl #2]
	ldr\size r2, [r0, r9, lsr #1]
	ldr\size r2, [r0, #8]!
	ldr\size r2, [r0, r9]!
	ldr\size r2, [r0], #-8
	ldr\size r2, [r0], -r9
	str\size r2, [r0]
	str\size r2, [r0, r9, lsl #2]
	str\size r2, [r0, #8]!
	str\size r2, [r0], #-8
	ldr\size\()t r2, [r0]
	str\size\()t r2, [r0]
	.endr
	.irp size, h, sb, sh, d
	ldr\size r2, [r0]
	ldr\size r2, [r0, #8]
	ldr\size r2, [r0, r9]
	ldr\size r2, [r1, -r9]
	ldr\size r2, [r0, #8]!
	ldr\size r2, [r0], #-8
	.endr
	.irp size, h, d
	str\size r2, [r0]
	str\size r2, [r0, r9]
	str\size r2, [r0, #8]!
	str\size r2, [r0], #-8
	.endr
	.irp mode, ia, ib
	ldm\mode r0, {r2, r4, r6}
	stm\mode r0, {r2, r4, r6}
	ldm\mode r0!, {r2, r4}
	.endr
	.irp mode, da, db
	ldm\mode r1, {r2, r4, r6}
	stm\mode r1, {r2, r4, r6}
	.endr
	ldrex r2, [r0]
	strex r3, r2, [r0]
	pld [r0]
	pld [r0, #64]
	pld [r0, r9]
	pld [r0, r9, lsl #2]
	mrc p15, 0, r2, c13, c0, 3
	mcr p15, 0, r2, c7, c10, 5
	nop
	END

	FORMS forms_vfp
	BEGIN
	.irp op, fmac, fnmac, fmsc, fnmsc, fmul, fnmul, fadd, fsub, fdiv
	\op\()s s0, s1, s2
	\op\()d d0, d1, d2
	.endr
	.irp op, fcpy, fabs, fneg, fsqrt, fcmp, fcmpe
	\op\()s s0, s1
	\op\()d d0, d1
	.endr
	fcmpzs s0
	fcmpezd d0
	fmstat
	fcvtds d0, s3
	fcvtsd s3, d0
	.irp op, fsito, fuito
	\op\()s s0, s1
	\op\()d d0, s3
	.endr
	.irp op, ftosi, ftoui, ftosiz, ftouiz
	\op\()s s0, s1
	\op\()d s3, d0
	.endr
	fmsr s0, r2
	fmrs r2, s0
	fmdlr d0, r2
	fmdhr d0, r2
	fmrdl r2, d0
	fmrdh r2, d0
	fmdrr d0, r2, r3
	fmrrd r2, r3, d0
	fmsrr {s2, s3}, r2, r3
	fmrrs r2, r3, {s2, s3}
	fmrx r2, fpscr
	fmxr fpscr, r2
	flds s0, [r0, #4]
	fsts s0, [r1, #-4]
	fldd d0, [r0, #8]
	fstd d0, [r0]
	fldmias r0, {s0-s3}
	fldmias r0!, {s0-s3}
	fldmdbs r0!, {s0-s3}
	fstmias r0, {s0-s3}
	fldmiad r0, {d0-d3}
	fstmdbd r1!, {d0-d3}
	fstmiad r1!, {d0-d3}
	fldmiax r0, {d0-d1}
	fstmiax r0, {d0-d1}
	END

	FORMS forms_branch
	mov r9, lr
	BEGIN
	b 1f
1:	bl 2f
2:	adr r2, 3f
	bx r2
3:	adr r2, 4f
	blx r2
4:	adr r2, 5f
	mov pc, r2
5:	adr r2, 6f
	str r2, [r0]
	ldr pc, [r0]
6:	adr r2, 7f
	str r2, [r0, #4]
	ldmia r0, {r3, pc}
7:	mov r2, #1
	cmp r2, #1
	ldrls pc, [pc, r2, lsl #2]
	b 8f
	.word 8f, 8f
8:	mov r2, #0
	add pc, pc, r2, lsl #2
	nop
	nop
	MARKER_END(0)
	bx r9
