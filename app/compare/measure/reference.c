#include "app/compare/measure/reference.h"

#include "app/compare/measure/posed_vertices.h"

#include <errno.h>
#include <stdlib.h>

static int init_parts(struct reference *reference)
{
	const struct instance *instance = reference->instance;
	int first = 0;

	reference->part_count = instance->drawable_count;
	reference->part = ARENA_ARRAY(&reference->arena, struct reference_part,
		(size_t)instance->drawable_count);
	reference->vertex_count = posed_vertices_count(instance);
	if (!reference->part || reference->vertex_count < 0) {
		return -ENOMEM;
	}
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];
		int count = drawable->primitive->vertex_count;

		reference->part[i] = (struct reference_part){
			.drawable = i,
			.first_vertex = first,
			.vertex_count = count,
			.normals = drawable->normal != NULL,
		};
		first += count;
	}
	return 0;
}

static int prepare(
	struct reference *reference, float unit_scale, const struct log *log)
{
	const struct instance_options options = {.unit_scale = unit_scale};
	struct arena *arena = &reference->arena;
	int error = instance_create_with(reference->model, kernel_find("float"),
		&options, log, &reference->instance);
	size_t count;

	if (error) {
		return error;
	}
	reference->instance->normal_mapping = false;
	reference->instance->undrawn = true;
	error = init_parts(reference);
	if (!error) {
		error = clip_cursor_init(
			&reference->cursor, reference->model, arena);
	}
	count = (size_t)reference->vertex_count;
	if (!error) {
		reference->position =
			arena_alloc(arena, count, sizeof(float[3]));
		reference->normal = arena_alloc(arena, count, sizeof(float[3]));
		error = reference->position && reference->normal ? 0 : -ENOMEM;
	}
	return error ? memory_budget_fail(reference->model->budget,
			       reference->model->path, log)
		     : 0;
}

int reference_create(const struct model *model, int clip, const struct log *log,
	struct reference **out)
{
	return reference_create_scaled(model, clip, 0.0f, log, out);
}

int reference_create_scaled(const struct model *model, int clip,
	float unit_scale, const struct log *log, struct reference **out)
{
	struct reference *reference;
	int error;

	if (!(model->clip[clip].duration_s > 0.0f)) {
		log_error(log,
			"%s: clip %d has no duration: choose a clip that moves",
			model->path, clip);
		return -EINVAL;
	}
	reference = calloc(1, sizeof(*reference));
	if (!reference) {
		log_error(log, "%s: there is not enough memory to compare it",
			model->path);
		return -ENOMEM;
	}
	reference->model = model;
	reference->clip = &model->clip[clip];
	reference->clip_index = clip;
	reference->arena = arena_within(model->budget);
	error = prepare(reference, unit_scale, log);
	if (error) {
		reference_destroy(reference);
		return error;
	}
	*out = reference;
	return 0;
}

void reference_destroy(struct reference *reference)
{
	if (reference) {
		instance_destroy(reference->instance);
		arena_release(&reference->arena);
		free(reference);
	}
}

static void take_pose(struct reference *reference, bool normals)
{
	struct instance *instance = reference->instance;

	instance->hold_normals = !normals;
	instance_update(instance);
	posed_vertices_positions(instance, reference->position);
	if (normals) {
		posed_vertices_normals(instance, reference->normal);
	}
}

void reference_pose(struct reference *reference, float time_s, bool normals)
{
	clip_pose(reference->clip, time_s, CLIP_AUTO, &reference->cursor,
		&reference->instance->pose);
	take_pose(reference, normals);
}

void reference_rest(struct reference *reference)
{
	pose_rest(&reference->instance->pose, reference->model);
	take_pose(reference, true);
}
