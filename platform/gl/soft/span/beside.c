/*
 * Draws runs with tests or blend functions that span functions lack: these draw
 * with copies of depths, or of pixels, and the results are merged afterwards.
 */
#include "platform/gl/soft/span/tests.h"
#include "platform/gl/soft/span/texels.h"
#include "platform/gl/soft/stages/made.h"
#include "platform/gl/soft/vertex/draw.h"

/*
 * The runs of one call, drawn with depths in aside instead of the buffer's. These
 * are copies of the buffer's if span functions test depths; else 65535 where a
 * fragment passes all tests and 0 where not; or all 65535 if tests come last.
 */
struct batch {
	struct draw *draw;
	const struct soft_row *from; /* the runs with the buffers' addresses */
	uint32_t count;
	bool copied; /* depths are copies */
	bool last;   /* tests come last: an alpha test precedes the stencil's */
	bool marked; /* it must be known which fragments were drawn */
	struct soft_row row[SOFT_BATCH_RUNS]; /* runs for the span function */
	/* a fragment was drawn if its depths in aside and before differ */
	uint16_t aside[SOFT_BATCH_ROOM], before[SOFT_BATCH_ROOM];
	uint32_t own[SOFT_BATCH_ROOM]; /* pixels drawn beside the picture */
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

/* Sets a run's depths in aside; false if no fragment passes. */
static bool set_aside(const struct batch *batch, const struct soft_row *from,
	struct soft_row *row)
{
	const struct soft_tested tested = find_tested(batch->draw, from);

