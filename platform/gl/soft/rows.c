/* The rows of a triangle in any state: cut into spans for fragment.c. */
#include "platform/gl/soft/rows.h"
#include "platform/gl/soft/ground.h"
#include "platform/gl/soft/luminance.h"
#include "platform/gl/soft/picture.h"
#include "platform/gl/soft/pixel.h"

/* 65536 / n */
static const int32_t inverse_q16[PERSPECTIVE_STEP + 1] = {0, 65536, 32768,
	21845, 16384, 13107, 10923, 9362, 8192, 7282, 6554, 5958, 5461, 5041,
	4681, 4369, 4096};

static uint32_t size_of(int64_t value)
{
	uint64_t size = (uint64_t)(value < 0 ? -value : value);

	return size > UINT32_MAX / 2 ? UINT32_MAX / 2 : (uint32_t)size;
}

/* The longer of the two ways a step across and a step down lead. */
static uint32_t longer_way(const int64_t across[2], const int64_t down[2])
{
	uint32_t right = raster_length(size_of(across[0]), size_of(across[1]));
	uint32_t below = raster_length(size_of(down[0]), size_of(down[1]));

	return right > below ? right : below;
}

static void find_affine_lod(const struct draw *draw, struct span *span)
{
	const struct raster *raster = &draw->raster;

	for (int unit = 0; unit < SOFT_UNITS; unit++) {
		const struct plane *p = &raster->plane[TEX_S + 2 * unit];

		if (draw->texture[unit].used) {
			const int64_t across[2] = {p[0].dx, p[1].dx};
			const int64_t down[2] = {p[0].dy, p[1].dy};

			span->lod[unit] =
				raster_log2_q8(longer_way(across, down));
		}
	}
}

void rows_affine(struct draw *draw, int y, int left, int right)
{
	const struct raster *raster = &draw->raster;
	struct span *span = &draw->raster.span;

	span->y = y;
	for (int x = left; x < right; x += SPAN_PIXELS) {
		span->x = x;
		span->count = right - x < SPAN_PIXELS ? right - x : SPAN_PIXELS;
		for (int i = 0; i < raster->moving_count; i++) {
			int name = raster->moving[i];

			span->value[name] = plane_at(raster, name, x);
		}
		span->value[DEPTH] = plane_at(raster, DEPTH, x);
		draw->span(draw, span);
	}
}

void rows_find_point(const struct draw *draw, int x, struct point *out)
{
	const struct raster *raster = &draw->raster;
	int32_t q;

	if (!raster->perspective) {
		for (int n = 0; n < raster->moving_count; n++) {
			int i = raster->moving[n];

			out->value[i] = (int32_t)plane_at(raster, i, x);
		}
		return;
	}
	q = (int32_t)plane_at(raster, INVERSE_W, x);
	out->q = q > 0 ? q : 1;
	out->zeros = LEADING_ZEROS_32((uint32_t)out->q);
	out->inverse = reciprocal((uint32_t)out->q << out->zeros);
	for (int n = 0; n < raster->moving_count; n++) {
		int i = raster->moving[n];
		int32_t at = (int32_t)plane_at(raster, i, x);

		if (i >= TEX_S) {
			out->value[i] = rows_divide(
				out, at, raster->tex_shift[i - TEX_S] + 8);
		} else {
			out->value[i] = clamp_int(
				rows_divide(out, at, 24), 0, 0xFF80FF);
		}
	}
}

/* d(S / q) = (dS - S / q dq) / q */
void rows_find_lod(
	const struct draw *draw, const struct point *point, struct span *span)
{
	const struct raster *raster = &draw->raster;
	const struct plane *q = &raster->plane[INVERSE_W];

	if (!raster->perspective) {
		find_affine_lod(draw, span);
		return;
	}
	for (int unit = 0; unit < SOFT_UNITS; unit++) {
		int64_t across[2], down[2];

		if (!draw->texture[unit].used) {
			continue;
		}
		for (int i = 0; i < 2; i++) {
			int name = TEX_S + 2 * unit + i;
			const struct plane *p = &raster->plane[name];
			int shift = raster->tex_shift[name - TEX_S];
			int64_t u = point->value[name];
			/* u is in 16.16: back to the plane's scale */
			int64_t x = p->dx - (u * q->dx >> (shift + 8));
			int64_t y = p->dy - (u * q->dy >> (shift + 8));

			across[i] =
				rows_divide(point, saturate_64(x), shift + 8);
			down[i] = rows_divide(point, saturate_64(y), shift + 8);
		}
		span->lod[unit] = raster_log2_q8(longer_way(across, down));
	}
}

