/*
 * tint.c for ARMv6: the same bytes. Offsets are those of struct tint_band.
 *
 * A row costs 31 instructions; a pixel 51 with four texels mixed, 31 with the
 * nearest, 10 where it is hidden; 55 if it is added, 63 if it multiplies, 62 if
 * it is a product of directions.
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
	pld	[r6, r12, lsl #1]
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

/* A pixel further; early on, as it takes its time. */
	.macro	load_steps
	ldmdb	r0, {r7, r8, r10, r11}
	.endm

/* On to \pixel with the next pixel, or behind the row. */
	.macro	next_pixel pixel
	add	r2, r2, r7
	add	r3, r3, r8
	add	r4, r4, r10
	adds	r5, r5, r11
	bpl	\pixel
	.endm

/* Pixels that are not seen, out of the way. */
	.macro	hidden_pixel next
	load_steps
	b	\next
	.endm

	.macro	next_row row
	ldr	r6, [r0, #ROWS]
	subs	r6, r6, #1
	str	r6, [r0, #ROWS]
	sub	r0, r0, #CONSTANTS
	bne	\row
	.endm

/*
 * soft_tint_NAME_arm(): four texels mixed, into lr red, r12 green and r6 blue, then
 * the macro \finish. Where \equal is 1 the depth has to be, and stays, what it
 * is.
 */
	.macro	linear name, finish, equal=0
	.global	soft_tint_\name\()_arm
	.type	soft_tint_\name\()_arm, %function
soft_tint_\name\()_arm:
	push	{r4-r11, lr}
.Lrow_\name:
	begin_row .Lend_\name

.Lpixel_\name:
	ldrh	r6, [r1], #2
	.if	\equal
	cmp	r6, r2, lsr #16
	bne	.Lhidden_\name
	ldmia	r0, {r8-r12}
	.else
	cmp	r2, r6, lsl #16
	bhs	.Lhidden_\name
	/* mask, next, shift, texels, stride */
	ldmia	r0, {r8-r12}
	mov	r6, r2, lsr #16
	strh	r6, [r1, #-2]
	.endif
	and	r6, r3, r8
	/* if a neighbour is at the other side of the level */
	adds	r7, r6, r9
	bicscc	r7, r7, r8
	bne	.Lwrap_\name
	uxtb	r7, r6, ror #8
	add	r7, r7, r6, lsr r10
	add	r7, r11, r7, lsl #1
	ldr	r6, [r7]
	ldr	r7, [r7, r12]

	/* r6 the two above, r7 below; r10 and r11 their weights */
.Lmix_\name:
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
	\finish

.Lnext_\name:
	next_pixel .Lpixel_\name
.Lend_\name:
	next_row .Lrow_\name
	pop	{r4-r11, pc}

.Lhidden_\name:
	hidden_pixel .Lnext_\name

.Lwrap_\name:
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
	b	.Lmix_\name
	.size	soft_tint_\name\()_arm, . - soft_tint_\name\()_arm
	.endm

/* Tinted, and written. */
	.macro	write_color
	ldrd	r8, [r0, #ROUND_PIXELS]
	smlawt	lr, lr, r4, r8
	smlawb	r12, r12, r5, r8
	smlawb	r6, r6, r4, r8
	load_steps
	and	lr, lr, #0x1F << 17
	and	r12, r12, #0x3F << 17
	mov	r6, r6, lsr #17
	orr	r6, r6, r12, lsr #12
	orr	r6, r6, lr, lsr #6
	strh	r6, [r1, r9]
	.endm

/* Tinted, and added to the picture. */
	.macro	add_color
	ldrd	r8, [r0, #ROUND_PIXELS]
	smlawt	lr, lr, r4, r8
	ldrh	r7, [r1, r9]
	smlawb	r12, r12, r5, r8
	smlawb	r6, r6, r4, r8
	and	r10, r7, #0xF800
	and	r11, r7, #0x07E0
	and	r7, r7, #31
	add	lr, lr, r10, lsl #6
	add	r12, r12, r11, lsl #12
	add	r6, r6, r7, lsl #17
	load_steps
	usat	lr, #5, lr, asr #17
	usat	r12, #6, r12, asr #17
	usat	r6, #5, r6, asr #17
	orr	r6, r6, r12, lsl #5
	orr	r6, r6, lr, lsl #11
	strh	r6, [r1, r9]
	.endm

/* Tinted; the picture is multiplied by it, in 1/1023 and 1/4095. */
	.macro	multiply_color
	ldr	r9, [r0, #ROUND_PIXELS + 4]
	smulwt	lr, lr, r4
	ldrh	r7, [r1, r9]
	smulwb	r12, r12, r5
	smulwb	r6, r6, r4
	mov	r8, r7, lsr #11
	and	r10, r7, #0x07E0
	and	r7, r7, #31
	add	r8, r8, r8, lsl #5
	mov	r10, r10, lsl #1
	add	r7, r7, r7, lsl #5
	add	r10, r10, r10, lsr #6
	smulwb	lr, lr, r8
	smulwb	r12, r12, r10
	smulwb	r6, r6, r7
	load_steps
	add	lr, lr, #1 << 10
	add	r12, r12, #1 << 12
	add	r6, r6, #1 << 10
	mov	lr, lr, lsr #11
	mov	r12, r12, lsr #13
	mov	r6, r6, lsr #11
	orr	r6, r6, r12, lsl #5
	orr	r6, r6, lr, lsl #11
	strh	r6, [r1, r9]
	.endm

/* Texel and colour as directions: what one has of the other, as a gray. */
	.macro	write_dot
	ldr	r9, [r0, #ROUND_PIXELS + 4]
	add	lr, lr, lr, lsr #6
	add	r6, r6, r6, lsr #6
	sub	r12, r12, #63 << 17
	sub	lr, lr, #63 << 16
	sub	r6, r6, #63 << 16
	smulwb	r8, r12, r5
	smulwt	r7, lr, r4
	smlawb	r7, r6, r4, r7
	sub	r8, r8, r12, asr #2
	sub	r7, r7, lr, asr #2
	sub	r7, r7, r6, asr #2
	add	r7, r8, r7, lsl #1
	sub	r6, r7, r7, asr #6
	add	r12, r7, #1 << 14
	add	r6, r6, #1 << 15
	load_steps
	usat	r12, #6, r12, asr #15
	usat	r6, #5, r6, asr #16
	orr	r12, r6, r12, lsl #5
	orr	r12, r12, r6, lsl #11
	strh	r12, [r1, r9]
	.endm

	linear	linear, write_color
	linear	add, add_color, 1
	linear	multiply, multiply_color, 1
	linear	dot, write_dot

	.global	soft_tint_nearest_arm
	.type	soft_tint_nearest_arm, %function
soft_tint_nearest_arm:
	push	{r4-r11, lr}
.Lnearest_row:
	begin_row .Lnearest_end

.Lnearest:
	ldrh	r6, [r1], #2
	cmp	r2, r6, lsl #16
	bhs	.Lnearest_hidden
	ldmia	r0, {r8-r11}
	mov	r6, r2, lsr #16
	strh	r6, [r1, #-2]
	and	r6, r3, r8
	uxtb	r7, r6, ror #8
	add	r7, r7, r6, lsr r10
	add	r7, r7, r7
	ldrh	r7, [r11, r7]
	ldrd	r10, [r0, #MASKS]
	ldrd	r8, [r0, #ROUND_PIXELS]
	and	r12, r10, r7, lsr #6
	and	r6, r10, r7, lsl #5
	and	r7, r11, r7
	smlabt	r12, r12, r4, r8
	smlabb	lr, r7, r5, r8
	smlabb	r6, r6, r4, r8
	load_steps
	and	r12, r12, #0x1F << 20
	and	lr, lr, #0x3F << 20
	mov	r6, r6, lsr #20
	orr	r6, r6, lr, lsr #15
	orr	r6, r6, r12, lsr #9
	strh	r6, [r1, r9]

.Lnearest_next:
	next_pixel .Lnearest
.Lnearest_end:
	next_row .Lnearest_row
	pop	{r4-r11, pc}

.Lnearest_hidden:
	hidden_pixel .Lnearest_next
	.size	soft_tint_nearest_arm, . - soft_tint_nearest_arm

	.section .note.GNU-stack, "", %progbits
