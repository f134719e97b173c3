/*
 * vertex/list.c for ARMv6: what triangle.c's
 * soft_fill_triangle() makes of each. Offsets are those of struct fast_setup,
 * struct setup, struct vertex and struct cache_tag.
 *
 * A triangle that is culled costs 26 instructions, one that is handed on 110.
 */
#include "platform/gl/soft/arm/offsets.h"
	.syntax unified
	.arch armv6
	.arm
	.text

/* The stack: a struct setup, and what stays the same for all triangles. */
#define CULL 88
#define BOX 96
#define ROUND 104
#define DRAW 112
#define END 116
#define CACHE 120
#define FILL 124
#define ATTRIBUTES 128
#define FLAGS 132
#define RETURN 136
#define MASKED 140
#define ROOM 148 /* with the nine registers a multiple of 8 */

/*
 * r0 draw, r1 indices, r2 how many, of 3 or more. Then r10 places, r11 the
 * next index, r3, r12, lr the three places, r5, r7, r9 their xy.
 */
	.global	soft_list
	.type	soft_list, %function
soft_list:
	push	{r4-r11, lr}
	sub	sp, sp, #ROOM
	mov	r11, r1
	ldr	r10, [r0, #FAST_SETUP_TAG]
	add	r2, r1, r2, lsl #1
	ldrd	r4, [r0, #FAST_SETUP_CULL]
	ldrd	r6, [r0, #FAST_SETUP_BOX]
	strd	r4, [sp, #CULL]
	strd	r6, [sp, #BOX]
	ldr	r4, =0x00070007
	ldr	r5, =0xFFF0FFF0
	strd	r4, [sp, #ROUND]
	str	r0, [sp, #DRAW]
	str	r2, [sp, #END]
	ldr	r4, [r0, #FAST_SETUP_CACHE]
	ldr	r5, [r0, #FAST_SETUP_FILL]
	ldr	r6, [r0, #FAST_SETUP_ATTRIBUTES]
	ldr	r7, [r0, #FAST_SETUP_BACK]
	str	r4, [sp, #CACHE]
	str	r5, [sp, #FILL]
	str	r6, [sp, #ATTRIBUTES]
	/* inside, not wide, fast_setup, and whether areas below 0 are back */
	ldr	r4, =0x00010001
	orr	r4, r4, r7, lsl #24
	str	r4, [sp, #FLAGS]
	ldr	r5, [r0, #FAST_SETUP_MASKED]
	mov	r4, #0
	str	r5, [sp, #MASKED]
	str	r4, [sp, #SETUP_AREA + 4]

.Lloop:	ldrh	r0, [r11], #2
	ldrh	r1, [r11], #2
	ldrh	r2, [r11], #2
	pld	[r11, #64]
	mov	r3, r0, lsl #23
	mov	r12, r1, lsl #23
	mov	lr, r2, lsl #23
	add	r3, r10, r3, lsr #20
	add	r12, r10, r12, lsr #20
	add	lr, r10, lr, lsr #20
	ldrd	r4, [r3]
	ldrd	r6, [r12]
	ldrd	r8, [lr]
	cmp	r4, r0
	cmpeq	r6, r1
	cmpeq	r8, r2
	bne	.Lmiss
.Lready:
	ssub16	r0, r7, r5
	ssub16	r1, r9, r5
	smusdx	r2, r0, r1
	ldrd	r0, [sp, #CULL]
	eor	r0, r0, r2
	tst	r0, r1
	beq	.Lseen

.Lnext:	ldr	r0, [sp, #END]
	cmp	r11, r0
	bne	.Lloop
	add	sp, sp, #ROOM
	pop	{r4-r11, pc}

	/* r4, r6: the least and the most of x and y */
.Lseen:	cmp	r2, #0
	beq	.Lnext
	usub16	r0, r5, r7
	sel	r4, r7, r5
	sel	r6, r5, r7
	usub16	r0, r4, r9
	sel	r4, r9, r4
	usub16	r0, r6, r9
	sel	r6, r6, r9
	ldrd	r0, [sp, #ROUND]
	sub	r8, r6, r4
	add	r4, r4, r0
	add	r6, r6, r0
	and	r4, r4, r1
	and	r6, r6, r1
	sub	r1, r6, r4
	movs	r0, r1, lsr #16
	movsne	r0, r1, lsl #16
	beq	.Lnext

	/* r8: the larger extent */
	mov	r0, r0, lsr #20
	str	r0, [sp, #SETUP_COLUMNS]
	ldrd	r0, [sp, #BOX]
	ssub16	r0, r4, r0
	ssub16	r1, r1, r6
	orr	r0, r0, r1
	orrs	r0, r0, r0, lsl #16
	bmi	.Lother
	uxth	r0, r8
	mov	r8, r8, lsr #16
	cmp	r8, r0
	movlt	r8, r0
	cmp	r8, #2048
	bge	.Lother
	ldr	r0, [sp, #MASKED]
	cmp	r0, #0
	bne	.Lmasked
	mov	r4, r4, lsr #20
	mov	r6, r6, lsr #20
	str	r4, [sp, #SETUP_TOP]
	str	r6, [sp, #SETUP_BOTTOM]
	str	r8, [sp, #SETUP_EXTENT]
	ldr	r0, [sp, #FLAGS]
	cmp	r2, #0
	eorlt	r0, r0, #1 << 24
	rsblt	r2, r2, #0
	str	r0, [sp, #SETUP_FLAGS]
	str	r2, [sp, #SETUP_AREA]

	/* r4, r6, r8: four times how many lie before them */
	cmp	r5, r7
	movle	r4, #0
	movgt	r4, #4
	rsb	r6, r4, #4
	cmp	r7, r9
	addgt	r6, r6, #4
	movle	r8, #4
	movgt	r8, #0
	cmp	r5, r9
	addgt	r4, r4, #4
	addle	r8, r8, #4
	add	r0, sp, #SETUP_XY
	str	r5, [r0, r4]
	str	r7, [r0, r6]
	str	r9, [r0, r8]
	ldr	r5, [sp, #CACHE]
	mov	r7, #VERTEX_BYTES / 8
	sub	r3, r3, r10
	sub	r12, r12, r10
	sub	lr, lr, r10
	mla	r3, r7, r3, r5
	mla	r12, r7, r12, r5
	mla	lr, r7, lr, r5
	ldr	r1, [sp, #SETUP_XY + 4]
	ldr	r0, [sp, #ATTRIBUTES]
	str	r3, [sp, r4]
	add	r1, r1, #7 << 16
	mov	r1, r1, lsr #20
	str	r12, [sp, r6]
	str	lr, [sp, r8]
	str	r1, [sp, #SETUP_MIDDLE]
	cmp	r0, #0
	beq	.Lfill
	ldrb	r0, [r3, #VERTEX_SHADED]
	ldrb	r1, [r12, #VERTEX_SHADED]
	ldrb	r2, [lr, #VERTEX_SHADED]
	and	r0, r0, r1
	ands	r0, r0, r2
	beq	.Lshade
.Lfill:	ldr	r0, [sp, #DRAW]
	ldr	r2, [sp, #FILL]
	mov	r1, sp
	blx	r2
	b	.Lnext

.Lshade:
	mov	r4, sp
	mov	r5, #3
1:	ldr	r1, [r4], #4
	ldrb	r2, [r1, #VERTEX_SHADED]
	ldr	r0, [sp, #DRAW]
	cmp	r2, #0
	bleq	soft_shade
	subs	r5, r5, #1
	bne	1b
	b	.Lfill

	/* masked.S asks for no more than the corners by y, and the rows */
.Lmasked:
	ldr	r0, [sp, #DRAW]
	cmp	r5, r7
	movgt	r1, r5
	movgt	r5, r7
	movgt	r7, r1
	cmp	r7, r9
	movgt	r1, r7
	movgt	r7, r9
	movgt	r9, r1
	cmp	r5, r7
	movgt	r1, r5
	movgt	r5, r7
	movgt	r7, r1
	add	r8, r7, #7 << 16
	mov	r1, r4, lsr #20
	mov	r2, r6, lsr #20
	mov	r8, r8, lsr #20
	mov	r6, r9
	mov	r4, r5
	mov	r5, r7
	mov	r7, r1
	mov	r9, r2
	bl	soft_fill_masked_sorted
	b	.Lnext

	/* Those that are missing, from r5, r7, r9: of what the indices are. */
.Lmiss:	mov	r5, r3
	mov	r7, r12
	mov	r9, lr
	mov	r1, r0
	mov	r0, r4
	mov	r8, r5
	cmp	r0, r1
	blne	.Lload
	ldrh	r1, [r11, #-4]
	ldr	r0, [r7]
	mov	r8, r7
	cmp	r0, r1
	blne	.Lload
	ldrh	r1, [r11, #-2]
	ldr	r0, [r9]
	mov	r8, r9
	cmp	r0, r1
	blne	.Lload
	mov	r3, r5
	mov	r12, r7
	cmp	r5, r7
	cmpne	r5, r9
	cmpne	r7, r9
	mov	lr, r9
	ldr	r5, [r5, #4]
	ldr	r7, [r7, #4]
	ldr	r9, [r9, #4]
	bne	.Lready

	/* outside, or two of one slot */
.Lother:
	ldr	r0, [sp, #DRAW]
	sub	r1, r11, #6
	bl	soft_list_other
	b	.Lnext

	/* r8 a place, of tag r0, for the vertex of index r1 */
.Lload:	ldr	r3, [sp, #CACHE]
	sub	r2, r8, r10
	mov	r4, #VERTEX_BYTES / 8
	mla	r4, r4, r2, r3
	cmn	r0, #2
	beq	.Lknown
.Ltransform:
	str	lr, [sp, #RETURN]
	ldr	r0, [sp, #DRAW]
	mov	r6, r1
	mov	r2, r4
	bl	soft_transform
	ldrb	r0, [r4, #VERTEX_OUTCODE]
	ldr	r2, [r4, #VERTEX_X]
	ldr	r3, [r4, #VERTEX_X + 4]
	cmp	r0, #0
	bne	.Loutside
	orr	r3, r2, r3, lsl #16
	mov	r2, r6
	strd	r2, [r8]
	ldr	pc, [sp, #RETURN]
.Lknown:
	ldr	r0, [r4, #VERTEX_INDEX]
	cmp	r0, r1
	bne	.Ltransform
	b	.Lother
.Loutside:
	mvn	r6, #1
	str	r6, [r8]
	b	.Lother
	.size	soft_list, . - soft_list

	.section .note.GNU-stack, "", %progbits
