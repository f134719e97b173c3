/*
 * Draws runs with tests or blend functions that span functions lack. Runs are
 * cut into parts whose fragments pass the stencil test, and depth tests that no
 * span function can make; parts are drawn with copies of depths, or of pixels,
 * where these need it, and the results are merged afterwards.
 */
#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/span/tests.h"
#include "platform/gl/soft/span/texels.h"
#include "platform/gl/soft/stages/made.h"
#include "platform/gl/soft/vertex/draw.h"

/* Runs with depths, and maybe pixels, beside the buffers, one behind the other. */
struct batch {
	struct soft_row row[SOFT_BATCH_RUNS];
	uint16_t depth[SOFT_BATCH_ROOM];
	uint32_t pixel[SOFT_BATCH_ROOM];
};

static const struct soft_row *end_of(const struct soft_run *run)
{
	return run->rows + run->row_count;
}

/* Copies depths, inverted or not. */
static void copy_depths(
	uint16_t *to, const uint16_t *from, uint32_t count, bool inverted)
{
	if (!inverted) {
		memcpy(to, from, count * sizeof(*to));
		return;
	}
#pragma GCC unroll 4
	for (; count >= 2; count -= 2, to += 2, from += 2) {
		const uint32_t two = ~soft_load_two(from);

		memcpy(to, &two, sizeof(two));
	}
	if (count > 0) {
		*to = (uint16_t) ~*from;
	}
}

/*
 * Draws runs with depths in batch: copies if copied is set, else 65535, which
 * becomes 0 where a fragment is drawn. beside: pixels are there, too.
 */
static void draw_batch(struct draw *draw, soft_span_function function,
	bool copied, bool beside, struct batch *batch)
{
	struct soft_run *run = &draw->spans.run;
	const struct soft_row *const rows = run->rows;
	const uint32_t z_right = run->z_right;
	const bool depth_kept = run->depth_kept;
	const bool inverted = copied && draw->spans.inverted;
	struct soft_row *to = batch->row;
	uint16_t *depth = batch->depth;

	for (const struct soft_row *row = rows; row < end_of(run); row++, to++) {
		*to = *row;
		to->depth = depth;
		if (copied) {
			copy_depths(depth, row->depth, row->count, inverted);
			to->z = inverted ? ~row->z : row->z;
		} else {
			memset(depth, 0xFF, row->count * sizeof(*depth));
			to->z = 0;
		}
		if (beside) {
			to->pixel = (uint8_t *)(batch->pixel +
				(depth - batch->depth));
		}
		depth += row->count;
	}
	run->rows = batch->row;
	run->z_right = !copied ? 0 : inverted ? 0 - z_right : z_right;
	run->depth_kept = false;
	function(run);
	run->rows = rows;
	run->z_right = z_right;
	run->depth_kept = depth_kept;
}

/* Blends a run that was drawn beside the picture, and writes its depths. */
static void end_run(struct draw *draw, const struct soft_row *to,
	const struct soft_row *from, bool copied)
{
	const struct soft_spans *spans = &draw->spans;
	uint16_t before[SOFT_RUN_PIXELS + 3]; /* see SOFT_BATCH_ROOM */
	uint32_t z = to->z;

	if (spans->blended_last) {
		memset(before, 0xFF, to->count * sizeof(*before));
		if (copied) {
			copy_depths(before, to->depth, to->count, false);
		}
		soft_blend_row(draw, to, from->pixel, before, from->depth);
	}
	if (copied && spans->depth_written) {
		copy_depths(to->depth, from->depth, to->count, spans->inverted);
		return;
	}
	for (uint32_t i = 0; i < to->count && spans->depth_written; i++) {
		if (from->depth[i] == 0) {
			to->depth[i] = (uint16_t)(z >> 16);
		}
		z += spans->run.z_right;
	}
}

static NEVER_INLINE void draw_beside(
	struct draw *draw, soft_span_function function)
{
	const struct soft_spans *spans = &draw->spans;
	const bool copied = spans->depths == SOFT_DEPTHS_COPIED;
	const struct soft_run *run = &spans->run;
	struct batch batch;

	draw_batch(draw, function, copied, spans->blended_last, &batch);
	if (spans->blended_last || spans->depth_written) {
		for (uint32_t i = 0; i < run->row_count; i++) {
			end_run(draw, &run->rows[i], &batch.row[i], copied);
		}
	}
}

/* The functions whose depth test, LESS or LEQUAL, serves the state's. */
static const soft_span_function *testing_functions(
	const struct soft_spans *spans)
{
	return spans->function + (spans->equal_passes ? SOFT_LEQUAL : 0);
}

