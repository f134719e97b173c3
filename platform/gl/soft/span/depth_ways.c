#include "platform/gl/soft/raster/small_list.h"
#include "platform/gl/soft/span/tests.h"
#include "platform/gl/soft/span/texels.h"
#include "platform/gl/soft/stages/blend_row.h"

/* Where a run's texels lie: the last ones are cut. */
enum reach {
	ANYWHERE = SOFT_ANYWHERE,
	INSIDE = SOFT_INSIDE,
	ACROSS,
};

/* The runs of one call, drawn with depths beside the buffer. */
struct batch {
	struct draw *draw;
	const struct soft_row *from; /* as they are */
	uint32_t count;
	bool marked;                     /* before tells what is drawn */
	bool by_less;                    /* aside are depths as they are */
	uint32_t z_right;                /* of row */
	struct soft_row row[SMALL_RUNS]; /* as the function gets them */
	uint16_t aside[SOFT_BATCH_PIXELS], before[SOFT_BATCH_PIXELS];
	uint32_t own[SOFT_BATCH_PIXELS];
};

static const struct soft_row *end_of(const struct soft_run *run)
{
	return run->rows + run->row_count;
}

static struct soft_tested find_tested(
	const struct draw *draw, const struct soft_row *row)
{
	return (struct soft_tested){
		.place = (size_t)(row->depth - draw->soft->buffers.depth),
		.count = row->count,
		.z = row->z,
		.z_right = draw->spans.run.z_right,
	};
}

/* What LESS compares, so that it passes where a fragment equals a depth. */
static void find_equal(const struct soft_row *row, uint32_t z_right,
	uint32_t less, uint16_t *out)
{
	uint32_t z = row->z;

	for (uint32_t i = 0; i < row->count; i++, z += z_right) {
		out[i] = (uint16_t)((row->depth[i] ^ z >> 16) - less);
	}
}

static void find_mirrored(const struct soft_row *row, uint16_t *out)
{
	for (uint32_t i = 0; i < row->count; i++) {
		out[i] = (uint16_t)~row->depth[i];
	}
}

/* LESS passes what LEQUAL did: depths of fragments are 1 to 65534. */
static void pass_equal(uint16_t *limit, uint32_t count)
{
	for (uint32_t i = 0; i < count; i++) {
		limit[i] = (uint16_t)(limit[i] + (limit[i] != UINT16_MAX));
	}
}

/* Sets a run's depths aside, which the function tests by LESS or LEQUAL. */
static void set_aside(const struct batch *batch, const struct soft_row *from,
	struct soft_row *row)
{
	const struct soft_spans *spans = &batch->draw->spans;

	switch (spans->depth_way) {
	case SOFT_DEPTH_FREE:
		row->z = 0;
		if (batch->marked) {
			memset(row->depth, 0xFF, row->count * 2);
		}
		return;
	case SOFT_DEPTH_EQUAL:
		row->z = 0xFFFEu << 16;
		find_equal(from, spans->run.z_right, 1, row->depth);
		return;
	case SOFT_DEPTH_UNLIKE:
		row->z = 0;
		find_equal(from, spans->run.z_right, 0, row->depth);
		return;
	case SOFT_DEPTH_MIRRORED:
		row->z = ~from->z;
		find_mirrored(from, row->depth);
		break;
	default:
		memcpy(row->depth, from->depth, row->count * 2);
		break;
	}
	if (batch->marked && spans->equal_passes) {
		pass_equal(row->depth, row->count);
	}
}

static uint32_t find_z_right(const struct soft_spans *spans)
{
	switch (spans->depth_way) {
	case SOFT_DEPTH_MIRRORED:
		return -spans->run.z_right;
	case SOFT_DEPTH_DIRECT:
	case SOFT_DEPTH_ASIDE:
		return spans->run.z_right;
	default:
		return 0;
	}
}

/* Gives all runs their depths; with a stencil false where none passes. */
static bool begin_batch(struct batch *batch, bool stenciled, bool tests_last)
{
	struct draw *draw = batch->draw;
	uint16_t *aside = batch->aside;
	bool any = !stenciled || tests_last;

	for (uint32_t i = 0; i < batch->count; i++) {
		const struct soft_row *from = &batch->from[i];
		struct soft_row *row = &batch->row[i];

		*row = *from;
		row->depth = aside;
		if (tests_last) {
			row->z = 0;
			memset(aside, 0xFF, row->count * 2);
		} else if (stenciled) {
			const struct soft_tested tested =
				find_tested(draw, from);

			row->z = 1 << 16;
			any |= soft_test(draw->soft, &tested, aside);
		} else {
			set_aside(batch, from, row);
		}
		aside += row->count;
	}
	batch->z_right = stenciled ? 0 : find_z_right(&draw->spans);
	if (batch->marked) {
		memcpy(batch->before, batch->aside,
			(size_t)((uint8_t *)aside - (uint8_t *)batch->aside));
	}
	return any;
}

