/*
 * Triangles of 16-bit indices, for ARMv6: one loop finds vertices in the cache,
 * culls triangles and sets those up that are small and inside of the clip volume
 * and of draw->box; it leaves the others to soft_draw_triangle(). In C that draws
 * all triangles (portable/triangles.c).
 *
 * A triangle that is culled costs 22 instructions, one that covers no pixel's centre
 * 35, others 115 until they are filled; a vertex 23 besides its transformation.
 */
#include "platform/gl/soft/arm/offsets.h"

	.syntax unified
	.arch armv6
	.arm
	.text

#define CACHE_SLOTS 512
#define FOUND 68 /* bytes of head up to label 2: all vertices are in the cache */

/* offsets from sp of locals behind a struct setup, which lies at sp */
#define ROUND 88
#define WHOLE 92
#define BOX 96 /* two words */
#define END 104
#define INDEX 108 /* r2 during calls */
#define HEAD 112
#define DRAW 116
#define SOURCE 120
#define CACHE 124
#define ATTRIBUTES 128
#define FLAGS 132
#define ROOM 140
	.if	SETUP_SIZE > ROUND
	.error	"struct setup is larger than its place"
	.endif

/*
 * In: r2 indices, r10 place, r11 mask of slots. Finds a triangle's vertices: r3,
 * r12, lr are their offsets in place, r4, r6, r8 their tags, r5, r7, r9 their xy.
 * r0 is twice the area; where condition unwanted holds, the next one is taken.
 */
	.macro	head unwanted
