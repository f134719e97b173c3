/* Derives from the state what a draw call needs (struct draw). */
#include "platform/gl/soft/stages/combine_rows.h"
#include "platform/gl/soft/state/matrix.h"
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

#include <stdlib.h>
#include <string.h>

#include "platform/base/scalar.h"

enum {
	/* exponents of the largest coordinate that positions are scaled for */
	EXPONENT_LEAST = -20,
	EXPONENT_MOST = 29,
};

static bool is_same_array(const struct array *a, const struct array *b)
{
	return a->enabled && b->enabled && a->size == b->size &&
		a->type == b->type && a->stride_bytes == b->stride_bytes &&
		a->pointer == b->pointer;
}

static void prepare_arrays(struct soft *soft, struct draw *draw)
{
	const struct array *array = &soft->arrays.vertex;
	const struct array *texcoord = soft->arrays.texcoord;
	const bool same = is_same_array(&texcoord[0], &texcoord[1]);
	struct view *view = &draw->view;
	const enum position_kind kind = view->kind;
	bool aligned;

	draw->checked = draw->exponent > EXPONENT_MOST;
	/* |position| < 2^30 */
	draw->position_q =
		29 - clamp_int(draw->exponent, EXPONENT_LEAST, EXPONENT_MOST);
	view->scale = soft_matrix_power_of_two(draw->position_q);
	aligned = ((uintptr_t)array->pointer | (uintptr_t)array->stride_bytes) %
			4 ==
		0;
	view->kind = array->size < 3      ? POSITION_OTHER
		: array->type == GL_SHORT ? POSITION_SHORTS
		: array->type == GL_FLOAT && aligned && !draw->checked
		? POSITION_FLOATS
		: POSITION_OTHER;
	view->positions = array->pointer;
	view->stride_bytes = array->stride_bytes;
	soft->changed |= kind != view->kind ? GROUP_SCALE : 0;
	soft->changed |= same != draw->same_texcoords ? GROUP_TEXTURES : 0;
	draw->same_texcoords = same;
}

/* The largest clip coordinate that a row gives for positions up to most. */
static float row_bound(const struct matrix *m, int row, float most)
{
	return (scalar_abs(m->m[row]) + scalar_abs(m->m[4 + row]) +
		       scalar_abs(m->m[8 + row])) *
		most +
		scalar_abs(m->m[12 + row]);
}

/*
 * The fraction bits with which products of a matrix's first rows and positions
 * stay below 2^28; *scale is the matrix's, if they are shifted right by 32.
 * Positions and the matrix's elements are below 2^30 then.
 */
static int find_scale(
	const struct matrix *m, int rows, int position_q, float *scale)
{
	float bound = 0.0f;
	int q;

	for (int row = 0; row < rows; row++) {
		float b = row_bound(
			m, row, soft_matrix_power_of_two(30 - position_q));

		bound = b > bound ? b : bound;
	}
	q = clamp_int(27 - soft_matrix_exponent(bound), -60, 90);
	*scale = soft_matrix_power_of_two(q - position_q + 32); /* -77 to 122 */
	return q;
}

static void prepare_clip(struct soft *soft, struct draw *draw)
{
	float scale, moved;
	struct view *view = &draw->view;
	const bool perspective = draw->perspective;
	int32_t *rows[4] = {view->row_x, view->row_y, view->row_z, view->row_w};
	/* shorts have a position_q of 14: m (p << 14) >> 32 is (m >> 2) p >> 16 */
	int shift = view->kind == POSITION_SHORTS ? 2 : 0;
	const struct matrix m =
		soft_matrix_multiply(soft->matrices.stack[STACK_PROJECTION].top,
			soft->matrices.stack[STACK_MODELVIEW].top);

	moved = soft_matrix_power_of_two(
		find_scale(&m, 4, draw->position_q, &scale));
	for (int row = 0; row < 4; row++) {
		for (int column = 0; column < 3; column++) {
			rows[row][column] =
				soft_matrix_to_int(
					m.m[4 * column + row] * scale) >>
				shift;
		}
	}
	view->moved_x = soft_matrix_to_int(m.m[12] * moved);
	view->moved_y = soft_matrix_to_int(m.m[13] * moved);
	view->moved_z = soft_matrix_to_int(m.m[14] * moved);
	view->moved_w = soft_matrix_to_int(m.m[15] * moved);
	draw->perspective = m.m[3] != 0.0f || m.m[7] != 0.0f || m.m[11] != 0.0f;
	soft->changed |= perspective != draw->perspective ? GROUP_FRAGMENTS : 0;
}

