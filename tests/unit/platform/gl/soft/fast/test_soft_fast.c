/*
 * The soft driver's short cuts: against the long way, which takes any state;
 * and triangles in assembly against the same in C.
 */
#include "platform/base/fixed.h"
#include "platform/gl/soft/fast/band.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/vertex/draw.h"
#include "tests/support/gl/soft_scene.h"
#include "tests/support/random.h"
#include "tests/support/soft/reference.h"
#include "tests/support/test.h"

#include <malloc.h>
#include <stdlib.h>
#include <string.h>

enum {
	WIDTH = 96,
	HEIGHT = 80,
	GUARD = 8, /* rows above and below */
	PIXELS = WIDTH * (HEIGHT + 2 * GUARD),
	SIDE = 32, /* of the texture */
};

/* A picture whose rows lie as close as those of its depth. */
struct scene {
	struct gl_context *context;
	const struct gl *gl;
	struct soft *soft;
	uint16_t all[PIXELS];
	struct pixels picture;
};

/* Calls of GL go to the context whose frame began last. */
static void use(struct scene *scene)
{
	assert_int_equal(scene->context->driver->begin_frame(
				 scene->context, &scene->picture),
		0);
}

static void make_texture(const struct gl *gl, uint32_t seed)
{
	uint8_t texels[SIDE * SIDE * 3];
	GLuint name;

	for (size_t i = 0; i < sizeof(texels); i++) {
		texels[i] = (uint8_t)next_random(&seed);
	}
	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, SIDE, SIDE, 0, GL_RGB,
		GL_UNSIGNED_BYTE, texels);
}

static struct scene *open_scene(uint32_t seed)
{
	const struct log log = {0};
	struct scene *scene = calloc(1, sizeof(*scene));

	assert_non_null(scene);
	memset(scene->all, 0xA5, sizeof(scene->all));
	scene->picture = (struct pixels){
		.width = WIDTH,
		.height = HEIGHT,
		.stride_bytes = WIDTH * 2,
		.format = PIXELS_RGB565,
		.data = (uint8_t *)(scene->all + GUARD * WIDTH),
	};
	assert_int_equal(gl_open("soft",
				 &(struct gl_request){
					 .format = PIXELS_RGB565, .log = &log},
				 &scene->context),
		0);
	scene->gl = &scene->context->gl;
	scene->soft = (struct soft *)scene->context;
	use(scene);
	scene->gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	make_texture(scene->gl, seed);
	return scene;
}

static void close_scene(struct scene *scene)
{
	scene->context->driver->end_frame(scene->context);
	scene->context->driver->destroy(scene->context);
	for (int i = 0; i < GUARD * WIDTH; i++) {
		assert_int_equal(scene->all[i], 0xA5A5);
		assert_int_equal(scene->all[PIXELS - 1 - i], 0xA5A5);
	}
	free(scene);
}

enum kind {
	PLAIN,
	TEXTURED,
	SHADOW,
	KINDS,
};

enum {
	TRIANGLES = 40,
	CORNERS = TRIANGLES * 3,
};

/* Small and large ones, inside of the picture and across its borders. */
static void make_triangles(
	struct soft_corner *corner, uint32_t seed, enum kind kind, int size)
{
	for (int i = 0; i < TRIANGLES; i++) {
		float x = (float)random_between(&seed, -1100, 1100) / 1000.0f;
		float y = (float)random_between(&seed, -1100, 1100) / 1000.0f;

		for (int k = 0; k < 3; k++) {
			struct soft_corner *c = &corner[i * 3 + k];
			int gray = random_between(&seed, 0, 255);

			c->position[0] = x +
				(float)random_between(&seed, -size, size) /
					1000.0f;
			c->position[1] = y +
				(float)random_between(&seed, -size, size) /
					1000.0f;
			c->position[2] =
				(float)random_between(&seed, -900, 900) /
				1000.0f;
			for (int n = 0; n < 3; n++) {
				c->color[n] = (uint8_t)(kind == TEXTURED
						? gray
						: random_between(&seed, 0, 255));
			}
			c->color[3] = 255;
			c->texcoord[0] =
				(float)random_between(&seed, -40, 40) / 64.0f;
			c->texcoord[1] =
				(float)random_between(&seed, -40, 40) / 64.0f;
		}
	}
}

