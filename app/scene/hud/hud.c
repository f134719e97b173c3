#include "app/scene/hud/hud.h"

#include "app/scene/draw/texture.h"
#include "app/scene/draw/triangle_list.h"
#include "platform/base/fixed.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

enum {
	EMS_PER_HEIGHT = 40, /* ems of text in the picture's height */
	MIDDLE_EMS = 4,      /* of text around a middle that is left out */
	/*
	 * the picture's edge as a vertex coordinate: half of a short's range,
	 * as text may lie beyond the edge
	 */
	CLIP = 16384,
	ELLIPSIS = 0x2026
};

const struct hud_color hud_color_text = {244, 247, 250, 255};
const struct hud_color hud_color_dim = {190, 201, 214, 255};
const struct hud_color hud_color_panel = {16, 21, 29, 184};
const struct hud_color hud_color_blue = {92, 172, 255, 255};
const struct hud_color hud_color_green = {104, 211, 145, 255};
const struct hud_color hud_color_amber = {250, 190, 88, 255};
const struct hud_color hud_color_rose = {248, 128, 140, 255};
const struct hud_color hud_color_violet = {178, 148, 255, 255};

static const struct hud_color bar_track = {255, 255, 255, 44};

static void set_filter(const struct gl *gl, GLint filter)
{
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
}

static int fail(const struct log *log)
{
	log_error(log,
		"there is not enough memory for the texture of the labels' font");
	return -ENOMEM;
}

int hud_init(struct hud *hud, const struct gl *gl, const struct log *log)
{
	const struct font *font = &font_default;
	uint16_t *next = hud->index;

	*hud = (struct hud){.font = font};
	for (uint32_t i = 0; i < HUD_QUADS_MAX; i++) {
		uint32_t first = i * 4;

		next = triangle_list_add(next, first, first + 1, first + 2);
		next = triangle_list_add(next, first + 2, first + 1, first + 3);
	}
	hud_begin(hud, 1, 1);
	gl->GenTextures(1, &hud->texture);
	if (!hud->texture) {
		return fail(log);
	}
	gl->BindTexture(GL_TEXTURE_2D, hud->texture);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	set_filter(gl, GL_NEAREST);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
	gl->TexImage2D(GL_TEXTURE_2D, 0, GL_ALPHA, font->width, font->height, 0,
		GL_ALPHA, GL_UNSIGNED_BYTE, font->alpha);
	if (!texture_memory_ok(gl)) {
		hud_finish(hud, gl);
		return fail(log);
	}
	return 0;
}

void hud_finish(struct hud *hud, const struct gl *gl)
{
	if (hud->texture) {
		gl->DeleteTextures(1, &hud->texture);
		hud->texture = 0;
	}
}

/* Takes the largest face that fits, and enlarges it if all are too small. */
const struct font_face *hud_face_for(
	const struct font *font, int height, int *scale)
{
	const struct font_face *largest = &font->face[font->face_count - 1];
	const struct font_face *chosen = &font->face[0];
	int wanted = height / EMS_PER_HEIGHT;

	*scale = wanted / largest->size;
	*scale = *scale < 1 ? 1 : *scale;
	for (int i = 1; i < font->face_count; i++) {
		if (font->face[i].size <= wanted) {
			chosen = &font->face[i];
		}
	}
	return chosen;
}

void hud_begin(struct hud *hud, int width, int height)
{
	hud->width = width < 1 ? 1 : width;
	hud->height = height < 1 ? 1 : height;
	hud->quad_count = 0;
	memset(hud->stacked_px, 0, sizeof(hud->stacked_px));
	hud->face = hud_face_for(hud->font, hud->height, &hud->scale);
}

int hud_em(const struct hud *hud)
{
	return hud->face->size * hud->scale;
}

int hud_line_height(const struct hud *hud)
{
	return hud->face->line_height * hud->scale;
}

/* Clamps a coordinate to 16 bits; such a vertex is outside the picture. */
static int16_t to_short(int value)
{
	return (int16_t)(value < -INT16_MAX ? -INT16_MAX
			: value > INT16_MAX ? INT16_MAX
					    : value);
}

static void add_vertex(struct hud *hud, int corner, int x, int y, int s, int t,
	struct hud_color color)
{
	hud->vertex[hud->quad_count * 4 + corner] =
		(struct hud_vertex){.x = to_short(x),
			.y = to_short(y),
			.s = (float)s,
			.t = (float)t,
			.color = color};
}

/* Maps the texels from s, t on onto w x h pixels at x, y. */
static void add_quad(struct hud *hud, int x, int y, int w, int h, int s, int t,
	int texels_w, int texels_h, struct hud_color color)
{
	if (hud->quad_count == HUD_QUADS_MAX || w <= 0 || h <= 0) {
		return;
	}
	add_vertex(hud, 0, x, y, s, t, color);
	add_vertex(hud, 1, x, y + h, s, t + texels_h, color);
	add_vertex(hud, 2, x + w, y, s + texels_w, t, color);
	add_vertex(hud, 3, x + w, y + h, s + texels_w, t + texels_h, color);
	hud->quad_count++;
}

