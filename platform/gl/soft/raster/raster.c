/* How attributes run across a triangle. */
#include "platform/gl/soft/raster/frame.h"
#include "platform/gl/soft/raster/rows.h"

/* num / area, times 2^scale; see struct frame. */
static int32_t divide_by_area(const struct frame *frame, int64_t num, int scale)
{
	uint64_t size = (uint64_t)(num < 0 ? -num : num);
	int spare;

	if (size == 0) {
		return 0;
	}
	spare = LEADING_ZEROS_64(size) - 33; /* to 31 bits */
	return shift_by(
		mul_high((int32_t)(spare < 0 ? num >> -spare
					     : num * ((int64_t)1 << spare)),
			frame->inverse_area),
		frame->zeros - spare - 30 + scale);
}

static ALWAYS_INLINE struct frame find_wide_frame(const struct setup *setup)
{
	const struct vertex *a = setup->v[0], *b = setup->v[1], *c = setup->v[2];
	uint64_t area = setup->area;
	int zeros = LEADING_ZEROS_64(area);

	return frame_begin(setup,
		area < 256 ? 0 : reciprocal((uint32_t)(area << zeros >> 32)),
		zeros - 32,
		(int64_t)(b->x - a->x) * (c->y - a->y) <
			(int64_t)(c->x - a->x) * (b->y - a->y));
}

/* A plane through three values; 2^scale over 16 is a unit of the plane. */
static void set_plane(const struct frame *f, const int32_t value[3], int scale,
	struct plane *plane)
{
	int64_t d1 = (int64_t)value[1] - value[0];
	int64_t d2 = (int64_t)value[2] - value[0];

	plane->dx = divide_by_area(f, d1 * f->y2 + d2 * f->less_y1, scale);
	plane->dy = divide_by_area(f, d2 * f->x1 + d1 * f->less_x2, scale);
	/* To column 0; both products before are within 16: less than a pixel. */
	plane->start = ((uint32_t)value[0] << (scale - 4)) +
		(uint32_t)(plane->dx >> 4) * (uint32_t)f->off_x +
		(uint32_t)(plane->dy >> 4) * (uint32_t)f->off_y -
		(uint32_t)plane->dx * (uint32_t)f->column;
}

static ALWAYS_INLINE uint32_t spread(const int32_t value[3])
{
	return (uint32_t)raster_most(value[0], value[1], value[2]) -
		(uint32_t)raster_least(value[0], value[1], value[2]);
}

static void set_affine(struct draw *draw, const struct setup *setup,
	const int32_t value[3], int name)
{
	struct plane *plane = &draw->raster.plane[name];

	if (!setup->wide && spread(value) < SMALL_DELTA) {
		const struct delta delta = {
			value[0], value[1] - value[0], value[2] - value[0]};

		*plane = frame_find_plane(&draw->raster.frame, &delta);
	} else {
		set_plane(&draw->raster.frame, value, 12, plane);
	}
}

/* Colours and fog as they are, coordinates in 1/256 of texels. */
static void gather_texels(
	struct draw *draw, const struct setup *setup, int name, int32_t out[3])
{
	int32_t *range = draw->raster.texel_range[name - TEX_S];
	const struct texture_input *input = &draw->texture[(name - TEX_S) / 2];
	bool t = (name - TEX_S) % 2;
	int log2 = t ? input->height_log2 : input->width_log2;
	GLenum wrap = t ? input->texture->wrap_t : input->texture->wrap_s;
	uint32_t first = (uint32_t)setup->v[0]->attribute[name];
	uint32_t base = wrap == GL_REPEAT ? first & ~0xFFFFu : 0;

	for (int i = 0; i < 3; i++) {
		out[i] = shift_by(
			(int32_t)((uint32_t)setup->v[i]->attribute[name] - base),
			log2 - 8);
	}
	range[0] = raster_least(out[0], out[1], out[2]);
	range[1] = raster_most(out[0], out[1], out[2]);
}

