#include "app/scene/shadow/shadow_volume.h"

#include "platform/base/fixed.h"
#include "platform/base/scalar.h"

#include <cglm/cglm.h>

#include <errno.h>

int shadow_volume_init(struct shadow_volume *volume, struct instance *instance,
	const struct log *log)
{
	struct arena *arena = &instance->arena;

	*volume = (struct shadow_volume){0};
	volume->caster = ARENA_ARRAY(
		arena, struct shadow_caster, (size_t)instance->drawable_count);
	if (!volume->caster) {
		goto fail;
	}
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];

		if (drawable->primitive->vertex_count >
			SHADOW_CASTER_VERTICES_MAX) {
			log_warning(log,
				"%s: a part of %d vertices is too "
				"large to cast a shadow volume",
				instance->model->path,
				drawable->primitive->vertex_count);
			continue;
		}
		if (shadow_caster_init(&volume->caster[volume->caster_count++],
			    drawable, arena) != 0) {
			goto fail;
		}
	}
	return 0;
fail:
	log_error(log, "%s: not enough memory for its shadow",
		instance->model->path);
	return -ENOMEM;
}

/*
 * How far from a place the ground is, down the light. From level ground on by
 * the secant: waves are so low that one step leaves less than they sag.
 */
static float way_to_ground(const struct shadow_light *light, const float from[3])
{
	const struct floor *ground = light->ground;
	const float *towards = light->towards;
	float per_height = 1.0f / towards[1];
	float way[2] = {(from[1] - ground->y) * per_height, 0.0f};
	float height[2], slope;

	for (int i = 0; i < 2; i++) {
		height[i] = floor_height(ground, from[0] - towards[0] * way[i],
			from[2] - towards[2] * way[i]);
		if (i == 0) {
			way[1] = (from[1] - height[0]) * per_height;
		}
	}
	slope = way[1] == way[0] ? 0.0f
				 : (height[1] - height[0]) / (way[1] - way[0]);
	return way[1] -
		(height[1] - height[0]) /
		scalar_clamp(towards[1] + slope, 0.5f * towards[1], 2.0f);
}

/*
 * From where to where a vertex is carried: a little to both sides of it, if it
 * is within reach.
 */
static bool find_ways(const struct shadow_light *light, const float posed[3],
	float *near, float *far)
{
	float ground, slack;

	*near = 0.0f;
	*far = light->max_length;
	if (!light->ground || light->towards[1] <= 0.0f) {
		return false;
	}
	ground = way_to_ground(light, posed);
	slack = floor_mesh_error(light->ground) / light->towards[1];
	*far = scalar_clamp(ground + slack, 0.0f, light->max_length);
	*near = scalar_clamp(ground - slack, 0.0f, *far);
	return *far < light->max_length;
}

static void move(const float from[3], const float towards_light[3], float way,
	float out[3])
{
	for (int axis = 0; axis < 3; axis++) {
		out[axis] = from[axis] - towards_light[axis] * way;
	}
}

/* Posed vertices in scene units, where the hull begins and where it ends. */
static void place_vertices(struct shadow_caster *caster,
	const struct instance *instance, const struct shadow_light *light)
{
	const struct drawable *drawable = caster->drawable;
	int count = drawable->primitive->vertex_count;
	mat4 matrix = GLM_MAT4_IDENTITY_INIT;

	if (drawable->skin < 0) {
		instance_drawable_matrix(instance, drawable, matrix);
	}
	caster->too_short = false;
	for (int i = 0; i < caster->vertex_count; i++) {
		int v = caster->vertex[i];
		float p[3], posed[3], near_way, far_way;

		drawable_position(drawable, v, p);
		for (int axis = 0; axis < 3; axis++) {
			posed[axis] = matrix[0][axis] * p[0] +
				matrix[1][axis] * p[1] +
				matrix[2][axis] * p[2] + matrix[3][axis];
		}
		caster->too_short |=
			!find_ways(light, posed, &near_way, &far_way);
		move(posed, light->towards, near_way, caster->position[v]);
		move(posed, light->towards, far_way,
			caster->position[v + count]);
	}
}

