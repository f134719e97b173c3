#include "app/scene/draw/live_texture.h"

#include "platform/base/fixed.h"

#include <errno.h>
#include <stdlib.h>

static void set_sampling(const struct gl *gl, bool smooth)
{
	GLint filter = smooth ? GL_LINEAR : GL_NEAREST;

	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

int live_texture_init(struct live_texture *texture, const struct gl *gl,
	bool smooth, const struct log *log)
{
	texture->width = texture->height = 0;
	texture->texels = calloc(LIVE_TEXTURE_SIDE * LIVE_TEXTURE_SIDE,
		sizeof(*texture->texels));
	if (!texture->texels) {
		log_error(log,
			"--camera: there is not enough memory for the camera's texture");
		return -ENOMEM;
	}
	gl->GenTextures(1, &texture->name);
	gl->BindTexture(GL_TEXTURE_2D, texture->name);
	set_sampling(gl, smooth);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 2);
	gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, LIVE_TEXTURE_SIDE,
		LIVE_TEXTURE_SIDE, 0, GL_RGB, GL_UNSIGNED_SHORT_5_6_5,
		texture->texels);
	return 0;
}

void live_texture_finish(struct live_texture *texture, const struct gl *gl)
{
	if (texture->name) {
		gl->DeleteTextures(1, &texture->name);
	}
	free(texture->texels);
	texture->texels = NULL;
	texture->name = 0;
}

void live_texture_update(struct live_texture *texture, const struct gl *gl,
	const struct camera_image *image, int aspect_width, int aspect_height)
{
	struct camera_part part = camera_part_cut(
		image->width, image->height, aspect_width, aspect_height);
	int width = part.width, height = part.height;

	while (width > LIVE_TEXTURE_SIDE || height > LIVE_TEXTURE_SIDE) {
		width = (width + 1) / 2;
		height = (height + 1) / 2;
	}
	camera_convert(&texture->scaler, image, &part, width, height,
		texture->texels, width);
	texture->width = width;
	texture->height = height;
	gl->BindTexture(GL_TEXTURE_2D, texture->name);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 2);
	gl->TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGB,
		GL_UNSIGNED_SHORT_5_6_5, texture->texels);
}

/* The distance from the first texel's centre to the last one's. */
static GLfixed texture_extent(int texels)
{
	return (texels - 1) * (FX16_ONE / LIVE_TEXTURE_SIDE);
}

void live_texture_bind(const struct live_texture *texture, const struct gl *gl)
{
	const GLfixed half = FX16_ONE / LIVE_TEXTURE_SIDE / 2;

	gl->Enable(GL_TEXTURE_2D);
	gl->BindTexture(GL_TEXTURE_2D, texture->name);
	gl->MatrixMode(GL_TEXTURE);
	gl->LoadIdentity();
	gl->Translatex(half, half, 0);
	gl->Scalex(texture_extent(texture->width),
		texture_extent(texture->height), FX16_ONE);
	gl->MatrixMode(GL_MODELVIEW);
}

void live_texture_unbind(const struct gl *gl)
{
	gl->MatrixMode(GL_TEXTURE);
	gl->LoadIdentity();
	gl->MatrixMode(GL_MODELVIEW);
	gl->Disable(GL_TEXTURE_2D);
}
