#include "app/model/xfile/xfile_reader.h"

#include <string.h>

static bool is_space(uint8_t byte)
{
	return byte <= ' ' || byte == ';' || byte == ',';
}

static bool ends_word(const uint8_t *at, const uint8_t *end)
{
	return is_space(*at) || strchr("{}<>[]()\"", *at) ||
		(*at == '/' && end - at > 1 && at[1] == '/');
}

static void skip_line(struct xfile_reader *reader)
{
	while (reader->at < reader->end && *reader->at != '\n') {
		reader->at++;
	}
}

static void skip_space(struct xfile_reader *reader)
{
	while (reader->at < reader->end) {
		const uint8_t *at = reader->at;

		if (*at == '#' ||
			(*at == '/' && reader->end - at > 1 && at[1] == '/')) {
			skip_line(reader);
		} else if (is_space(*at)) {
			reader->line += *at == '\n';
			reader->at++;
		} else {
			return;
		}
	}
}

/* Reads up to the closing character; reader->at is behind the opening one. */
static int scan_enclosed(
	struct xfile_reader *reader, struct xfile_token *token, uint8_t close)
{
	const uint8_t *at = reader->at;

	while (at < reader->end && *at != close) {
		reader->line += *at == '\n';
		at++;
	}
	if (at == reader->end) {
		return xfile_fail_at(&reader->context, token->location,
			"the file ends before the closing %c", close);
	}
	token->text = (const char *)reader->at;
	token->length = (size_t)(at - reader->at);
	reader->at = at + 1;
	return 0;
}

static double power_of_ten(int exponent)
{
	double power = 1;
	double base = 10;

	for (; exponent; exponent >>= 1) {
		if (exponent & 1) {
			power *= base;
		}
		base *= base;
	}
	return power;
}

/*
 * Returns mantissa * 10^exponent, to within a few units in the last place. The
 * mantissa is exact, since take_digits() puts only 18 digits into it.
 */
static double scale_by_ten(uint64_t mantissa, int exponent)
{
	if (!mantissa || exponent < -400) {
		return 0;
	}
	if (exponent > 400) {
		exponent = 400;
	}
	if (exponent < -300) {
		return (double)mantissa / 1e300 / power_of_ten(-300 - exponent);
	}
	return exponent < 0 ? (double)mantissa / power_of_ten(-exponent)
			    : (double)mantissa * power_of_ten(exponent);
}

struct digits {
	const char *at;
	const char *end;
	uint64_t mantissa;
	int count;   /* digits in the mantissa, without leading zeros */
	int dropped; /* further digits before the point */
	int behind;  /* digits behind the point in the mantissa */
	bool any;
};

static void take_digits(struct digits *digits, bool fraction)
{
	enum {
		MAX_SHIFT = 1000000 /* keeps sums of exponents in an int */
	};

	for (; digits->at < digits->end && *digits->at >= '0' &&
		*digits->at <= '9';
		digits->at++) {
		digits->any = true;
		if (digits->count < 18) {
			digits->mantissa = digits->mantissa * 10 +
				(uint64_t)(*digits->at - '0');
			digits->count += digits->mantissa != 0;
			digits->behind += fraction && digits->behind < MAX_SHIFT;
		} else if (!fraction && digits->dropped < MAX_SHIFT) {
			digits->dropped++;
		}
	}
}

static bool take_exponent(struct digits *digits, int *exponent)
{
	bool negative = false;
	bool any = false;

	*exponent = 0;
	if (digits->at == digits->end) {
		return true;
	}
	if (*digits->at != 'e' && *digits->at != 'E') {
		return false;
	}
	digits->at++;
	if (digits->at < digits->end &&
		(*digits->at == '-' || *digits->at == '+')) {
		negative = *digits->at == '-';
		digits->at++;
	}
	for (; digits->at < digits->end && *digits->at >= '0' &&
		*digits->at <= '9';
		digits->at++) {
		any = true;
		if (*exponent < 100000) {
			*exponent = *exponent * 10 + (*digits->at - '0');
		}
	}
	*exponent = negative ? -*exponent : *exponent;
	return any && digits->at == digits->end;
}

/*
 * Parses a decimal number with an optional sign, fraction and exponent,
 * whatever the locale. Returns false unless the number fills the text. NaN and
 * infinity as Microsoft's C library prints them (1.#IND, 1.#INF) become 0.
 */
static bool parse_number(const char *text, size_t length, double *out)
{
	struct digits digits = {.at = text, .end = text + length};
	bool negative = length && *text == '-';
	int exponent;

	if (length && (*text == '-' || *text == '+')) {
		digits.at++;
	}
	take_digits(&digits, false);
	if (digits.at < digits.end && *digits.at == '.') {
		digits.at++;
		if (digits.any && digits.at < digits.end && *digits.at == '#') {
			*out = 0;
			return true;
		}
		take_digits(&digits, true);
	}
	if (!digits.any || !take_exponent(&digits, &exponent)) {
		return false;
	}
	*out = scale_by_ten(
		digits.mantissa, exponent + digits.dropped - digits.behind);
	if (negative) {
		*out = -*out;
	}
	return true;
}

static void scan_word(struct xfile_reader *reader, struct xfile_token *token)
{
	const uint8_t *at = reader->at;

	while (at < reader->end && !ends_word(at, reader->end)) {
		at++;
	}
	token->text = (const char *)reader->at;
	token->length = (size_t)(at - reader->at);
	token->kind = parse_number(token->text, token->length, &token->number)
		? XFILE_NUMBER
		: XFILE_WORD;
	reader->at = at;
}

int xfile_scan_text(struct xfile_reader *reader, struct xfile_token *token)
{
	skip_space(reader);
	*token = (struct xfile_token){.location = reader->line};
	if (reader->at == reader->end) {
		return 0;
	}
	switch (*reader->at) {
	case '{':
		token->kind = XFILE_OPEN;
		break;
	case '}':
		token->kind = XFILE_CLOSE;
		break;
	case '"':
		reader->at++;
		token->kind = XFILE_STRING;
		return scan_enclosed(reader, token, '"');
	case '<':
		reader->at++;
		token->kind = XFILE_GUID;
		return scan_enclosed(reader, token, '>');
	case '>':
	case '[':
	case ']':
	case '(':
	case ')':
		token->kind = XFILE_OTHER;
		break;
	default:
		scan_word(reader, token);
		return 0;
	}
	reader->at++;
	return 0;
}
