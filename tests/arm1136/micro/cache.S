#include "tests/arm1136/micro/cases.h"

	/* All data is in L1. */
	CASE resident_lines, 8
	ldr r3, [r0, #96]
	BEGIN
	.rept 2
	ldr r2, [r0]
	ldr r3, [r0, #32]
	ldr r4, [r0, #64]
	ldr r5, [r0, #96]
	.endr
	END

	/* Data is in L2: 10 more than 3, then the addition. */
	CASE l2_use, 14
	MARKER_FLUSH(MARKER_L1_DATA)
	BEGIN
	ldr r2, [r0]
	add r3, r4, r2
	END

	/* Data is in memory: 80 more. */
	CASE ddr_use, 84
	MARKER_FLUSH(MARKER_DATA)
	BEGIN
	ldr r2, [r0]
	add r3, r4, r2
	END

	/* Only instructions that need the result wait for a miss. */
	CASE miss_beside_work, 51
	MARKER_FLUSH(MARKER_DATA)
	BEGIN
	ldr r2, [r0]
	.rept 50
	add r3, r3, #1
	.endr
	END

	CASE hit_under_miss, 5
	MARKER_FLUSH(MARKER_DATA)
	ldr r2, [r1]
	add r2, r2, #1
	BEGIN
	ldr r2, [r0]
	ldr r3, [r1]
	add r4, r3, #1
	END

	/* The second line waits 40 until memory is free, then takes 80. */
	CASE two_misses, 124
	MARKER_FLUSH(MARKER_DATA)
	BEGIN
	ldr r2, [r0]
	ldr r3, [r1]
	add r4, r3, r2
	END

	/* Four lines, each used before the next is requested. */
	CASE ddr_streaming, 336
	MARKER_FLUSH(MARKER_DATA)
	BEGIN
	.irp n, 0, 32, 64, 96
	ldr r2, [r0, #\n]
	add r3, r4, r2
	.endr
	END

	CASE l2_streaming, 56
	ldr r3, [r0, #96]
	MARKER_FLUSH(MARKER_L1_DATA)
	BEGIN
	.irp n, 0, 32, 64, 96
	ldr r2, [r0, #\n]
	add r3, r4, r2
	.endr
	END

	/*
	 * A store that misses does not load the line. So the load misses as
	 * well, after the store has left the write buffer: 1 + 16 + 84.
	 */
	CASE store_miss_does_not_allocate, 101
	MARKER_FLUSH(MARKER_DATA)
	BEGIN
	str r2, [r0]
	ldr r3, [r0, #4]
	add r4, r3, #1
	END

	/* A store that hits leaves its line in L1. */
	CASE store_hit, 5
	MARKER_FLUSH(MARKER_DATA)
	ldr r2, [r0]
	add r2, r2, #1
	BEGIN
	str r2, [r0]
	ldr r3, [r0, #4]
	add r4, r3, #1
	END

	/* An early preload hides the whole miss, a late one hides a part. */
	CASE pld_hides, 105
	MARKER_FLUSH(MARKER_DATA)
	BEGIN
	pld [r0]
	.rept 100
	add r3, r3, #1
	.endr
	ldr r2, [r0]
	add r4, r2, #1
	END

	CASE pld_late, 84
	MARKER_FLUSH(MARKER_DATA)
	BEGIN
	pld [r0]
	.rept 40
	add r3, r3, #1
	.endr
	ldr r2, [r0]
	add r4, r2, #1
	END

	CASE pld_dropped, 9
	ldr r2, [r0]
	add r2, r2, #1
	BEGIN
	.rept 4
	pld [r0]
	add r3, r3, #1
	.endr
	ldr r2, [r0]
	END

	/* The model computes the address from moves, additions and loads. */
	CASE pld_address_followed, 109
	str r0, [r0]
	MARKER_FLUSH(MARKER_DATA)
	ldr r2, [r0]
	add r5, r2, #64
	mov r6, #4
	BEGIN
	pld [r5, r6, lsl #3]
	.rept 100
	add r3, r3, #1
	.endr
	add r1, r1, #32
	nop
	nop
	ldr r2, [r1]
	add r4, r2, #1
	END

	/*
	 * Whole lines are written past the caches; each occupies memory for 16
	 * cycles. The first leaves at 4. The last store waits until the tenth
	 * has left: 4 + 10 x 16 + 1.
	 */
	CASE store_streaming, 165
	MARKER_FLUSH(MARKER_DATA)
	BEGIN
	.rept 16
	stmia r0!, {r2-r9}
	.endr
	END
