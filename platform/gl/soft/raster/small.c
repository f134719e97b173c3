/*
 * How attributes run across a triangle of up to SMALL_EXTENT: in 32 bits, and
 * either linearly or as bend.c has it.
 */
#include "platform/gl/soft/raster/frame.h"
#include "platform/gl/soft/raster/rows.h"

/* A triangle whose planes are being set up. */
struct small {
	const int32_t *corner[3]; /* attributes */
	struct delta *next;
	int *moving;
	uint32_t bits;         /* of those that move */
	uint32_t color, texel; /* the most that colours and texels differ by */
};

static ALWAYS_INLINE void add_moving(struct raster *raster,
	const struct setup *setup, struct small *small, int name,
	struct delta delta)
{
	*small->next++ = delta;
	*small->moving++ = name;
	small->bits |= 1u << name;
	raster_set_small_plane(
		&raster->basis, setup, &delta, &raster->plane[name]);
}

static ALWAYS_INLINE void set_color(struct raster *raster,
	const struct setup *setup, struct small *small, int name)
{
	int32_t first = small->corner[0][name];
	const struct delta delta = {first, small->corner[1][name] - first,
		small->corner[2][name] - first};
	uint32_t own;

	if ((delta.d1 | delta.d2) == 0) {
		raster->span.value[name] = (uint32_t)first << 8;
		raster->span.step[name] = 0;
		return;
	}
	own = frame_find_spread(delta.d1, delta.d2);
	small->color = own > small->color ? own : small->color;
	add_moving(raster, setup, small, name, delta);
}

/* In 1/256 of texels. False where they differ by too much. */
static ALWAYS_INLINE bool set_texels(struct raster *raster,
	const struct setup *setup, struct small *small, int name, int log2,
	bool repeats)
{
	const struct frame_texels texels =
		frame_find_texels(setup, name, log2, repeats);
	int32_t *range = raster->texel_range[name - TEX_S];
	uint32_t own = (uint32_t)texels.high - (uint32_t)texels.low;

	range[0] = texels.low;
	range[1] = texels.high;
	if (own >= SMALL_DELTA) {
		return false;
	}
	small->texel = own > small->texel ? own : small->texel;
	add_moving(raster, setup, small, name, texels.delta);
	raster->plane[name].start += TEXEL_NUDGE;
	return true;
}

static bool set_unit(struct draw *draw, const struct setup *setup,
	struct small *small, int unit)
{
	const struct texture_input *input = &draw->texture[unit];
	struct raster *raster = &draw->raster;
	int name = TEX_S + 2 * unit;

	return !input->used ||
		(set_texels(raster, setup, small, name, input->width_log2,
			 input->texture->wrap_s == GL_REPEAT) &&
			set_texels(raster, setup, small, name + 1,
				input->height_log2,
				input->texture->wrap_t == GL_REPEAT));
}

static void set_colors(struct draw *draw, const struct setup *setup,
	struct small *small, uint32_t wanted)
{
	struct raster *raster = &draw->raster;

	frame_choose_colors(draw, setup, small->corner);
	if (wanted & 1u << RED) {
		set_color(raster, setup, small, RED);
		set_color(raster, setup, small, GREEN);
		set_color(raster, setup, small, BLUE);
	}
	if (wanted & 1u << ALPHA) {
		set_color(raster, setup, small, ALPHA);
	}
}

/* Whether what the triangle has runs linearly, or bends; else it is divided. */
static bool find_perspective(struct draw *draw, const struct setup *setup,
	const struct small *small, const struct delta delta[])
{
	int32_t a = setup->v[0]->clip[3], b = setup->v[1]->clip[3];
	int32_t c = setup->v[2]->clip[3];
	int32_t low = a < b ? a : b, high = a < b ? b : a;
	int tolerance = rows_color_tolerance(draw);
	struct perspective perspective;

	low = c < low ? c : low;
	high = c > high ? c : high;
	perspective = (struct perspective){(uint32_t)(high - low),
		(uint32_t)low, small->texel, small->color >> (tolerance - 2)};
	if (raster_bends(&perspective, small->color, tolerance)) {
		draw->raster.colors_bent = true;
	} else if (!raster_bends(&perspective, small->texel, 0)) {
		return true;
	}
	return !draw->divides && high - low <= low &&
		soft_bend(draw, setup, delta, &perspective);
}

bool soft_set_small_attributes(struct draw *draw, const struct setup *setup)
{
	struct raster *raster = &draw->raster;
	const uint32_t wanted = draw->attributes & ~draw->spans.white_bits;
	struct delta delta[ATTRIBUTES];
	struct small small = {
		.corner = {setup->v[0]->attribute, setup->v[1]->attribute,
			setup->v[2]->attribute},
		.next = delta,
		.moving = raster->moving,
	};

	raster->perspective = false;
	raster->colors_divided = false;
	raster->bent = false;
	raster->colors_bent = false;
	set_colors(draw, setup, &small, wanted);
	small.corner[0] = setup->v[0]->attribute;
	small.corner[1] = setup->v[1]->attribute;
	small.corner[2] = setup->v[2]->attribute;
	if (wanted & 1u << FOG) {
		set_color(raster, setup, &small, FOG);
	}
	for (int i = 0; i < SOFT_UNITS; i++) {
		if (!set_unit(draw, setup, &small, i)) {
			return false;
		}
	}
	raster->moving_count = (int)(small.moving - raster->moving);
	raster->moving_bits = small.bits;
	return !draw->perspective || small.bits == 0 ||
		find_perspective(draw, setup, &small, delta);
}
