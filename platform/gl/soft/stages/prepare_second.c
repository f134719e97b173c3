/* Chooses span functions that read a second texture's texels, and how. */
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/spans.h"
#include "platform/gl/soft/stages/combine_rows.h"
#include "platform/gl/soft/stages/made.h"
#include "platform/gl/soft/vertex/draw.h"

#include <string.h>

/* Whether both textures have colours, and the first's environment is simple. */
static bool is_pair(const struct draw *draw)
{
	const struct texture_input *first = &draw->texture[0];
	const struct texture_input *second = &draw->texture[1];

	return draw->spans.textured && second->used && !draw->smooth &&
		soft_is_simple_environment(first) &&
		first->base->format != TEXEL_A8 &&
		second->base->format != TEXEL_A8;
}

/*
 * The finish that also draws the second of a pair; finish where there is none.
 * The alpha of opaque fragments does not matter.
 */
static enum soft_finish find_second_finish(
	const struct draw *draw, enum soft_finish finish)
{
	const struct texture_input *input = &draw->texture[1];

	if (!draw->spans.wide &&
		(soft_adds(input, GL_TEXTURE) ||
			(input->mode == GL_ADD && finish == SOFT_OPAQUE))) {
		return finish <= SOFT_BLENDED
			? (enum soft_finish)(SOFT_SUMMED + finish)
			: finish;
	}
	return input->mode == GL_MODULATE && finish == SOFT_OPAQUE ? SOFT_SCALED
								   : finish;
}

static bool has_joined_formats(const struct draw *draw)
{
	const enum texel_format first = draw->texture[0].base->format;
	const enum texel_format second = draw->texture[1].base->format;

	return draw->spans.wide ? first == TEXEL_8888 && second == TEXEL_8888
				: (first == TEXEL_565 || first == TEXEL_4444) &&
			second == TEXEL_565;
}

/* Whether both textures have the same coordinates, sizes, levels and filters. */
static bool are_joined(const struct draw *draw)
{
	const struct texture_input *a = &draw->texture[0], *b = a + 1;
	const struct texture *first = a->texture, *second = b->texture;

	return has_joined_formats(draw) && a->levels == b->levels &&
		!soft_rows_mixes_levels(a) && a->width_log2 == b->width_log2 &&
		a->height_log2 == b->height_log2 &&
		first->min_filter == second->min_filter &&
		first->mag_filter == second->mag_filter &&
		first->wrap_s == second->wrap_s &&
		first->wrap_t == second->wrap_t && draw->same_texcoords &&
		a->matrix_q == b->matrix_q &&
		memcmp(a->matrix, b->matrix, sizeof(a->matrix)) == 0;
}

bool soft_choose_second(struct draw *draw)
{
	struct soft_spans *spans = &draw->spans;
	struct soft_levels *levels = &spans->levels[1];
	const bool pair = is_pair(draw);
	const enum soft_finish finish =
		pair ? find_second_finish(draw, spans->finish) : spans->finish;

	levels->level = -1;
	levels->packed = false;
	spans->read_second = NULL;
	spans->joined = false;
	spans->multiplied = false;
	if (finish == spans->finish) {
		/* an alpha test needs alpha rounded after each stage */
		spans->multiplied = pair && !spans->alpha_tested &&
			draw->texture[1].mode == GL_MODULATE;
		return false;
	}
	spans->finish = finish;
	spans->joined = are_joined(draw);
	spans->read_second = spans->joined ? NULL : soft_read_second;
	spans->table = spans->joined ? &soft_spans_joined
		: spans->wide        ? &soft_spans_scaled
				     : &soft_spans_second;
	levels->packed = !spans->wide &&
		draw->texture[1].base->format == TEXEL_565 &&
		!soft_rows_mixes_levels(&draw->texture[1]);
	return true;
}
