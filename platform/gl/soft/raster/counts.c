/* Counts what is drawn, in soft->counts, if a program has asked for that. */
#include "platform/gl/gl_counts.h"
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/vertex/cache.h"

#include <limits.h>
#include <math.h>
#include <string.h>

enum {
	NOT_SET_UP = INT_MIN, /* in raster.top: no planes or list were made */
	/* vertices that the processor's second-level cache is taken to hold */
	CACHED_VERTICES = 1500
};

/* What a row without pixels costs of one with some: its edges are found. */
static const double empty_row = 0.25;

/* The kind of work of the last triangle, which span functions drew. */
static enum gl_work_kind kind_of_spans(const struct draw *draw)
{
	bool planes = draw->raster.top != NOT_SET_UP &&
		draw->raster.top != RASTER_LISTED;
	bool tested = draw->spans.alpha_tested;
	bool mixed = draw->blended || tested || (planes && draw->added);

	if (!draw->texture[0].used) {
		return mixed ? GL_WORK_MIXED : GL_WORK_SPANS;
	}
	if (tested) {
		return planes ? GL_WORK_TESTED_SPANS : GL_WORK_TESTED;
	}
	if (!mixed && draw->raster.top != NOT_SET_UP &&
		!draw->spans.levels[0].linear) {
		return GL_WORK_SPANS_NEAREST;
	}
	if (!planes) {
		return mixed ? GL_WORK_MIXED_TEXTURED : GL_WORK_TEXTURED;
	}
	if (draw->raster.perspective) {
		return mixed ? GL_WORK_MIXED_DIVIDED : GL_WORK_SPANS_DIVIDED;
	}
	return mixed ? GL_WORK_MIXED_SPANS : GL_WORK_SPANS_TEXTURED;
}

/* The kind of work of the last triangle. */
static enum gl_work_kind kind_of(const struct draw *draw)
{
	fill_function fill = draw->counted_fill;
	const bool narrow =
		fill == soft_fill_narrow || fill == soft_fill_narrow_offset;

	if (fill == soft_fill_flat) {
		return GL_WORK_FLAT;
	}
	if (fill == soft_rows_fill && draw->spans.whole_rows) {
		return GL_WORK_BACKDROP;
	}
	if (fill != soft_rows_fill && !narrow && fill != soft_fill_textured) {
		return GL_WORK_LUMINANCE;
	}
	return narrow && draw->raster.top == NOT_SET_UP ? GL_WORK_PLAIN
							: kind_of_spans(draw);
}

/*
 * Whether the last triangle's colours were interpolated. Paths for one colour
 * and for luminance never do that; span functions only if corners differ.
 */
static bool colors_move(const struct draw *draw, enum gl_work_kind kind,
	const struct setup *setup)
{
	const struct vertex *const *v = setup->v;

	if (kind == GL_WORK_FLAT || kind == GL_WORK_BACKDROP ||
		kind == GL_WORK_LUMINANCE) {
		return false;
	}
	if (draw->counted_fill != soft_rows_fill &&
		draw->raster.top == NOT_SET_UP) {
		return true;
	}
	for (int i = RED; i <= ALPHA; i++) {
		if ((draw->attributes >> i & 1) &&
			(v[0]->attribute[i] != v[1]->attribute[i] ||
				v[0]->attribute[i] != v[2]->attribute[i])) {
			return true;
		}
	}
	return false;
}