static bool faces(const struct shadow_caster *caster, const uint16_t *corner,
	const float towards_light[3])
{
	const float *a = caster->position[corner[0]];
	const float *b = caster->position[corner[1]];
	const float *c = caster->position[corner[2]];
	vec3 u, v, normal;

	glm_vec3_sub((float *)b, (float *)a, u);
	glm_vec3_sub((float *)c, (float *)a, v);
	glm_vec3_cross(u, v, normal);
	return glm_vec3_dot(normal, (float *)towards_light) > 0.0f;
}

static uint16_t *add_triangle(uint16_t *next, uint32_t a, uint32_t b, uint32_t c)
{
	next[0] = (uint16_t)a;
	next[1] = (uint16_t)b;
	next[2] = (uint16_t)c;
	return next + 3;
}

/* The lit triangles close the hull near the light. */
static uint16_t *add_near(const struct shadow_caster *caster, uint16_t *next)
{
	for (int t = 0; t < caster->corner_count / 3; t++) {
		const uint16_t *corner = caster->corner + t * 3;

		if (caster->lit[t]) {
			next = add_triangle(
				next, corner[0], corner[1], corner[2]);
		}
	}
	return next;
}

/* Turned round, they close it far from the light. */
static uint16_t *add_far(const struct shadow_caster *caster, uint16_t *next)
{
	uint32_t away = (uint32_t)caster->drawable->primitive->vertex_count;

	for (int t = 0; t < caster->corner_count / 3; t++) {
		const uint16_t *corner = caster->corner + t * 3;

		if (caster->lit[t]) {
			next = add_triangle(next, corner[0] + away,
				corner[2] + away, corner[1] + away);
		}
	}
	return next;
}

/* A quad along every edge between a lit triangle and one that is not. */
static uint16_t *add_sides(const struct shadow_caster *caster, uint16_t *next)
{
	uint32_t away = (uint32_t)caster->drawable->primitive->vertex_count;

	for (int i = 0; i < caster->edge_count; i++) {
		const struct shadow_edge *edge = &caster->edge[i];
		bool left = caster->lit[edge->left];
		bool right = edge->right >= 0 && caster->lit[edge->right];
		uint32_t a = left ? edge->a : edge->b;
		uint32_t b = left ? edge->b : edge->a;

		if (left != right) {
			next = add_triangle(next, b, a, a + away);
			next = add_triangle(next, b, a + away, b + away);
		}
	}
	return next;
}

static float distance(const float plane[4], const float from[3])
{
	return glm_vec3_dot((float *)plane, (float *)from) + plane[3];
}

/* Of the near plane, and not ended by the light's reach. */
static bool is_beyond(
	const struct shadow_caster *caster, const struct shadow_light *light)
{
	const float *plane = light->near_plane;
	int away = caster->drawable->primitive->vertex_count;
	float least = 1.0f;

	for (int i = 0; i < caster->vertex_count; i++) {
		int v = caster->vertex[i];
		float near = distance(plane, caster->position[v]);
		float far = distance(plane, caster->position[v + away]);

		least = near < least ? near : least;
		least = far < least ? far : least;
	}
	return least > 0.0f && !caster->too_short;
}

void shadow_volume_update(struct shadow_volume *volume,
	const struct instance *instance, const struct shadow_light *light)
{
	volume->depth_pass = light->ground && light->towards[1] > 0.0f;
	for (int i = 0; i < volume->caster_count; i++) {
		struct shadow_caster *caster = &volume->caster[i];
		uint16_t *sides_end, *end;

		caster->index_count = 0;
		caster->back_cap_count = 0;
		if (caster->drawable->hidden) {
			continue;
		}
		place_vertices(caster, instance, light);
		for (int t = 0; t < caster->corner_count / 3; t++) {
			caster->lit[t] = faces(
				caster, caster->corner + t * 3, light->towards);
		}
		sides_end = add_sides(caster, add_near(caster, caster->index));
		end = add_far(caster, sides_end);
		caster->index_count = (int)(end - caster->index);
		caster->back_cap_count = (int)(end - sides_end);
		volume->depth_pass &= is_beyond(caster, light);
	}
}