static const struct font_glyph *glyph_of(const struct hud *hud, uint32_t code)
{
	return &hud->face->glyph[font_find_glyph(hud->font, code)];
}

static int advance_of(const struct hud *hud, uint32_t code)
{
	return glyph_of(hud, code)->advance * hud->scale;
}

int hud_text_width(const struct hud *hud, const char *text)
{
	uint32_t code;
	int width = 0;

	while ((code = font_next_code(&text)) != 0) {
		width += advance_of(hud, code);
	}
	return width;
}

static int add_glyph(struct hud *hud, int x, int baseline, uint32_t code,
	struct hud_color color)
{
	const struct font_glyph *glyph = glyph_of(hud, code);
	int scale = hud->scale;

	add_quad(hud, x + glyph->left * scale, baseline - glyph->top * scale,
		glyph->width * scale, glyph->height * scale, glyph->s, glyph->t,
		glyph->width, glyph->height, color);
	return x + glyph->advance * scale;
}

static int baseline_of(const struct hud *hud, int y)
{
	return y + hud->face->ascent * hud->scale;
}

int hud_text(
	struct hud *hud, int x, int y, struct hud_color color, const char *text)
{
	uint32_t code;

	while ((code = font_next_code(&text)) != 0) {
		x = add_glyph(hud, x, baseline_of(hud, y), code, color);
	}
	return x;
}

/*
 * Adds the longest beginning of a text that is at most this wide, without the
 * blanks at its end, and an ellipsis.
 */
static int add_beginning(struct hud *hud, int x, int y, int width,
	struct hud_color color, const char *text)
{
	int end = x + width, inked = x;
	uint32_t code;

	while ((code = font_next_code(&text)) != 0 &&
		x + advance_of(hud, code) <= end) {
		x = add_glyph(hud, x, baseline_of(hud, y), code, color);
		inked = code == ' ' ? inked : x;
	}
	return add_glyph(hud, inked, baseline_of(hud, y), ELLIPSIS, color);
}

int hud_text_cut(struct hud *hud, int x, int y, int width,
	struct hud_color color, const char *text)
{
	int room = width - advance_of(hud, ELLIPSIS);

	if (hud_text_width(hud, text) <= width) {
		return hud_text(hud, x, y, color, text);
	}
	return room < 0 ? x : add_beginning(hud, x, y, room, color, text);
}

/* Returns the longest end of a text that is at most this wide. */
static const char *find_end(const struct hud *hud, const char *text, int width)
{
	int left = hud_text_width(hud, text);

	while (left > width) {
		left -= advance_of(hud, font_next_code(&text));
	}
	return text;
}

/*
 * Returns what of a text stays behind an ellipsis: the second of two words, as
 * of a part and what moves in it, or half of a single word. NULL: cut the end.
 */
static const char *find_kept(const struct hud *hud, const char *text, int room)
{
	const char *blank = strchr(text, ' ');

	if (room < MIDDLE_EMS * hud_em(hud)) {
		return NULL;
	}
	if (!blank) {
		return find_end(hud, text, room / 2);
	}
	return !strchr(blank + 1, ' ') &&
			3 * hud_text_width(hud, blank) <= 2 * room
		? blank
		: NULL;
}

int hud_text_shorten(struct hud *hud, int x, int y, int width,
	struct hud_color color, const char *text)
{
	int room = width - advance_of(hud, ELLIPSIS);
	const char *end = hud_text_width(hud, text) > width
		? find_kept(hud, text, room)
		: NULL;

	if (!end) {
		return hud_text_cut(hud, x, y, width, color, text);
	}
	x = add_beginning(
		hud, x, y, room - hud_text_width(hud, end), color, text);
	return hud_text(hud, x, y, color, end);
}

void hud_rectangle(
	struct hud *hud, int x, int y, int w, int h, struct hud_color color)
{
	add_quad(hud, x, y, w, h, hud->font->solid_s, hud->font->solid_t, 0, 0,
		color);
}

/* Adds one quarter of a disc with its top left corner at x, y. */
static void add_quarter(struct hud *hud, int x, int y, int radius, int right,
	int bottom, struct hud_color color)
{
	int texels = radius / hud->scale;
	const uint16_t *disc = hud->font->disc[texels];

	add_quad(hud, x, y, radius, radius, disc[0] + right * texels,
		disc[1] + bottom * texels, texels, texels, color);
}

static int min_int(int a, int b)
{
	return a < b ? a : b;
}

