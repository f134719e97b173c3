/* What the reference of a clip takes from its model's memory, and gives back. */
#include "app/compare/measure/posed_vertices.h"
#include "app/compare/measure/reference.h"
#include "platform/base/memory_budget.h"
#include "tests/support/log_capture.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum {
	STEPS = 64
};

static void test_a_reference_without_memory_gives_back_what_it_took(void **state)
{
	struct model *model = model_fixture("gltf/skin/and_morph.gltf", NULL);
	struct memory_budget budget = {.limit_bytes = SIZE_MAX},
			     *own = model->budget;
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct reference *reference;
	size_t all;

	(void)state;
	model->budget = &budget;
	assert_int_equal(reference_create(model, 0, &log, &reference), 0);
	all = budget.used_bytes;
	assert_true(all > STEPS);
	reference_destroy(reference);
	assert_int_equal(budget.used_bytes, 0);
	for (size_t i = 0; i < STEPS; i++) {
		budget.limit_bytes = (all - 1) * i / (STEPS - 1);
		log = log_capture_begin(&logged);
		assert_int_equal(
			reference_create(model, 0, &log, &reference), -ENOMEM);
		assert_int_equal(budget.used_bytes, 0);
		assert_int_equal(logged.count, 1);
		assert_contains(logged.sentence[0], "memory");
	}
	model->budget = own;
	model_destroy(model);
}

static void test_a_clip_without_a_duration_has_no_reference(void **state)
{
	struct model *model = model_fixture("gltf/clip/pose.gltf", NULL);
	struct log_capture logged;
	struct log log = log_capture_begin(&logged);
	struct reference *reference;

	(void)state;
	assert_int_equal(reference_create(model, 0, &log, &reference), -EINVAL);
	assert_true(log_capture_has(
		&logged, LOG_ERROR, "clip 0 has no duration: choose a clip"));
	model_destroy(model);
}

/* Finding normals takes half of the time of a pose. */
static void test_normals_are_posed_where_they_are_asked_for(void **state)
{
	struct model *model = model_fixture("gltf/skin/and_morph.gltf", NULL);
	struct log log = log_to_nowhere();
	struct reference *reference;
	const float(*normal)[3];
	size_t size;
	void *first;

	(void)state;
	assert_int_equal(reference_create(model, 0, &log, &reference), 0);
	reference_pose(reference, 0.0f, true);
	normal = (const float(*)[3])reference->instance->drawable[0].normal;
	size = sizeof(*normal) *
		(size_t)model->mesh[0].primitive[0].vertex_count;
	first = malloc(size);
	assert_non_null(first);
	memcpy(first, normal, size);
	reference_pose(reference, 0.4f, false);
	assert_memory_equal(normal, first, size);
	reference_pose(reference, 0.4f, true);
	assert_memory_not_equal(normal, first, size);
	free(first);
	reference_destroy(reference);
	model_destroy(model);
}

/* One part for each primitive that a node shows, in the drawables' order. */
static void expect_parts(const char *name, bool normals)
{
	struct model *model = model_fixture(name, NULL);
	const struct log log = log_to_nowhere();
	struct reference *reference;
	int first = 0;

	assert_int_equal(reference_create(model, 0, &log, &reference), 0);
	assert_true(reference->part_count > 0);
	for (int i = 0; i < reference->part_count; i++) {
		const struct reference_part *part = &reference->part[i];

		assert_int_equal(part->drawable, i);
		assert_int_equal(part->first_vertex, first);
		assert_int_equal(part->normals, normals);
		first += part->vertex_count;
	}
	assert_int_equal(reference->vertex_count, first);
	reference_destroy(reference);
	model_destroy(model);
}

/* Of a model whose clip begins at another pose than that of rest. */
static void test_the_pose_of_rest_is_computed_at_any_time(void **state)
{
	struct model *model = model_fixture("gltf/skin/and_morph.gltf", NULL);
	const struct log log = log_to_nowhere();
	struct reference *reference;
	struct instance *instance;
	float(*rest)[3];
	size_t count;

	(void)state;
	assert_int_equal(reference_create(model, 0, &log, &reference), 0);
	assert_true(reference->instance->undrawn);
	assert_false(reference->instance->normal_mapping);
	count = (size_t)reference->vertex_count;
	assert_int_equal(
		instance_create(model, kernel_find("float"), &log, &instance),
		0);
	rest = malloc(2 * count * sizeof(*rest));
	assert_non_null(rest);
	posed_vertices_positions(instance, rest);
	posed_vertices_normals(instance, rest + count);
	for (int again = 0; again < 2; again++) {
		reference_rest(reference);
		assert_memory_equal(
			reference->position, rest, count * sizeof(float[3]));
		assert_memory_equal(reference->normal, rest + count,
			count * sizeof(float[3]));
		reference_pose(reference, 0.4f, true);
		assert_memory_not_equal(
			reference->position, rest, count * sizeof(float[3]));
		assert_memory_not_equal(reference->normal, rest + count,
			count * sizeof(float[3]));
	}
	free(rest);
	instance_destroy(instance);
	reference_destroy(reference);
	model_destroy(model);
}

static void test_a_reference_knows_its_clip(void **state)
{
	struct model *model = model_fixture("gltf/clip/door.gltf", NULL);
	const struct log log = log_to_nowhere();

	(void)state;
	assert_true(model->clip_count > 1);
	for (int clip = 0; clip < model->clip_count; clip++) {
		struct reference *reference;

		assert_int_equal(
			reference_create(model, clip, &log, &reference), 0);
		assert_int_equal(reference->clip_index, clip);
		assert_ptr_equal(reference->clip, &model->clip[clip]);
		/* Its keys are not searched for in each pose. */
		assert_non_null(reference->cursor.moving);
		reference_destroy(reference);
	}
	model_destroy(model);
}

/* Positions and normals of each vertex, beside the instance. */
static void test_vertices_count_as_memory_of_the_model(void **state)
{
	struct model *model = model_fixture("gltf/skin/and_morph.gltf", NULL);
	struct memory_budget budget = {.limit_bytes = SIZE_MAX},
			     *own = model->budget;
	const struct log log = log_to_nowhere();
	struct reference *reference;
	struct instance *instance;
	size_t alone;

	(void)state;
	model->budget = &budget;
	assert_int_equal(
		instance_create(model, kernel_find("float"), &log, &instance),
		0);
	alone = budget.used_bytes;
	instance_destroy(instance);
	assert_int_equal(reference_create(model, 0, &log, &reference), 0);
	assert_true(budget.used_bytes >=
		alone + 24 * (size_t)reference->vertex_count);
	reference_destroy(reference);
	model->budget = own;
	model_destroy(model);
}

static void test_parts_tell_whether_they_have_normals(void **state)
{
	(void)state;
	expect_parts("gltf/skin/and_morph.gltf", true);
	expect_parts("gltf/clip/far.gltf", false);
	expect_parts("gltf/clip/normalized.gltf", false);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_reference_without_memory_gives_back_what_it_took),
		cmocka_unit_test(test_a_clip_without_a_duration_has_no_reference),
		cmocka_unit_test(test_normals_are_posed_where_they_are_asked_for),
		cmocka_unit_test(test_parts_tell_whether_they_have_normals),
		cmocka_unit_test(test_the_pose_of_rest_is_computed_at_any_time),
		cmocka_unit_test(test_a_reference_knows_its_clip),
		cmocka_unit_test(test_vertices_count_as_memory_of_the_model),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
