/*
 * What textured.S sets triangles up with: the offsets it knows, the stack of
 * its functions, and the steps that both of them take.
 */
/* struct textured */
#define DEPTH 0 /* and the stride */
#define INVERSE 8
#define RECIPROCALS 12
#define TINT 16
#define PERSPECTIVE 20
#define TEXEL_LIMIT 24
#define S_SHIFT 28
#define T_SHIFT 32
#define LAST_LEVEL 36
#define TINT_CONSTANTS 40 /* four */
#define PIXELS 52
#define HALF_TEXEL 56
#define NEAR_LIMIT 60
#define LEVELS 64 /* of 32 bytes */

/* struct setup, from its three vertices on */
#define TOP 24
#define MIDDLE 28
#define BOTTOM 32
#define EXTENT 40
#define AREA 48

/* struct vertex */
#define Z 12
#define RED 16
#define GREEN 20
#define BLUE 24
#define TEX_S 36
#define TEX_T 40
#define W 76

/* struct texture_band */
#define GRAY_DOWN 16
#define GRAY_RIGHT 32
#define GRAY_TEXELS 40
#define GRAY_EDGE 64
#define GRAY_STEP 72
#define GRAY_SHARE_RIGHT 80
#define GRAY_ROWS 84

/* struct tint_band */
#define TINT_DOWN 20
#define TINT_EDGE 40
#define TINT_STEP 48
#define TINT_ROWS 56
#define TINT_RIGHT 64
#define TINT_LEVEL 80
#define TINT_MASKS 104

/* The stack, behind the band. */
#define LOWER 120 /* the lower edge's step, and where it is */
#define PART 128  /* 0 if the edges that meet are left, 4 if right */
#define V2 132
#define S_RUN 136 /* right, down, start */
#define T_RUN 148
#define RED_RUN 160
#define TEXTURED 172
#define SETUP 176
#define LIMIT 180
#define ROOM 188 /* with the nine registers a multiple of 8 */

