/* The looks of the crowd's walkers. */
#include "app/demo/crowd/crowd_dress.h"
#include "platform/base/compiler.h"
#include "platform/base/fixed.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

/* FNV-1a */
static uint32_t hash(uint32_t so_far, const void *bytes, size_t size)
{
	for (size_t i = 0; i < size; i++) {
		so_far = (so_far ^ ((const uint8_t *)bytes)[i]) * 0x01000193u;
	}
	return so_far;
}

/* All colours and textures of a walker, and the colours' mean. */
static uint32_t colors_of(struct model *model, int number, double mean[3])
{
	struct log log = log_to_stderr(LOG_WARNING);
	uint32_t all = 0x811c9dc5u;
	double count = 0.0;
	struct instance *instance;

	assert_int_equal(
		instance_create(model, kernel_find("fixed"), &log, &instance),
		0);
	assert_int_equal(crowd_dress(instance, number), 0);
	memset(mean, 0, 3 * sizeof(mean[0]));
	for (int d = 0; d < instance->drawable_count; d++) {
		const struct drawable *drawable = &instance->drawable[d];
		const struct batch *batch = drawable->batch;

		const int texture =
			instance->model->material[drawable->primitive->material]
				.texture;

		all = hash(all, &texture, sizeof(texture));
		all = hash(all, drawable->color, sizeof(drawable->color));
		for (int v = 0; v < batch->vertex_count; v++) {
			all = hash(all, batch->color[v], 4);
			for (int c = 0; c < 3; c++) {
				mean[c] += batch->color[v][c];
			}
			count += 1.0;
		}
	}
	for (int c = 0; c < 3; c++) {
		mean[c] /= count;
	}
	instance_destroy(instance);
	return all;
}

static void test_each_walker_has_colours_of_its_own(void **state)
{
	/* They change with the looks and with the model's colours. */
	static const uint32_t colors[12] = {0x5a5ff165, 0x36b95631, 0xdc9a0fa,
		0x140acc88, 0x509d60a8, 0x8ed1ffe2, 0xde2a2d7e, 0x6b31903d,
		0x3fd1a664, 0x9f0a4559, 0x711e9ccd, 0xeaa2104d};
	struct log log = log_to_stderr(LOG_WARNING);
	double mean[12][3];
	struct model *model;

	(void)state;
	assert_int_equal(model_load("assets/walker.glb", &log, &model), 0);
	for (int i = 0; i < 12; i++) {
		assert_int_equal(colors_of(model, i, mean[i]), colors[i]);
		for (int other = 0; other < i; other++) {
			double apart = 0.0;

			for (int c = 0; c < 3; c++) {
				apart += fabs(mean[i][c] - mean[other][c]);
			}
			assert_true(apart > 4.0);
		}
	}
	model_destroy(model);
}

/* A board in clothes whose vertices have this colour, rows of 2 cm one by one. */
static struct model *make_board(int rows, const uint8_t color[4])
{
	struct model *model = small_model_grid(1, rows, 2, true);
	struct model_primitive *body = model->mesh[0].primitive;

	model->material[0].name = "shirt";
	model->material[0].unlit = true; /* dark colours mirror nothing */
	body->color = arena_alloc(&model->arena, (size_t)body->vertex_count, 4);
	for (int v = 0; v < body->vertex_count; v++) {
		memcpy(body->color[v], color, 4);
	}
	return model;
}

/* Writes the colour of the board's vertices when the second walker wears it. */
static void wear(const uint8_t color[4], uint8_t worn[4])
{
	struct model *model = make_board(1, color);
	struct instance *instance = small_model_instance(model);

	assert_int_equal(crowd_dress(instance, 1), 0);
	memcpy(worn, instance->drawable[0].batch->color[0], 4);
	instance_destroy(instance);
	model_destroy(model);
}

/* By six tenths, and four tenths of what the look's shirt has of a colour. */
static void test_a_figure_without_clothes_is_tinted_as_a_whole(void **state)
{
	static const uint8_t white[4] = {255, 255, 255, 255};
	static const int tints[][3] = {
		{255, 255, 255}, {245, 190, 182}, {255, 216, 199}};

	(void)state;
	for (int number = 0; number < (int)ARRAY_COUNT(tints); number++) {
		struct model *model = make_board(1, white);
		struct instance *instance;

		model->material[0].name = "paint";
		instance = small_model_instance(model);
		assert_int_equal(crowd_dress(instance, number), 0);
		for (int d = 0; d < instance->drawable_count; d++) {
			const struct batch *batch = instance->drawable[d].batch;

			for (int c = 0; c < 3; c++) {
				assert_in_range(batch->color[0][c],
					tints[number][c] - 1,
					tints[number][c] + 1);
			}
		}
		instance_destroy(instance);
		model_destroy(model);
	}
}

/*
 * Trousers have 9 more of blue than of red, and shoes less than six tenths of
 * red's green. The look's colours are as bright as the model's, which are at
 * most 118 and 222.
 */
