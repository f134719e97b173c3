/*
 * The bytes of a .x file as tokens, numbers, strings and data objects.
 *
 * A reader always holds the next token, not yet taken. Text and binary files
 * differ only in the scan function that finds it. Separators carry no meaning
 * that the templates do not already give, so scanning drops them. Everything
 * that a reader hands out lives in its scratch arena.
 */
#ifndef APP_MODEL_XFILE_XFILE_READER_H
#define APP_MODEL_XFILE_XFILE_READER_H

#include "platform/base/arena.h"
#include "platform/base/log.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
	XFILE_HEADER_BYTES = 16,
	XFILE_MAX_DEPTH = 512, /* data objects within data objects */
};

/* Who is read, for sentences. A place is a line or a byte offset. */
struct xfile_source {
	const char *path;
	const struct log *log;
	bool binary;
	bool unpacked; /* places count in the unpacked data */
};

enum xfile_token_kind {
	XFILE_END,
	XFILE_WORD,   /* text, length */
	XFILE_STRING, /* text, length: without the quotes */
	XFILE_NUMBER, /* number; text and length too in text files */
	XFILE_GUID,
	XFILE_OPEN,  /* { */
	XFILE_CLOSE, /* } */
	XFILE_OTHER, /* what only templates hold */
};

struct xfile_token {
	enum xfile_token_kind kind;
	size_t place;
	const char *text; /* into the data, not zero-terminated */
	size_t length;
	double number;
};

struct xfile_reader {
	struct xfile_source source;
	struct arena *scratch;
	int (*scan)(struct xfile_reader *reader, struct xfile_token *token);
	const uint8_t *body; /* what follows the header */
	const uint8_t *at;
	const uint8_t *end;
	size_t line;        /* text: the line of at, from 1 */
	int float_bytes;    /* binary: 4 or 8 */
	uint32_t list_left; /* binary: elements of a list not yet scanned */
	bool list_float;
	int depth;
	struct xfile_token token; /* the next */
};

/* Starts on the body of a file; the first token is scanned. 0 or -errno. */
int xfile_reader_begin(
	struct xfile_reader *reader, const uint8_t *body, size_t size);

/*
 * Scanners: the token at reader->at, or -EINVAL after a sentence. Scanning at
 * the end of the data gives XFILE_END.
 */
int xfile_scan_text(struct xfile_reader *reader, struct xfile_token *token);
int xfile_scan_binary(struct xfile_reader *reader, struct xfile_token *token);

/*
 * Reads a number spelled in text, all of it: digits with an optional sign,
 * fraction and exponent, whatever the locale. What Microsoft's C library
 * prints for NaN and infinity (1.#IND and the like) is 0.
 */
bool xfile_parse_number(const char *text, size_t length, double *out);

/* Says "PATH: line N: ..." or "PATH: byte N: ..." and returns -EINVAL. */
int xfile_fail_at(const struct xfile_source *source, size_t place,
	const char *format, ...) PRINTF_LIKE(3, 4);

/* The same as a warning. */
void xfile_warn_at(const struct xfile_source *source, size_t place,
	const char *format, ...) PRINTF_LIKE(3, 4);

/* Says that memory is short and returns -ENOMEM. */
int xfile_no_memory(const struct xfile_source *source);

/* Drops the next token and scans the one after it. */
int xfile_advance(struct xfile_reader *reader);

/*
 * Members of a data object. what names the member in sentences ("the vertex
 * count"). A float is finite.
 */
int xfile_read_integer(
	struct xfile_reader *reader, const char *what, uint32_t *out);
int xfile_read_floats(struct xfile_reader *reader, const char *what,
	size_t count, float *out);
int xfile_read_double(
	struct xfile_reader *reader, const char *what, double *out);

/* A string or word, byte for byte. */
int xfile_read_string(
	struct xfile_reader *reader, const char *what, const char **out);

/* The same as a name, in the form below. */
int xfile_read_name(
	struct xfile_reader *reader, const char *what, const char **out);

/*
 * A copy in valid UTF-8: other bytes are read as Latin-1, control characters
 * become spaces. NULL when memory is short.
 */
char *xfile_clean_name(struct arena *arena, const char *text);

/*
 * A count of elements that follow, each of at least numbers numbers; fails
 * where the rest of the file cannot hold them, so that it bounds memory.
 */
int xfile_read_count(struct xfile_reader *reader, const char *what,
	size_t numbers, uint32_t *out);

/* Floats and counts with room in the scratch arena. */
int xfile_read_vectors(struct xfile_reader *reader, const char *what, int width,
	uint32_t *count, float **out);

struct xfile_scope;

/*
 * What to do with a data object of a type: parse() is called behind the brace
 * that opens it and returns behind the brace that closes it.
 */
struct xfile_kind {
	const char *type;
	int (*parse)(struct xfile_reader *reader,
		const struct xfile_scope *scope, const char *name);
};

/* What a list of data objects may hold. */
struct xfile_grammar {
	const struct xfile_kind *kinds; /* ends with a NULL type */

	/* { NAME }; may be NULL: such references are ignored. */
	int (*reference)(struct xfile_reader *reader,
		const struct xfile_scope *scope, const char *name, size_t place);
};

/* Takes data objects and references up to the brace that closes the parent. */
int xfile_read_children(struct xfile_reader *reader,
	const struct xfile_grammar *grammar, const struct xfile_scope *scope);

/* The same without a parent, up to the end of the file. */
int xfile_read_top(struct xfile_reader *reader,
	const struct xfile_grammar *grammar, const struct xfile_scope *scope);

/* Skips what is left of a data object, and the brace that closes it. */
int xfile_read_rest(struct xfile_reader *reader);

#endif
