#include "platform/gl/soft/fast/luminance.h"

#include "platform/gl/soft/fast/tile_row.h"
#include "platform/gl/soft/fast/tiles.h"
#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/spans.h"

enum {
	/* Half of 1/32, so that 255 is 32/32. */
	SHARE_ROUND = 4 << 16,
	SHARE_STEP = 1 << 19,
	/* Shares may move on by more than a step every so many pixels. */
	SHARE_PIXELS = 8,
};

/* Pixels of a row whose values run linearly; texels are the base's, 16.16. */
struct piece {
	int x, count;
	uint32_t s, t, alpha; /* of the first */
	int32_t s_right, t_right, alpha_right;
};

static uint32_t size_of(int32_t value)
{
	return value < 0 ? 0u - (uint32_t)value : (uint32_t)value;
}

/*
 * A level plane is as deep all along a row, but for what rounding left: then one value
 * does.
 */
static void write_depth(const struct draw *draw, const struct piece *piece)
{
	const struct fragment_state *state = &draw->soft->fragment;
	const struct buffers *buffers = &draw->soft->buffers;
	size_t row = (size_t)draw->raster.span.y * (size_t)buffers->width;
	uint16_t *depth = buffers->depth + row + piece->x;
	int32_t right = draw->raster.plane[DEPTH].dx;
	uint32_t z;

	if (!state->depth_test || !state->depth_mask) {
		return;
	}
	z = plane_at(&draw->raster, DEPTH, piece->x);
	if ((uint64_t)size_of(right) * (uint32_t)piece->count < 1 << 10) {
		z += (uint32_t)(right * piece->count / 2);
		soft_fill_pixels(depth, piece->count, (uint16_t)(z >> 10));
		return;
	}
	for (int i = 0; i < piece->count; i++) {
		depth[i] = (uint16_t)(z >> 10);
		z += (uint32_t)right;
	}
}

static const struct level *choose_level(const struct draw *draw, int *number)
{
	const struct texture_input *input = &draw->texture[0];
	int side = input->width_log2 < input->height_log2 ? input->width_log2
							  : input->height_log2;
	/* Down to two texels: less has no quads. */
	int most = input->levels - 1 < side - 1 ? input->levels - 1 : side - 1;

	*number = clamp_int((draw->raster.span.lod[0] + 127) >> 8, 0, most);
	while (!input->texture->level[*number].tiles) {
		--*number;
	}
	return &input->texture->level[*number];
}

static void shade(
	const struct draw *draw, const struct piece *piece, uint16_t *pixel)
{
	int number;
	const struct level *level = choose_level(draw, &number);
	int32_t s_right = piece->s_right >> number;
	int32_t t_right = piece->t_right >> number;
	const struct tile_run run = {
		.pixel = pixel,
		.count = piece->count,
		.quads = level->tiles->quad,
		.s = (uint32_t)((int32_t)piece->s >> number) - 0x8000,
		.t = (uint32_t)((int32_t)piece->t >> number) - 0x8000,
		.s_right = s_right,
		.t_right = t_right,
		.shade = draw->shade,
		.s_end = &level->tiles->patch->s[s_right >= 0],
		.t_end = &level->tiles->patch->t[t_right >= 0],
		.s_pixels = soft_tile_pixels(s_right, level->width_log2),
		.t_pixels = soft_tile_pixels(t_right, level->height_log2),
		.width_log2 = level->width_log2,
		.height_log2 = level->height_log2,
		.fine = level->tiles->fine,
	};
	/* The base may be seen from so near that its places show. */
	bool fine = number > 0 && run.fine;

	if (tile_is_square(&run)) {
		(fine ? soft_tile_fine : soft_tile_row)(&run);
	} else {
		(fine ? soft_tile_fine_c : soft_tile_row_c)(&run);
	}
}

/* So many that one share is less than a step off for each, or as will do. */
static int share_pixels(int32_t alpha_right)
{
	uint32_t step = size_of(alpha_right);
	int count = SHARE_PIXELS;

	while (count > 1 && step * (uint32_t)count >= 2 * SHARE_STEP) {
		count /= 2;
	}
	return count;
}

