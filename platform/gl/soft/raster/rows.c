/* Perspective division at single columns; levels of detail. */
#include "platform/gl/soft/raster/rows.h"

/* A coordinate's derivative in x, or y; of polynomials at the centre. */
static int32_t find_slope(const struct raster *raster, int name, bool down)
{
	const struct plane *p = &raster->plane[name];
	const struct bend *bend = &raster->bend[name];
	uint32_t x = (uint32_t)raster->middle_column;
	uint32_t y = (uint32_t)raster->middle_row;
	uint32_t change = (uint32_t)(down ? p->dy : p->dx);

	if (raster->bent) {
		change += (uint32_t)bend->xy * (down ? x : y) +
			(uint32_t)(down ? bend->yy : bend->xx) * 2 *
				(down ? y : x);
	}
	return (int32_t)change;
}

void soft_rows_find_affine_lod(struct draw *draw)
{
	struct raster *raster = &draw->raster;

	for (int unit = 0; unit < SOFT_UNITS; unit++) {
		const int s = TEX_S + 2 * unit;

		if (draw->texture[unit].used) {
			raster->lod[unit] =
				raster_find_lod(find_slope(raster, s, false),
					find_slope(raster, s + 1, false),
					find_slope(raster, s, true),
					find_slope(raster, s + 1, true));
		}
	}
}

/* The level of detail at a point, by d(S / q) = (dS - S / q dq) / q. */
int soft_rows_find_lod(const struct raster *raster, const struct point *point,
	int unit, struct texels texels)
{
	const struct plane *q = &raster->plane[INVERSE_W];
	int32_t across[2], down[2];

	for (int i = 0; i < 2; i++) {
		int name = TEX_S + 2 * unit + i;
		const struct plane *p = &raster->plane[name];
		int shift = raster->tex_shift[name - TEX_S];
		int64_t u = i == 0 ? texels.s : texels.t;
		/* u is 16.16: the shift leads back to the plane's scale */
		int64_t x = p->dx - (u * q->dx >> (shift + 8));
		int64_t y = p->dy - (u * q->dy >> (shift + 8));

		across[i] = rows_divide(point, saturate_64(x), shift + 8);
		down[i] = rows_divide(point, saturate_64(y), shift + 8);
	}
	return raster_find_lod(across[0], across[1], down[0], down[1]);
}

bool soft_rows_is_linear(GLenum filter)
{
	return filter == GL_LINEAR || filter == GL_LINEAR_MIPMAP_NEAREST ||
		filter == GL_LINEAR_MIPMAP_LINEAR;
}

bool soft_rows_want_lod(const struct texture_input *input)
{
	return input->used &&
		(input->levels > 1 ||
			soft_rows_is_linear(input->texture->min_filter) !=
				(input->texture->mag_filter == GL_LINEAR));
}

bool soft_rows_is_small(const struct texture_input *input, int lod)
{
	GLenum min = input->texture->min_filter;
	bool sharp = input->texture->mag_filter == GL_LINEAR &&
		(min == GL_NEAREST_MIPMAP_NEAREST ||
			min == GL_NEAREST_MIPMAP_LINEAR);

	return lod > (sharp ? 128 : 0);
}

bool soft_rows_mixes_levels(const struct texture_input *input)
{
	return input->used && input->levels > 1 &&
		(input->texture->min_filter == GL_NEAREST_MIPMAP_LINEAR ||
			input->texture->min_filter == GL_LINEAR_MIPMAP_LINEAR);
}
