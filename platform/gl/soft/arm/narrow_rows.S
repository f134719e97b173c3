/*
 * fast/narrow_rows.c for ARMv6, with the same results. A row costs 15 instructions,
 * a pixel 9, whether it is visible or not. arm/layout.c asserts these offsets.
 */
	.syntax unified
	.arch armv6
	.arm
	.text

#define DOWN 20
#define MIDDLE_LEFT 60
#define RED 72
#define GREEN 80
#define BLUE 88
#define COLUMN 96

/* offsets from sp; at sp are five words: a row's steps of r0, r4, r5, r10, r11 */
#define LEFT_STEP 12
#define RIGHT_STEP 16
#define END 20  /* r0 after the rows under way */
#define REST 24 /* two words: rows left of the band, and of the chunk */
#define MORE 32 /* rows of the band below the middle vertex */
#define NARROW 40 /* address of struct narrow */

#define COLUMNS 24

/*
 * A pixel: r1 address of the depth, r12 the depth, r2 z, r3 packed colour; passes
 * is the condition, hi or hs, for the depth to pass. Loads the next pixel's depth
 * early, to hide the latency. The jump to pixels relies on there being 9
 * instructions.
 */
	.macro	pixel passes
	cmp	r12, r2, lsr #16
	ldrh	r12, [r1, #2]!
	mov\passes	lr, r2, lsr #16
	strh\passes	lr, [r1, #-2]
	and\passes	lr, r8, r3, ror #5
	add	r2, r2, r6
	orr\passes	lr, lr, lr, lsr #16
	strh\passes	lr, [r1, r9]
	add	r3, r3, r7
	.endm

/* The last pixel of a row: loads and steps nothing for a next one. */
	.macro	last_pixel passes
	cmp	r12, r2, lsr #16
	mov\passes	lr, r2, lsr #16
	strh\passes	lr, [r1], #2
	and\passes	lr, r8, r3, ror #5
	orr\passes	lr, lr, lr, lsr #16
	strh\passes	lr, [r1, r9]
	.endm

/*
 * r0 the row's depths, r4 z, r5 packed colour, r6 and r7 their steps a pixel, r8
 * WIDE_MASK, r9 the distance from a depth + 2 to its pixel, r10 left edge, r11
 * right edge.
 */
	.macro	narrow_rows name, passes
	.global	\name
	.type	\name, %function
\name:
	push	{r0, r4-r11, lr}
	add	r8, r0, #DOWN
	ldm	r0, {r0, r4, r5, r10, r11}
	ldm	r8!, {r1, r2, r3, r12, lr}
	sub	sp, sp, #NARROW
	stm	sp, {r1, r2, r3, r12, lr}
	ldm	r8, {r6, r7, r9, r12, lr}
	str	r12, [sp, #MORE]
	ldr	r8, =0x07E0F81F
	add	r10, r10, #24 << 16
	movs	r2, lr
	mov	r3, #8
	beq	.Lturn\@
.Lrows\@:	cmp	r2, r3
	movle	r12, r2
	movgt	r12, r3
	ldr	r1, [sp]
	sub	r2, r2, r12
	sub	r3, r3, r12
	strd	r2, [sp, #REST]
	mla	r1, r12, r1, r0
	str	r1, [sp, #END]

.Lrow\@:	mov	lr, r10, asr #16
	mla	r2, lr, r6, r4
	add	r1, r0, lr, lsl #1
	mla	r3, lr, r7, r5
	ldrh	r12, [r1, #-48]!
	sub	lr, lr, r11, asr #16
	cmp	lr, #COLUMNS - 1
	addls	lr, lr, lr, lsl #3
	addls	pc, pc, lr, lsl #2
	b	.Lnext\@
	.rept	COLUMNS - 1
	pixel	\passes
	.endr
	last_pixel	\passes
.Lnext\@:	ldm	sp, {r1, r2, r3, r12, lr}
	add	r0, r0, r1
	ldr	r1, [sp, #END]
	add	r4, r4, r2
	add	r5, r5, r3
	add	r10, r10, r12
	add	r11, r11, lr
	cmp	r0, r1
	bne	.Lrow\@

	ldrd	r2, [sp, #REST]
	cmp	r2, #0
	beq	.Lturn\@
.Lsegment\@:
	cmp	r3, #0
	bne	.Lrows\@

	/* Steps the channels' colour by 8 rows and packs it, as pack_again(). */
	ldr	r1, [sp, #NARROW]
	ldr	r3, [r1, #RED]
	ldr	r5, [r1, #RED + 4]
	ldr	r12, [r1, #GREEN]
	ldr	lr, [r1, #GREEN + 4]
	add	r3, r3, r5, lsl #2
	str	r3, [r1, #RED]
	ldr	r5, [r1, #BLUE]
	add	r12, r12, lr, lsl #2
	ldr	lr, [r1, #BLUE + 4]
	str	r12, [r1, #GREEN]
	mov	r3, r3, asr #12
	add	r5, r5, lr, lsl #2
	str	r5, [r1, #BLUE]
	ldr	lr, [r1, #COLUMN]
	mov	r5, r5, asr #13
	mov	r12, r12, asr #12
	add	r5, r5, r3, lsl #10
	mul	lr, r7, lr
	add	r5, r5, r12, lsl #21
	sub	r5, r5, lr
	mov	r3, #8
	b	.Lrows\@

	/* At the middle vertex, replaces the left edge or the right one. */
.Lturn\@:
	ldr	r2, [sp, #MORE]
	cmp	r2, #0
	beq	.Ldone\@
	ldr	r12, [sp, #NARROW]
	mov	r1, #0
	str	r1, [sp, #MORE]
	add	r12, r12, #MIDDLE_LEFT
	ldm	r12, {r1, r12, lr}
	cmp	r1, #0
	addne	r10, r12, #24 << 16
	strne	lr, [sp, #LEFT_STEP]
	moveq	r11, r12
	streq	lr, [sp, #RIGHT_STEP]
	b	.Lsegment\@
.Ldone\@:	add	sp, sp, #NARROW + 4
	pop	{r4-r11, pc}
	.ltorg
	.size	\name, . - \name
	.endm

	narrow_rows	soft_narrow_rows, hi
	narrow_rows	soft_narrow_rows_equal, hs

	.section .note.GNU-stack, "", %progbits
