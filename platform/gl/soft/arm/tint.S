/*
 * tint.c for ARMv6: the same bytes. Offsets are those of struct tint_band.
 *
 * A row costs 30 instructions; a pixel 51 with four texels mixed, 31 with the
 * nearest, 9 where it is hidden.
 */
	.syntax unified
	.arch armv6
	.arm
	.text

#define EDGE 40
#define EDGE_STEP 48
#define CONSTANTS 80
/* from there */
#define ROWS -24
#define MASKS 24
#define ROUND_PIXELS 32

/*
 * The next row, from column r12 on: r0 the constants, r1 depth, r2 z, r3 texel,
 * r4 red and blue, r5 green and, above it, how many pixels follow the first.
 */
	.macro	begin_row none
	ldmia	r0!, {r1-r5}
	ldmia	r0, {r6-r10}
	add	r6, r6, r1
	add	r7, r7, r2
	add	r8, r8, r3
	add	r9, r9, r4
	add	r10, r10, r5
	stmdb	r0!, {r6-r10}
	ldrd	r10, [r0, #EDGE]
	ldrd	r8, [r0, #EDGE_STEP]
	mov	r12, r10, asr #16
	rsbs	r6, r12, r11, asr #16
	add	r10, r10, r8
	add	r11, r11, r9
	strd	r10, [r0, #EDGE]
	add	r0, r0, #CONSTANTS
	ble	\none
	ldmdb	r0, {r8-r11}
	sub	r6, r6, #1
	add	r1, r1, r12, lsl #1
	mla	r5, r12, r11, r5
	mla	r2, r12, r8, r2
	mla	r3, r12, r9, r3
	mla	r4, r12, r10, r4
	pkhbt	r5, r5, r6, lsl #16
	.endm

/* On to \pixel with the next pixel, or behind the row. */
	.macro	next_pixel pixel
	ldmdb	r0, {r8-r11}
	add	r2, r2, r8
	add	r3, r3, r9
	add	r4, r4, r10
	adds	r5, r5, r11
	bpl	\pixel
	.endm

	.macro	next_row row
	ldr	r6, [r0, #ROWS]
	subs	r6, r6, #1
	str	r6, [r0, #ROWS]
	sub	r0, r0, #CONSTANTS
	bne	\row
	.endm

	.global	tint_linear_arm
	.type	tint_linear_arm, %function
tint_linear_arm:
	push	{r4-r11, lr}
.Llinear_row:
	begin_row .Llinear_end

.Llinear:
	ldrh	r6, [r1], #2
	cmp	r2, r6, lsl #16
	bhs	.Llinear_next
	/* mask, next, shift, texels, stride */
	ldmia	r0, {r8-r12}
	mov	r6, r2, lsr #16
	strh	r6, [r1, #-2]
	and	r6, r3, r8
	/* if a neighbour is at the other side of the level */
	adds	r7, r6, r9
	bicscc	r7, r7, r8
	bne	.Lwrap
	uxtb	r7, r6, ror #8
	add	r7, r7, r6, lsr r10
	add	r7, r11, r7, lsl #1
	ldr	r6, [r7]
	ldr	r7, [r7, r12]

	/* r6 the two above, r7 below; r10 and r11 their weights */
.Lmix:
	mov	r10, r3, lsl #24
	mov	r10, r10, lsr #27
	uxtb	r11, r3, ror #16
	rsb	r10, r10, r10, lsl #16
	add	r10, r10, #32
	ldrd	r8, [r0, #MASKS]
	mul	r11, r10, r11
	and	lr, r8, r6, lsr #6
	and	r12, r9, r6
	and	r6, r8, r6, lsl #5
	rsb	r10, r11, r10, lsl #8
	smuad	lr, lr, r10
	smuad	r12, r12, r10
	smuad	r6, r6, r10
	and	r10, r8, r7, lsr #6
	and	r9, r9, r7
	and	r7, r8, r7, lsl #5
	smlad	lr, r10, r11, lr
	smlad	r12, r9, r11, r12
	smlad	r6, r7, r11, r6
	ldrd	r8, [r0, #ROUND_PIXELS]
	smlawt	lr, lr, r4, r8
	smlawb	r12, r12, r5, r8
	smlawb	r6, r6, r4, r8
	and	lr, lr, #0x1F << 17
	and	r12, r12, #0x3F << 17
	mov	r6, r6, lsr #17
	orr	r6, r6, r12, lsr #12
	orr	r6, r6, lr, lsr #6
	strh	r6, [r1, r9]

.Llinear_next:
	next_pixel .Llinear
.Llinear_end:
	next_row .Llinear_row
	pop	{r4-r11, pc}

.Lwrap:
	add	r7, r6, #0x100
	add	r9, r6, #0x1000000
	and	r7, r7, r8
	and	r9, r9, r8
	uxtb	r8, r6, ror #8
	uxtb	r12, r7, ror #8
	mov	r6, r6, lsr r10
	mov	r9, r9, lsr r10
	add	r7, r11, r6, lsl #1
	add	r9, r11, r9, lsl #1
	add	r8, r8, r8
	add	r12, r12, r12
	ldrh	r6, [r7, r8]
	ldrh	r10, [r7, r12]
	ldrh	r7, [r9, r8]
	ldrh	r11, [r9, r12]
	orr	r6, r6, r10, lsl #16
	orr	r7, r7, r11, lsl #16
	b	.Lmix
	.size	tint_linear_arm, . - tint_linear_arm

	.global	tint_nearest_arm
	.type	tint_nearest_arm, %function
tint_nearest_arm:
	push	{r4-r11, lr}
.Lnearest_row:
	begin_row .Lnearest_end

.Lnearest:
	ldrh	r6, [r1], #2
	cmp	r2, r6, lsl #16
	bhs	.Lnearest_next
	ldmia	r0, {r8-r11}
	mov	r6, r2, lsr #16
	strh	r6, [r1, #-2]
	and	r6, r3, r8
	uxtb	r7, r6, ror #8
	add	r7, r7, r6, lsr r10
	add	r7, r7, r7
	ldrh	r7, [r11, r7]
	ldrd	r8, [r0, #MASKS]
	ldrd	r10, [r0, #ROUND_PIXELS]
	and	r12, r8, r7, lsr #6
	and	r9, r9, r7
	and	r7, r8, r7, lsl #5
	smlabt	r12, r12, r4, r10
	smlabb	r9, r9, r5, r10
	smlabb	r7, r7, r4, r10
	and	r12, r12, #0x1F << 20
	and	r9, r9, #0x3F << 20
	mov	r7, r7, lsr #20
	orr	r7, r7, r9, lsr #15
	orr	r7, r7, r12, lsr #9
	strh	r7, [r1, r11]

.Lnearest_next:
	next_pixel .Lnearest
.Lnearest_end:
	next_row .Lnearest_row
	pop	{r4-r11, pc}
	.size	tint_nearest_arm, . - tint_nearest_arm

	.section .note.GNU-stack, "", %progbits
