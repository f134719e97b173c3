/* DrawArrays and DrawElements: from indices to primitives. */
#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/state/state.h"
#include "platform/gl/soft/vertex/cache.h"

/* Draws two triangles from the i-th index on if they are a rectangle of text. */
static bool draw_rectangle(
	struct draw *draw, const struct source *source, uint32_t i)
{
	struct vertex *v[4];

	if (i + 5 >= source->count) {
		return false;
	}
	for (uint32_t j = 0; j < 4; j++) {
		v[j] = find_vertex(draw, source, j < 3 ? i + j : i + 5);
	}
	/* the second triangle is v[2] v[1] v[3]; two may need the same slot */
	for (uint32_t j = 0; j < 5; j++) {
		if (v[j < 3 ? j : 5 - j]->index != index_at(source, i + j)) {
			return false;
		}
	}
	return soft_fill_rectangle(draw, v);
}

static void draw_line(
	struct draw *draw, const struct source *source, uint32_t a, uint32_t b)
{
	struct vertex *v[2];

	soft_find_vertices(draw, source, (uint32_t[]){a, b}, 2, v);
	if (v[0]->outcode & v[1]->outcode) {
		return;
	}
	draw->provoking = v[1];
	soft_shade(draw, v[0]);
	soft_shade(draw, v[1]);
	if (v[0]->outcode | v[1]->outcode) {
		soft_clip_line(draw, v[0], v[1]);
	} else {
		soft_draw_line(draw, v[0], v[1]);
	}
}

static void draw_lines(
	struct draw *draw, const struct source *source, GLenum mode)
{
	uint32_t step = mode == GL_LINES ? 2 : 1;

	for (uint32_t i = 0; i + 1 < source->count; i += step) {
		draw_line(draw, source, i, i + 1);
	}
	if (mode == GL_LINE_LOOP && source->count > 1) {
		draw_line(draw, source, source->count - 1, 0);
	}
}

/* Whether y, z, w and all attributes but texture coordinates are the same. */
static bool are_alike(
	const struct draw *draw, const struct vertex *a, const struct vertex *b)
{
	int32_t z = a->z - b->z, w = a->clip[3] - b->clip[3];

	for (int i = RED; i < TEX_S; i++) {
		if ((draw->attributes >> i & 1) &&
			a->attribute[i] != b->attribute[i]) {
			return false;
		}
	}
	return a->y == b->y && z >= -1 && z <= 1 && w <= a->clip[3] >> 16 &&
		-w <= a->clip[3] >> 16;
}

/* Whether a coordinate's change from v[0] to v[1] is that from v[2] to v[3]. */
static bool changes_alike(struct vertex *const v[4], int name)
{
	int64_t there = (int64_t)v[3]->attribute[name] - v[2]->attribute[name];
	int64_t here = (int64_t)v[1]->attribute[name] - v[0]->attribute[name];
	int64_t apart = there * v[0]->clip[3] - here * v[2]->clip[3];
	int64_t most = (int64_t)v[2]->clip[3] << 6;

	return apart <= most && -apart <= most;
}

/*
 * Whether two triangles of a strip are an upright rectangle of the picture, as
 * level planes and gradients are. Rectangles of up to SMALL_EXTENT are refused:
 * their texture coordinates might be polynomials, which depend on all corners.
 */
static bool is_upright(struct draw *draw, struct vertex *const v[4])
{
	if ((v[0]->outcode | v[1]->outcode | v[2]->outcode | v[3]->outcode) ||
		v[0] == v[1] || v[0]->x != v[2]->x || v[1]->x != v[3]->x ||
		v[1]->x - v[0]->x <= SMALL_EXTENT || v[0]->y == v[2]->y) {
		return false;
	}
	for (int i = 0; i < 4; i++) {
		soft_shade(draw, v[i]);
	}
	return are_alike(draw, v[0], v[1]) && are_alike(draw, v[2], v[3]) &&
		(!draw->texture[0].used ||
			(changes_alike(v, TEX_S) && changes_alike(v, TEX_S + 1)));
}

/* Draws two triangles of a strip at once, so that each row is a single run. */
static bool draw_upright(
	struct draw *draw, const struct source *source, uint32_t first)
{
	struct vertex *v[4];
	bool upwards;

	for (uint32_t i = 0; i < 4; i++) {
		v[i] = find_vertex(draw, source, first + i);
	}
	if (!is_upright(draw, v)) {
		return false;
	}
	/* both triangles have the winding of the strip's first one */
	upwards = v[0]->y > v[2]->y;
	draw->fourth = upwards ? v[1] : v[3];
	draw->provoking = v[3];
	soft_fill_triangle(draw,
		upwards ? (struct vertex *[]){v[3], v[2], v[0]}
			: (struct vertex *[]){v[0], v[1], v[2]});
	draw->fourth = NULL;
	return true;
}

/* Whether the state's rows cost so much that joining triangles is worth it. */
static bool fills_whole_rows(const struct draw *draw)
{
	return !draw->cull_front && !draw->cull_back &&
		(draw->fast_setup.fill == soft_fill_luminance ||
			(draw->fast_setup.fill == soft_rows_fill &&
				draw->spans.whole_rows &&
				!draw->texture[0].used));
}

