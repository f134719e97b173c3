#include "platform/gl/soft/ground.h"

#include "platform/base/compiler.h"
#include "platform/gl/soft/luminance.h"
#include "platform/gl/soft/pixel.h"
#include "platform/gl/soft/rows.h"

enum {
	/* Half of 1/32, so that 255 is 32/32. */
	ALPHA_ROUND = 4 << 16,
	BLENDED_MOST = 64, /* pixels of a blended run */
};

static ALWAYS_INLINE uint32_t load_quad(
	const struct shade_run *run, uint32_t s, uint32_t t)
{
	return run->quads[(t >> (32 - run->height_log2) << run->width_log2) +
		(s >> (32 - run->width_log2))];
}

/* As shade.c's mix_quad(), with 8 bits of fraction. */
static ALWAYS_INLINE uint32_t mix_quad_q8(
	const struct shade_run *run, uint32_t quad, uint32_t s, uint32_t t)
{
	uint32_t left = quad & 0xFF00FF, right = quad >> 8 & 0xFF00FF;
	uint32_t across = s << run->width_log2 >> 28;
	uint32_t down = t << run->height_log2 >> 28;
	uint32_t rows = left * 16 + (right - left) * across;

	return (rows & 0xFFFF) * (16 - down) + (rows >> 16) * down;
}

/* 65280 times 65662 are below 2^32. */
static ALWAYS_INLINE uint16_t shade_one(
	const struct shade_run *run, uint32_t texel_q8, uint32_t share)
{
	return (uint16_t)run->shade[texel_q8 * (share >> 8) >> 24];
}

static void shade_each(const struct shade_run *run, uint16_t *pixel, int count,
	uint32_t s, uint32_t t, uint32_t share)
{
	for (int i = 0; i < count; i++) {
		uint32_t quad = load_quad(run, s, t);

		pixel[i] = shade_one(run, mix_quad_q8(run, quad, s, t), share);
		s += (uint32_t)run->s_right;
		t += (uint32_t)run->t_right;
		share += (uint32_t)run->share_right;
	}
}

/* Four pixels of one texel. */
static void shade_same(const struct shade_run *run, uint16_t *pixel,
	uint32_t texel, uint32_t share)
{
	for (int i = 0; i < 4; i++) {
		pixel[i] = shade_one(run, texel << 8, share);
		share += (uint32_t)run->share_right;
	}
}

static int32_t size_of(int32_t value)
{
	return value < 0 ? -value : value;
}

void ground_shade_c(const struct shade_run *run)
{
	uint16_t *pixel = run->pixel;
	uint32_t s = run->s, t = run->t, share = run->share;
	uint32_t quad = load_quad(run, s, t);
	int left = run->count;

	if ((size_of(run->s_right) | size_of(run->t_right)) >>
		(31 - run->width_log2)) {
		shade_each(run, pixel, left, s, t, share);
		return;
	}
	for (; left >= 4; left -= 4, pixel += 4) {
		uint32_t next_s = s + (uint32_t)run->s_right * 4;
		uint32_t next_t = t + (uint32_t)run->t_right * 4;
		uint32_t next = load_quad(run, next_s, next_t);

		if (next == quad && quad == (quad >> 8 | quad << 24)) {
			shade_same(run, pixel, quad & 255, share);
		} else {
			shade_each(run, pixel, 4, s, t, share);
		}
		quad = next;
		s = next_s;
		t = next_t;
		share += (uint32_t)run->share_right * 4;
	}
	shade_each(run, pixel, left, s, t, share);
}

int ground_depth_c(uint16_t *depth, int count, uint32_t z, uint32_t z_right)
{
	int i;

	for (i = 0; i < count && z >> 10 < depth[i]; i++) {
		depth[i] = (uint16_t)(z >> 10);
		z += z_right;
	}
	return i;
}

static void blend_run(struct shade_run *run, uint16_t *pixel)
{
	uint32_t alpha = run->alpha;

	for (int i = 0; i < run->count; i++) {
		pixel[i] = narrow(mix_wide(
			widen(pixel[i]), widen(run->pixel[i]), alpha >> 19));
		alpha += (uint32_t)run->alpha_right;
	}
}

/* A part of a run, from its pixel first on. */
static void shade_part(const struct draw *draw, const struct shade_run *run,
	int first, int count)
{
	uint16_t own[BLENDED_MOST];
	struct shade_run part = *run;
	uint32_t n = (uint32_t)first;

	part.pixel += first;
	part.count = count;
	part.s += (uint32_t)run->s_right * n;
	part.t += (uint32_t)run->t_right * n;
	part.share += (uint32_t)run->share_right * n;
	if (!draw->blended) {
		soft_bands.shade_ground(&part);
		return;
	}
	part.alpha += (uint32_t)run->alpha_right * n;
	part.pixel = own;
	soft_bands.shade_ground(&part);
	blend_run(&part, run->pixel + first);
}