/* Draws beside the picture what is to be blended, or to be tested. */
static void begin_pixels(struct batch *batch)
{
	const struct soft_spans *spans = &batch->draw->spans;
	uint8_t *own = (uint8_t *)batch->own;

	for (uint32_t i = 0; i < batch->count; i++) {
		struct soft_row *row = &batch->row[i];

		if (!spans->blended_last) {
			memcpy(own, row->pixel, row->count << spans->pixel_log2);
		}
		row->pixel = own;
		own += row->count * 4;
	}
}

/* Draws the runs by functions for runs anywhere, and inside of the window. */
static void draw_rows(struct soft_spans *spans,
	const soft_span_function function[2], enum reach reach)
{
	if (reach == ACROSS) {
		const struct soft_row row = spans->run.row;

		soft_cut_run(&spans->run, &spans->view, function,
			spans->table == &soft_spans_8888 ? 2 : 1);
		spans->run.row = row;
	} else {
		function[reach](&spans->run);
	}
}

static void draw_batch(struct batch *batch,
	const soft_span_function function[2], enum reach reach)
{
	struct soft_spans *spans = &batch->draw->spans;
	struct soft_run *run = &spans->run;
	const struct soft_row row = run->row;
	const uint32_t z_right = run->z_right;

	run->rows = batch->row;
	run->z_right = batch->z_right;
	if (reach == ACROSS) {
		run->row = batch->row[0];
		run->rows = &run->row;
	}
	draw_rows(spans, function, reach);
	run->rows = batch->from;
	run->z_right = z_right;
	run->row = row;
}

/*
 * With an alpha test a stencil is tested last: fragments that fail the former
 * must not touch it.
 */
static void test_drawn(const struct batch *batch, uint32_t i,
	const uint16_t *before, uint16_t *aside)
{
	struct soft_tested one = find_tested(batch->draw, &batch->from[i]);
	uint32_t count = one.count;
	uint16_t passes;

	one.count = 1;
	for (; count > 0; count--, before++, aside++, one.place++) {
		if (*before != *aside &&
			!soft_test(batch->draw->soft, &one, &passes)) {
			*aside = *before;
		}
		one.z += one.z_right;
	}
}

/* Takes the pixels beside the picture that are drawn. */
static void copy_drawn(const struct soft_row *row, const uint8_t *own,
	int pixel_log2, const uint16_t *before, const uint16_t *aside)
{
	for (uint32_t i = 0; i < row->count; i++) {
		if (before[i] != aside[i]) {
			memcpy(row->pixel + (i << pixel_log2),
				own + (i << pixel_log2),
				(size_t)1 << pixel_log2);
		}
	}
}

/* Writes depths of the fragments that are drawn. */
static void write_depths(const struct batch *batch, const struct soft_row *row,
	const uint16_t *before, const uint16_t *aside)
{
	const struct soft_spans *spans = &batch->draw->spans;
	const uint32_t z_right = spans->run.z_right;
	uint32_t z = row->z;

	if (spans->depth_way == SOFT_DEPTH_DIRECT && batch->by_less) {
		memcpy(row->depth, aside, row->count * 2);
	} else if (batch->marked) {
		for (uint32_t i = 0; i < row->count; i++, z += z_right) {
			if (before[i] != aside[i]) {
				row->depth[i] = (uint16_t)(z >> 16);
			}
		}
	} else if (spans->depth_way == SOFT_DEPTH_MIRRORED) {
		for (uint32_t i = 0; i < row->count; i++) {
			row->depth[i] = (uint16_t)~aside[i];
		}
	} else if (spans->depth_way == SOFT_DEPTH_FREE) {
		for (uint32_t i = 0; i < row->count; i++, z += z_right) {
			row->depth[i] = (uint16_t)(z >> 16);
		}
	}
}

static void end_batch(struct batch *batch, bool tests_last)
{
	const struct draw *draw = batch->draw;
	const struct soft_spans *spans = &draw->spans;
	uint16_t *before = batch->before, *aside = batch->aside;

	for (uint32_t i = 0; i < batch->count; i++) {
		const struct soft_row *from = &batch->from[i];
		const uint8_t *own = batch->row[i].pixel;

		if (tests_last) {
			test_drawn(batch, i, before, aside);
		}
		if (spans->blended_last) {
			soft_blend_row(draw, from, own, before, aside);
		} else if (tests_last) {
			copy_drawn(from, own, spans->pixel_log2, before, aside);
		}
		if (spans->depth_written) {
			write_depths(batch, from, before, aside);
		}
		before += from->count;
		aside += from->count;
	}
}

static NEVER_INLINE void draw_beside(
	struct draw *draw, enum reach reach, bool stenciled)
{
	const struct soft_spans *spans = &draw->spans;
	const bool tests_last = stenciled && spans->alpha_tested;
	struct batch batch;
	bool by_lequal;

