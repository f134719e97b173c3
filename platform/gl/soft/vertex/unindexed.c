/* Lists of triangles without indices: which vertices come again. */
#include "platform/gl/soft/vertex/primitive.h"

/* An array in use, as words to compare. */
struct stream {
	const uint8_t *pointer;
	size_t stride_bytes;
	int words;
};

/* Whole words alone are compared, and seldom is something else given. */
static bool is_of_words(const struct array *array)
{
	return array->type == GL_FLOAT || array->type == GL_FIXED ||
		(array->type == GL_UNSIGNED_BYTE && array->size == 4);
}

/* The arrays in use, by their addresses; interleaved ones are one stream. */
static int list_streams(const struct arrays *arrays, struct stream *streams)
{
	const struct array *const all[] = {&arrays->vertex, &arrays->normal,
		&arrays->color, &arrays->texcoord[0], &arrays->texcoord[1]};
	int used = 0, count = 0;

	for (size_t i = 0; i < ARRAY_COUNT(all); i++) {
		int at = used;

		if (!all[i]->enabled) {
			continue;
		}
		if (!is_of_words(all[i])) {
			return 0;
		}
		for (; at > 0 && streams[at - 1].pointer > all[i]->pointer;
			at--) {
			streams[at] = streams[at - 1];
		}
		streams[at] = (struct stream){all[i]->pointer,
			(size_t)all[i]->stride_bytes,
			all[i]->type == GL_UNSIGNED_BYTE ? 1 : all[i]->size};
		used++;
	}
	for (int i = 0; i < used; i++) {
		struct stream *last = count > 0 ? &streams[count - 1] : NULL;

		if (last && last->stride_bytes == streams[i].stride_bytes &&
			last->pointer + 4 * last->words == streams[i].pointer) {
			last->words += streams[i].words;
		} else {
			streams[count++] = streams[i];
		}
	}
	return count;
}

static bool are_equal_words(const uint8_t *left, const uint8_t *right, int words)
{
	uint32_t differ = 0;

	for (int i = 0; i < words; i++) {
		differ |= load_32(left + 4 * i) ^ load_32(right + 4 * i);
	}
	return differ == 0;
}

static bool are_equal_streams(
	const struct stream *streams, int count, uint32_t a, uint32_t b)
{
	for (int i = 0; i < count; i++) {
		const struct stream *stream = &streams[i];

		if (!are_equal_words(stream->pointer + a * stream->stride_bytes,
			    stream->pointer + b * stream->stride_bytes,
			    stream->words)) {
			return false;
		}
	}
	return true;
}

static ALWAYS_INLINE uint32_t choose_slot(uint32_t x, uint32_t y, uint32_t z)
{
	return (x + (y << 3) + (y >> 9) - (z >> 5)) * 2654435761u >> 23;
}

static const uint8_t *find_position(const struct draw *draw, uint32_t index)
{
	return draw->view.positions +
		(size_t)index * (size_t)draw->view.stride_bytes;
}

/* By what the vertex is made of: unindexed lists give it several times. */
static struct vertex *find_dedup(struct draw *draw,
	const struct stream *streams, int count, uint32_t index)
{
	const uint8_t *at = find_position(draw, index);
	uint32_t slot =
		choose_slot(load_32(at), load_32(at + 4), load_32(at + 8));
	struct vertex *vertex = &draw->cache[slot];

	if (draw->place[slot].tag == PLACE_EMPTY ||
		!are_equal_streams(streams, count, vertex->index, index)) {
		soft_load_slot(draw, slot, index);
	}
	return vertex;
}

static NEVER_INLINE void draw_dedup(struct draw *draw,
	const struct stream *streams, int stream_count, uint32_t index)
{
	struct vertex *v[3];

	for (uint32_t i = 0; i < 3; i++) {
		v[i] = find_dedup(draw, streams, stream_count, index + i);
	}
	if (v[0] == v[1] || v[0] == v[2]) {
		v[0] = &draw->apart[0];
		soft_transform(draw, index, v[0]);
	}
	if (v[1] == v[2]) {
		v[1] = &draw->apart[1];
		soft_transform(draw, index + 1, v[1]);
	}
	draw_transformed(draw, v);
}

/* A triangle of whose vertices two share a slot, or one lies outside. */
static NEVER_INLINE void draw_apart(
	struct draw *draw, const struct stream *stream, uint32_t index)
{
	const uint8_t *a = find_position(draw, index);
	const uint8_t *b = find_position(draw, index + 1);
	const uint8_t *c = find_position(draw, index + 2);

	/* Where two positions are equal, as at a sphere's poles, none is seen. */
	if (!are_equal_words(a, b, 3) && !are_equal_words(a, c, 3) &&
		!are_equal_words(b, c, 3)) {
		draw_dedup(draw, stream, 1, index);
	}
}

/* Of tags that are there: whether two share one, or one lies outside. */
static bool is_apart(const struct cache_tag *a, const struct cache_tag *b,
	const struct cache_tag *c)
{
	return a->tag == TAG_OUTSIDE || b->tag == TAG_OUTSIDE ||
		c->tag == TAG_OUTSIDE || a == b || a == c || b == c;
}

