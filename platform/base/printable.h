/*
 * Text from files and devices, for terminals.
 *
 * A name in a file may hold escape sequences that a terminal executes,
 * characters that reverse the direction of what follows, or bytes that are no
 * UTF-8. These functions replace each byte of such a character by a question
 * mark. Whatever prints such a name uses them; log_write() does so by itself.
 */
#ifndef PLATFORM_BASE_PRINTABLE_H
#define PLATFORM_BASE_PRINTABLE_H

#include <stdio.h>

/* Replaces the characters in place. */
void printable_make(char *text);

/* Prints the text with these characters replaced. */
void printable_put(const char *text, FILE *out);

/*
 * The same for text inside a comment of C: also replaces the second character
 * of what would begin or end a comment.
 */
void printable_put_comment(const char *text, FILE *out);

#endif
