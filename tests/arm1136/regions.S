/* A program with 513 regions, one more than the model has room for. */
#include "tests/arm1136/marker.h"

	.arm
	.balign 32
	.globl _start
	.type _start, %function
_start:
	.rept 513
	MARKER_BEGIN(0)
	mov r0, #1
	MARKER_END(0)
	.endr
	mov r0, #0
	mov r7, #1
	svc 0
