/*
 * Reads the bytes of a .x file as tokens, numbers, strings and data objects.
 *
 * A reader always holds the next token. Text and binary files have a scan
 * function each, and share the rest. Scanning drops separators, because the
 * type of a data object already says how many values follow. The reader's
 * scratch arena owns all results.
 */
#ifndef APP_MODEL_XFILE_XFILE_READER_H
#define APP_MODEL_XFILE_XFILE_READER_H

#include "platform/base/arena.h"
#include "platform/base/log.h"
#include "platform/base/memory_budget.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
	XFILE_HEADER_BYTES = 16,
	XFILE_MAX_DEPTH = 512, /* nesting of data objects */
};

/*
 * What messages need to know of the file. A location is a line in text files
 * and an offset in bytes in binary files.
 */
struct xfile_context {
	const char *path;
	const struct log *log;
	struct memory_budget *budget; /* the model's */
	bool binary;
	bool unpacked; /* whether locations refer to decompressed data */
};

enum xfile_token_kind {
	XFILE_END,
	XFILE_WORD,   /* text, length */
	XFILE_STRING, /* text, length: without the quotes */
	XFILE_NUMBER, /* number; text and length too in text files */
	XFILE_GUID,
	XFILE_OPEN,  /* { */
	XFILE_CLOSE, /* } */
	XFILE_OTHER, /* a token that occurs only in templates */
};

struct xfile_token {
	enum xfile_token_kind kind;
	size_t location;
	const char *text; /* points into the file; not zero-terminated */
	size_t length;
	double number;
};

struct xfile_reader {
	struct xfile_context context;
	struct arena *scratch;
	int (*scan)(struct xfile_reader *reader, struct xfile_token *token);
	const uint8_t *body; /* the bytes behind the header */
	const uint8_t *at;
	const uint8_t *end;
	size_t line;        /* text: line number of at, from 1 */
	int float_bytes;    /* binary: 4 or 8 */
	uint32_t list_left; /* binary: elements of the present list that are not
			       scanned yet */
	bool list_float;
	int depth;
	struct xfile_token token; /* the next token */
};

/*
 * Begins with the body of a file and scans its first token. Returns 0, or
 * -EINVAL after an error on the log.
 */
int xfile_reader_begin(
	struct xfile_reader *reader, const uint8_t *body, size_t size);

/*
 * Scan the token at reader->at. Return 0, or -EINVAL after an error on the log.
 * At the end of the data the token is XFILE_END.
 */
int xfile_scan_text(struct xfile_reader *reader, struct xfile_token *token);
int xfile_scan_binary(struct xfile_reader *reader, struct xfile_token *token);

/* Logs an error "PATH: line N: ..." or "PATH: byte N: ..."; returns -EINVAL. */
int xfile_fail_at(const struct xfile_context *context, size_t location,
	const char *format, ...) PRINTF_LIKE(3, 4);

/* Logs the same as a warning. */
void xfile_warn_at(const struct xfile_context *context, size_t location,
	const char *format, ...) PRINTF_LIKE(3, 4);

/* Logs that there is not enough memory; returns -ENOMEM. */
int xfile_no_memory(const struct xfile_context *context);

/*
 * Read members of a data object. what names the member in messages ("the vertex
 * count"). Return 0, or -errno after an error on the log. Floats are finite and
 * at most MODEL_NUMBER_MAX.
 */
int xfile_read_integer(
	struct xfile_reader *reader, const char *what, uint32_t *out);
int xfile_read_floats(struct xfile_reader *reader, const char *what,
	size_t count, float *out);
int xfile_read_double(
	struct xfile_reader *reader, const char *what, double *out);

/* Reads a string or word. Its bytes are copied as they are. */
int xfile_read_string(
	struct xfile_reader *reader, const char *what, const char **out);

/* Reads a string or word and cleans it by xfile_clean_name(). */
int xfile_read_name(
	struct xfile_reader *reader, const char *what, const char **out);

/*
 * Returns a copy in valid UTF-8: bytes that are not UTF-8 are taken as Latin-1,
 * control characters become spaces. Returns NULL if there is not enough memory.
 */
char *xfile_clean_name(struct arena *arena, const char *text);

/*
 * Reads a count of elements, each of which has at least `numbers` numbers in
 * the file. Fails if the rest of the file is too short for them. This bounds
 * the memory that the caller allocates.
 */
int xfile_read_count(struct xfile_reader *reader, const char *what,
	size_t numbers, uint32_t *out);

/* Reads a count and so many vectors of width floats, [*count][width]. */
int xfile_read_vectors(struct xfile_reader *reader, const char *what, int width,
	uint32_t *count, float **out);

struct xfile_scope;

/*
 * A type of data object and its parser. parse() is called behind the opening
 * brace and reads up to and including the closing brace. name is "" if the
 * object has none.
 */
struct xfile_kind {
	const char *type;
	int (*parse)(struct xfile_reader *reader,
		const struct xfile_scope *scope, const char *name);
};

/* What a data object may contain; other things are skipped. */
struct xfile_grammar {
	const struct xfile_kind *kinds; /* ends with a NULL type */

	/* Handles a reference { NAME }. NULL: references are ignored. */
	int (*reference)(struct xfile_reader *reader,
		const struct xfile_scope *scope, const char *name,
		size_t location);
};

/* Reads data objects and references to the parent's closing brace. */
int xfile_read_children(struct xfile_reader *reader,
	const struct xfile_grammar *grammar, const struct xfile_scope *scope);

/* Reads data objects and references up to the end of the file. */
int xfile_read_top(struct xfile_reader *reader,
	const struct xfile_grammar *grammar, const struct xfile_scope *scope);

/* Skips the rest of a data object and its closing brace. */
int xfile_skip_rest(struct xfile_reader *reader);

#endif
