/* Points and lines: squares and steps of one fragment each. */
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

static int texel_value(const struct draw *draw, const struct vertex *v, int name)
{
	const struct texture_input *input = &draw->texture[(name - TEX_S) / 2];
	int log2 = (name - TEX_S) % 2 ? input->height_log2 : input->width_log2;

	return shift_by(v->attribute[name], log2);
}

static void set_values(
	const struct draw *draw, const struct vertex *v, uint32_t *out)
{
	for (int i = 0; i < ATTRIBUTES; i++) {
		if (draw->attributes >> i & 1) {
			out[i] = i < TEX_S ? (uint32_t)v->attribute[i] << 8
					   : (uint32_t)texel_value(draw, v, i);
		}
	}
	out[DEPTH] = (uint32_t)v->z << 8;
}

/* A square of fragments with one colour, around a pixel's place. */
static void draw_square(struct draw *draw, struct span *span, int32_t x_q4,
	int32_t y_q4, int size)
{
	int left = (x_q4 >> 4) - (size - 1) / 2;
	int top = (y_q4 >> 4) - (size - 1) / 2;
	const struct clip_box *box = &draw->box;
	int right = left + size < box->right ? left + size : box->right;
	int bottom = top + size < box->bottom ? top + size : box->bottom;

	left = left > box->left ? left : box->left;
	top = top > box->top ? top : box->top;
	for (span->y = top; span->y < bottom; span->y++) {
		for (span->x = left; span->x < right; span->x += SPAN_PIXELS) {
			int count = right - span->x;

			span->count = count < SPAN_PIXELS ? count : SPAN_PIXELS;
			soft_draw_span(draw, span);
		}
	}
}

static int whole_size(GLfixed size)
{
	return clamp_int((size >> 16) + (size >> 15 & 1), 1, 64);
}

void soft_draw_point(struct draw *draw, struct vertex *v)
{
	struct span span = {0};

	if (v->outcode) {
		return;
	}
	soft_shade(draw, v);
	set_values(draw, v, span.value);
	draw_square(draw, &span, v->x, v->y,
		whole_size(draw->soft->fragment.point_size));
}

/* (b - a) / steps, by a reciprocal: a share of 2^-25 off at most. */
static int32_t step_between(int32_t a, int32_t b, int steps)
{
	int zeros = LEADING_ZEROS_32((uint32_t)steps);
	int32_t inverse = reciprocal((uint32_t)steps << zeros);

	return (int32_t)(((int64_t)b - a) * inverse >> (62 - zeros));
}

/* Along the longer axis, the last pixel left out for the next line. */
void soft_draw_line(
	struct draw *draw, const struct vertex *a, const struct vertex *b)
{
	int32_t dx = b->x - a->x, dy = b->y - a->y;
	int32_t wide = dx < 0 ? -dx : dx, high = dy < 0 ? -dy : dy;
	int steps = ((wide > high ? wide : high) + 8) >> 4;
	int width = whole_size(draw->soft->fragment.line_width);
	bool flat = draw->soft->fragment.flat;
	uint32_t to[PLANES] = {0};
	int32_t step[PLANES], step_x, step_y;
	struct span span = {0};

	if (steps == 0) {
		return;
	}
	set_values(draw, flat ? draw->provoking : a, span.value);
	set_values(draw, flat ? draw->provoking : b, to);
	span.value[DEPTH] = (uint32_t)a->z << 8;
	to[DEPTH] = (uint32_t)b->z << 8;
	for (int i = 0; i < PLANES; i++) {
		step[i] = step_between(
			(int32_t)span.value[i], (int32_t)to[i], steps);
	}
	step_x = step_between(0, dx * 4096, steps);
	step_y = step_between(0, dy * 4096, steps);
	for (int i = 0; i < steps; i++) {
		draw_square(draw, &span, a->x + (step_x * i >> 12),
			a->y + (step_y * i >> 12), width);
		for (int j = 0; j < PLANES; j++) {
			span.value[j] += (uint32_t)step[j];
		}
	}
}
