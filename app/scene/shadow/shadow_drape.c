#include "app/scene/shadow/shadow_drape.h"

#include "app/anim/math/vec.h"
#include "app/scene/draw/draw.h"
#include "app/scene/draw/triangle_list.h"
#include "app/scene/instance/bounds.h"
#include "platform/base/fixed.h"
#include "platform/base/scalar.h"

#include <cglm/cglm.h>

#include <errno.h>

enum {
	EDGES_ALONG = 4, /* undivided edges along the figure's longest side */
	DIVIDED_MAX = 2048, /* vertices that divisions may add to a sheet */
	VERTICES_MAX = 65536,
};

#define UNUSED 0xFFFFFFFFu

static int vertices_of(const struct batch *batch, const struct batch_lod *lod)
{
	return lod && batch->source ? lod->vertex_count : batch->vertex_count;
}

/* Returns the number of vertices of the list that may be drawn with the most. */
static int count_vertices(const struct batch *batch)
{
	int most = batch->vertex_count;

	for (int i = 0; i < batch->lod_count; i++) {
		int count = vertices_of(batch, &batch->lod[i]);

		most = count > most ? count : most;
	}
	for (int i = 0; i < batch->shadow_count; i++) {
		int count = vertices_of(batch, &batch->shadow[i]);

		most = count > most ? count : most;
	}
	return most;
}

/* Returns the number of corners of the longest list that may be drawn. */
static int count_corners(const struct batch *batch)
{
	int most = batch->index ? batch->index_count : batch->vertex_count;

	for (int i = 0; i < batch->lod_count; i++) {
		int count = batch->lod[i].index_count;

		most = count > most ? count : most;
	}
	for (int i = 0; i < batch->shadow_count; i++) {
		int count = batch->shadow[i].index_count;

		most = count > most ? count : most;
	}
	return most;
}

static int allocate(
	struct shadow_drape *drape, struct arena *arena, int place_count)
{
	size_t vertices = (size_t)drape->vertex_max;

	drape->place = ARENA_ARRAY(arena, uint32_t, (size_t)place_count);
	drape->posed = arena_alloc(arena, vertices, sizeof(float[3]));
	drape->position = arena_alloc(arena, vertices, sizeof(float[3]));
	drape->index = ARENA_ARRAY(arena, uint16_t, (size_t)drape->index_max);
	drape->grid.node =
		arena_alloc(arena, SHADOW_NODES_MAX, sizeof(float[3]));
	return drape->place && drape->posed && drape->position &&
			drape->index && drape->grid.node
		? 0
		: -ENOMEM;
}

static void make_cloth_sheets(struct shadow_drape *drape,
	const struct shadow_cloth *cloth, int cloth_count)
{
	for (int i = 0; i < cloth_count; i++) {
		drape->sheet[drape->sheet_count++] = (struct shadow_sheet){
			.cloth = &cloth[i], .two_sided = true};
		drape->vertex_max += cloth[i].vertex_count;
		drape->index_max += cloth[i].index_count;
	}
}

/*
 * The sheets of what is blended come last: opaque shadows hide theirs. Returns
 * the number of vertices of the largest batch.
 */
static int make_sheets(struct shadow_drape *drape, struct instance *instance)
{
	int largest = 1, drawables = instance->drawable_count;

	for (int i = 0; i < 2 * drawables; i++) {
		const struct drawable *drawable =
			&instance->drawable[i % drawables];

		const struct model_material *material =
			&instance->model->material[drawable->primitive->material];

		if ((drawable->alpha == MODEL_BLEND) != (i >= drawables)) {
			continue;
		}
		for (int k = 0; k < drawable->batch_count; k++) {
			const struct batch *batch = &drawable->batch[k];
			int count = count_vertices(batch);

			drape->sheet[drape->sheet_count++] =
				(struct shadow_sheet){.drawable = drawable,
					.batch = batch,
					.two_sided = material->double_sided};
			largest = count > largest ? count : largest;
			drape->vertex_max += count;
			drape->index_max += count_corners(batch);
		}
	}
	return largest;
}

int shadow_drape_init(struct shadow_drape *drape, struct instance *instance,
	const struct shadow_cloth *cloth, int cloth_count, const struct log *log)
{
	struct bounds bounds = bounds_of_instance(instance);
	int count = cloth_count, error = -ENOMEM;

	for (int i = 0; i < instance->drawable_count; i++) {
		count += instance->drawable[i].batch_count;
	}
	*drape = (struct shadow_drape){
		.longest = bounds_extent(&bounds) / EDGES_ALONG,
		.sheet = ARENA_ARRAY(&instance->arena, struct shadow_sheet,
			(size_t)count + 1),
		/* Each division adds one vertex and one triangle. */
		.vertex_max = DIVIDED_MAX,
		.index_max = 3 * DIVIDED_MAX,
	};
	if (drape->sheet) {
		make_cloth_sheets(drape, cloth, cloth_count);
		error = allocate(
			drape, &instance->arena, make_sheets(drape, instance));
	}
	return error ? memory_budget_fail(instance->arena.budget,
			       instance->model->path, log)
		     : 0;
}

