#include "app/model/xfile/xfile_reader.h"

#include "app/model/model.h"
#include "platform/base/interrupt.h"

#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

static void log_at(const struct xfile_context *context, size_t location,
	enum log_level level, const char *format, va_list arguments)
{
	char reason[512];

	vsnprintf(reason, sizeof(reason), format, arguments);
	log_write(context->log, level, "%s: %s %zu%s: %s", context->path,
		context->binary ? "byte" : "line", location,
		context->unpacked ? " of the decompressed data" : "", reason);
}

int xfile_fail_at(const struct xfile_context *context, size_t location,
	const char *format, ...)
{
	va_list arguments;

	va_start(arguments, format);
	log_at(context, location, LOG_ERROR, format, arguments);
	va_end(arguments);
	return -EINVAL;
}

void xfile_warn_at(const struct xfile_context *context, size_t location,
	const char *format, ...)
{
	va_list arguments;

	va_start(arguments, format);
	log_at(context, location, LOG_WARNING, format, arguments);
	va_end(arguments);
}

int xfile_no_memory(const struct xfile_context *context)
{
	return memory_budget_fail(context->budget, context->path, context->log);
}

/* Replaces the token by the next one. */
static int advance(struct xfile_reader *reader)
{
	return interrupt_pending() ? -EINTR
				   : reader->scan(reader, &reader->token);
}

int xfile_reader_begin(
	struct xfile_reader *reader, const uint8_t *body, size_t size)
{
	reader->body = body;
	reader->at = body;
	reader->end = body + size;
	reader->line = 1;
	reader->list_left = 0;
	reader->depth = 0;
	return advance(reader);
}

static char *copy_text(struct xfile_reader *reader)
{
	const struct xfile_token *token = &reader->token;
	char *text = ARENA_ARRAY(reader->scratch, char, token->length + 1);

	if (text && token->length) {
		memcpy(text, token->text, token->length);
	}
	return text;
}

/* Returns a clause about a token, for messages. */
static const char *describe(const struct xfile_token *token, char buffer[48])
{
	static const char *const other[] = {
		[XFILE_END] = "the file ends",
		[XFILE_GUID] = "there is a GUID",
		[XFILE_OPEN] = "there is an opening brace",
		[XFILE_CLOSE] = "there is a closing brace",
		[XFILE_OTHER] = "there is a punctuation mark",
	};
	int length = 0;

	switch (token->kind) {
	case XFILE_WORD:
	case XFILE_STRING:
		length = snprintf(buffer, 48, "there is \"%.*s\"",
			(int)(token->length < 32 ? token->length : 32),
			token->text);
		break;
	case XFILE_NUMBER:
		length = snprintf(buffer, 48, "there is %.9g", token->number);
		break;
	default:
		return other[token->kind];
	}
	for (int i = 0; i < length && i < 47; i++) {
		if ((unsigned char)buffer[i] < ' ' ||
			(unsigned char)buffer[i] > '~') {
			buffer[i] = '?';
		}
	}
	return buffer;
}

static int fail_expected(struct xfile_reader *reader, const char *what)
{
	char buffer[48];

	return xfile_fail_at(&reader->context, reader->token.location,
		"%s is expected here, but %s", what,
		describe(&reader->token, buffer));
}

int xfile_read_double(struct xfile_reader *reader, const char *what, double *out)
{
	if (reader->token.kind != XFILE_NUMBER) {
		return fail_expected(reader, what);
	}
	*out = reader->token.number;
	if (!(fabs(*out) <= (double)FLT_MAX)) {
		return xfile_fail_at(&reader->context, reader->token.location,
			"%s is not a finite number", what);
	}
	return advance(reader);
}

int xfile_read_integer(
	struct xfile_reader *reader, const char *what, uint32_t *out)
{
	size_t location = reader->token.location;
	double value = 0;
	int error = xfile_read_double(reader, what, &value);

	if (error) {
		return error;
	}
	if (!(value >= 0 && value <= (double)UINT32_MAX) ||
		value != floor(value)) {
		return xfile_fail_at(&reader->context, location,
			"%s is %.9g, but must be an integer from 0 to 4294967295",
			what, value);
	}
	*out = (uint32_t)value;
	return 0;
}

