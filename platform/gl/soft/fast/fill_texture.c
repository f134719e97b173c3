/*
 * Small opaque triangles with one RGB565 texture, set up as bands: nearest
 * texels times a gray, or bilinear ones times a colour. Span functions draw
 * larger triangles, and those at the edges of levels that are clamped or larger
 * than 256 texels.
 */
#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/raster/frame.h"
#include "platform/gl/soft/raster/pixel.h"

enum {
	/* largest size in 1/16 pixels for which 1/256 texels are exact enough */
	BAND_EXTENT = 32 * 16,
	/* half of 1/32, so that 255 becomes 32/32 */
	SHARE_ROUND = 4 << 8,
	/* half a texel, and the sum of rounding errors in a band */
	TEXEL_SPARE = 128 + 80,
};

/* A small triangle whose band is being set up. */
struct small {
	const struct setup *setup;
	struct frame frame;
	const struct level *level;
	/* shifts from 16.16 base texels to 8 fraction bits of the level */
	int s_down, t_down;
};

/* A colour's plane; this and find_texels()'s start in frame.column. */
static ALWAYS_INLINE struct plane find_color(
	const struct small *small, int name, int32_t round)
{
	const struct vertex *const *v = small->setup->v;
	int32_t first = v[0]->attribute[name];

	return frame_find_near(&small->frame, first + round,
		v[1]->attribute[name] - first, v[2]->attribute[name] - first);
}

/* A texture coordinate's plane, in 16.16 base texels. */
static ALWAYS_INLINE struct plane find_texels(
	const struct small *small, const struct delta *delta)
{
	struct plane out = frame_find_near(
		&small->frame, delta->first, delta->d1, delta->d2);

	out.start += TEXEL_NUDGE;
	return out;
}

/* Moves a plane's start from frame.column to column 0. */
static ALWAYS_INLINE uint32_t leave_column(
	const struct small *small, uint32_t start, uint32_t right)
{
	return start - right * (uint32_t)small->frame.column;
}

/* Sets up a gray, as factors of 6.26, of 32. */
static ALWAYS_INLINE void set_gray(const struct small *small, struct band *band)
{
	const struct plane share = find_color(small, RED, SHARE_ROUND);

	band->red_blue_right = (uint32_t)share.dx << 7;
	band->down.red_blue = (uint32_t)share.dy << 7;
	band->row.red_blue =
		leave_column(small, share.start << 7, band->red_blue_right);
	band->row.green = band->down.green = band->green_right = 0;
	band->more.green = WIDE_ROUND;
}

/* Converts a plane's colour, 8.16, to 1.15, rounded. */
static ALWAYS_INLINE int32_t weight(int32_t color)
{
	return (color + 256) >> 9;
}

static ALWAYS_INLINE uint32_t pair_weights(int32_t red, int32_t blue)
{
	return ((uint32_t)weight(red) << 16) + (uint32_t)weight(blue);
}

static ALWAYS_INLINE void set_tint(
	const struct draw *draw, const struct small *small, struct band *band)
{
	const int32_t *far = draw->spans.stages.far;
	const struct plane r = find_color(small, RED, 0);
	const struct plane g = find_color(small, GREEN, 0);
	const struct plane b = find_color(small, BLUE, 0);

	band->red_blue_right = pair_weights(r.dx, b.dx);
	band->down.red_blue = pair_weights(r.dy, b.dy);
	band->row.red_blue = leave_column(small,
		pair_weights((int32_t)r.start, (int32_t)b.start),
		band->red_blue_right);
	/* Steps that do not fit 16 bits occur only in rows of one pixel. */
	band->green_right = (uint32_t)(int16_t)weight(g.dx) - 0x10000;
	band->down.green = (uint32_t)weight(g.dy);
	band->row.green = leave_column(
		small, (uint32_t)weight((int32_t)g.start), band->green_right);
	band->more =
		(struct band_more){.green = (1 << 16) - ((uint32_t)far[1] << 3),
			.red = (1 << 16) - ((uint32_t)far[0] << 3),
			.blue = (1 << 16) - ((uint32_t)far[2] << 3)};
}

