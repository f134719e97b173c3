/* Updates that pose only the vertices that the chosen lists draw. */
#include "app/anim/clip.h"
#include "app/model/levels/levels.h"
#include "app/scene/instance/batch/batch.h"
#include "app/scene/instance/lod.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	SENTINEL = 0x7ABC
};

struct scene {
	struct model *model;
	struct instance *instance;
	struct clip_cursor cursor;
};

typedef int create_function(const struct model *model,
	const struct kernel *kernel, const struct log *log,
	struct instance **out);

static struct scene begin(const char *kernel, create_function *create)
{
	struct log nowhere = log_to_nowhere();
	struct scene scene;

	assert_int_equal(
		model_load("assets/walker.glb", &nowhere, &scene.model), 0);
	assert_int_equal(levels_make(scene.model), 0);
	assert_int_equal(create(scene.model, kernel_find(kernel), &nowhere,
				 &scene.instance),
		0);
	assert_int_equal(clip_cursor_init(&scene.cursor, scene.model,
				 &scene.instance->arena),
		0);
	return scene;
}

static void end(struct scene *scene)
{
	instance_destroy(scene->instance);
	model_destroy(scene->model);
}

static void choose_level(struct scene *scene, int level)
{
	struct lod lod = {.kind = LOD_LEVEL, .level = level};

	lod_choose(scene->instance, &lod, 100.0f);
}

static void pose(struct scene *scene, float time_s)
{
	clip_pose(&scene->model->clip[model_find_clip(scene->model, "walk")],
		time_s, CLIP_AUTO, &scene->cursor, &scene->instance->pose);
	instance_update(scene->instance);
}

/* Marks all output as not written. */
static void spoil(struct scene *scene)
{
	for (int i = 0; i < scene->instance->drawable_count; i++) {
		struct drawable *drawable = &scene->instance->drawable[i];

		for (int v = 0; v < drawable->primitive->vertex_count; v++) {
			drawable->fixed->position[v].fraction = SENTINEL;
			drawable->fixed->position[v].x = SENTINEL;
		}
	}
}

static int count_spoilt(const struct scene *scene)
{
	int count = 0;

	for (int i = 0; i < scene->instance->drawable_count; i++) {
		const struct drawable *drawable = &scene->instance->drawable[i];

		for (int v = 0; v < drawable->primitive->vertex_count; v++) {
			count += drawable->fixed->position[v].x == SENTINEL &&
				drawable->fixed->position[v].fraction ==
					SENTINEL;
		}
	}
	return count;
}

/* What draw.h draws of a batch: the level's list, and its shadow's. */
static void assert_drawn_as_in(const struct drawable *drawable,
	const struct drawable *all, const uint16_t *index, int count)
{
	for (int i = 0; i < count; i++) {
		uint32_t vertex = drawable->fixed->order[index[i]];
		uint32_t other = all->fixed->inverse_order[vertex];

		assert_memory_equal(&drawable->fixed->position[index[i]],
			&all->fixed->position[other],
			sizeof(struct fixed_vector));
		assert_memory_equal(&drawable->fixed->normal[index[i]],
			&all->fixed->normal[other], sizeof(struct fixed_vector));
	}
}

static void assert_same_drawing(
	const struct drawable *drawable, const struct drawable *all)
{
	const struct batch *batch = drawable->batch;
	const struct batch_lod *shadow = drawable_shadow(drawable, batch);

	if (drawable->lod > 0) {
		const struct batch_lod *lod = &batch->lod[drawable->lod - 1];

		assert_drawn_as_in(drawable, all, lod->index, lod->index_count);
	} else {
		assert_drawn_as_in(
			drawable, all, batch->index, batch->index_count);
	}
	assert_non_null(shadow);
	assert_drawn_as_in(drawable, all, shadow->index, shadow->index_count);
}

