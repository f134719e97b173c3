/*
 * Pictures whose sides are powers of two, which GL ES 1.1 requires: their
 * resampling, mipmap levels and formats of 16 bits.
 */
#ifndef APP_SCENE_DRAW_TEXELS_H
#define APP_SCENE_DRAW_TEXELS_H

#include "app/model/model.h"

struct texels {
	int width, height;
	uint8_t (*rgba)[4]; /* [height * width], from malloc() */
};

/* Returns the side of the texels for that of an image: 1 to 1024. */
int texels_side(int side, enum model_wrap wrap);

/*
 * Makes texels of an image, interpolated, or the nearest ones if the model asks
 * for these. A mirrored axis gets the image twice, the second time reversed.
 * The caller frees out->rgba. Returns 0 or -ENOMEM.
 */
int texels_resample(const struct model_image *image,
	const struct model_texture *sampling, struct texels *out);

/* Makes the next mipmap level in place: each texel averages two or four. */
void texels_halve(struct texels *texels);

/* Returns true if red, green and blue are equal everywhere. */
bool texels_are_gray(const struct texels *texels);

/* Writes the red bytes: out has width * height of them. */
void texels_pack_gray(const struct texels *texels, uint8_t *out);

/* Writes width * height texels of 16 bits, red in the highest bits. */
void texels_pack_565(const struct texels *texels, uint16_t *out);
void texels_pack_4444(const struct texels *texels, uint16_t *out);

#endif