/* The level whose texels are nearest in size to pixels, as soft_set_level(). */
static ALWAYS_INLINE int find_level(
	int last, const struct plane *s, const struct plane *t)
{
	int lod = raster_find_lod(s->dx, t->dx, s->dy, t->dy);

	return clamp_int((lod + 127) >> 8, 0, last);
}

/* s and t in 1/256 of the level's texels, in a word; rounded if nearest. */
static ALWAYS_INLINE uint32_t pair_texels(
	const struct small *small, int32_t s, int32_t t, bool nearest)
{
	int32_t s_round = nearest ? 1 << (small->s_down - 1) : 0;
	int32_t t_round = nearest ? 1 << (small->t_down - 1) : 0;

	return ((uint32_t)((t + t_round) >> small->t_down) << 16) +
		(uint32_t)((s + s_round) >> small->s_down);
}

/* The mask of whole texels in coordinates of so many bits. */
static ALWAYS_INLINE uint32_t find_mask(int s_bits, int t_bits)
{
	return ((1u << t_bits) - 1) << 24 | ((1u << s_bits) - 1) << 8;
}

static ALWAYS_INLINE void set_texels(const struct small *small,
	const struct plane *s, const struct plane *t, bool linear,
	struct band *band)
{
	const struct level *level = small->level;
	const int width = level->width_log2;

	band->texel_right = pair_texels(small, s->dx, t->dx, linear);
	band->down.texel = pair_texels(small, s->dy, t->dy, linear);
	band->row.texel = leave_column(small,
		pair_texels(small, (int32_t)s->start, (int32_t)t->start, linear) -
			(linear ? TINT_NEXT / 2 : 0),
		band->texel_right);
	band->texel_mask = find_mask(width, level->height_log2);
	band->texel_shift = (uint32_t)(24 - width);
	band->texels = level->texels;
	band->stride_bytes = linear ? 2u << width : WIDE_MASK;
}

/*
 * If the level is clamped or larger than 256 texels, lets the band begin at the
 * first texel that the triangle needs. False unless the band reaches all others
 * from there, without the level's last one.
 */
static NEVER_INLINE bool move_texels(
	const struct draw *draw, const struct small *small, struct band *band)
{
	const struct texture_input *input = &draw->texture[0];
	const struct texture *texture = input->texture;
	const int base[2] = {input->width_log2, input->height_log2};
	const int log2[2] = {
		small->level->width_log2, small->level->height_log2};
	const int bits[2] = {log2[0] < 16 - log2[0] ? log2[0] : 16 - log2[0],
		log2[1] < 8 ? log2[1] : 8};
	int32_t first[2] = {0, 0};

	for (int i = 0; i < 2; i++) {
		const bool repeats =
			(i ? texture->wrap_t : texture->wrap_s) == GL_REPEAT;
		const struct frame_texels texels = frame_find_texels(
			small->setup, TEX_S + i, base[i], repeats);
		const int down = base[i] - log2[i];
		const int32_t low = (texels.low >> down) - TEXEL_SPARE;
		const int32_t last = ((texels.high >> down) + TEXEL_SPARE) >> 8;

		if (repeats && log2[i] <= 8) {
			continue;
		}
		first[i] = low >> 8;
		if (low < 0 || last >= (1 << log2[i]) - 1 ||
			last - first[i] >= (1 << bits[i]) - 1) {
			return false;
		}
	}
	band->texel_mask = find_mask(bits[0], bits[1]);
	band->row.texel -=
		((uint32_t)first[1] << 24) + ((uint32_t)first[0] << 8);
	band->texels +=
		((uint32_t)first[1] << (log2[0] + 1)) + 2 * (uint32_t)first[0];
	return true;
}

static ALWAYS_INLINE bool is_whole(
	const struct texture *texture, const struct level *level)
{
	return texture->wrap_s == GL_REPEAT && texture->wrap_t == GL_REPEAT &&
		level->width_log2 <= 8 && level->height_log2 <= 8;
}