int xfile_read_floats(
	struct xfile_reader *reader, const char *what, size_t count, float *out)
{
	for (size_t i = 0; i < count; i++) {
		size_t location = reader->token.location;
		double value = 0;
		int error = xfile_read_double(reader, what, &value);

		if (error) {
			return error;
		}
		if (fabs(value) > (double)MODEL_NUMBER_MAX) {
			return xfile_fail_at(&reader->context, location,
				"%s is larger than 1e9", what);
		}
		out[i] = (float)value;
	}
	return 0;
}

int xfile_read_string(
	struct xfile_reader *reader, const char *what, const char **out)
{
	if (reader->token.kind != XFILE_STRING &&
		reader->token.kind != XFILE_WORD) {
		return fail_expected(reader, what);
	}
	*out = copy_text(reader);
	if (!*out) {
		return xfile_no_memory(&reader->context);
	}
	return advance(reader);
}

static size_t utf8_length(const unsigned char *text)
{
	size_t length = text[0] < 0x80              ? 1
		: text[0] >= 0xc2 && text[0] < 0xe0 ? 2
		: text[0] >= 0xe0 && text[0] < 0xf0 ? 3
		: text[0] >= 0xf0 && text[0] < 0xf5 ? 4
						    : 0;

	for (size_t i = 1; i < length; i++) {
		if ((text[i] & 0xc0) != 0x80) {
			return 0;
		}
	}
	/* Refuses overlong forms, surrogates, code points beyond U+10FFFF. */
	if ((text[0] == 0xe0 && text[1] < 0xa0) ||
		(text[0] == 0xed && text[1] > 0x9f) ||
		(text[0] == 0xf0 && text[1] < 0x90) ||
		(text[0] == 0xf4 && text[1] > 0x8f)) {
		return 0;
	}
	return length;
}

/* A Latin-1 character takes two bytes, so the result at most doubles. */
char *xfile_clean_name(struct arena *arena, const char *text)
{
	const unsigned char *from = (const unsigned char *)text;
	char *name = arena_alloc(arena, 2 * strlen(text) + 1, 1);
	char *to = name;

	while (name && *from) {
		size_t length = utf8_length(from);

		if (!length) {
			*to++ = (char)(0xc0 | *from >> 6);
			*to++ = (char)(0x80 | (*from & 0x3f));
			from++;
		} else if (*from < ' ' || *from == 0x7f) {
			*to++ = ' ';
			from++;
		} else {
			memcpy(to, from, length);
			to += length;
			from += length;
		}
	}
	return name;
}

int xfile_read_name(
	struct xfile_reader *reader, const char *what, const char **out)
{
	const char *text;
	int error;

	/* In a text file, a name may look like a number. */
	if (reader->token.kind == XFILE_NUMBER && reader->token.text) {
		reader->token.kind = XFILE_WORD;
	}
	error = xfile_read_string(reader, what, &text);
	if (error) {
		return error;
	}
	*out = xfile_clean_name(reader->scratch, text);
	return *out ? 0 : xfile_no_memory(&reader->context);
}

/*
 * Returns an upper bound of the numbers in the rest of the file. In text, a
 * number takes at least a digit and a separator.
 */
static size_t numbers_left(const struct xfile_reader *reader)
{
	size_t bytes = (size_t)(reader->end - reader->at);

	return 1 + (reader->context.binary ? bytes / 4 : bytes / 2 + 1);
}

int xfile_read_count(struct xfile_reader *reader, const char *what,
	size_t numbers, uint32_t *out)
{
	size_t location = reader->token.location;
	int error = xfile_read_integer(reader, what, out);

	if (error) {
		return error;
	}
	if (*out > numbers_left(reader) / numbers) {
		return xfile_fail_at(&reader->context, location,
			"%s is %u, which is more than the rest of the file can hold",
			what, (unsigned)*out);
	}
	return 0;
}

int xfile_read_vectors(struct xfile_reader *reader, const char *what, int width,
	uint32_t *count, float **out)
{
	size_t floats;
	int error = xfile_read_count(reader, what, (size_t)width, count);

	if (error) {
		return error;
	}
	floats = (size_t)*count * (size_t)width;
	*out = ARENA_ARRAY(reader->scratch, float, floats);
	if (!*out) {
		return xfile_no_memory(&reader->context);
	}
	return xfile_read_floats(reader, what, floats, *out);
}

