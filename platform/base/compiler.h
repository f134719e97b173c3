/*
 * The only header that names compiler extensions.
 */
#ifndef PLATFORM_BASE_COMPILER_H
#define PLATFORM_BASE_COMPILER_H

/* Checks a printf-like function's arguments against its format. */
#define PRINTF_LIKE(format_index, first_argument)                              \
	__attribute__((format(printf, format_index, first_argument)))

#define ARRAY_COUNT(array) (sizeof(array) / sizeof((array)[0]))

#endif