static ALWAYS_INLINE bool is_seen(
	const struct fast_setup *fast_setup, int32_t twice_area)
{
	return twice_area != 0 &&
		(((uint32_t)twice_area ^ fast_setup->cull_side) &
			fast_setup->cull_mask) == 0;
}

/*
 * Whether vertices of four words or more are equal; the first has these. Of an
 * odd number the last pair has a word of the one before.
 */
static ALWAYS_INLINE bool are_equal_pairs(const uint8_t *left,
	const uint8_t *right, uint64_t xy, uint64_t z, int words)
{
	if (load_two_words(right) != xy || load_two_words(right + 8) != z) {
		return false;
	}
	for (int i = 4; i < words; i += 2) {
		int at = 4 * (i < words - 1 ? i : words - 2);

		if (load_two_words(left + at) != load_two_words(right + at)) {
			return false;
		}
	}
	return true;
}

static ALWAYS_INLINE uint32_t find_index(
	const struct stream *stream, const uint8_t *at)
{
	return (uint32_t)((size_t)(at - stream->pointer) / stream->stride_bytes);
}

/* As find_dedup(), of pairs of words: its tag, and if its slot was filled. */
static ALWAYS_INLINE const struct cache_tag *find_pairs(struct draw *draw,
	const struct stream *stream, const uint8_t *at, bool *filled)
{
	const struct cache_tag *place = draw->place;
	uint64_t xy = load_two_words(at), z = load_two_words(at + 8);
	const struct cache_tag *tag = place +
		choose_slot((uint32_t)xy, (uint32_t)(xy >> 32), (uint32_t)z);

	OPAQUE(tag); /* else the slot is kept beside it */
	if (tag->tag >= TAG_OUTSIDE ||
		!are_equal_pairs(at,
			stream->pointer + tag->tag * stream->stride_bytes, xy,
			z, stream->words)) {
		soft_load_slot(
			draw, (uint32_t)(tag - place), find_index(stream, at));
		*filled = true;
	}
	return tag;
}

/* What most lists are: all of a vertex together. */
static ALWAYS_INLINE void draw_pairs(struct draw *draw,
	const struct stream *stream, int words, size_t stride_bytes,
	uint32_t first, uint32_t count)
{
	const struct stream own = {stream->pointer, stride_bytes, words};
	const uint8_t *at = own.pointer + first * stride_bytes;
	const uint8_t *end = at + count / 3 * 3 * stride_bytes;

	for (; at != end; at += 3 * stride_bytes) {
		bool filled = false;
		const struct cache_tag *a = find_pairs(draw, &own, at, &filled);
		const struct cache_tag *b =
			find_pairs(draw, &own, at + stride_bytes, &filled);
		const struct cache_tag *c =
			find_pairs(draw, &own, at + 2 * stride_bytes, &filled);
		int32_t twice;

		PRELOAD(at + 4 * stride_bytes);
		if (filled && is_apart(a, b, c)) {
			draw_apart(draw, stream, find_index(&own, at));
			continue;
		}
		twice = cross_halves(subtract_halves(b->xy, a->xy),
			subtract_halves(c->xy, a->xy));
		if (is_seen(&draw->fast_setup, twice)) {
			soft_draw_tagged(draw, a, b, c, twice);
		}
	}
}

#define DRAW_PAIRS(name, words, stride_bytes)                                \
	static NEVER_INLINE void draw_##name(struct draw *draw,              \
		const struct stream *stream, uint32_t first, uint32_t count) \
	{                                                                    \
		draw_pairs(draw, stream, words, stride_bytes, first, count); \
	}

/* The sizes that most programs use are constants of the loop. */
DRAW_PAIRS(eight, 8, 32)
DRAW_PAIRS(six_of_eight, 6, 32)
DRAW_PAIRS(six, 6, 24)
DRAW_PAIRS(any, stream->words, stream->stride_bytes)

static void draw_together(struct draw *draw, const struct stream *stream,
	uint32_t first, uint32_t count)
{
	if (stream->words == 8 && stream->stride_bytes == 32) {
		draw_eight(draw, stream, first, count);
	} else if (stream->words == 6 && stream->stride_bytes == 32) {
		draw_six_of_eight(draw, stream, first, count);
	} else if (stream->words == 6 && stream->stride_bytes == 24) {
		draw_six(draw, stream, first, count);
	} else {
		draw_any(draw, stream, first, count);
	}
}

bool soft_draw_unindexed(struct draw *draw, uint32_t first, uint32_t count)
{
	const struct arrays *arrays = &draw->soft->arrays;
	struct stream streams[3 + SOFT_UNITS];
	int used = arrays->vertex.size == 3 ? list_streams(arrays, streams) : 0;

	if (used == 1 && streams->words >= 4 && draw->packed &&
		((uintptr_t)streams->pointer | streams->stride_bytes) % 4 == 0) {
		draw_together(draw, streams, first, count);
		return true;
	}
	for (uint32_t i = 0; i + 2 < count && used > 0; i += 3) {
		draw_dedup(draw, streams, used, first + i);
	}
	return used > 0;
}
