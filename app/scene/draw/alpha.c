#include "app/scene/draw/alpha.h"

#include "app/anim/math/matrix.h"
#include "app/anim/math/vec.h"
#include "app/scene/instance/instance.h"

/* Vertices of a skin whose mean is taken for its middle. */
enum {
	VERTICES = 8
};

void alpha_list_blended(struct instance *instance)
{
	instance->blended_count = 0;
	for (int i = 0; i < instance->drawable_count; i++) {
		if (instance->drawable[i].alpha == MODEL_BLEND) {
			instance->blended[instance->blended_count++] =
				(struct blended_drawable){.drawable = i};
		}
	}
}

/* Of the coarsest list: each update poses its vertices. */
static void find_skin_middle(const struct drawable *drawable, float out[3])
{
	const struct batch *batch = drawable->batch;
	const uint16_t *index;
	int count, first = 0;

	out[0] = out[1] = out[2] = 0.0f;
	if (drawable->batch_count == 0) {
		return;
	}
	index = batch->index;
	count = index ? batch->index_count : batch->vertex_count;
	if (batch->lod_count > 0) {
		index = batch->lod[batch->lod_count - 1].index;
		count = batch->lod[batch->lod_count - 1].index_count;
		first = batch->lod[batch->lod_count - 1].first_vertex;
	}
	for (int i = 0; count > 0 && i < VERTICES; i++) {
		int at = (int)((int64_t)count * i / VERTICES);
		float position[3];

		int vertex = first + (index ? index[at] : at);

		if (batch->source) {
			drawable_position(
				drawable, (int)batch->source[vertex], position);
		} else {
			drawable_batch_position(
				drawable, batch, vertex, position);
		}
		vec_add_scaled(out, position, 1.0f / VERTICES, out);
	}
}

static void find_middle(const struct instance *instance,
	const struct drawable *drawable, float out[3])
{
	mat4 matrix;
	float local[3];

	if (drawable->skin >= 0) {
		find_skin_middle(drawable, out);
		return;
	}
	instance_drawable_matrix(instance, drawable, matrix);
	for (int axis = 0; axis < 3; axis++) {
		local[axis] =
			drawable->box_middle[axis] * drawable->vertex_scale;
	}
	matrix_apply(matrix, local, out);
}

static bool is_before(
	const struct blended_drawable *a, const struct blended_drawable *b)
{
	return a->distance_squared > b->distance_squared ||
		(a->distance_squared == b->distance_squared &&
			a->drawable < b->drawable);
}

/* Shell's sort: it needs no memory, and little time for what is nearly sorted. */
static void sort(struct blended_drawable *list, int count)
{
	for (int gap = count; gap > 1;) {
		gap = gap > 2 ? (int)((int64_t)gap * 5 / 11) : 1;
		for (int i = gap; i < count; i++) {
			struct blended_drawable moved = list[i];
			int to = i;

			for (; to >= gap && is_before(&moved, &list[to - gap]);
				to -= gap) {
				list[to] = list[to - gap];
			}
			list[to] = moved;
		}
	}
}

void alpha_sort_blended(struct instance *instance, const float eye[3])
{
	if (instance->blended_count < 2) {
		return;
	}
	for (int i = 0; i < instance->blended_count; i++) {
		struct blended_drawable *blended = &instance->blended[i];
		float middle[3];

		find_middle(instance, &instance->drawable[blended->drawable],
			middle);
		vec_subtract(middle, eye, middle);
		blended->distance_squared = vec_dot(middle, middle);
	}
	sort(instance->blended, instance->blended_count);
}
