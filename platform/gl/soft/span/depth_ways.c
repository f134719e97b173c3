#include "platform/gl/soft/span/depth_ways.h"

#include <string.h>

#include "platform/gl/soft/vertex/draw.h"

/* GL's comparisons: the low bits say which of less, equal, greater pass. */
static bool passes(GLenum function, uint32_t a, uint32_t b)
{
	return function >> (a < b ? 0 : a == b ? 1 : 2) & 1;
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
	uint32_t z = run->z;

	if (spans->depth_way == SOFT_DEPTH_FREE) {
		memset(spans->aside, 0xFF, run->count * 2);
	} else if (spans->depth_way == SOFT_DEPTH_LAST) {
		const GLenum function = state->depth_function;
		const uint16_t *depth = run->depth;

		for (uint32_t i = 0; i < run->count; i++, z += run->z_right) {
			bool through = passes(function, z >> 16, depth[i]);

			spans->aside[i] = (uint16_t)-through;
		}
	} else {
		bool through[SPAN_PIXELS];
		/* The buffers are as wide: x counts through all of their rows. */
		const struct span span = {
			.x = (int)(run->depth - draw->soft->buffers.depth),
			.count = (int)run->count,
			.value[DEPTH] = z >> 6,
			.step[DEPTH] = (int32_t)run->z_right >> 6,
		};

		soft_test_span(draw, &span, through);
		for (uint32_t i = 0; i < run->count; i++) {
			spans->aside[i] = through[i] ? UINT16_MAX : 0;
		}
	}
}

static void draw_tested(struct draw *draw, soft_span_function function)
{
	struct soft_spans *spans = &draw->spans;
	struct soft_run *run = &spans->run;
	uint16_t *depth = run->depth;
	uint32_t z = run->z, z_right = run->z_right;

	if (spans->depth_way == SOFT_DEPTH_KEPT) {
		memcpy(spans->aside, depth, run->count * 2);
		run->depth = spans->aside;
		function(run);
		run->depth = depth;
		return;
	}
	test_aside(draw);
	run->depth = spans->aside;
	run->z = 1 << 16;
	run->z_right = 0;
	function(run);
	run->depth = depth;
	run->z = z;
	run->z_right = z_right;
	if (spans->depth_way != SOFT_DEPTH_LAST ||
		!draw->soft->fragment.depth_mask) {
		return;
	}
	for (uint32_t i = 0; i < run->count; i++, z += z_right) {
		if (spans->aside[i] == 1) {
			depth[i] = (uint16_t)(z >> 16);
		}
	}
}

static void test_anywhere(const struct soft_run *run)
{
	draw_tested(run->draw, run->draw->spans.function[0]);
}

static void test_inside(const struct soft_run *run)
{
	draw_tested(run->draw, run->draw->spans.function[1]);
}

void soft_set_functions(
	struct soft_spans *spans, const soft_span_function function[2])
{
	bool direct = spans->depth_way == SOFT_DEPTH_DIRECT;

	spans->function = function;
	spans->draw_anywhere = direct ? function[0] : test_anywhere;
	spans->draw = direct ? function[1] : test_inside;
}