void hud_panel(struct hud *hud, int x, int y, int w, int h, int radius,
	struct hud_color color)
{
	/* The atlas has discs of whole texels up to the largest radius. */
	int texels = min_int(min_int(radius, min_int(w, h) / 2) / hud->scale,
		FONT_DISC_RADIUS_MAX);
	int r = texels > 0 ? texels * hud->scale : 0;

	if (r > 0) {
		add_quarter(hud, x, y, r, 0, 0, color);
		add_quarter(hud, x + w - r, y, r, 1, 0, color);
		add_quarter(hud, x, y + h - r, r, 0, 1, color);
		add_quarter(hud, x + w - r, y + h - r, r, 1, 1, color);
	}
	hud_rectangle(hud, x + r, y, w - 2 * r, r, color);
	hud_rectangle(hud, x, y + r, w, h - 2 * r, color);
	hud_rectangle(hud, x + r, y + h - r, w - 2 * r, r, color);
}

void hud_bar(struct hud *hud, int x, int y, int w, int h, float fraction,
	struct hud_color color)
{
	float clamped = scalar_clamp(fraction, 0.0f, 1.0f);
	int filled = (int)((float)w * clamped + 0.5f);

	hud_panel(hud, x, y, w, h, h / 2, bar_track);
	if (clamped > 0.0f) {
		/* The filled part holds at least two round ends. */
		filled = filled < h ? min_int(h, w) : filled;
		hud_panel(hud, x, y, filled, h, h / 2, color);
	}
}

void hud_move(struct hud *hud, int first_quad, int x, int y)
{
	for (int i = first_quad * 4; i < hud->quad_count * 4; i++) {
		struct hud_vertex *vertex = &hud->vertex[i];

		vertex->x = to_short(vertex->x + x);
		vertex->y = to_short(vertex->y + y);
	}
}

/*
 * Converts 0..size pixels to -CLIP..CLIP. A matrix for pixels would contain
 * 2 / size, which in 16.16 is wrong by half a pixel across a large picture;
 * 1 / CLIP is exact, and a step is at most a quarter of a pixel.
 */
static int16_t to_clip(int pixel, int32_t scale_q16, int size)
{
	int64_t clip_q16 = (int64_t)(2 * pixel - size) * scale_q16;

	return to_short((int)((clip_q16 + 32768) >> 16));
}

static void convert_vertices(struct hud *hud)
{
	int32_t x_q16 = (CLIP << 16) / hud->width;
	int32_t y_q16 = (CLIP << 16) / hud->height;
	/* Exact, as the atlas' sides are powers of two. */
	float width = 1.0f / (float)hud->font->width;
	float height = 1.0f / (float)hud->font->height;

	for (int i = 0; i < hud->quad_count * 4; i++) {
		struct hud_vertex *vertex = &hud->vertex[i];

		vertex->x = to_clip(vertex->x, x_q16, hud->width);
		vertex->y = to_clip(vertex->y, y_q16, hud->height);
		vertex->s *= width;
		vertex->t *= height;
	}
}

static void set_matrices(const struct gl *gl)
{
	gl->MatrixMode(GL_TEXTURE);
	gl->LoadIdentity();
	gl->MatrixMode(GL_PROJECTION);
	gl->LoadIdentity();
	gl->MatrixMode(GL_MODELVIEW);
	gl->LoadIdentity();
	gl->Scalex(FX16_ONE / CLIP, -FX16_ONE / CLIP, FX16_ONE);
}

static void set_state(const struct gl *gl, const struct hud *hud)
{
	gl->Disable(GL_LIGHTING);
	gl->Disable(GL_CULL_FACE);
	gl->Disable(GL_ALPHA_TEST);
	gl->Disable(GL_DEPTH_TEST);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	gl->Enable(GL_TEXTURE_2D);
	gl->BindTexture(GL_TEXTURE_2D, hud->texture);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
	/* At scale 1 each texel lies on one pixel. */
	set_filter(gl, hud->scale > 1 ? GL_LINEAR : GL_NEAREST);
}

static void set_arrays(const struct gl *gl, const struct hud_vertex *vertex)
{
	const int stride = sizeof(*vertex);

	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->DisableClientState(GL_NORMAL_ARRAY);
	gl->VertexPointer(3, GL_SHORT, stride, &vertex->x);
	gl->TexCoordPointer(2, GL_FLOAT, stride, &vertex->s);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, stride, &vertex->color);
}

void hud_end(struct hud *hud, const struct gl *gl)
{
	convert_vertices(hud);
	set_state(gl, hud);
	set_matrices(gl);
	set_arrays(gl, hud->vertex);
	if (hud->quad_count > 0) {
		gl->DrawElements(GL_TRIANGLES, hud->quad_count * 6,
			GL_UNSIGNED_SHORT, hud->index);
	}
	hud->quad_count = 0;
	gl->LoadIdentity();
	gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->Disable(GL_TEXTURE_2D);
	gl->Disable(GL_BLEND);
	gl->Enable(GL_DEPTH_TEST);
}
