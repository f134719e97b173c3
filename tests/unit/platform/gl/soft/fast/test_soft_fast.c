/*
 * The soft driver's short cuts against the long way, which takes any state.
 */
#include "platform/base/fixed.h"
#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/vertex/draw.h"
#include "tests/support/random.h"
#include "tests/support/soft/fast_scene.h"
#include "tests/support/soft/reference.h"
#include "tests/support/test.h"

#include <malloc.h>
#include <stdlib.h>
#include <string.h>

static void check_kind(enum fast_kind kind)
{
	static const int sizes[] = {30, 100, 300, 900, 3000};

	for (uint32_t seed = 1; seed <= 60; seed++) {
		struct soft_scene *fast_setup = fast_scene_open(7),
				  *slow = fast_scene_open(7);
		struct soft_corner corner[FAST_CORNERS];

		fast_scene_make_triangles(corner, seed, kind, sizes[seed % 5]);
		fast_scene_draw(fast_setup, corner, kind, false);
		fast_scene_draw(slow, corner, kind, true);
		fast_scene_compare(fast_setup, slow);
		soft_scene_close(fast_setup);
		soft_scene_close(slow);
	}
}

static void test_plain_triangles_are_those_of_the_long_way(void **state)
{
	(void)state;
	check_kind(FAST_PLAIN);
}

/* Draws triangles again in other colours: by LEQUAL these are seen. */
static void test_equal_depths_pass_by_lequal(void **state)
{
	(void)state;
	for (uint32_t seed = 1; seed <= 60; seed++) {
		const enum fast_kind kind =
			seed % 3 ? FAST_PLAIN : FAST_TEXTURED;
		struct soft_scene *scene[3];
		struct soft_corner corner[FAST_CORNERS];

		for (int i = 0; i < 3; i++) {
			scene[i] = fast_scene_open(7);
			scene[i]->gl->DepthFunc(i < 2 ? GL_LEQUAL : GL_LESS);
			fast_scene_make_triangles(
				corner, seed, kind, 20 + (int)seed);
			fast_scene_draw(scene[i], corner, kind, i == 1);
			for (int k = 0; k < FAST_CORNERS; k++) {
				for (int n = 0; n < 3; n++) {
					corner[k].color[n] ^= 255;
				}
			}
			fast_scene_draw(scene[i], corner, kind, i == 1);
		}
		assert_true(scene[0]->soft->draw->fill != soft_rows_fill);
		assert_memory_not_equal(scene[0]->pixel, scene[2]->pixel,
			sizeof(scene[0]->pixel));
		if (kind == FAST_PLAIN) {
			fast_scene_compare(scene[0], scene[1]);
		}
		for (int i = 0; i < 3; i++) {
			soft_scene_close(scene[i]);
		}
	}
}

static void test_shadows_are_those_of_the_long_way(void **state)
{
	(void)state;
	check_kind(FAST_SHADOW);
}

/*
 * Coordinates run in 1/256 of texels there, so that near the border of two
 * texels either may be taken: with a texture of noise, pixels are counted.
 */
static void test_textured_triangles_are_nearly_those_of_the_long_way(
	void **state)
{
	int other = 0, seen = 0;

	(void)state;
	for (uint32_t seed = 1; seed <= 60; seed++) {
		struct soft_scene *fast_setup = fast_scene_open(7),
				  *slow = fast_scene_open(7);
		struct soft_corner corner[FAST_CORNERS];

		fast_scene_make_triangles(
			corner, seed, FAST_TEXTURED, 30 + (int)seed * 6);
		fast_scene_draw(fast_setup, corner, FAST_TEXTURED, false);
		fast_scene_draw(slow, corner, FAST_TEXTURED, true);
		assert_memory_equal(fast_setup->soft->buffers.depth,
			slow->soft->buffers.depth,
			SOFT_SCENE_WIDTH * SOFT_SCENE_HEIGHT * 2);
		for (int i = 0; i < SOFT_SCENE_PIXELS; i++) {
			seen += slow->pixel[i] != 0;
			other += soft_scene_steps(fast_setup->pixel[i],
					 slow->pixel[i]) > 1;
		}
		soft_scene_close(fast_setup);
		soft_scene_close(slow);
	}
	assert_true(seen > 10000);
	assert_true(other * 30 < seen);
}

enum {
	MANY = 1400, /* more vertices than the cache has slots */
	LISTED = 300,
};

static void make_list(uint32_t seed, uint16_t index[LISTED * 3])
{
	for (int i = 0; i < LISTED; i++) {
		int near = random_between(&seed, 0, MANY - 3);
		bool same_slot = i % 11 == 0;

		for (int k = 0; k < 3; k++) {
			index[3 * i + k] = (uint16_t)(i % 5
					? near + k
					: random_between(&seed, 0, MANY - 1));
		}
		if (same_slot) {
			index[3 * i + 1] =
				(uint16_t)((index[3 * i] + VERTEX_CACHE) % MANY);
		}
	}
}

