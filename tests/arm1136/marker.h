/*
 * Marks for the timing model (README.md): no-ops that no compiler makes, so a
 * marked program runs as it did. For C and for assembly on ARM.
 *
 *   MARKER_BEGIN(3);
 *   kernel(...);
 *   MARKER_END(3);
 *
 * A region is known by the function its beginning is in and by its number,
 * 0-12. It may be entered often; regions do not nest. Between regions,
 * MARKER_FLUSH(MARKER_ALL) empties all caches, MARKER_DATA those of data, so
 * that it comes from memory, MARKER_L1_DATA only the first, so that it comes
 * from L2.
 */
#ifndef TESTS_ARM1136_MARKER_H
#define TESTS_ARM1136_MARKER_H

#define MARKER_ALL     0
#define MARKER_DATA    1
#define MARKER_L1_DATA 2

#define MARKER_JOIN_(op, n, last) op r##n, r##n, last
#define MARKER_JOIN(op, n, last)  MARKER_JOIN_(op, n, last)

#ifdef __ASSEMBLER__

#define MARKER_BEGIN(n)    orr r##n, r##n, r##n
#define MARKER_END(n)      and r##n, r##n, r##n
#define MARKER_FLUSH(what) MARKER_JOIN(bic, what, 0)

#elif defined(__arm__)

#define MARKER_TEXT_(...)  #__VA_ARGS__
#define MARKER_TEXT(...)   MARKER_TEXT_(__VA_ARGS__)
#define MARKER_ASM(...)    __asm__ volatile(MARKER_TEXT(__VA_ARGS__)::: "memory")
#define MARKER_BEGIN(n)    MARKER_ASM(orr r##n, r##n, r##n)
#define MARKER_END(n)      MARKER_ASM(and r##n, r##n, r##n)
#define MARKER_FLUSH(what) MARKER_ASM(MARKER_JOIN(bic, what, 0))

#else

#define MARKER_BEGIN(n)    ((void)0)
#define MARKER_END(n)      ((void)0)
#define MARKER_FLUSH(what) ((void)0)

#endif

#endif
