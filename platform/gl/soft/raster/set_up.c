/* Finds a triangle's planes: how depth and attributes change across it. */
#include "platform/gl/soft/raster/frame.h"
#include "platform/gl/soft/raster/rows.h"

/* num / area * 2^scale, of an area of any size; see struct frame. */
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

static NEVER_INLINE void find_wide_frame(
	const struct setup *setup, struct frame *out)
{
	const struct vertex *const *v = setup->v;
	uint64_t area = setup->area;
	int zeros = LEADING_ZEROS_64(area);

	frame_begin(setup,
		area < 256 ? 0 : reciprocal((uint32_t)(area << zeros >> 32)),
		zeros - 32, raster_find_area(v[0], v[1], v[2]) < 0, out);
}

/* A plane through the values at three corners, times 2^scale / 16. */
static NEVER_INLINE void set_wide_plane(const struct frame *f,
	const struct delta *delta, int scale, struct plane *plane)
{
	const int64_t d1 = delta->d1, d2 = delta->d2;

	plane->dx = divide_by_area(f, d1 * f->y2 + d2 * f->less_y1, scale);
	plane->dy = divide_by_area(f, d2 * f->x1 + d1 * f->less_x2, scale);
	/* off_x and off_y are less than a pixel; then on to column 0 */
	plane->start = ((uint32_t)delta->first << (scale - 4)) +
		(uint32_t)(plane->dx >> 4) * (uint32_t)f->off_x +
		(uint32_t)(plane->dy >> 4) * (uint32_t)f->off_y -
		(uint32_t)plane->dx * (uint32_t)f->column;
}

static ALWAYS_INLINE void set_plane(
	struct raster *raster, bool small, const struct delta *delta, int name)
{
	if (small) {
		raster->plane[name] = frame_find_plane(&raster->frame, delta);
	} else {
		set_wide_plane(&raster->frame, delta, 12, &raster->plane[name]);
	}
}

/* Attributes' differences, and the largest one of texels. */
struct moving {
	struct delta delta[ATTRIBUTES];
	uint32_t texel;
};

/* Sets an attribute's differences; returns its bit if it is not constant. */
static ALWAYS_INLINE uint32_t gather(struct raster *raster,
	const struct setup *setup, int name, struct delta *delta)
{
	*delta = frame_find_attribute(setup, name);
	raster->constant[name] = (uint32_t)delta->first << 8;
	return (uint32_t)((delta->d1 | delta->d2) != 0) << name;
}

/*
 * Finds the differences of colours and fog. Values that are constant go into
 * raster->constant; white, in place of colours, is there since the call began.
 */
static ALWAYS_INLINE void gather_colors(
	struct draw *draw, const struct setup *setup, struct delta *delta)
{
	const uint32_t wanted = draw->attributes & ~draw->spans.white_bits;
	struct raster *raster = &draw->raster;
	uint32_t bits = 0;

	if (wanted >> RED & 1) {
		bits = gather(raster, setup, RED, &delta[RED]) |
			gather(raster, setup, GREEN, &delta[GREEN]) |
			gather(raster, setup, BLUE, &delta[BLUE]);
	} else {
		for (int i = RED; i <= BLUE; i++) {
			delta[i] = (struct delta){
				(int32_t)(raster->constant[i] >> 8), 0, 0};
		}
	}
	if (wanted >> ALPHA & 1) {
		bits |= gather(raster, setup, ALPHA, &delta[ALPHA]);
	}
	if (wanted >> FOG & 1) {
		bits |= gather(raster, setup, FOG, &delta[FOG]);
	}
	raster->moving_bits = bits;
	/* red, green and blue have planes together */
	raster->moving_count = 0;
	for (int i = RED; bits && i <= FOG; i++) {
		if (i <= BLUE || bits >> i & 1) {
			raster->moving[raster->moving_count++] = i;
		}
	}
}

bool soft_colors_bend(const struct draw *draw, const struct setup *setup)
{
	const struct perspective perspective = raster_find_perspective(setup);
	const uint32_t wanted = draw->attributes & ~draw->spans.white_bits;
	uint32_t most = 0;

	for (int i = RED; i <= FOG; i++) {
		if (wanted >> i & 1) {
			const struct delta delta =
				frame_find_attribute(setup, i);
			const uint32_t own =
				frame_find_spread(delta.d1, delta.d2);

			most = own > most ? own : most;
		}
	}
	return raster_bends(&perspective, most, rows_color_tolerance(draw));
}

/* Finds the differences and ranges of texture coordinates, in 1/256 texels. */
static ALWAYS_INLINE void gather_texels(
	struct draw *draw, const struct setup *setup, struct moving *moving)
{
	const uint32_t wanted = draw->attributes;
	struct raster *raster = &draw->raster;
	int count = raster->moving_count;

