/*
 * A model's images as GL textures.
 *
 * GL ES 1.1 wants sides that are powers of two and has no mirrored wrap, so
 * images are resampled and, for a mirrored side, stored twice, the second time
 * mirrored; texture_bind() then halves the coordinates.
 */
#ifndef APP_SCENE_DRAW_TEXTURE_H
#define APP_SCENE_DRAW_TEXTURE_H

#include "app/model/model.h"
#include "platform/display/pixels.h"
#include "platform/gl/gl.h"

struct texture_set {
	const struct model *model;
	int count;
	GLuint *name;        /* [count], one for each of the model's textures */
	bool normal_mapping; /* normal maps can be shown, see bump.h */
};

/*
 * Uploads all textures of the model, in 16 bits a texel for RGB565 targets.
 * 0, or -ENOMEM after a sentence with nothing left behind.
 */
int texture_set_create(struct texture_set *set, const struct model *model,
	const struct gl *gl, enum pixel_format target, const struct log *log);

void texture_set_destroy(struct texture_set *set, const struct gl *gl);

/* Makes a texture current and enables it; sets the texture matrix. */
void texture_bind(
	const struct texture_set *set, const struct gl *gl, int texture);

/*
 * One RGBA picture as a texture name, with the same rules; for pictures that
 * are not a model's. 0 when memory is short.
 */
GLuint texture_upload(const struct gl *gl, const struct model_image *image,
	const struct model_texture *sampling, enum pixel_format target);

#endif
