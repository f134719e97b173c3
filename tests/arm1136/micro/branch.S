#include "tests/arm1136/micro/cases.h"

	/*
	 * Manual, table 16-11. The predictor knows the loop: its branch is
	 * folded nine times and mispredicted once: 7, right after the flags.
	 */
	CASE loop_folded, 18
	BEGIN
	mov r2, #10
1:	subs r2, r2, #1
	bne 1b
	END

	/* The flags were set earlier, so the misprediction takes 6, then 5. */
	CASE loop_one_between, 27
	BEGIN
	mov r2, #10
1:	subs r2, r2, #1
	mov r3, #1
	bne 1b
	END

	CASE loop_two_between, 36
	BEGIN
	mov r2, #10
1:	subs r2, r2, #1
	mov r3, #1
	mov r4, #1
	bne 1b
	END

	/*
	 * Two branches of a doubleword share an entry of the predictor and
	 * evict each other. The static predictor is right about these, which
	 * lead forward and are never taken.
	 */
	CASE static_not_taken, 9
	cmp r0, r0
	nop
	BEGIN
	.rept 8
	bne 1f
	.endr
1:	mov r2, #1
	END

	/* Branches with an entry each are folded. */
	CASE dynamic_not_taken, 8
	cmp r0, r0
	BEGIN
	.rept 8
	bne 1f
	mov r2, #1
	.endr
1:	END

	/*
	 * Two branches that share an entry of the predictor evict each other,
	 * so that both are predicted statically: 4 each.
	 */
	CASE static_taken, 10
	b 1f
	.balign 1024
	nop
1:	BEGIN
	mov r2, #1
	b 2f
	.space 1020
2:	b 3f
	nop
3:	mov r2, #1
	END

	/* Forward branches are predicted not taken: 7 after the flags, then 5. */
	CASE static_mispredicted, 14
	b 1f
	.balign 1024
	nop
1:	BEGIN
	cmp r0, r0
	beq 2f
	.space 1020
2:	beq 3f
	nop
3:	mov r2, #1
	END

	CASE branch_always_folded, 8
	b 1f
	.balign 1024
	.space 512
1:	BEGIN
	.rept 8
	b 1f
	nop
1:	mov r2, #1
	.endr
	END

	/* A predicted branch that leads to another branch is not folded. */
	CASE branch_to_branch, 1
	BEGIN
	b 1f
	nop
1:	b 2f
	nop
2:	END

	/*
	 * A call is not folded, and its return is predicted: 1 + 1 + 4. Two
	 * branches of an aligned doubleword would share an entry.
	 */
	CASE call_and_return, 28
	mov r9, lr
	BEGIN
	.rept 4
	bl leaf
	mov r2, #1
	.endr
	MARKER_END(0)
	bx r9
	.type leaf, %function
leaf:
	mov r2, #1
	bx lr

	CASE call_and_pop, 40
	mov r9, lr
	ldr sp, =data + 4096
	BEGIN
	.rept 4
	bl popping
	mov r2, #1
	.endr
	MARKER_END(0)
	bx r9
	.ltorg
	.type popping, %function
popping:
	push {r4, lr}
	mov r2, #1
	mov r3, #1
	mov r4, #1
	pop {r4, pc}

	/*
	 * The return stack has three entries: the fourth return finds none.
	 * Four calls, six moves, returns of 4, 4, 4 and 5.
	 */
	CASE call_four_deep, 27
	mov r9, lr
	BEGIN
	bl deep1
	MARKER_END(0)
	bx r9
deep1:	mov r2, lr
	bl deep2
	mov lr, r2
	bx lr
deep2:	mov r3, lr
	bl deep3
	mov lr, r3
	bx lr
deep3:	mov r4, lr
	bl deep4
	mov lr, r4
	bx lr
deep4:	bx lr

	/* A computed branch is not predicted: 5. */
	CASE branch_to_register, 6
	adr r3, 1f
	BEGIN
	bx r3
	nop
1:	mov r2, #1
	END

	CASE load_pc, 9
	adr r3, 1f
	str r3, [r0]
	BEGIN
	ldr pc, [r0]
	nop
1:	mov r2, #1
	END

	CASE conditional_return_not_taken, 2
	cmp r0, r0
	BEGIN
	bxne lr
	mov r2, #1
	END