	if (batch->copied) {
		memcpy(row->depth, from->depth, row->count * 2);
		return true;
	}
	row->z = 0;
	/* without tests all fragments pass */
	if (batch->last || batch->draw->spans.untested) {
		memset(row->depth, 0xFF, row->count * 2);
		return true;
	}
	return soft_test(batch->draw->soft, &tested, row->depth);
}

static bool begin_batch(struct batch *batch)
{
	uint16_t *aside = batch->aside;
	bool any = false;

	for (uint32_t i = 0; i < batch->count; i++) {
		struct soft_row *row = &batch->row[i];

		*row = batch->from[i];
		row->depth = aside;
		any |= set_aside(batch, &batch->from[i], row);
		aside += row->count;
	}
	if (batch->marked) {
		memcpy(batch->before, batch->aside,
			(size_t)((uint8_t *)aside - (uint8_t *)batch->aside));
	}
	return any;
}

/* Lets runs draw beside the picture, where they are blended or tested last. */
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

static void draw_batch(struct batch *batch, soft_span_function function)
{
	struct soft_run *run = &batch->draw->spans.run;
	const uint32_t z_right = run->z_right;

	run->rows = batch->row;
	run->z_right = batch->copied ? z_right : 0;
	function(run);
	run->rows = batch->from;
	run->z_right = z_right;
}

/*
 * Makes depth and stencil tests of the fragments that were drawn, if an alpha
 * test came first: fragments that fail it must not change the stencil.
 */
static void test_drawn(const struct batch *batch, uint32_t i,
	const uint16_t *before, uint16_t *aside)
{
	const struct soft_tested all = find_tested(batch->draw, &batch->from[i]);
	uint16_t passes[SOFT_RUN_PIXELS];

	for (uint32_t at = 0, end; at < all.count; at = end + 1) {
		struct soft_tested part = all;

		for (end = at; end < all.count && before[end] != aside[end];
			end++) {
		}
		if (end == at) {
			continue;
		}
		part.place += at;
		part.count = end - at;
		part.z += all.z_right * at;
		soft_test(batch->draw->soft, &part, passes);
		for (uint32_t k = at; k < end; k++) {
			if (!passes[k - at]) {
				aside[k] = before[k];
			}
		}
	}
}

/*
 * Writes the depths of the fragments that were drawn and, if own is not NULL,
 * copies their pixels from there to the picture.
 */
static void write_drawn(const struct soft_spans *spans,
	const struct soft_row *row, const uint8_t *own, const uint16_t *before,
	const uint16_t *aside)
{
	const size_t pixel_bytes = (size_t)1 << spans->pixel_log2;
	uint32_t z = row->z;

	for (uint32_t i = 0; i < row->count; i++, z += spans->run.z_right) {
		if (before[i] == aside[i]) {
			continue;
		}
		if (own) {
			memcpy(row->pixel + i * pixel_bytes,
				own + i * pixel_bytes, pixel_bytes);
		}
		if (spans->depth_written) {
			row->depth[i] = (uint16_t)(z >> 16);
		}
	}
}

static void end_batch(struct batch *batch)
{
	const struct soft_spans *spans = &batch->draw->spans;
	uint16_t *before = batch->before, *aside = batch->aside;

	for (uint32_t i = 0; i < batch->count; i++) {
		const struct soft_row *from = &batch->from[i];
		const uint8_t *own = batch->row[i].pixel;
		const uint8_t *copied =
			batch->last && !spans->blended_last ? own : NULL;

		if (batch->last) {
			test_drawn(batch, i, before, aside);
		}
		if (spans->blended_last) {
			soft_blend_row(batch->draw, from, own, before, aside);
		}
		if (copied || spans->depth_written) {
			write_drawn(spans, from, copied, before, aside);
		}
		before += from->count;
		aside += from->count;
	}
}

/* The functions whose depth test, LESS or LEQUAL, is the state's. */
static const soft_span_function *testing_functions(
	const struct soft_spans *spans)
{
	return spans->function + (spans->equal_passes ? SOFT_LEQUAL : 0);
}

static NEVER_INLINE void draw_beside(struct draw *draw, enum soft_place place)
{
	const struct soft_spans *spans = &draw->spans;
	struct batch batch;

	batch.draw = draw;
	batch.from = spans->run.rows;
	batch.count = spans->run.row_count;
	batch.copied = spans->tested_by_functions;
	batch.last = spans->stenciled && spans->alpha_tested;
	batch.marked = batch.last || spans->blended_last || spans->depth_written;
	if (!begin_batch(&batch)) {
		return;
	}
	if (batch.last || spans->blended_last) {
		begin_pixels(&batch);
	}
	draw_batch(&batch,
		batch.copied ? testing_functions(spans)[place]
			     : spans->function[place]);
	if (batch.marked) {
		end_batch(&batch);
	}
}

static void draw_tested(struct draw *draw, enum soft_place place)
{
	struct soft_spans *spans = &draw->spans;

	if (spans->unmasked) {
		for (const struct soft_row *row = spans->run.rows;
			spans->depth_replaced && row < end_of(&spans->run);
			row++) {
			memset(row->depth, 0xFF, row->count * 2);
		}
		testing_functions(spans)[place](&spans->run);
	} else {
		draw_beside(draw, place);
	}
}

/* Restores the bits of pixels that are not in mask. */
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

static NEVER_INLINE void draw_masked(struct draw *draw, enum soft_place place)
{
	const struct soft_spans *spans = &draw->spans;
	const struct soft_run *run = &spans->run;
	uint32_t own[SOFT_BATCH_ROOM], *old = own;

	for (const struct soft_row *row = run->rows; row < end_of(run); row++) {
		memcpy(old, row->pixel, row->count << spans->pixel_log2);
		old += row->count;
	}
	draw_tested(draw, place);
	old = own;
	for (const struct soft_row *row = run->rows; row < end_of(run); row++) {
		restore(row->pixel, (const uint8_t *)old,
			row->count << spans->pixel_log2, spans->color_mask);
		old += row->count;
	}
}

/* Draws as a span function does, with colour mask and any tests. */
static void draw_other(const struct soft_run *run, enum soft_place place)
{
	if (run->draw->spans.color_mask != UINT32_MAX) {
		draw_masked(run->draw, place);
	} else {
		draw_tested(run->draw, place);
	}
}

static void draw_anywhere(const struct soft_run *run)
{
	draw_other(run, SOFT_ANYWHERE);
}

static void draw_inside(const struct soft_run *run)
{
	draw_other(run, SOFT_INSIDE);
}

static void draw_second(const struct soft_run *run)
{
	const struct soft_spans *spans = &run->draw->spans;
	uint32_t texel[SOFT_BATCH_ROOM];

	spans->read_second(run->draw, texel);
	spans->seconded(run);
}

/* Without tests, whole rows may be filled or copied. */
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
	spans->function = function;
	spans->whole_rows = false;
	spans->draw_anywhere = draw_anywhere;
	spans->draw = draw_inside;
	if (spans->direct) {
		spans->draw_anywhere = testing_functions(spans)[SOFT_ANYWHERE];
		spans->draw = testing_functions(spans)[SOFT_INSIDE];
	}
	if (spans->untested) {
		set_untested(spans);
	}
	if (spans->read_second) {
		spans->seconded = spans->draw;
		spans->draw = draw_second;
	}
}