int xfile_skip_rest(struct xfile_reader *reader)
{
	size_t open = 1;
	int error;

	while (open) {
		if (reader->token.kind == XFILE_END) {
			return xfile_fail_at(&reader->context,
				reader->token.location,
				"the file ends before a closing brace");
		}
		open += reader->token.kind == XFILE_OPEN;
		open -= reader->token.kind == XFILE_CLOSE;
		error = advance(reader);
		if (error) {
			return error;
		}
	}
	return 0;
}

static bool is_word(const struct xfile_token *token, const char *word)
{
	return token->kind == XFILE_WORD && token->length == strlen(word) &&
		!strncasecmp(token->text, word, token->length);
}

static const struct xfile_kind *find_kind(
	const struct xfile_token *token, const struct xfile_kind *kinds)
{
	for (; kinds->type; kinds++) {
		if (is_word(token, kinds->type)) {
			return kinds;
		}
	}
	return NULL;
}

/* Reads TYPE [NAME] { [<GUID>] up to the first member. */
static int read_head(struct xfile_reader *reader, const char **name)
{
	int error = advance(reader);

	*name = "";
	if (!error && reader->token.kind != XFILE_OPEN) {
		error = xfile_read_name(reader,
			"a data object's name or its opening brace", name);
	}
	if (!error && reader->token.kind != XFILE_OPEN) {
		error = fail_expected(
			reader, "the opening brace of a data object");
	}
	if (!error) {
		error = advance(reader);
	}
	if (!error && reader->token.kind == XFILE_GUID) {
		error = advance(reader);
	}
	return error;
}

static int read_object(struct xfile_reader *reader,
	const struct xfile_grammar *grammar, const struct xfile_scope *scope)
{
	const struct xfile_kind *kind =
		find_kind(&reader->token, grammar->kinds);
	size_t location = reader->token.location;
	const char *name;
	int error = read_head(reader, &name);

	if (error) {
		return error;
	}
	if (reader->depth == XFILE_MAX_DEPTH) {
		return xfile_fail_at(&reader->context, location,
			"data objects are nested more than %d levels deep",
			XFILE_MAX_DEPTH);
	}
	reader->depth++;
	error = kind ? kind->parse(reader, scope, name)
		     : xfile_skip_rest(reader);
	reader->depth--;
	return error;
}

/* Reads { NAME }, { <GUID> } or { NAME <GUID> }. */
static int read_reference(struct xfile_reader *reader,
	const struct xfile_grammar *grammar, const struct xfile_scope *scope)
{
	size_t location = reader->token.location;
	const char *name = NULL;
	int error = advance(reader);

	if (!error && reader->token.kind != XFILE_GUID &&
		reader->token.kind != XFILE_CLOSE) {
		error = xfile_read_name(
			reader, "the name of a data object", &name);
	}
	if (!error) {
		error = xfile_skip_rest(reader);
	}
	if (!error && name && grammar->reference) {
		error = grammar->reference(reader, scope, name, location);
	}
	return error;
}

int xfile_read_children(struct xfile_reader *reader,
	const struct xfile_grammar *grammar, const struct xfile_scope *scope)
{
	int error = 0;

	while (!error) {
		switch (reader->token.kind) {
		case XFILE_CLOSE:
			return advance(reader);
		case XFILE_END:
			return xfile_fail_at(&reader->context,
				reader->token.location,
				"the file ends before a closing brace");
		case XFILE_WORD:
			error = read_object(reader, grammar, scope);
			break;
		case XFILE_OPEN:
			error = read_reference(reader, grammar, scope);
			break;
		default:
			error = advance(reader);
			break;
		}
	}
	return error;
}

int xfile_read_top(struct xfile_reader *reader,
	const struct xfile_grammar *grammar, const struct xfile_scope *scope)
{
	int error = 0;

	while (!error && reader->token.kind != XFILE_END) {
		switch (reader->token.kind) {
		case XFILE_WORD:
			error = read_object(reader, grammar, scope);
			break;
		case XFILE_OPEN:
			error = read_reference(reader, grammar, scope);
			break;
		default:
			error = fail_expected(reader, "a data object");
			break;
		}
	}
	return error;
}
