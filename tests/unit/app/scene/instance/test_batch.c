/*
 * Batches have the primitive's triangles, each corner with its own texture
 * coordinate and colour, however the vertices are arranged.
 */
#include "app/model/color.h"
#include "app/scene/instance/batch/batch.h"
#include "platform/base/compiler.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	SIDE = 12,
	VERTICES = (SIDE + 1) * (SIDE + 1),
	CORNERS = SIDE * SIDE * 6,
	MOST = 65535 /* corners of a batch without an index */
};

static float texcoord[VERTICES][2];
static uint8_t color[VERTICES][4];

/* What a primitive may be. */
struct kind {
	const char *kernel;
	bool normals;  /* one a vertex */
	bool blended;  /* its triangles keep their order */
	bool colorful; /* triangles have corners of several colours */
	float alpha;   /* of the material's colour */
};

static struct model *make_model(const struct kind *kind)
{
	struct model *model = small_model_grid(SIDE, SIDE, 1, kind->normals);
	struct model_primitive *primitive = model->mesh[0].primitive;

	assert_int_equal(primitive->vertex_count, VERTICES);
	assert_int_equal(primitive->index_count, CORNERS);
	for (int v = 0; v < VERTICES; v++) {
		texcoord[v][0] = (float)v;
		texcoord[v][1] = (float)(v * v);
		for (int i = 0; i < 4; i++) {
			color[v][i] = (uint8_t)(200 + 10 * i +
				(kind->colorful ? v % 16 : 0));
		}
	}
	primitive->texcoord = texcoord;
	primitive->color = color;
	model->material[0].base_color[0] = 0.25f;
	model->material[0].base_color[1] = 0.5f;
	model->material[0].base_color[3] = kind->alpha;
	model->material[0].alpha = kind->blended ? MODEL_BLEND : MODEL_OPAQUE;
	return model;
}

static struct instance *make_instance(
	const struct model *model, const char *kernel)
{
	struct log nowhere = log_to_nowhere();
	struct instance *instance;

	assert_int_equal(
		instance_create(model, kernel_find(kernel), &nowhere, &instance),
		0);
	return instance;
}

/* A triangle by its corners' numbers in the primitive, the least one first. */
struct triangle {
	int corner[3];
};

static struct triangle turned(int a, int b, int c)
{
	if (b < a && b < c) {
		return (struct triangle){{b, c, a}};
	}
	return c < a && c < b ? (struct triangle){{c, a, b}}
			      : (struct triangle){{a, b, c}};
}

static int compare(const void *left, const void *right)
{
	return memcmp(left, right, sizeof(struct triangle));
}

/* What the drawable's batches draw; returns how many triangles. */
static int list_triangles(const struct drawable *drawable, struct triangle *out)
{
	int count = 0;

	for (int b = 0; b < drawable->batch_count; b++) {
		const struct batch *batch = &drawable->batch[b];
		int corners =
			batch->index ? batch->index_count : batch->vertex_count;

		for (int i = 0; i + 2 < corners; i += 3) {
			int v[3];

			for (int k = 0; k < 3; k++) {
				v[k] = batch_vertex(drawable, batch,
					batch->index ? batch->index[i + k]
						     : i + k);
			}
			out[count++] = turned(v[0], v[1], v[2]);
		}
	}
	return count;
}

static void check_triangles(const struct drawable *drawable, bool in_their_order)
{
	const struct model_primitive *primitive = drawable->primitive;
	static struct triangle drawn[CORNERS / 3], wanted[CORNERS / 3];

	assert_int_equal(list_triangles(drawable, drawn), CORNERS / 3);
	for (int i = 0; i < CORNERS / 3; i++) {
		const uint32_t *index = primitive->index + 3 * i;

		wanted[i] = turned((int)index[0], (int)index[1], (int)index[2]);
	}
	if (!in_their_order) {
		qsort(drawn, CORNERS / 3, sizeof(drawn[0]), compare);
		qsort(wanted, CORNERS / 3, sizeof(wanted[0]), compare);
	}
	assert_memory_equal(drawn, wanted, sizeof(wanted));
}

/* Colours of vertices times those of the material, encoded as they are. */
static void check_attributes(const struct drawable *drawable, float alpha)
{
	const float factor[4] = {
		color_encode_srgb(0.25f), color_encode_srgb(0.5f), 1, alpha};

	for (int b = 0; b < drawable->batch_count; b++) {
		const struct batch *batch = &drawable->batch[b];

		for (int v = 0; v < batch->vertex_count; v++) {
			int from = batch_vertex(drawable, batch, v);

			assert_memory_equal(batch->texcoord[v], texcoord[from],
				sizeof(texcoord[0]));
			for (int i = 0; i < 4; i++) {
				assert_near(batch->color[v][i],
					color[from][i] * factor[i], 0.51);
			}
		}
	}
}

