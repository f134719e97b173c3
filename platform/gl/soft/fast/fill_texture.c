/*
 * Small opaque triangles with one RGB565 texture that repeats, set up as bands:
 * nearest texels under one share of all colours, or four mixed under three.
 * Larger ones are drawn by the span template.
 */
#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/fast/limits.h"
#include "platform/gl/soft/fast/tint.h"
#include "platform/gl/soft/raster/frame.h"
#include "platform/gl/soft/raster/pixel.h"

enum {
	/* So many sixteenths of a pixel, so that 1/256 of texels are enough. */
	BAND_EXTENT = 32 * 16,
	/* Half of 1/32, so that 255 is 32/32. */
	SHARE_ROUND = 4 << 8,
};

/* False where perspective would show, as with all that follow. */
static ALWAYS_INLINE bool find_color(const struct setup *setup,
	const struct frame *frame, int name, int32_t round, int32_t limit,
	struct run *out)
{
	int32_t first = setup->v[0]->attribute[name];
	int32_t d1 = setup->v[1]->attribute[name] - first;
	int32_t d2 = setup->v[2]->attribute[name] - first;

	*out = frame_find_run(frame, first + round, d1, d2);
	return is_color_within(d1, d2, limit);
}

/* In 16.16 of the base's texels. */
static ALWAYS_INLINE bool find_texels(const struct setup *setup,
	const struct frame *frame, int name, int log2, int32_t limit,
	struct run *out)
{
	int32_t first = setup->v[0]->attribute[name];
	int32_t d1 = (int32_t)((uint32_t)setup->v[1]->attribute[name] -
		(uint32_t)first);
	int32_t d2 = (int32_t)((uint32_t)setup->v[2]->attribute[name] -
		(uint32_t)first);

	first &= 0xFFFF;
	if (log2 <= 8) {
		first >>= 8 - log2;
		d1 >>= 8 - log2;
		d2 >>= 8 - log2;
	} else {
		first = shift_by(first, log2 - 8);
		d1 = shift_by(d1, log2 - 8);
		d2 = shift_by(d2, log2 - 8);
	}
	if (!is_within(d1, limit) || !is_within(d2, limit)) {
		return false;
	}
	*out = frame_find_run(frame, first, d1, d2);
	out->start += TEXEL_NUDGE;
	return true;
}

static ALWAYS_INLINE struct run find_depth(
	const struct setup *setup, const struct frame *frame)
{
	int32_t z = setup->v[0]->z;

	return frame_find_run(frame, z, setup->v[1]->z - z, setup->v[2]->z - z);
}

/* What a value is at column 0. */
static ALWAYS_INLINE uint32_t leave_column(
	const struct frame *frame, uint32_t start, uint32_t right)
{
	return start - right * (uint32_t)frame->column;
}

/* Whole 256ths of texels, which s and t have 8 bits more than. */
static ALWAYS_INLINE uint32_t pair_cut(int32_t s, int32_t t)
{
	return (((uint32_t)t << 8) & 0xFFFF0000) + (uint32_t)(s >> 8);
}

static ALWAYS_INLINE bool set_nearest(const struct draw *draw,
	const struct setup *setup, const struct frame *frame,
	struct texture_band *band)
{
	const struct texture_input *input = &draw->texture[0];
	const struct textured_level *level = &draw->textured.level[0];
	const struct limits limits = find_limits(draw, setup);
	struct run share, s, t, z;