int shadow_drape_init_on(struct shadow_drape *drape, struct instance *instance,
	const struct shadow_cloth *cloth, int cloth_count,
	const struct shadow_relief *relief, const struct log *log)
{
	float longest = 4.0f * relief->cell[0];
	int error = shadow_drape_init(drape, instance, cloth, cloth_count, log);

	if (!error && longest < drape->longest) {
		drape->longest = longest;
	}
	return error;
}

static void find_posed(const struct shadow_sheet *sheet, const vec4 *matrix,
	int vertex, float out[3])
{
	float p[3];

	drawable_batch_position(sheet->drawable, sheet->batch, vertex, p);
	for (int axis = 0; axis < 3; axis++) {
		out[axis] = matrix[0][axis] * p[0] + matrix[1][axis] * p[1] +
			matrix[2][axis] * p[2] + matrix[3][axis];
	}
}

static float find_square(const float a[3], const float b[3])
{
	float edge[3];

	vec_subtract(a, b, edge);
	return vec_dot(edge, edge);
}

/*
 * Adds a triangle to the sheet's list. If an edge is too long, it divides the
 * triangle at the middle of its longest edge and goes on with both halves.
 * Triangles on both sides of an edge divide it at the same point.
 */
static void add_triangle(struct shadow_drape *drape, struct shadow_sheet *sheet,
	uint32_t a, uint32_t b, uint32_t c)
{
	float(*posed)[3] = sheet->posed;
	float ab = find_square(posed[a], posed[b]);
	float bc = find_square(posed[b], posed[c]);
	float ca = find_square(posed[c], posed[a]);
	float square = drape->longest * drape->longest;
	uint32_t middle = (uint32_t)sheet->vertex_count;

	if (!(ab > square || bc > square || ca > square) ||
		drape->divisions_left == 0 || middle >= VERTICES_MAX) {
		triangle_list_add(sheet->index + sheet->index_count, a, b, c);
		sheet->index_count += 3;
	} else if (bc > ab && bc >= ca) {
		add_triangle(drape, sheet, b, c, a);
	} else if (ca > ab) {
		add_triangle(drape, sheet, c, a, b);
	} else {
		drape->divisions_left--;
		sheet->vertex_count++;
		vec_mix(posed[a], posed[b], 0.5f, posed[middle]);
		add_triangle(drape, sheet, a, middle, c);
		add_triangle(drape, sheet, middle, b, c);
	}
}

/*
 * Returns the place of a batch's vertex in the sheet. A vertex that is met for
 * the first time gets the next place and is posed. first is the vertex that a
 * list's index 0 stands for.
 */
static uint32_t find_place(uint32_t *place, struct shadow_sheet *sheet,
	const vec4 *matrix, int first, uint32_t vertex)
{
	if (place[vertex] == UNUSED) {
		place[vertex] = (uint32_t)sheet->vertex_count++;
		find_posed(sheet, matrix, first + (int)vertex,
			sheet->posed[place[vertex]]);
	}
	return place[vertex];
}

static void list_triangles(struct shadow_drape *drape,
	struct shadow_sheet *sheet, const vec4 *matrix)
{
	const struct batch *batch = sheet->batch;
	const struct batch_lod *lod = drawable_shadow(sheet->drawable, batch);
	const uint16_t *index = lod ? lod->index : batch->index;
	int count = lod ? lod->index_count
		: index ? batch->index_count
			: batch->vertex_count;
	/*
	 * The corners are kept at the array's end, so that they are read before
	 * the triangles overwrite them.
	 */
	uint16_t *listed = drape->index + drape->index_max - count;

	memset(drape->place, 0xFF,
		(size_t)vertices_of(batch, lod) * sizeof(*drape->place));
	for (int i = 0; i < count; i++) {
		listed[i] = (uint16_t)find_place(drape->place, sheet, matrix,
			lod ? lod->first_vertex : 0,
			index ? index[i] : (uint32_t)i);
	}
	for (int i = 0; i + 2 < count; i += 3) {
		add_triangle(
			drape, sheet, listed[i], listed[i + 1], listed[i + 2]);
	}
}

