/* Levels of detail of skins: bent limbs stay round. */
#include "app/model/levels/levels.h"
#include "app/model/model_loader.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>

enum {
	SIDE = 40, /* quads along each side of the net */
	ROW = SIDE + 1,
	COUNT = ROW * ROW
};

/* A flat net of 1 m, in which one joint takes over from another along x. */
static void fill(struct model_primitive *primitive, struct arena *arena)
{
	primitive->vertex_count = COUNT;
	primitive->position = arena_alloc(arena, COUNT, sizeof(float[3]));
	primitive->normal = arena_alloc(arena, COUNT, sizeof(float[3]));
	primitive->influences = 2;
	primitive->joint = ARENA_ARRAY(arena, uint16_t, 2 * COUNT);
	primitive->weight = ARENA_ARRAY(arena, float, 2 * COUNT);
	for (int i = 0; i < COUNT; i++) {
		float second = (float)(i % ROW) / SIDE;

		primitive->position[i][0] = second;
		primitive->position[i][1] = (float)(i / ROW) / SIDE;
		primitive->normal[i][2] = 1.0f;
		primitive->joint[2 * i + 1] = 1;
		primitive->weight[2 * i] = 1.0f - second;
		primitive->weight[2 * i + 1] = second;
	}
}

static void list_triangles(
	struct model_primitive *primitive, struct arena *arena)
{
	uint32_t *next = ARENA_ARRAY(arena, uint32_t, SIDE * SIDE * 6);

	primitive->index = next;
	primitive->index_count = SIDE * SIDE * 6;
	for (uint32_t i = 0; i < SIDE * ROW; i++) {
		if (i % ROW < SIDE) {
			*next++ = i;
			*next++ = i + 1;
			*next++ = i + ROW;
			*next++ = i + ROW;
			*next++ = i + 1;
			*next++ = i + ROW + 1;
		}
	}
}

/*
 * Bent by 60 degrees about y, a straight edge cuts off a quarter of the product
 * of its length in x and the change of weight along it.
 */
static void test_a_limb_bends_round_within_its_levels_errors(void **state)
{
	struct model model = {.arena = arena_empty(), .mesh_count = 1};
	struct model_mesh mesh = {.primitive_count = 1};
	struct model_primitive primitive = {0};

	(void)state;
	mesh.primitive = &primitive;
	model.mesh = &mesh;
	fill(&primitive, &model.arena);
	list_triangles(&primitive, &model.arena);
	assert_int_equal(levels_make(&model), 0);
	assert_true(primitive.lod_count > 0);
	for (int i = 0; i < primitive.lod_count; i++) {
		const struct model_lod *lod = &primitive.lod[i];

		for (int j = 0; j < lod->index_count; j++) {
			int next = j % 3 == 2 ? j - 2 : j + 1;
			float along = primitive.position[lod->index[next]][0] -
				primitive.position[lod->index[j]][0];

			assert_true(
				0.25f * along * along <= 3.0f * lod->error_m);
		}
	}
	arena_release(&model.arena);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_limb_bends_round_within_its_levels_errors),
	};

	return cmocka_run_group_tests_name("levels_skin", tests, NULL, NULL);
}
