/* model_alpha.h: whether a surface that may be transparent is so. */
#include "app/model/model_alpha.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	VERTICES = 3
};

/* A primitive with a material, which may have a texture, and colours. */
struct fixture {
	struct model_material material[2];
	struct model_image image[2];
	struct model_texture texture[2];
	uint8_t color[VERTICES][4];
	float texcoord[VERTICES][2];
	struct model_primitive primitive;
	struct model model;
};

static void begin(struct fixture *f, enum model_alpha alpha, float of_material)
{
	memset(f, 0, sizeof(*f));
	memset(f->color, 255, sizeof(f->color));
	f->material[0] = f->material[1] = model_plain_material;
	f->material[1].alpha = alpha;
	f->material[1].base_color[3] = of_material;
	f->image[0].opaque = true;
	f->texture[0].image = 1;
	f->primitive = (struct model_primitive){
		.vertex_count = VERTICES, .material = 1};
	f->model = (struct model){.material = f->material,
		.material_count = 2,
		.texture = f->texture,
		.texture_count = 2,
		.image = f->image,
		.image_count = 2};
}

static enum model_alpha alpha_of(const struct fixture *f)
{
	return model_alpha_of(&f->model, &f->primitive);
}

static void test_what_is_opaque_everywhere_is_opaque(void **state)
{
	static const struct {
		enum model_alpha alpha;
		float of_material;
		enum model_alpha wanted;
	} cases[] = {
		{MODEL_OPAQUE, 0, MODEL_OPAQUE},
		{MODEL_OPAQUE, 1, MODEL_OPAQUE},
		{MODEL_BLEND, 1, MODEL_OPAQUE},
		{MODEL_BLEND, 0.99f, MODEL_BLEND},
		{MODEL_MASK, 1, MODEL_OPAQUE},
		{MODEL_MASK, 0.5f, MODEL_OPAQUE}, /* as much as the cutoff */
		{MODEL_MASK, 0.49f, MODEL_MASK},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct fixture f;

		begin(&f, cases[i].alpha, cases[i].of_material);
		assert_int_equal(alpha_of(&f), cases[i].wanted);
	}
}

/* Each vertex counts, and only the fourth number of its colour. */
static void test_the_least_colour_decides(void **state)
{
	(void)state;
	for (int v = 0; v < VERTICES; v++) {
		struct fixture f;

		begin(&f, MODEL_BLEND, 1);
		f.color[v][0] = f.color[v][1] = f.color[v][2] = 0;
		f.primitive.color = f.color;
		assert_int_equal(alpha_of(&f), MODEL_OPAQUE);
		f.color[v][3] = 254;
		assert_int_equal(alpha_of(&f), MODEL_BLEND);
		f.material[1].alpha = MODEL_MASK;
		f.color[v][3] = 128;
		assert_int_equal(alpha_of(&f), MODEL_OPAQUE);
		f.color[v][3] = 127;
		assert_int_equal(alpha_of(&f), MODEL_MASK);
		f.color[v][3] = 255;
		f.material[1].base_color[3] = 0.5f;
		assert_int_equal(alpha_of(&f), MODEL_OPAQUE);
		f.color[v][3] = 254;
		assert_int_equal(alpha_of(&f), MODEL_MASK);
	}
}

/* A texture counts where the primitive has coordinates in it. */
static void test_textures_with_alpha_are_not_opaque(void **state)
{
	(void)state;
	for (int texture = -1; texture < 2; texture++) {
		struct fixture f;

		begin(&f, MODEL_BLEND, 1);
		f.material[1].texture = texture;
		assert_int_equal(alpha_of(&f), MODEL_OPAQUE);
		f.primitive.texcoord = f.texcoord;
		/* Texture 0 has image 1, which is not opaque. */
		assert_int_equal(alpha_of(&f),
			texture == 0 ? MODEL_BLEND : MODEL_OPAQUE);
	}
}

/* Half of the first of 255 steps, or the cutoff. */
static void test_what_shows_nothing_is_not_seen(void **state)
{
	static const struct {
		enum model_alpha alpha;
		float of_material;
		bool seen;
	} cases[] = {
		{MODEL_OPAQUE, 0, true},
		{MODEL_BLEND, 0, false},
		{MODEL_BLEND, 0.49f / 255, false},
		{MODEL_BLEND, 0.51f / 255, true},
		{MODEL_BLEND, 1, true},
		{MODEL_MASK, 0.49f, false},
		{MODEL_MASK, 0.5f, true},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct fixture f;

		begin(&f, cases[i].alpha, cases[i].of_material);
		assert_int_equal(model_alpha_is_seen(&f.model, &f.primitive),
			cases[i].seen);
	}
}

static void test_the_most_colour_decides_whether_it_is_seen(void **state)
{
	(void)state;
	for (int v = 0; v < VERTICES; v++) {
		struct fixture f;

		begin(&f, MODEL_MASK, 1);
		f.primitive.color = f.color;
		for (int i = 0; i < VERTICES; i++) {
			f.color[i][3] = 0;
		}
		assert_false(model_alpha_is_seen(&f.model, &f.primitive));
		f.color[v][3] = 127;
		assert_false(model_alpha_is_seen(&f.model, &f.primitive));
		f.color[v][3] = 128;
		assert_true(model_alpha_is_seen(&f.model, &f.primitive));
		f.material[1].base_color[3] = 0.9f;
		assert_false(model_alpha_is_seen(&f.model, &f.primitive));
		f.material[1].alpha = MODEL_BLEND;
		f.color[v][3] = 1;
		assert_true(model_alpha_is_seen(&f.model, &f.primitive));
		f.color[v][3] = 0;
		assert_false(model_alpha_is_seen(&f.model, &f.primitive));
	}
}

static void test_the_mean_is_that_of_all_vertices(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f, MODEL_BLEND, 0.5f);
	assert_near(model_alpha_mean(&f.model, &f.primitive), 0.5, 0);
	f.primitive.color = f.color;
	assert_near(model_alpha_mean(&f.model, &f.primitive), 0.5, 1e-6);
	f.color[0][3] = 0;
	f.color[1][3] = 51;
	f.color[2][3] = 102;
	/* (0 + 51 + 102) / 3 is a fifth of 255. */
	assert_near(model_alpha_mean(&f.model, &f.primitive), 0.1, 1e-6);
	f.primitive.vertex_count = 0;
	assert_near(model_alpha_mean(&f.model, &f.primitive), 0.5, 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_what_is_opaque_everywhere_is_opaque),
		cmocka_unit_test(test_the_least_colour_decides),
		cmocka_unit_test(test_textures_with_alpha_are_not_opaque),
		cmocka_unit_test(test_what_shows_nothing_is_not_seen),
		cmocka_unit_test(test_the_most_colour_decides_whether_it_is_seen),
		cmocka_unit_test(test_the_mean_is_that_of_all_vertices),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
