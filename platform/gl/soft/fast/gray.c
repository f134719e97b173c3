#include "platform/gl/soft/fast/gray.h"

#include "platform/base/compiler.h"
#include "platform/gl/soft/fast/luminance.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/halves.h"
#include "platform/gl/soft/span/spans.h"

static ALWAYS_INLINE uint32_t load_quad(
	const struct shade_run *run, uint32_t s, uint32_t t)
{
	return run->quads[(t >> (32 - run->height_log2) << run->width_log2) +
		(s >> (32 - run->width_log2))];
}

/* Of four texels that are the same. */
static ALWAYS_INLINE bool is_even(uint32_t quad)
{
	return quad == (quad >> 8 | quad << 24);
}

/* The mean of four texels by 16ths, with 8 bits of fraction. */
static ALWAYS_INLINE uint32_t mix_quad_q8(
	const struct shade_run *run, uint32_t quad, uint32_t s, uint32_t t)
{
	uint32_t left = BYTES_AS_HALVES(quad);
	uint32_t right = BYTES_AS_HALVES(quad >> 8);
	uint32_t across = s << run->width_log2 >> 28;
	uint32_t down = t << run->height_log2 >> 28;
	uint32_t rows = left * 16 + (right - left) * across;

	return HALVES_SUM(rows, (down << 16) - down + 16);
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
	for (const uint16_t *end = pixel + count; pixel < end; pixel++) {
		uint32_t quad = load_quad(run, s, t);

		*pixel = shade_one(run, mix_quad_q8(run, quad, s, t), share);
		s += (uint32_t)run->s_right;
		t += (uint32_t)run->t_right;
		share += (uint32_t)run->share_right;
	}
}

/* Four pixels of one texel, which is at most 255: a product is below 2^32. */
static ALWAYS_INLINE void shade_same(const struct shade_run *run,
	uint16_t *pixel, uint32_t texel, uint32_t share)
{
	const uint32_t *shade = run->shade;
	uint32_t right = (uint32_t)run->share_right;

	pixel[0] = (uint16_t)shade[texel * (share >> 8) >> 16];
	share += right;
	pixel[1] = (uint16_t)shade[texel * (share >> 8) >> 16];
	share += right;
	pixel[2] = (uint16_t)shade[texel * (share >> 8) >> 16];
	share += right;
	pixel[3] = (uint16_t)shade[texel * (share >> 8) >> 16];
}

static int32_t size_of(int32_t value)
{
	return value < 0 ? -value : value;
}

