#include "platform/gl/soft/luminance.h"

#include "platform/gl/soft/pixel.h"
#include "platform/gl/soft/rows.h"
#include "platform/gl/soft/shade.h"

enum {
	/* Half of 1/32, so that 255 is 32/32. */
	SHARE_ROUND = 4 << 16,
	RUN_MOST = 512,
};

static int32_t size_of(int32_t value)
{
	return value < 0 ? -value : value;
}

/*
 * Ground is as deep all along a row, but for what rounding left: then one value
 * does.
 */
static void write_depth(const struct shade_run *run)
{
	int32_t all = run->z_right * run->count;
	uint32_t z = run->z;

	if (size_of(all) < 1 << 10) {
		z += (uint32_t)(all / 2);
		soft_bands.fill(run->depth, run->count, (uint16_t)(z >> 10));
		return;
	}
	for (int i = 0; i < run->count; i++) {
		run->depth[i] = (uint16_t)(z >> 10);
		z += (uint32_t)run->z_right;
	}
}

/* Pairs of pixels go where words may: mapped memory can be particular. */
static void put_odd_pixel(struct shade_run *run)
{
	struct shade_run odd = *run;

	odd.count = 1;
	shade_two_c(&odd);
	run->pixel++;
	run->count--;
	run->s += (uint32_t)run->s_right;
	run->t += (uint32_t)run->t_right;
}

static void draw_run(struct shade_run *run, bool blended)
{
	int32_t s = size_of(run->s_right) >> (31 - run->width_log2);
	int32_t t = size_of(run->t_right) >> (31 - run->height_log2);
	bool wide = s == 0 && t == 0; /* texels of two pixels or more */
	bool square = run->width_log2 == run->height_log2;

	if (run->depth) {
		write_depth(run);
	}
	if (!blended && (uintptr_t)run->pixel % sizeof(uint32_t) != 0) {
		put_odd_pixel(run);
	}
	if (blended && wide) {
		shade_four_blended_c(run);
	} else if (blended) {
		shade_two_blended_c(run);
	} else if (wide && square) {
		soft_bands.shade_four(run);
	} else if (wide) {
		shade_four_c(run);
	} else if (square) {
		soft_bands.shade_two(run);
	} else {
		shade_two_c(run);
	}
}

/* n^2 of the slope of q is below q. */
int luminance_find_length(const struct draw *draw, const struct point *from)
{
	const struct raster *raster = &draw->raster;
	uint32_t slope, n = RUN_MOST;

	if (!raster->perspective) {
		return RUN_MOST;
	}
	slope = (uint32_t)size_of(raster->plane[INVERSE_W].dx);
	while (n > PERSPECTIVE_STEP &&
		(uint64_t)slope * n * n > (uint32_t)from->q) {
		n /= 2;
	}
	return (int)n;
}

int32_t luminance_share_out(const struct draw *draw, int32_t all, int steps)
{
	return steps < 2
		? all
		: (int32_t)((int64_t)all * draw->inverse_q31[steps] >> 31);
}

/* Coordinates at the base, 16.16, into those of a level. */
static void choose_texels(
	const struct draw *draw, int lod, struct shade_run *run)
{
	const struct texture_input *input = &draw->texture[0];
	int side = input->width_log2 < input->height_log2 ? input->width_log2
							  : input->height_log2;
	/* Down to two texels: none is shifted by 32 bits. */
	int most = input->levels - 1 < side - 1 ? input->levels - 1 : side - 1;
	int number = clamp_int((lod + 127) >> 8, 0, most);
	const struct level *level = &input->texture->level[number];
	int s_shift = 16 - input->width_log2, t_shift = 16 - input->height_log2;

	run->quads = level->quads;
	run->width_log2 = level->width_log2;
	run->height_log2 = level->height_log2;
	run->s = (run->s << s_shift) - (1u << (31 - level->width_log2));
	run->t = (run->t << t_shift) - (1u << (31 - level->height_log2));
	run->s_right = (int32_t)((uint32_t)run->s_right << s_shift);
	run->t_right = (int32_t)((uint32_t)run->t_right << t_shift);
}

