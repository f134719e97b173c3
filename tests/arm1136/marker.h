/*
 * Marks regions for the timing model (README.md), in C and in assembly for ARM.
 * A mark is a no-op that no compiler generates, so a marked program behaves as
 * it did before. On other machines marks are nothing.
 *
 *   MARKER_BEGIN(3);
 *   kernel(...);
 *   MARKER_END(3);
 *
 * A region is named by the function that contains its MARKER_BEGIN and by its
 * number, 0-12. It may be entered often; regions do not nest. Between regions,
 * MARKER_FLUSH(MARKER_ALL) empties all caches and TLBs. MARKER_DATA empties the
 * data caches, so that data comes from memory; MARKER_L1_DATA empties L1, so
 * that data comes from L2. MARKER_PAGES empties the data TLBs.
 */
#ifndef TESTS_ARM1136_MARKER_H
#define TESTS_ARM1136_MARKER_H

#define MARKER_ALL     0
#define MARKER_DATA    1
#define MARKER_L1_DATA 2
#define MARKER_PAGES   3

#ifdef __ASSEMBLER__

#define MARKER_JOIN(op, n, last) op r##n, r##n, last
#define MARKER_BEGIN(n)          MARKER_JOIN(orr, n, r##n)
#define MARKER_END(n)            MARKER_JOIN(and, n, r##n)
#define MARKER_FLUSH_(what)      MARKER_JOIN(bic, what, 0)
#define MARKER_FLUSH(what)       MARKER_FLUSH_(what)

#elif defined(__arm__)

#define MARKER_TEXT(x) #x
#define MARKER_ASM(op, n, last)                                                \
	__asm__ volatile(op                                                    \
			 " r" MARKER_TEXT(n) ", r" MARKER_TEXT(n) ", " last :: \
				 : "memory")
#define MARKER_BEGIN(n)    MARKER_ASM("orr", n, "r" MARKER_TEXT(n))
#define MARKER_END(n)      MARKER_ASM("and", n, "r" MARKER_TEXT(n))
#define MARKER_FLUSH(what) MARKER_ASM("bic", what, "#0")

#else

#define MARKER_BEGIN(n)    ((void)0)
#define MARKER_END(n)      ((void)0)
#define MARKER_FLUSH(what) ((void)0)

#endif

#endif
