/*
 * Lists of triangles without indices, for ARMv6: gives each vertex a slot of
 * the cache by what it is made of, as unindexed.c's find_dedup() does, and hands
 * slots instead of indices to soft_list(), up to 64 triangles at a time. Offsets are
 * those of struct dedup, struct dedup_run, struct fast_setup and struct vertex.
 *
 * A vertex that is there already costs 21 instructions, of eight words 26.
 */
#include "platform/gl/soft/arm/offsets.h"
	.syntax unified
	.arch armv6
	.arm
	.text

/* struct dedup */
#define BATCH 64

/* struct dedup_run */
#define RUN_FROM 0
#define RUN_END 4
#define RUN_BASE 8
#define RUN_SHIFT 12
#define RUN_INVERSE 16

/* of the stack, over the first arguments */
#define DRAW 0
#define LIMIT 4
#define RUN 8
#define TRIANGLE 12
#define TRIANGLE_SLOTS 16
#define AT 20
#define OUT 24
#define RETURN 28
#define SCRATCH 32

/*
 * The next vertex: r0 behind it, r8 its slot, r7 the multiplier, r10 struct
 * dedup, lr behind the slots. Any part of r7 marks what is listed.
 */
	.macro	one_vertex words, stride
	ldmia	r0, {r1-r6}
	pld	[r0, #4 * \stride]
	add	r0, r0, #\stride
	add	r8, r1, r2, lsl #3
	add	r8, r8, r2, lsr #9
	sub	r8, r8, r3, lsr #5
	mul	r8, r7, r8
	lsr	r8, r8, #23
	ldr	r9, [r10, r8, lsl #2]
	strh	r8, [lr], #2
	ldmia	r9!, {r11, r12}
	cmp	r1, r11
	cmpeq	r2, r12
	ldmia	r9!, {r11, r12}
	cmpeq	r3, r11
	cmpeq	r4, r12
	ldmia	r9!, {r11, r12}
	cmpeq	r5, r11
	cmpeq	r6, r12
	.if	\words == 8
	ldmia	r9, {r1, r2}
	ldr	r11, [r0, #24 - \stride]
	ldr	r12, [r0, #28 - \stride]
	cmpeq	r1, r11
	cmpeq	r2, r12
	.endif
	adrne	r11, 1f
	bne	.Lmiss_\stride
1:	add	r11, r10, r8
	strb	r7, [r11, #DEDUP_LISTED]
	.endm

/*
 * r0 draw, r1 dedup, r2 run, whose from is the first triangle; r0 is the first
 * that is not drawn: run's end, or one that soft_list() cannot have this way.
 */
	.macro	dedup_list name, words, stride
	.global	\name
	.type	\name, %function
\name:
	push	{r4-r11, lr}
	sub	sp, sp, #SCRATCH + 4
	strd	r0, [sp, #DRAW]
	mov	r10, r1
	str	r2, [sp, #RUN]
	ldr	r7, =2654435761
	ldr	r0, [r2, #RUN_FROM]
2:	bl	.Lbegin_batch
	ldr	r2, [sp, #RUN]
	ldr	r1, [r2, #RUN_END]
	add	r2, r0, #BATCH * 3 * \stride
	cmp	r1, r2
	movlo	r2, r1
	str	r2, [sp, #LIMIT]
3:	ldr	r1, [sp, #LIMIT]
	str	r0, [sp, #TRIANGLE]
	str	lr, [sp, #TRIANGLE_SLOTS]
	cmp	r0, r1
	beq	4f
	one_vertex \words, \stride
	one_vertex \words, \stride
	one_vertex \words, \stride
	b	3b
4:	bl	.Lflush
	ldr	r2, [sp, #RUN]
	ldr	r0, [sp, #TRIANGLE]
	ldr	r1, [r2, #RUN_END]
	cmp	r0, r1
	bne	2b
	b	.Lreturn
	.size	\name, . - \name
	.endm

	dedup_list soft_dedup_six_tight_arm, 6, 24

	/* r11 where to go on; r4 the vertex */
.Lmiss_24:
	sub	r4, r0, #24
	b	.Lmiss
.Lmiss_32:
	sub	r4, r0, #32
.Lmiss:
	str	r0, [sp, #AT]
	str	lr, [sp, #OUT]
	str	r11, [sp, #RETURN]
	add	r1, r10, r8
	ldrb	r1, [r1, #DEDUP_LISTED]
	cmp	r1, #0
	blne	.Lmake_room
	ldr	r2, [sp, #RUN]
	ldr	r0, [sp, #DRAW]
	ldr	r1, [r2, #RUN_BASE]
	ldr	r3, [r2, #RUN_SHIFT]
	ldr	r5, [r2, #RUN_INVERSE]
	ldr	r6, [r0, #FAST_SETUP_CACHE]
	sub	r1, r4, r1
	lsr	r1, r1, r3
	mul	r1, r5, r1
	add	r9, r8, r8, lsl #1
	add	r9, r6, r9, lsl #5
	mov	r2, r9
	bl	soft_transform
	ldrb	r1, [r9, #VERTEX_OUTCODE]
	ldr	r0, [sp, #DRAW]
	cmp	r1, #0
	bne	.Loutside
	ldr	r2, [r9, #VERTEX_X]
	ldr	r3, [r9, #VERTEX_X + 4]
	ldr	r0, [r0, #FAST_SETUP_TAG]
	str	r4, [r10, r8, lsl #2]
	orr	r3, r2, r3, lsl #16
	mov	r2, r8
	add	r1, r0, r8, lsl #3
	strd	r2, [r1]
	ldr	r0, [sp, #AT]
	ldr	lr, [sp, #OUT]
	ldr	pc, [sp, #RETURN]

	/* The slot's vertex is overwritten: it is made of nothing. */
.Loutside:
	add	r1, r10, #DEDUP_NOTHING
	cmp	r8, #0
	addeq	r1, r1, #32
	str	r1, [r10, r8, lsl #2]
.Lother:
	bl	.Lflush
.Lreturn:
	ldr	r0, [sp, #TRIANGLE]
	add	sp, sp, #SCRATCH + 4
	pop	{r4-r11, pc}

	/* Draws the triangles that are listed and whole. */
.Lflush:
	ldr	r2, [sp, #TRIANGLE_SLOTS]
	ldr	r0, [sp, #DRAW]
	add	r1, r10, #DEDUP_SLOTS
	subs	r2, r2, r1
	lsrne	r2, r2, #1
	bne	soft_list
	bx	lr

	/* r0 stays; lr becomes the first slot */
.Lbegin_batch:
	add	r1, r10, #DEDUP_LISTED
	add	r2, r1, #DEDUP_SLOTS - DEDUP_LISTED
	mov	r3, #0
	mov	r4, #0
	mov	r5, #0
	mov	r6, #0
5:	stmia	r1!, {r3-r6}
	stmia	r1!, {r3-r6}
	cmp	r1, r2
	bne	5b
	mov	r3, lr
	mov	lr, r2
	bx	r3

	/*
	 * Slot r8 is listed. Unless the triangle under way lists it itself,
	 * draws what lies before that, and its slots become the first.
	 */
.Lmake_room:
	str	lr, [sp, #SCRATCH]
	ldr	r1, [sp, #TRIANGLE_SLOTS]
	ldr	r2, [sp, #OUT]
	sub	r2, r2, #2
6:	cmp	r1, r2
	ldrhne	r3, [r1], #2
	beq	7f
	cmp	r3, r8
	bne	6b
	b	.Lother
7:	bl	.Lflush
	mov	r9, r4
	bl	.Lbegin_batch
	mov	r4, r9
	ldr	r1, [sp, #TRIANGLE_SLOTS]
	ldr	r2, [sp, #OUT]
	str	lr, [sp, #TRIANGLE_SLOTS]
8:	cmp	r1, r2
	ldrhne	r3, [r1], #2
	strhne	r3, [lr], #2
	addne	r3, r3, r10
	strbne	r7, [r3, #DEDUP_LISTED]
	bne	8b
	str	lr, [sp, #OUT]
	ldr	pc, [sp, #SCRATCH]

	.ltorg

	dedup_list soft_dedup_six_arm, 6, 32
	dedup_list soft_dedup_eight_arm, 8, 32

	.section .note.GNU-stack, "", %progbits
