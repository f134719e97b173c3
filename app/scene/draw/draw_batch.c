#include "app/scene/draw/draw_batch.h"

#include "app/scene/draw/edge_list.h"

static void enable_array(const struct gl *gl, GLenum array, const void *data)
{
	if (data) {
		gl->EnableClientState(array);
	} else {
		gl->DisableClientState(array);
	}
}

/* first is the vertex that index 0 stands for. */
static void set_vertices(const struct gl *gl, const struct batch *batch,
	int first, bool with_normals)
{
	const struct fixed_vector *position = batch->fixed_position;
	const struct fixed_vector *normal = batch->fixed_normal;
	const GLsizei stride = sizeof(*position);

	enable_array(gl, GL_NORMAL_ARRAY, with_normals ? batch : NULL);
	if (position) {
		gl->VertexPointer(3, GL_SHORT, stride, &position[first].x);
	} else {
		gl->VertexPointer(3, GL_FLOAT, 0, batch->position + first);
	}
	if (with_normals && position) {
		gl->NormalPointer(GL_SHORT, stride, &normal[first].x);
	} else if (with_normals) {
		gl->NormalPointer(GL_FLOAT, 0, batch->normal + first);
	}
}

/* index is NULL where each three vertices are a triangle. */
static void draw_list(
	const struct gl *gl, const uint16_t *index, int count, bool edges)
{
	if (edges) {
		edge_list_draw(gl, index, count);
	} else if (index) {
		gl->DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_SHORT, index);
	} else {
		gl->DrawArrays(GL_TRIANGLES, 0, count);
	}
}

static void set_texcoords(const struct gl *gl, const void *texcoord)
{
	enable_array(gl, GL_TEXTURE_COORD_ARRAY, texcoord);
	if (texcoord) {
		gl->TexCoordPointer(2, GL_FLOAT, 0, texcoord);
	}
}

void draw_batch(const struct gl *gl, const struct batch *batch,
	const struct draw_arrays *arrays)
{
	int first = arrays->list ? arrays->list->first_vertex : 0;
	const void *texcoord =
		arrays->texcoord ? arrays->texcoord + first : NULL;
	const void *color = arrays->color ? arrays->color + first : NULL;

	if (arrays->list && arrays->list->index_count == 0) {
		return;
	}
	gl->EnableClientState(GL_VERTEX_ARRAY);
	set_vertices(gl, batch, first, arrays->lit);
	set_texcoords(gl, texcoord);
	if (arrays->both_units) {
		gl->ClientActiveTexture(GL_TEXTURE1);
		set_texcoords(gl, texcoord);
		gl->ClientActiveTexture(GL_TEXTURE0);
	}
	enable_array(gl, GL_COLOR_ARRAY, color);
	if (color) {
		gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, color);
	}
	if (arrays->list) {
		draw_list(gl, arrays->list->index, arrays->list->index_count,
			arrays->edges);
	} else {
		draw_list(gl, batch->index,
			batch->index ? batch->index_count : batch->vertex_count,
			arrays->edges);
	}
}