static void list_cloth(struct shadow_drape *drape, struct shadow_sheet *sheet)
{
	const struct shadow_cloth *cloth = sheet->cloth;
	const uint16_t *index = cloth->index;

	sheet->vertex_count = cloth->vertex_count;
	for (int v = 0; v < cloth->vertex_count; v++) {
		for (int axis = 0; axis < 3; axis++) {
			sheet->posed[v][axis] =
				cloth->position[v][axis] * cloth->scale;
		}
	}
	for (int i = 0; i + 2 < cloth->index_count; i += 3) {
		add_triangle(drape, sheet, index[i], index[i + 1], index[i + 2]);
	}
}

static bool casts_shadow(const struct shadow_sheet *sheet)
{
	return sheet->cloth
		? !sheet->cloth->hidden
		: !sheet->drawable->hidden && !sheet->drawable->unseen;
}

static void pose_sheet(struct shadow_drape *drape, struct shadow_sheet *sheet,
	const struct instance *instance)
{
	const struct drawable *drawable = sheet->drawable;
	mat4 matrix = GLM_MAT4_IDENTITY_INIT;

	if (sheet->cloth) {
		list_cloth(drape, sheet);
		return;
	}
	if (drawable->skin < 0) {
		instance_drawable_matrix(instance, drawable, matrix);
	}
	list_triangles(drape, sheet, (const vec4 *)matrix);
}

void shadow_drape_update(struct shadow_drape *drape,
	const struct instance *instance, const struct shadow_light *light)
{
	int vertices = 0, indices = 0;

	drape->divisions_left = DIVIDED_MAX;
	drape->box = bounds_empty();
	for (int i = 0; i < drape->sheet_count; i++) {
		struct shadow_sheet *sheet = &drape->sheet[i];

		sheet->vertex_count = sheet->index_count = 0;
		sheet->posed = drape->posed + vertices;
		sheet->position = drape->position + vertices;
		sheet->index = drape->index + indices;
		if (casts_shadow(sheet) && light->towards[1] > 0.0f) {
			pose_sheet(drape, sheet, instance);
		}
		vertices += sheet->vertex_count;
		indices += sheet->index_count;
	}
	shadow_lay(&drape->grid, light, (const float(*)[3])drape->posed,
		vertices, drape->position, &drape->box);
}

/*
 * Blends a dark colour over the ground where the stencil is mark, and counts
 * there: a pixel that many triangles cover is darkened by the first one.
 */
static void begin_darkening(const struct gl *gl, int mark)
{
	gl->Enable(GL_STENCIL_TEST);
	gl->StencilFunc(GL_EQUAL, mark, 255);
	gl->StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	gl->DepthMask(GL_FALSE);
	gl->Enable(GL_CULL_FACE);
}

static void end_darkening(const struct gl *gl)
{
	gl->Disable(GL_CULL_FACE);
	gl->DepthMask(GL_TRUE);
	gl->Disable(GL_BLEND);
	gl->Disable(GL_STENCIL_TEST);
}

/* The front faces of a body cast all of its shadow, but not those of a sheet. */
static void draw_sheet(
	const struct shadow_sheet *sheet, const struct gl *gl, float strength)
{
	if (sheet->drawable && sheet->drawable->alpha == MODEL_BLEND) {
		draw_set_shadow_color(
			gl, strength * sheet->drawable->mean_alpha);
	}
	if (sheet->index_count == 0) {
		return;
	}
	if (sheet->two_sided) {
		gl->Disable(GL_CULL_FACE);
	}
	gl->VertexPointer(3, GL_FLOAT, 0, sheet->position);
	gl->DrawElements(GL_TRIANGLES, sheet->index_count, GL_UNSIGNED_SHORT,
		sheet->index);
	if (sheet->two_sided) {
		gl->Enable(GL_CULL_FACE);
	}
}

void shadow_drape_draw(const struct shadow_drape *drape, const struct gl *gl,
	float strength, int mark, bool may_be_hidden)
{
	gl->Disable(GL_LIGHTING);
	gl->Disable(GL_TEXTURE_2D);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->DisableClientState(GL_COLOR_ARRAY);
	gl->DisableClientState(GL_NORMAL_ARRAY);
	gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
	if (!may_be_hidden) {
		gl->Disable(GL_DEPTH_TEST);
	}
	begin_darkening(gl, mark);
	draw_set_shadow_color(gl, strength);
	for (int i = 0; i < drape->sheet_count; i++) {
		draw_sheet(&drape->sheet[i], gl, strength);
	}
	end_darkening(gl);
	gl->Enable(GL_DEPTH_TEST);
}