static const struct kind kinds[] = {{"float", true, false, true, 1},
	{"float", true, true, true, 0.5f}, {"float", false, false, false, 1},
	{"float", false, false, true, 1}, {"float", false, true, false, 0.5f},
	{"fixed", true, false, true, 1}, {"fixed", true, true, true, 0.5f},
	{"fixed", false, false, false, 1}, {"fixed", false, false, true, 1},
	{"fixed", false, true, false, 0.5f}};

static void test_each_triangle_is_drawn_once_with_its_corners(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(kinds); i++) {
		const struct kind *kind = &kinds[i];
		struct model *model = make_model(kind);
		struct instance *instance = make_instance(model, kind->kernel);
		const struct drawable *drawable = &instance->drawable[0];
		const struct batch *batch = drawable->batch;

		check_triangles(drawable, kind->blended);
		check_attributes(drawable, kind->alpha);
		/* Only facets and triangles apart need copies. */
		assert_int_equal(batch->source == NULL, kind->normals);
		assert_int_equal(batch->index == NULL,
			!kind->normals && (kind->blended || kind->colorful));
		assert_int_equal(
			batch->position == NULL, drawable->fixed != NULL);
		assert_int_equal(
			batch->fixed_normal == NULL, drawable->fixed == NULL);
		assert_int_equal(batch->normal == NULL, drawable->fixed != NULL);
		instance_destroy(instance);
		model_destroy(model);
	}
}

/* White materials leave the model's own colours in use. */
static void test_colours_are_copied_only_to_change_them(void **state)
{
	(void)state;
	for (int i = 0; i < 5; i++) {
		struct model *model = make_model(&kinds[0]);
		struct instance *instance;

		model->material[0].unlit = true;
		for (int k = 0; k < 4; k++) {
			model->material[0].base_color[k] = k == i ? 0.5f : 1;
		}
		instance = make_instance(model, "float");
		assert_int_equal(
			(const void *)instance->drawable[0].batch->color ==
				(const void *)color,
			i == 4);
		instance_destroy(instance);
		model_destroy(model);
	}
}

/* One list of its own for shadows, or those of the file. */
static void test_a_shadow_has_a_list(void **state)
{
	static uint32_t two[6] = {
		0, SIDE, VERTICES - 1, 0, VERTICES - 1, VERTICES - 1 - SIDE};
	static struct model_lod lod[3] = {
		{.error_m = 0.01f, .index_count = 6, .index = two},
		{.error_m = 0.02f,
			.shadow_only = true,
			.index_count = 6,
			.index = two},
		{.error_m = 0.04f,
			.shadow_only = true,
			.index_count = 3,
			.index = two}};

	(void)state;
	for (size_t i = 0; i < 2 * ARRAY_COUNT(kinds); i++) {
		const struct kind *kind = &kinds[i / 2];
		struct model *model = make_model(kind);
		const struct batch *batch;
		struct instance *instance;

		if (i % 2) {
			model->mesh[0].primitive->lod = lod;
			model->mesh[0].primitive->lod_count = 3;
		}
		instance = make_instance(model, kind->kernel);
		batch = instance->drawable[0].batch;
		assert_int_equal(batch->lod_count, i % 2 ? 1 : 0);
		if (batch->index || i % 2) {
			assert_int_equal(batch->shadow_count, i % 2 ? 2 : 1);
			assert_true(batch->shadow[0].index_count >= 6);
			assert_non_null(batch->shadow[0].index);
		}
		instance_destroy(instance);
		model_destroy(model);
	}
}

/* Triangles without an index are divided into batches that GL can count. */
static void test_many_corners_take_several_batches(void **state)
{
	static const int counts[][2] = {
		{MOST - 3, 1}, {MOST, 1}, {MOST + 3, 2}, {2 * MOST, 2}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(counts); i++) {
		struct model *model = small_model_grid(150, 150, 1, false);
		struct instance *instance;
		const struct drawable *drawable;
		int left = counts[i][0];

		assert_true(model->mesh[0].primitive->index_count > 2 * MOST);
		model->mesh[0].primitive->index_count = left;
		model->material[0].alpha = MODEL_BLEND;
		model->material[0].base_color[3] = 0.5f;
		instance = make_instance(model, "float");
		drawable = &instance->drawable[0];
		assert_int_equal(drawable->batch_count, counts[i][1]);
		for (int b = 0; b < drawable->batch_count; b++) {
			assert_int_equal(drawable->batch[b].vertex_count,
				left < MOST ? left : MOST);
			left -= drawable->batch[b].vertex_count;
		}
		assert_int_equal(left, 0);
		instance_destroy(instance);
		model_destroy(model);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_each_triangle_is_drawn_once_with_its_corners),
		cmocka_unit_test(test_colours_are_copied_only_to_change_them),
		cmocka_unit_test(test_a_shadow_has_a_list),
		cmocka_unit_test(test_many_corners_take_several_batches),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
