#include "platform/gl/soft/span/sample.h"
#include "platform/gl/soft/span/spans.h"
#include "platform/gl/soft/span/tests.h"
#include "platform/gl/soft/stages/blend_row.h"
#include "platform/gl/soft/vertex/draw.h"

/* The run's fragments for soft_test(). */
static struct soft_tested find_tested(const struct draw *draw)
{
	const struct soft_run *run = &draw->spans.run;

	return (struct soft_tested){
		.place = (size_t)(run->row.depth - draw->soft->buffers.depth),
		.count = run->row.count,
		.z = run->row.z,
		.z_right = run->z_right,
	};
}

/*
 * Depths beside the buffer, which every fragment of a run passes that passes
 * its tests: z is 1 for all of them then. False where none does.
 */
static bool test_aside(struct draw *draw)
{
	struct soft_spans *spans = &draw->spans;

	if (spans->depth_way == SOFT_DEPTH_FREE && !spans->stenciled) {
		memset(spans->aside, 0xFF, spans->run.row.count * 2);
		return true;
	}
	const struct soft_tested tested = find_tested(draw);

	return soft_test(draw->soft, &tested, spans->aside);
}

/* Draws where depths aside pass, which become 1. */
static void draw_aside(
	struct soft_spans *spans, soft_span_function function, uint8_t *pixel)
{
	struct soft_run *run = &spans->run;
	const struct soft_run whole = *run;

	run->row.depth = spans->aside;
	run->row.pixel = pixel;
	run->row.z = 1 << 16;
	run->z_right = 0;
	function(run);
	run->row.depth = whole.row.depth;
	run->row.pixel = whole.row.pixel;
	run->row.z = whole.row.z;
	run->z_right = whole.z_right;
}

/* Writes depths of the fragments that are drawn. */
static void write_depths(const struct draw *draw)
{
	const struct soft_spans *spans = &draw->spans;
	const struct fragment_state *state = &draw->soft->fragment;
	const struct soft_run *run = &spans->run;
	uint32_t z = run->row.z;

	if (!state->depth_test || !state->depth_mask) {
		return;
	}
	for (uint32_t i = 0; i < run->row.count; i++, z += run->z_right) {
		if (spans->aside[i] == 1) {
			run->row.depth[i] = (uint16_t)(z >> 16);
		}
	}
}

/*
 * Depths that are not written, or colours that are blended last: where the
 * function changes a depth by LESS, it draws.
 */
static void draw_beside(
	struct soft_spans *spans, soft_span_function function, bool writes)
{
	struct soft_run *run = &spans->run;
	uint16_t *depth = run->row.depth, *aside = spans->aside;
	uint8_t *pixel = run->row.pixel;
	uint32_t own[SOFT_RUN_PIXELS];

	memcpy(aside, depth, run->row.count * 2);
	run->row.depth = writes ? depth : aside;
	run->row.pixel = spans->blended_last ? (uint8_t *)own : pixel;
	function(run);
	run->row.depth = depth;
	run->row.pixel = pixel;
	if (spans->blended_last) {
		soft_blend_row(run, own, aside, depth);
	}
}

/*
 * With an alpha test a stencil is tested last: fragments that fail the former
 * must not touch it.
 */
static void test_drawn(struct draw *draw)
{
	struct soft_spans *spans = &draw->spans;
	struct soft_tested one = find_tested(draw);

	one.count = 1;
	for (uint32_t i = 0; i < spans->run.row.count; i++, one.place++) {
		if (spans->aside[i] == 1) {
			spans->aside[i] =
				soft_test(draw->soft, &one, &spans->aside[i])
				? 1
				: UINT16_MAX;
		}
		one.z += one.z_right;
	}
}

/* Takes the pixels beside the picture that are drawn. */
static void copy_drawn(struct soft_spans *spans, const uint8_t *own)
{
	const int pixel_log2 = spans->pixel_log2;
	const struct soft_row *row = &spans->run.row;

	for (uint32_t i = 0; i < row->count; i++) {
		if (spans->aside[i] == 1) {
			memcpy(row->pixel + (i << pixel_log2),
				own + (i << pixel_log2),
				(size_t)1 << pixel_log2);
		}
	}
}

