/*
 * Bakes a font file into C source for app/scene/hud/font.h: a texture atlas with
 * the glyphs in several sizes, a solid patch and discs, and the glyphs' metrics.
 *
 *	bake FONT SIZE... >font_data.c
 *
 * It runs on the build machine; the result is the same for every target.
 */
#include "app/scene/hud/font.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <ft2build.h>
#include FT_FREETYPE_H

enum {
	FACES_MAX = 4,
	SIZE_MAX_PX = 64,
	ATLAS_WIDTH = 256,
	ATLAS_HEIGHT_MAX = 512,
	GAP = 1, /* keeps a neighbour out of a filtered edge */
	SOLID_SIDE = 4,
	GRID = 16, /* samples along a texel's side, for discs */
};

/* Characters beyond ASCII and Latin-1, ascending. */
static const uint16_t signs[] = {
	0x2013, /* en dash */
	0x2014, /* em dash */
	0x2022, /* bullet */
	0x2026, /* ellipsis */
	0x2190, /* arrows: left, up, right, down */
	0x2191,
	0x2192,
	0x2193,
	0x21B5, /* arrow of the enter key */
	0x2212, /* minus */
	0x25B2, /* triangles: up, right, down, left */
	0x25B6,
	0x25BC,
	0x25C0,
};

enum {
	ASCII_FIRST = 0x20,
	ASCII_COUNT = 0x7F - ASCII_FIRST,
	LATIN_FIRST = 0xA1, /* Latin-1: accents, umlauts, degree, times */
	LATIN_COUNT = 0x100 - LATIN_FIRST,
	PLAIN_COUNT = ASCII_COUNT + LATIN_COUNT,
	SIGN_COUNT = sizeof(signs) / sizeof(signs[0]),
	GLYPH_COUNT = 1 + PLAIN_COUNT + SIGN_COUNT,
	PIECES_MAX = FACES_MAX * GLYPH_COUNT + FONT_DISC_RADIUS_MAX + 1,
};

/* A picture to be placed in the atlas, at (s, t). */
struct piece {
	int width, height;
	uint8_t *alpha;
	int s, t;
};

struct baked_glyph {
	struct piece piece;
	int left, top, advance;
};

struct baked_face {
	int size, ascent, line_height, cap_height;
	struct baked_glyph glyph[GLYPH_COUNT];
};

struct bake {
	FT_Face font;
	int face_count;
	struct baked_face face[FACES_MAX];
	struct piece disc[FONT_DISC_RADIUS_MAX + 1];
	struct piece solid;
	int height;
	uint8_t atlas[ATLAS_HEIGHT_MAX][ATLAS_WIDTH];
};

static void fail(const char *what, const char *why)
{
	fprintf(stderr, "bake: %s: %s\n", what, why);
	exit(1);
}

static uint8_t *alloc_alpha(int width, int height)
{
	uint8_t *alpha = calloc((size_t)width * (size_t)height + 1, 1);

	if (!alpha) {
		fail("atlas", "not enough memory");
	}
	return alpha;
}

static int code_at(int glyph)
{
	return glyph == FONT_UNKNOWN   ? 0
		: glyph <= ASCII_COUNT ? ASCII_FIRST + glyph - 1
		: glyph <= PLAIN_COUNT ? LATIN_FIRST + glyph - 1 - ASCII_COUNT
				       : signs[glyph - 1 - PLAIN_COUNT];
}

static int pixels_from_26_6(FT_Pos value)
{
	return (int)((value + 32) >> 6);
}

static void load_glyph(struct bake *bake, int code, struct baked_glyph *out)
{
	FT_UInt index = FT_Get_Char_Index(bake->font, (FT_ULong)code);
	FT_GlyphSlot slot = bake->font->glyph;
	char name[16];

	snprintf(name, sizeof(name), "U+%04X", (unsigned)code);
	if (index == 0) {
		fail(name,
			"the font lacks this character; remove it from the list of signs");
	}
	if (FT_Load_Glyph(bake->font, index,
		    FT_LOAD_TARGET_LIGHT | FT_LOAD_RENDER) != 0) {
		fail(name, "FreeType cannot draw this character");
	}
	out->piece.width = (int)slot->bitmap.width;
	out->piece.height = (int)slot->bitmap.rows;
	out->piece.alpha = alloc_alpha(out->piece.width, out->piece.height);
	for (int row = 0; row < out->piece.height; row++) {
		memcpy(out->piece.alpha + row * out->piece.width,
			slot->bitmap.buffer + row * slot->bitmap.pitch,
			(size_t)out->piece.width);
	}
	out->left = slot->bitmap_left;
	out->top = slot->bitmap_top;
	out->advance = pixels_from_26_6(slot->advance.x);
}

