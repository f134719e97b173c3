/*
 * fill_texture.c's fill_gray() and fill_tinted() for ARMv6: the same bytes.
 * Offsets are those of struct textured, struct setup, struct vertex, struct
 * texture_band and struct tint_band; textured_layout.c asserts them.
 *
 * Without its rows a triangle under one share costs 310 instructions, one under
 * three colours 400.
 */
#include "platform/gl/soft/arm/textured.h"

	.syntax unified
	.arch armv6
	.arm
	.text

	.global	soft_gray_triangle_arm
	.type	soft_gray_triangle_arm, %function
soft_gray_triangle_arm:
	push	{r4-r11, lr}
	sub	sp, sp, #ROOM
	ldmia	r1, {r2-r4}
	check_limits .Lgray_others, .Lgray_checked
	find_frame GRAY_DOWN, GRAY_EDGE, GRAY_STEP
	find_texels TEX_S, S_SHIFT, S_RUN, .Lgray_refuse
	find_texels TEX_T, T_SHIFT, T_RUN, .Lgray_refuse
	find_depth GRAY_DOWN, GRAY_RIGHT
	/* half of 1/32, so that 255 is 32/32 */
	find_color RED, 4 << 8
	mov	r2, r2, lsl #7
	mov	r3, r3, lsl #7
	mov	lr, lr, lsl #7
	str	r2, [sp, #GRAY_SHARE_RIGHT]
	str	r3, [sp, #GRAY_DOWN + 12]
	str	lr, [sp, #12]

	add	r4, sp, #S_RUN
	ldmia	r4, {r5-r10}
	pair_texels r5, r8
	pair_texels r6, r9
	pair_texels r7, r10
	str	r5, [sp, #GRAY_RIGHT + 4]
	str	r6, [sp, #GRAY_DOWN + 8]
	str	r7, [sp, #8]
	ldr	r11, [sp, #TEXTURED]
	add	r4, sp, #GRAY_TEXELS
	ldr	r2, [r11, #LEVELS]
	ldr	r3, [r11, #LEVELS + 8]
	ldr	r1, [r11, #LEVELS + 12]
	ldr	r6, [r11, #PIXELS]
	ldr	r5, =0x07E0F81F
	ldr	r7, =0x02008010
	cmp	r1, #0
	beq	.Lgray_refuse
	stmia	r4, {r1, r2, r3, r5, r6, r7}
	draw_parts GRAY_ROWS, GRAY_EDGE, GRAY_STEP, bl soft_band_texture_arm
	add	sp, sp, #ROOM
	pop	{r4-r11, pc}

.Lgray_others:
	check_others .Lgray_checked, .Lgray_refuse, RED
.Lgray_refuse:
	mov	r0, #0
	add	sp, sp, #ROOM
	pop	{r4-r11, pc}
	.size	soft_gray_triangle_arm, . - soft_gray_triangle_arm

	.global	soft_tint_triangle_arm
	.type	soft_tint_triangle_arm, %function
soft_tint_triangle_arm:
	push	{r4-r11, lr}
	sub	sp, sp, #ROOM
	ldmia	r1, {r2-r4}
	check_limits .Ltint_others, .Ltint_checked
	find_frame TINT_DOWN, TINT_EDGE, TINT_STEP
	find_texels TEX_S, S_SHIFT, S_RUN, .Ltint_refuse
	find_texels TEX_T, T_SHIFT, T_RUN, .Ltint_refuse
	find_depth TINT_DOWN, TINT_RIGHT
	find_color RED
	round_color
	add	r4, sp, #RED_RUN
	stmia	r4, {r2, r3, lr}
	find_color GREEN
	round_color
	sxth	r2, r2
	sub	r2, r2, #0x10000
	str	r2, [sp, #TINT_RIGHT + 12]
	str	r3, [sp, #TINT_DOWN + 16]
	str	lr, [sp, #16]
	find_color BLUE
	round_color
	add	r4, sp, #RED_RUN
	ldmia	r4, {r5-r7}
	add	r2, r2, r5, lsl #16
	add	r3, r3, r6, lsl #16
	add	lr, lr, r7, lsl #16
	str	r2, [sp, #TINT_RIGHT + 8]
	str	r3, [sp, #TINT_DOWN + 12]
	str	lr, [sp, #12]

	/* the level, see find_level(); r5-r10 as struct run of s, then of t */
	add	r4, sp, #S_RUN
	ldmia	r4, {r5-r10}
	ldr	r11, [sp, #TEXTURED]
	movs	r0, r5
	rsbmi	r0, r0, #0
	movs	r1, r8
	rsbmi	r1, r1, #0
	movs	r2, r6
	rsbmi	r2, r2, #0
	movs	r3, r9
	rsbmi	r3, r3, #0
	cmp	r0, r1
	addhi	r4, r0, r1, lsr #2
	addhi	r4, r4, r1, lsr #3
	addls	r4, r1, r0, lsr #2
	addls	r4, r4, r0, lsr #3
	cmp	r2, r3
	addhi	r12, r2, r3, lsr #2
	addhi	r12, r12, r3, lsr #3
	addls	r12, r3, r2, lsr #2
	addls	r12, r12, r2, lsr #3
	cmp	r4, r12
	movlo	r4, r12
	orr	r4, r4, #1
	clz	r12, r4
	mov	r4, r4, lsl r12
	rsb	r12, r12, #15
	mov	r4, r4, lsl #1
	cmp	r4, #129 << 24
	ldr	r4, [r11, #LAST_LEVEL]
	addhs	r12, r12, #1
	cmp	r12, #0
	movlt	r12, #0
	cmp	r12, r4
	movgt	r12, r4
	add	r12, r11, r12, lsl #5
	add	r12, r12, #LEVELS
	ldmia	r12, {r0-r4, r12, lr}
	cmp	r3, #0
	beq	.Ltint_refuse
	add	r11, sp, #TINT_LEVEL
	stmia	r11, {r0-r4}

	/* rounded to the level's texels, which are 1 << r12 and 1 << lr */
	mov	r0, #1
	mov	r1, r0, lsl r12
	mov	r2, r0, lsl lr
	add	r5, r5, r1, lsr #1
	add	r6, r6, r1, lsr #1
	add	r7, r7, r1, lsr #1
	add	r8, r8, r2, lsr #1
	add	r9, r9, r2, lsr #1
	add	r10, r10, r2, lsr #1
	mov	r5, r5, asr r12
	mov	r6, r6, asr r12
	mov	r7, r7, asr r12
	mov	r8, r8, asr lr
	mov	r9, r9, asr lr
	mov	r10, r10, asr lr
	ldr	r11, [sp, #TEXTURED]
	add	r5, r5, r8, lsl #16
	add	r6, r6, r9, lsl #16
	ldr	r8, [r11, #HALF_TEXEL]
	add	r7, r7, r10, lsl #16
	add	r4, r11, #TINT_CONSTANTS
	ldmia	r4, {r0-r3}
	sub	r7, r7, r8
	str	r5, [sp, #TINT_RIGHT + 4]
	str	r6, [sp, #TINT_DOWN + 8]
	str	r7, [sp, #8]
	add	r4, sp, #TINT_MASKS
	stmia	r4, {r0-r3}
	ldr	r11, [r11, #TINT]
	draw_parts TINT_ROWS, TINT_EDGE, TINT_STEP, blx r11
	add	sp, sp, #ROOM
	pop	{r4-r11, pc}

.Ltint_others:
	check_others .Ltint_checked, .Ltint_refuse, RED, GREEN, BLUE
.Ltint_refuse:
	mov	r0, #0
	add	sp, sp, #ROOM
	pop	{r4-r11, pc}
	.size	soft_tint_triangle_arm, . - soft_tint_triangle_arm

	.section .note.GNU-stack, "", %progbits
