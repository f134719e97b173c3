/*
 * A pixel of band.c's and fill_narrow.c's rows: r1 the depth's address, \depth
 * the depth, r2 z, r3 the packed colour, r6 and r7 what the two grow by, r8
 * WIDE_MASK, r9 from behind a depth to its pixel. Loads the next depth, which
 * takes as long as the rest. Those who jump to them know the 9 instructions.
 */
	.macro	depth_tested_pixel depth, temp
	cmp	r2, \depth, lsl #16
	ldrh	\depth, [r1, #2]!
	movlo	\temp, r2, lsr #16
	strhlo	\temp, [r1, #-2]
	andlo	\temp, r8, r3, ror #5
	add	r2, r2, r6
	orrlo	\temp, \temp, \temp, lsr #16
	strhlo	\temp, [r1, r9]
	add	r3, r3, r7
	.endm

/* The last of a row. */
	.macro	see_last depth, temp
	cmp	r2, \depth, lsl #16
	movlo	\temp, r2, lsr #16
	strhlo	\temp, [r1], #2
	andlo	\temp, r8, r3, ror #5
	orrlo	\temp, \temp, \temp, lsr #16
	strhlo	\temp, [r1, r9]
	.endm
