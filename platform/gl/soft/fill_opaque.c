/*
 * A common case by itself: opaque triangles of up to 128 pixels into RGB565,
 * tested and written with the depth function LESS, with one RGB565 texture that
 * repeats. The small ones of them are fill_texture.c's, all else is rows.c's.
 *
 * The differences from there: four texels are mixed, and those under one share
 * modulated, in steps of 1/32.
 */
#include "platform/gl/soft/pixel.h"
#include "platform/gl/soft/ramp.h"

enum {
	/* Half of 1/32, so that 255 is 32/32. */
	SHARE_ROUND = 4 << 16,
};

enum paint {
	TEXTURE_GRAY, /* red alone stands for all */
	TEXTURE_TINTED,
	TEXTURE_LINEAR, /* tinted, four texels mixed */
};

struct ramps {
	struct ramp z, color[3], s, t;
};

/* Where pixels go and what they are made of. */
struct run {
	uint16_t *pixel, *depth;
	int left, count;
	const uint8_t *texels;
	uint32_t s_mask, t_mask; /* of offsets in bytes */
	int t_shift;
	int s_down, t_down; /* from the base's coordinates to the level's */
};

static ALWAYS_INLINE uint32_t load_texel(
	const struct run *run, uint32_t s, uint32_t t)
{
	uint32_t offset =
		(s >> 15 & run->s_mask) + (t >> run->t_shift & run->t_mask);

	return *(const uint16_t *)(const void *)(run->texels + offset);
}

/* The mean of four texels by where the centre lies between them. */
static ALWAYS_INLINE uint32_t load_linear(
	const struct run *run, uint32_t s, uint32_t t)
{
	uint32_t left = s >> 15 & run->s_mask;
	uint32_t right = (left + 2) & run->s_mask;
	uint32_t row = t >> run->t_shift & run->t_mask;
	const uint8_t *above = run->texels + row;
	const uint8_t *below =
		run->texels + ((row + run->s_mask + 2) & run->t_mask);
	uint32_t across = s >> 11 & 31;
	uint32_t mixed = mix_wide(mix_wide(widen(load_16(above + left)),
					  widen(load_16(above + right)), across),
		mix_wide(widen(load_16(below + left)),
			widen(load_16(below + right)), across),
		t >> 11 & 31);

	return narrow(mixed);
}

/* Shares are 0..32. */
static ALWAYS_INLINE uint32_t shade_gray(uint32_t texel, uint32_t share)
{
	texel = (texel | texel << 16) & 0x07E0F81F;
	texel = (texel * share + 0x02008010) >> 5 & 0x07E0F81F;
	return texel | texel >> 16;
}

/* Colours are below 2^15. */
static ALWAYS_INLINE uint32_t shade_tinted(
	uint32_t texel, uint32_t r, uint32_t g, uint32_t b)
{
	return (((texel & 0xF800) * r + (1 << 25)) >> 15 & 0xF800) |
		(((texel & 0x07E0) * g + (1 << 19)) >> 15 & 0x07E0) |
		((texel & 31) * b + (1 << 14)) >> 15;
}

static ALWAYS_INLINE void run_texture(
	const struct run *run, const struct ramps *ramps, enum paint paint)
{
	bool gray = paint == TEXTURE_GRAY, linear = paint == TEXTURE_LINEAR;
	int s_down = linear ? run->s_down : 0, t_down = linear ? run->t_down : 0;
	uint32_t half = linear ? 32768 : 0;
	uint16_t *pixel = run->pixel + run->left;
	uint16_t *depth = run->depth + run->left;
	uint16_t *const end = pixel + run->count;
	uint32_t z = ramp_at(&ramps->z, run->left);
	uint32_t s =
		(uint32_t)((int32_t)ramp_at(&ramps->s, run->left) >> s_down);
	uint32_t t =
		(uint32_t)((int32_t)ramp_at(&ramps->t, run->left) >> t_down);
	uint32_t ds = (uint32_t)(ramps->s.dx >> s_down);
	uint32_t dt = (uint32_t)(ramps->t.dx >> t_down);
	uint32_t r = ramp_at(&ramps->color[0], run->left);
	uint32_t g = gray ? 0 : ramp_at(&ramps->color[1], run->left);
	uint32_t b = gray ? 0 : ramp_at(&ramps->color[2], run->left);

	s -= half;
	t -= half;
	do {
		if (z >> 10 < *depth) {
			uint32_t texel = linear ? load_linear(run, s, t)
						: load_texel(run, s, t);

			*depth = (uint16_t)(z >> 10);
			*pixel = (uint16_t)(gray ? shade_gray(texel, r >> 19)
						 : shade_tinted(texel, r >> 9,
							   g >> 9, b >> 9));
		}
		depth++;
		z += (uint32_t)ramps->z.dx;
		s += ds;
		t += dt;
		r += (uint32_t)ramps->color[0].dx;
		if (!gray) {
			g += (uint32_t)ramps->color[1].dx;
			b += (uint32_t)ramps->color[2].dx;
		}
	} while (++pixel != end);
}

