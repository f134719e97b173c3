/*
 * Morphing for ARMv6. Results equal those of the functions of the same names in
 * fixed_loops.c bit for bit. Vectors and sums are loaded and stored in words:
 *
 *   vector  { x, fraction }  { z, y }      upper half first
 *   sum     x  y  z
 */
	.syntax	unified
	.arch	armv6
	.arm
	.text

#define AHEAD 96

/* Packs the upper halves of y and z into z, as y and z of a fixed_vector. */
	.macro	pack y, z
	pkhtb	\z, \z, \y, asr #16
	.endm

/*
 * void kernel_armv6_lerp(int count, const struct fixed_pair (*pair)[3],
 *	struct fixed_weights weights, struct fixed_vector *out);
 *
 *   r0 vertices left   r1 pairs   r2 weights   r3 out   r12 a half
 *
 * The loop does three vertices: while it loads one, it weighs the previous one
 * and stores the one before that.
 */
	.macro	weigh x, y, z
	smlad	\y, \y, r2, r12
	smlad	\z, \z, r2, r12
	smlad	\x, \x, r2, r12
	.endm

	.global	kernel_armv6_lerp
	.type	kernel_armv6_lerp, %function
kernel_armv6_lerp:
	push	{r4-r11, lr}
	subs	r0, r0, #1
	mov	r12, #0x8000
	blt	lerp_done
	ldmia	r1!, {r4, r5, r6}
	subs	r0, r0, #3
	blt	lerp_rest
