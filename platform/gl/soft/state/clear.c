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

/* Sets those bits of a row's bytes that are in mask to the value's. */
static void fill_masked(uint8_t *at, size_t bytes, uint32_t value, uint32_t mask)
{
	uint32_t keep = ~mask;

	value &= mask;
	for (; bytes >= sizeof(keep); bytes -= sizeof(keep)) {
		const uint32_t word = (load_32(at) & keep) | value;

		memcpy(at, &word, sizeof(word));
		at += sizeof(word);
	}
	for (; bytes > 0; bytes--, at++, keep >>= 8, value >>= 8) {
		*at = (uint8_t)((*at & keep) | value);
	}
}

/*
 * Sets those bits of a buffer's rows that are in mask to the value's. Rows
 * without a gap between them are one long row.
 */
static void fill_rows(uint8_t *first, ptrdiff_t stride_bytes, size_t row_bytes,
	int rows, uint32_t value, uint32_t mask)
{
	const bool whole = mask == UINT32_MAX;
	const bool even = ((uintptr_t)first | row_bytes) % 2 == 0;
	const bool halves = whole && even && value >> 16 == (value & 0xFFFF);
	uint8_t *row = first;

	if (halves && stride_bytes == (ptrdiff_t)row_bytes) {
		row_bytes *= (size_t)rows;
		rows = 1;
	}
	for (int y = 0; y < rows; y++, row += stride_bytes) {
		if (halves) {
			soft_fill_pixels((uint16_t *)(void *)row,
				(int)(row_bytes / 2), (uint16_t)value);
		} else if (whole && y > 0) {
			memcpy(row, first, row_bytes);
		} else {
			fill_masked(row, row_bytes, value, mask);
		}
	}
}

static void clear_color(struct soft *soft, const struct clip_box *box)
{
	const struct pixels *target = &soft->buffers.target;
	uint8_t rgba[4];

	for (int i = 0; i < 4; i++) {
		rgba[i] = (uint8_t)soft_byte(soft->fragment.clear_color[i]);
	}
	fill_rows(pixel_at(target, box->left, box->top), target->stride_bytes,
		(size_t)((box->right - box->left) * pixel_bytes(target->format)),
		box->bottom - box->top,
		target->format == PIXELS_RGB565
			? twice_565(pack_565(rgba[0], rgba[1], rgba[2]))
			: load_32(rgba),
		soft->fragment.color_bits);
}

/* Clears the depth or the stencil buffer, of so many bytes a pixel. */
static void clear_buffer(const struct soft *soft, void *buffer, size_t bytes,
	const struct clip_box *box, uint32_t value, uint32_t mask)
{
	const size_t stride = bytes * (size_t)soft->buffers.width;

	fill_rows((uint8_t *)buffer + (size_t)box->top * stride +
			bytes * (size_t)box->left,
		(ptrdiff_t)stride, bytes * (size_t)(box->right - box->left),
		box->bottom - box->top, value, mask);
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
		clear_buffer(soft, soft->buffers.depth, 2, &box,
			(uint32_t)soft_depth_units(state->clear_depth) *
				0x00010001u,
			UINT32_MAX);
	}
	if (mask & GL_STENCIL_BUFFER_BIT && soft->buffers.stencil) {
		clear_buffer(soft, soft->buffers.stencil, 1, &box,
			state->stencil.clear * 0x01010101u,
			state->stencil.write_mask * 0x01010101u);
	}
}

static void read_row(
	const struct pixels *target, int x, int y, int count, uint8_t *out)
{
	const uint8_t *from = pixel_at(target, x, y);

	if (target->format == PIXELS_RGBA8888) {
		memcpy(out, from, (size_t)count * 4);
		return;
	}
	for (int i = 0; i < count; i++) {
		load_pixel(PIXELS_RGB565, from + 2 * i, out + 4 * i);
	}
}

/*
 * Reads GL_RGBA of bytes, the only format that is supported. Values outside of
 * the picture are undefined.
 */
void soft_gl_ReadPixels(GLint x, GLint y, GLsizei width, GLsizei height,
	GLenum format, GLenum type, void *pixels)
{
	struct soft *soft = soft_current();
	const struct pixels *target = &soft->buffers.target;
	size_t align = (size_t)soft->textures.pack_alignment;
	size_t row_bytes;
	int64_t left = x < 0 ? -(int64_t)x : 0;
	int64_t right = (int64_t)target->width - x;

	if (!soft_check(format == GL_RGBA && type == GL_UNSIGNED_BYTE,
		    GL_INVALID_ENUM) ||
		!soft_check(width >= 0 && height >= 0, GL_INVALID_VALUE)) {
		return;
	}
	right = right > width ? width : right;
	row_bytes = ((size_t)width * 4 + align - 1) / align * align;
	for (int row = 0; row < height && target->data && left < right; row++) {
		int64_t from_y = (int64_t)target->height - 1 - y - row;

		if (from_y >= 0 && from_y < target->height) {
			read_row(target, (int)(x + left), (int)from_y,
				(int)(right - left),
				(uint8_t *)pixels + (size_t)row * row_bytes +
					(size_t)left * 4);
		}
	}
}
