/*
 * A triangle's runs as a list. walk.c makes it, then each value of all runs is
 * found at a time, and the span function draws the list.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_LIST_H
#define PLATFORM_GL_SOFT_SPAN_LIST_H

#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/spans.h"

enum {
	SOFT_LIST_RUNS = 64
};

/*
 * Where the triangle is divided, behind the last run of each line is a row of
 * no pixels: the line's last pixel, to which the values of the run before lead.
 */
struct soft_list {
	struct soft_row *end;
	struct soft_row row[SOFT_LIST_RUNS];
};

/* A plane, and how a value of a row comes from it. */
struct soft_list_value {
	uint32_t start, right, down;
	const struct bend *bend;
	int scale; /* of products, see rows_find_quotient() */
};

/* How a value runs along a row. */
enum soft_list_way {
	SOFT_LIST_LINEAR,
	SOFT_LIST_BENT,
	SOFT_LIST_DIVIDED,
	SOFT_LIST_STEEP, /* linear, but kept in a colour's range at both ends */
};

static ALWAYS_INLINE struct soft_list_value soft_list_begin(
	const struct raster *raster, int name)
{
	const struct plane *p = &raster->plane[name];
	bool texels = name >= TEX_S && name < ATTRIBUTES;

	return (struct soft_list_value){p->start, (uint32_t)p->dx,
		(uint32_t)p->dy,
		name < ATTRIBUTES ? &raster->bend[name] : NULL,
		texels ? raster->tex_shift[name - TEX_S] : ROWS_COLOR_SCALE};
}

static ALWAYS_INLINE struct soft_list_value soft_list_begin_z(
	const struct raster *raster)
{
	const struct plane *p = &raster->plane[DEPTH];

	return (struct soft_list_value){.start = p->start << 6,
		.right = (uint32_t)p->dx << 6,
		.down = (uint32_t)p->dy << 6};
}

/* The plane's value where the row begins. */
static ALWAYS_INLINE uint32_t soft_list_find(
	const struct soft_list_value *value, const struct soft_row *row)
{
	return value->start + value->down * row->y + value->right * row->x;
}

/* list_colors.c: of what moves; and depth. */
void soft_list_colors(const struct draw *draw, const struct setup *setup,
	struct soft_list *list);

/*
 * list_texels.c: runs that leave the window are drawn at once, and their counts
 * become 0.
 */
void soft_list_texels(struct draw *draw, struct soft_list *list);

#endif
