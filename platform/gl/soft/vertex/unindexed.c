/*
 * Lists of triangles without indices: finds repeated vertices by comparing
 * their array elements, and gives all vertices indices for soft_list().
 */
#include "platform/gl/soft/vertex/cache.h"

/* Interleaved arrays, as vertices of words that can be compared. */
struct stream {
	const uint8_t *pointer;
	size_t stride_bytes;
	int words;
};

/* Whether elements consist of 32-bit words, as they nearly always do. */
static bool is_of_words(const struct array *array)
{
	return array->type == GL_FLOAT || array->type == GL_FIXED ||
		(array->type == GL_UNSIGNED_BYTE && array->size == 4);
}

/* False unless the enabled arrays are interleaved words, four or more in all. */
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

/*
 * Whether two vertices of four or more words are equal; xy and z are the left
 * one's first four words. Of an odd number of words the last pair overlaps.
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

/*
 * The index of an equal vertex that came before, or the vertex's own. known is
 * a hash table: [hash of position] the index of the last vertex with that hash.
 * number is the vertex's index, or NULL if the stride is a constant: then the
 * compiler divides by it without a division.
 */
static ALWAYS_INLINE uint32_t find_index(const struct stream *stream,
	uint32_t *known, const uint8_t *at, const uint32_t *number)
{
	uint64_t xy = load_two_words(at), z = load_two_words(at + 8);
	uint32_t *slot = known +
		choose_slot((uint32_t)xy, (uint32_t)(xy >> 32), (uint32_t)z);
	uint32_t index = *slot;

	if (!are_equal_pairs(at, stream->pointer + index * stream->stride_bytes,
		    xy, z, stream->words)) {
		index = number ? *number
			       : (uint32_t)((size_t)(at - stream->pointer) /
					 stream->stride_bytes);
		*slot = index;
	}
	return index;
}

static ALWAYS_INLINE void draw_pairs(struct draw *draw,
	const struct stream *stream, int words, size_t stride_bytes,
	uint32_t first, uint32_t count, bool counted)
{
	const struct stream own = {stream->pointer, stride_bytes, words};
	const uint8_t *at = own.pointer + first * stride_bytes;
	uint32_t known[VERTEX_CACHE], number = first;
	uint16_t index[CACHE_LIST];
	struct source source = {
		.indices = (const uint8_t *)index, .type = GL_UNSIGNED_SHORT};

	for (int i = 0; i < VERTEX_CACHE; i++) {
		known[i] = first;
	}
	for (uint32_t left = count / 3 * 3; left > 0; left -= source.count) {
		const uint8_t *end;
		uint16_t *next = index;

		source.count = left < CACHE_LIST ? left : CACHE_LIST;
		end = at + source.count * stride_bytes;
		while (at != end) {
			PRELOAD(at + 4 * stride_bytes);
			for (int i = 0; i < 3; i++, at += stride_bytes) {
				*next++ = (uint16_t)find_index(&own, known, at,
					counted ? &number : NULL);
				number++;
			}
		}
		soft_list(draw, &source);
	}
}

#define DRAW_PAIRS(name, words, stride_bytes, counted)                       \
	static NEVER_INLINE void draw_##name(struct draw *draw,              \
		const struct stream *stream, uint32_t first, uint32_t count) \
	{                                                                    \
		draw_pairs(draw, stream, words, stride_bytes, first, count,  \
			counted);                                            \
	}

/* In loops for the sizes that most programs use, the size is a constant. */
DRAW_PAIRS(eight, 8, 32, false)
DRAW_PAIRS(six_of_eight, 6, 32, false)
DRAW_PAIRS(any, stream->words, stream->stride_bytes, true)

bool soft_draw_unindexed(struct draw *draw, uint32_t first, uint32_t count)
{
	const struct arrays *arrays = &draw->soft->arrays;
	struct stream stream;

	if (!draw->packed || arrays->vertex.size != 3 ||
		first + count > CACHE_INDICES || !find_stream(arrays, &stream)) {
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
