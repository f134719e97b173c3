/* Counts what is drawn, if a program has asked for it. */
#include "platform/gl/gl_counts.h"
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/vertex/primitive.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

enum {
	NOT_SET_UP = INT_MIN /* as raster.top: neither planes nor lists */
};

/* Of the triangle that the span functions drew last. */
static enum gl_work_kind kind_of_spans(const struct draw *draw)
{
	uint32_t bits = draw->key.bits;
	bool textured = (bits & KEY_TEXTURE) != 0;

	if (bits & (KEY_BLENDED | KEY_ALPHA_TEST)) {
		return textured ? GL_WORK_MIXED_TEXTURED : GL_WORK_MIXED;
	}
	if (!textured) {
		return GL_WORK_SPANS;
	}
	if (draw->raster.top == NOT_SET_UP ||
		draw->raster.top == RASTER_LISTED) {
		return GL_WORK_TEXTURED;
	}
	return draw->raster.perspective ? GL_WORK_SPANS_DIVIDED
					: GL_WORK_SPANS_TEXTURED;
}

/* Of the triangle that was drawn last. */
static enum gl_work_kind kind_of(const struct draw *draw)
{
	fill_function fill = draw->counted_fill;

	if (fill == soft_fill_flat || fill == soft_fill_masked) {
		return GL_WORK_FLAT;
	}
	if (fill != soft_rows_fill && fill != soft_fill_narrow &&
		fill != soft_fill_textured) {
		return GL_WORK_GROUND;
	}
	return fill == soft_fill_narrow && draw->raster.top == NOT_SET_UP
		? GL_WORK_PLAIN
		: kind_of_spans(draw);
}

/* Vertices that are clipped lie outside of the cache. */
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

/* The paths that drop hidden triangles. */
static bool skips_hidden(const struct draw *draw)
{
	return draw->counted_fill == soft_fill_textured ||
		draw->counted_fill == soft_rows_fill;
}

/* The pixels in which the triangle can lie. */
static struct clip_box box_of(const struct draw *draw, const struct setup *setup)
{
	const struct vertex *const *v = setup->v;
	int left = raster_centre(raster_least(v[0]->x, v[1]->x, v[2]->x));
	struct clip_box box = draw->box;
	int right = left + setup->columns;

	box.left = left > box.left ? left : box.left;
	box.right = right < box.right ? right : box.right;
	box.top = setup->top > box.top ? setup->top : box.top;
	box.bottom = setup->bottom < box.bottom ? setup->bottom : box.bottom;
	return box;
}

/* Copies the depths in the box, row after row; NULL if that is impossible. */
static uint16_t *copy_depth(const struct draw *draw, const struct clip_box *box)
{
	const struct buffers *buffers = &draw->soft->buffers;
	size_t width = (size_t)(box->right - box->left);
	uint16_t *copy = malloc(
		width * (size_t)(box->bottom - box->top) * sizeof(*copy));

	for (int y = box->top; copy && y < box->bottom; y++) {
		memcpy(copy + width * (size_t)(y - box->top),
			buffers->depth + y * buffers->width + box->left,
			width * sizeof(*copy));
	}
	return copy;
}

static double count_changed(const struct draw *draw, const struct clip_box *box,
	const uint16_t *before)
{
	const struct buffers *buffers = &draw->soft->buffers;
	double count = 0.0;

	for (int y = box->top; y < box->bottom; y++) {
		for (int x = box->left; x < box->right; x++) {
			count += buffers->depth[y * buffers->width + x] !=
				*before++;
		}
	}
	return count;
}

/*
 * Draws the triangle, and returns how many of its pixels are behind others.
 * That is less than 0 where its rows cover more than its area. Where depths do
 * not tell, because alpha is tested too, it is 0.
 */
static double draw_and_find_hidden(
	struct draw *draw, struct setup *setup, double pixels)
{
	const struct clip_box box = box_of(draw, setup);
	uint32_t bits = draw->key.bits & (KEY_DEPTH_LESS | KEY_ALPHA_TEST);
	bool tested = bits == KEY_DEPTH_LESS && box.left < box.right &&
		box.top < box.bottom;
	uint16_t *before = tested ? copy_depth(draw, &box) : NULL;
	double hidden = 0.0;

	draw->counted_fill(draw, setup);
	if (before) {
		hidden = pixels - count_changed(draw, &box, before);
	}
	free(before);
	return hidden;
}

static void fill_and_count(struct draw *draw, struct setup *setup)
{
	struct gl_counts *counts = draw->soft->counts;
	bool skipped = skips_hidden(draw) && soft_is_hidden(draw, setup);
	double pixels = (double)setup->area / (2.0 * 16.0 * 16.0), hidden;
	const struct clip_box box = box_of(draw, setup);
	struct gl_work *work;

	for (int i = 0; i < 3 && draw->attributes; i++) {
		counts->shaded += is_new(draw, setup->v[i]);
	}
	draw->raster.top = NOT_SET_UP;
	hidden = draw_and_find_hidden(draw, setup, pixels);
	if (!skipped) {
		work = &counts->work[kind_of(draw)];
		work->triangles += 1.0;
		work->rows += box.bottom - box.top;
		work->pixels += pixels - hidden;
		counts->hidden += hidden;
	}
}

void soft_count_call(struct draw *draw, const struct source *source, GLenum mode)
{
	struct gl_counts *counts = draw->soft->counts;

	counts->calls += 1.0;
	counts->listed +=
		mode == GL_TRIANGLES ? source->count / 3 : source->count;
	draw->counted_fill = draw->fill;
	memset(draw->counted, 0xFF, sizeof(draw->counted));
	for (uint32_t i = 0; i < source->count; i++) {
		uint32_t index = index_at(source, i);
		uint32_t *known = &draw->counted[index % VERTEX_CACHE];

		counts->vertices += *known != index;
		*known = index;
	}
	memset(draw->counted, 0xFF, sizeof(draw->counted));
	/* Text is drawn by its rectangles. */
	if (draw->fill != soft_fill_glyph) {
		draw->fill = fill_and_count;
	}
}