/* The glyph of an unknown character: a rectangle as large as a capital. */
static void make_box(const struct baked_face *face, struct baked_glyph *out)
{
	int width = face->cap_height * 3 / 4, height = face->cap_height;
	int line = 1 + face->size / 20;

	out->piece.width = width;
	out->piece.height = height;
	out->piece.alpha = alloc_alpha(width, height);
	for (int i = 0; i < width * height; i++) {
		int x = i % width, y = i / width;
		bool inside = x >= line && x < width - line && y >= line &&
			y < height - line;

		out->piece.alpha[i] = inside ? 0 : 255;
	}
	out->left = 1;
	out->top = height;
	out->advance = width + 2;
}

static struct baked_glyph *glyph_of(struct baked_face *face, int code)
{
	return &face->glyph[1 + code - ASCII_FIRST];
}

/* Makes all digits as wide as the widest, so that changing numbers do not move. */
static void align_digits(struct baked_face *face)
{
	int widest = 0;

	for (int digit = '0'; digit <= '9'; digit++) {
		int advance = glyph_of(face, digit)->advance;

		widest = advance > widest ? advance : widest;
	}
	for (int digit = '0'; digit <= '9'; digit++) {
		struct baked_glyph *glyph = glyph_of(face, digit);

		glyph->left += (widest - glyph->advance) / 2;
		glyph->advance = widest;
	}
}

static void load_face(struct bake *bake, int size)
{
	struct baked_face *face = &bake->face[bake->face_count++];
	const FT_Size_Metrics *metrics;

	if (FT_Set_Pixel_Sizes(bake->font, 0, (FT_UInt)size) != 0) {
		fail("size", "FreeType cannot scale the font to this size");
	}
	metrics = &bake->font->size->metrics;
	face->size = size;
	face->ascent = pixels_from_26_6(metrics->ascender);
	face->line_height = face->ascent + pixels_from_26_6(-metrics->descender);
	for (int i = 1; i < GLYPH_COUNT; i++) {
		load_glyph(bake, code_at(i), &face->glyph[i]);
	}
	face->cap_height = glyph_of(face, 'H')->top;
	make_box(face, &face->glyph[FONT_UNKNOWN]);
	align_digits(face);
}

/* The fraction of a texel's samples within the circle, 0..255. */
static int disc_coverage(int x, int y, int radius)
{
	int inside = 0;

	for (int i = 0; i < GRID * GRID; i++) {
		/* In half samples from the centre, which are integers. */
		int dx = 2 * GRID * (x - radius) + 2 * (i % GRID) + 1;
		int dy = 2 * GRID * (y - radius) + 2 * (i / GRID) + 1;

		inside += dx * dx + dy * dy <= 4 * GRID * GRID * radius * radius;
	}
	return (inside * 255 + GRID * GRID / 2) / (GRID * GRID);
}

static void make_disc(struct piece *disc, int radius)
{
	int side = 2 * radius;

	disc->width = disc->height = side;
	disc->alpha = alloc_alpha(side, side);
	for (int i = 0; i < side * side; i++) {
		disc->alpha[i] =
			(uint8_t)disc_coverage(i % side, i / side, radius);
	}
}

static void make_solid(struct piece *solid)
{
	solid->width = solid->height = SOLID_SIDE;
	solid->alpha = alloc_alpha(SOLID_SIDE, SOLID_SIDE);
	memset(solid->alpha, 255, SOLID_SIDE * SOLID_SIDE);
}

/* Orders pieces by height, then by width, so that shelves waste little. */
static int compare_pieces(const void *a, const void *b)
{
	const struct piece *one = *(struct piece *const *)a;
	const struct piece *other = *(struct piece *const *)b;

	if (one->height != other->height) {
		return other->height - one->height;
	}
	return other->width - one->width;
}

static void copy_into_atlas(struct bake *bake, const struct piece *piece)
{
	for (int row = 0; row < piece->height; row++) {
		memcpy(&bake->atlas[piece->t + row][piece->s],
			piece->alpha + row * piece->width, (size_t)piece->width);
	}
}

/* Places the pieces on shelves, each as high as its first piece. */
static void pack(struct bake *bake, struct piece **piece, int count)
{
	int s = GAP, t = GAP, shelf_height = 0;

	qsort(piece, (size_t)count, sizeof(*piece), compare_pieces);
	for (int i = 0; i < count; i++) {
		if (s + piece[i]->width + GAP > ATLAS_WIDTH) {
			s = GAP;
			t += shelf_height + GAP;
			shelf_height = 0;
		}
		shelf_height = shelf_height ? shelf_height : piece[i]->height;
		if (t + piece[i]->height + GAP > ATLAS_HEIGHT_MAX) {
			fail("atlas", "the glyphs of these sizes do not fit");
		}
		piece[i]->s = s;
		piece[i]->t = t;
		s += piece[i]->width + GAP;
		copy_into_atlas(bake, piece[i]);
	}
	for (bake->height = 1; bake->height < t + shelf_height + GAP;) {
		bake->height *= 2;
	}
}