static void draw_tested(struct draw *draw, enum soft_place place)
{
	struct soft_spans *spans = &draw->spans;
	const soft_span_function function = testing_functions(spans)[place];

	if (spans->depths != SOFT_DEPTHS_OWN) {
		draw_beside(draw, function);
		return;
	}
	for (const struct soft_row *row = spans->run.rows;
		spans->depth_replaced && row < end_of(&spans->run); row++) {
		memset(row->depth, 0xFF, row->count * 2);
	}
	function(&spans->run);
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
	const uint32_t mask = draw->soft->fragment.color_bits;
	uint32_t own[SOFT_BATCH_ROOM], *old = own;

	for (const struct soft_row *row = run->rows; row < end_of(run); row++) {
		memcpy(old, row->pixel, row->count << spans->pixel_log2);
		old += row->count;
	}
	draw_tested(draw, place);
	old = own;
	for (const struct soft_row *row = run->rows; row < end_of(run); row++) {
		restore(row->pixel, (const uint8_t *)old,
			row->count << spans->pixel_log2, mask);
		old += row->count;
	}
}

/* Draws runs as a span function does, with colour mask and depth test. */
static void draw_seen(struct draw *draw, enum soft_place place)
{
	if (draw->spans.unseen && !draw->spans.depth_written) {
		return;
	}
	if (draw->spans.unseen) {
		soft_write_depths(
			draw->soft->fragment.depth_function, &draw->spans.run);
	} else if (draw->soft->fragment.color_bits != UINT32_MAX) {
		draw_masked(draw, place);
	} else {
		draw_tested(draw, place);
	}
}

/* Draws the listed runs before end; returns the first element, now free. */
static struct soft_row *draw_parts(struct draw *draw, enum soft_place place,
	struct soft_row *list, const struct soft_row *end)
{
	draw->spans.run.row_count = (uint32_t)(end - list);
	if (end > list) {
		draw_seen(draw, place);
	}
	return list;
}

/* Makes the alpha test of runs: drawn becomes 0 where it passes, else 65535. */
static NEVER_INLINE void test_alpha(
	struct draw *draw, enum soft_place place, uint16_t *drawn)
{
	struct batch batch;

	draw_batch(draw, draw->spans.function[place], false, true, &batch);
	memcpy(drawn, batch.depth, sizeof(batch.depth));
}

/* The first fragments of a part of a run, with the same result of all tests. */
static struct soft_stretch find_stretch(struct draw *draw,
	const struct soft_row *part, uint32_t left, const uint16_t *drawn)
{
	const struct soft_spans *spans = &draw->spans;
	uint32_t count = 1;

	if (spans->tested_last) {
		while (count < left && drawn[count] == *drawn) {
			count++;
		}
		if (*drawn != 0) {
			return (struct soft_stretch){count, false};
		}
		left = count;
	}
	return soft_test(
		draw->soft, part, left, spans->run.z_right, spans->compared);
}

/*
 * Draws the parts of runs that pass soft_test(); if that writes the stencil,
 * only the fragments that pass the alpha test are tested.
 */
static NEVER_INLINE void draw_passing(struct draw *draw, enum soft_place place)
{
	struct soft_spans *spans = &draw->spans;
	struct soft_run *run = &spans->run;
	const struct soft_coordinate s = run->s, t = run->t;
	const struct soft_row *const rows = run->rows, *const end = end_of(run);
	const uint32_t row_count = run->row_count;
	const uintptr_t second = run->second;
	/* these values are not those of a row: parts are drawn one by one */
	const bool single = place == SOFT_ANYWHERE || spans->read_second;
	uint16_t drawn[SOFT_BATCH_ROOM], *at = drawn;
	struct soft_row list[SOFT_BATCH_RUNS], *next = list;

	if (spans->tested_last) {
		test_alpha(draw, place, drawn);
	}
	run->rows = list;
	for (const struct soft_row *row = rows; row < end; row++) {
		struct soft_row part = *row;

		for (uint32_t left = row->count; left > 0; left -= part.count) {
			struct soft_stretch stretch =
				find_stretch(draw, &part, left, at);

			part.count = stretch.count;
			at += stretch.count;
			if (stretch.passes) {
				*next++ = part;
				next = single || next == list + SOFT_BATCH_RUNS
					? draw_parts(draw, place, list, next)
					: next;
			}
			if (stretch.count == left) {
				run->second += 4 * (uintptr_t)left;
				break;
			}
			soft_advance(run, &part, part.count, spans->pixel_log2);
			part.texel += part.texel_right * part.count;
			run->s.at += run->s.right * part.count;
			run->t.at += run->t.right * part.count;
		}
	}
	draw_parts(draw, place, list, next);
	run->rows = rows;
	run->row_count = row_count;
	run->second = second;
	run->s = s;
	run->t = t;
}

/* Draws as a span function does, with colour mask and any tests. */
static void draw_other(const struct soft_run *run, enum soft_place place)
{
	if (run->draw->spans.parted) {
		draw_passing(run->draw, place);
	} else {
		draw_seen(run->draw, place);
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
	if (spans->run.draw->soft->counts) {
		soft_count_runs(spans);
	}
}
