#include "app/demo/duel/duel_rigid.h"

#include <errno.h>
#include <string.h>

static const struct model_primitive *primitive_of(
	const struct rigid_bake *rigid, const struct rigid_part *part)
{
	const struct reference *reference = rigid->reference;
	int drawable = reference->part[part->part].drawable;

	return reference->instance->drawable[drawable].primitive;
}

/* The index that vertex v of the part has in the reference's primitive. */
static int vertex_of(
	const struct rigid_bake *rigid, const struct rigid_part *part, int v)
{
	return rigid->source[part->first_vertex + v] -
		rigid->reference->part[part->part].first_vertex;
}

/* Copies texture coordinates and colours. */
static int copy_attributes(struct model_primitive *to,
	const struct rigid_bake *rigid, const struct rigid_part *part,
	struct arena *arena)
{
	const struct model_primitive *from = primitive_of(rigid, part);
	size_t count = (size_t)part->vertex_count;

	if (from->texcoord) {
		to->texcoord = arena_alloc(arena, count, sizeof(float[2]));
	}
	if (from->color) {
		to->color = arena_alloc(arena, count, 4);
	}
	if ((from->texcoord && !to->texcoord) || (from->color && !to->color)) {
		return -ENOMEM;
	}
	for (int v = 0; v < part->vertex_count; v++) {
		int vertex = vertex_of(rigid, part, v);

		if (from->texcoord) {
			memcpy(to->texcoord[v], from->texcoord[vertex],
				sizeof(float[2]));
		}
		if (from->color) {
			memcpy(to->color[v], from->color[vertex], 4);
		}
	}
	return 0;
}

static int fill_primitive(struct model_primitive *primitive,
	const struct rigid_bake *rigid, int part_index, struct arena *arena)
{
	const struct rigid_part *part = &rigid->part[part_index];
	bool normals = rigid->reference->part[part->part].normals;

	*primitive = (struct model_primitive){
		.file_index = part_index,
		.material = primitive_of(rigid, part)->material,
		.vertex_count = part->vertex_count,
		.position = rigid->position + part->first_vertex,
		.normal = normals ? rigid->normal + part->first_vertex : NULL,
		.index_count = part->index_count,
		.index = rigid->index + part->first_index,
	};
	return copy_attributes(primitive, rigid, part, arena);
}

/* Makes a mesh of the node's parts; *next is the end of shown->part. */
static int fill_node(struct duel_rigid *shown, int node, int *next,
	struct model_primitive *primitive, struct arena *arena)
{
	const struct rigid_bake *rigid = shown->rigid;
	struct model *model = &shown->model;
	struct model_mesh *mesh = &model->mesh[model->mesh_count];
	int first = *next;

	shown->first[node] = first;
	for (int i = 0; i < rigid->part_count; i++) {
		if (rigid->part[i].node == node) {
			int error = fill_primitive(
				&primitive[*next], rigid, i, arena);

			if (error) {
				return error;
			}
			shown->part[(*next)++] = i;
		}
	}
	model->node[node].mesh = -1;
	model->node[node].skin = -1;
	if (*next > first) {
		*mesh = (struct model_mesh){
			.name = "",
			.primitive_count = *next - first,
			.primitive = primitive + first,
		};
		model->node[node].mesh = model->mesh_count++;
		model->node[node].in_scene = true;
	}
	return 0;
}

int duel_rigid_init(struct duel_rigid *shown, const struct rigid_bake *rigid,
	struct arena *arena)
{
	const struct model *from = rigid->reference->model;
	size_t nodes = (size_t)from->node_count;
	size_t parts = (size_t)rigid->part_count;
	struct model_primitive *primitive;
	int next = 0, error = 0;

	*shown = (struct duel_rigid){.model = *from, .rigid = rigid};
	shown->model.node = ARENA_ARRAY(arena, struct model_node, nodes);
	shown->model.mesh = ARENA_ARRAY(arena, struct model_mesh, nodes);
	shown->first = ARENA_ARRAY(arena, int, nodes);
	shown->part = ARENA_ARRAY(arena, int, parts);
	primitive = ARENA_ARRAY(arena, struct model_primitive, parts);
	if (!shown->model.node || !shown->model.mesh || !shown->first ||
		!shown->part || !primitive) {
		return -ENOMEM;
	}
	memcpy(shown->model.node, from->node, nodes * sizeof(*from->node));
	shown->model.mesh_count = 0;
	shown->model.skin_count = 0;
	for (int i = 0; i < from->node_count && !error; i++) {
		error = fill_node(shown, i, &next, primitive, arena);
	}
	return error;
}

int duel_rigid_source(const struct duel_rigid *shown,
	const struct drawable *drawable, int vertex)
{
	int index = shown->first[drawable->node] + drawable->primitive_index;
	const struct rigid_part *part = &shown->rigid->part[shown->part[index]];

	return shown->rigid->source[part->first_vertex + vertex];
}