1:	ldmia	r1!, {r7, r8, r9}
	weigh	r4, r5, r6
	ldmia	r1!, {r10, r11, lr}
	weigh	r7, r8, r9
	pack	r5, r6
	pld	[r1, #AHEAD]
	stmia	r3!, {r4, r6}
	ldmia	r1!, {r4, r5, r6}
	weigh	r10, r11, lr
	pack	r8, r9
	subs	r0, r0, #3
	stmia	r3!, {r7, r9}
	pack	r11, lr
	stmia	r3!, {r10, lr}
	bge	1b
/* r4 r5 r6 hold a loaded vertex, and r0 + 3 more follow. */
lerp_rest:
	add	r0, r0, #3
2:	weigh	r4, r5, r6
	subs	r0, r0, #1
	ldmiage	r1!, {r7, r8, r9}
	pack	r5, r6
	stmia	r3!, {r4, r6}
	mov	r4, r7
	mov	r5, r8
	mov	r6, r9
	bge	2b
lerp_done:
	pop	{r4-r11, pc}
	.size	kernel_armv6_lerp, . - kernel_armv6_lerp

/*
 * void kernel_armv6_lerp_keys(int count, const struct fixed_key *source,
 *	const struct fixed_key *destiny, struct fixed_weights weights,
 *	struct fixed_vector *out);
 *
 *   r0 vertices left   r1 source   r2 destiny   r3 weights   r12 a half
 *   lr out   r4-r6, r7-r9  two vertices of each key: { y, x } { x, z } { z, y }
 *
 * Two vertices are three words of each key. PKH makes pairs of the two keys'
 * halves; in lerp they are pairs already.
 */
	.macro	pair_keys
	pkhbt	r10, r4, r7, lsl #16
	pkhtb	r11, r7, r4, asr #16
	pkhbt	r4, r5, r8, lsl #16
	smlad	r10, r10, r3, r12
	smlad	r11, r11, r3, r12
	smlad	r4, r4, r3, r12
	.endm

	.global	kernel_armv6_lerp_keys
	.type	kernel_armv6_lerp_keys, %function
kernel_armv6_lerp_keys:
	push	{r4-r11, lr}
	ldr	lr, [sp, #36]
	mov	r12, #0x8000
	subs	r0, r0, #2
	blt	2f
1:	ldmia	r1!, {r4, r5, r6}
	ldmia	r2!, {r7, r8, r9}
	pld	[r1, #AHEAD]
	pld	[r2, #AHEAD]
	subs	r0, r0, #2
	pair_keys
	pkhtb	r7, r8, r5, asr #16
	pkhbt	r5, r6, r9, lsl #16
	pkhtb	r8, r9, r6, asr #16
	pkhtb	r11, r4, r11, asr #16
	smlad	r5, r5, r3, r12
	smlad	r8, r8, r3, r12
	stmia	lr!, {r10, r11}
	smlad	r7, r7, r3, r12
	pack	r5, r8
	stmia	lr!, {r7, r8}
	bge	1b
2:	adds	r0, r0, #1
	blt	3f
	ldmia	r1, {r4, r5}
	ldmia	r2, {r7, r8}
	pair_keys
	pack	r11, r4
	str	r10, [lr]
	str	r4, [lr, #4]
3:	pop	{r4-r11, pc}
	.size	kernel_armv6_lerp_keys, . - kernel_armv6_lerp_keys

/*
 * void kernel_armv6_increment(int count, const struct fixed_vector *step,
 *	struct fixed_vector *vector);
 *
 *   r0 vertices left   r1 steps   r2 vectors
 */
	.global	kernel_armv6_increment
	.type	kernel_armv6_increment, %function
kernel_armv6_increment:
	push	{r4-r11, lr}
	subs	r0, r0, #2
	blt	2f
1:	ldmia	r1!, {r4-r7}
	ldmia	r2, {r8-r11}
	pld	[r1, #AHEAD]
	pld	[r2, #AHEAD]
	qadd16	r4, r4, r8
	qadd16	r5, r5, r9
	qadd16	r6, r6, r10
	qadd16	r7, r7, r11
	subs	r0, r0, #2
	stmia	r2!, {r4-r7}
	bge	1b
2:	adds	r0, r0, #1
	blt	3f
	ldmia	r1, {r4, r5}
	ldmia	r2, {r8, r9}
	qadd16	r4, r4, r8
	qadd16	r5, r5, r9
	stmia	r2, {r4, r5}
3:	pop	{r4-r11, pc}
	.size	kernel_armv6_increment, . - kernel_armv6_increment

/*
 * void kernel_armv6_morph_pair(int count, const struct fixed_vector *base,
 *	const struct fixed_pair (*pair)[3], struct fixed_weights weights,
 *	struct fixed_vector *out);
 *
 *   r0 vertices left   r1 base   r2 pairs   r3 weights   r12 out
 *   r7 r11 lr  a vertex's pairs
 *   r4 r5 r6, r8 r9 r10  sums x z y of two vertices in turn, from base
 *
 * A step loads a vertex's pairs, stores the previous vertex, adds the pairs to
 * the base, and loads the base of the next vertex.
 */
	.macro	expand x, z, y
	pkhbt	\y, \x, \z, lsl #16
	pkhbt	\z, \x, \z
	.endm

	.macro	add_pair x, z, y
	smlad	\y, r11, r3, \y
	smlad	\z, lr, r3, \z
	smlad	\x, r7, r3, \x
	.endm

	.macro	even_step
	ldmia	r2!, {r7, r11, lr}
	pack	r10, r9
	stmia	r12!, {r8, r9}
	expand	r4, r5, r6
	add_pair r4, r5, r6
	ldrd	r8, r9, [r1], #8
	.endm

	.macro	odd_step
	ldmia	r2!, {r7, r11, lr}
	pack	r6, r5
	stmia	r12!, {r4, r5}
	expand	r8, r9, r10
	add_pair r8, r9, r10
	ldrd	r4, r5, [r1], #8
	.endm

	.global	kernel_armv6_morph_pair
	.type	kernel_armv6_morph_pair, %function
kernel_armv6_morph_pair:
	pld	[r1]
	pld	[r2]
	push	{r3-r11, lr}
	pld	[r2, #32]
	pld	[r1, #32]
	ldr	r12, [sp, #40]
	subs	r0, r0, #10
	pld	[r2, #64]
	blt	morph_rest
/* The first vertex is done without a step, since there is none to store yet. */
	ldrd	r4, r5, [r1], #8
	ldmia	r2!, {r7, r11, lr}
	expand	r4, r5, r6
	add_pair r4, r5, r6
	ldrd	r8, r9, [r1], #8
1:	odd_step
	pld	[r2, #AHEAD]
	even_step
	odd_step
	pld	[r2, #AHEAD]
	even_step
	pld	[r1, #AHEAD]
	odd_step
	even_step
	pld	[r2, #AHEAD]
	odd_step
	even_step
	subs	r0, r0, #8
	pld	[r1, #AHEAD]
	bge	1b
/*
 * Stores the last vertex, and goes back by the base that was loaded too early.
 */
	pack	r6, r5
	stmia	r12!, {r4, r5}
	sub	r1, r1, #8
	sub	r0, r0, #1
morph_rest:
	adds	r0, r0, #10
	ble	3f
2:	ldrd	r4, r5, [r1], #8
	ldmia	r2!, {r7, r11, lr}
	subs	r0, r0, #1
	expand	r4, r5, r6
	add_pair r4, r5, r6
	pack	r6, r5
	stmia	r12!, {r4, r5}
	bgt	2b
3:	pop	{r3-r11, pc}
	.size	kernel_armv6_morph_pair, . - kernel_armv6_morph_pair

/*
 * void kernel_armv6_morph_begin(int count, const struct fixed_vector *base,
 *	struct fixed_sum *sum);
 */
	.global	kernel_armv6_morph_begin
	.type	kernel_armv6_morph_begin, %function
kernel_armv6_morph_begin:
	push	{r4-r11, lr}
	subs	r0, r0, #2
	blt	2f
1:	ldmia	r1!, {r4, r5}
	ldmia	r1!, {r7, r8}
	subs	r0, r0, #2
	pkhbt	r6, r4, r5
	pkhbt	r5, r4, r5, lsl #16
	pkhbt	r9, r7, r8
	pkhbt	r8, r7, r8, lsl #16
	pld	[r1, #AHEAD]
	stmia	r2!, {r4-r9}
	bge	1b
2:	adds	r0, r0, #1
	blt	3f
	ldmia	r1, {r4, r5}
	pkhbt	r6, r4, r5
	pkhbt	r5, r4, r5, lsl #16
	stmia	r2, {r4, r5, r6}
3:	pop	{r4-r11, pc}
	.size	kernel_armv6_morph_begin, . - kernel_armv6_morph_begin

/*
 * void kernel_armv6_morph_add(int count, const struct fixed_pair (*pair)[3],
 *	struct fixed_weights weights, struct fixed_sum *sum);
 *
 *   r0 vertices left   r1 pairs   r2 weights   r3 sums
 */
	.global	kernel_armv6_morph_add
	.type	kernel_armv6_morph_add, %function
kernel_armv6_morph_add:
	push	{r4-r11, lr}
	subs	r0, r0, #2
	blt	2f
1:	ldmia	r1!, {r4, r5, r6}
	ldmia	r3, {r7, r8, r9}
	pld	[r1, #AHEAD]
	subs	r0, r0, #2
	smlad	r7, r4, r2, r7
	smlad	r8, r5, r2, r8
	smlad	r9, r6, r2, r9
	ldmia	r1!, {r4, r5, r6}
	stmia	r3!, {r7, r8, r9}
	ldmia	r3, {r10, r11, lr}
	smlad	r10, r4, r2, r10
	smlad	r11, r5, r2, r11
	smlad	lr, r6, r2, lr
	stmia	r3!, {r10, r11, lr}
	bge	1b
2:	adds	r0, r0, #1
	blt	3f
	ldmia	r1, {r4, r5, r6}
	ldmia	r3, {r7, r8, r9}
	smlad	r7, r4, r2, r7
	smlad	r8, r5, r2, r8
	smlad	r9, r6, r2, r9
	stmia	r3, {r7, r8, r9}
3:	pop	{r4-r11, pc}
	.size	kernel_armv6_morph_add, . - kernel_armv6_morph_add

/*
 * void kernel_armv6_morph_end(int count, const struct fixed_sum *sum,
 *	struct fixed_vector *out);
 */
	.global	kernel_armv6_morph_end
	.type	kernel_armv6_morph_end, %function
kernel_armv6_morph_end:
	push	{r4-r11, lr}
	subs	r0, r0, #2
	blt	2f
1:	ldmia	r1!, {r4-r9}
	subs	r0, r0, #2
	pack	r5, r6
	pack	r8, r9
	stmia	r2!, {r4, r6, r7, r9}
	bge	1b
2:	adds	r0, r0, #1
	blt	3f
	ldmia	r1, {r4, r5, r6}
	pack	r5, r6
	stmia	r2, {r4, r6}
3:	pop	{r4-r11, pc}
	.size	kernel_armv6_morph_end, . - kernel_armv6_morph_end

/*
 * void kernel_armv6_rebase(int count, const struct fixed_rebase *rebase,
 *	const struct fixed_vector *delta, struct fixed_base *base);
 *
 *   r0 influences left   r1 rebase   r2 deltas   r3 base   r12 a half
 */
	.global	kernel_armv6_rebase
	.type	kernel_armv6_rebase, %function
kernel_armv6_rebase:
	push	{r4-r11, lr}
	subs	r0, r0, #1
	mov	r12, #0x8000
	blt	2f
1:	ldmia	r1!, {r4-r7}	/* y x, w z, base_index, weight_q16 delta_index */
	pld	[r1, #AHEAD]
	subs	r0, r0, #1
	pkhbt	r10, r12, r4, lsl #16
	pkhbt	r11, r12, r4
	pkhbt	lr, r12, r5, lsl #16
	uxth	r8, r7
	add	r8, r2, r8, lsl #3
	ldmia	r8, {r8, r9}	/* x fraction, z y */
	add	r6, r3, r6, lsl #3
	smlatt	r10, r8, r7, r10
	smlabt	r11, r9, r7, r11
	smlatt	lr, r9, r7, lr
	pkhtb	r10, r11, r10, asr #16
	pkhtb	r11, r5, lr, asr #16
	stmia	r6, {r10, r11}
	bge	1b
2:	pop	{r4-r11, pc}
	.size	kernel_armv6_rebase, . - kernel_armv6_rebase

	.section .note.GNU-stack, "", %progbits
