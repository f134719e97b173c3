/* Clearing the buffers. */
#include <string.h>

#include "platform/base/fixed.h"
#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/state/parameter.h"

static void clear_colorx(GLfixed red, GLfixed green, GLfixed blue, GLfixed alpha)
{
	const GLfixed given[4] = {red, green, blue, alpha};

	memcpy(soft_current()->fragment.clear_color, given, sizeof(given));
}

static void clear_depthx(GLfixed depth)
{
	soft_current()->fragment.clear_depth = depth < 0 ? 0
		: depth > FX16_ONE                       ? FX16_ONE
							 : depth;
}

static void clear_stencil(GLint value)
{
	soft_current()->fragment.stencil.clear = (uint8_t)value;
}

/* Rows of bytes that are all like the first, which is filled already. */
static void repeat_row(uint8_t *first, size_t bytes, ptrdiff_t stride, int rows)
{
	uint8_t *row = first;

	for (int y = 1; y < rows; y++) {
		row += stride;
		memcpy(row, first, bytes);
	}
}

/* Rows that follow one another without a gap are one. */
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
	const GLfixed *wanted = soft->fragment.clear_color;
	int bytes = pixel_bytes(target->format);
	int width = box->right - box->left, rows = box->bottom - box->top;
	uint8_t *first = pixel_at(target, box->left, box->top);
	uint8_t rgba[4];

	for (int i = 0; i < 4; i++) {
		rgba[i] = (uint8_t)soft_byte(wanted[i]);
	}
	if (target->format == PIXELS_RGB565) {
		fill_rows((uint16_t *)(void *)first, width,
			target->stride_bytes / (ptrdiff_t)sizeof(uint16_t),
			rows, pack_565(rgba[0], rgba[1], rgba[2]));
		return;
	}
	for (int x = 0; x < width; x++) {
		store_pixel(target->format, first + x * bytes, rgba);
	}
	repeat_row(first, (size_t)(width * bytes), target->stride_bytes, rows);
}

static void clear_masked_color(struct soft *soft, const struct clip_box *box)
{
	const struct pixels *target = &soft->buffers.target;
	const struct fragment_state *state = &soft->fragment;

	for (int y = box->top; y < box->bottom; y++) {
		for (int x = box->left; x < box->right; x++) {
			uint8_t *at = pixel_at(target, x, y);
			uint8_t rgba[4];

			load_pixel(target->format, at, rgba);
			for (int i = 0; i < 4; i++) {
				rgba[i] = state->color_mask[i]
					? (uint8_t)soft_byte(
						  state->clear_color[i])
					: rgba[i];
			}
			store_pixel(target->format, at, rgba);
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

	/* By two, where rows begin and end with a pair. */
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

static void clear(GLbitfield mask)
{
	struct soft *soft = soft_current();
	const struct fragment_state *state = &soft->fragment;
	const GLboolean *write = state->color_mask;
	const GLbitfield known = GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT |
		GL_STENCIL_BUFFER_BIT;
	struct clip_box box = soft_clip_box(soft, false);

	if (!soft_check((mask & ~known) == 0, GL_INVALID_VALUE) ||
		!soft->buffers.target.data || box.left >= box.right ||
		box.top >= box.bottom) {
		return;
	}
	if (mask & GL_COLOR_BUFFER_BIT) {
		if (write[0] && write[1] && write[2] && write[3]) {
			clear_color(soft, &box);
		} else {
			clear_masked_color(soft, &box);
		}
	}
	if (mask & GL_DEPTH_BUFFER_BIT && state->depth_mask) {
		clear_depth(soft, &box);
	}
	if (mask & GL_STENCIL_BUFFER_BIT && soft->buffers.stencil) {
		clear_stencil_buffer(soft, &box);
	}
}

void soft_init_clear(struct soft *soft)
{
	struct gl *gl = &soft->base.gl;

	gl->Clear = clear;
	gl->ClearColorx = clear_colorx;
	gl->ClearDepthx = clear_depthx;
	gl->ClearStencil = clear_stencil;
}
