/*
 * Small triangles without a texture, in any state: set up in 32 bits, and their
 * runs listed for one call of the span function.
 */
#include "platform/gl/soft/fast/narrow.h"
#include "platform/gl/soft/span/colors.h"

/* A triangle whose runs are listed: values of column 0. */
struct listed {
	struct draw *draw;
	const struct setup *setup;
	struct frame frame;
	struct narrow narrow;         /* its edges and depths */
	struct plane red_blue, green; /* in a run's number formats */
	struct plane alpha, fog;      /* 8.16 */
	bool alpha_moves;
};

static ALWAYS_INLINE struct plane find_scaled(
	const struct listed *listed, int name, int32_t half, int32_t scale)
{
	const struct frame *frame = &listed->frame;
	const struct delta delta = frame_find_attribute(listed->setup, name);
	const struct plane plane =
		frame_find_near(frame, delta.first, delta.d1, delta.d2);

	return scale_color(&plane, frame->column, half, scale);
}

static ALWAYS_INLINE void set_listed_colors(struct listed *listed)
{
	const struct soft_spans *spans = &listed->draw->spans;
	const struct soft_scales *scales = &spans->scales;
	struct plane alpha = {0};

	if (spans->alpha_read) {
		const struct delta delta =
			frame_find_attribute(listed->setup, ALPHA);

		alpha = frame_find_plane(&listed->frame, &delta);
	} else if (!listed->draw->attributes) { /* only depths are written */
		listed->red_blue = listed->green = listed->alpha = alpha;
		listed->alpha_moves = false;
		return;
	}
	listed->red_blue =
		pair_colors(find_scaled(listed, RED, scales->red_blue_half,
				    scales->red_blue),
			find_scaled(listed, BLUE, scales->red_blue_half,
				scales->red_blue));
	listed->green =
		find_scaled(listed, GREEN, scales->green_half, scales->green);
	listed->alpha_moves = (alpha.dx | alpha.dy) != 0;
	if (!listed->alpha_moves) {
		listed->green.start += alpha.start >> 9 << 16;
	}
	listed->alpha = alpha;
}

static ALWAYS_INLINE void set_fog(struct listed *listed)
{
	listed->fog = (struct plane){listed->draw->raster.constant[FOG], 0, 0};
	if (listed->draw->fogged) {
		const struct delta delta =
			frame_find_attribute(listed->setup, FOG);

		listed->fog = frame_find_plane(&listed->frame, &delta);
	}
}

static ALWAYS_INLINE void set_steps(const struct listed *listed)
{
	struct soft_run *run = &listed->draw->spans.run;

	run->z_right = listed->narrow.z_right;
	run->red_blue_right = (uint32_t)listed->red_blue.dx;
	run->green_alpha_right = (uint32_t)listed->green.dx +
		((uint32_t)soft_alpha_step(listed->alpha.dx) << 16);
	run->fog_right = scale_step(listed->fog.dx, SOFT_FOG_SCALE);
}

/* What changes from run to run, besides red, green and blue. */
struct list_kind {
	bool alpha, fog;
};

/* A value at column x of a row that the plane starts in. */
static ALWAYS_INLINE uint32_t find_at(const struct plane *plane, uint32_t x)
{
	return plane->start + (uint32_t)plane->dx * x;
}

static ALWAYS_INLINE void set_run(const struct listed *listed,
	const struct list_kind kind, uint32_t x, struct soft_row *row)
{
	const struct narrow *narrow = &listed->narrow;

	row->z = narrow->row.z + narrow->z_right * x;
	row->red_blue = find_at(&listed->red_blue, x);
	row->green_alpha = find_at(&listed->green, x);
	if (kind.alpha) {
		row->green_alpha += find_at(&listed->alpha, x) >> 9 << 16;
	}
	row->fog =
		(uint32_t)mul_high((int32_t)(kind.fog ? find_at(&listed->fog, x)
						      : listed->fog.start),
			SOFT_FOG_SCALE);
}

static ALWAYS_INLINE void step_down(struct plane *plane)
{
	plane->start += (uint32_t)plane->dy;
}

static ALWAYS_INLINE void leave_row(
	struct listed *listed, const struct list_kind kind)
{
	struct narrow_row *row = &listed->narrow.row;
	const struct narrow_row *down = &listed->narrow.down;

	row->depth += down->depth;
	row->z += down->z;
	row->left += down->left;
	row->right += down->right;
	step_down(&listed->red_blue);
	step_down(&listed->green);
	if (kind.alpha) {
		step_down(&listed->alpha);
	}
	if (kind.fog) {
		step_down(&listed->fog);
	}
}

/* Lists all runs; returns the end of the list. */
static ALWAYS_INLINE struct soft_row *list_rows(struct listed *listed,
	const struct list_kind kind, struct soft_row *out)
{
	struct narrow *narrow = &listed->narrow;
	const struct narrow_row *row = &narrow->row;
	const int more_bytes = listed->draw->spans.pixel_log2 - 1;
	const uintptr_t pixels = narrow->pixels + 2;

	for (int rows = narrow->rows + narrow->more; rows > 0; rows--) {
		int32_t x, count;

		if (rows == narrow->more) {
			narrow_set_edge(
				narrow, narrow->middle_left, narrow->lower);
		}
		x = (int32_t)row->left >> 16;
		count = ((int32_t)row->right >> 16) - x;
		if (count > 0) {
			const uintptr_t depth = row->depth + 2 * (uintptr_t)x;

			out->depth = (uint16_t *)depth;
			out->pixel = (uint8_t *)(pixels + (depth << more_bytes));
			out->count = (uint32_t)count;
			set_run(listed, kind, (uint32_t)x, out++);
		}
		leave_row(listed, kind);
	}
	return out;
}

static ALWAYS_INLINE void draw_listed(struct listed *listed)
{
	struct soft_row row[SOFT_LISTED_SIZE], *end;

	if (listed->draw->fogged) {
		end = listed->alpha_moves
			? list_rows(listed, (struct list_kind){true, true}, row)
			: list_rows(
				  listed, (struct list_kind){.fog = true}, row);
	} else {
		end = listed->alpha_moves
			? list_rows(listed, (struct list_kind){.alpha = true},
				  row)
			: list_rows(listed, (struct list_kind){false}, row);
	}
	soft_draw_runs(&listed->draw->spans, row, end);
}

/*
 * Thin triangles are refused, whose colours may be steep (span/begin.c): a step
 * to the right is at most the colours' range over the thickness, twice the area
 * over the extent: 256 steps of 255 in triangles that are a pixel thick, and 32
 * in those of eight pixels.
 */
bool soft_fill_small(struct draw *draw, struct setup *setup)
{
	const int rows = setup->bottom - setup->top;
	struct listed listed;

	if (!setup->inside || draw->fourth ||
		!rows_are_linear(draw, setup, rows_color_tolerance(draw)) ||
		(uint32_t)setup->area <
			(uint32_t)(setup->extent * (rows < 16 ? 16 : 128))) {
		return false;
	}
	listed.draw = draw;
	listed.setup = setup;
	frame_find(setup, &listed.frame);
	narrow_set_edges(
		draw, setup, listed.frame.middle_left, true, &listed.narrow);
	narrow_set_depth(
		draw, setup, &listed.frame, 0, draw->offset, &listed.narrow);
	set_listed_colors(&listed);
	set_fog(&listed);
	set_steps(&listed);
	draw_listed(&listed);
	draw->raster.top = RASTER_LISTED;
	return true;
}