static void draw_list(struct soft_scene *scene, enum fast_kind kind, int cull,
	const void *indices)
{
	const struct gl *gl = scene->gl;

	(cull ? gl->Enable : gl->Disable)(GL_CULL_FACE);
	gl->CullFace(cull == 1      ? GL_BACK
			: cull == 2 ? GL_FRONT
				    : GL_FRONT_AND_BACK);
	gl->ShadeModel(kind == FAST_PLAIN && cull == 2 ? GL_FLAT : GL_SMOOTH);
	gl->DrawElements(GL_TRIANGLES, LISTED * 3, GL_UNSIGNED_SHORT, indices);
}

/* Indices at odd addresses go the portable way. */
static void test_lists_are_drawn_the_same_in_assembly(void **state)
{
	static const int sizes[] = {20, 60, 150, 400, 3000};
	static struct soft_corner corner[MANY + FAST_CORNERS];
	static uint16_t index[LISTED * 3];
	static uint8_t odd[sizeof(index) + 1];

	(void)state;
	for (uint32_t seed = 1; seed <= 120; seed++) {
		struct soft_scene *fast_setup = fast_scene_open(7),
				  *slow = fast_scene_open(7);
		enum fast_kind kind = (enum fast_kind)(seed % FAST_KINDS);
		int cull = (int)(seed / FAST_KINDS % 4);

		for (uint32_t i = 0; i < MANY; i += FAST_CORNERS) {
			fast_scene_make_triangles(corner + i, seed * 64 + i,
				kind, sizes[seed % 5]);
		}
		make_list(seed, index);
		memcpy(odd + 1, index, sizeof(index));
		fast_scene_set_state(fast_setup, corner, kind, false);
		draw_list(fast_setup, kind, cull, index);
		fast_scene_set_state(slow, corner, kind, false);
		draw_list(slow, kind, cull, odd + 1);
		fast_scene_compare(fast_setup, slow);
		assert_memory_equal(fast_setup->pixel, slow->pixel,
			sizeof(fast_setup->pixel));
		soft_scene_close(fast_setup);
		soft_scene_close(slow);
	}
}

/* Positions and normals in 16 bits show what floats show. */
static void test_shorts_are_drawn_like_floats(void **state)
{
	struct soft_scene *a = fast_scene_open(7), *b = fast_scene_open(7);
	struct soft_corner corner[FAST_CORNERS];
	int16_t shorts[FAST_CORNERS][4];

	(void)state;
	fast_scene_make_triangles(corner, 5, FAST_PLAIN, 300);
	for (int i = 0; i < FAST_CORNERS; i++) {
		for (int k = 0; k < 3; k++) {
			shorts[i][k] =
				(int16_t)(corner[i].position[k] * 8192.0f);
			corner[i].position[k] = (float)shorts[i][k];
		}
	}
	for (int i = 0; i < 2; i++) {
		const struct gl *gl = i ? a->gl : b->gl;

		soft_scene_use(i ? a : b, false);
		gl->Scalex(FX16_ONE / 8192, FX16_ONE / 8192, FX16_ONE / 8192);
	}
	fast_scene_draw(a, corner, FAST_PLAIN, false);
	soft_scene_use(b, false);
	b->gl->Enable(GL_DEPTH_TEST);
	b->gl->EnableClientState(GL_VERTEX_ARRAY);
	b->gl->EnableClientState(GL_COLOR_ARRAY);
	b->gl->ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(*corner), corner->color);
	b->gl->VertexPointer(3, GL_SHORT, sizeof(shorts[0]), shorts);
	b->gl->DrawArrays(GL_TRIANGLES, 0, FAST_CORNERS);
	fast_scene_compare(a, b);
	soft_scene_close(a);
	soft_scene_close(b);
}

static void test_a_context_needs_less_than_256_kib(void **state)
{
	(void)state;
	assert_true(sizeof(struct soft) + sizeof(struct draw) < 256 * 1024);
}

static void test_drawing_takes_no_memory(void **state)
{
	struct soft_scene *scene = fast_scene_open(7);
	struct soft_corner corner[FAST_CORNERS];
	struct mallinfo2 before, after;

	(void)state;
	for (int round = 0; round < 2; round++) {
		before = mallinfo2();
		for (int kind = 0; kind < FAST_KINDS; kind++) {
			fast_scene_make_triangles(
				corner, 3, (enum fast_kind)kind, 200);
			fast_scene_draw(
				scene, corner, (enum fast_kind)kind, false);
			fast_scene_draw(
				scene, corner, (enum fast_kind)kind, true);
		}
		after = mallinfo2();
	}
	/* In the first round the stencil was made. */
	assert_int_equal(before.uordblks, after.uordblks);
	assert_int_equal(before.arena, after.arena);
	soft_scene_close(scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_plain_triangles_are_those_of_the_long_way),
		cmocka_unit_test(test_equal_depths_pass_by_lequal),
		cmocka_unit_test(test_shadows_are_those_of_the_long_way),
		cmocka_unit_test(
			test_textured_triangles_are_nearly_those_of_the_long_way),
		cmocka_unit_test(test_lists_are_drawn_the_same_in_assembly),
		cmocka_unit_test(test_shorts_are_drawn_like_floats),
		cmocka_unit_test(test_a_context_needs_less_than_256_kib),
		cmocka_unit_test(test_drawing_takes_no_memory),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
