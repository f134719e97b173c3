#include "platform/gl/soft/span/made.h"

#include "platform/gl/soft/span/sample.h"
#include "platform/gl/soft/span/texels.h"
#include "platform/gl/soft/span/walk.h"
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

/* White's alpha, 8.7. */
enum {
	WHITE_ALPHA = 0x7FC0,
};

bool soft_wants_made(const struct texture_input *input)
{
	GLenum min;

	if (!input->used || input->levels <= 1) {
		return false;
	}
	min = input->texture->min_filter;
	return min == GL_NEAREST_MIPMAP_LINEAR || min == GL_LINEAR_MIPMAP_LINEAR;
}

/* The function that leaves texels as they are, but makes bytes of them. */
static const soft_span_function *find_sampler(
	const struct texture_input *input, bool linear)
{
	int source = (linear ? SOFT_LINEAR : SOFT_NEAREST) +
		(int)input->base->format - 1;

	return soft_spans_8888[source][SOFT_OPAQUE];
}

void soft_set_made_levels(struct draw *draw, int lod)
{
	struct soft_spans *spans = &draw->spans;
	const struct texture_input *input = &draw->texture[0];
	int last = input->levels - 1;
	bool linear = lod < 0
		? input->texture->mag_filter == GL_LINEAR
		: input->texture->min_filter == GL_LINEAR_MIPMAP_LINEAR;
	int level = lod < 0 ? 0 : clamp_int(lod >> 8, 0, last), line = lod & 255;

	/* lod runs straight between powers of two, a logarithm above. */
	spans->made_share = lod < 0 || level == last
		? 0
		: line + (line * (256 - line) * 92 >> 16);
	if (level == spans->level && linear == spans->made_linear) {
		return;
	}
	spans->level = level;
	spans->made_linear = linear;
	spans->made_sampler = find_sampler(input, linear);
	spans->view = soft_find_view(input, level, linear);
	spans->next_view =
		soft_find_view(input, level < last ? level + 1 : level, linear);
	/* All runs come here: none lies in the window. */
	spans->window.s_room = 0;
	spans->draw_anywhere = soft_draw_made;
}

/* The texels of a level, as bytes. */
static void sample(const struct soft_spans *spans, const struct soft_view *view,
	uint32_t count, uint32_t *out)
{
	const soft_span_function *function = spans->made_sampler;
	const struct soft_made_at *at = &spans->made_at;
	uint16_t passing[SOFT_RUN_PIXELS];
	struct soft_window window;
	struct soft_run run = {
		.depth = passing,
		.pixel = (uint8_t *)out,
		.count = count,
		.red_blue = spans->made_white[0] * 0x10001,
		.green_alpha = WHITE_ALPHA << 16 | spans->made_white[1],
		.stages = &spans->stages,
	};

	memset(passing, 0xFF, count * sizeof(*passing));
	soft_use_view(view, function, &run, &window);
	run.s_right = soft_texel_step(at->s_step, view->s_shift);
	run.t_right = soft_texel_step(at->t_step, view->t_shift);
	run.texel_right = ((uint32_t)run.t_right << 16) + (uint32_t)run.s_right;
	run.s = soft_find_start(at->s, at->s_step, count >> 1, run.s_right,
		view->s_shift, view->s_half);
	run.t = soft_find_start(at->t, at->t_step, count >> 1, run.t_right,
		view->t_shift, view->t_half);
	function[soft_find_window(&window, view->texel_log2, &run)](&run);
}

/* From one to the other of four bytes by 0..255 of 256. */
static uint32_t mix(uint32_t from, uint32_t to, uint32_t share)
{
	const uint32_t mask = 0x00FF00FF, half = 0x00800080;
	uint32_t low = (from & mask) * (256 - share) + (to & mask) * share;
	uint32_t high =
		(from >> 8 & mask) * (256 - share) + (to >> 8 & mask) * share;

	return ((low + half) >> 8 & mask) | ((high + half) & ~mask);
}

void soft_draw_made(const struct soft_run *given)
{
	struct soft_spans *spans = &given->draw->spans;
	struct soft_run *run = &spans->run;
	uint32_t texel[SOFT_RUN_PIXELS], next[SOFT_RUN_PIXELS];
	uint32_t share = (uint32_t)spans->made_share;

	sample(spans, &spans->view, run->count, texel);
	if (share > 0) {
		sample(spans, &spans->next_view, run->count, next);
		for (uint32_t i = 0; i < run->count; i++) {
			texel[i] = mix(texel[i], next[i], share);
		}
	}
	run->first_texel = (const uint8_t *)texel;
	run->texels = run->first_texel;
	run->texel = 0;
	run->s = 0;
	run->t = 0;
	spans->draw(run);
}