static void draw_between(struct draw *draw, const struct point *from,
	const struct point *to, int x, int count, int steps)
{
	struct span *span = &draw->raster.span;
	const struct buffers *buffers = &draw->soft->buffers;
	const struct fragment_state *state = &draw->soft->fragment;
	uint16_t *depth =
		buffers->depth + (size_t)span->y * (size_t)buffers->width + x;
	struct shade_run run = {
		.pixel = (uint16_t *)(void *)pixel_at(
			&buffers->target, x, span->y),
		.depth = state->depth_test && state->depth_mask ? depth : NULL,
		.count = count,
		.s = (uint32_t)from->value[TEX_S],
		.t = (uint32_t)from->value[TEX_S + 1],
		.s_right = luminance_share_out(
			draw, to->value[TEX_S] - from->value[TEX_S], steps),
		.t_right = luminance_share_out(draw,
			to->value[TEX_S + 1] - from->value[TEX_S + 1], steps),
		.z = plane_at(&draw->raster, DEPTH, x),
		.z_right = draw->raster.plane[DEPTH].dx,
		.alpha = (uint32_t)from->value[ALPHA] + SHARE_ROUND,
		.alpha_right = luminance_share_out(
			draw, to->value[ALPHA] - from->value[ALPHA], steps),
		.shade = draw->shade,
	};

	/* Every fourth row, and in the triangle's first one. */
	if (span->y % 4 == 0 || draw->raster.first_row) {
		rows_find_lod(draw, from, span);
		draw->raster.first_row = false;
	}
	choose_texels(draw, span->lod[0], &run);
	draw_run(&run, draw->blended);
}

void luminance_row(struct draw *draw, int y, int left, int right)
{
	struct point from, to;
	int length;

	draw->raster.span.y = y;
	/* Where it does not move. */
	from.value[ALPHA] = (int32_t)draw->raster.span.value[ALPHA];
	rows_find_point(draw, left, &from);
	length = luminance_find_length(draw, &from);
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

static void make_shades(struct draw *draw, const uint32_t color[3])
{
	for (uint32_t i = 0; i < 256; i++) {
		int c[3];

		for (int k = 0; k < 3; k++) {
			c[k] = (int)(((color[k] >> 16) * i * 257 + 32896) >> 16);
		}
		draw->shade[i] = widen(pack_565(c[0], c[1], c[2]));
	}
	memcpy(draw->shade_color, color, sizeof(draw->shade_color));
}

bool luminance_begin(struct draw *draw)
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

bool luminance_takes_texture(const struct draw *draw)
{
	const struct fragment_state *state = &draw->soft->fragment;
	const struct texture_input *input = &draw->texture[0];
	const struct texture *texture = input->texture;
	const GLboolean *mask = state->color_mask;

	return input->used && draw->soft->format == PIXELS_RGB565 &&
		!draw->fogged && !state->alpha_test && !draw->texture[1].used &&
		(!draw->blended ||
			(state->blend_source == GL_SRC_ALPHA &&
				state->blend_destination ==
					GL_ONE_MINUS_SRC_ALPHA)) &&
		input->env->mode == GL_MODULATE && input->base->quads &&
		input->width_log2 > 0 && input->height_log2 > 0 &&
		texture->mag_filter == GL_LINEAR &&
		texture->min_filter == GL_LINEAR_MIPMAP_NEAREST &&
		texture->wrap_s == GL_REPEAT && texture->wrap_t == GL_REPEAT &&
		mask[0] && mask[1] && mask[2] && !state->stencil.enabled;
}

bool luminance_takes(const struct draw *draw)
{
	const struct fragment_state *state = &draw->soft->fragment;

	return luminance_takes_texture(draw) &&
		(!state->depth_test || state->depth_function == GL_ALWAYS);
}