1:	ldr	r0, [sp, #END]
	pld	[r2, #70]
	cmp	r2, r0
	beq	.Ldone
	ldrh	r7, [r2, #4]
	ldrh	r0, [r2], #6
	ldrh	r1, [r2, #-4]
	and	lr, r11, r7, lsl #3
	and	r3, r11, r0, lsl #3
	ldrd	r8, [r10, lr]
	and	r12, r11, r1, lsl #3
	ldrd	r4, [r10, r3]
	cmp	r8, r7
	ldrd	r6, [r10, r12]
	cmpeq	r4, r0
	cmpeq	r6, r1
	bne	.Lload
2:	ssub16	r1, r7, r5
	ssub16	r0, r9, r5
	smusdx	r0, r1, r0
	cmp	r0, #0
	b\unwanted	1b
	.if	2b - 1b != FOUND
	.error	"found vertices are elsewhere"
	.endif
	.endm

	/* Swaps two vertices, xy and address each, if they are not sorted by xy. */
	.macro	sort xy, vertex, next_xy, next_vertex
	cmp	\xy, \next_xy
	movhi	r0, \xy
	movhi	\xy, \next_xy
	movhi	\next_xy, r0
	movhi	r0, \vertex
	movhi	\vertex, \next_vertex
	movhi	\next_vertex, r0
	.endm

	.macro	shade_corner number
	ldr	r1, [sp, #4 * \number]
	ldrb	r0, [r1, #VERTEX_SHADED]
	cmp	r0, #0
	bne	1f
	ldr	r0, [sp, #DRAW]
	bl	soft_shade_vertex
1:
	.endm

	/*
	 * If a slot's tag is not the index, transforms the vertex into it; sets xy.
	 * In: r2 indices.
	 */
	.macro	load_corner number, tag, xy
	ldrh	r1, [r2, #2 * \number - 6]
	cmp	\tag, r1
	beq	1f
	ldr	r3, [sp, #4 * \number]
	ldr	r0, [sp, #CACHE]
	add	r2, r3, r3, lsl #1
	add	r2, r0, r2, lsl #2
	ldr	r0, [sp, #DRAW]
	mov	\tag, r2
	bl	soft_transform
	ldr	r3, [sp, #4 * \number]
	ldm	\tag, {r0-r2}
	tst	r0, #0xFF << 8
	ldr	r0, [\tag, #VERTEX_INDEX]
	orr	r1, r1, r2, lsl #16
	mvnne	r0, #1
	ldr	r2, [sp, #INDEX]
	strd	r0, [r10, r3]
	mov	\xy, r1
	bne	.Lapart
1:
	.endm

	/* r0 draw, r1 source */
	.global	soft_list
	.type	soft_list, %function
soft_list:
	push	{r4-r11, lr}
	sub	sp, sp, #ROOM
	mov	r2, #0 /* upper half of all areas */
	str	r2, [sp, #SETUP_AREA + 4]
	str	r0, [sp, #DRAW]
	str	r1, [sp, #SOURCE]
	ldr	r2, [r1]
	ldr	r3, [r1, #SOURCE_COUNT]
	ldr	r4, =0xAAAAAAAB
	umull	r5, r3, r4, r3
	mov	r3, r3, lsr #1
	add	r3, r3, r3, lsl #1
	add	r3, r2, r3, lsl #1
	str	r3, [sp, #END]
	ldr	r4, =0x00070007
	ldr	r5, =0xFFF0FFF0
	strd	r4, [sp, #ROUND]
	ldrd	r4, [r0, #FAST_SETUP_BOX]
	strd	r4, [sp, #BOX]
	ldr	r3, [r0, #FAST_SETUP_CACHE]
	str	r3, [sp, #CACHE]
	ldr	r3, [r0, #FAST_SETUP_ATTRIBUTES]
	str	r3, [sp, #ATTRIBUTES]
	ldr	r3, [r0, #FAST_SETUP_BACK_FLIP]
	mov	r3, r3, lsl #16
	orr	r3, r3, #1
	str	r3, [sp, #FLAGS]
	ldr	r10, [r0, #FAST_SETUP_PLACE]
	mov	r11, #CACHE_SLOTS << 3
	sub	r11, r11, #1 << 3
	ldrd	r4, [r0, #FAST_SETUP_CULL]
	adr	r3, .Lboth
	cmp	r5, #0
	adrne	r3, .Lpositive
	cmpne	r4, #0
	adrne	r3, .Lnegative
	str	r3, [sp, #HEAD]
	mov	pc, r3

.Lboth:
	head	eq
	b	.Lseen
.Lpositive:
	head	le
	b	.Lseen
.Lnegative:
	head	ge

	/* r6, r4: least and largest x and y; then times 16 the first columns, rows */
.Lseen:
	usub16	r1, r5, r7
	sel	r4, r5, r7
	sel	r6, r7, r5
	usub16	r1, r6, r9
	sel	r6, r9, r6
	usub16	r1, r4, r9
	sel	r4, r4, r9
	ldr	r1, [sp, #ROUND]
	sub	r8, r4, r6
	add	r6, r6, r1
	add	r4, r4, r1
	ldr	r1, [sp, #WHOLE]
	and	r6, r6, r1
	and	r4, r4, r1
	sub	r1, r4, r6
	cmp	r1, #1 << 16
	blo	.Lnext
	movs	r1, r1, lsl #16
	beq	.Lnext
	mov	r1, r1, lsr #20
	str	r1, [sp, #SETUP_COLUMNS]
	ldr	r1, [sp, #FLAGS]
	cmp	r0, #0
	eormi	r1, r1, #1 << 16
	rsbmi	r0, r0, #0
	str	r1, [sp, #SETUP_FLAGS]
	str	r0, [sp, #SETUP_AREA]
	mov	r0, r8, lsr #16
	uxth	r8, r8
	cmp	r0, r8
	movlo	r0, r8
	str	r0, [sp, #SETUP_EXTENT]
	cmp	r0, #2048
	bge	.Lother
	ldrd	r0, [sp, #BOX]
	ssub16	r0, r6, r0
	ssub16	r1, r1, r4
	orr	r0, r0, r1
	orrs	r0, r0, r0, lsl #16
	bmi	.Lother
	mov	r6, r6, lsr #20
	str	r6, [sp, #SETUP_TOP]
	mov	r4, r4, lsr #20
	str	r4, [sp, #SETUP_BOTTOM]

	/* r3, r12, lr become the vertices' addresses */
	ldr	r8, [sp, #CACHE]
	add	r3, r3, r3, lsl #1
	add	r12, r12, r12, lsl #1
	add	lr, lr, lr, lsl #1
	add	lr, r8, lr, lsl #2
	add	r3, r8, r3, lsl #2
	add	r12, r8, r12, lsl #2
	str	lr, [sp, #SETUP_PROVOKING]
	ldr	r8, [sp, #ATTRIBUTES]
	cmp	r8, #0
	beq	.Lshaded
	ldrb	r0, [r3, #VERTEX_SHADED]
	ldrb	r1, [r12, #VERTEX_SHADED]
	ldrb	r8, [lr, #VERTEX_SHADED]
	and	r0, r0, r1
	ands	r0, r0, r8
	beq	.Lshade
.Lshaded:
	sort	r5, r3, r7, r12
	sort	r7, r12, r9, lr
	sort	r5, r3, r7, r12
	stm	sp, {r3, r12, lr}
	add	r7, r7, #7 << 16
	mov	r7, r7, lsr #20
	str	r7, [sp, #SETUP_MIDDLE]
	ldr	r0, [sp, #DRAW]
	mov	r1, sp
	str	r2, [sp, #INDEX]
	ldr	r3, [r0, #FAST_SETUP_FILL]
	blx	r3
	ldr	r2, [sp, #INDEX]
.Lnext:	ldr	pc, [sp, #HEAD]
.Ldone:	add	sp, sp, #ROOM
	pop	{r4-r11, pc}

.Lshade:
	stm	sp, {r3, r12, lr}
	str	r2, [sp, #INDEX]
	shade_corner 0
	shade_corner 1
	shade_corner 2
	ldm	sp, {r3, r12, lr}
	ldr	r2, [sp, #INDEX]
	b	.Lshaded

	/* a vertex is not in its slot */
.Lload:
	str	r2, [sp, #INDEX]
	cmp	r3, r12
	cmpne	r3, lr
	cmpne	r12, lr
	cmnne	r4, #2
	cmnne	r6, #2
	cmnne	r8, #2
	beq	.Lapart
	stm	sp, {r3, r12, lr}
	load_corner 0, r4, r5
	load_corner 1, r6, r7
	load_corner 2, r8, r9
	ldm	sp, {r3, r12, lr}
	ldr	r0, [sp, #HEAD]
	add	pc, r0, #FOUND

	/* the triangle is partly outside of the box, or large */
.Lother:
	str	r2, [sp, #INDEX]

	/* a vertex lies outside of the clip volume, or two need the same slot */
.Lapart:
	ldr	r1, [sp, #SOURCE]
	ldr	r2, [sp, #INDEX]
	ldr	r0, [r1]
	sub	r2, r2, #6
	sub	r2, r2, r0
	mov	r2, r2, lsr #1
	add	r0, r2, #2
	str	r0, [sp]
	ldr	r0, [sp, #DRAW]
	add	r3, r2, #1
	bl	soft_draw_triangle
	ldr	r2, [sp, #INDEX]
	ldr	pc, [sp, #HEAD]
	.size	soft_list, . - soft_list

	.section .note.GNU-stack, "", %progbits