/* With one share for as many pixels as will do. */
void soft_luminance_blend(uint16_t *pixel, const uint16_t *shaded, int all,
	uint32_t alpha, int32_t alpha_right)
{
	int most = share_pixels(alpha_right), count;

	for (int i = 0; i < all; i += count) {
		uint32_t middle;

		count = all - i;
		if ((uint64_t)size_of(alpha_right) * (uint32_t)count >=
				SHARE_STEP &&
			count > most) {
			count = most;
		}
		middle = alpha + (uint32_t)(alpha_right * (i + count / 2));
		soft_mix_pixels(pixel + i, shaded + i, count,
			(middle + SHARE_ROUND) >> 19);
	}
}

static void draw_piece(struct draw *draw, const struct piece *piece)
{
	uint16_t *pixel = (uint16_t *)(void *)pixel_at(
		&draw->soft->buffers.target, piece->x, draw->raster.span.y);

	write_depth(draw, piece);
	if (draw->blended) {
		/* Words lie in one as they do in the other. */
		uint16_t *shaded =
			draw->shaded + ((uintptr_t)pixel / sizeof(*pixel)) % 2;

		shade(draw, piece, shaded);
		soft_luminance_blend(pixel, shaded, piece->count, piece->alpha,
			piece->alpha_right);
	} else {
		shade(draw, piece, pixel);
	}
}

/* n^2 of the slope of q is below q. */
int soft_luminance_find_length(const struct draw *draw, const struct point *from)
{
	const struct raster *raster = &draw->raster;
	uint32_t slope, n = LUMINANCE_RUN;

	if (!raster->perspective) {
		return LUMINANCE_RUN;
	}
	slope = size_of(raster->plane[INVERSE_W].dx);
	while (n > PERSPECTIVE_STEP &&
		(uint64_t)slope * n * n > (uint32_t)from->q) {
		n /= 2;
	}
	return (int)n;
}

/*
 * A plane that is equally far all along a row: q moves by less than 2^-16 of it,
 * and so do coordinates, of thousands of texels, by less than their fraction.
 */
static bool is_level(
	const struct draw *draw, const struct point *from, int count)
{
	const struct raster *raster = &draw->raster;

	return !raster->perspective ||
		((uint64_t)size_of(raster->plane[INVERSE_W].dx) * (uint32_t)count
			<< 16) < (uint32_t)from->q;
}

/* How much an attribute changes from pixel to pixel of such a row. */
static int32_t level_step(
	const struct draw *draw, const struct point *from, int name)
{
	const struct raster *raster = &draw->raster;
	int32_t dx = raster->plane[name].dx;

	if (!raster->perspective) {
		return dx;
	}
	return rows_divide(from, dx,
		name >= TEX_S ? raster->tex_shift[name - TEX_S] + 8 : 24);
}

static void set_start(struct piece *piece, const struct point *from)
{
	piece->s = (uint32_t)from->value[TEX_S];
	piece->t = (uint32_t)from->value[TEX_S + 1];
	piece->alpha = (uint32_t)from->value[ALPHA];
}

static void level_row(struct draw *draw, const struct point *from, int left,
	int right, bool fading)
{
	struct piece piece = {
		.x = left,
		.s_right = level_step(draw, from, TEX_S),
		.t_right = level_step(draw, from, TEX_S + 1),
		.alpha_right = fading ? level_step(draw, from, ALPHA) : 0,
	};

	set_start(&piece, from);
	for (int left_over; piece.x < right; piece.x += LUMINANCE_RUN) {
		left_over = right - piece.x;
		piece.count =
			left_over < LUMINANCE_RUN ? left_over : LUMINANCE_RUN;
		draw_piece(draw, &piece);
		piece.s += (uint32_t)piece.s_right * LUMINANCE_RUN;
		piece.t += (uint32_t)piece.t_right * LUMINANCE_RUN;
		piece.alpha += (uint32_t)piece.alpha_right * LUMINANCE_RUN;
	}
}

