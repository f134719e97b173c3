/* A program with an instruction that the model cannot decode: SETEND LE. */
#include "tests/arm1136/marker.h"

	.arm
	.balign 32
	.globl _start
	.type _start, %function
_start:
	MARKER_BEGIN(0)
	mov r0, #1
	.inst 0xf1010000
	mov r0, #0
	MARKER_END(0)
	mov r7, #1
	svc 0