	for (int i = 0; i < 2 * SOFT_UNITS && wanted >> (TEX_S + i); i++) {
		const struct texture_input *input = &draw->texture[i / 2];
		struct frame_texels texels;
		uint32_t own;

		if (!(wanted >> (TEX_S + i) & 1)) {
			continue;
		}
		texels = frame_find_texels(setup, TEX_S + i,
			i % 2 ? input->height_log2 : input->width_log2,
			(i % 2 ? input->texture->wrap_t
			       : input->texture->wrap_s) == GL_REPEAT);
		raster->texel_range[i][0] = texels.low;
		raster->texel_range[i][1] = texels.high;
		own = (uint32_t)texels.high - (uint32_t)texels.low;
		moving->texel = own > moving->texel ? own : moving->texel;
		moving->delta[TEX_S + i] = texels.delta;
		raster->moving[count++] = TEX_S + i;
	}
	raster->moving_count = count;
	raster->moving_bits |= wanted & (UINT32_MAX << TEX_S);
}

/* 1 / w of the three corners in a common scale, below 2^29, at least 1. */
static void gather_inverse_w(const struct setup *setup, int32_t q[3])
{
	const struct vertex *const *v = setup->v;
	const int most =
		raster_most(v[0]->w_zeros, v[1]->w_zeros, v[2]->w_zeros);

	for (int i = 0; i < 3; i++) {
		int down = most - v[i]->w_zeros + 2;

		q[i] = v[i]->inverse_w_q30 >> (down > 31 ? 31 : down);
		q[i] = q[i] > 0 ? q[i] : 1;
	}
}

/* Chooses what is divided by 1 / w: all attributes, only s and t, or none. */
static ALWAYS_INLINE void find_perspective(struct draw *draw,
	const struct setup *setup, const struct moving *moving)
{
	struct raster *raster = &draw->raster;
	const struct perspective perspective = raster_find_perspective(setup);

	/* colours differ by less than 2^16 */
	raster->colors_divided = perspective.w_spread > perspective.w_least >>
			(8 - rows_color_tolerance(draw)) &&
		soft_colors_bend(draw, setup);
	if (raster->colors_divided) {
		raster->perspective = true;
	} else if (raster_bends(&perspective, moving->texel, 0)) {
		/* small triangles use polynomials instead of a division */
		raster->perspective = setup->wide || draw->divides ||
			moving->texel >= SMALL_DELTA ||
			perspective.w_spread > perspective.w_least ||
			!soft_bend(draw, setup, moving->delta, moving->texel);
	}
}

/* Sets the plane of a value times q = 1 / w, scaled to stay below 2^29. */
static void set_perspective(struct raster *raster, const struct delta *delta,
	const int32_t q[3], int name)
{
	int32_t value[3] = {delta->first,
		(int32_t)((uint32_t)delta->first + (uint32_t)delta->d1),
		(int32_t)((uint32_t)delta->first + (uint32_t)delta->d2)};
	struct delta scaled;
	int shift = 16;

	if (name >= TEX_S) {
		uint32_t all = 1;

		for (int i = 0; i < 3; i++) {
			all |= (uint32_t)(value[i] ^ value[i] >> 31);
		}
		shift = 32 - LEADING_ZEROS_32(all);
		raster->tex_shift[name - TEX_S] = shift;
	}
	for (int i = 0; i < 3; i++) {
		value[i] = (int32_t)((int64_t)value[i] * q[i] >> shift);
	}
	scaled = frame_find_delta(value[0], value[1], value[2]);
	set_wide_plane(&raster->frame, &scaled, 4, &raster->plane[name]);
}

static void set_attributes(struct draw *draw, const struct setup *setup)
{
	struct raster *raster = &draw->raster;
	const bool small = !setup->wide;
	struct moving moving;
	int32_t q[3];

	moving.texel = 0;
	raster->perspective = false;
	raster->colors_divided = false;
	raster->bent = false;
	gather_colors(draw, setup, moving.delta);
	gather_texels(draw, setup, &moving);
	if (draw->perspective && raster->moving_count > 0) {
		find_perspective(draw, setup, &moving);
	}
	if (raster->perspective) {
		struct delta inverse;

		gather_inverse_w(setup, q);
		inverse = frame_find_delta(q[0], q[1], q[2]);
		set_wide_plane(
			&raster->frame, &inverse, 4, &raster->plane[INVERSE_W]);
	}
	for (int i = 0; i < raster->moving_count; i++) {
		const int name = raster->moving[i];
		const struct delta *delta = &moving.delta[name];

		if (rows_is_divided(raster, name)) {
			set_perspective(raster, delta, q, name);
		} else if (name < TEX_S) {
			set_plane(raster, small, delta, name);
		} else if (!raster->bent) {
			set_plane(raster, small && moving.texel < SMALL_DELTA,
				delta, name);
			raster->plane[name].start += TEXEL_NUDGE;
		}
	}
}

int32_t soft_find_offset(const struct draw *draw, const struct setup *setup,
	int32_t dx, int32_t dy)
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
	const struct delta z = frame_find_delta(
		setup->v[0]->z, setup->v[1]->z, setup->v[2]->z);

	draw->raster.top = setup->top;
	if (setup->wide) {
		find_wide_frame(setup, &raster->frame);
	} else {
		frame_find(setup, &raster->frame);
	}
	setup->middle_left = raster->frame.middle_left;
	if (draw->soft->fragment.depth_test) {
		set_plane(raster, !setup->wide, &z, DEPTH);
	}
	if (draw->offset) {
		struct plane *depth = &raster->plane[DEPTH];

		depth->start += (uint32_t)soft_find_offset(
			draw, setup, depth->dx, depth->dy);
	}
	set_attributes(draw, setup);
}
