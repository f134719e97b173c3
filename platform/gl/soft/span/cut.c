/* Cuts runs at the edges of a level's texels. */
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/span/texels.h"

enum {
	/* runs and repetitions of a texture that are shorter are not cut */
	FEW_PIXELS = 32,
};

/* How many whole steps fit into distance, at most SOFT_RUN_PIXELS - 1. */
static uint32_t count_steps(uint32_t distance, uint32_t step)
{
	uint32_t count = 0;

	if (distance / SOFT_RUN_PIXELS >= step) {
		return SOFT_RUN_PIXELS - 1;
	}
	for (uint32_t part = SOFT_RUN_PIXELS / 2; part > 0; part /= 2) {
		if (distance >= step * part) {
			distance -= step * part;
			count += part;
		}
	}
	return count;
}

/* Neighbouring pixels whose texels all lie inside of the window, or do not. */
struct stretch {
	uint32_t count;
	struct soft_coordinate from; /* clamped, to draw them with */
	bool inside;
};

/*
 * The stretch from a coordinate on that is beyond the first or the last texel:
 * its pixels show that texel.
 */
static NEVER_INLINE struct stretch find_clamped(struct soft_coordinate given,
	const struct soft_axis *axis, uint32_t step)
{
	const bool below = (int32_t)given.at < 0;
	const int32_t right = (int32_t)given.right;
	uint32_t beyond = below ? ~given.at : given.at - axis->room;
	bool returns = below ? right > 0 : right < 0;

	return (struct stretch){
		returns ? count_steps(beyond, step) + 1 : SOFT_RUN_PIXELS,
		{below ? 0 : axis->last << SOFT_TEXEL_FRACTION, 0}, true};
}

/*
 * The stretch from a coordinate to the next edge of the window, at most left
 * pixels. Runs that repeat are only cut if few stretches follow, as a call for
 * each takes longer than wrapping a few pixels.
 */
static ALWAYS_INLINE struct stretch find_stretch(struct soft_coordinate given,
	const struct soft_axis *axis, uint32_t left)
{
	const uint32_t room = axis->room, mask = axis->mask;
	const uint32_t at = given.at & mask, right = given.right;
	const uint32_t step = raster_size((int32_t)right);
	const bool inside = at < room, clamped = mask == UINT32_MAX;
	const bool whole = inside && at + right * (left - 1) < room;
	uint32_t first = inside ? 0 : room, end = inside ? room - 1 : mask;

	if (whole ||
		(!clamped &&
			(room > mask || step > mask / FEW_PIXELS ||
				left < FEW_PIXELS))) {
		return (struct stretch){left, {at, right}, whole};
	}
	if (clamped && !inside) {
		return find_clamped(given, axis, step);
	}
	return (struct stretch){
		count_steps((int32_t)right < 0 ? at - first : end - at, step) + 1,
		{at, right}, inside};
}

static void set_coordinates(struct soft_run *run, struct soft_coordinate s,
	struct soft_coordinate t)
{
	run->s = s;
	run->t = t;
	run->row.texel_right = (t.right << 16) + s.right;
}

void soft_cut_run(struct soft_run *run, const struct soft_view *view,
	const soft_span_function function[2], int pixel_log2)
{
	/* coordinates are clamped by now: no wrapping, and no limit */
	const struct soft_axis any = {.mask = UINT32_MAX, .room = INT32_MAX};
	const struct soft_view all = {.texel_log2 = view->texel_log2,
		.large = view->large,
		.s = any,
		.t = any};
	const uint8_t *first_texel = run->first_texel;
	struct soft_coordinate own_s = run->s, own_t = run->t;
	uint32_t left = run->row.count, count;

	run->first_texel = run->texels;
	for (;;) {
		const struct stretch s = find_stretch(own_s, &view->s, left);
		const struct stretch t = find_stretch(own_t, &view->t, left);

		count = s.count < t.count ? s.count : t.count;
		count = count < left ? count : left;
		run->row.count = count;
		set_coordinates(run, s.from, t.from);
		function[s.inside && t.inside && soft_find_window(&all, run)](
			run);
		left -= count;
		if (left == 0) {
			break;
		}
		soft_advance(run, &run->row, count, pixel_log2);
		own_s.at += own_s.right * count;
		own_t.at += own_t.right * count;
	}
	set_coordinates(run, own_s, own_t);
	run->first_texel = first_texel;
}

void soft_draw_across(struct soft_spans *spans)
{
	const soft_span_function function[2] = {spans->draw_anywhere,
		spans->read_second ? spans->seconded : spans->draw};
	uint32_t second[SOFT_RUN_PIXELS + 3]; /* see SOFT_BATCH_ROOM */

	if (spans->read_second) {
		spans->read_second(spans->run.draw, second);
	}
	soft_cut_run(&spans->run, &spans->levels[0].view, function,
		spans->pixel_log2);
}
