/*
 * The soft driver's lists without indices draw what the same vertices draw by
 * indices: where they lie close together, and with room behind positions.
 */
#include "platform/base/fixed.h"
#include "platform/gl/gl_counts.h"
#include "tests/support/gl/gl_checks.h"
#include "tests/support/random.h"

#include <string.h>

enum {
	POOL = 700, /* more than the vertex cache has slots */
	TRIANGLES = 500,
	CORNERS = 3 * TRIANGLES,
	WORDS = 9, /* position, normal, texture coordinates, colour */
	WORDS_MOST = WORDS + 2,
	PICTURE_BYTES = 2 * GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT,
};

/* Words of 4 bytes a vertex, of these in use, and free behind the position. */
struct layout {
	int stride, used, room;
};

static float random_float(uint32_t *seed)
{
	return (float)next_random(seed) / (1 << 23) - 1.0f;
}

/* Normals are of unit length; a colour is any four bytes. */
static void make_pool(uint32_t *seed, float reach, float pool[POOL][WORDS])
{
	static const float normals[3][3] = {
		{0, 0, 1}, {0.6f, 0, 0.8f}, {0, -0.6f, 0.8f}};

	for (int i = 0; i < POOL; i++) {
		for (int j = 0; j < 3; j++) {
			pool[i][j] = reach * random_float(seed);
		}
		memcpy(pool[i] + 3, normals[i % 3], sizeof(normals[0]));
		for (int j = 6; j < WORDS; j++) {
			pool[i][j] = random_float(seed);
		}
	}
	memset(pool[0], 0, sizeof(pool[0]));
	/* As pool[1] but for one word each. */
	for (int i = 3; i < WORDS; i++) {
		memcpy(pool[i], pool[1], sizeof(pool[1]));
		pool[i][i] += 0.5f;
	}
}

static void make_list(uint32_t *seed, uint16_t list[CORNERS])
{
	for (int i = 0; i < TRIANGLES; i++) {
		uint32_t near = next_random(seed) % (POOL - 3);

		for (uint32_t j = 0; j < 3; j++) {
			uint32_t any = next_random(seed) % POOL;

			list[3 * i + (int)j] =
				(uint16_t)(i % 4 ? near + j : any);
		}
		if (i % 16 == 0) {
			list[3 * i] = list[3 * i + 1];
		}
	}
	for (int i = 0; i < TRIANGLES; i += 2) {
		list[3 * i] = (uint16_t)(1 + i / 2 % 7);
	}
}

static void draw_list(const float pool[POOL][WORDS],
	const uint16_t list[CORNERS], const struct layout *layout,
	bool by_indices, uint8_t picture[PICTURE_BYTES])
{
	static float vertex[CORNERS * WORDS_MOST];
	uint16_t index[CORNERS];
	const GLsizei bytes = layout->stride * 4;
	const float *rest = vertex + 3 + layout->room;
	static const GLfixed aslant[4] = {FX16_ONE, FX16_ONE, FX16_ONE, 0};
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	struct gl *gl = canvas.gl;

	for (int i = 0; i < CORNERS; i++) {
		float *to = vertex + i * layout->stride;

		index[i] = (uint16_t)i;
		to[3] = (float)i; /* where there is room */
		memcpy(to, pool[list[i]], sizeof(float[3]));
		memcpy(to + 3 + layout->room, pool[list[i]] + 3,
			(size_t)(layout->used - 3) * 4);
	}
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_NORMAL_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, bytes, vertex);
	gl->NormalPointer(GL_FLOAT, bytes, rest);
	gl->Enable(GL_LIGHTING);
	gl->Enable(GL_LIGHT0);
	gl->Lightxv(GL_LIGHT0, GL_POSITION, aslant);
	gl->Enable(GL_DEPTH_TEST);
	if (layout->used >= 8) {
		gl_canvas_make_texture(gl);
		gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
		gl->TexCoordPointer(2, GL_FLOAT, bytes, rest + 3);
	}
	if (layout->used == WORDS) {
		gl->EnableClientState(GL_COLOR_ARRAY);
		gl->ColorPointer(4, GL_UNSIGNED_BYTE, bytes, rest + 5);
		gl->Enable(GL_COLOR_MATERIAL);
	}
	/* All but the first triangle, and two corners that are of none. */
	if (by_indices) {
		gl->DrawElements(GL_TRIANGLES, CORNERS - 4, GL_UNSIGNED_SHORT,
			index + 3);
		gl->DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, index);
	} else {
		gl->DrawArrays(GL_TRIANGLES, 3, CORNERS - 4);
		gl->DrawArrays(GL_TRIANGLES, 0, 3);
	}
	assert_int_equal(canvas.pixels.stride_bytes, 2 * GL_CANVAS_WIDTH);
	memcpy(picture, canvas.pixels.data, PICTURE_BYTES);
	gl_canvas_end_and_close(&canvas);
}

