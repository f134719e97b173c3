#include "tests/support/hud_read.h"

#include "tests/support/test.h"

#include <limits.h>
#include <string.h>

void hud_read_begin(struct hud *hud, int width, int height)
{
	memset(hud, 0, sizeof(*hud));
	hud->font = &font_default;
	hud_begin(hud, width, height);
}

/* The letter whose picture a quad shows, or -1. */
static int find_letter(const struct hud *hud, const struct hud_vertex *corner)
{
	for (int i = 0; i < hud->font->glyph_count; i++) {
		const struct font_glyph *glyph = &hud->face->glyph[i];

		if (glyph->width > 0 && corner->s == (float)glyph->s &&
			corner->t == (float)glyph->t) {
			return i;
		}
	}
	return -1;
}

/* Writes a character of less than 12 bits as UTF-8, and returns its length. */
static size_t write_letter(char *out, uint16_t code)
{
	if (code < 0x80) {
		out[0] = (char)code;
		return 1;
	}
	out[0] = (char)(0xc0 | code >> 6);
	out[1] = (char)(0x80 | (code & 0x3f));
	return 2;
}

void hud_read_text(const struct hud *hud, char *out, size_t size)
{
	int em = hud_em(hud), row = INT_MIN, pen = 0;
	size_t length = 0;

	for (int i = 0; i < hud->quad_count; i++) {
		const struct hud_vertex *corner = &hud->vertex[4 * i];
		int letter = find_letter(hud, corner), baseline;
		const struct font_glyph *glyph;

		if (letter < 0) {
			continue;
		}
		glyph = &hud->face->glyph[letter];
		baseline = corner->y + glyph->top * hud->scale;
		assert_true(length + 3 < size);
		if (row != INT_MIN && baseline != row) {
			out[length++] = '\n';
		} else if (row != INT_MIN &&
			(corner->x > pen + em || corner->x < pen - em)) {
			out[length++] = '|';
		} else if (row != INT_MIN && corner->x > pen + em / 6) {
			out[length++] = ' ';
		}
		length += write_letter(out + length, hud->font->code[letter]);
		row = baseline;
		pen = corner->x - glyph->left * hud->scale +
			glyph->advance * hud->scale;
	}
	out[length] = '\0';
}

int hud_read_width(const struct hud *hud, struct hud_color color)
{
	int low = INT_MAX, high = INT_MIN;

	for (int i = 0; i < 4 * hud->quad_count; i++) {
		const struct hud_vertex *corner = &hud->vertex[i];

		if (memcmp(&corner->color, &color, sizeof(color)) == 0) {
			low = corner->x < low ? corner->x : low;
			high = corner->x > high ? corner->x : high;
		}
	}
	return high > low ? high - low : 0;
}
