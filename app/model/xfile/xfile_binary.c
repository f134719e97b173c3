#include "app/model/little_endian.h"
#include "app/model/xfile/xfile_reader.h"

#include <string.h>

/* Tokens of the binary encoding: two bytes, least significant first. */
enum {
	TOKEN_NAME = 1,
	TOKEN_STRING = 2,
	TOKEN_INTEGER = 3,
	TOKEN_GUID = 5,
	TOKEN_INTEGER_LIST = 6,
	TOKEN_FLOAT_LIST = 7,
	TOKEN_OPEN_BRACE = 10,
	TOKEN_CLOSE_BRACE = 11,
	TOKEN_OPEN_PAREN = 12,
	TOKEN_DOT = 18,
	TOKEN_COMMA = 19,
	TOKEN_SEMICOLON = 20,
	TOKEN_TEMPLATE = 31,
	TOKEN_WORD = 40,
	TOKEN_ARRAY = 52,
};

static uint64_t get_u64(const uint8_t *at)
{
	return little_endian_u32(at) | (uint64_t)little_endian_u32(at + 4) << 32;
}

static double get_float(const uint8_t *at, int bytes)
{
	uint32_t bits_32 = little_endian_u32(at);
	uint64_t bits_64;
	double value_64;
	float value_32;

	if (bytes == 4) {
		memcpy(&value_32, &bits_32, sizeof(value_32));
		return (double)value_32;
	}
	bits_64 = get_u64(at);
	memcpy(&value_64, &bits_64, sizeof(value_64));
	return value_64;
}

static int fail_short(
	struct xfile_reader *reader, const struct xfile_token *token)
{
	return xfile_fail_at(&reader->context, token->location,
		"the file ends within this token");
}

/* Reads a length and checks that so many elements of `bytes` bytes follow. */
static int take_length(struct xfile_reader *reader,
	const struct xfile_token *token, size_t bytes, uint32_t *length)
{
	if (reader->end - reader->at < 4) {
		return fail_short(reader, token);
	}
	*length = little_endian_u32(reader->at);
	reader->at += 4;
	if (*length > (size_t)(reader->end - reader->at) / bytes) {
		return fail_short(reader, token);
	}
	return 0;
}

static int scan_text(struct xfile_reader *reader, struct xfile_token *token)
{
	uint32_t length;
	int error = take_length(reader, token, 1, &length);

	if (error) {
		return error;
	}
	token->text = (const char *)reader->at;
	token->length = length;
	reader->at += length;
	return 0;
}

/*
 * A string ends with a separator token of two bytes, or of four in some files.
 * Two zero bytes are no token, so a separator with two zero bytes behind it is
 * the longer form.
 */
static void skip_terminator(struct xfile_reader *reader)
{
	if (reader->end - reader->at >= 4) {
		uint32_t word = little_endian_u32(reader->at);

		if (word == TOKEN_COMMA || word == TOKEN_SEMICOLON) {
			reader->at += 4;
		}
	}
}

static void scan_element(struct xfile_reader *reader, struct xfile_token *token)
{
	int bytes = reader->list_float ? reader->float_bytes : 4;

	token->kind = XFILE_NUMBER;
	token->number = reader->list_float
		? get_float(reader->at, bytes)
		: (double)little_endian_u32(reader->at);
	reader->at += bytes;
	reader->list_left--;
}

static int scan_list(
	struct xfile_reader *reader, struct xfile_token *token, bool is_float)
{
	int bytes = is_float ? reader->float_bytes : 4;

	reader->list_float = is_float;
	return take_length(reader, token, (size_t)bytes, &reader->list_left);
}

static int scan_integer(struct xfile_reader *reader, struct xfile_token *token)
{
	if (reader->end - reader->at < 4) {
		return fail_short(reader, token);
	}
	token->kind = XFILE_NUMBER;
	token->number = little_endian_u32(reader->at);
	reader->at += 4;
	return 0;
}

static int scan_guid(struct xfile_reader *reader, struct xfile_token *token)
{
	if (reader->end - reader->at < 16) {
		return fail_short(reader, token);
	}
	token->kind = XFILE_GUID;
	reader->at += 16;
	return 0;
}

static int scan_standalone(
	struct xfile_reader *reader, struct xfile_token *token, uint32_t code)
{
	static const char template[] = "template";

	if (code == TOKEN_OPEN_BRACE) {
		token->kind = XFILE_OPEN;
	} else if (code == TOKEN_CLOSE_BRACE) {
		token->kind = XFILE_CLOSE;
	} else if (code == TOKEN_TEMPLATE) {
		token->kind = XFILE_WORD;
		token->text = template;
		token->length = sizeof(template) - 1;
	} else if ((code >= TOKEN_OPEN_PAREN && code <= TOKEN_DOT) ||
		(code >= TOKEN_WORD && code <= TOKEN_ARRAY)) {
		token->kind = XFILE_OTHER;
	} else {
		return xfile_fail_at(&reader->context, token->location,
			"%u is not a token of the binary format",
			(unsigned)code);
	}
	return 0;
}

/*
 * Scans the rest of a token with this code. Sets *again if the code yields no
 * token: a separator, or the beginning of a list.
 */
static int scan_coded(struct xfile_reader *reader, struct xfile_token *token,
	uint32_t code, bool *again)
{
	int error;

	switch (code) {
	case TOKEN_COMMA:
	case TOKEN_SEMICOLON:
		*again = true;
		return 0;
	case TOKEN_NAME:
		token->kind = XFILE_WORD;
		return scan_text(reader, token);
	case TOKEN_STRING:
		token->kind = XFILE_STRING;
		error = scan_text(reader, token);
		if (!error) {
			skip_terminator(reader);
		}
		return error;
	case TOKEN_INTEGER:
		return scan_integer(reader, token);
	case TOKEN_GUID:
		return scan_guid(reader, token);
	case TOKEN_INTEGER_LIST:
	case TOKEN_FLOAT_LIST:
		*again = true;
		return scan_list(reader, token, code == TOKEN_FLOAT_LIST);
	default:
		return scan_standalone(reader, token, code);
	}
}

int xfile_scan_binary(struct xfile_reader *reader, struct xfile_token *token)
{
	bool again = true;
	int error = 0;

	while (again && !error) {
		again = false;
		*token = (struct xfile_token){.location = XFILE_HEADER_BYTES +
				(size_t)(reader->at - reader->body)};
		if (reader->list_left) {
			scan_element(reader, token);
		} else if (reader->at == reader->end) {
			token->kind = XFILE_END;
		} else if (reader->end - reader->at < 2) {
			error = fail_short(reader, token);
		} else {
			uint32_t code = little_endian_u16(reader->at);

			reader->at += 2;
			error = scan_coded(reader, token, code, &again);
		}
	}
	return error;
}
