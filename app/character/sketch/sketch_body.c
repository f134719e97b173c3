#include "app/character/sketch/sketch_body.h"

#include "app/anim/math/quat.h"

static void add_point(struct sketch_body *body, const float at[3])
{
	bounds_add(&body->box, at);
	for (int i = 0; i < 3; i++) {
		float a = at[(i + 1) % 3], b = at[(i + 2) % 3];
		float reach = a * a + b * b;

		body->reach[i] = reach > body->reach[i] ? reach : body->reach[i];
	}
}

/* Adds a node's mesh, in the frame of its parent or, if own, in its own. */
static void add_mesh(
	const struct model *model, int node, bool own, struct sketch_body *body)
{
	const struct model_node *of = &model->node[node];
	const struct model_mesh *mesh = &model->mesh[of->mesh];

	for (int p = 0; p < mesh->primitive_count; p++) {
		const struct model_primitive *one = &mesh->primitive[p];

		for (int v = 0; v < one->vertex_count; v++) {
			float at[3];

			for (int i = 0; i < 3; i++) {
				at[i] = one->position[v][i] * of->rest.scale[i];
			}
			if (!own) {
				quat_rotate(of->rest.rotation, at, at);
				for (int i = 0; i < 3; i++) {
					at[i] += of->rest.translation[i];
				}
			}
			add_point(body, at);
		}
	}
}

static bool is_rigid(const struct model_node *node)
{
	return node->mesh >= 0 && node->skin < 0;
}

/* Adds what a node shows to its own body, or to that of the pivot above it. */
static void add_node(
	const struct model *model, int node, struct sketch_body *body)
{
	const struct model_node *of = &model->node[node];
	int parent = of->parent;

	if (!is_rigid(of)) {
		return;
	}
	add_mesh(model, node, true, &body[node]);
	if (parent >= 0 && !is_rigid(&model->node[parent]) && !of->matrix) {
		add_mesh(model, node, false, &body[parent]);
	}
}

void sketch_measure_bodies(const struct model *model, struct sketch_body *body)
{
	for (int i = 0; i < model->node_count; i++) {
		body[i] = (struct sketch_body){.box = bounds_empty()};
	}
	for (int i = 0; i < model->node_count; i++) {
		add_node(model, i, body);
	}
}

float sketch_side(const struct bounds *box, int axis)
{
	return box->high[axis] - box->low[axis];
}

float sketch_pivot(const struct bounds *box, int axis)
{
	return -box->low[axis] / sketch_side(box, axis);
}

bool sketch_is_pivot_within(const struct bounds *box, int axis, float part)
{
	float at = sketch_pivot(box, axis);

	return at >= part && at <= 1 - part;
}