static void fill_atlas(struct bake *bake)
{
	struct piece *piece[PIECES_MAX];
	int count = 0;

	for (int i = 0; i < bake->face_count; i++) {
		for (int k = 0; k < GLYPH_COUNT; k++) {
			piece[count++] = &bake->face[i].glyph[k].piece;
		}
	}
	for (int radius = 1; radius <= FONT_DISC_RADIUS_MAX; radius++) {
		make_disc(&bake->disc[radius], radius);
		piece[count++] = &bake->disc[radius];
	}
	make_solid(&bake->solid);
	piece[count++] = &bake->solid;
	pack(bake, piece, count);
	for (int i = 0; i < count; i++) {
		free(piece[i]->alpha);
	}
}

static void write_atlas(const struct bake *bake)
{
	printf("static const uint8_t alpha[%d] = {", bake->height * ATLAS_WIDTH);
	for (int i = 0; i < bake->height * ATLAS_WIDTH; i++) {
		printf("%s%d,", i % 32 ? "" : "\n",
			bake->atlas[i / ATLAS_WIDTH][i % ATLAS_WIDTH]);
	}
	printf("\n};\n\n");
}

static void write_codes(void)
{
	printf("static const uint16_t code[%d] = {", GLYPH_COUNT);
	for (int i = 0; i < GLYPH_COUNT; i++) {
		printf("%s0x%04X,", i % 10 ? " " : "\n\t", (unsigned)code_at(i));
	}
	printf("\n};\n\n");
}

static void write_glyphs(const struct baked_face *face)
{
	printf("static const struct font_glyph glyph_%d[%d] = {\n", face->size,
		GLYPH_COUNT);
	for (int i = 0; i < GLYPH_COUNT; i++) {
		const struct baked_glyph *glyph = &face->glyph[i];

		printf("\t{%d, %d, %d, %d, %d, %d, %d},\n", glyph->piece.s,
			glyph->piece.t, glyph->piece.width, glyph->piece.height,
			glyph->left, glyph->top, glyph->advance);
	}
	printf("};\n\n");
}

static void write_faces(const struct bake *bake)
{
	for (int i = 0; i < bake->face_count; i++) {
		write_glyphs(&bake->face[i]);
	}
	printf("static const struct font_face face[%d] = {\n", bake->face_count);
	for (int i = 0; i < bake->face_count; i++) {
		const struct baked_face *face = &bake->face[i];

		printf("\t{%d, %d, %d, %d, glyph_%d},\n", face->size,
			face->ascent, face->line_height, face->cap_height,
			face->size);
	}
	printf("};\n\n");
}

static void write_font(const struct bake *bake)
{
	printf("const struct font font_default = {\n");
	printf("\t.name = \"%s %s\",\n", bake->font->family_name,
		bake->font->style_name);
	printf("\t.width = %d,\n\t.height = %d,\n\t.alpha = alpha,\n",
		ATLAS_WIDTH, bake->height);
	printf("\t.glyph_count = %d,\n\t.code = code,\n", GLYPH_COUNT);
	printf("\t.face_count = %d,\n\t.face = face,\n", bake->face_count);
	printf("\t.solid_s = %d,\n\t.solid_t = %d,\n",
		bake->solid.s + SOLID_SIDE / 2, bake->solid.t + SOLID_SIDE / 2);
	printf("\t.disc = {{0, 0}");
	for (int radius = 1; radius <= FONT_DISC_RADIUS_MAX; radius++) {
		printf(", {%d, %d}", bake->disc[radius].s, bake->disc[radius].t);
	}
	printf("},\n};\n");
}

static void write_c(const struct bake *bake)
{
	printf("/* Made by toolchain/font/bake.c from %s %s. */\n",
		bake->font->family_name, bake->font->style_name);
	printf("#include \"app/scene/hud/font.h\"\n\n");
	write_atlas(bake);
	write_codes();
	write_faces(bake);
	write_font(bake);
	if (fflush(stdout) != 0 || ferror(stdout)) {
		fail("standard output", "the font cannot be written to it");
	}
}

int main(int argc, char **argv)
{
	struct bake bake = {0};
	FT_Library library;

	if (argc < 3 || argc > 2 + FACES_MAX) {
		fprintf(stderr, "usage: bake FONT SIZE... (up to %d sizes)\n",
			FACES_MAX);
		return 2;
	}
	if (FT_Init_FreeType(&library) != 0 ||
		FT_New_Face(library, argv[1], 0, &bake.font) != 0) {
		fail(argv[1], "FreeType cannot read this file as a font");
	}
	for (int i = 2; i < argc; i++) {
		int size = atoi(argv[i]);

		if (size < 6 || size > SIZE_MAX_PX ||
			(i > 2 && size <= bake.face[i - 3].size)) {
			fail(argv[i],
				"a size must be 6 to 64 pixels and larger than the one before");
		}
		load_face(&bake, size);
	}
	fill_atlas(&bake);
	write_c(&bake);
	FT_Done_Face(bake.font);
	FT_Done_FreeType(library);
	return 0;
}