	if (!find_color(setup, frame, RED, SHARE_ROUND, limits.color, &share) ||
		!find_texels(setup, frame, TEX_S, input->width_log2,
			limits.texel, &s) ||
		!find_texels(setup, frame, TEX_S + 1, input->height_log2,
			limits.texel, &t)) {
		return false;
	}
	z = find_depth(setup, frame);
	band->z_right = (uint32_t)z.right << 6;
	band->down.z_q16 = (uint32_t)z.down << 6;
	band->row.z_q16 =
		leave_column(frame, (uint32_t)z.start << 6, band->z_right);
	band->texel_right = pair_cut(s.right, t.right);
	band->down.texel = pair_cut(s.down, t.down);
	band->row.texel = leave_column(
		frame, pair_cut(s.start, t.start), band->texel_right);
	band->share_right = (uint32_t)share.right << 7;
	band->down.share_q26 = (uint32_t)share.down << 7;
	band->row.share_q26 = leave_column(
		frame, (uint32_t)share.start << 7, band->share_right);
	band->texels = level->texels;
	band->texel_mask = level->texel_mask;
	band->texel_shift = level->texel_shift;
	band->wide_mask = WIDE_MASK;
	band->wide_round = WIDE_ROUND;
	return true;
}

static void draw_gray(void *band)
{
	soft_band_texture(band);
}

/* The depth at column 0 of the first row. */
static ALWAYS_INLINE uintptr_t find_row(
	const struct draw *draw, const struct setup *setup)
{
	return draw->fast_setup.depth +
		(uintptr_t)setup->top * draw->fast_setup.stride_bytes;
}

static bool fill_gray(const struct draw *draw, const struct setup *setup)
{
	struct texture_band band;
	struct frame frame;

	if (!setup->inside || setup->extent > BAND_EXTENT ||
		!draw->textured.level[0].texels) {
		return false;
	}
	frame = frame_find(setup);
	if (!set_nearest(draw, setup, &frame, &band)) {
		return false;
	}
	band.row.depth = find_row(draw, setup);
	band.down.depth = draw->fast_setup.stride_bytes;
	band.pixels = draw->fast_setup.pixels;
	frame_draw_bands(draw, setup, &frame,
		&(struct band_ends){band.edge, band.edge_step, &band.rows},
		draw_gray, &band);
	return true;
}

/* The level whose texels are nearest in size to pixels; see choose_level(). */
static ALWAYS_INLINE int find_level(
	int last, const struct run *s, const struct run *t)
{
	uint32_t right =
		raster_length(raster_size(s->right), raster_size(t->right));
	uint32_t down =
		raster_length(raster_size(s->down), raster_size(t->down));
	int lod = (raster_log2_q8(right > down ? right : down) + 127) >> 8;

	return clamp_int(lod, 0, last);
}

/* The nearest 256ths of the level's texels. */
static ALWAYS_INLINE uint32_t pair_round(
	const struct textured_level *level, int32_t s, int32_t t)
{
	uint32_t low =
		(uint32_t)((s + (1 << (level->s_down - 1))) >> level->s_down);
	uint32_t high =
		(uint32_t)((t + (1 << (level->t_down - 1))) >> level->t_down);

	return (high << 16) + low;
}

/* 1.15 of a plane's colour. */
static ALWAYS_INLINE int32_t weight(int32_t color)
{
	return (color + 256) >> 9;
}

static ALWAYS_INLINE uint32_t pair_weights(int32_t red, int32_t blue)
{
	return ((uint32_t)weight(red) << 16) + (uint32_t)weight(blue);
}

static ALWAYS_INLINE bool set_tint(const struct setup *setup,
	const struct frame *frame, int32_t limit, struct tint_band *band)
{
	struct run r, g, b;

	if (!find_color(setup, frame, RED, 0, limit, &r) ||
		!find_color(setup, frame, GREEN, 0, limit, &g) ||
		!find_color(setup, frame, BLUE, 0, limit, &b)) {
		return false;
	}
	band->red_blue_right = pair_weights(r.right, b.right);
	band->down.red_blue = pair_weights(r.down, b.down);
	band->row.red_blue = leave_column(
		frame, pair_weights(r.start, b.start), band->red_blue_right);
	/* Steps that leave 16 bits are of rows of one pixel. */
	band->green_right = (uint32_t)(int16_t)weight(g.right) - 0x10000;
	band->down.green = (uint32_t)weight(g.down);
	band->row.green = leave_column(
		frame, (uint32_t)weight(g.start), band->green_right);
	return true;
}