/* Whether a row's products with positions are as small as find_scale() says. */
static bool is_bounded(const int32_t row[4])
{
	int64_t sum = 0;

	for (int i = 0; i < 4; i++) {
		int64_t size = row[i] < 0 ? -row[i] : row[i];

		sum += i < 3 ? size / 4 : size;
	}
	return sum < 3 << 27;
}

static bool is_eye_needed(const struct lighting *lighting)
{
	for (int i = 0; i < SOFT_LIGHTS && lighting->enabled; i++) {
		if (lighting->light[i].enabled &&
			lighting->light[i].position[3] != 0.0f) {
			return true;
		}
	}
	return false;
}

/* Rows with numbers that are infinite, or nearly so, become 0. */
static void prepare_eye(struct soft *soft, struct draw *draw)
{
	const struct matrix *m = soft->matrices.stack[STACK_MODELVIEW].top;
	float scale, moved;

	draw->eye_needed = is_eye_needed(&soft->lighting);
	if (!draw->eye_needed && !draw->fogged) {
		return;
	}
	draw->eye_q = find_scale(m, 3, draw->position_q, &scale);
	moved = soft_matrix_power_of_two(draw->eye_q);
	for (int i = 0; i < 12; i++) {
		draw->eye[i % 3][i / 3] = soft_matrix_to_int(
			m->m[i / 3 * 4 + i % 3] * (i < 9 ? scale : moved));
	}
	for (int i = 0; i < 3; i++) {
		if (!is_bounded(draw->eye[i])) {
			memset(draw->eye[i], 0, sizeof(draw->eye[i]));
		}
	}
}

/* Makes tiles of levels again whose texels have changed: only for a draw call. */
static void prepare_tiles(struct texture *texture)
{
	for (int i = 0; i < SOFT_LEVELS; i++) {
		struct level *level = &texture->level[i];

		if (level->changed) {
			soft_tiles_update(level);
			level->changed = false;
		}
	}
}

static void prepare_viewport(struct soft *soft, struct draw *draw)
{
	const struct rectangle *r = &soft->fragment.viewport;
	int height = soft->buffers.target.height;
	struct view *view = &draw->view;

	/* 8 is half of 1/16 in Q8, so that shifting to 4 fraction bits rounds. */
	view->center_x_q8 = r->x * 256 + r->width * 128 + 8;
	view->center_y_q8 = (height - r->y) * 256 - r->height * 128 + 8;
	view->width_q10 = r->width * 1024;
	view->height_q10 = r->height * -1024;
	draw->box = soft_clip_box(soft, true);
}

static void prepare_fog(const struct fog *fog, struct draw *draw)
{
	float range = (float)(fog->end - (int64_t)fog->start) / 65536.0f;
	float scale = range != 0.0f ? 1.0f / range : 32768.0f;

	/* fog_scale is 2^28 to 2^29, whatever the range */
	draw->fog_scale_q = 28 - soft_matrix_exponent(scale);
	draw->fog_scale = soft_matrix_to_int(
		scale * soft_matrix_power_of_two(draw->fog_scale_q));
}

/* The number of levels to use: 0 if the texture is not complete, as in GL. */
static int count_levels(const struct texture *texture)
{
	const struct level *base = &texture->level[0];
	int most = base->width_log2 > base->height_log2 ? base->width_log2
							: base->height_log2;

	if (!base->texels) {
		return 0;
	}
	if (texture->min_filter < GL_NEAREST_MIPMAP_NEAREST) {
		return 1;
	}
	for (int i = 1; i <= most; i++) {
		const struct level *level = &texture->level[i];
		int width = base->width_log2 - i, height = base->height_log2 - i;

		if (!level->texels || level->format != base->format ||
			level->width_log2 != (width > 0 ? width : 0) ||
			level->height_log2 != (height > 0 ? height : 0)) {
			return 0;
		}
	}
	return most + 1;
}