static void test_each_level_has_the_vertices_that_it_draws(void **state)
{
	struct scene all = begin("fixed", instance_create);
	struct scene few = begin("fixed", instance_create_for_drawing);
	int level_count = few.instance->drawable[0].batch->lod_count;
	int spared = 0;

	(void)state;
	for (int level = 0; level <= level_count; level++) {
		choose_level(&few, level);
		spoil(&few);
		pose(&few, 0.1f * (float)level);
		pose(&all, 0.1f * (float)level);
		for (int i = 0; i < few.instance->drawable_count; i++) {
			assert_same_drawing(&few.instance->drawable[i],
				&all.instance->drawable[i]);
		}
		assert_true(count_spoilt(&few) >= spared);
		spared = count_spoilt(&few);
	}
	/* The coarsest level needs less than a third of 5,001 vertices. */
	assert_true(spared > 3400);
	end(&all);
	end(&few);
}

static void test_all_vertices_are_posed_unless_asked_otherwise(void **state)
{
	struct scene scene = begin("fixed", instance_create);

	(void)state;
	choose_level(&scene, 4);
	spoil(&scene);
	pose(&scene, 0.3f);
	assert_int_equal(count_spoilt(&scene), 0);
	assert_false(instance_is_stale(scene.instance));
	choose_level(&scene, 0);
	assert_false(instance_is_stale(scene.instance));
	end(&scene);
}

static void test_a_finer_level_asks_for_an_update(void **state)
{
	struct scene scene = begin("fixed", instance_create_for_drawing);

	(void)state;
	choose_level(&scene, 4);
	pose(&scene, 0.3f);
	assert_false(instance_is_stale(scene.instance));
	choose_level(&scene, 99);
	assert_false(instance_is_stale(scene.instance));
	choose_level(&scene, 1);
	assert_true(instance_is_stale(scene.instance));
	pose(&scene, 0.3f);
	assert_false(instance_is_stale(scene.instance));
	end(&scene);
}

static void test_float_vertices_are_posed_at_every_level(void **state)
{
	struct scene scene = begin("float", instance_create_for_drawing);

	(void)state;
	choose_level(&scene, 4);
	pose(&scene, 0.3f);
	for (int i = 0; i < scene.instance->drawable_count; i++) {
		struct drawable *drawable = &scene.instance->drawable[i];

		memset(drawable->position, 0xFF,
			(size_t)drawable->primitive->vertex_count *
				sizeof(*drawable->position));
	}
	pose(&scene, 0.4f);
	for (int i = 0; i < scene.instance->drawable_count; i++) {
		const struct drawable *drawable = &scene.instance->drawable[i];

		for (int v = 0; v < drawable->primitive->vertex_count; v++) {
			assert_true(drawable->position[v][0] ==
				drawable->position[v][0]);
		}
	}
	end(&scene);
}

/* A tint belongs to one instance. */
static void test_a_tint_changes_one_instance_alone(void **state)
{
	static const float half[3] = {0.5f, 0.0f, 1.0f};
	struct scene plain = begin("fixed", instance_create),
		     tinted = begin("fixed", instance_create);
	struct drawable *drawable = &tinted.instance->drawable[0];
	const struct batch *from = plain.instance->drawable[0].batch;
	const struct batch *to = drawable->batch;

	(void)state;
	assert_int_equal(batch_tint(drawable, half, &tinted.instance->arena), 0);
	for (int v = 0; v < to->vertex_count; v++) {
		assert_int_equal(to->color[v][0], (from->color[v][0] + 1) / 2);
		assert_int_equal(to->color[v][1], 0);
		assert_int_equal(to->color[v][2], from->color[v][2]);
		assert_int_equal(to->color[v][3], from->color[v][3]);
	}
	end(&plain);
	end(&tinted);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_level_has_the_vertices_that_it_draws),
		cmocka_unit_test(
			test_all_vertices_are_posed_unless_asked_otherwise),
		cmocka_unit_test(test_a_finer_level_asks_for_an_update),
		cmocka_unit_test(test_float_vertices_are_posed_at_every_level),
		cmocka_unit_test(test_a_tint_changes_one_instance_alone),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
