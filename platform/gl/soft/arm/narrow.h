/*
 * What narrow.S sets up and narrow_rows.S walks, on their stack, and in
 *
 *	r0	the row's depths, from column -24 on
 *	r4, r5	z and the packed colour, of the same
 *	r6, r7	what they grow by with a pixel
 *	r8	WIDE_MASK
 *	r9	from behind a depth to its pixel
 *	r10	the left edge, 24 pixels further right, r11 the right edge
 */
#define STRIDE 0 /* what a row adds to r0, r4, r5, r10, r11 */
#define Z_DOWN 4
#define PACKED_DOWN 8
#define LEFT_STEP 12
#define RIGHT_STEP 16
#define COLUMN 20 /* less 24, negative: where the colours are from */
#define RED 24    /* struct channel */
#define GREEN 32
#define BLUE 40
#define REST 48 /* rows of the part after those under way */
#define CHUNK 52
#define Z 56
#define SIDE 64 /* negative: the middle corner is left of the long edge */
#define LATER 68 /* rows of the lower part */
#define RETURN 72
#define END 76 /* r0 after the rows under way */
#define DRAW 84
#define SETUP 88