/* The long way is that of soft/reference.h, for all fragments. */
static void set_state(struct scene *scene, const struct soft_corner *corner,
	enum kind kind, bool long_way)
{
	const struct gl *gl = scene->gl;
	const GLsizei stride = sizeof(*corner);

	use(scene);
	reference_use(scene->soft, long_way);
	gl->Enable(GL_DEPTH_TEST);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, stride, corner->position);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, stride, corner->color);
	if (kind == TEXTURED) {
		gl->Enable(GL_TEXTURE_2D);
		gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
		gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
		gl->TexCoordPointer(2, GL_FLOAT, stride, corner->texcoord);
	}
	if (kind == SHADOW) {
		gl->Disable(GL_DEPTH_TEST);
		gl->DisableClientState(GL_COLOR_ARRAY);
		gl->Color4x(FX16_ONE, FX16_ONE / 2, 0, FX16_ONE * 3 / 8);
		gl->Enable(GL_BLEND);
		gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
		gl->Enable(GL_STENCIL_TEST);
		gl->StencilFunc(GL_EQUAL, 0, 255);
		gl->StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
		gl->Clear(GL_STENCIL_BUFFER_BIT);
	}
}

static void draw(struct scene *scene, const struct soft_corner *corner,
	enum kind kind, bool long_way)
{
	set_state(scene, corner, kind, long_way);
	scene->gl->DrawArrays(GL_TRIANGLES, 0, CORNERS);
}

/* Coverage, depth and stencil are the same, colours within a step. */
static void compare(const struct scene *a, const struct scene *b)
{
	const struct buffers *left = &a->soft->buffers;
	const struct buffers *right = &b->soft->buffers;
	const uint16_t *p = a->all + GUARD * WIDTH, *q = b->all + GUARD * WIDTH;

	assert_memory_equal(left->depth, right->depth, WIDTH * HEIGHT * 2);
	if (left->stencil) {
		assert_memory_equal(
			left->stencil, right->stencil, WIDTH * HEIGHT);
	}
	for (int i = 0; i < WIDTH * HEIGHT; i++) {
		if (soft_scene_steps(p[i], q[i]) > 1) {
			fail_msg("pixel %d,%d is %04x, the long way %04x",
				i % WIDTH, i / WIDTH, p[i], q[i]);
		}
	}
}

static void check_kind(enum kind kind)
{
	static const int sizes[] = {30, 100, 300, 900, 3000};

	for (uint32_t seed = 1; seed <= 60; seed++) {
		struct scene *fast_setup = open_scene(7), *slow = open_scene(7);
		struct soft_corner corner[CORNERS];

		make_triangles(corner, seed, kind, sizes[seed % 5]);
		draw(fast_setup, corner, kind, false);
		draw(slow, corner, kind, true);
		compare(fast_setup, slow);
		close_scene(fast_setup);
		close_scene(slow);
	}
}

static void test_plain_triangles_are_those_of_the_long_way(void **state)
{
	(void)state;
	check_kind(PLAIN);
}

