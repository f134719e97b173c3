/* The level of detail that runs are drawn from, and its window. */
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/texels.h"
#include "platform/gl/soft/span/walk.h"
#include "platform/gl/soft/vertex/number.h"

static void choose_level(struct draw *draw, int number, bool small)
{
	struct soft_spans *spans = &draw->spans;
	const struct texture_input *input = &draw->texture[0];
	GLenum min = input->texture->min_filter;
	bool linear = small ? min == GL_LINEAR || min == GL_LINEAR_MIPMAP_NEAREST
			    : input->texture->mag_filter == GL_LINEAR;

	spans->level = number;
	spans->small = small;
	spans->view = soft_find_view(input, number, linear);
	soft_set_functions(spans, small ? spans->min : spans->mag);
	soft_use_view(&spans->view, &spans->run);
	spans->window = spans->view.window;
}

void soft_set_level(struct draw *draw, int lod)
{
	struct soft_spans *spans = &draw->spans;
	const struct texture_input *input = &draw->texture[0];
	bool small;
	int number;

	if (spans->set_level) {
		spans->set_level(draw, lod);
		return;
	}
	small = soft_rows_is_small(input, lod);
	number = small ? clamp_int((lod + 127) >> 8, 0, input->levels - 1) : 0;
	if (number != spans->level || small != spans->small) {
		choose_level(draw, number, small);
	}
}

/*
 * What of the window the triangle needs, with so much to spare, up to the
 * level's edges. False where no run can lie in it.
 */
static bool find_window_part(
	struct soft_spans *spans, const struct raster *raster, int32_t spare)
{
	const struct soft_view *view = &spans->view;
	const struct soft_window *whole = &view->window;
	const uint32_t most = SOFT_RUN_TEXELS << SOFT_TEXEL_FRACTION;
	const struct texel_place s = soft_find_place(raster->texel_range[0][0],
		raster->texel_range[0][1], view->s_shift, view->s_half, spare,
		whole->s_mask);
	const struct texel_place t = soft_find_place(raster->texel_range[1][0],
		raster->texel_range[1][1], view->t_shift, view->t_half, spare,
		whole->t_mask);

	if (s.room >= most || t.room >= most || s.first >= whole->s_room ||
		t.first >= whole->t_room) {
		return false;
	}
	spans->part = (struct soft_window){s.first, t.first, whole->s_mask,
		whole->t_mask, s.room, t.room, false};
	spans->part_s = (uint32_t)s.low;
	spans->part_t = (uint32_t)t.low;
	spans->part_texel = view->texels +
		(t.first >> SOFT_TEXEL_FRACTION << view->stride_log2) +
		(s.first >> SOFT_TEXEL_FRACTION << view->texel_log2);
	return true;
}

/* Cuts it off at the level's edges. False where nothing is cut off. */
static bool cut_part(struct soft_spans *spans)
{
	struct soft_window *part = &spans->part;
	uint32_t s_room = spans->view.window.s_room - part->s_first;
	uint32_t t_room = spans->view.window.t_room - part->t_first;

	if (part->s_room <= s_room && part->t_room <= t_room) {
		return false;
	}
	part->s_room = part->s_room < s_room ? part->s_room : s_room;
	part->t_room = part->t_room < t_room ? part->t_room : t_room;
	return true;
}

/* An eighth of a texel; a texel where values bend, see bend.c. */
void soft_set_window(struct draw *draw)
{
	const struct raster *raster = &draw->raster;
	struct soft_spans *spans = &draw->spans;
	const int32_t spare = 1 << (SOFT_TEXEL_FRACTION - 3);

	spans->window = spans->view.window;
	spans->run.first_texel = spans->run.texels;
	if (!find_window_part(spans, raster, raster->bent ? 8 * spare : spare) ||
		cut_part(spans)) {
		if (!find_window_part(spans, raster, spare)) {
			spans->part = spans->window;
			spans->part_texel = spans->run.texels;
			spans->part_s = spans->part_t = 0;
			return;
		}
		if (cut_part(spans)) {
			return;
		}
	}
	spans->window = spans->part;
	spans->run.first_texel = spans->part_texel;
}