/* Far ends lie behind the ground: nobody sees them who is outside. */
static void draw_hulls(const struct shadow_volume *volume, const struct gl *gl)
{
	for (int i = 0; i < volume->caster_count; i++) {
		const struct shadow_caster *caster = &volume->caster[i];
		int count = caster->index_count -
			(volume->depth_pass ? caster->back_cap_count : 0);

		gl->VertexPointer(3, GL_FLOAT, 0, caster->position);
		gl->DrawElements(
			GL_TRIANGLES, count, GL_UNSIGNED_SHORT, caster->index);
	}
}

/* A see-through sheet over the picture wherever the stencil is not 0. */
static void darken(const struct gl *gl, float strength)
{
	static const int16_t corner[4][2] = {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}};

	gl->MatrixMode(GL_PROJECTION);
	gl->PushMatrix();
	gl->LoadIdentity();
	gl->MatrixMode(GL_MODELVIEW);
	gl->PushMatrix();
	gl->LoadIdentity();
	gl->StencilFunc(GL_NOTEQUAL, 0, 255);
	gl->StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
	gl->Disable(GL_DEPTH_TEST);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	gl->Color4x(FX16_ONE / 16, FX16_ONE / 16, FX16_ONE / 12,
		fx16_from_float(strength));
	gl->VertexPointer(2, GL_SHORT, 0, corner);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
	gl->Disable(GL_BLEND);
	gl->Enable(GL_DEPTH_TEST);
	gl->MatrixMode(GL_PROJECTION);
	gl->PopMatrix();
	gl->MatrixMode(GL_MODELVIEW);
	gl->PopMatrix();
}

/*
 * How many hulls' surfaces lie between the eye and the ground: front faces up,
 * back faces down. An eye inside of one misses its front; then it is counted
 * where the ground hides the caster, back faces up and front faces down. What
 * counts up goes first because GL ES 1.1's stencil does not wrap.
 */
static void count_hulls(const struct shadow_volume *volume, const struct gl *gl)
{
	bool seen = volume->depth_pass;

	gl->CullFace(seen ? GL_BACK : GL_FRONT);
	gl->StencilOp(
		GL_KEEP, seen ? GL_KEEP : GL_INCR, seen ? GL_INCR : GL_KEEP);
	draw_hulls(volume, gl);
	gl->CullFace(seen ? GL_FRONT : GL_BACK);
	gl->StencilOp(
		GL_KEEP, seen ? GL_KEEP : GL_DECR, seen ? GL_DECR : GL_KEEP);
	draw_hulls(volume, gl);
	gl->CullFace(GL_BACK);
}

void shadow_volume_draw(
	const struct shadow_volume *volume, const struct gl *gl, float strength)
{
	gl->Disable(GL_LIGHTING);
	gl->Disable(GL_TEXTURE_2D);
	gl->Disable(GL_BLEND);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->DisableClientState(GL_COLOR_ARRAY);
	gl->DisableClientState(GL_NORMAL_ARRAY);
	gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->Enable(GL_STENCIL_TEST);
	gl->StencilFunc(GL_ALWAYS, 0, 255);
	gl->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
	gl->DepthMask(GL_FALSE);
	gl->Enable(GL_CULL_FACE);
	count_hulls(volume, gl);
	gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
	gl->Disable(GL_CULL_FACE);
	darken(gl, strength);
	gl->DepthMask(GL_TRUE);
	gl->Disable(GL_STENCIL_TEST);
}
