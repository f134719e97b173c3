/* Which surfaces are blended, and which of them are drawn first. */
#include "app/model/model_alpha.h"
#include "app/scene/draw/alpha.h"
#include "platform/base/compiler.h"
#include "tests/support/model/instance_pair.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/model/small_model.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

/* A grid of a square with the given alphas. */
struct surface {
	enum model_alpha alpha;
	float cutoff, base_alpha;
	uint8_t texel_alpha, vertex_alpha;
};

static enum model_alpha alpha_of_surface(const struct surface *surface)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct model_primitive *primitive = model->mesh[0].primitive;
	struct model_material *material = model->material;
	struct model_texture texture = {0};
	struct model_image image = {.opaque = surface->texel_alpha == 255};
	float texcoord[4][2] = {{0}};
	uint8_t color[4][4] = {{0}};
	enum model_alpha out;

	for (int v = 0; v < 4; v++) {
		color[v][3] = v == 3 ? surface->vertex_alpha : 255;
	}
	primitive->texcoord = texcoord;
	primitive->color = color;
	model->image = &image;
	model->texture = &texture;
	material->texture = 0;
	material->alpha = surface->alpha;
	material->alpha_cutoff = surface->cutoff;
	material->base_color[3] = surface->base_alpha;
	out = model_alpha_of(model, primitive);
	/* Without texture coordinates there is no texture. */
	primitive->texcoord = NULL;
	if (surface->texel_alpha != 255 && surface->base_alpha == 1.0f &&
		surface->vertex_alpha == 255) {
		assert_int_equal(model_alpha_of(model, primitive), MODEL_OPAQUE);
	}
	model_destroy(model);
	return out;
}

static void test_only_what_shows_through_is_blended(void **state)
{
	static const struct surface opaque[] = {
		{MODEL_BLEND, 0.5f, 1.0f, 255, 255},
		{MODEL_MASK, 0.5f, 1.0f, 255, 255},
		{MODEL_MASK, 0.5f, 0.5f, 255, 255},
		{MODEL_MASK, 0.5f, 1.0f, 255, 128},
		{MODEL_OPAQUE, 0.5f, 0.2f, 0, 0},
	};
	static const struct surface not_opaque[] = {
		{MODEL_BLEND, 0.5f, 0.99f, 255, 255},
		{MODEL_BLEND, 0.5f, 1.0f, 254, 255},
		{MODEL_BLEND, 0.5f, 1.0f, 255, 254},
		{MODEL_MASK, 0.5f, 0.49f, 255, 255},
		{MODEL_MASK, 0.5f, 1.0f, 254, 255},
		{MODEL_MASK, 0.5f, 1.0f, 255, 127},
		{MODEL_MASK, 0.5f, 0.9f, 255, 128},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(opaque); i++) {
		assert_int_equal(alpha_of_surface(&opaque[i]), MODEL_OPAQUE);
	}
	for (size_t i = 0; i < ARRAY_COUNT(not_opaque); i++) {
		assert_int_equal(
			alpha_of_surface(&not_opaque[i]), not_opaque[i].alpha);
	}
}

static void blend_all(struct model *model)
{
	for (int i = 0; i < model->material_count; i++) {
		model->material[i].alpha = MODEL_BLEND;
		model->material[i].base_color[3] = 0.5f;
	}
}

/* Of the drawables, by their number. */
static void expect_order(
	struct instance *instance, float eye_z, const int *order)
{
	alpha_sort_blended(instance, (float[3]){0.3f, 0.2f, eye_z});
	for (int i = 0; i < instance->blended_count; i++) {
		assert_int_equal(instance->blended[i].drawable, order[i]);
	}
}