static void test_shadows_are_those_of_the_long_way(void **state)
{
	(void)state;
	check_kind(SHADOW);
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
		struct scene *fast_setup = open_scene(7), *slow = open_scene(7);
		struct soft_corner corner[CORNERS];

		make_triangles(corner, seed, TEXTURED, 30 + (int)seed * 6);
		draw(fast_setup, corner, TEXTURED, false);
		draw(slow, corner, TEXTURED, true);
		assert_memory_equal(fast_setup->soft->buffers.depth,
			slow->soft->buffers.depth, WIDTH * HEIGHT * 2);
		for (int i = 0; i < PIXELS; i++) {
			seen += slow->all[i] != 0 && slow->all[i] != 0xA5A5;
			other += soft_scene_steps(
					 fast_setup->all[i], slow->all[i]) > 1;
		}
		close_scene(fast_setup);
		close_scene(slow);
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

static void draw_list(
	struct scene *scene, enum kind kind, int cull, const void *indices)
{
	const struct gl *gl = scene->gl;

	(cull ? gl->Enable : gl->Disable)(GL_CULL_FACE);
	gl->CullFace(cull == 1      ? GL_BACK
			: cull == 2 ? GL_FRONT
				    : GL_FRONT_AND_BACK);
	gl->ShadeModel(kind == PLAIN && cull == 2 ? GL_FLAT : GL_SMOOTH);
	gl->DrawElements(GL_TRIANGLES, LISTED * 3, GL_UNSIGNED_SHORT, indices);
}

/* Indices at odd addresses go the portable way. */
static void test_lists_are_drawn_the_same_in_assembly(void **state)
{
	static const int sizes[] = {20, 60, 150, 400, 3000};
	static struct soft_corner corner[MANY + CORNERS];
	static uint16_t index[LISTED * 3];
	static uint8_t odd[sizeof(index) + 1];

	(void)state;
	for (uint32_t seed = 1; seed <= 120; seed++) {
		struct scene *fast_setup = open_scene(7), *slow = open_scene(7);
		enum kind kind = (enum kind)(seed % KINDS);
		int cull = (int)(seed / KINDS % 4);

		for (uint32_t i = 0; i < MANY; i += CORNERS) {
			make_triangles(corner + i, seed * 64 + i, kind,
				sizes[seed % 5]);
		}
		make_list(seed, index);
		memcpy(odd + 1, index, sizeof(index));
		set_state(fast_setup, corner, kind, false);
		draw_list(fast_setup, kind, cull, index);
		set_state(slow, corner, kind, false);
		draw_list(slow, kind, cull, odd + 1);
		compare(fast_setup, slow);
		assert_memory_equal(
			fast_setup->all, slow->all, sizeof(fast_setup->all));
		close_scene(fast_setup);
		close_scene(slow);
	}
}

/* Positions and normals in 16 bits show what floats show. */
static void test_shorts_are_drawn_like_floats(void **state)
{
	struct scene *a = open_scene(7), *b = open_scene(7);
	struct soft_corner corner[CORNERS];
	int16_t shorts[CORNERS][4];

	(void)state;
	make_triangles(corner, 5, PLAIN, 300);
	for (int i = 0; i < CORNERS; i++) {
		for (int k = 0; k < 3; k++) {
			shorts[i][k] =
				(int16_t)(corner[i].position[k] * 8192.0f);
			corner[i].position[k] = (float)shorts[i][k];
		}
	}
	for (int i = 0; i < 2; i++) {
		const struct gl *gl = i ? a->gl : b->gl;

		use(i ? a : b);
		gl->Scalex(FX16_ONE / 8192, FX16_ONE / 8192, FX16_ONE / 8192);
	}
	draw(a, corner, PLAIN, false);
	use(b);
	b->gl->Enable(GL_DEPTH_TEST);
	b->gl->EnableClientState(GL_VERTEX_ARRAY);
	b->gl->EnableClientState(GL_COLOR_ARRAY);
	b->gl->ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(*corner), corner->color);
	b->gl->VertexPointer(3, GL_SHORT, sizeof(shorts[0]), shorts);
	b->gl->DrawArrays(GL_TRIANGLES, 0, CORNERS);
	compare(a, b);
	close_scene(a);
	close_scene(b);
}

static void test_a_context_needs_less_than_256_kib(void **state)
{
	(void)state;
	assert_true(sizeof(struct soft) + sizeof(struct draw) < 256 * 1024);
}

static void test_drawing_takes_no_memory(void **state)
{
	struct scene *scene = open_scene(7);
	struct soft_corner corner[CORNERS];
	struct mallinfo2 before, after;

	(void)state;
	for (int round = 0; round < 2; round++) {
		before = mallinfo2();
		for (int kind = 0; kind < KINDS; kind++) {
			make_triangles(corner, 3, (enum kind)kind, 200);
			draw(scene, corner, (enum kind)kind, false);
			draw(scene, corner, (enum kind)kind, true);
		}
		after = mallinfo2();
	}
	/* In the first round the stencil was made. */
	assert_int_equal(before.uordblks, after.uordblks);
	assert_int_equal(before.arena, after.arena);
	close_scene(scene);
}