void soft_gray_shade(const struct shade_run *run)
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

		if (next == quad && is_even(quad)) {
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

int soft_gray_depth(uint16_t *depth, int count, uint32_t z, uint32_t z_right)
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

/* A part of a run, from its pixel first on; up to LUMINANCE_RUN pixels. */
static void shade_part(
	struct draw *draw, const struct shade_run *run, int first, int count)
{
	struct shade_run part = *run;
	uint16_t *pixel = run->pixel + first;
	uint32_t n = (uint32_t)first;

	part.count = count;
	part.s += (uint32_t)run->s_right * n;
	part.t += (uint32_t)run->t_right * n;
	part.share += (uint32_t)run->share_right * n;
	part.pixel = draw->blended
		? draw->shaded + ((uintptr_t)pixel / sizeof(*pixel)) % 2
		: pixel;
	soft_gray_shade(&part);
	if (draw->blended) {
		soft_luminance_blend(pixel, part.pixel, count,
			run->alpha + (uint32_t)run->alpha_right * n,
			run->alpha_right);
	}
}

/* Parts that are nearer than what is there; the first was tested already. */
static void draw_parts(
	struct draw *draw, const struct shade_run *run, int passed)
{
	int first = 0;

	while (first < run->count) {
		int count = passed < LUMINANCE_RUN ? passed : LUMINANCE_RUN;

		if (count > 0) {
			shade_part(draw, run, first, count);
		}
		first += count;
		passed -= count;
		if (passed == 0) {
			/* what follows is hidden, unless the run is over */
			first++;
			passed = soft_gray_depth(run->depth + first,
				run->count - first,
				run->z + (uint32_t)run->z_right * (uint32_t)first,
				(uint32_t)run->z_right);
		}
	}
}

/* Mostly all of it is. */
static void draw_run(struct draw *draw, const struct shade_run *run)
{
	int passed = soft_gray_depth(
		run->depth, run->count, run->z, (uint32_t)run->z_right);

	if (passed == run->count && !draw->blended) {
		soft_gray_shade(run);
	} else {
		draw_parts(draw, run, passed);
	}
}

/* Of 255 parts into 256, 8.16; the half that planes have rounds. */
static int32_t to_share(int32_t color_q16)
{
	return color_q16 + (color_q16 >> 8);
}

static void choose_level(struct draw *draw)
{
	const struct texture_input *input = &draw->texture[0];
	/* Down to two texels: none is shifted by 32 bits. */
	int most = input->levels - 1 < input->width_log2 - 1
		? input->levels - 1
		: input->width_log2 - 1;
	int number = clamp_int((draw->raster.span.lod[0] + 127) >> 8, 0, most);
	const struct level *level = &input->texture->level[number];

	draw->gray_rows.run.quads = level->quads;
	draw->gray_rows.run.width_log2 = level->width_log2;
	draw->gray_rows.run.height_log2 = level->height_log2;
}

/* Where it begins; coordinates are those of the base, 16.16. */
static void start_run(struct draw *draw, int x, uint32_t s, uint32_t t)
{
	const struct buffers *buffers = &draw->soft->buffers;
	struct shade_run *run = &draw->gray_rows.run;
	int y = draw->raster.span.y, shift = 16 - draw->texture[0].width_log2;
	/* From centres to the upper left texel of four. */
	uint32_t half = 1u << (31 - run->width_log2);

	run->pixel = (uint16_t *)(void *)pixel_at(&buffers->target, x, y);
	run->depth = buffers->depth + (size_t)y * (size_t)buffers->width + x;
	run->z = plane_at(&draw->raster, DEPTH, x);
	run->s = (s << shift) - half;
	run->t = (t << shift) - half;
}

/* How it goes on, where that is not the same in all of a triangle. */
static void step_run(struct draw *draw, const struct point *from,
	const struct point *to, int steps)
{
	struct shade_run *run = &draw->gray_rows.run;
	int shift = 16 - draw->texture[0].width_log2;
	int32_t step[ATTRIBUTES];

	for (int i = 0; i < draw->raster.moving_count; i++) {
		int name = draw->raster.moving[i];

		step[name] = soft_luminance_share_out(
			draw, to->value[name] - from->value[name], steps);
		if (name == RED) {
			run->share = (uint32_t)to_share(from->value[RED]);
			run->share_right = to_share(step[RED]);
		} else if (name == ALPHA) {
			run->alpha = (uint32_t)from->value[ALPHA];
			run->alpha_right = step[ALPHA];
		}
	}
	run->s_right = (int32_t)((uint32_t)step[TEX_S] << shift);
	run->t_right = (int32_t)((uint32_t)step[TEX_S + 1] << shift);
}

static void row_perspective(struct draw *draw, int left, int right)
{
	struct raster *raster = &draw->raster;
	struct shade_run *run = &draw->gray_rows.run;
	struct point from, to;
	int length;

	soft_rows_find_point(draw, left, &from);
	length = soft_luminance_find_length(draw, &from);
	/* Every fourth row, and in the triangle's first one. */
	if (raster->span.y % 4 == 0 || raster->first_row) {
		soft_rows_find_lod(draw, &from, &raster->span);
		choose_level(draw);
		raster->first_row = false;
	}
	for (int x = left; x < right; x += length) {
		/* Up to the last pixel, which still is inside. */
		int steps = right - x > length ? length : right - x - 1;

		if (steps > 0) {
			soft_rows_find_point(draw, x + steps, &to);
		} else {
			to = from;
		}
		run->count = right - x < length ? right - x : length;
		start_run(draw, x, (uint32_t)from.value[TEX_S],
			(uint32_t)from.value[TEX_S + 1]);
		step_run(draw, &from, &to, steps);
		draw_run(draw, run);
		from = to;
	}
}

static void row_affine(struct draw *draw, int left, int right)
{
	const struct raster *raster = &draw->raster;
	struct shade_run *run = &draw->gray_rows.run;

	run->count = right - left;
	start_run(draw, left, plane_at(raster, TEX_S, left),
		plane_at(raster, TEX_S + 1, left));
	if (draw->gray_rows.shaded) {
		run->share = (uint32_t)to_share(
			(int32_t)plane_at(raster, RED, left));
	}
	if (draw->gray_rows.fading) {
		run->alpha = plane_at(raster, ALPHA, left);
	}
	draw_run(draw, run);
}

static void draw_row(struct draw *draw, int y, int left, int right)
{
	draw->raster.span.y = y;
	if (draw->raster.perspective) {
		row_perspective(draw, left, right);
	} else {
		row_affine(draw, left, right);
	}
}

/* What is the same in all of a triangle. */
static void begin_runs(struct draw *draw)
{
	struct raster *raster = &draw->raster;
	const struct plane *plane = raster->plane;
	struct gray_rows *rows = &draw->gray_rows;
	struct shade_run *run = &rows->run;
	int shift = 16 - draw->texture[0].width_log2;

	run->shade = draw->gray;
	run->z_right = plane[DEPTH].dx;
	run->share = (uint32_t)to_share((int32_t)raster->span.value[RED]);
	run->share_right = 0;
	run->alpha = raster->span.value[ALPHA];
	run->alpha_right = 0;
	raster->first_row = true;
	if (raster->perspective) {
		return;
	}
	soft_rows_find_lod(draw, NULL, &raster->span);
	choose_level(draw);
	run->s_right = (int32_t)((uint32_t)plane[TEX_S].dx << shift);
	run->t_right = (int32_t)((uint32_t)plane[TEX_S + 1].dx << shift);
	run->share_right = rows->shaded ? to_share(plane[RED].dx) : 0;
	run->alpha_right = rows->fading ? plane[ALPHA].dx : 0;
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

/* Whether the triangle is gray, which is taken. */
static bool begin(struct draw *draw)
{
	struct raster *raster = &draw->raster;
	int grays = count_grays(raster), count = 0;

	if (grays < 0) {
		return false;
	}
	draw->gray_rows.shaded = grays > 0;
	draw->gray_rows.fading = false;
	/* One of the three stands for all. */
	for (int i = 0; i < raster->moving_count; i++) {
		int name = raster->moving[i];

		if (name != GREEN && name != BLUE) {
			raster->moving[count++] = name;
		}
		draw->gray_rows.fading |= name == ALPHA;
	}
	raster->moving_count = count;
	begin_runs(draw);
	return true;
}

void soft_gray_init(struct draw *draw)
{
	for (int i = 0; i < 256; i++) {
		draw->gray[i] = pack_565(i, i, i) * 0x10001u;
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

void soft_fill_gray(struct draw *draw, struct setup *setup)
{
	rows_set_up(draw, setup);
	if (begin(draw)) {
		raster_walk(draw, setup, draw_row, next_row);
	} else {
		soft_walk_rows(draw, setup);
	}
}