static void prepare_texture_matrix(
	const struct soft *soft, struct texture_input *input, int unit)
{
	const struct matrix *m = soft->matrices.stack[STACK_TEXTURE + unit].top;
	static const int column[3] = {0, 4, 12};
	float values[6], scale;

	input->identity = memcmp(m, &soft_matrix_identity, sizeof(*m)) == 0;
	if (input->identity) {
		return;
	}
	for (int i = 0; i < 6; i++) {
		values[i] = m->m[column[i / 2] + i % 2];
	}
	input->matrix_q = clamp_int(
		29 - soft_matrix_exponent(soft_matrix_largest(values, 6)), 0,
		40);
	scale = soft_matrix_power_of_two(input->matrix_q);
	for (int i = 0; i < 6; i++) {
		input->matrix[i % 2][i / 2] =
			soft_matrix_to_int(values[i] * scale);
	}
}

/* Fills draw->texture; a unit that is used alone becomes the first one. */
static void prepare_textures(const struct soft *soft, struct draw *draw)
{
	int used = 0;

	for (int i = 0; i < SOFT_UNITS; i++) {
		draw->texture[i].used = false;
	}
	for (int i = 0; i < SOFT_UNITS; i++) {
		const struct unit *unit = &soft->textures.unit[i];
		struct texture_input *input = &draw->texture[used];
		int levels = unit->enabled ? count_levels(unit->bound) : 0;

		if (levels == 0) {
			continue;
		}
		input->levels = levels;
		input->used = true;
		used++;
		input->texture = unit->bound;
		input->env = &unit->env;
		input->base = &unit->bound->level[0];
		input->mode = soft_find_mode(
			input->env, input->base->base_format, i == 0);
		input->width_log2 = input->base->width_log2;
		input->height_log2 = input->base->height_log2;
		prepare_texture_matrix(soft, input, i);
		input->array = &soft->arrays.texcoord[i];
	}
}

static void prepare_texcoords(struct soft *soft, struct draw *draw)
{
	(void)soft;
	for (int i = 0; i < SOFT_UNITS && draw->texture[i].used; i++) {
		struct texture_input *input = &draw->texture[i];

		input->plain_floats = input->identity &&
			input->array->enabled && input->array->type == GL_FLOAT;
	}
}

/*
 * If the second texture's environment only adds a constant colour, the texture
 * is not read: span functions add the colour by the same code as fog.
 */
static void prepare_addition(struct draw *draw)
{
	struct texture_input *last = &draw->texture[1];

	draw->added = NULL;
	if (last->used && !draw->fogged && soft_adds(last, GL_CONSTANT)) {
		last->used = false;
		draw->added = last->env->color;
	}
}

static void prepare_fragments(const struct soft *soft, struct draw *draw)
{
	const struct fragment_state *state = &soft->fragment;
	bool both = state->cull_face == GL_FRONT_AND_BACK;
	bool triangles = draw->primitive == GL_TRIANGLES;
	bool cull = state->cull && triangles;

	draw->offset = triangles && state->offset_fill;
	draw->smooth = draw->primitive == GL_POINTS
		? state->point_smooth
		: !triangles && state->line_smooth;
	draw->front_is_ccw = state->front_face == GL_CCW;
	draw->cull_front = cull && (both || state->cull_face == GL_FRONT);
	draw->cull_back = cull && (both || state->cull_face == GL_BACK);
	draw->blended = state->blend &&
		(state->blend_source != GL_ONE ||
			state->blend_destination != GL_ZERO);
}

/* Bits of the attributes that are interpolated. */
static uint32_t choose_attributes(const struct draw *draw)
{
	const struct fragment_state *state = &draw->soft->fragment;
	uint32_t mask = 0;

	if (state->color_bits != 0 || state->alpha_test) {
		mask = 15u << RED;
		if (draw->fogged) {
			mask |= 1u << FOG;
		}
		for (int i = 0; i < SOFT_UNITS; i++) {
			if (draw->texture[i].used) {
				mask |= 3u << (TEX_S + 2 * i);
			}
		}
	}
	return mask;
}

void soft_init_scratch(struct draw *draw)
{
	draw->spans.run.stages = &draw->spans.stages;
	draw->spans.run.draw = draw;
	draw->view.reciprocals = soft_reciprocal_table;
	draw->shading.roots = soft_root_table;
	/* window z is 4 (1 + 65533 (z/w + 1) / 2), 2 fraction bits */
	draw->view.center_z = 131070;
	draw->view.depth = 1048528;
	soft_luminance_init(draw);
	draw->inverse_q31[0] = INT32_MAX;
	draw->inverse_q31[1] = INT32_MAX;
	for (int i = 2; i <= SMALL_EXTENT; i++) {
		draw->inverse_q31[i] = (int32_t)((1u << 31) / (unsigned)i);
	}
}

