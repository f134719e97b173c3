/*
 * Walks the rows of a triangle that needs perspective correction (set_up.c),
 * and cuts them into runs for the span functions: values are divided by 1 / w
 * every 16 to 64 pixels. walk_list.c walks the rows of all other triangles.
 */
#include "platform/gl/soft/span/walk.h"
#include "platform/gl/soft/raster/frame.h"
#include "platform/gl/soft/span/points.h"

/* Draws a run of count pixels from x on, whose values and steps are set. */
static ALWAYS_INLINE void draw_run(
	const struct line *line, const struct walk_kind kind, int x, int count)
{
	struct soft_spans *spans = &line->draw->spans;
	struct soft_run *run = &spans->run;

	run->row.count = (uint32_t)count;
	run->row.depth = line->depth + x;
	run->row.pixel = line->pixel + (x << spans->pixel_log2);
	run->row.z = (uint32_t)find_value(line, DEPTH, x) << 6;
	run->row.place = (uint32_t)line->row << 16 | (uint32_t)x;
	if (!kind.textured || spans->made ||
		soft_find_window(&spans->levels[0].view, run)) {
		spans->draw(run);
	} else {
		soft_draw_across(spans);
	}
}

/* Steps a point's values by count pixels. */
static ALWAYS_INLINE void step_point(const struct walk_kind kind,
	struct row_point *at, const struct change *change, int count)
{
	struct colors *c = &at->colors;
	const struct colors *step = &change->colors;

	at->texels.s = step_by(at->texels.s, change->texels.s, count);
	at->texels.t = step_by(at->texels.t, change->texels.t, count);
	if (kind.colors_divided) {
		*c = (struct colors){step_by(c->red, step->red, count),
			step_by(c->green, step->green, count),
			step_by(c->blue, step->blue, count),
			step_by(c->alpha, step->alpha, count),
			step_by(c->fog, step->fog, count)};
	}
}

/*
 * Draws the pixels from x to right, whose values are linear between two points
 * that are so many steps apart.
 */
static ALWAYS_INLINE void draw_between(const struct line *line,
	const struct walk_kind kind, int x, int right,
	const struct row_point *from, const struct row_point *to, int steps)
{
	struct soft_spans *spans = &line->draw->spans;
	const struct change change = set_steps(line, kind, from, to, steps);
	struct row_point at = *from;
	const int most = kind.textured
		? rows_find_run_pixels(
			  line->draw, change.texels.s, change.texels.t)
		: spans->plain_pixels;

	for (;; x += most) {
		const int count = right - x < most ? right - x : most;

		if (kind.textured && spans->made) {
			spans->made_at =
				(struct soft_made_at){at.texels, change.texels};
		} else if (kind.textured) {
			soft_set_texels(&spans->levels[0].view, at.texels,
				change.texels, (uint32_t)count, &spans->run);
		}
		if (kind.colors_divided) {
			set_colors(spans, at.colors.red, at.colors.green,
				at.colors.blue);
			set_more_colors(spans, &spans->run.row, at.colors.alpha,
				at.colors.fog);
		} else if (kind.colored) {
			place_colors(line, x, count);
		}
		draw_run(line, kind, x, count);
		if (right - x <= most) {
			return;
		}
		step_point(kind, &at, &change, most);
	}
}

static NEVER_INLINE void set_row_level(
	struct draw *draw, struct point divisor, struct texels texels)
{
	draw->spans.level_unknown = false;
	soft_set_level(draw, 0,
		soft_rows_find_lod(&draw->raster, &divisor, 0, texels));
}

/*
 * The larger change of s and t of the second texture between two columns. The
 * caller's line stays in registers, as no pointer to it is given.
 */
static NEVER_INLINE uint32_t find_second_change(
	struct draw *draw, int row, int left, int right)
{
	const struct walk_kind kind = {.textured = true};
	const struct line line = {.draw = draw, .row = row};
	const struct texels from = find_point(&line, kind, 1, left).texels;
	const struct texels to = find_point(&line, kind, 1, right).texels;

	return larger(distance(from.s, to.s), distance(from.t, to.t));
}

