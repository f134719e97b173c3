/*
 * The only header that names compiler extensions.
 */
#ifndef PLATFORM_BASE_COMPILER_H
#define PLATFORM_BASE_COMPILER_H

/* Checks a printf-like function's arguments against its format. */
#define PRINTF_LIKE(format_index, first_argument)                              \
	__attribute__((format(printf, format_index, first_argument)))

#define ARRAY_COUNT(array) (sizeof(array) / sizeof((array)[0]))

/* For small functions whose arguments must become constants of their caller. */
#define ALWAYS_INLINE inline __attribute__((always_inline))

/* How many zero bits stand above the highest one; value is not 0. */
#define LEADING_ZEROS_32(value) __builtin_clz(value)
#define LEADING_ZEROS_64(value) __builtin_clzll(value)

#endif
