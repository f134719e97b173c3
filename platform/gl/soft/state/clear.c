/* Clearing the buffers, and reading the picture back. */
#include <string.h>

#include "platform/base/fixed.h"
#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/state/state.h"
#include "platform/gl/soft/vertex/number.h"

void soft_gl_ClearColorx(GLfixed red, GLfixed green, GLfixed blue, GLfixed alpha)
{
	const GLfixed given[4] = {red, green, blue, alpha};

	memcpy(soft_current()->fragment.clear_color, given, sizeof(given));
}

/* Fills rows; where no gap lies between them, as one long row. */
static void fill_rows(
	uint16_t *first, int width, ptrdiff_t stride, int rows, uint16_t value)
{
	if (width == stride) {
		soft_fill_pixels(first, width * rows, value);
		return;
	}
	for (int y = 0; y < rows; y++) {
		soft_fill_pixels(first + y * stride, width, value);
	}
}

static void clear_color(struct soft *soft, const struct clip_box *box)
{
	const struct pixels *target = &soft->buffers.target;
	const GLboolean *mask = soft->fragment.color_mask;
	const bool all = mask[0] && mask[1] && mask[2] && mask[3];
	int bytes = pixel_bytes(target->format);
	int width = box->right - box->left, rows = box->bottom - box->top;
	uint8_t *first = pixel_at(target, box->left, box->top), *row = first;
	uint8_t wanted[4], rgba[4];

	for (int i = 0; i < 4; i++) {
		wanted[i] = (uint8_t)soft_byte(soft->fragment.clear_color[i]);
	}
	if (all && target->format == PIXELS_RGB565) {
		fill_rows((uint16_t *)(void *)first, width,
			target->stride_bytes / (ptrdiff_t)sizeof(uint16_t),
			rows, pack_565(wanted[0], wanted[1], wanted[2]));
		return;
	}
	for (int y = 0; y < rows; y++, row += target->stride_bytes) {
		if (all && y > 0) {
			memcpy(row, first, (size_t)(width * bytes));
			continue;
		}
		for (int x = 0; x < width; x++) {
			load_pixel(target->format, row + x * bytes, rgba);
			for (int i = 0; i < 4; i++) {
				rgba[i] = mask[i] ? wanted[i] : rgba[i];
			}
			store_pixel(target->format, row + x * bytes, rgba);
		}
	}
}

static void clear_depth(struct soft *soft, const struct clip_box *box)
{
	int stride = soft->buffers.width;

	fill_rows(soft->buffers.depth + (size_t)box->top * (size_t)stride +
			box->left,
		box->right - box->left, stride, box->bottom - box->top,
		(uint16_t)soft_depth_units(soft->fragment.clear_depth));
}

static void clear_stencil_buffer(struct soft *soft, const struct clip_box *box)
{
	const struct stencil *stencil = &soft->fragment.stencil;
	size_t stride = (size_t)soft->buffers.width;
	uint8_t *first = soft->buffers.stencil + (size_t)box->top * stride;
	int width = box->right - box->left, rows = box->bottom - box->top;
	uint8_t keep = (uint8_t)~stencil->write_mask;

	/* whole rows without a gap: two bytes at a time */
	if (keep == 0 && width == (int)stride && width % 2 == 0) {
		soft_fill_pixels((uint16_t *)(void *)first, width / 2 * rows,
			(uint16_t)(stencil->clear * 0x101u));
		return;
	}
	for (int y = 0; y < rows; y++) {
		uint8_t *row = first + (size_t)y * stride + box->left;

		if (keep == 0) {
			memset(row, stencil->clear, (size_t)width);
			continue;
		}
		for (int x = 0; x < width; x++) {
			row[x] = (uint8_t)((row[x] & keep) |
				(stencil->clear & stencil->write_mask));
		}
	}
}

void soft_gl_Clear(GLbitfield mask)
{
	struct soft *soft = soft_current();
	const struct fragment_state *state = &soft->fragment;
	const GLbitfield known = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT |
		GL_STENCIL_BUFFER_BIT;
	struct clip_box box = soft_clip_box(soft, false);

	if (!soft_check((mask & ~known) == 0, GL_INVALID_VALUE) ||
		!soft->buffers.target.data || box.left >= box.right ||
		box.top >= box.bottom) {
		return;
	}
	if (mask & GL_COLOR_BUFFER_BIT) {
		clear_color(soft, &box);
	}
	if (mask & GL_DEPTH_BUFFER_BIT && state->depth_mask) {
		clear_depth(soft, &box);
	}
	if (mask & GL_STENCIL_BUFFER_BIT && soft->buffers.stencil) {
		clear_stencil_buffer(soft, &box);
	}
}

/* Reads GL_RGBA of bytes, the only format that is supported. */
void soft_gl_ReadPixels(GLint x, GLint y, GLsizei width, GLsizei height,
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

			/* Values outside of the picture are undefined. */
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