/* Tests, then draws beside the picture what passes, where it is to be blended. */
static void draw_tested(
	struct draw *draw, soft_span_function function, bool tests_last)
{
	struct soft_spans *spans = &draw->spans;
	struct soft_run *run = &spans->run;
	uint32_t own[SOFT_RUN_PIXELS];
	uint16_t before[SOFT_RUN_PIXELS];
	uint8_t *at = (uint8_t *)own;

	if (tests_last) {
		memset(spans->aside, 0xFF, run->row.count * 2);
		memcpy(own, run->row.pixel,
			(size_t)run->row.count << spans->pixel_log2);
	} else if (!test_aside(draw)) {
		return;
	}
	if (spans->blended_last) {
		memcpy(before, spans->aside, run->row.count * 2);
	}
	draw_aside(spans, function,
		tests_last || spans->blended_last ? at : run->row.pixel);
	if (tests_last) {
		test_drawn(draw);
	}
	if (spans->blended_last) {
		soft_blend_row(run, own, before, spans->aside);
	} else if (tests_last) {
		copy_drawn(spans, at);
	}
	write_depths(draw);
}

/* Whether a stencil changes, or hides, what the run draws. */
static bool is_stenciled(const struct draw *draw)
{
	const struct soft_row *row = &draw->spans.run.row;

	return draw->spans.stenciled &&
		!soft_stencil_keeps(draw->soft,
			(size_t)(row->depth - draw->soft->buffers.depth),
			row->count);
}

/* Every depth test but that of the functions themselves. */
static void draw_by_way(struct draw *draw, enum soft_place place)
{
	struct soft_spans *spans = &draw->spans;
	soft_span_function function = spans->function[place];

	if (is_stenciled(draw)) {
		draw_tested(draw, function, spans->alpha_tested);
		return;
	}
	switch (spans->depth_way) {
	case SOFT_DEPTH_DIRECT:
		function(&spans->run);
		break;
	case SOFT_DEPTH_ASIDE:
		draw_beside(spans, function, draw->soft->fragment.depth_mask);
		break;
	default:
		draw_tested(draw, function, false);
		break;
	}
}

/* Draws beside the picture, and takes from there what the mask lets through. */
static void draw_masked(struct draw *draw, enum soft_place place)
{
	struct soft_spans *spans = &draw->spans;
	struct soft_run *run = &spans->run;
	const uint32_t mask = spans->color_mask;
	const uint32_t bytes = run->row.count << spans->pixel_log2;
	uint8_t *pixel = run->row.pixel;
	uint32_t own[SOFT_RUN_PIXELS];
	uint8_t *at = (uint8_t *)own;

	memcpy(own, pixel, bytes);
	run->row.pixel = at;
	draw_by_way(draw, place);
	run->row.pixel = pixel;
	for (uint32_t i = 0; i < bytes; i++) {
		uint8_t own_bits = (uint8_t)(mask >> i % 4 * 8);

		pixel[i] =
			(uint8_t)((pixel[i] & ~own_bits) | (at[i] & own_bits));
	}
}

static void test_anywhere(const struct soft_run *run)
{
	draw_by_way(run->draw, run->draw->spans.anywhere);
}

static void test_inside(const struct soft_run *run)
{
	draw_by_way(run->draw, run->draw->spans.inside);
}

static void mask_anywhere(const struct soft_run *run)
{
	draw_masked(run->draw, run->draw->spans.anywhere);
}

static void mask_inside(const struct soft_run *run)
{
	draw_masked(run->draw, run->draw->spans.inside);
}

void soft_set_functions(
	struct soft_spans *spans, const soft_span_function function[SOFT_PLACES])
{
	bool direct = spans->depth_way == SOFT_DEPTH_DIRECT && !spans->stenciled;

	spans->function = function;
	spans->draw_anywhere = direct ? function[spans->anywhere] : test_anywhere;
	spans->draw = direct ? function[spans->inside] : test_inside;
	if (spans->color_mask != UINT32_MAX) {
		spans->draw_anywhere = mask_anywhere;
		spans->draw = mask_inside;
	}
	if (spans->draw_scaled) {
		spans->scaled[0] = spans->draw_anywhere;
		spans->scaled[1] = spans->draw;
		spans->draw = spans->draw_scaled;
	}
}