/* Counts a triangle that was drawn, as each kind of work that it is. */
static void add_work(const struct draw *draw, const struct setup *setup,
	double rows, double pixels)
{
	struct gl_work *work = draw->soft->counts->work;
	const enum gl_work_kind kind = kind_of(draw);
	const bool luminance = kind == GL_WORK_LUMINANCE;
	/* These have functions of their own instead of those of spans. */
	const bool own = luminance || kind == GL_WORK_BACKDROP ||
		kind == GL_WORK_FLAT || kind == GL_WORK_PLAIN;
	bool is[GL_WORK_KINDS] = {
		[GL_WORK_COLORED] = colors_move(draw, kind, setup),
		[GL_WORK_DEEP] = luminance && draw->spans.depth_written,
		[GL_WORK_BENT] = draw->raster.bent,
		[GL_WORK_SECOND] = draw->texture[1].used || draw->spans.joined,
		[GL_WORK_PARTED] = !own && draw->spans.parted,
		[GL_WORK_ADDED] = !own && draw->blended &&
			draw->spans.finish == SOFT_MIXED &&
			!draw->spans.alpha_tested,
	};

	is[kind] = true;
	for (int i = 0; i < GL_WORK_KINDS; i++) {
		if (is[i]) {
			work[i].triangles += 1.0;
			work[i].rows += rows;
			work[i].pixels += pixels;
		}
	}
	work[GL_WORK_CROSSED].triangles += draw->counted_across > 0;
	work[GL_WORK_CROSSED].rows += draw->counted_across;
	work[GL_WORK_CROSSED].pixels += draw->counted_across_pixels;
}

/* Whether a vertex is counted for the first time; clipped ones always are. */
static bool is_new(struct draw *draw, const struct vertex *vertex)
{
	uintptr_t at = (uintptr_t)vertex - (uintptr_t)draw->cache;
	size_t slot = at / sizeof(*vertex);
	bool is_known;

	if (slot >= VERTEX_CACHE) {
		return true;
	}
	is_known = draw->counted[slot] == draw->place[slot].tag;
	draw->counted[slot] = draw->place[slot].tag;
	return !is_known;
}

/* Whether a depth is behind the buffer's, apart from a unit of rounding. */
static bool is_behind(const struct draw *draw, int32_t depth, int32_t there)
{
	GLenum function = draw->soft->fragment.depth_function;

	return (function == GL_LESS && depth + 1 >= there) ||
		(function == GL_LEQUAL && depth - 1 > there);
}

/*
 * Whether the triangle covers the pixel and lies behind the depth buffer there.
 * The pixel's centre is moved a little, so that it lies on no edge.
 */
static bool is_pixel_hidden(
	const struct draw *draw, const struct setup *setup, int x, int y)
{
	const struct buffers *buffers = &draw->soft->buffers;
	const struct vertex *const *v = setup->v;
	double sum = 0.0, z = 0.0;
	int signs = 0;

	for (int i = 0; i < 3; i++) {
		const struct vertex *a = v[(i + 1) % 3], *b = v[(i + 2) % 3];
		/* v[i]'s barycentric coordinate, times the area */
		double share =
			(double)(b->x - a->x) * (16.0 * y + 8.125 - a->y) -
			(double)(b->y - a->y) * (16.0 * x + 8.25 - a->x);

		signs += (share > 0.0) - (share < 0.0);
		sum += share;
		z += share * v[i]->z;
	}
	return (signs == 3 || signs == -3) &&
		is_behind(draw, (int32_t)(z / sum / 4.0),
			buffers->depth[y * buffers->width + x]);
}

/*
 * The number of the triangle's hidden pixels. It may be a little more than the
 * triangle's area, but on average of many triangles it is not.
 */
static double count_hidden(const struct draw *draw, const struct setup *setup,
	const struct clip_box *box)
{
	double count = 0.0;

	if (!draw->soft->fragment.depth_test) {
		return 0.0;
	}
	for (int y = box->top; y < box->bottom; y++) {
		for (int x = box->left; x < box->right; x++) {
			count += is_pixel_hidden(draw, setup, x, y);
		}
	}
	return count;
}

/* Whether a pixel's centre lies in the triangle, or on an edge, in this row. */
static bool covers_row(
	const struct setup *setup, const struct clip_box *box, int row)
{
	double y = 16.0 * row + 8.0, left = INFINITY, right = -INFINITY;

	for (int i = 0; i < 3; i++) {
		const struct vertex *a = setup->v[i], *b = setup->v[(i + 1) % 3];
		double x;

		if ((a->y < y) == (b->y < y)) {
			continue;
		}
		x = a->x + (y - a->y) * (double)(b->x - a->x) / (b->y - a->y);
		left = fmin(left, (x - 8.0) / 16.0);
		right = fmax(right, (x - 8.0) / 16.0);
	}
	left = fmax(ceil(left), box->left);
	return left <= right && left < box->right;
}

