/*
 * Noticing every allocation of jansson that fails.
 *
 * Many of jansson's functions accept NULL where an earlier one found no memory,
 * so a value may be missing from a file that looks complete. Between
 * json_memory_begin() and json_memory_ok() all of them are watched; whoever
 * builds or reads JSON checks the result before using it. Jansson has one
 * allocator for the whole process, so the watch is for one thread at a time.
 *
 * Jansson's lexer ignores a buffer that could not grow, and then reads and
 * writes beyond it. A load is therefore abandoned at the first allocation that
 * fails.
 */
#ifndef PLATFORM_BASE_JSON_MEMORY_H
#define PLATFORM_BASE_JSON_MEMORY_H

#include <stdbool.h>
#include <stddef.h>

#include <jansson.h>

/* Begins to watch, and forgets earlier failures. */
void json_memory_begin(void);

/* Whether no allocation has failed since json_memory_begin(). */
bool json_memory_ok(void);

/*
 * json_loadb() between a json_memory_begin() of its own and the caller's
 * json_memory_ok(). Returns NULL when the text is wrong or memory is short; in
 * the second case *error is undefined.
 */
json_t *json_memory_load(
	const char *text, size_t size, size_t flags, json_error_t *error);

#endif
