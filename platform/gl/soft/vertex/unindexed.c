/*
 * Lists of triangles without indices: finds repeated vertices by comparing
 * their array elements, and gives all vertices indices for soft_list().
 */
#include "platform/gl/soft/vertex/cache.h"

/* Bytes of vertices: of an array, or of interleaved ones. */
struct stream {
	const uint8_t *pointer;
	size_t stride_bytes;
	int bytes;
};

/* All bytes that vertices consist of. */
struct streams {
	struct stream position; /* part of the others */
	struct stream stream[3 + SOFT_UNITS];
	int count;
};

static struct streams list_streams(const struct arrays *arrays)
{
	const struct array *const all[] = {&arrays->vertex, &arrays->normal,
		&arrays->color, &arrays->texcoord[0], &arrays->texcoord[1]};
	struct streams streams = {.count = 0};

	for (size_t i = 0; i < ARRAY_COUNT(all); i++) {
		if (all[i]->enabled) {
			streams.stream[streams.count++] = (struct stream){
				all[i]->pointer, (size_t)all[i]->stride_bytes,
				all[i]->element_bytes};
		}
	}
	streams.position = streams.stream[0];
	return streams;
}

/* Makes interleaved arrays a single stream. */
static void join_streams(struct streams *streams)
{
	struct stream *joined = &streams->stream[0];
	uintptr_t least = UINTPTR_MAX, most = 0;

	for (int i = 0; i < streams->count; i++) {
		uintptr_t at = (uintptr_t)streams->stream[i].pointer;
		uintptr_t end = at + (uintptr_t)streams->stream[i].bytes;

		if (streams->stream[i].stride_bytes != joined->stride_bytes) {
			return;
		}
		least = at < least ? at : least;
		most = end > most ? end : most;
	}
	if (most - least <= joined->stride_bytes) {
		joined->pointer -= (uintptr_t)joined->pointer - least;
		joined->bytes = (int)(most - least);
		streams->count = 1;
	}
}

enum {
	/* bytes; the compiler divides by it without a division */
	PAIRS_STRIDE = 32,
	COUNT_LEAST = 24 /* fewer vertices take less than the table's set-up */
};

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
 * known is a hash table: [hash of position] the index of the last vertex with
 * that hash. Returns the index of an equal vertex that came before, or the
 * vertex's own: of one stream of words, PAIRS_STRIDE apart.
 */
static ALWAYS_INLINE uint32_t find_index(
	const uint8_t *first, int words, uint32_t *known, const uint8_t *at)
{
	uint64_t xy = load_two_words(at), z = load_two_words(at + 8);
	uint32_t *slot = known +
		choose_slot((uint32_t)xy, (uint32_t)(xy >> 32), (uint32_t)z);
	uint32_t index = *slot;

	if (!are_equal_pairs(at, first + index * PAIRS_STRIDE, xy, z, words)) {
		index = (uint32_t)(at - first) / PAIRS_STRIDE;
		*slot = index;
	}
	return index;
}

static const uint8_t *bytes_at(const struct stream *stream, uint32_t index)
{
	return stream->pointer + index * stream->stride_bytes;
}

/* Whether two vertices have equal bytes in a stream, which has bytes each. */
static ALWAYS_INLINE bool are_equal(
	const struct stream *stream, int bytes, uint32_t left, uint32_t right)
{
	const uint8_t *a = bytes_at(stream, left), *b = bytes_at(stream, right);
	int i = 0;

	for (; i + 4 <= bytes; i += 4) {
		if (load_32(a + i) != load_32(b + i)) {
			return false;
		}
	}
	for (; i < bytes; i++) {
		if (a[i] != b[i]) {
			return false;
		}
	}
	return true;
}

/* The same as find_index() of any streams. */
static uint32_t find_any_index(
	const struct streams *streams, uint32_t *known, uint32_t number)
{
	const uint8_t *at = bytes_at(&streams->position, number);
	const int last = streams->position.bytes - 4;
	uint32_t *slot = known +
		(last < 0 ? choose_slot(load_16(at), 0, load_16(at + last + 2))
			  : choose_slot(load_32(at), load_32(at + last / 2),
				    load_32(at + last)));
	const uint32_t found = *slot;
	const struct stream *stream = streams->stream;

	for (int i = 0; i < streams->count; i++, stream++) {
		const int bytes = stream->bytes;

		/* three floats are the most common: a loop with a constant */
		if (!(bytes == 12 ? are_equal(stream, 12, number, found)
				  : are_equal(stream, bytes, number, found))) {
			*slot = number;
			return number;
		}
	}
	return found;
}

/* words: of the only stream, whose vertices lie PAIRS_STRIDE apart, or 0. */
static ALWAYS_INLINE void draw_found(struct draw *draw,
	const struct streams *streams, int words, uint32_t first, uint32_t count)
{
	const uint8_t *start = streams->stream[0].pointer;
	const uint8_t *at = start + (size_t)first * PAIRS_STRIDE;
	uint32_t known[VERTEX_CACHE];
	uint16_t index[CACHE_LIST];
	struct source source = {
		.indices = (const uint8_t *)index, .type = GL_UNSIGNED_SHORT};

	known[0] = first;
	for (int i = 1; i < VERTEX_CACHE; i *= 2) {
		memcpy(known + i, known, (size_t)i * sizeof(known[0]));
	}
	for (uint32_t left = count / 3 * 3; left > 0; left -= source.count) {
		const uint8_t *end;
		uint16_t *next = index;

		source.count = left < CACHE_LIST ? left : CACHE_LIST;
		for (uint32_t i = 0; i < source.count && words == 0; i++) {
			index[i] = (uint16_t)find_any_index(
				streams, known, first++);
		}
		end = at + source.count * PAIRS_STRIDE;
		while (at != end && words > 0) {
			PRELOAD(at + 4 * PAIRS_STRIDE);
			for (int i = 0; i < 3; i++, at += PAIRS_STRIDE) {
				*next++ = (uint16_t)find_index(
					start, words, known, at);
			}
		}
		soft_list(draw, &source);
	}
}

#define DRAW_FOUND(name, words)                                                \
	static NEVER_INLINE void draw_##name(struct draw *draw,                \
		const struct streams *streams, uint32_t first, uint32_t count) \
	{                                                                      \
		draw_found(draw, streams, words, first, count);                \
	}

/* The loops of the sizes that most programs use have constants. */
DRAW_FOUND(eight, 8)
DRAW_FOUND(six, 6)
DRAW_FOUND(any, 0)

bool soft_draw_unindexed(struct draw *draw, uint32_t first, uint32_t count)
{
	struct streams streams = list_streams(&draw->soft->arrays);
	const struct stream *joined = &streams.stream[0];
	bool pairs;

	if (!draw->packed || count < COUNT_LEAST ||
		first + count > CACHE_INDICES) {
		return false;
	}
	join_streams(&streams);
	pairs = streams.count == 1 && joined->stride_bytes == PAIRS_STRIDE &&
		(uintptr_t)joined->pointer % 4 == 0;
	if (pairs && joined->bytes == 32) {
		draw_eight(draw, &streams, first, count);
	} else if (pairs && joined->bytes == 24) {
		draw_six(draw, &streams, first, count);
	} else {
		draw_any(draw, &streams, first, count);
	}
	return true;
}
