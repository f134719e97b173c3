/*
 * Changes a glTF file as JSON: a number becomes a limit or another number of
 * the file, a string becomes another string, a member or element is repeated,
 * moved or left out. Most mutations of bytes would only break the syntax. The
 * binary part of a .glb is left to libFuzzer.
 */
#include "tests/fuzz/gltf_mutator.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t max_size);

/* A part of the text. */
struct span {
	size_t begin, end;
};

static uint32_t next_random(uint32_t *state)
{
	*state = *state * 1664525u + 1013904223u;
	return *state >> 8;
}

static size_t pick(uint32_t *state, size_t count)
{
	return count ? next_random(state) % count : 0;
}

static bool in_number(uint8_t c)
{
	return (c >= '0' && c <= '9') || c == '-' || c == '+' || c == '.' ||
		c == 'e' || c == 'E';
}

static bool begins_value(uint8_t c)
{
	return (c >= '0' && c <= '9') || c == '-' || c == '"' || c == '[' ||
		c == '{';
}

static size_t end_of_string(const uint8_t *text, size_t size, size_t at)
{
	for (at++; at < size && text[at] != '"'; at++) {
		at += text[at] == '\\';
	}
	return at < size ? at + 1 : size;
}

/* The end of the value that begins at a position. */
static size_t end_of_value(const uint8_t *text, size_t size, size_t at)
{
	int depth = 0;

	if (in_number(text[at])) {
		while (at < size && in_number(text[at])) {
			at++;
		}
		return at;
	}
	while (at < size) {
		uint8_t c = text[at];

		if (c == '"') {
			at = end_of_string(text, size, at);
		} else {
			depth += c == '[' || c == '{';
			depth -= c == ']' || c == '}';
			at++;
		}
		if (depth <= 0) {
			break;
		}
	}
	return at;
}

/* The first value at or after a random position, of a kind if that is not 0. */
static struct span find_value(
	const uint8_t *text, size_t size, uint32_t *state, uint8_t kind)
{
	size_t from = pick(state, size);

	for (size_t i = 0; i < size; i++) {
		size_t at = (from + i) % size;
		uint8_t c = text[at];
		bool number = in_number(c) && c != 'e' && c != 'E' && c != '.';

		if (kind == '0' ? number && (at == 0 || !in_number(text[at - 1]))
				: (kind ? c == kind : begins_value(c))) {
			return (struct span){at, end_of_value(text, size, at)};
		}
	}
	return (struct span){0, 0};
}

/* Replaces a part of the text. Returns the new size. */
static size_t replace(uint8_t *text, size_t size, size_t max_size,
	struct span at, const void *by, size_t by_size)
{
	if (at.end < at.begin || at.end > size ||
		size - (at.end - at.begin) + by_size > max_size) {
		return size;
	}
	memmove(text + at.begin + by_size, text + at.end, size - at.end);
	memcpy(text + at.begin, by, by_size);
	return size - (at.end - at.begin) + by_size;
}

static size_t change_number(
	uint8_t *text, size_t size, size_t max_size, uint32_t *state)
{
	static const char *const limits[] = {"0", "1", "2", "3", "-1", "4",
		"127", "255", "256", "5120", "5121", "5123", "5125", "5126",
		"65535", "65536", "2147483647", "2147483648", "4294967295",
		"1e9", "-1e9", "1e-30", "3.4e38", "0.5", "1e400", "33071",
		"33648", "9729", "9987", "34962", "34963"};
	struct span at = find_value(text, size, state, '0');
	char other[32];
	struct span from;
	const char *by = limits[pick(state, sizeof(limits) / sizeof(*limits))];

	if (at.end == at.begin) {
		return size;
	}
	if (pick(state, 3) == 0) {
		from = find_value(text, size, state, '0');
		snprintf(other, sizeof(other), "%.*s",
			(int)(from.end - from.begin),
			(const char *)text + from.begin);
		by = other;
	}
	return replace(text, size, max_size, at, by, strlen(by));
}

/* Puts a copy of one value in the place of, or in front of, another. */
static size_t copy_value(uint8_t *text, size_t size, size_t max_size,
	uint32_t *state, uint8_t kind, bool insert)
{
	uint8_t copy[4096];
	struct span from = find_value(text, size, state, kind);
	struct span at = find_value(text, size, state, kind);
	size_t length = from.end - from.begin;

	if (length == 0 || length >= sizeof(copy)) {
		return size;
	}
	memcpy(copy, text + from.begin, length);
	if (insert) {
		at.end = at.begin;
		copy[length++] = ',';
	}
	return replace(text, size, max_size, at, copy, length);
}

static size_t leave_out(
	uint8_t *text, size_t size, size_t max_size, uint32_t *state)
{
	struct span at = find_value(text, size, state, 0);

	if (at.end < size && text[at.end] == ',') {
		at.end++;
	}
	return replace(text, size, max_size, at, "", 0);
}

static size_t mutate_text(
	uint8_t *text, size_t size, size_t max_size, uint32_t *state)
{
	static const uint8_t kinds[] = {'0', '"', '[', '{'};

	switch (pick(state, 6)) {
	case 0:
	case 1:
	case 2:
		return change_number(text, size, max_size, state);
	case 3:
		return copy_value(text, size, max_size, state,
			kinds[pick(state, sizeof(kinds))], false);
	case 4:
		return copy_value(text, size, max_size, state,
			kinds[pick(state, sizeof(kinds))], true);
	default:
		return leave_out(text, size, max_size, state);
	}
}

static uint32_t read_u32(const uint8_t *at)
{
	return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 |
		(uint32_t)at[3] << 24;
}

static void write_u32(uint8_t *at, size_t value)
{
	for (int i = 0; i < 4; i++) {
		at[i] = (uint8_t)(value >> 8 * i);
	}
}

/* A .glb's JSON is mutated in place; blanks keep the length of its chunk. */
static size_t mutate_glb(uint8_t *data, size_t size, uint32_t *state)
{
	size_t room = size >= 20 ? read_u32(data + 12) : 0;
	size_t length;

	if (room == 0 || room > size - 20) {
		return 0;
	}
	length = room;
	while (length > 0 && data[20 + length - 1] == ' ') {
		length--;
	}
	length = mutate_text(data + 20, length, room, state);
	memset(data + 20 + length, ' ', room - length);
	write_u32(data + 8, size);
	return size;
}

size_t LLVMFuzzerCustomMutator(
	uint8_t *data, size_t size, size_t max_size, unsigned int seed)
{
	uint32_t state = seed;
	size_t result = 0;

	for (size_t times = 1 + pick(&state, 4); times > 0; times--) {
		if (pick(&state, 4) == 0 || size < 8) {
			result = LLVMFuzzerMutate(data, size, max_size);
		} else if (memcmp(data, "glTF", 4) == 0) {
			result = mutate_glb(data, size, &state);
		} else {
			result = mutate_text(data, size, max_size, &state);
		}
		size = result ? result : size;
	}
	return size;
}