static ALWAYS_INLINE void row_divided(const struct line *line,
	const struct walk_kind kind, int left, int right)
{
	int steps = right - left - 1, x = left;
	struct row_point from = find_point(line, kind, 0, left), to, end = from;

	if (steps > 0) {
		end = find_point(line, kind, 0, right - 1);
	}
	if (kind.textured && line->draw->spans.level_by_row &&
		((line->row + line->top) % ROWS_OF_LEVEL == 0 ||
			line->draw->spans.level_unknown)) {
		set_row_level(line->draw, from.divisor, from.texels);
	}
	/* If 1 / w is the same at both ends, the whole row is linear. */
	if (steps >= PERSPECTIVE_STEP &&
		(from.divisor.q != end.divisor.q || steps > SMALL_EXTENT)) {
		uint32_t most = line->draw->texture[1].used
			? find_second_change(
				  line->draw, line->row, left, right - 1)
			: 0;
		int spacing = find_spacing(
			line->draw, kind, &from, &end, steps, most);

		for (; right - x > spacing; x += spacing) {
			to = find_point(line, kind, 0, x + spacing);
			draw_between(line, kind, x, x + spacing, &from, &to,
				spacing);
			from = to;
		}
	}
	draw_between(line, kind, x, right, &from, &end, right - x - 1);
}

/* The row under way, and the edges from there on. */
struct rows {
	struct line line;
	struct band_edges edges;
};

/* Walks the rows between two edges. */
static ALWAYS_INLINE void walk_part(
	struct rows *rows, const struct walk_kind kind)
{
	struct rows own = *rows; /* in registers */
	struct line *line = &own.line;
	const struct buffers *buffers = &line->draw->soft->buffers;
	const int width = buffers->width;
	const int stride_bytes = buffers->target.stride_bytes;
	const struct clip_box box = line->draw->box;

	for (; own.edges.rows > 0; band_next_row(&own.edges)) {
		int left = band_column(&own.edges, BAND_LEFT);
		int right = band_column(&own.edges, BAND_RIGHT);

		left = left > box.left ? left : box.left;
		right = right < box.right ? right : box.right;
		if (left < right) {
			row_divided(line, kind, left, right);
		}
		line->row++;
		line->depth += width;
		line->pixel += stride_bytes;
	}
	*rows = own;
}

static void walk(
	struct draw *draw, const struct setup *setup, void (*part)(void *rows))
{
	const struct buffers *buffers = &draw->soft->buffers;
	int y = raster_first_row(draw, setup);
	struct rows rows = {
		.line = {
			.draw = draw,
			.row = y - setup->top,
			.top = setup->top,
			.depth = buffers->depth + (ptrdiff_t)y * buffers->width,
			.pixel = buffers->target.data +
				(ptrdiff_t)y * buffers->target.stride_bytes,
		}};

	frame_draw_bands(draw, setup, false, setup->middle_left, &rows.edges,
		part, &rows);
}

#define PART(name, ...)                                           \
	static void part_##name(void *rows)                       \
	{                                                         \
		walk_part(rows, (struct walk_kind){__VA_ARGS__}); \
	}

PART(plain, .colored = true, .colors_divided = true)
PART(still, .textured = true)
PART(colored, .textured = true, .colored = true)
PART(colored_divided, .textured = true, .colored = true, .colors_divided = true)

void soft_walk_rows(struct draw *draw, const struct setup *setup)
{
	const struct raster *raster = &draw->raster;
	const uint32_t moving =
		soft_begin_walk(draw, setup->bottom - setup->top);

	if (!raster->perspective) {
		soft_draw_list(draw, setup, moving);
		return;
	}
	soft_begin_steps(draw, moving);
	if (!draw->spans.textured) {
		walk(draw, setup, part_plain);
		return;
	}
	walk(draw, setup,
		!moving                          ? part_still
			: raster->colors_divided ? part_colored_divided
						 : part_colored);
}

/* Draws a triangle by span functions, in any state. */
void soft_rows_fill(struct draw *draw, struct setup *setup)
{
	const int size = setup->columns + setup->bottom - setup->top;

	if (!soft_is_hidden(draw, setup) &&
		(size > draw->spans.small_size ||
			!soft_fill_small(draw, setup))) {
		soft_raster_set_up(draw, setup);
		soft_walk_rows(draw, setup);
	}
}
