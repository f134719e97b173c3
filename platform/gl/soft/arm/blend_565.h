/*
 * The pixel in \wide's lower half, whose upper half is 0, becomes one mixed as
 * pixel.h mixes wide ones: \fraction of it, in 32nds, and \own, which is the rest
 * and WIDE_ROUND. \mask is WIDE_MASK.
 */
	.macro	mix_wide wide, fraction, own, mask
	orr	\wide, \wide, \wide, lsl #16
	and	\wide, \wide, \mask
	mla	\wide, \fraction, \wide, \own
	and	\wide, \mask, \wide, lsr #5
	orr	\wide, \wide, \wide, lsr #16
	.endm
