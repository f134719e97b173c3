#include "tests/arm1136/micro/cases.h"

	/* The MicroTLB holds ten pages at once. */
	CASE ten_pages, 4
	.irp n, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9
	add r5, r0, #\n * 4096
	ldr r2, [r5, #\n * 32]
	.endr
	add r2, r2, #1
	BEGIN
	ldr r2, [r0]
	add r3, r4, r2
	END

	/* An eleventh page evicts the first, which costs 8 more than a hit. */
	CASE eleven_pages, 12
	.irp n, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10
	add r5, r0, #\n * 4096
	ldr r2, [r5, #\n * 32]
	.endr
	add r2, r2, #1
	BEGIN
	ldr r2, [r0]
	add r3, r4, r2
	END

	/* Two words of the page tables come from L2: 8 + 10 + 10 more. */
	CASE page_walk_in_l2, 32
	ldr r2, [r0]
	MARKER_FLUSH(MARKER_PAGES)
	BEGIN
	ldr r2, [r0]
	add r3, r4, r2
	END

	/* The words, then the line come from memory: 8 + 80 + 80 + 80 more. */
	CASE page_walk_in_memory, 252
	MARKER_FLUSH(MARKER_DATA)
	MARKER_FLUSH(MARKER_PAGES)
	BEGIN
	ldr r2, [r0]
	add r3, r4, r2
	END

	/* Instructions that access no memory do not wait. */
	CASE page_walk_beside_work, 51
	ldr r2, [r0]
	MARKER_FLUSH(MARKER_PAGES)
	BEGIN
	ldr r2, [r0]
	.rept 50
	add r3, r3, #1
	.endr
	END

	/* A hit does not pass a load that awaits its page: 1 + 27, then 4. */
	CASE no_hit_under_page_walk, 32
	ldr r2, [r0]
	add r5, r0, #4096
	ldr r2, [r5, #128]
	MARKER_FLUSH(MARKER_PAGES)
	ldr r2, [r5, #128]
	add r2, r2, #1
	BEGIN
	ldr r2, [r0]
	ldr r6, [r5, #128]
	add r3, r4, r6
	END

	/* A store waits for its page, too: 28, then the load. */
	CASE store_waits_for_page, 32
	ldr r2, [r0]
	add r5, r0, #4096
	ldr r2, [r5, #128]
	MARKER_FLUSH(MARKER_PAGES)
	ldr r2, [r5, #128]
	add r2, r2, #1
	BEGIN
	str r2, [r0]
	ldr r6, [r5, #128]
	add r3, r4, r6
	END

	/* Pages 32 apart share a set of the main TLB; a third one evicts one. */
	CASE main_tlb_has_two_ways, 32
	add r5, r0, #32 * 4096
	ldr r2, [r5, #1024]
	add r6, r5, #32 * 4096
	ldr r2, [r6, #2048]
	.irp n, 1, 2, 3, 4, 5, 6, 7, 8
	add r6, r0, #\n * 4096
	ldr r2, [r6, #\n * 32]
	.endr
	add r2, r2, #1
	BEGIN
	ldr r2, [r0]
	add r3, r4, r2
	END
