#include "app/compare/reference.h"

#include "platform/base/count.h"
#include "platform/base/scalar.h"

#include <cglm/cglm.h>

#include <errno.h>
#include <stdlib.h>

enum {
	FRAMES_MAX = 1000000
};

/* Normals are transformed by the cofactors of the node's matrix. */
static void transform_normal(
	const vec4 *world, const float normal[3], float out[3])
{
	vec3 a, b, c;

	glm_vec3_cross((float *)world[1], (float *)world[2], a);
	glm_vec3_cross((float *)world[2], (float *)world[0], b);
	glm_vec3_cross((float *)world[0], (float *)world[1], c);
	for (int axis = 0; axis < 3; axis++) {
		out[axis] = a[axis] * normal[0] + b[axis] * normal[1] +
			c[axis] * normal[2];
	}
	glm_vec3_normalize(out);
}

static void take_part(const struct reference *reference,
	const struct reference_part *part, float (*position)[3],
	float (*normal)[3])
{
	const struct instance *instance = reference->instance;
	const struct drawable *drawable = &instance->drawable[part->drawable];
	const vec4 *world = instance->world[drawable->node];

	for (int v = 0; v < part->vertex_count; v++) {
		instance_world_vertex(instance, drawable, v, position[v]);
		if (!part->normals) {
			continue;
		}
		if (drawable->skin >= 0) {
			glm_vec3_copy(drawable->normal[v], normal[v]);
		} else {
			transform_normal(world, drawable->normal[v], normal[v]);
		}
	}
}

static void take_frame(struct reference *reference, int frame)
{
	size_t at = (size_t)frame * (size_t)reference->vertex_count;

	pose_rest(&reference->instance->pose, reference->model);
	clip_sample(reference->clip, reference->time_s[frame],
		&reference->cursor, &reference->instance->pose);
	instance_update(reference->instance);
	for (int i = 0; i < reference->part_count; i++) {
		const struct reference_part *part = &reference->part[i];
		size_t first = at + (size_t)part->first_vertex;

		take_part(reference, part, reference->position + first,
			reference->normal + first);
	}
}

static int init_parts(struct reference *reference)
{
	const struct instance *instance = reference->instance;

	reference->part_count = instance->drawable_count;
	reference->part = ARENA_ARRAY(&reference->arena, struct reference_part,
		(size_t)instance->drawable_count);
	if (!reference->part) {
		return -ENOMEM;
	}
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];

		reference->part[i] = (struct reference_part){
			.drawable = i,
			.first_vertex = reference->vertex_count,
			.vertex_count = drawable->primitive->vertex_count,
			.normals = drawable->normal != NULL,
		};
		if (!count_add(reference->vertex_count,
			    drawable->primitive->vertex_count,
			    &reference->vertex_count)) {
			return -E2BIG;
		}
	}
	return 0;
}

static int init_times(struct reference *reference)
{
	double duration_s = (double)reference->clip->duration_s;
	double frames = duration_s * reference->rate_hz - 1e-6;
	int whole;

	if (frames > FRAMES_MAX) {
		return -E2BIG;
	}
	whole = (int)frames + 1;
	reference->frame_count = whole + 1;
	reference->time_s = ARENA_ARRAY(
		&reference->arena, float, (size_t)reference->frame_count);
	if (!reference->time_s) {
		return -ENOMEM;
	}
	for (int i = 0; i < whole; i++) {
		reference->time_s[i] = (float)(i / reference->rate_hz);
	}
	reference->time_s[whole] = reference->clip->duration_s;
	return 0;
}

static int init_frames(struct reference *reference)
{
	size_t count;

	if (!size_multiply((size_t)reference->frame_count,
		    (size_t)reference->vertex_count, &count)) {
		return -E2BIG;
	}
	reference->position =
		arena_alloc(&reference->arena, count, sizeof(float[3]));
	reference->normal =
		arena_alloc(&reference->arena, count, sizeof(float[3]));
	return reference->position && reference->normal ? 0 : -E2BIG;
}

static int init_arrays(struct reference *reference)
{
	int error = init_parts(reference);

	if (!error) {
		error = init_times(reference);
	}
	if (!error) {
		error = clip_cursor_init(&reference->cursor, reference->model,
			&reference->arena);
	}
	return error ? error : init_frames(reference);
}

static int prepare(struct reference *reference, const struct log *log)
{
	int error = instance_create(reference->model, kernel_find("float"), log,
		&reference->instance);

	if (error) {
		return error;
	}
	reference->instance->normal_mapping = false;
	error = init_arrays(reference);
	if (error == -E2BIG) {
		log_error(log,
			"%s: the frames of clip %d need too much memory: give a lower --fps, or allow more with --memory",
			reference->model->path, reference->clip_index);
	} else if (error) {
		error = memory_budget_fail(
			reference->model->budget, reference->model->path, log);
	}
	return error;
}

int reference_create(const struct model *model, int clip, double rate_hz,
	const struct log *log, struct reference **out)
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
		log_error(log, "%s: there is not enough memory for its frames",
			model->path);
		return -ENOMEM;
	}
	reference->model = model;
	reference->clip = &model->clip[clip];
	reference->clip_index = clip;
	reference->rate_hz = rate_hz;
	reference->arena = arena_within(model->budget);
	error = prepare(reference, log);
	if (error) {
		reference_destroy(reference);
		return error;
	}
	for (int i = 0; i < reference->frame_count; i++) {
		take_frame(reference, i);
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

const float (
	*reference_position(const struct reference *reference, int frame))[3]
{
	return (const float(*)[3])reference->position +
		(size_t)frame * (size_t)reference->vertex_count;
}

const float (*reference_normal(const struct reference *reference, int frame))[3]
{
	return (const float(*)[3])reference->normal +
		(size_t)frame * (size_t)reference->vertex_count;
}

int reference_frame_at(const struct reference *reference, float time_s)
{
	int low = 0, high = reference->frame_count - 1;

	while (low < high) {
		int middle = (low + high + 1) / 2;

		if (reference->time_s[middle] <= time_s) {
			low = middle;
		} else {
			high = middle - 1;
		}
	}
	return low;
}
