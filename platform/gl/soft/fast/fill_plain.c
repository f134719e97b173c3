/*
 * Small opaque triangles without a texture, set up as bands; see fill_opaque.c
 * for the state that asks for them.
 */
#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/raster/ramp.h"

/* How a value runs across; per pixel. */
struct gradient {
	int32_t right, down;
};

static ALWAYS_INLINE struct gradient find_gradient(
	const struct scale *scale, int32_t d1, int32_t d2)
{
	const struct setup *setup = scale->setup;
	int32_t across = d1 * setup->y2 - d2 * setup->y1;
	int32_t down = d2 * setup->x1 - d1 * setup->x2;

	return (struct gradient){
		(int32_t)((uint32_t)mul_high(across, scale->inverse)
			<< scale->shift),
		(int32_t)((uint32_t)mul_high(down, scale->inverse)
			<< scale->shift)};
}

/* At the centre of scale.column in the first row. */
static ALWAYS_INLINE uint32_t find_start(const struct scale *scale,
	int32_t first, const struct gradient *gradient)
{
	return ((uint32_t)first << 8) +
		(uint32_t)(gradient->right >> 4) * (uint32_t)scale->off_x +
		(uint32_t)(gradient->down >> 4) * (uint32_t)scale->off_y;
}

static int32_t cut(int32_t value, int bits)
{
	return value < 0 ? -(-value >> bits) : value >> bits;
}

/* A colour as five bits want it, without its half; see round_to_5(). */
static ALWAYS_INLINE int32_t five(int32_t value)
{
	return value - (value >> 5);
}

static ALWAYS_INLINE int32_t six(int32_t value)
{
	return value - (value >> 6);
}

static ALWAYS_INLINE uint32_t pair(int32_t red, int32_t blue)
{
	return ((uint32_t)(red >> 8) << 16) + (uint32_t)(blue >> 8);
}

struct colors {
	int32_t start[3];
	struct gradient gradient[3];
};

static ALWAYS_INLINE bool find_color(
	const struct scale *scale, int name, int32_t limit, struct colors *out)
{
	const struct setup *setup = scale->setup;
	int32_t first = setup->v[0]->attribute[name];
	int32_t d1 = setup->v[1]->attribute[name] - first;
	int32_t d2 = setup->v[2]->attribute[name] - first;

	out->gradient[name] = find_gradient(scale, d1, d2);
	out->start[name] =
		(int32_t)find_start(scale, first, &out->gradient[name]);
	return is_color_within(d1, d2, limit);
}

static ALWAYS_INLINE void set_colors(
	struct band *band, const struct colors *colors, int column)
{
	const struct gradient *r = &colors->gradient[RED];
	const struct gradient *g = &colors->gradient[GREEN];
	const struct gradient *b = &colors->gradient[BLUE];

	band->red_blue_right = pair(five(r->right), five(b->right));
	band->down.red_blue = pair(five(r->down), five(b->down));
	band->green_right = (uint32_t)six(g->right) << 8;
	band->down.green_q26 = (uint32_t)six(g->down) << 8;
	band->row.red_blue = pair(five(colors->start[RED]) + (1 << 18),
				     five(colors->start[BLUE]) + (1 << 18)) -
		band->red_blue_right * (uint32_t)column;
	band->row.green_q26 =
		((uint32_t)(six(colors->start[GREEN]) + (1 << 17)) << 8) -
		band->green_right * (uint32_t)column;
	band->packed_right = ((uint32_t)cut(six(g->right), 13) << 21) +
		((uint32_t)cut(five(r->right), 13) << 10) +
		(uint32_t)cut(five(b->right), 14);
}

bool soft_fill_plain_is_linear(
	const struct draw *draw, const struct setup *setup)
{
	int32_t limit = find_limits(draw, setup).color;
	bool within = true;

	for (int name = RED; name <= BLUE; name++) {
		int32_t first = setup->v[0]->attribute[name];

		within &= is_color_within(setup->v[1]->attribute[name] - first,
			setup->v[2]->attribute[name] - first, limit);
	}
	return within;
}

static ALWAYS_INLINE bool is_gray_vertex(const struct vertex *v)
{
	return v->attribute[RED] == v->attribute[GREEN] &&
		v->attribute[RED] == v->attribute[BLUE];
}

static ALWAYS_INLINE bool is_gray(const struct setup *setup)
{
	return is_gray_vertex(setup->v[0]) && is_gray_vertex(setup->v[1]) &&
		is_gray_vertex(setup->v[2]);
}

static ALWAYS_INLINE bool set_values(
	struct draw *draw, struct setup *setup, struct band *band)
{
	struct limits limits = find_limits(draw, setup);
	int32_t z = setup->v[0]->z;
	struct gradient deep;
	struct colors colors;
	struct scale scale;

	raster_find_area(setup);
	scale = find_scale(setup);
	if (!find_color(&scale, RED, limits.color, &colors)) {
		return false;
	}
	if (is_gray(setup)) {
		colors.start[GREEN] = colors.start[BLUE] = colors.start[RED];
		colors.gradient[GREEN] = colors.gradient[RED];
		colors.gradient[BLUE] = colors.gradient[RED];
	} else if (!find_color(&scale, GREEN, limits.color, &colors) ||
		!find_color(&scale, BLUE, limits.color, &colors)) {
		return false;
	}
	set_colors(band, &colors, scale.column);
	deep = find_gradient(&scale, setup->v[1]->z - z, setup->v[2]->z - z);
	band->z_right = (uint32_t)deep.right << 6;
	band->down.z_q16 = (uint32_t)deep.down << 6;
	band->row.z_q16 = (find_start(&scale, z, &deep) << 6) -
		band->z_right * (uint32_t)scale.column;
	return true;
}

static ALWAYS_INLINE void place(
	const struct draw *draw, const struct setup *setup, struct band *band)
{
	const struct buffers *buffers = &draw->soft->buffers;
	ptrdiff_t stride = buffers->target.stride_bytes;
	ptrdiff_t depth_stride = buffers->width * 2;

	band->row.depth = (uintptr_t)buffers->depth +
		(uintptr_t)(setup->top * depth_stride);
	band->down.depth = (uintptr_t)depth_stride;
	band->pixels = (uintptr_t)buffers->target.data +
		(uintptr_t)(setup->top * stride) - band->row.depth - 2;
	band->wide_mask = WIDE_MASK;
	band->pixels_step = (uintptr_t)(stride - depth_stride);
	band->from = draw->box.left;
	band->to = draw->box.right;
}

static void skip_rows(struct band *band, int rows)
{
	uint32_t n = (uint32_t)rows;

	band->row.depth += band->down.depth * n;
	band->row.z_q16 += band->down.z_q16 * n;
	band->row.red_blue += band->down.red_blue * n;
	band->row.green_q26 += band->down.green_q26 * n;
	band->pixels += band->pixels_step * n;
}

static void draw_inside(void *band)
{
	soft_bands.color(band);
}

static void draw_cut(void *band)
{
	soft_band_color_c(band);
}

void soft_fill_plain(struct draw *draw, struct setup *setup)
{
	struct band band;

	if (setup->wide || !set_values(draw, setup, &band)) {
		soft_rows_fill(draw, setup);
		return;
	}
	place(draw, setup, &band);
	skip_rows(&band, raster_first_row(draw, setup) - setup->top);
	raster_draw_bands(draw, setup, setup->middle_left,
		&(struct band_ends){band.edge, band.edge_step, &band.rows},
		setup->inside ? draw_inside : draw_cut, &band);
}