/* Whether texels differ too much, or perspective correction is needed. */
static ALWAYS_INLINE bool bends(const struct draw *draw,
	const struct setup *setup, const struct delta *s, const struct delta *t)
{
	const uint32_t extent = (uint32_t)setup->extent << 4;
	uint32_t in_s = frame_find_spread(s->d1, s->d2);
	uint32_t in_t = frame_find_spread(t->d1, t->d2);
	uint32_t most = in_s > in_t ? in_s : in_t;
	struct perspective perspective;

	if (most >= SMALL_DELTA || !draw->perspective) {
		return most >= SMALL_DELTA;
	}
	perspective = raster_find_perspective(setup);
	/* with mipmaps, a texel of the chosen level is about a pixel wide */
	if (most > extent && draw->texture[0].levels > 1) {
		most = extent;
	}
	/* Colours differ by < 2^16: linear enough if w differs by up to 1/16 */
	return raster_bends(&perspective, most, 0) ||
		(perspective.w_spread > perspective.w_least >> 4 &&
			soft_colors_bend(draw, setup));
}

static ALWAYS_INLINE void set_rows(
	const struct draw *draw, const struct small *small, struct band *band)
{
	const struct vertex *const *v = small->setup->v;
	const int32_t first = v[0]->z;
	const struct delta delta = {first, v[1]->z - first, v[2]->z - first};
	const struct plane z = frame_find_plane(&small->frame, &delta);

	band->z_right = (uint32_t)z.dx << 6;
	band->down.z_q16 = (uint32_t)z.dy << 6;
	band->row.z_q16 = z.start << 6;
	band->row.depth = draw->fast_setup.depth +
		(uintptr_t)small->setup->top * draw->fast_setup.stride_bytes;
	band->down.depth = draw->fast_setup.stride_bytes;
	band->pixels = draw->fast_setup.pixels;
}

static ALWAYS_INLINE bool fill(
	const struct draw *draw, const struct setup *setup, bool linear)
{
	const struct texture_input *input = &draw->texture[0];
	struct delta s, t;
	struct plane s_plane, t_plane;
	struct small small;
	struct band band;

	if (!setup->inside || setup->extent > BAND_EXTENT) {
		return false;
	}
	small.setup = setup;
	frame_find(setup, &small.frame);
	if (linear) {
		set_tint(draw, &small, &band);
	} else {
		set_gray(&small, &band);
	}
	s = frame_find_texels(setup, TEX_S, input->width_log2, true).delta;
	t = frame_find_texels(setup, TEX_S + 1, input->height_log2, true).delta;
	if (bends(draw, setup, &s, &t)) {
		return false;
	}
	s_plane = find_texels(&small, &s);
	t_plane = find_texels(&small, &t);
	small.level = input->base;
	if (linear && input->levels > 1) {
		small.level += find_level(input->levels - 1, &s_plane, &t_plane);
	}
	small.s_down = input->width_log2 - small.level->width_log2 + 8;
	small.t_down = input->height_log2 - small.level->height_log2 + 8;
	set_texels(&small, &s_plane, &t_plane, linear, &band);
	if (!is_whole(input->texture, small.level) &&
		!move_texels(draw, &small, &band)) {
		return false;
	}
	set_rows(draw, &small, &band);
	frame_draw_bands(draw, setup, true, small.frame.middle_left,
		&band.edges, draw->fill_band, &band);
	return true;
}

static bool is_gray(const struct setup *setup)
{
	const int32_t *a = setup->v[0]->attribute + RED;
	const int32_t *b = setup->v[1]->attribute + RED;
	const int32_t *c = setup->v[2]->attribute + RED;

	return ((a[0] ^ a[1]) | (a[0] ^ a[2]) | (b[0] ^ b[1]) | (b[0] ^ b[2]) |
		       (c[0] ^ c[1]) | (c[0] ^ c[2])) == 0;
}

/* Span functions draw nearest texels times a colour that is no gray. */
void soft_fill_textured(struct draw *draw, struct setup *setup)
{
	bool linear = draw->texture[0].texture->mag_filter == GL_LINEAR;

	if (!soft_is_hidden(draw, setup) &&
		!(linear ? fill(draw, setup, true)
			 : is_gray(setup) && fill(draw, setup, false))) {
		soft_raster_set_up(draw, setup);
		soft_walk_rows(draw, setup);
	}
}
