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

/*
 * Pixels of a row whose values run linearly. Texels are the base's, 16.16;
 * share, how much of 256 a texel counts, and alpha are 8.16.
 */
struct piece {
	int x, count;
	uint32_t s, t, alpha, share; /* of the first */
	int32_t s_right, t_right, alpha_right, share_right;
};

static uint32_t size_of(int32_t value)
{
	return value < 0 ? 0u - (uint32_t)value : (uint32_t)value;
}

/*
 * The same depth for all pixels of a row if rounding alone makes them differ,
 * as in level planes.
 */
static void write_depth(uint16_t *depth, int count, uint32_t z, int32_t z_right)
{
	if ((uint64_t)size_of(z_right) * (uint32_t)count < 1 << 10) {
		z += (uint32_t)(z_right * count / 2);
		soft_fill_pixels(depth, count, (uint16_t)(z >> 10));
		return;
	}
	for (int i = 0; i < count; i++) {
		depth[i] = (uint16_t)(z >> 10);
		z += (uint32_t)z_right;
	}
}

int soft_luminance_test_depth(
	uint16_t *depth, int count, uint32_t z, uint32_t z_right)
{
	int i = 0;

	for (; i < count - 1; i += 2) {
		if (z >> 10 >= depth[i]) {
			return i;
		}
		depth[i] = (uint16_t)(z >> 10);
		z += z_right;
		if (z >> 10 >= depth[i + 1]) {
			return i + 1;
		}
		depth[i + 1] = (uint16_t)(z >> 10);
		z += z_right;
	}
	if (i < count && z >> 10 < depth[i]) {
		depth[i] = (uint16_t)(z >> 10);
		i++;
	}
	return i;
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

/* The piece's texels, by the table: colours, or luminance if that is varied. */
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
		.shade = draw->by_share ? draw->luminance : draw->shade,
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

	if (fine && draw->soft->counts) {
		soft_count_fine(draw, piece->count);
	}
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

/* Mixes what is shaded into the picture, with one alpha for as many as will do. */
static void blend(
	const struct piece *piece, uint16_t *pixel, const uint16_t *shaded)
{
	uint32_t size = size_of(piece->alpha_right);
	int most = share_pixels(piece->alpha_right), count;

	for (int i = 0; i < piece->count; i += count) {
		uint32_t middle;

		count = piece->count - i;
		if ((uint64_t)size * (uint32_t)count >= SHARE_STEP &&
			count > most) {
			count = most;
		}
		middle = piece->alpha +
			(uint32_t)piece->alpha_right * (uint32_t)(i + count / 2);
		soft_mix_pixels(pixel + i, shaded + i, count,
			(middle + SHARE_ROUND) >> 19);
	}
}

/* Luminance becomes gray; 255 times 65536 is below 2^24. */
static void make_gray(const struct draw *draw, const struct piece *piece,
	const uint16_t *luminance, uint16_t *out)
{
	const uint16_t *end = luminance + piece->count;
	const uint32_t *gray = draw->gray;
	uint32_t share = piece->share, right = (uint32_t)piece->share_right;

	while (luminance < end) {
		*out++ = (uint16_t)gray[*luminance++ * (share >> 8) >> 16];
		share += right;
	}
}

static void draw_visible(struct draw *draw, const struct piece *piece)
{
	uint16_t *pixel = (uint16_t *)(void *)pixel_at(
		&draw->soft->buffers.target, piece->x, draw->raster.span.y);
	/* Words lie in one as they do in the other. */
	uint16_t *aside = draw->shaded + ((uintptr_t)pixel / sizeof(*pixel)) % 2;

	shade(draw, piece, draw->by_share || draw->blended ? aside : pixel);
	if (draw->by_share) {
		make_gray(draw, piece, aside, draw->blended ? aside : pixel);
	}
	if (draw->blended) {
		blend(piece, pixel, aside);
	}
}

/* To where so many pixels of it are over. */
static void move_on(struct piece *piece, int pixels)
{
	uint32_t n = (uint32_t)pixels;

	piece->x += pixels;
	piece->s += (uint32_t)piece->s_right * n;
	piece->t += (uint32_t)piece->t_right * n;
	piece->alpha += (uint32_t)piece->alpha_right * n;
	piece->share += (uint32_t)piece->share_right * n;
}

/* The parts of a piece that are nearer than what is there. */
static void draw_tested(
	struct draw *draw, const struct piece *piece, uint16_t *depth)
{
	const struct raster *raster = &draw->raster;

	struct piece part = *piece;

	for (int left = piece->count; left > 0; left -= part.count + 1) {
		part.count = soft_luminance_test_depth(depth, left,
			plane_at(raster, DEPTH, part.x),
			(uint32_t)raster->plane[DEPTH].dx);
		if (part.count > 0) {
			draw_visible(draw, &part);
		}
		depth += part.count + 1;
		move_on(&part, part.count + 1);
	}
}

static void draw_piece(struct draw *draw, const struct piece *piece)
{
	const struct raster *raster = &draw->raster;
	const struct buffers *buffers = &draw->soft->buffers;
	uint16_t *depth = buffers->depth + piece->x +
		(size_t)raster->span.y * (size_t)buffers->width;
	uint32_t bits = draw->key.bits;

	if (bits & KEY_DEPTH_LESS) {
		draw_tested(draw, piece, depth);
		return;
	}
	if (bits & KEY_DEPTH_TEST && draw->soft->fragment.depth_mask) {
		write_depth(depth, piece->count,
			plane_at(raster, DEPTH, piece->x),
			raster->plane[DEPTH].dx);
	}
	draw_visible(draw, piece);
}

/* How many pixels may run linearly from there: n^2 of the slope of q is below q. */
static int find_length(const struct draw *draw, const struct point *from)
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

/* Of 255 parts into 256; the half that planes have rounds. */
static int32_t to_share(int32_t color_q16)
{
	return (int32_t)((uint32_t)color_q16 + (uint32_t)(color_q16 >> 8));
}

static void start_piece(const struct point *from, int x, struct piece *piece)
{
	piece->x = x;
	piece->s = (uint32_t)from->value[TEX_S];
	piece->t = (uint32_t)from->value[TEX_S + 1];
	piece->alpha = (uint32_t)from->value[ALPHA];
	piece->share = (uint32_t)to_share(from->value[RED]);
}

static void level_row(
	struct draw *draw, const struct point *from, int left, int right)
{
	uint32_t moving = draw->raster.moving_bits;
	struct piece piece;

	start_piece(from, left, &piece);
	piece.s_right = level_step(draw, from, TEX_S);
	piece.t_right = level_step(draw, from, TEX_S + 1);
	piece.alpha_right =
		moving >> ALPHA & 1 ? level_step(draw, from, ALPHA) : 0;
	piece.share_right =
		moving >> RED & 1 ? to_share(level_step(draw, from, RED)) : 0;
	for (; piece.x < right; move_on(&piece, piece.count)) {
		piece.count = right - piece.x < LUMINANCE_RUN ? right - piece.x
							      : LUMINANCE_RUN;
		draw_piece(draw, &piece);
	}
}

/* A step of so many that lead from one value to another. */
static int32_t share_out(
	const struct draw *draw, int32_t from, int32_t to, int steps)
{
	int32_t all = (int32_t)((uint32_t)to - (uint32_t)from);

	return steps < 2
		? all
		: (int32_t)((int64_t)all * draw->inverse_q31[steps] >> 31);
}

static void bent_row(
	struct draw *draw, const struct point *begin, int left, int right)
{
	struct point from = *begin, to;
	int length = find_length(draw, &from);

	for (int x = left; x < right; x += length) {
		/* Up to the last pixel, which still is inside. */
		int steps = right - x > length ? length : right - x - 1;
		const int32_t *at = from.value;
		struct piece piece;

		start_piece(&from, x, &piece);
		piece.count = right - x < length ? right - x : length;
		to = from;
		if (steps > 0) {
			soft_rows_find_point(draw, x + steps, &to);
		}
		piece.s_right =
			share_out(draw, at[TEX_S], to.value[TEX_S], steps);
		piece.t_right = share_out(
			draw, at[TEX_S + 1], to.value[TEX_S + 1], steps);
		piece.alpha_right =
			share_out(draw, at[ALPHA], to.value[ALPHA], steps);
		piece.share_right = to_share(
			share_out(draw, at[RED], to.value[RED], steps));
		draw_piece(draw, &piece);
		from = to;
	}
}

static void draw_row(struct draw *draw, int y, int left, int right)
{
	struct raster *raster = &draw->raster;
	struct point from;

	raster->span.y = y;
	/* Where they do not move. */
	from.value[RED] = (int32_t)raster->span.value[RED];
	from.value[ALPHA] = (int32_t)raster->span.value[ALPHA];
	soft_rows_find_point(draw, left, &from);
	/* Every fourth row, and in the triangle's first one. */
	if (y % 4 == 0 || raster->first_row) {
		soft_rows_find_lod(draw, &from, &raster->span);
		raster->first_row = false;
	}
	if (is_level(draw, &from, right - left)) {
		level_row(draw, &from, left, right);
	} else {
		bent_row(draw, &from, left, right);
	}
}

/* Of halves of 127ths, 0 to 255. */
static uint32_t luminance_of(uint32_t halves)
{
	return (halves * 257 + 128) >> 8;
}

static void make_shades(struct draw *draw, const uint32_t color[3])
{
	for (uint32_t i = 0; i < 255; i++) {
		uint32_t luminance = luminance_of(i);
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

static bool is_same_plane(const struct plane *a, const struct plane *b)
{
	return a->start == b->start && a->dx == b->dx && a->dy == b->dy;
}

/* Whether red, green and blue are the same all over. */
static bool is_gray(const struct raster *raster)
{
	const uint32_t colors = 7u << RED;
	const struct plane *plane = raster->plane;
	const uint32_t *still = raster->span.value;

	if ((raster->moving_bits & colors) == 0) {
		return still[RED] == still[GREEN] && still[RED] == still[BLUE];
	}
	return (raster->moving_bits & colors) == colors &&
		is_same_plane(&plane[RED], &plane[GREEN]) &&
		is_same_plane(&plane[RED], &plane[BLUE]);
}

/* Red stands for all three colours. */
static void leave_green_and_blue(struct raster *raster)
{
	int count = 0;

	for (int i = 0; i < raster->moving_count; i++) {
		if (raster->moving[i] != GREEN && raster->moving[i] != BLUE) {
			raster->moving[count++] = raster->moving[i];
		}
	}
	raster->moving_count = count;
}

/*
 * Whether the triangle is taken: in one colour, or in gray. Of gray ground that is
 * tested each triangle has another, for which a table each would take too long.
 */
static bool begin(struct draw *draw)
{
	struct raster *raster = &draw->raster;
	bool still = (raster->moving_bits & 7u << RED) == 0;
	bool gray = is_gray(raster);

	if (!still && !gray) {
		return false;
	}
	raster->first_row = true;
	draw->by_share = !still || (gray && draw->key.bits & KEY_DEPTH_LESS);
	if (!still) {
		leave_green_and_blue(raster);
	} else if (!draw->by_share &&
		memcmp(raster->span.value, draw->shade_color,
			sizeof(draw->shade_color)) != 0) {
		make_shades(draw, raster->span.value);
	}
	return true;
}

void soft_luminance_init(struct draw *draw)
{
	draw->shade_color[0] = UINT32_MAX; /* no colour */
	for (uint32_t i = 0; i < 255; i++) {
		draw->luminance[i] = luminance_of(i);
	}
	for (int i = 0; i < 256; i++) {
		draw->gray[i] = pack_565(i, i, i);
	}
}

/* To the next row: what those take. */
static void next_row(struct draw *draw)
{
	static const int taken[] = {
		RED, ALPHA, TEX_S, TEX_S + 1, DEPTH, INVERSE_W};
	struct plane *plane = draw->raster.plane;

	/* Some have no plane, but nobody asks for it then. */
	for (int i = 0; i < 6; i++) {
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