/*
 * struct limits: of texels onto the stack, colours are held against it at once.
 * r0 textured, r1 setup, r2-r4 v; \other is check_others.
 */
	.macro	check_limits other, checked
	ldr	r5, [r0, #PERSPECTIVE]
	ldr	r10, [r0, #TEXEL_LIMIT]
	cmp	r5, #0
	beq	\checked
	ldr	r5, [r2, #W]
	ldr	r6, [r3, #W]
	ldr	r7, [r4, #W]
	cmp	r5, r6
	movgt	r8, r6
	movle	r8, r5
	movgt	r9, r5
	movle	r9, r6
	cmp	r7, r8
	movlt	r8, r7
	cmp	r7, r9
	movgt	r9, r7
	sub	r9, r9, r8
	cmp	r9, r8, asr #6
	bgt	\other
\checked:
	str	r10, [sp, #LIMIT]
	.endm

/* Where w differs by more: r8 the least, r9 by how much. */
	.macro	check_others checked, refuse, colors:vararg
	clz	r5, r9
	clz	r6, r8
	subs	r5, r5, r6
	ble	\refuse
	cmp	r9, r8, asr r5
	subgt	r5, r5, #1
	cmp	r5, #0
	ble	\refuse
	mov	r10, #128
	mov	r7, #1024
	mov	r10, r10, lsl r5
	mov	r7, r7, lsl r5
	ldr	r6, [r1, #EXTENT]
	ldr	r12, [r0, #NEAR_LIMIT]
	cmp	r5, #4
	rsbsge	r6, r6, #256
	cmpge	r12, r10
	movge	r10, r12
	.irp	at, \colors
	ldr	r5, [r2, #\at]
	ldr	r6, [r3, #\at]
	ldr	r12, [r4, #\at]
	cmp	r5, r6
	movgt	lr, r5
	movle	lr, r6
	movgt	r5, r6
	cmp	r12, lr
	movgt	lr, r12
	cmp	r12, r5
	movlt	r5, r12
	sub	lr, lr, r5
	cmp	lr, r7
	bgt	\refuse
	.endr
	b	\checked
	.endm

/*
 * An edge: its step, from r3 = dx and r4 = 2^31 / dy, and where it is, into r4,
 * from r1 where it begins and \off how far above the first row's centre.
 */
	.macro	find_edge off
	mov	r3, r3, lsl #17
	smmul	r3, r3, r4
	mov	r4, r3, asr #4
	mla	r4, r4, \off, r1
	.endm

/*
 * Edges, and what find_run wants: r5 off_x, r6 off_y, r7 x1, r8 -y1, r9 -x2,
 * r10 y2, r11 shift, r12 inverse; r0 and r1 the first two vertices.
 */
	.macro	find_frame down, edge, step
	str	r0, [sp, #TEXTURED]
	str	r1, [sp, #SETUP]
	str	r4, [sp, #V2]
	ldmib	r2, {r5, r6}
	ldmib	r3, {r7, r8}
	ldmib	r4, {r9, r10}
	ldrd	r2, [r0, #DEPTH]
	ldr	r4, [r1, #TOP]
	sub	r7, r7, r5
	sub	r8, r6, r8
	sub	r9, r5, r9
	sub	r10, r10, r6
	mul	r11, r7, r10
	mul	r12, r9, r8
	mla	r2, r4, r3, r2
	mov	r4, r5, asr #4
	add	r2, r2, r4, lsl #1
	str	r2, [sp]
	str	r3, [sp, #\down]
	cmp	r11, r12
	movlt	r11, #0
	movge	r11, #4
	str	r11, [sp, #PART]

	/* from the first vertex to the last */
	ldr	r2, [r0, #INVERSE]
	and	r5, r5, #15
	mov	r1, r5, lsl #12
	ldr	r4, [r2, r10, lsl #2]
	rsb	r6, r6, #8
	add	r1, r1, #0x8000
	rsb	r3, r9, #0
	sub	r1, r1, #1
	and	lr, r6, #15
	find_edge lr
	eor	r12, r11, #4
	add	r12, sp, r12
	str	r4, [r12, #\edge]
	str	r3, [r12, #\step]

	/* to the middle one; unused without rows */
	sub	r4, r2, r8, lsl #2
	mov	r3, r7
	ldr	r4, [r4]
	add	r12, sp, r11
	find_edge lr
	str	r4, [r12, #\edge]
	str	r3, [r12, #\step]

	/* from there to the last */
	add	r4, r10, r8
	add	r3, r9, r7
	ldr	r4, [r2, r4, lsl #2]
	add	r12, r6, r8
	rsb	r3, r3, #0
	and	r12, r12, #15
	add	r1, r1, r7, lsl #12
	find_edge r12
	str	r3, [sp, #LOWER]
	str	r4, [sp, #LOWER + 4]

	/* 2^62 over the area, see reciprocal() */
	ldr	r1, [sp, #SETUP]
	ldr	r4, [r0, #RECIPROCALS]
	ldr	r2, [r1, #AREA]
	mov	r6, lr
	rsb	r5, r5, #8
	clz	r3, r2
	mov	r2, r2, lsl r3
	mov	r12, r2, lsl #1
	mov	r12, r12, lsr #23
	bic	r12, r12, #1
	ldrh	r12, [r4, r12]
	mov	r12, r12, lsl #15
	umull	r0, r4, r2, r12
	rsb	r4, r4, #0x80000000
	umull	r0, r12, r4, r12
	mov	r12, r12, lsl #2
	umull	r0, r4, r2, r12
	rsb	r4, r4, #0x80000000
	umull	r0, r12, r4, r12
	ldmia	r1, {r0, r1}
	movs	r12, r12, lsl #2
	mvnmi	r12, #0x80000000
	/* areas below 256 have no gradients */
	cmp	r3, #24
	movhs	r12, #0
	cmp	r11, #0
	rsbeq	r12, r12, #0
	subs	r11, r3, #18
	rsbmi	r3, r11, #0
	movmi	r12, r12, asr r3
	movmi	r11, #0
	.endm

/* Into r4 and lr what the other two vertices differ by. */
	.macro	find_differences at
	ldr	lr, [sp, #V2]
	ldr	r3, [r0, #\at]
	ldr	r4, [r1, #\at]
	ldr	lr, [lr, #\at]
	sub	r4, r4, r3
	sub	lr, lr, r3
	.endm

/* Into r2 a step right, into r3 one down. */
	.macro	find_gradient
	mul	r2, lr, r8
	mul	r3, lr, r7
	mla	r2, r4, r10, r2
	mla	r3, r4, r9, r3
	smmul	r2, r2, r12
	smmul	r3, r3, r12
	mov	r2, r2, lsl r11
	mov	r3, r3, lsl r11
	.endm

/* lr from the first vertex to the band's first centre. */
	.macro	find_start
	mov	r4, r2, asr #4
	mla	lr, r4, r5, lr
	mov	r4, r3, asr #4
	mla	lr, r4, r6, lr
	.endm

	.macro	find_depth down, right
	find_differences Z
	find_gradient
	ldr	lr, [r0, #Z]
	mov	lr, lr, lsl #8
	find_start
	mov	r2, r2, lsl #6
	mov	r3, r3, lsl #6
	mov	lr, lr, lsl #6
	str	r2, [sp, #\right]
	str	r3, [sp, #\down + 4]
	str	lr, [sp, #4]
	.endm

/* In 16.16 of the base's texels, onto the stack. */
	.macro	find_texels at, shift, run, refuse
	find_differences \at
	ldr	r2, [sp, #TEXTURED]
	ldr	r2, [r2, #\shift]
	ldr	r3, [sp, #LIMIT]
	mov	r4, r4, asr r2
	mov	lr, lr, asr r2
	add	r2, r4, r3
	cmp	r2, r3, lsl #1
	addls	r2, lr, r3
	cmpls	r2, r3, lsl #1
	bhi	\refuse
	find_gradient
	ldr	r4, [sp, #TEXTURED]
	ldr	lr, [r0, #\at]
	ldr	r4, [r4, #\shift]
	uxth	lr, lr
	mov	lr, lr, lsr r4
	mov	lr, lr, lsl #8
	/* TEXEL_NUDGE */
	add	lr, lr, #128
	find_start
	add	r4, sp, #\run
	stmia	r4, {r2, r3, lr}
	.endm

	.macro	find_color at, round=0
	find_differences \at
	find_gradient
	ldr	lr, [r0, #\at]
	.if	\round
	add	lr, lr, #\round
	.endif
	mov	lr, lr, lsl #8
	find_start
	.endm

/* To 1.15. */
	.macro	round_color
	add	r2, r2, #256
	add	r3, r3, #256
	add	lr, lr, #256
	mov	r2, r2, asr #9
	mov	r3, r3, asr #9
	mov	lr, lr, asr #9
	.endm

/* 256ths of texels as one number, into \s, which is s's. */
	.macro	pair_texels s, t
	mov	\s, \s, asr #8
	mov	\t, \t, lsr #8
	add	\s, \s, \t, lsl #16
	.endm

/* Both parts, by a call; leaves 1 in r0. */
	.macro	draw_parts rows, edge, step, call:vararg
	ldr	r4, [sp, #SETUP]
	ldr	r5, [r4, #MIDDLE]
	ldr	r6, [r4, #TOP]
	subs	r6, r5, r6
	ble	1f
	str	r6, [sp, #\rows]
	mov	r0, sp
	\call
1:
	ldr	r6, [r4, #BOTTOM]
	subs	r6, r6, r5
	ble	2f
	ldr	r0, [sp, #PART]
	ldr	r2, [sp, #LOWER]
	ldr	r3, [sp, #LOWER + 4]
	add	r0, sp, r0
	str	r2, [r0, #\step]
	str	r3, [r0, #\edge]
	str	r6, [sp, #\rows]
	mov	r0, sp
	\call
2:
	mov	r0, #1
	.endm