static ALWAYS_INLINE bool set_level(const struct draw *draw,
	const struct setup *setup, const struct frame *frame, int32_t limit,
	struct tint_band *band)
{
	const struct texture_input *input = &draw->texture[0];
	const struct textured *textured = &draw->textured;
	const struct textured_level *level;
	struct run s, t;

	if (!find_texels(setup, frame, TEX_S, input->width_log2, limit, &s) ||
		!find_texels(setup, frame, TEX_S + 1, input->height_log2, limit,
			&t)) {
		return false;
	}
	level = textured->level;
	if (textured->last_level > 0) {
		level += find_level(textured->last_level, &s, &t);
	}
	band->texel_right = pair_round(level, s.right, t.right);
	band->down.texel = pair_round(level, s.down, t.down);
	band->row.texel = leave_column(frame,
		pair_round(level, s.start, t.start) - TINT_NEXT / 2,
		band->texel_right);
	band->texel_mask = level->texel_mask;
	band->texel_shift = level->texel_shift;
	band->texels = level->texels;
	band->stride_bytes = level->stride_bytes;
	return level->texels != NULL;
}

/*
 * Whether a triangle has so many pixels that the span template, which takes
 * longer to begin a triangle and a row, but less for a pixel, is faster.
 */
static ALWAYS_INLINE bool is_full(const struct setup *setup)
{
	uint32_t rows = (uint32_t)(setup->bottom - setup->top);

	return setup->area > (14 + rows) << 11;
}

static void draw_tinted(void *band)
{
	soft_band_tint(band);
}

static bool fill_tinted(const struct draw *draw, const struct setup *setup)
{
	struct limits limits;
	struct frame frame;
	struct tint_band band;
	struct run z;

	if (!setup->inside || setup->extent > BAND_EXTENT || is_full(setup)) {
		return false;
	}
	limits = find_limits(draw, setup);
	frame = frame_find(setup);
	if (!set_tint(setup, &frame, limits.color, &band) ||
		!set_level(draw, setup, &frame, limits.texel, &band)) {
		return false;
	}
	z = find_depth(setup, &frame);
	band.z_right = (uint32_t)z.right << 6;
	band.down.z_q16 = (uint32_t)z.down << 6;
	band.row.z_q16 =
		leave_column(&frame, (uint32_t)z.start << 6, band.z_right);
	band.row.depth = find_row(draw, setup);
	band.down.depth = draw->fast_setup.stride_bytes;
	band.pixels = draw->fast_setup.pixels;
	frame_draw_bands(draw, setup, &frame,
		&(struct band_ends){band.edge, band.edge_step, &band.rows},
		draw_tinted, &band);
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

/* Nearest texels under three colours are left to the span template. */
void soft_fill_textured(struct draw *draw, struct setup *setup)
{
	bool linear = draw->texture[0].texture->mag_filter == GL_LINEAR;

	if (!soft_is_hidden(draw, setup) &&
		!(linear ? fill_tinted(draw, setup)
			 : is_gray(setup) && fill_gray(draw, setup))) {
		soft_rows_fill(draw, setup);
	}
}

static void set_levels(
	const struct texture_input *input, struct textured_level *out)
{
	for (int i = 0; i < input->levels; i++) {
		const struct level *level = &input->texture->level[i];
		int width = level->width_log2, height = level->height_log2;
		bool fits = width <= 8 && height <= 8;

		out[i] = (struct textured_level){
			.texel_mask = ((1u << height) - 1) << 24 |
				((1u << width) - 1) << 8,
			.texel_shift = (uint32_t)(24 - width),
			.texels = fits ? level->texels : NULL,
			.stride_bytes = 2u << width,
			.s_down = input->width_log2 - width + 8,
			.t_down = input->height_log2 - height + 8,
		};
	}
}

void soft_fill_textured_begin(struct draw *draw)
{
	const struct texture_input *input = &draw->texture[0];
	bool linear = input->texture->mag_filter == GL_LINEAR;

	draw->textured.last_level = linear ? input->levels - 1 : 0;
	set_levels(input, draw->textured.level);
}
