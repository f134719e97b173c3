/*
 * A texture that shows the images of a video camera.
 *
 * A camera image has sides of any length, a texture's are powers of two. The
 * image therefore fills one corner of the texture, and live_texture_bind() sets
 * a texture matrix in which it extends from 0 to 1.
 */
#ifndef APP_SCENE_DRAW_LIVE_TEXTURE_H
#define APP_SCENE_DRAW_LIVE_TEXTURE_H

#include "platform/base/log.h"
#include "platform/camera/convert.h"
#include "platform/gl/gl.h"

enum {
	LIVE_TEXTURE_SIDE = 512
};

struct live_texture {
	GLuint name;
	int width, height; /* of the image in it; 0 before the first one */
	uint16_t *texels;  /* conversion buffer for the next image; owned */
	struct camera_scaler scaler;
};

/*
 * Creates the texture. smooth selects linear filtering. Returns 0, or -ENOMEM
 * after logging an error.
 */
int live_texture_init(struct live_texture *texture, const struct gl *gl,
	bool smooth, const struct log *log);

void live_texture_finish(struct live_texture *texture, const struct gl *gl);

/*
 * Uploads the largest centred part of the image whose aspect is aspect_width :
 * aspect_height (both above 0). The part is halved until it fits the texture.
 * Allocates nothing.
 */
void live_texture_update(struct live_texture *texture, const struct gl *gl,
	const struct camera_image *image, int aspect_width, int aspect_height);

/*
 * Binds the texture and enables GL_TEXTURE_2D. s runs from 0 at the left to 1
 * at the right, t from 0 at the top to 1 at the bottom. Leaves the matrix mode
 * at GL_MODELVIEW.
 */
void live_texture_bind(const struct live_texture *texture, const struct gl *gl);

/* Disables GL_TEXTURE_2D and resets the texture matrix. */
void live_texture_unbind(const struct gl *gl);

#endif