	batch.draw = draw;
	batch.from = spans->run.rows;
	batch.count = spans->run.row_count;
	batch.marked = stenciled || spans->marked;
	batch.by_less = !stenciled && !spans->equal_passes;
	by_lequal = !batch.marked &&
		(spans->equal_passes || spans->depth_way == SOFT_DEPTH_FREE);
	if (!begin_batch(&batch, stenciled, tests_last)) {
		return;
	}
	if (tests_last || spans->blended_last) {
		begin_pixels(&batch);
	}
	draw_batch(
		&batch, spans->function + (by_lequal ? SOFT_LEQUAL : 0), reach);
	end_batch(&batch, tests_last);
}

/* Whether a stencil changes, or hides, what the runs draw. */
static bool is_stenciled(const struct draw *draw)
{
	const struct soft_run *run = &draw->spans.run;

	if (!draw->spans.stenciled) {
		return false;
	}
	for (const struct soft_row *row = run->rows; row < end_of(run); row++) {
		if (!soft_stencil_keeps(draw->soft,
			    (size_t)(row->depth - draw->soft->buffers.depth),
			    row->count)) {
			return true;
		}
	}
	return false;
}

/* Every depth test but that of the functions themselves. */
static void draw_by_way(struct draw *draw, enum reach reach)
{
	struct soft_spans *spans = &draw->spans;
	const bool stenciled = is_stenciled(draw);

	if (!stenciled && !spans->marked &&
		spans->depth_way == SOFT_DEPTH_DIRECT) {
		draw_rows(spans,
			spans->function + (spans->equal_passes ? SOFT_LEQUAL : 0),
			reach);
	} else if (stenciled || spans->depth_way != SOFT_DEPTH_NEVER) {
		draw_beside(draw, reach, stenciled);
	}
}

/* Takes back what the mask does not let through. */
static void restore(
	uint8_t *pixel, const uint8_t *old, uint32_t bytes, uint32_t mask)
{
	for (; bytes >= 4; bytes -= 4, pixel += 4, old += 4) {
		uint32_t from = load_32(old);
		uint32_t to = from ^ ((from ^ load_32(pixel)) & mask);

		memcpy(pixel, &to, sizeof(to));
	}
	if (bytes > 0) {
		uint32_t from = load_16(old);

		store_16(pixel,
			(uint16_t)(from ^ ((from ^ load_16(pixel)) & mask)));
	}
}

static NEVER_INLINE void draw_masked(struct draw *draw, enum reach reach)
{
	const struct soft_spans *spans = &draw->spans;
	const struct soft_run *run = &spans->run;
	uint32_t own[SOFT_BATCH_PIXELS], *old = own;

	for (const struct soft_row *row = run->rows; row < end_of(run); row++) {
		memcpy(old, row->pixel, row->count << spans->pixel_log2);
		old += row->count;
	}
	draw_by_way(draw, reach);
	old = own;
	for (const struct soft_row *row = run->rows; row < end_of(run); row++) {
		restore(row->pixel, (const uint8_t *)old,
			row->count << spans->pixel_log2, spans->color_mask);
		old += row->count;
	}
}

#define BY_REACH(name, reach)                               \
	static void test_##name(const struct soft_run *run) \
	{                                                   \
		draw_by_way(run->draw, reach);              \
	}                                                   \
	static void mask_##name(const struct soft_run *run) \
	{                                                   \
		draw_masked(run->draw, reach);              \
	}

BY_REACH(anywhere, ANYWHERE)
BY_REACH(inside, INSIDE)
BY_REACH(across, ACROSS)

/* Where nothing is tested whole rows may be known. */
static void set_untested(struct soft_spans *spans)
{
	spans->draw_tested = spans->draw;
	if (spans->function == soft_spans_565[SOFT_NO_TEXTURE][SOFT_OPAQUE]) {
		spans->draw = soft_fill_untested;
		spans->plain_pixels = SOFT_PLAIN_PIXELS;
		spans->whole_rows = true;
	} else if (spans->function ==
		soft_spans_565[SOFT_NEAREST + TEXEL_565 - 1][SOFT_OPAQUE]) {
		spans->draw = soft_copy_untested;
		spans->whole_rows = true;
	}
}

void soft_set_functions(struct soft_spans *spans,
	const soft_span_function function[SOFT_PLACES])
{
	static const soft_span_function tests[] = {
		test_anywhere, test_inside, test_across};
	static const soft_span_function masks[] = {
		mask_anywhere, mask_inside, mask_across};
	const soft_span_function *chosen =
		spans->color_mask != UINT32_MAX ? masks : tests;

	spans->function = function;
	spans->whole_rows = false;
	if (spans->color_mask == UINT32_MAX && spans->direct) {
		chosen = function + (spans->equal_passes ? SOFT_LEQUAL : 0);
	}
	spans->draw_anywhere = chosen[ANYWHERE];
	spans->draw = chosen[INSIDE];
	spans->draw_across =
		chosen == tests || chosen == masks ? chosen[ACROSS] : NULL;
	if (spans->untested) {
		set_untested(spans);
	}
}
