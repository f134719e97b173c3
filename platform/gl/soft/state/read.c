/* ReadPixels: ES 1.1's GL_RGBA of bytes. */
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/state/parameter.h"

static void read_pixels(GLint x, GLint y, GLsizei width, GLsizei height,
	GLenum format, GLenum type, void *pixels)
{
	struct soft *soft = soft_current();
	const struct pixels *target = &soft->buffers.target;
	size_t align = (size_t)soft->textures.pack_alignment;
	size_t row_bytes;

	if (!soft_check(format == GL_RGBA && type == GL_UNSIGNED_BYTE,
		    GL_INVALID_ENUM) ||
		!soft_check(width >= 0 && height >= 0, GL_INVALID_VALUE)) {
		return;
	}
	row_bytes = ((size_t)width * 4 + align - 1) / align * align;
	for (int row = 0; row < height && target->data; row++) {
		int64_t from_y = (int64_t)target->height - 1 - y - row;
		uint8_t *out = (uint8_t *)pixels + (size_t)row * row_bytes;

		for (int column = 0; column < width; column++) {
			int64_t from_x = (int64_t)x + column;

			/* Outside of the picture nothing is defined. */
			if (from_x >= 0 && from_x < target->width &&
				from_y >= 0 && from_y < target->height) {
				load_pixel(target->format,
					pixel_at(target, (int)from_x,
						(int)from_y),
					out + 4 * column);
			}
		}
	}
}

void soft_init_read(struct soft *soft)
{
	soft->base.gl.ReadPixels = read_pixels;
}
