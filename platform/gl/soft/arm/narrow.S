/*
 * fill_narrow.c for ARMv6: the same bytes. Offsets are those of struct view,
 * struct fast_setup, struct setup and struct vertex.
 */
#include "platform/gl/soft/arm/offsets.h"
#include "platform/gl/soft/arm/narrow.h"

	.syntax unified
	.arch armv6
	.arm
	.text

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

#define ROOM 84 /* then r0 and r1 follow */

/*
 * A channel of the colour. r4, r5, r6 vertices, r2 and r3 their x and y from
 * the first one, of the second in the lower half; r11 where the start is, lr
 * the shift; r12 and r10 get what packed grows by. Leaves the start in r0.
 */
	.macro	add_channel at, color, inverse, bits, cut, place, round
	ldr	r7, [r4, #\color]
	ldr	r0, [r5, #\color]
	ldr	r1, [r6, #\color]
	sub	r0, r0, r7
	sub	r1, r1, r7
	mov	r0, r0, asr #1
	pkhbt	r0, r0, r1, lsl #15
	smusdx	r1, r2, r0
	smusdx	r0, r0, r3
	rsb	r7, r7, r7, lsl #\bits
	smmul	r1, r1, \inverse
	smmul	r0, r0, \inverse
	mov	r7, r7, lsl #7 - \bits
	mov	r1, r1, lsl lr
	mov	r0, r0, lsl lr
	smlawb	r7, r0, r11, r7
	add	r0, r0, #1 << (\cut - 1)
	mov	r0, r0, asr #\cut
	smlawt	r7, r1, r11, r7
	.if	\place
	add	r12, r12, r0, lsl #\place
	.else
	mov	r12, r0
	.endif
	add	r0, r7, #\round
	strd	r0, [sp, #\at]
	add	r1, r1, #1 << (\cut - 1)
	mov	r1, r1, asr #\cut
	.if	\place
	add	r10, r10, r1, lsl #\place
	.else
	mov	r10, r1
	.endif
	.endm

	/* It is the left one or, where the middle corner is elsewhere, right. */
	.macro	set_edge left, right
	add\left	r10, r1, #24 << 16
	str\left	r2, [sp, #LEFT_STEP]
	mov\right	r11, r1
	str\right	r2, [sp, #RIGHT_STEP]
	.endm

	.global	soft_fill_narrow
	.type	soft_fill_narrow, %function
soft_fill_narrow:
	ldr	r2, [r1, #SETUP_FLAGS]
	ldr	r3, [r1, #SETUP_COLUMNS]
	tst	r2, #1 << 16
	beq	soft_rows_fill
	cmp	r3, #23
	bgt	soft_rows_fill
	push	{r0, r1, r4-r11, lr}
	sub	sp, sp, #ROOM
	ldr	r12, [r0, #FAST_SETUP_PERSPECTIVE]
	ldm	r1, {r4-r10}
	cmp	r12, #0
	beq	1f
	ldr	r2, [r4, #VERTEX_W]
	ldr	r3, [r5, #VERTEX_W]
	ldr	lr, [r6, #VERTEX_W]
	subs	r3, r3, r2
	rsbmi	r3, r3, #0
	subs	lr, lr, r2
	rsbmi	lr, lr, #0
	add	r3, r3, lr
	cmp	r3, r2, asr #6
	bgt	.Ldiffer

	/* r12 the area's reciprocal, lr the shift */
1:	ldr	r3, [r1, #SETUP_AREA]
	ldr	r12, [r0, #VIEW_RECIPROCALS]
	ssub16	r8, r8, r7
	ssub16	r9, r9, r7
	clz	lr, r3
	mov	r2, r3, lsl lr
	mov	r0, r2, lsl #1
	mov	r0, r0, lsr #24
	add	r12, r12, r0, lsl #1
	ldrh	r12, [r12]
	smusdx	r0, r8, r9
	and	r1, r7, #15
	mov	r12, r12, lsl #15
	umull	r4, r11, r2, r12
	str	r0, [sp, #SIDE]
	rsb	r11, r11, #1 << 31
	umull	r4, r12, r11, r12
	rsb	r1, r1, #8
	mov	r12, r12, lsl #2
	umull	r4, r11, r2, r12
	pkhbt	r2, r8, r9, lsl #16
	rsb	r11, r11, #1 << 31
	umull	r4, r12, r11, r12
	mov	r11, r7, lsr #16
	movs	r12, r12, lsl #2
	mvnmi	r12, #1 << 31
	cmp	r0, #0
	rsblt	r12, r12, #0
	subs	lr, lr, #18
	rsblt	r0, lr, #0
	movlt	r12, r12, asr r0
	movlt	lr, #0
	/* Less than half a pixel: nothing runs. */
	cmp	r3, #256
	movlo	r12, #0
	pkhtb	r3, r9, r8, asr #16

	/* r8, r9 to the centre of the column in the first row, r7 the column */
	mov	r8, r1
	rsb	r9, r11, r10, lsl #4
	add	r9, r9, #8
	mov	r7, r7, lsl #16
	mvn	r7, r7, lsr #20
	sub	r7, r7, #23

	/* depth */
	ldr	r10, [sp, #SETUP]
	ldm	r10, {r4-r6}
	ldr	r0, [r4, #VERTEX_Z]
	ldr	r1, [r5, #VERTEX_Z]
	ldr	r11, [r6, #VERTEX_Z]
	mov	r4, r3, asr #16
	sub	r1, r1, r0
	sub	r11, r11, r0
	mul	r4, r1, r4
	sxth	r5, r3
	mul	r5, r11, r5
	mov	r6, r2, asr #16
	mul	r6, r1, r6
	sxth	r1, r2
	mul	r1, r11, r1
	sub	r4, r4, r5
	smmul	r4, r4, r12
	sub	r5, r1, r6
	smmul	r5, r5, r12
	mov	r0, r0, lsl #8
	mov	r4, r4, lsl lr
	mov	r6, r4, asr #4
	mla	r0, r6, r8, r0
	mov	r5, r5, lsl lr
	mov	r6, r5, asr #4
	mla	r0, r6, r9, r0
	str	r7, [sp, #COLUMN]
	mov	r1, r4, lsl #6
	mla	r0, r4, r7, r0
	mov	r5, r5, lsl #6
	mov	r8, r8, lsl #11
	mov	r0, r0, lsl #6
	strd	r0, [sp, #Z]
	str	r5, [sp, #Z_DOWN]
	pkhbt	r11, r8, r9, lsl #27

	/* colours */
	ldm	r10, {r4-r6}
	sub	r8, r12, r12, asr #5
	sub	r9, r12, r12, asr #6
	add	lr, lr, #1
	add_channel BLUE, VERTEX_COLOR + 8, r8, 5, 14, 0, 0x21000
	add_channel RED, VERTEX_COLOR, r8, 5, 13, 10, 0x20800
	add_channel GREEN, VERTEX_COLOR + 4, r9, 6, 13, 21, 0x10800
	ldr	r1, [sp, #RED]
	ldr	r7, [sp, #BLUE]
	ldr	r2, [sp, #COLUMN]
	mov	r0, r0, asr #12
	mov	r1, r1, asr #12
	mov	r7, r7, asr #13
	add	r7, r7, r1, lsl #10
	add	r7, r7, r0, lsl #21
	mla	r5, r12, r2, r7
	mov	r7, r12
	str	r10, [sp, #PACKED_DOWN]

	/* where the rows begin, and the long edge */
.Lbegin:
	ldr	r1, [sp, #DRAW]
	ldr	r10, [sp, #SETUP]
	ldr	lr, [r1, #FAST_SETUP_INVERSE]
	ldrd	r8, [r1, #FAST_SETUP_DEPTH]
	ldr	r3, [r10, #SETUP_TOP]
	ldr	r4, [sp, #Z]
	str	r9, [sp, #STRIDE]
	mla	r0, r3, r9, r8
	ldr	r9, [r1, #FAST_SETUP_PIXELS]
	ldr	r8, =0x07E0F81F
	ldr	r6, [sp, #Z + 4]
	sub	r0, r0, #48
	ldr	r1, [r10, #SETUP_XY]
	ldr	r2, [r10, #SETUP_XY + 8]
	find_edge
	ldr	r12, [sp, #SIDE]
	cmp	r12, #0
	set_edge ge, lt

	ldr	r1, [sp, #SETUP]
	mov	r2, #8
	str	r2, [sp, #CHUNK]
	ldr	r3, [r1, #SETUP_TOP]
	ldr	r12, [r1, #SETUP_MIDDLE]
	ldr	r2, [r1, #SETUP_BOTTOM]
	sub	r2, r2, r12
	subs	r12, r12, r3
	str	r2, [sp, #LATER]
	beq	.Llower
	str	r12, [sp, #REST]
	ldr	r2, [r1, #SETUP_XY + 4]
	ldr	r1, [r1, #SETUP_XY]
	find_edge
	ldr	r12, [sp, #SIDE]
	cmp	r12, #0
	set_edge lt, ge
	ldr	r2, [sp, #REST]
	bl	soft_narrow_rows
.Llower:
	ldr	r12, [sp, #LATER]
	ldr	r2, [sp, #DRAW]
	ldr	r1, [sp, #SETUP]
	cmp	r12, #0
	beq	.Ldone
	ldr	lr, [r2, #FAST_SETUP_INVERSE]
	ldr	r3, [r1, #SETUP_MIDDLE]
	ldr	r2, [r1, #SETUP_XY + 8]
	ldr	r1, [r1, #SETUP_XY + 4]
	find_edge
	ldr	r12, [sp, #SIDE]
	cmp	r12, #0
	set_edge lt, ge
	ldr	r2, [sp, #LATER]
	bl	soft_narrow_rows
.Ldone:	add	sp, sp, #ROOM + 8
	pop	{r4-r11, pc}

	/* more of w: colours may run linearly yet */
.Ldiffer:
	bl	soft_fill_is_linear
	cmp	r0, #0
	ldr	r0, [sp, #DRAW]
	ldr	r1, [sp, #SETUP]
	bne	1b
	add	sp, sp, #ROOM
	pop	{r0, r1, r4-r11, lr}
	b	soft_rows_fill
	.size	soft_fill_narrow, . - soft_fill_narrow
	.section .note.GNU-stack, "", %progbits
