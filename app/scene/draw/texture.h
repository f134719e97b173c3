/*
 * Makes GL textures of a model's images.
 *
 * GL ES 1.1 requires sides that are powers of two and has no mirrored wrap
 * mode. Images are therefore resampled, and an image that is mirrored along an
 * axis is stored twice along it, the second time reversed; texture_bind() then
 * halves the coordinates of that axis.
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
	bool normal_mapping; /* the driver can draw the model's normal maps */
	bool two_units; /* the driver has two texture units and GL_COMBINE */
	size_t taken_bytes; /* from the model's budget, for the GL's memory */
};

/*
 * Uploads all textures of the model, with 16 bits a texel when the target is
 * RGB565. The memory that the GL needs for them is taken from the model's
 * budget, because many textures may share one image. Returns 0, or -ENOMEM
 * after logging an error; then nothing is left to release. Release the set with
 * texture_set_destroy() while the model exists.
 */
int texture_set_create(struct texture_set *set, const struct model *model,
	const struct gl *gl, enum pixel_format target, const struct log *log);

void texture_set_destroy(struct texture_set *set, const struct gl *gl);

/*
 * Binds one of the model's textures, enables GL_TEXTURE_2D, sets the texture
 * matrix and leaves the matrix mode at GL_MODELVIEW.
 */
void texture_bind(
	const struct texture_set *set, const struct gl *gl, int texture);

/*
 * Uploads one RGBA image, which need not be a model's, under the same rules.
 * Returns the texture's name, or 0 when memory is short.
 */
GLuint texture_upload(const struct gl *gl, const struct model_image *image,
	const struct model_texture *sampling, enum pixel_format target);

/*
 * Reads the GL's errors. Returns false if one of them was GL_OUT_OF_MEMORY: a
 * texture that was given its image before may have none.
 */
bool texture_memory_ok(const struct gl *gl);

#endif