static void test_clothes_are_told_apart_by_their_colour(void **state)
{
	static const uint8_t cases[][2][4] = {
		{{90, 90, 98, 255}, {90, 90, 98, 255}},
		{{90, 90, 99, 255}, {58, 60, 67, 255}},
		{{20, 0, 118, 255}, {70, 72, 80, 255}},
		{{20, 0, 119, 255}, {70, 72, 80, 255}},
		{{100, 60, 60, 255}, {100, 60, 60, 255}},
		{{100, 59, 60, 7}, {103, 103, 101, 7}},
		{{222, 0, 0, 255}, {230, 230, 226, 255}},
		{{250, 0, 0, 255}, {230, 230, 226, 255}},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		uint8_t worn[4];

		wear(cases[i][0], worn);
		assert_memory_equal(worn, cases[i][1], 4);
	}
}

/* What vertices of a figure in clothes become, by their colour and height. */
static void expect_looks(float scale)
{
	enum {
		ROWS = 100,
	};
	static const uint8_t red[4] = {200, 40, 40, 255};
	static const uint8_t blue[4] = {40, 40, 200, 255};
	static const uint8_t skin[4] = {200, 150, 130, 255};
	static const uint8_t *const was[] = {red, blue, skin};

	for (int i = 0; i < 3; i++) {
		struct model *model = make_board(ROWS, was[i]);
		struct model_primitive *body = model->mesh[0].primitive;
		struct instance *instance;
		uint8_t(*now)[4];

		for (int v = 0; v < body->vertex_count; v++) {
			for (int axis = 0; axis < 3; axis++) {
				body->position[v][axis] *= scale;
			}
		}
		instance = small_model_instance(model);
		assert_int_equal(crowd_dress(instance, 1), 0);
		now = (uint8_t(*)[4])instance->drawable[0].batch->color;
		for (int v = 0; v < body->vertex_count; v++) {
			int percent = v / 2; /* of the height */
			bool same = memcmp(now[v], was[i], 4) == 0;

			assert_int_equal(same,
				was[i] == skin ||
					(was[i] == blue && percent > 62) ||
					(was[i] == red && percent > 9 &&
						percent < 69));
		}
		instance_destroy(instance);
		model_destroy(model);
	}
}

static void test_hair_trousers_and_shoes_are_told_apart_by_their_height(
	void **state)
{
	(void)state;
	expect_looks(1.0f);
	expect_looks(100.0f);
	expect_looks(0.01f);
}

/* Hair begins above its height, and trousers and shoes end below theirs. */
static void test_what_is_exactly_at_an_edge_keeps_its_colour(void **state)
{
	static const struct {
		float height;
		uint8_t color[4];
	} edges[] = {{0.683f, {200, 40, 40, 255}}, {0.626f, {40, 40, 200, 255}},
		{0.091f, {200, 40, 40, 255}}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(edges); i++) {
		struct model *model = make_board(1, edges[i].color);
		struct model_primitive *body = model->mesh[0].primitive;
		struct instance *instance;

		for (int v = 0; v < body->vertex_count; v++) {
			body->position[v][1] = v == 0 ? edges[i].height : 1;
		}
		instance = small_model_instance(model);
		assert_int_equal(crowd_dress(instance, 1), 0);
		assert_memory_equal(instance->drawable[0].batch->color[0],
			edges[i].color, 4);
		instance_destroy(instance);
		model_destroy(model);
	}
}

/* Which of the walker's traits a figure with a material named "shirt" lacks. */
enum trait {
	VERTEX_COLORS,
	PLAIN_SKIN
};

/* How the second look changes a figure that lacks the trait. */
static void expect_tint_without(enum trait trait)
{
	static const uint8_t gray[4] = {200, 200, 200, 255};
	struct model *model = make_board(1, gray);
	struct model_primitive *body = model->mesh[0].primitive;
	struct model_material material[2] = {
		model->material[0], model->material[0]};
	struct instance *instance;

	model->material = material;
	model->material_count = 2;
	if (trait == VERTEX_COLORS) {
		body->color = NULL;
	} else {
		material[1].name = "skin";
		material[1].texture = 0;
		body->material = 1;
	}
	instance = small_model_instance(model);
	assert_int_equal(crowd_dress(instance, 1), 0);
	assert_ptr_equal(instance->model, model);
	assert_in_range(instance->drawable[0].color[1],
		(unsigned long)(0.73 * FX16_ONE),
		(unsigned long)(0.76 * FX16_ONE));
	instance_destroy(instance);
	model_destroy(model);
}

/* The clothes' rules are those of one model, but "shirt" is a common name. */
static void test_a_shirt_of_another_model_is_tinted_with_its_figure(void **state)
{
	(void)state;
	expect_tint_without(VERTEX_COLORS);
	expect_tint_without(PLAIN_SKIN);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_walker_has_colours_of_its_own),
		cmocka_unit_test(
			test_a_figure_without_clothes_is_tinted_as_a_whole),
		cmocka_unit_test(test_clothes_are_told_apart_by_their_colour),
		cmocka_unit_test(
			test_hair_trousers_and_shoes_are_told_apart_by_their_height),
		cmocka_unit_test(
			test_what_is_exactly_at_an_edge_keeps_its_colour),
		cmocka_unit_test(
			test_a_shirt_of_another_model_is_tinted_with_its_figure),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