/* Parts that are nearer than what is there; mostly all of it is. */
static void draw_run(const struct draw *draw, const struct shade_run *run)
{
	uint32_t z = run->z, z_right = (uint32_t)run->z_right;

	for (int first = 0; first < run->count;) {
		int count = soft_bands.depth(
			run->depth + first, run->count - first, z, z_right);

		if (count > 0) {
			shade_part(draw, run, first, count);
		}
		/* what follows is hidden */
		first += count + 1;
		z += z_right * (uint32_t)(count + 1);
	}
}

/* Of 255 parts into 256, 8.16. */
static int32_t to_share(int32_t color_q16)
{
	return color_q16 + (color_q16 >> 8);
}

static void draw_between(struct draw *draw, const struct point *from,
	const struct point *to, int x, int count, int steps)
{
	struct span *span = &draw->raster.span;
	const struct buffers *buffers = &draw->soft->buffers;
	int32_t s = from->value[TEX_S], t = from->value[TEX_S + 1];
	struct shade_run run = {
		.pixel = (uint16_t *)(void *)pixel_at(
			&buffers->target, x, span->y),
		.depth = buffers->depth +
			(size_t)span->y * (size_t)buffers->width + x,
		.count = count,
		.s = (uint32_t)s,
		.t = (uint32_t)t,
		.s_right =
			luminance_share_out(draw, to->value[TEX_S] - s, steps),
		.t_right = luminance_share_out(
			draw, to->value[TEX_S + 1] - t, steps),
		.z = plane_at(&draw->raster, DEPTH, x),
		.z_right = draw->raster.plane[DEPTH].dx,
		.alpha = (uint32_t)from->value[ALPHA] + ALPHA_ROUND,
		.alpha_right = luminance_share_out(
			draw, to->value[ALPHA] - from->value[ALPHA], steps),
		.share = (uint32_t)to_share(from->value[RED]),
		.share_right = to_share(luminance_share_out(
			draw, to->value[RED] - from->value[RED], steps)),
		.shade = draw->gray,
	};

	/* Every fourth row, and in the triangle's first one. */
	if (span->y % 4 == 0 || draw->raster.first_row) {
		rows_find_lod(draw, from, span);
		draw->raster.first_row = false;
	}
	luminance_choose_texels(draw, span->lod[0], &run);
	draw_run(draw, &run);
}

void ground_row(struct draw *draw, int y, int left, int right)
{
	const struct span *span = &draw->raster.span;
	struct point from, to;
	int length;

	draw->raster.span.y = y;
	/* Where they do not move. */
	from.value[RED] = (int32_t)span->value[RED];
	from.value[ALPHA] = (int32_t)span->value[ALPHA];
	rows_find_point(draw, left, &from);
	length = luminance_find_length(draw, &from);
	if (draw->blended && length > BLENDED_MOST) {
		length = BLENDED_MOST;
	}
	for (int x = left; x < right; x += length) {
		int count = right - x < length ? right - x : length;
		/* Up to the last pixel, which still is inside. */
		int steps = right - x > length ? length : count - 1;

		to = from;
		if (steps > 0) {
			rows_find_point(draw, x + steps, &to);
		}
		draw_between(draw, &from, &to, x, count, steps);
		from = to;
	}
}

static bool is_same_plane(const struct plane *a, const struct plane *b)
{
	return a->start == b->start && a->dx == b->dx && a->dy == b->dy;
}

/* How many of the colours move; those that do not are the same or -1. */
static int count_grays(const struct raster *raster)
{
	const struct plane *plane = raster->plane;
	const uint32_t *still = raster->span.value;
	int count = 0;

	for (int i = 0; i < raster->moving_count; i++) {
		count += raster->moving[i] <= BLUE;
	}
	if (count == 0) {
		return still[RED] == still[GREEN] && still[RED] == still[BLUE]
			? 0
			: -1;
	}
	return count == 3 && is_same_plane(&plane[RED], &plane[GREEN]) &&
			is_same_plane(&plane[RED], &plane[BLUE])
		? 3
		: -1;
}

bool ground_begin(struct draw *draw)
{
	struct raster *raster = &draw->raster;
	int grays = count_grays(raster), count = 0;

	if (grays < 0) {
		return false;
	}
	/* One of the three stands for all. */
	for (int i = 0; i < raster->moving_count; i++) {
		int name = raster->moving[i];

		if (name != GREEN && name != BLUE) {
			raster->moving[count++] = name;
		}
	}
	raster->moving_count = count;
	raster->first_row = true;
	return true;
}

void ground_init(struct draw *draw)
{
	/* What is cut to i is between i and i + 1. */
	for (int i = 0; i < 256; i++) {
		int red = (int)(round_to_5((uint32_t)(2 * i + 1) << 15) >> 19);
		int green = (int)(round_to_6((uint32_t)(2 * i + 1) << 15) >> 18);

		draw->gray[i] =
			(uint32_t)(red << 11 | green << 5 | red) * 0x10001u;
	}
}

bool ground_takes(const struct draw *draw)
{
	const struct fragment_state *state = &draw->soft->fragment;
	const struct texture_input *input = &draw->texture[0];

	return state->depth_test && state->depth_mask &&
		state->depth_function == GL_LESS &&
		luminance_takes_texture(draw) &&
		input->width_log2 == input->height_log2;
}
