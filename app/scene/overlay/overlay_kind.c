#include "app/scene/overlay/overlay_kind.h"

#include <string.h>

static const char *const names[OVERLAY_KINDS] = {
	[OVERLAY_SKELETON] = "skeleton",
	[OVERLAY_WEIGHTS] = "weights",
	[OVERLAY_WIREFRAME] = "wireframe",
	[OVERLAY_KEYS] = "keys",
	[OVERLAY_PIVOTS] = "pivots",
	[OVERLAY_CURVE] = "curve",
	[OVERLAY_LAYERS] = "layers",
};

const char *overlay_kind_name(enum overlay_kind kind)
{
	return names[kind];
}

static bool is_word(const char *text, size_t length, const char *word)
{
	return strlen(word) == length && memcmp(text, word, length) == 0;
}

/* Cuts ":NAME" off a word and keeps the name. */
static bool take_joint(
	const char *text, size_t *length, struct overlay_choice *out)
{
	const char *colon = memchr(text, ':', *length);
	size_t before, after;

	if (!colon) {
		return true;
	}
	before = (size_t)(colon - text);
	after = *length - before - 1;
	if (!is_word(text, before, names[OVERLAY_WEIGHTS]) || after == 0 ||
		after >= sizeof(out->joint)) {
		return false;
	}
	memcpy(out->joint, colon + 1, after);
	out->joint[after] = '\0';
	*length = before;
	return true;
}

static bool parse_word(
	const char *text, size_t length, struct overlay_choice *out)
{
	if (!take_joint(text, &length, out)) {
		return false;
	}
	for (int kind = 0; kind < OVERLAY_KINDS; kind++) {
		if (is_word(text, length, names[kind])) {
			out->kinds |= 1U << kind;
			return true;
		}
	}
	return false;
}

bool overlay_choice_parse(const char *text, struct overlay_choice *out)
{
	struct overlay_choice choice = {0};

	if (strcmp(text, "all") == 0) {
		choice.kinds = (1U << OVERLAY_KINDS) - 1;
	} else if (strcmp(text, "none") != 0) {
		size_t length;

		do {
			length = strcspn(text, ",");
			if (!parse_word(text, length, &choice)) {
				return false;
			}
			text += length;
		} while (*text++ == ',');
	}
	*out = choice;
	return true;
}