static ALWAYS_INLINE void move_down(
	struct ramps *ramps, int rows, enum paint paint)
{
	ramp_down(&ramps->z, rows);
	ramp_down(&ramps->color[0], rows);
	if (paint >= TEXTURE_TINTED) {
		ramp_down(&ramps->color[1], rows);
		ramp_down(&ramps->color[2], rows);
	}
	ramp_down(&ramps->s, rows);
	ramp_down(&ramps->t, rows);
}

/* The level whose texels are nearest in size to pixels. */
static int choose_level(
	const struct texture_input *input, const struct ramps *ramps)
{
	uint32_t right = raster_length(
		raster_size(ramps->s.dx), raster_size(ramps->t.dx));
	uint32_t down = raster_length(
		raster_size(ramps->s.dy), raster_size(ramps->t.dy));
	uint32_t most = right > down ? right : down;
	int lod;

	lod = (raster_log2_q8(most) + 127) >> 8;
	return clamp_int(lod, 0, input->levels - 1);
}

static ALWAYS_INLINE void begin_run(const struct draw *draw,
	const struct ramps *ramps, int y, enum paint paint, struct run *run)
{
	const struct buffers *buffers = &draw->soft->buffers;
	const struct texture_input *input = &draw->texture[0];
	const struct level *level;
	int number;

	run->pixel = (uint16_t *)(void *)(buffers->target.data +
		(ptrdiff_t)y * buffers->target.stride_bytes);
	run->depth = buffers->depth + y * buffers->width;
	number = paint == TEXTURE_LINEAR ? choose_level(input, ramps) : 0;
	level = &input->texture->level[number];
	run->texels = level->texels;
	run->s_down = input->width_log2 - level->width_log2;
	run->t_down = input->height_log2 - level->height_log2;
	run->s_mask = (2u << level->width_log2) - 2;
	run->t_mask = ((1u << level->height_log2) - 1)
		<< (level->width_log2 + 1);
	run->t_shift = 15 - level->width_log2;
}

static ALWAYS_INLINE void walk(struct draw *draw, const struct setup *setup,
	const struct ramps *start, enum paint paint)
{
	struct ramps ramps = *start;
	const struct clip_box box = draw->box;
	const struct buffers *buffers = &draw->soft->buffers;
	const ptrdiff_t stride = buffers->target.stride_bytes;
	const int depth_stride = buffers->width;
	int top = setup->top < box.top ? box.top : setup->top;
	int bottom = setup->bottom < box.bottom ? setup->bottom : box.bottom;
	int turn = setup->middle < top ? top : setup->middle;
	int y = top, end = turn < bottom ? turn : bottom;
	struct side whole = raster_side(draw, setup->v[0], setup->v[2], top);
	struct side part = raster_side(draw, setup->v[0], setup->v[1], top);
	struct run run;

	begin_run(draw, &ramps, y, paint, &run);
	if (top > setup->top) {
		move_down(&ramps, top - setup->top, paint);
	}
	for (;;) {
		struct side left = setup->middle_left ? part : whole;
		struct side right = setup->middle_left ? whole : part;

		for (; y < end; y++) {
			int from = raster_column(left.x);
			int to = raster_column(right.x);

			from = from > box.left ? from : box.left;
			to = to < box.right ? to : box.right;
			run.left = from;
			run.count = to - from;
			if (run.count > 0) {
				run_texture(&run, &ramps, paint);
			}
			move_down(&ramps, 1, paint);
			left.x += left.step;
			right.x += right.step;
			run.pixel = (uint16_t *)(void *)((uint8_t *)run.pixel +
				stride);
			run.depth += depth_stride;
		}
		if (end == bottom) {
			return;
		}
		end = bottom;
		whole = setup->middle_left ? right : left;
		part = raster_side(draw, setup->v[1], setup->v[2], y);
	}
}

