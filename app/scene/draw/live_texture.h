/*
 * A texture whose picture comes from a camera.
 *
 * Camera pictures have sides of any size, textures powers of two: the picture
 * lies in a corner of the texture, and live_texture_bind() sets a texture
 * matrix in which it reaches from 0 to 1.
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
	int width, height; /* of the picture in it; 0: none yet */
	uint16_t *texels;  /* of the next one; owned */
	struct camera_scaler scaler;
};

/*
 * smooth: texels are blended where they are enlarged. 0, or -ENOMEM after a
 * sentence.
 */
int live_texture_init(struct live_texture *texture, const struct gl *gl,
	bool smooth, const struct log *log);

void live_texture_finish(struct live_texture *texture, const struct gl *gl);

/*
 * Shows the middle of the image that has the aspect width : height (above 0),
 * in its own size or, where that is too large, halved. No allocation.
 */
void live_texture_update(struct live_texture *texture, const struct gl *gl,
	const struct camera_image *image, int aspect_width, int aspect_height);

/*
 * Makes it current and enables it: s from 0 to 1 is left to right, t from 0 to
 * 1 top to bottom. Leaves the matrix mode at GL_MODELVIEW.
 */
void live_texture_bind(const struct live_texture *texture, const struct gl *gl);

/* Disables it and resets the texture matrix. */
void live_texture_unbind(const struct gl *gl);

#endif