int32_t soft_luminance_share_out(const struct draw *draw, int32_t all, int steps)
{
	return steps < 2
		? all
		: (int32_t)((int64_t)all * draw->inverse_q31[steps] >> 31);
}

static void bent_row(
	struct draw *draw, const struct point *begin, int left, int right)
{
	struct point from = *begin, to;
	int length = soft_luminance_find_length(draw, &from);

	for (int x = left; x < right; x += length) {
		int count = right - x < length ? right - x : length;
		/* Up to the last pixel, which still is inside. */
		int steps = right - x > length ? length : count - 1;
		struct piece piece = {.x = x, .count = count};
		const int32_t *at = from.value;

		to = from;
		if (steps > 0) {
			soft_rows_find_point(draw, x + steps, &to);
		}
		set_start(&piece, &from);
		piece.s_right = soft_luminance_share_out(
			draw, to.value[TEX_S] - at[TEX_S], steps);
		piece.t_right = soft_luminance_share_out(
			draw, to.value[TEX_S + 1] - at[TEX_S + 1], steps);
		piece.alpha_right = soft_luminance_share_out(
			draw, to.value[ALPHA] - at[ALPHA], steps);
		draw_piece(draw, &piece);
		from = to;
	}
}

static void draw_row(struct draw *draw, int y, int left, int right)
{
	struct raster *raster = &draw->raster;
	struct point from;
	/* Coordinates are last. */
	bool fading = raster->moving[0] == ALPHA;

	raster->span.y = y;
	/* Where it does not move. */
	from.value[ALPHA] = (int32_t)raster->span.value[ALPHA];
	soft_rows_find_point(draw, left, &from);
	/* Every fourth row, and in the triangle's first one. */
	if (y % 4 == 0 || raster->first_row) {
		soft_rows_find_lod(draw, &from, &raster->span);
		raster->first_row = false;
	}
	if (is_level(draw, &from, right - left)) {
		level_row(draw, &from, left, right, fading);
	} else {
		bent_row(draw, &from, left, right);
	}
}

static void make_shades(struct draw *draw, const uint32_t color[3])
{
	for (uint32_t i = 0; i < 255; i++) {
		uint32_t luminance = (i * 257 + 128) >> 8;
		int c[3];

		for (int k = 0; k < 3; k++) {
			c[k] = (int)(((color[k] >> 16) * luminance * 257 +
					     32896) >>
				16);
		}
		draw->shade[i] = pack_565(c[0], c[1], c[2]);
	}
	memcpy(draw->shade_color, color, sizeof(draw->shade_color));
}

/* Whether the triangle has one colour, which is taken. */
static bool begin(struct draw *draw)
{
	const struct raster *raster = &draw->raster;
	uint32_t color[3];

	for (int i = 0; i < raster->moving_count; i++) {
		if (raster->moving[i] <= BLUE) {
			return false;
		}
	}
	for (int i = 0; i < 3; i++) {
		color[i] = raster->span.value[RED + i];
	}
	draw->raster.first_row = true;
	if (memcmp(color, draw->shade_color, sizeof(color)) != 0) {
		make_shades(draw, color);
	}
	return true;
}

/* To the next row: what those take. */
static void next_row(struct draw *draw)
{
	static const int taken[] = {ALPHA, TEX_S, TEX_S + 1, DEPTH, INVERSE_W};
	struct plane *plane = draw->raster.plane;

	/* Some have no plane, but nobody asks for it then. */
	for (int i = 0; i < 5; i++) {
		plane[taken[i]].start += (uint32_t)plane[taken[i]].dy;
	}
}

void soft_fill_luminance(struct draw *draw, struct setup *setup)
{
	rows_set_up(draw, setup);
	if (begin(draw)) {
		raster_walk(draw, setup, draw_row, next_row);
	} else {
		soft_walk_rows(draw, setup);
	}
}
