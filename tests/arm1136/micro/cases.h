/*
 * Macros for a test program of the timing model. A case is a sequence whose
 * cycles follow from the published tables. Each case runs three times; micro.sh
 * compares the cycles of the last run, in which code, data and predictor are
 * warm unless the case empties the caches.
 *
 *   CASE name, cycles
 *   ... set-up, which does not count: r0-r9, r12 and the VFP are free; r0 points
 *       to data, r1 to data + 64
 *   BEGIN
 *   ... the sequence that counts
 *   END
 */
/* clang-format off: this is assembly. */
#include "tests/arm1136/marker.h"

	.syntax unified
	.arm
	.fpu vfpv2

	.macro CASE name, cycles
	.section cases, "a"
	.word \name
	.text
	.balign 32
	.type \name, %function
\name :
	.endm

	/* Three cycles, after which all results of the set-up are ready. */
	.macro BEGIN
	.rept 3
	mov r12, r12
	.endr
	MARKER_BEGIN(0)
	.endm

	.macro END
	MARKER_END(0)
	bx lr
	.ltorg
	.endm

	/* Sets LEN, from 1 to 8; uses r12. */
	.macro VECTOR length
	fmrx r12, fpscr
	bic r12, r12, #7 << 16
	orr r12, r12, #(\length - 1) << 16
	fmxr fpscr, r12
	.endm

	.bss
	.balign 4096
data:
	.space 512 * 1024

	/* Aligned, so that cases can avoid its branch's predictor entry. */
	.text
	.balign 1024
	.globl _start
	.type _start, %function
_start:
	ldr r10, =__start_cases
1:
	mov r11, #3
2:
	ldr r0, =data
	add r1, r0, #64
	mov r2, #1
	mov r3, #2
	mov r4, #3
	mov r5, #4
	str r0, [r0]
	mov r6, #5
	mov r7, #6
	mov r8, #7
	mov r9, #8
	ldr r12, [r10]
	mov lr, pc
	bx r12
	VECTOR 1
	subs r11, r11, #1
	bne 2b
	add r10, r10, #4
	ldr r0, =__stop_cases
	cmp r10, r0
	blo 1b
	mov r0, #0
	mov r7, #1
	svc 0
	.ltorg