static void set_steps(const struct raster *raster, const struct point *from,
	const struct point *to, int steps, struct span *span)
{
	for (int n = 0; n < raster->moving_count; n++) {
		int i = raster->moving[n];
		int64_t all = (int64_t)to->value[i] - from->value[i];

		span->value[i] = (uint32_t)from->value[i];
		span->step[i] = (int32_t)(all * inverse_q16[steps] >> 16);
	}
}

static void row_perspective(struct draw *draw, int y, int left, int right)
{
	struct span *span = &draw->raster.span;
	struct point from, to;

	span->y = y;
	rows_find_point(draw, left, &from);
	for (int x = left; x < right; x += PERSPECTIVE_STEP) {
		int left_over = right - x;
		/* Up to the last pixel, which still is inside. */
		int steps = left_over > PERSPECTIVE_STEP ? PERSPECTIVE_STEP
							 : left_over - 1;

		span->x = x;
		span->count = left_over < PERSPECTIVE_STEP ? left_over
							   : PERSPECTIVE_STEP;
		span->value[DEPTH] = plane_at(&draw->raster, DEPTH, x);
		rows_find_lod(draw, &from, span);
		to = from;
		if (steps > 0) {
			rows_find_point(draw, x + steps, &to);
		}
		set_steps(&draw->raster, &from, &to, steps, span);
		draw->span(draw, span);
		from = to;
	}
}

/* Rows of one colour with nothing to test or blend: backdrops. */
static void row_constant(struct draw *draw, int y, int left, int right)
{
	const struct plane *plane = draw->raster.plane;

	soft_bands.fill((uint16_t *)(void *)pixel_at(
				&draw->soft->buffers.target, left, y),
		right - left,
		color_565(plane[RED].start, plane[GREEN].start,
			plane[BLUE].start));
}

static void next_constant(struct draw *draw)
{
	struct plane *plane = draw->raster.plane;

	for (int i = RED; i <= BLUE; i++) {
		plane[i].start += (uint32_t)plane[i].dy;
	}
}

/* Colours that stand still have planes too. */
static void fill_constant(struct draw *draw, struct setup *setup)
{
	struct raster *raster = &draw->raster;
	uint32_t still = 7u << RED;

	for (int i = 0; i < raster->moving_count; i++) {
		still &= ~(1u << raster->moving[i]);
	}
	for (int i = RED; i <= BLUE; i++) {
		if (still >> i & 1) {
			raster->plane[i] =
				(struct plane){.start = raster->span.value[i]};
		}
	}
	raster_walk(draw, setup, row_constant, next_constant);
}

static bool is_constant_by_row(const struct draw *draw)
{
	const struct raster *raster = &draw->raster;
	int32_t across = 0;

	if (!draw->plain || raster->perspective) {
		return false;
	}
	for (int i = 0; i < raster->moving_count; i++) {
		across |= raster->plane[raster->moving[i]].dx;
	}
	return across == 0;
}

void rows_fill(struct draw *draw, struct setup *setup)
{
	struct raster *raster = &draw->raster;

	raster_set_up(draw, setup);
	raster->span.step[DEPTH] = raster->plane[DEPTH].dx;
	if (draw->luminance && luminance_begin(draw)) {
		raster_walk(draw, setup, luminance_row, luminance_next);
		return;
	}
	if (draw->ground && ground_begin(draw)) {
		raster_walk(draw, setup, ground_row, ground_next);
		return;
	}
	if (is_constant_by_row(draw)) {
		fill_constant(draw, setup);
		return;
	}
	if (raster->perspective) {
		raster_walk(draw, setup, row_perspective, raster_next_row);
		return;
	}
	for (int i = 0; i < raster->moving_count; i++) {
		int name = raster->moving[i];

		raster->span.step[name] = raster->plane[name].dx;
	}
	find_affine_lod(draw, &raster->span);
	if (draw->picture && picture_begin(draw)) {
		raster_walk(draw, setup, picture_row, raster_next_row);
		return;
	}
	raster_walk(draw, setup, rows_affine, raster_next_row);
}