/* Chooses how fragments are drawn. */
static void prepare_pixels(struct soft *soft, struct draw *draw)
{
	prepare_fragments(soft, draw);
	draw->fogged = soft->fog.enabled;
	if (draw->fogged) {
		prepare_fog(&soft->fog, draw);
	}
	prepare_textures(soft, draw);
	prepare_addition(draw);
	draw->attributes = choose_attributes(draw);
	draw->shade_more = draw->fogged || draw->texture[0].used;
	draw->passes = soft_prepare_spans(draw);
	draw->hides = draw->spans.depth_by_less && !draw->offset;
	/* Span functions use the first texture's coordinates for both. */
	if (draw->spans.joined) {
		draw->texture[1].used = false;
		draw->attributes &= ~(3u << (TEX_S + 2));
	}
	/* Alpha is interpolated only if fragments read it. */
	if (!draw->spans.alpha_read) {
		draw->attributes &= ~(1u << ALPHA);
	}
	draw->lists = soft_lists_primitives(draw);
	soft_choose_path(draw);
	if (draw->divides) { /* soft_fill_luminance() draws by tiles */
		prepare_tiles(draw->texture[0].texture);
	}
}

/* Prepares a part anew if a group that it reads has changed. */
static ALWAYS_INLINE void redo(struct soft *soft, uint32_t reads,
	void (*part)(struct soft *soft, struct draw *draw))
{
	if (soft->changed & reads) {
		part(soft, soft->draw);
	}
}

/*
 * The parts of the preparation, in the order in which they use each other's
 * results, with the groups of the state that each reads. Where a result changes
 * what a later part does, the earlier one adds a group that the later one reads.
 */
static void prepare(struct soft *soft, struct draw *draw)
{
	const uint32_t pixels = GROUP_FRAGMENTS | GROUP_TEXTURES;
	const uint32_t vertices = GROUP_MATRICES | GROUP_SCALE;
	const uint32_t lights = GROUP_LIGHTING |
		(soft->lighting.color_material ? GROUP_COLOR : 0);

	redo(soft, GROUP_VIEWPORT, prepare_viewport);
	redo(soft, GROUP_ARRAYS | GROUP_SCALE, prepare_arrays);
	redo(soft, vertices, prepare_clip);
	redo(soft, pixels, prepare_pixels);
	redo(soft, pixels | GROUP_ARRAYS, prepare_texcoords);
	redo(soft, vertices | pixels | GROUP_LIGHTING, prepare_eye);
	redo(soft, pixels | GROUP_LIGHTING, soft_prepare_sides);
	if (soft->lighting.enabled) {
		redo(soft, GROUP_MATRICES | GROUP_LIGHTING,
			soft_prepare_normals);
		redo(soft, lights, soft_prepare_sources);
		redo(soft, vertices | GROUP_LIGHTING, soft_prepare_directions);
		redo(soft, vertices | GROUP_LIGHTING | GROUP_ARRAYS,
			soft_prepare_lit_arrays);
	}
	redo(soft, pixels | GROUP_COLOR, soft_prepare_flat);
	redo(soft, pixels | GROUP_VIEWPORT | GROUP_LIGHTING,
		soft_prepare_fast_setup);
	draw->draws = draw->passes && draw->box.left < draw->box.right &&
		draw->box.top < draw->box.bottom;
	soft->changed = 0;
}

bool soft_prepare(struct soft *soft, struct draw *draw, GLenum mode,
	uint32_t first, uint32_t count)
{
	const GLenum primitive = mode > GL_LINE_STRIP ? GL_TRIANGLES
		: mode > GL_POINTS                    ? GL_LINES
						      : GL_POINTS;
	int exponent;

	if (!soft->buffers.target.data || !soft->arrays.vertex.enabled) {
		return false;
	}
	exponent = soft_array_position_exponent(
		&soft->arrays.vertex, first, count);
	if (soft->changed || exponent != draw->exponent ||
		primitive != draw->primitive) {
		soft->changed |= exponent != draw->exponent ? GROUP_SCALE : 0;
		soft->changed |=
			primitive != draw->primitive ? GROUP_FRAGMENTS : 0;
		draw->exponent = exponent;
		draw->primitive = primitive;
		prepare(soft, draw);
	}
	return draw->draws;
}
