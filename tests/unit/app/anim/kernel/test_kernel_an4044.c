/*
 * Compares AN4044's own loops with the float kernel, but for rounding.
 */
#include "app/anim/kernel/kernel.h"
#include "app/cmd/bench/bench_mesh.h"
#include "tests/support/test.h"

enum {
	VERTICES = 150, /* not a multiple of what passes at a time */
};

static const double rounding = 2e-6;

struct fixture {
	const struct kernel *kernel;
	struct bench_mesh mesh;
	struct arena arena;
	struct skin_stream stream;
	float expected[VERTICES][3], expected_normal[VERTICES][3];
	float actual[VERTICES][3], actual_normal[VERTICES][3];
};

static void begin(struct fixture *f, int influences)
{
	f->kernel = kernel_find("an4044");
	f->arena = arena_empty();
	assert_non_null(f->kernel);
	assert_int_equal(bench_mesh_make(&f->mesh, VERTICES, influences, 0), 0);
	assert_int_equal(skin_stream_init(&f->stream, &f->mesh.primitive, 1.0f,
				 &f->arena),
		0);
}

static void end(struct fixture *f)
{
	arena_release(&f->arena);
	bench_mesh_release(&f->mesh);
}

static void skin_with_both(struct fixture *f, int max, bool with_normals)
{
	const mat4 *palette = (const mat4 *)f->mesh.palette;

	kernel_float.skin(&f->stream, palette, max, f->expected,
		with_normals ? f->expected_normal : NULL);
	f->kernel->skin(&f->stream, palette, max, f->actual,
		with_normals ? f->actual_normal : NULL);
	assert_all_near(f->actual, f->expected, VERTICES * 3, rounding);
	if (with_normals) {
		assert_all_near(f->actual_normal, f->expected_normal,
			VERTICES * 3, rounding);
	}
}

static void test_skins_as_float_does(void **state)
{
	(void)state;
	for (int influences = 1; influences <= 4; influences++) {
		struct fixture f;

		begin(&f, influences);
		skin_with_both(&f, 0, false);
		skin_with_both(&f, 0, true);
		end(&f);
	}
}

static void test_caps_influences_as_float_does(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f, 4);
	skin_with_both(&f, 2, true);
	end(&f);
}

static void test_interpolates_as_float_does(void **state)
{
	static const float heights[2][3] = {{0, 0, 0}, {0, 0.25f, -0.125f}};
	struct fixture f;

	(void)state;
	begin(&f, 1);
	for (int i = 0; i < 2; i++) {
		const float(*source)[3] =
			(const float(*)[3])f.mesh.primitive.position;
		const float(*destiny)[3] = (const float(*)[3])f.mesh.destiny;

		kernel_float.morph_lerp(VERTICES, source, destiny, 0.7f,
			heights[i], f.expected);
		f.kernel->morph_lerp(
			VERTICES, source, destiny, 0.7f, heights[i], f.actual);
		assert_all_near(f.actual, f.expected, VERTICES * 3, rounding);
	}
	end(&f);
}

static void test_mixes_targets_as_float_does(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f, 1);
	for (int count = 0; count <= 4; count++) {
		const float(*base)[3] =
			(const float(*)[3])f.mesh.primitive.position;
		const float(*delta[2])[3] = {(const float(*)[3])f.mesh.delta[0],
			(const float(*)[3])f.mesh.delta[1]};
		const struct morph_term term[4] = {
			{.weight = 0.5f, .position = delta[0]},
			{.weight = 0.0f, .position = delta[1]},
			{.weight = -0.25f, .position = delta[1]},
			{.weight = 0.75f, .position = delta[0]},
		};

		kernel_float.morph_targets(
			VERTICES, base, term, count, false, f.expected);
		f.kernel->morph_targets(
			VERTICES, base, term, count, false, f.actual);
		assert_all_near(f.actual, f.expected, VERTICES * 3, rounding);
	}
	end(&f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_skins_as_float_does),
		cmocka_unit_test(test_caps_influences_as_float_does),
		cmocka_unit_test(test_interpolates_as_float_does),
		cmocka_unit_test(test_mixes_targets_as_float_does),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
