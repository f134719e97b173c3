/* Lists of triangles without indices: which vertices come again. */
#include "platform/gl/soft/vertex/primitive.h"

/* An array in use, as words to compare. */
struct stream {
	const uint8_t *pointer;
	size_t stride_bytes;
	int words;
};

/* Whole words alone are compared, and seldom is something else given. */
static bool add_stream(
	const struct array *array, struct stream *streams, int *count)
{
	bool words = array->type == GL_FLOAT || array->type == GL_FIXED;
	bool color = array->type == GL_UNSIGNED_BYTE && array->size == 4;
	struct stream own, *last;

	if (!array->enabled) {
		return true;
	}
	own = (struct stream){array->pointer, (size_t)array->stride_bytes,
		color ? 1 : array->size};
	last = *count > 0 ? &streams[*count - 1] : NULL;
	if (last && last->stride_bytes == own.stride_bytes &&
		last->pointer + 4 * last->words == own.pointer) {
		last->words += own.words; /* interleaved */
	} else {
		streams[(*count)++] = own;
	}
	return words || color;
}

static bool are_equal_words(
	const uint8_t *left, const uint8_t *right, int words)
{
	uint32_t differ = 0;

	for (int i = 0; i < words; i++) {
		differ |= load_word(left + 4 * i) ^ load_word(right + 4 * i);
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

/* By what the vertex is made of: unindexed lists give it several times. */
static struct vertex *find_dedup(struct draw *draw,
	const struct stream *streams, int count, uint32_t index)
{
	const uint8_t *at = streams->pointer + index * streams->stride_bytes;
	uint32_t y = load_word(at + 4);
	uint32_t mixed =
		load_word(at) + (y << 3) + (y >> 9) - (load_word(at + 8) >> 5);
	uint32_t slot = mixed * 2654435761u >> 23;
	struct vertex *vertex = &draw->cache[slot];

	if (draw->place[slot].tag == PLACE_EMPTY ||
		!are_equal_streams(streams, count, vertex->index, index)) {
		soft_load_slot(draw, slot, index);
	}
	return vertex;
}

static bool list_streams(
	const struct draw *draw, struct stream *streams, int *count)
{
	const struct arrays *arrays = &draw->soft->arrays;

	*count = 0;
	return arrays->vertex.size == 3 &&
		add_stream(&arrays->vertex, streams, count) &&
		add_stream(&arrays->normal, streams, count) &&
		add_stream(&arrays->color, streams, count) &&
		add_stream(&arrays->texcoord[0], streams, count) &&
		add_stream(&arrays->texcoord[1], streams, count);
}

static void draw_dedup(struct draw *draw, const struct stream *streams,
	int stream_count, uint32_t first, uint32_t count)
{
	for (uint32_t i = 0; i + 2 < count; i += 3) {
		uint32_t index = first + i;
		struct vertex *v[3];

		v[0] = find_dedup(draw, streams, stream_count, index);
		v[1] = find_dedup(draw, streams, stream_count, index + 1);
		v[2] = find_dedup(draw, streams, stream_count, index + 2);
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
}

static bool draw_together(struct draw *draw, const struct stream *stream,
	uint32_t first, uint32_t count)
{
	return draw->packed &&
		soft_draw_dedup(draw, stream->pointer, stream->stride_bytes,
			stream->words, first, count);
}

bool soft_draw_unindexed(struct draw *draw, uint32_t first, uint32_t count)
{
	struct stream streams[3 + SOFT_UNITS];
	int used;

	if (!list_streams(draw, streams, &used)) {
		return false;
	}
	if (used != 1 || !draw_together(draw, streams, first, count)) {
		draw_dedup(draw, streams, used, first, count);
	}
	return true;
}