/* Draws triangles of any mode: as lists of 16-bit indices, or one by one. */
static void draw_triangles(
	struct draw *draw, const struct source *source, GLenum mode)
{
	const bool strip = mode == GL_TRIANGLE_STRIP;
	const bool upright = strip && fills_whole_rows(draw);
	const bool text = mode == GL_TRIANGLES && draw->rectangles;
	/* soft_list() can draw them by indices that are made for it */
	const bool listed = draw->packed && !upright && !text &&
		(source->indices ||
			source->first + source->count <= CACHE_INDICES);
	uint16_t index[CACHE_LIST];
	struct source list = {
		.indices = (const uint8_t *)index, .type = GL_UNSIGNED_SHORT};

	for (uint32_t i = 0; i + 2 < source->count;
		i += mode == GL_TRIANGLES ? 3 : 1) {
		/* Every second one of a strip has its first vertices swapped. */
		const uint32_t odd = strip ? i % 2 : 0;
		const uint32_t a = mode == GL_TRIANGLE_FAN ? 0 : i + odd;
		const uint32_t b = i + 1 - odd;

		if (upright && i + 3 < source->count &&
			draw_upright(draw, source, i)) {
			i++;
		} else if (text && draw_rectangle(draw, source, i)) {
			i += 3;
		} else if (!listed) {
			soft_draw_triangle(draw, source, a, b, i + 2);
		} else {
			index[list.count++] = (uint16_t)index_at(source, a);
			index[list.count++] = (uint16_t)index_at(source, b);
			index[list.count++] = (uint16_t)index_at(source, i + 2);
		}
		if (list.count == CACHE_LIST) {
			soft_list(draw, &list);
			list.count = 0;
		}
	}
	soft_list(draw, &list);
}

/* Empties count slots of the cache: PLACE_EMPTY is all ones. */
static void empty_slots(struct draw *draw, uint32_t first, uint32_t count)
{
	soft_fill_pixels((uint16_t *)(void *)(draw->place + first),
		(int)(count * (sizeof(struct cache_tag) / 2)), UINT16_MAX);
}

static void draw_primitives(
	struct draw *draw, const struct source *source, GLenum mode)
{
	const bool plain = mode == GL_TRIANGLES && !draw->rectangles;
	const uint32_t slot = source->first % VERTEX_CACHE;

	if (!source->indices && slot + source->count < VERTEX_CACHE) {
		empty_slots(draw, slot, source->count);
	} else {
		empty_slots(draw, 0, VERTEX_CACHE);
	}
	if (draw->soft->counts) {
		soft_count_call(draw, source, mode);
		soft_prepare_fast_setup(draw->soft, draw);
	}
	if (mode == GL_POINTS) {
		for (uint32_t i = 0; i < source->count; i++) {
			soft_draw_point(draw, find_vertex(draw, source, i));
		}
	} else if (mode <= GL_LINE_STRIP) {
		draw_lines(draw, source, mode);
	} else if (plain && draw->packed && source->indices &&
		source->type == GL_UNSIGNED_SHORT &&
		(uintptr_t)source->indices % 2 == 0) {
		soft_list(draw, source);
	} else if (!plain || source->indices ||
		!soft_draw_unindexed(draw, source->first, source->count)) {
		draw_triangles(draw, source, mode);
	}
}

/* Checks what both calls have in common; false where nothing is to be drawn. */
static bool may_draw(GLenum mode, GLsizei count)
{
	return soft_check(mode <= GL_TRIANGLE_FAN, GL_INVALID_ENUM) &&
		soft_check(count >= 0, GL_INVALID_VALUE) && count > 0;
}

void soft_gl_DrawArrays(GLenum mode, GLint first, GLsizei count)
{
	struct soft *soft = soft_current();
	const struct source source = {
		.first = (uint32_t)first, .count = (uint32_t)count};

	if (soft_check(first >= 0, GL_INVALID_VALUE) && may_draw(mode, count) &&
		soft_prepare(
			soft, soft->draw, mode, source.first, source.count)) {
		draw_primitives(soft->draw, &source, mode);
	}
}

void soft_gl_DrawElements(
	GLenum mode, GLsizei count, GLenum type, const void *indices)
{
	struct soft *soft = soft_current();
	const struct source source = {
		.indices = indices, .type = type, .count = (uint32_t)count};
	uint32_t low = UINT32_MAX, high = 0;

	if (!soft_check(IS_ONE_OF(type, GL_UNSIGNED_BYTE, GL_UNSIGNED_SHORT),
		    GL_INVALID_ENUM) ||
		!may_draw(mode, count)) {
		return;
	}
	/* The range of indices decides the scale of numbers with fractions. */
	if (IS_ONE_OF(soft->arrays.vertex.type, GL_FLOAT, GL_FIXED)) {
		for (uint32_t i = 0; i < source.count; i++) {
			uint32_t index = index_at(&source, i);

			low = index < low ? index : low;
			high = index > high ? index : high;
		}
	}
	if (soft_prepare(soft, soft->draw, mode, low, high - low + 1)) {
		draw_primitives(soft->draw, &source, mode);
	}
}