/* 1 / w of the three in a common scale, below 2^29. */
static void gather_inverse_w(const struct setup *setup, int32_t q[3])
{
	int most = 0;

	for (int i = 0; i < 3; i++) {
		int zeros = setup->v[i]->w_zeros;

		most = zeros > most ? zeros : most;
	}
	for (int i = 0; i < 3; i++) {
		int down = most - setup->v[i]->w_zeros + 2;

		q[i] = setup->v[i]->inverse_w_q30 >> (down > 31 ? 31 : down);
		q[i] = q[i] > 0 ? q[i] : 1;
	}
}

/* The most that colours differ by, and texels, into perspective. */
static uint32_t find_spreads(const struct raster *raster, int32_t (*value)[3],
	struct perspective *perspective)
{
	uint32_t color = 0;

	for (int i = 0; i < raster->moving_count; i++) {
		uint32_t own = spread(value[i]);
		uint32_t *most =
			raster->moving[i] < TEX_S ? &color : &perspective->texel;

		*most = own > *most ? own : *most;
	}
	return color;
}

/* Whether texels bend, in a small triangle, instead of being divided. */
static bool bend(struct draw *draw, const struct setup *setup,
	int32_t (*value)[3], const struct perspective *perspective)
{
	struct delta delta[ATTRIBUTES];

	if (setup->wide || draw->divides || perspective->texel >= SMALL_DELTA ||
		perspective->w_spread > perspective->w_least) {
		return false;
	}
	for (int i = 0; i < draw->raster.moving_count; i++) {
		delta[i] = (struct delta){value[i][0],
			value[i][1] - value[i][0], value[i][2] - value[i][0]};
	}
	return soft_bend(draw, setup, delta, perspective);
}

/* What has to be divided: everything, or texels alone unless they bend, or nothing. */
static void find_perspective(
	struct draw *draw, const struct setup *setup, int32_t (*value)[3])
{
	struct raster *raster = &draw->raster;
	const struct vertex *const *v = setup->v;
	const int32_t w[3] = {v[0]->clip[3], v[1]->clip[3], v[2]->clip[3]};
	struct perspective perspective = {.w_spread = spread(w),
		.w_least = (uint32_t)raster_least(w[0], w[1], w[2])};
	uint32_t color = find_spreads(raster, value, &perspective);

	raster->colors_divided =
		raster_bends(&perspective, color, rows_color_tolerance(draw));
	raster->perspective = raster->colors_divided ||
		(raster_bends(&perspective, perspective.texel, 0) &&
			!bend(draw, setup, value, &perspective));
}

/* Values times q, scaled to stay below 2^29; exact again after a division. */
static void set_perspective(struct raster *raster, const int32_t value[3],
	const int32_t q[3], int name)
{
	int32_t product[3];
	int shift = 16;

	if (name >= TEX_S) {
		uint32_t all = 1;

		for (int i = 0; i < 3; i++) {
			all |= (uint32_t)(value[i] < 0 ? -(value[i] + 1)
						       : value[i]);
		}
		shift = 32 - LEADING_ZEROS_32(all);
		raster->tex_shift[name - TEX_S] = shift;
	}
	for (int i = 0; i < 3; i++) {
		product[i] = (int32_t)((int64_t)value[i] * q[i] >> shift);
	}
	set_plane(&raster->frame, product, 4, &raster->plane[name]);
}

/*
 * Of what differs; what does not goes into the span once and for all, as white
 * did once a call.
 */
static int gather_attributes(
	struct draw *draw, const struct setup *setup, int32_t (*value)[3])
{
	const struct vertex *const *v = setup->v;
	const int32_t *const own[3] = {
		v[0]->attribute, v[1]->attribute, v[2]->attribute};
	struct raster *raster = &draw->raster;
	const int32_t *color[3];
	int count = 0;

