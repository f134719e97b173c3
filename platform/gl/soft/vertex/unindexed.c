/*
 * Lists of triangles without indices: finds vertices that come again, and sets
 * those up that are on the screen, as arm/list.S does by indices.
 */
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/vertex/primitive.h"

/* Vertices whose arrays lie together, as words to compare. */
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

/* False where the arrays in use do not lie together. */
static bool find_stream(const struct arrays *arrays, struct stream *stream)
{
	const struct array *const all[] = {&arrays->vertex, &arrays->normal,
		&arrays->color, &arrays->texcoord[0], &arrays->texcoord[1]};
	uintptr_t least = UINTPTR_MAX, most = 0;

	for (size_t i = 0; i < ARRAY_COUNT(all); i++) {
		const struct array *array = all[i];
		uintptr_t at = (uintptr_t)array->pointer;
		int words = array->type == GL_UNSIGNED_BYTE ? 1 : array->size;

		if (!array->enabled) {
			continue;
		}
		if (!is_of_words(array) || array->stride_bytes % 4 != 0 ||
			array->stride_bytes != arrays->vertex.stride_bytes ||
			at % 4 != 0) {
			return false;
		}
		least = at < least ? at : least;
		at += 4 * (uintptr_t)words;
		most = at > most ? at : most;
	}
	stream->stride_bytes = (size_t)arrays->vertex.stride_bytes;
	stream->pointer = arrays->vertex.pointer -
		((uintptr_t)arrays->vertex.pointer - least);
	stream->words = (int)((most - least) / 4);
	return most - least <= stream->stride_bytes && stream->words >= 4;
}

static ALWAYS_INLINE uint32_t find_index(
	const struct stream *stream, const uint8_t *at)
{
	return (uint32_t)((size_t)(at - stream->pointer) / stream->stride_bytes);
}

struct corner {
	uint32_t xy; /* as struct cache_tag has it */
	struct vertex *vertex;
};

/*
 * Rows, columns and size of corners as struct cache_tag has them. False where
 * no centre is covered; *all is whether all of the triangle is in the box.
 */
static ALWAYS_INLINE bool find_extent(const struct fast_setup *fast_setup,
	uint32_t a, uint32_t b, uint32_t c, struct setup *setup, bool *all)
{
	uint32_t least = least_halves(least_halves(a, b), c);
	uint32_t most = most_halves(most_halves(a, b), c);
	uint32_t size = most - least, round = 0x70007, whole = 0xFFF0FFF0;
	uint32_t centres, out;

	/* else each becomes two of an instruction */
	OPAQUE(round);
	OPAQUE(whole);
	least = (least + round) & whole;
	most = (most + round) & whole;
	centres = most - least;
	if (centres >> 16 == 0 || centres << 16 == 0) {
		return false;
	}
	setup->columns = (int)(centres << 16 >> 20);
	setup->top = (int)(least >> 20);
	setup->bottom = (int)(most >> 20);
	setup->extent = (int32_t)(size >> 16 > (size & 0xFFFF) ? size >> 16
							       : size & 0xFFFF);
	out = subtract_halves(least, fast_setup->box_low) |
		subtract_halves(fast_setup->box_high, most);
	*all = ((out | out << 16) >> 31) == 0 && setup->extent <= SMALL_EXTENT;
	return true;
}

static ALWAYS_INLINE struct corner find_corner(
	const struct fast_setup *fast_setup, const struct cache_tag *tag)
{
	return (struct corner){
		tag->xy, fast_setup->cache + (tag - fast_setup->place)};
}

static ALWAYS_INLINE void order(struct corner *a, struct corner *b)
{
	if (a->xy > b->xy) {
		const struct corner first = *b;

		*b = *a;
		*a = first;
	}
}

/* Corners by y. */
static ALWAYS_INLINE void set_corners(
	struct setup *setup, struct corner a, struct corner b, struct corner c)
{
	order(&a, &b);
	order(&b, &c);
	order(&a, &b);
	setup->xy[0] = a.xy;
	setup->xy[1] = b.xy;
	setup->xy[2] = c.xy;
	setup->v[0] = a.vertex;
	setup->v[1] = b.vertex;
	setup->v[2] = c.vertex;
	setup->middle = (int)((b.xy + (7 << 16)) >> 20);
}

static NEVER_INLINE void draw_tagged(struct draw *draw,
	const struct cache_tag *at_a, const struct cache_tag *at_b,
	const struct cache_tag *at_c, int32_t twice_area)
{
	const struct fast_setup *fast_setup = &draw->fast_setup;
	const struct corner a = find_corner(fast_setup, at_a);
	const struct corner b = find_corner(fast_setup, at_b);
	const struct corner c = find_corner(fast_setup, at_c);
	struct setup setup;
	bool all;

	if (!find_extent(fast_setup, a.xy, b.xy, c.xy, &setup, &all)) {
		return;
	}
	if (!all) {
		draw_transformed(draw,
			(struct vertex *[]){a.vertex, b.vertex, c.vertex});
		return;
	}
	set_corners(&setup, a, b, c);
	draw->provoking = c.vertex;
	setup.inside = true;
	setup.wide = false;
	setup.fast_setup = true;
	setup.back = ((uint32_t)twice_area >> 31) ^ fast_setup->back_flip;
	setup.area = raster_size(twice_area);
	if (fast_setup->attributes) {
		soft_shade(draw, a.vertex);
		soft_shade(draw, b.vertex);
		soft_shade(draw, c.vertex);
	}
	fast_setup->fill(draw, &setup);
}

/* A triangle of whose vertices two share a slot, or one lies outside. */
static NEVER_INLINE void draw_apart(struct draw *draw, uint32_t index)
{
	struct vertex *v[3];

	for (uint32_t i = 0; i < 3; i++) {
		v[i] = &draw->apart[i];
		soft_transform(draw, index + i, v[i]);
	}
	draw_transformed(draw, v);
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

static ALWAYS_INLINE uint32_t choose_slot(uint32_t x, uint32_t y, uint32_t z)
{
	return (x + (y >> 9 | y << 23) - (z >> 22 | z << 10)) * 2654435761u >>
		23;
}

/* The tag of a vertex by what it is made of, and if its slot was filled. */
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
			draw_apart(draw, find_index(&own, at));
			continue;
		}
		twice = cross_halves(subtract_halves(b->xy, a->xy),
			subtract_halves(c->xy, a->xy));
		if (is_seen(&draw->fast_setup, twice)) {
			draw_tagged(draw, a, b, c, twice);
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
DRAW_PAIRS(any, stream->words, stream->stride_bytes)

bool soft_draw_unindexed(struct draw *draw, uint32_t first, uint32_t count)
{
	const struct arrays *arrays = &draw->soft->arrays;
	struct stream stream;

	if (!draw->packed || arrays->vertex.size != 3 ||
		!find_stream(arrays, &stream)) {
		return false;
	}
	if (stream.words == 8 && stream.stride_bytes == 32) {
		draw_eight(draw, &stream, first, count);
	} else if (stream.words == 6 && stream.stride_bytes == 32) {
		draw_six_of_eight(draw, &stream, first, count);
	} else {
		draw_any(draw, &stream, first, count);
	}
	return true;
}