static void check_layout(const struct layout *layout)
{
	static float pool[POOL][WORDS];
	static uint16_t list[CORNERS];
	const struct layout spread = {
		.stride = layout->used + 2, .used = layout->used, .room = 2};
	uint32_t seed = 5;

	for (int round = 0; round < 24; round++) {
		uint8_t listed[PICTURE_BYTES], close[PICTURE_BYTES],
			apart[PICTURE_BYTES];

		/* The last ones leave the picture. */
		make_pool(&seed, round < 16 ? 0.99f : 1.5f, pool);
		make_list(&seed, list);
		draw_list(pool, list, layout, true, listed);
		draw_list(pool, list, layout, false, close);
		draw_list(pool, list, &spread, false, apart);
		assert_memory_equal(close, listed, PICTURE_BYTES);
		assert_memory_equal(apart, listed, PICTURE_BYTES);
	}
}

static void test_six_words_are_found_again(void **state)
{
	(void)state;
	check_layout(&(struct layout){.stride = 6, .used = 6});
}

static void test_six_words_of_eight_are_found_again(void **state)
{
	(void)state;
	check_layout(&(struct layout){.stride = 8, .used = 6});
}

static void test_eight_words_are_found_again(void **state)
{
	(void)state;
	check_layout(&(struct layout){.stride = 8, .used = 8});
}

/* The colour, which lies last, is not the last array that is found. */
static void test_other_numbers_of_words_are_found_again(void **state)
{
	(void)state;
	check_layout(&(struct layout){.stride = 10, .used = 8});
	check_layout(&(struct layout){.stride = WORDS, .used = WORDS});
}

/* Draws the list from an array each for positions, normals and colours. */
static double draw_apart(const float pool[POOL][WORDS],
	const uint16_t list[CORNERS], GLenum type, bool by_indices,
	uint8_t picture[PICTURE_BYTES])
{
	static int16_t halves[CORNERS][3];
	static int8_t bytes[CORNERS][3];
	static float position[CORNERS][3], normal[CORNERS][3];
	static uint8_t color[CORNERS][4];
	static uint16_t index[CORNERS];
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	struct gl *gl = canvas.gl;
	struct gl_counts counts = {0};

	for (int i = 0; i < CORNERS; i++) {
		const float *from = pool[list[i]];

		index[i] = (uint16_t)i;
		memcpy(position[i], from, sizeof(position[i]));
		memcpy(normal[i], from + 3, sizeof(normal[i]));
		memcpy(color[i], from + 8, sizeof(color[i]));
		for (int j = 0; j < 3; j++) {
			halves[i][j] = (int16_t)(from[j] * 20000);
			bytes[i][j] = (int8_t)(from[j] * 80);
		}
	}
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_NORMAL_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->VertexPointer(3, type, 0,
		type == GL_SHORT          ? (void *)halves
			: type == GL_BYTE ? (void *)bytes
					  : position);
	gl->NormalPointer(GL_FLOAT, 0, normal);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, color);
	gl->Enable(GL_LIGHTING);
	gl->Enable(GL_LIGHT0);
	gl->Enable(GL_NORMALIZE);
	gl->Enable(GL_COLOR_MATERIAL);
	if (type != GL_FLOAT) {
		GLfixed scale = type == GL_BYTE ? 750 : 3;

		gl->Scalex(scale, scale, scale);
	}
	canvas.context->driver->count(canvas.context, &counts);
	if (by_indices) {
		gl->DrawElements(
			GL_TRIANGLES, CORNERS, GL_UNSIGNED_SHORT, index);
	} else {
		gl->DrawArrays(GL_TRIANGLES, 0, CORNERS);
	}
	canvas.context->driver->count(canvas.context, NULL);
	memcpy(picture, canvas.pixels.data, PICTURE_BYTES);
	gl_canvas_end_and_close(&canvas);
	return counts.shaded;
}

static void test_vertices_of_separate_arrays_are_found_again(void **state)
{
	static const GLenum types[] = {GL_FLOAT, GL_SHORT, GL_BYTE};
	static float pool[POOL][WORDS];
	static uint16_t list[CORNERS];
	uint32_t seed = 9;

	(void)state;
	for (int round = 0; round < 30; round++) {
		const GLenum type = types[round / 2 % 3];
		uint8_t listed[PICTURE_BYTES], found[PICTURE_BYTES];
		double all, some;

		make_pool(&seed, round % 2 ? 0.99f : 1.5f, pool);
		make_list(&seed, list);
		all = draw_apart(pool, list, type, true, listed);
		some = draw_apart(pool, list, type, false, found);
		assert_memory_equal(found, listed, PICTURE_BYTES);
		/* Others have cuts of the clip volume, which count, too. */
		if (round % 2) {
			assert_true(some < all * 0.8);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_six_words_are_found_again),
		cmocka_unit_test(test_six_words_of_eight_are_found_again),
		cmocka_unit_test(test_eight_words_are_found_again),
		cmocka_unit_test(test_other_numbers_of_words_are_found_again),
		cmocka_unit_test(
			test_vertices_of_separate_arrays_are_found_again),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