	frame_choose_colors(draw, setup, color);
	for (int i = 0; i < draw->attribute_count; i++) {
		int name = draw->attribute[i];
		const int32_t *const *from = name == FOG ? own : color;
		int32_t *out = value[count];

		if (name >= TEX_S) {
			gather_texels(draw, setup, name, out);
			raster->moving[count++] = name;
			continue;
		}
		if (draw->spans.white_bits >> name & 1) {
			continue;
		}
		out[0] = from[0][name];
		out[1] = from[1][name];
		out[2] = from[2][name];
		if (out[0] != out[1] || out[0] != out[2]) {
			raster->moving[count++] = name;
			continue;
		}
		raster->span.value[name] = (uint32_t)out[0] << 8;
		raster->span.step[name] = 0;
	}
	return count;
}

static void set_attributes(struct draw *draw, const struct setup *setup)
{
	struct raster *raster = &draw->raster;
	int32_t value[ATTRIBUTES][3], q[3];
	int count = gather_attributes(draw, setup, value);

	raster->moving_count = count;
	raster->moving_bits = 0;
	for (int i = 0; i < count; i++) {
		raster->moving_bits |= 1u << raster->moving[i];
	}
	raster->perspective = false;
	raster->colors_divided = false;
	raster->bent = false;
	if (draw->perspective && count > 0) {
		find_perspective(draw, setup, value);
	}
	if (raster->perspective) {
		gather_inverse_w(setup, q);
		set_plane(&raster->frame, q, 4, &raster->plane[INVERSE_W]);
	}
	for (int i = 0; i < count; i++) {
		int name = raster->moving[i];

		if (rows_is_divided(raster, name)) {
			set_perspective(raster, value[i], q, name);
		} else if (name < TEX_S || !raster->bent) {
			set_affine(draw, setup, value[i], name);
			raster->plane[name].start +=
				name >= TEX_S ? TEXEL_NUDGE : 0;
		}
	}
}

int32_t soft_raster_offset_depth(const struct draw *draw,
	const struct setup *setup, int32_t dx, int32_t dy)
{
	const struct fragment_state *state = &draw->soft->fragment;
	const uint32_t x = raster_size(dx), y = raster_size(dy);
	int64_t offset =
		((int64_t)state->offset_factor * (x > y ? x : y) >> 16) +
		(state->offset_units >> 6);
	const struct vertex *const *v = setup->v;
	int64_t low = raster_least(v[0]->z, v[1]->z, v[2]->z);
	int64_t high = raster_most(v[0]->z, v[1]->z, v[2]->z);

	low = -(low - 4) * 256;
	high = (262138 - high) * 256;
	return (int32_t)(offset < low ? low : offset > high ? high : offset);
}

void soft_raster_set_up(struct draw *draw, struct setup *setup)
{
	struct raster *raster = &draw->raster;
	const int32_t z[3] = {setup->v[0]->z, setup->v[1]->z, setup->v[2]->z};

	draw->raster.top = setup->top;
	if (setup->wide) {
		raster->frame = find_wide_frame(setup);
	} else {
		raster->frame = frame_find(setup);
	}
	setup->middle_left = raster->frame.middle_left;
	if (draw->soft->fragment.depth_test) {
		set_affine(draw, setup, z, DEPTH);
	}
	if (draw->offset) {
		struct plane *depth = &raster->plane[DEPTH];

		depth->start += (uint32_t)soft_raster_offset_depth(
			draw, setup, depth->dx, depth->dy);
	}
	set_attributes(draw, setup);
}

int32_t soft_raster_long_slope(int32_t dx, int32_t dy)
{
	int zeros = LEADING_ZEROS_32((uint32_t)dy);

	/* |dx| < 2^18, so below 2^49; long and flat edges end within a row */
	return saturate_64((int64_t)dx * reciprocal((uint32_t)dy << zeros) >>
		(46 - zeros));
}