/* Any place and size in sixteenths, colours and depths up to their ends. */
static void make_projected(uint32_t *seed, struct vertex v[3])
{
	static const int sizes[] = {6, 20, 100, 360, 1600};
	int width = sizes[random_between(seed, 0, 4)];
	int height = sizes[random_between(seed, 0, 4)];
	int x = random_between(seed, 0, WIDTH * 16);
	int y = random_between(seed, 0, HEIGHT * 16);
	bool near = random_between(seed, 0, 3) == 0;
	int most = random_between(seed, 0, 2);

	for (int i = 0; i < 3; i++) {
		int to_x = x + random_between(seed, -width, width);
		int to_y = y + random_between(seed, -height, height);

		v[i] = (struct vertex){
			.shaded = true,
			.x = to_x < 0               ? 0
				: to_x > WIDTH * 16 ? WIDTH * 16
						    : to_x,
			.y = to_y < 0                ? 0
				: to_y > HEIGHT * 16 ? HEIGHT * 16
						     : to_y,
			.z = random_between(seed, 5000, 257000),
			.clip[3] = (1 << 27) +
				random_between(seed, 0, near ? 4000000 : 900000),
		};
		for (int n = RED; n <= ALPHA; n++) {
			v[i].attribute[n] = most == 0
				? random_between(seed, 0x80, 0xFF80)
				: random_between(seed, 0, 1) ? 0x80
							     : 0xFF80;
		}
	}
}

static void fill_projected(struct scene *scene, fill_function fill,
	uint32_t seed, bool perspective)
{
	struct draw *draw = scene->soft->draw;

	draw->fill = fill;
	draw->perspective = perspective;
	soft_prepare_fast_setup(draw);
	for (int i = 0; i < 100; i++) {
		struct vertex v[3];
		struct vertex *const corner[3] = {&v[0], &v[1], &v[2]};

		make_projected(&seed, v);
		soft_fill_triangle(draw, corner);
	}
}

/* Two that should draw the same. */
struct fills {
	fill_function slow, fast_setup;
	enum kind kind;
	uint32_t rounds;
	bool perspective; /* in every second one */
	bool exact;       /* the fast path is chosen and draws the same bytes */
};

static void check_fills(const struct fills *fills)
{
	struct soft_corner corner[CORNERS];

	make_triangles(corner, 1, fills->kind, 10);
	for (uint32_t seed = 1; seed <= fills->rounds; seed++) {
		struct scene *fast_setup = open_scene(7), *slow = open_scene(7);
		bool perspective = fills->perspective && seed % 2;

		draw(slow, corner, fills->kind, false);
		fill_projected(slow, fills->slow, seed, perspective);
		draw(fast_setup, corner, fills->kind, false);
		if (fills->exact) {
			assert_true(fast_setup->soft->draw->fill ==
				fills->fast_setup);
		}
		fill_projected(fast_setup, fills->fast_setup, seed, perspective);
		compare(fast_setup, slow);
		if (fills->exact) {
			assert_memory_equal(fast_setup->all, slow->all,
				sizeof(fast_setup->all));
		}
		close_scene(fast_setup);
		close_scene(slow);
	}
}

static void test_narrow_triangles_are_as_in_c(void **state)
{
	(void)state;
	check_fills(&(struct fills){
		.slow = soft_fill_narrow_c,
		.fast_setup = soft_fill_narrow,
		.kind = PLAIN,
		.rounds = 300,
		.perspective = true,
		.exact = true,
	});
}

static void test_shadows_are_as_in_c(void **state)
{
	(void)state;
	check_fills(&(struct fills){
		.slow = soft_fill_flat,
		.fast_setup = soft_fill_masked,
		.kind = SHADOW,
		.rounds = 200,
		.exact = true,
	});
}

/*
 * Slivers whose edges round to a centre outside of them may get any depth
 * there: one in 30,000 of these triangles does, none of the first 15,000.
 */
static void test_narrow_triangles_are_those_of_the_long_way(void **state)
{
	(void)state;
	check_fills(&(struct fills){
		.slow = soft_rows_fill,
		.fast_setup = soft_fill_narrow_c,
		.kind = PLAIN,
		.rounds = 150,
	});
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_plain_triangles_are_those_of_the_long_way),
		cmocka_unit_test(test_shadows_are_those_of_the_long_way),
		cmocka_unit_test(
			test_textured_triangles_are_nearly_those_of_the_long_way),
		cmocka_unit_test(test_lists_are_drawn_the_same_in_assembly),
		cmocka_unit_test(test_shorts_are_drawn_like_floats),
		cmocka_unit_test(test_a_context_needs_less_than_256_kib),
		cmocka_unit_test(test_drawing_takes_no_memory),
		cmocka_unit_test(test_narrow_triangles_are_as_in_c),
		cmocka_unit_test(test_shadows_are_as_in_c),
		cmocka_unit_test(test_narrow_triangles_are_those_of_the_long_way),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
