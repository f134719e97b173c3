/* Rows of luminance textures in C; arm/tile_row.S has the same in assembly. */
#include "platform/gl/soft/fast/tiles.h"
#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/vertex/number.h"

static ALWAYS_INLINE uint32_t load_quad(
	const struct tile_run *run, uint32_t s, uint32_t t)
{
	uint32_t mask = (1u << run->side_log2) - 1;

	return run->quads[((t >> 16 & mask) << run->side_log2) + (s >> 16 & mask)];
}

static ALWAYS_INLINE uint32_t load_fine(
	const struct tile_run *run, uint32_t s, uint32_t t)
{
	uint32_t mask = (4u << run->side_log2) - 1;

	return run->fine[((t >> 14 & mask) << (run->side_log2 + 2)) +
		(s >> 14 & mask)];
}

/* How many more steps a coordinate makes before its end. */
static ALWAYS_INLINE uint32_t room(
	uint32_t end, uint32_t at, int32_t step, uint32_t pixels)
{
	uint32_t left = end - at;

	return mul_high_unsigned(step < 0 ? ~left : left, pixels);
}

/* How many steps, this one included, lie in the quad's patch; at most most. */
static ALWAYS_INLINE int count_patch(const struct tile_run *run, uint32_t quad,
	uint32_t s, uint32_t t, int most)
{
	size_t end = (size_t)quad_patch(quad) *
		(sizeof(struct patch) / sizeof(uint32_t));
	uint32_t across = room(run->s_end[end], s << (16 - run->side_log2),
		run->s_right, run->s_pixels);
	uint32_t down = room(run->t_end[end], t << (16 - run->side_log2),
		run->t_right, run->t_pixels);
	uint32_t further = across < down ? across : down;

	return further < (uint32_t)most ? (int)further + 1 : most;
}

void soft_tile_row_c(const struct tile_run *run, int by_fine)
{
	const int by_two = by_fine == 2; /* log2 of the pixels a step */
	uint16_t *pixel = run->pixel;
	uint32_t s = run->s, t = run->t;

	for (int left = run->count; left > 0;) {
		uint32_t quad = load_quad(run, s, t), place;
		int steps = 1, count;

		if (quad & QUAD_PATCH) {
			steps = count_patch(
				run, quad, s, t, (left + by_two) >> by_two);
			place = 2 * quad_luminance(quad);
		} else {
			place = by_fine
				? load_fine(run, s, t)
				: quad_mix(quad, s >> 8 & 255, t >> 8 & 255);
		}
		count = steps << by_two < left ? steps << by_two : left;
		soft_fill_pixels(pixel, count, (uint16_t)run->shade[place]);
		pixel += count;
		left -= count;
		s += (uint32_t)run->s_right * (uint32_t)steps;
		t += (uint32_t)run->t_right * (uint32_t)steps;
	}
}