/*
 * The rows in which the triangle has pixels, or their runs if there are more,
 * and a share of the other rows: a triangle that is thinner than a pixel passes
 * between the centres of most.
 */
static double count_rows(
	const struct setup *setup, const struct clip_box *box, uint32_t runs)
{
	double covered = 0.0, empty = 0.0;

	for (int y = box->top; y < box->bottom; y++) {
		if (covers_row(setup, box, y)) {
			covered += 1.0;
		} else {
			empty += empty_row;
		}
	}
	return fmax(covered, runs) + empty;
}

static void fill_and_count(struct draw *draw, struct setup *setup)
{
	struct gl_counts *counts = draw->soft->counts;
	/* the paths that drop hidden triangles */
	bool skipped = (draw->counted_fill == soft_fill_textured ||
			       draw->counted_fill == soft_rows_fill) &&
		soft_is_hidden(draw, setup);
	double pixels = (double)setup->area / (2.0 * 16.0 * 16.0), hidden;
	const struct vertex *const *v = setup->v;
	int left = raster_centre(raster_least(v[0]->x, v[1]->x, v[2]->x));
	/* the pixels in which the triangle can lie */
	const struct clip_box box = raster_clip(draw,
		(struct clip_box){left, setup->top, left + setup->columns,
			setup->bottom});

	if (raster_is_flat(draw)) {
		/* Copying the corners costs about as much as shading one. */
		counts->shaded += 1 + is_new(draw, setup->provoking);
	} else {
		for (int i = 0; i < 3 && draw->attributes; i++) {
			counts->shaded += is_new(draw, setup->v[i]);
		}
	}
	hidden = skipped ? 0.0 : count_hidden(draw, setup, &box);
	draw->raster.top = NOT_SET_UP;
	draw->raster.bent = false;
	draw->counted_runs = 0;
	draw->counted_across = draw->counted_across_pixels = 0;
	draw->counted_fill(draw, setup);
	if (skipped) {
		counts->skipped += 1.0;
	} else {
		add_work(draw, setup,
			count_rows(setup, &box, draw->counted_runs),
			pixels - hidden);
		counts->hidden += hidden;
	}
}

/*
 * Whether a call of so many vertices reads an array that two recent calls have
 * read, and that the cache of the second level still has. One is not enough: a
 * shadow and its figure are two calls, between which others may lie.
 */
static bool is_read_again(struct draw *draw, double vertices)
{
	const uint8_t *positions = draw->view.positions;
	double since = vertices;
	int found = 0;

	for (uint32_t i = 1; i <= RECENT_CALLS; i++) {
		const struct counted_call *call =
			&draw->recent[(draw->recent_next - i) % RECENT_CALLS];

		if (since > CACHED_VERTICES) {
			break;
		}
		found += call->positions == positions;
		since += call->vertices;
	}
	draw->recent[draw->recent_next++ % RECENT_CALLS] =
		(struct counted_call){positions, vertices};
	return found >= 2;
}

void soft_count_call(struct draw *draw, const struct source *source, GLenum mode)
{
	struct gl_counts *counts = draw->soft->counts;
	bool listed = mode == GL_TRIANGLES && source->indices &&
		source->type == GL_UNSIGNED_SHORT;
	double vertices = 0.0;

	counts->calls += 1.0;
	counts->listed +=
		mode == GL_TRIANGLES ? source->count / 3 : source->count;
	draw->soft->changed |=
		GROUP_FRAGMENTS; /* the next call needs its own draw->fill */
	draw->counted_fill = draw->fill;
	memset(draw->counted, 0xFF, sizeof(draw->counted));
	for (uint32_t i = 0; i < source->count; i++) {
		uint32_t index = index_at(source, i);
		uint32_t *known = &draw->counted[index % VERTEX_CACHE];

		vertices += *known != index;
		*known = index;
	}
	*(!listed                                       ? &counts->single
			: is_read_again(draw, vertices) ? &counts->again
							: &counts->vertices) +=
		vertices;
	memset(draw->counted, 0xFF, sizeof(draw->counted));
	/* Text is drawn as rectangles, without fill. */
	if (!draw->rectangles) {
		draw->fill = fill_and_count;
	}
}