static bool is_gray(const struct setup *setup)
{
	const int32_t *a = setup->v[0]->attribute + RED;
	const int32_t *b = setup->v[1]->attribute + RED;
	const int32_t *c = setup->v[2]->attribute + RED;

	return ((a[0] ^ a[1]) | (a[0] ^ a[2]) | (b[0] ^ b[1]) | (b[0] ^ b[2]) |
		       (c[0] ^ c[1]) | (c[0] ^ c[2])) == 0;
}

static ALWAYS_INLINE bool find_ramps(const struct draw *draw,
	struct setup *setup, enum paint paint, struct ramps *out)
{
	const struct texture_input *input = &draw->texture[0];
	int32_t round = paint == TEXTURE_GRAY ? SHARE_ROUND >> 8 : 0;
	int32_t z = setup->v[0]->z;
	struct limits limits = find_limits(draw, setup);
	struct scale scale;

	if (setup->wide) {
		return false;
	}
	raster_find_area(setup);
	scale = find_scale(setup);
	if (!find_color_ramp(&scale, RED, limits.color, round, &out->color[0])) {
		return false;
	}
	if (paint >= TEXTURE_TINTED) {
		if (!find_color_ramp(&scale, GREEN, limits.color, round,
			    &out->color[1]) ||
			!find_color_ramp(&scale, BLUE, limits.color, round,
				&out->color[2])) {
			return false;
		}
	}
	if (!find_texel_ramp(
		    &scale, TEX_S, input->width_log2, limits.texel, &out->s) ||
		!find_texel_ramp(&scale, TEX_S + 1, input->height_log2,
			limits.texel, &out->t)) {
		return false;
	}
	out->z = find_ramp(&scale, z, setup->v[1]->z - z, setup->v[2]->z - z);
	return true;
}

static ALWAYS_INLINE void fill_walking(
	struct draw *draw, struct setup *setup, enum paint paint)
{
	struct ramps ramps;

	if (find_ramps(draw, setup, paint, &ramps)) {
		walk(draw, setup, &ramps, paint);
	} else {
		rows_fill(draw, setup);
	}
}

static void fill_gray(struct draw *draw, struct setup *setup)
{
	fill_walking(draw, setup, TEXTURE_GRAY);
}

static void fill_tinted(struct draw *draw, struct setup *setup)
{
	fill_walking(draw, setup, TEXTURE_TINTED);
}

static void fill_linear(struct draw *draw, struct setup *setup)
{
	fill_walking(draw, setup, TEXTURE_LINEAR);
}

void fill_textured(struct draw *draw, struct setup *setup)
{
	if (draw->texture[0].texture->mag_filter == GL_LINEAR) {
		if (!fill_texture_tinted(draw, setup)) {
			fill_linear(draw, setup);
		}
	} else if (is_gray(setup)) {
		if (!fill_texture_gray(draw, setup)) {
			fill_gray(draw, setup);
		}
	} else if (!fill_texture_tinted(draw, setup)) {
		fill_tinted(draw, setup);
	}
}

bool fill_is_opaque(const struct draw *draw)
{
	const struct soft *soft = draw->soft;
	const struct fragment_state *state = &soft->fragment;
	const GLboolean *mask = state->color_mask;

	return soft->format == PIXELS_RGB565 && !draw->blended &&
		!state->alpha_test && !state->stencil.enabled && !draw->fogged &&
		mask[0] && mask[1] && mask[2] && state->depth_test &&
		state->depth_mask && state->depth_function == GL_LESS &&
		!state->flat && !state->offset_fill &&
		!draw->shading.two_side && !draw->texture[1].used;
}

bool fill_takes_texture(const struct texture_input *input)
{
	const struct texture *texture = input->texture;
	GLenum min = texture->min_filter;
	bool nearest = min == GL_NEAREST && texture->mag_filter == GL_NEAREST;
	bool linear = texture->mag_filter == GL_LINEAR &&
		(min == GL_LINEAR || min == GL_LINEAR_MIPMAP_NEAREST);

	return input->base->format == TEXEL_565 &&
		input->env->mode == GL_MODULATE && (nearest || linear) &&
		texture->wrap_s == GL_REPEAT && texture->wrap_t == GL_REPEAT;
}