/* Panes at these depths, as nodes of one mesh. */
static void test_far_surfaces_come_first_from_each_side(void **state)
{
	static const float depth[] = {
		3.0f, -5.0f, 3.0f, 7.0f, 0.0f, -2.0f, 4.0f};
	static const int from_front[] = {1, 5, 4, 0, 2, 6, 3};
	static const int from_behind[] = {3, 6, 0, 2, 4, 5, 1};
	enum {
		PANES = ARRAY_COUNT(depth)
	};
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct model_node node[PANES], *single = model->node;
	struct instance *instance;

	(void)state;
	for (int i = 0; i < PANES; i++) {
		node[i] = single[0];
		node[i].rest.translation[2] = depth[i];
	}
	model->node = node;
	model->node_count = PANES;
	blend_all(model);
	instance = small_model_instance(model);
	assert_int_equal(instance->blended_count, PANES);
	expect_order(instance, 100.0f, from_front);
	expect_order(instance, -100.0f, from_behind);
	expect_order(instance, 100.0f, from_front);
	instance_destroy(instance);
	model_destroy(model);
}

/* Any number of panes in any order, as the sort takes its steps by their number. */
static void test_any_number_of_surfaces_is_sorted(void **state)
{
	enum {
		PANES_MAX = 40
	};
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct model_node node[PANES_MAX], *single = model->node;
	uint32_t seed = 1;

	(void)state;
	model->node = node;
	blend_all(model);
	for (int count = 2; count <= PANES_MAX; count++) {
		struct instance *instance;
		int order[PANES_MAX];

		for (int i = 0; i < count; i++) {
			int at = random_between(&seed, 0, i);

			order[i] = order[at];
			order[at] = i;
		}
		for (int i = 0; i < count; i++) {
			node[order[i]] = single[0];
			node[order[i]].rest.translation[2] = (float)i;
		}
		model->node_count = count;
		instance = small_model_instance(model);
		expect_order(instance, 100.0f, order);
		instance_destroy(instance);
	}
	model->node = single;
	model_destroy(model);
}

/* Two drawables of the fixture are skins; their roots are these nodes. */
static void test_skins_are_where_their_joints_took_them(void **state)
{
	struct model *model = model_fixture("gltf/skin/shared_mesh.gltf", NULL);
	const int root[2] = {(int)(fixture_node(model, 3) - model->node),
		(int)(fixture_node(model, 5) - model->node)};
	struct instance_pair pair;

	(void)state;
	blend_all(model);
	instance_pair_begin(&pair, model);
	for (int nearer = 0; nearer < 2; nearer++) {
		struct instance *both[2] = {pair.exact, pair.fixed};

		for (int k = 0; k < 2; k++) {
			float *to = pair.exact->pose.local[root[k]].translation;

			to[2] = k == nearer ? 2.0f : -2.0f;
			pair.exact->pose.animated[root[k]] = true;
		}
		instance_pair_pose(&pair, -1, 0.0f);
		for (int i = 0; i < 2; i++) {
			expect_order(both[i], 10.0f,
				nearer == 0 ? (int[]){1, 2, 0}
					    : (int[]){0, 2, 1});
		}
	}
	instance_pair_end(&pair);
}

/* Sorting would put the second triangle first. */
static void test_blended_triangles_stay_in_the_order_of_the_file(void **state)
{
	struct model *model = small_model_grid(8, 1, 1.0f, true);
	struct model_primitive *primitive = model->mesh[0].primitive;

	(void)state;
	for (int i = 0; i < primitive->index_count / 2; i++) {
		int other = primitive->index_count - 1 - i;
		uint32_t kept = primitive->index[i];

		primitive->index[i] = primitive->index[other];
		primitive->index[other] = kept;
	}
	blend_all(model);
	for (int flat = 0; flat < 2; flat++) {
		struct instance *instance = small_model_instance(model);
		const struct batch *batch = instance->drawable[0].batch;

		for (int i = 0; i < primitive->index_count; i++) {
			uint32_t v =
				batch->index ? batch->index[i] : (uint32_t)i;

			assert_int_equal(batch->source ? batch->source[v] : v,
				primitive->index[i]);
		}
		instance_destroy(instance);
		primitive->normal = NULL;
	}
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_only_what_shows_through_is_blended),
		cmocka_unit_test(test_far_surfaces_come_first_from_each_side),
		cmocka_unit_test(test_any_number_of_surfaces_is_sorted),
		cmocka_unit_test(test_skins_are_where_their_joints_took_them),
		cmocka_unit_test(
			test_blended_triangles_stay_in_the_order_of_the_file),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
