#include "platform/gl/soft/span/sample.h"
#include "platform/gl/soft/span/spans.h"
#include "platform/gl/soft/span/tests.h"
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
 * its tests: z is 1 for all of them then.
 */
static void test_aside(struct draw *draw)
{
	struct soft_spans *spans = &draw->spans;
	const struct soft_run *run = &spans->run;
	const struct fragment_state *state = &draw->soft->fragment;
	uint32_t z = run->row.z;

	if (spans->depth_way == SOFT_DEPTH_FREE) {
		memset(spans->aside, 0xFF, run->row.count * 2);
	} else if (spans->depth_way == SOFT_DEPTH_LAST) {
		const GLenum function = state->depth_function;
		const uint16_t *depth = run->row.depth;

		for (uint32_t i = 0; i < run->row.count; i++, z += run->z_right) {
			bool through =
				soft_compares(function, z >> 16, depth[i]);

			spans->aside[i] = (uint16_t)-through;
		}
	} else {
		bool through[SOFT_RUN_PIXELS];
		const struct soft_tested tested = find_tested(draw);

		soft_test(draw->soft, &tested, through);
		for (uint32_t i = 0; i < run->row.count; i++) {
			spans->aside[i] = through[i] ? UINT16_MAX : 0;
		}
	}
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

static void draw_tested(struct draw *draw, soft_span_function function)
{
	struct soft_spans *spans = &draw->spans;
	struct soft_run *run = &spans->run;
	uint16_t *depth = run->row.depth;
	uint32_t z = run->row.z, z_right = run->z_right;

	if (spans->depth_way == SOFT_DEPTH_KEPT) {
		memcpy(spans->aside, depth, run->row.count * 2);
		run->row.depth = spans->aside;
		function(run);
		run->row.depth = depth;
		return;
	}
	test_aside(draw);
	draw_aside(spans, function, run->row.pixel);
	if (spans->depth_way != SOFT_DEPTH_LAST ||
		!draw->soft->fragment.depth_mask) {
		return;
	}
	for (uint32_t i = 0; i < run->row.count; i++, z += z_right) {
		if (spans->aside[i] == 1) {
			depth[i] = (uint16_t)(z >> 16);
		}
	}
}

/*
 * With an alpha test and a stencil, which fragments that fail the former must
 * not touch: drawn beside the picture first, then the others tested.
 */
static void draw_then_test(struct draw *draw, soft_span_function function)
{
	struct soft_spans *spans = &draw->spans;
	struct soft_run *run = &spans->run;
	const int pixel_log2 = spans->pixel_log2;
	uint8_t own[SOFT_RUN_PIXELS * 4], *pixel = run->row.pixel;
	struct soft_tested one = find_tested(draw);
	bool through;

	memcpy(own, pixel, (size_t)run->row.count << pixel_log2);
	memset(spans->aside, 0xFF, run->row.count * 2);
	draw_aside(spans, function, own);
	one.count = 1;
	for (uint32_t i = 0; i < run->row.count; i++, one.place++) {
		if (spans->aside[i] == 1) {
			soft_test(draw->soft, &one, &through);
			if (through) {
				memcpy(pixel + (i << pixel_log2),
					own + (i << pixel_log2),
					(size_t)1 << pixel_log2);
			}
		}
		one.z += one.z_right;
	}
}

/*
 * At most what is there is less than one more. No fragment's depth is 65535,
 * see soft_depth_units(), so that where 65535 is there nothing is lost. Depths
 * go two at a time; one behind the run is left as it is.
 */
static void draw_at_most(struct draw *draw, soft_span_function function)
{
	struct soft_spans *spans = &draw->spans;
	struct soft_run *run = &spans->run;
	uint8_t *depth = (uint8_t *)run->row.depth;
	uint32_t pairs = run->row.count / 2, odd = run->row.count % 2;
	uint32_t aside[SOFT_RUN_PIXELS / 2 + 1];

	for (uint32_t i = 0; i < pairs; i++) {
		aside[i] =
			HALVES_ADD_LIMITED(load_32(depth + 4 * i), 0x00010001);
	}
	if (odd) {
		aside[pairs] = HALVES_ADD_LIMITED(load_16(depth + 4 * pairs), 1);
	}
	run->row.depth = (uint16_t *)aside;
	function(run);
	run->row.depth = (uint16_t *)(void *)depth;
	if (!draw->soft->fragment.depth_mask) {
		return;
	}
	for (uint32_t i = 0; i < pairs; i++) {
		uint32_t least = least_halves(load_32(depth + 4 * i), aside[i]);

		memcpy(depth + 4 * i, &least, 4);
	}
	if (odd) {
		uint16_t *last = run->row.depth + run->row.count - 1;
		uint16_t own = (uint16_t)aside[pairs];

		*last = own < *last ? own : *last;
	}
}

/* Every depth test but that of the functions themselves. */
static void draw_by_way(struct draw *draw, int inside)
{
	soft_span_function function = draw->spans.function[inside];

	switch (draw->spans.depth_way) {
	case SOFT_DEPTH_DIRECT:
		function(&draw->spans.run);
		break;
	case SOFT_DEPTH_LEQUAL:
		draw_at_most(draw, function);
		break;
	case SOFT_DEPTH_AFTER:
		draw_then_test(draw, function);
		break;
	default:
		draw_tested(draw, function);
		break;
	}
}

/* Draws beside the picture, and takes from there what the mask lets through. */
static void draw_masked(struct draw *draw, int inside)
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
	draw_by_way(draw, inside);
	run->row.pixel = pixel;
	for (uint32_t i = 0; i < bytes; i++) {
		uint8_t own_bits = (uint8_t)(mask >> i % 4 * 8);

		pixel[i] =
			(uint8_t)((pixel[i] & ~own_bits) | (at[i] & own_bits));
	}
}

static void test_anywhere(const struct soft_run *run)
{
	draw_by_way(run->draw, 0);
}

static void test_inside(const struct soft_run *run)
{
	draw_by_way(run->draw, 1);
}

static void mask_anywhere(const struct soft_run *run)
{
	draw_masked(run->draw, 0);
}

static void mask_inside(const struct soft_run *run)
{
	draw_masked(run->draw, 1);
}

void soft_set_functions(
	struct soft_spans *spans, const soft_span_function function[2])
{
	bool direct = spans->depth_way == SOFT_DEPTH_DIRECT;

	spans->function = function;
	spans->draw_anywhere = direct ? function[0] : test_anywhere;
	spans->draw = direct ? function[1] : test_inside;
	if (spans->color_mask != UINT32_MAX) {
		spans->draw_anywhere = mask_anywhere;
		spans->draw = mask_inside;
	}
}
