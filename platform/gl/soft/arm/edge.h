/*
 * raster.h's raster_side() of small triangles, and 0x7FFF more: from r1 to r2,
 * both struct cache_tag's xy, at the first row, r3; lr has 2^31 / n. Leaves x in
 * r1, the step in r2, and neither r3 nor r12.
 */
	.macro	find_edge
	ssub16	r2, r2, r1
	mov	r12, r2, lsr #16
	ldr	r12, [lr, r12, lsl #2]
	mov	r2, r2, lsl #17
	smmul	r2, r2, r12
	mov	r12, r1, lsr #16
	rsb	r12, r12, r3, lsl #4
	mov	r1, r1, lsl #16
	add	r12, r12, #8
	mov	r1, r1, lsr #4
	mov	r3, r2, asr #4
	add	r1, r1, #0x8000
	mla	r1, r3, r12, r1
	sub	r1, r1, #1
	.endm
