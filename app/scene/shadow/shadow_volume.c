#include "app/scene/shadow/shadow_volume.h"

#include "app/scene/draw/triangle_list.h"
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
				"%s: a part of the model has %d vertices, too many to cast a shadow on uneven ground",
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
	log_error(log, "%s: there is not enough memory for the model's shadow",
		instance->model->path);
	return -ENOMEM;
}

/*
 * The distance from a point to the ground, down the light's direction. One step
 * of the secant method from level ground leaves less than floor_mesh_error().
 */
static float distance_to_ground(
	const struct shadow_light *light, const float from[3])
{
	const struct floor *ground = light->ground;
	const float *towards = light->towards;
	float per_height = 1.0f / towards[1];
	float guess[2] = {(from[1] - ground->y) * per_height, 0.0f};
	float height[2], slope;

	for (int i = 0; i < 2; i++) {
		height[i] = floor_height(ground, from[0] - towards[0] * guess[i],
			from[2] - towards[2] * guess[i]);
		if (i == 0) {
			guess[1] = (from[1] - height[0]) * per_height;
		}
	}
	slope = guess[1] == guess[0]
		? 0.0f
		: (height[1] - height[0]) / (guess[1] - guess[0]);
	return guess[1] -
		(height[1] - height[0]) /
		scalar_clamp(towards[1] + slope, 0.5f * towards[1], 2.0f);
}

/*
 * Finds how far down the light a vertex's volume begins and ends: a little
 * above and below the ground. Returns false if it ends before the ground.
 */
static bool find_extent(const struct shadow_light *light, const float posed[3],
	float *near, float *far)
{
	float ground, slack;

	*near = 0.0f;
	*far = light->max_length;
	if (!light->ground || light->towards[1] <= 0.0f) {
		return false;
	}
	ground = distance_to_ground(light, posed);
	slack = floor_mesh_error(light->ground,
			posed[0] - light->towards[0] * ground,
			posed[2] - light->towards[2] * ground) /
		light->towards[1];
	*far = scalar_clamp(ground + slack, 0.0f, light->max_length);
	*near = scalar_clamp(ground - slack, 0.0f, *far);
	return *far < light->max_length;
}

static void move(const float from[3], const float towards_light[3],
	float length, float out[3])
{
	for (int axis = 0; axis < 3; axis++) {
		out[axis] = from[axis] - towards_light[axis] * length;
	}
}

/* Moves posed vertices to where the volume begins and to where it ends. */
static void move_vertices(struct shadow_caster *caster,
	const struct instance *instance, const struct shadow_light *light)
{
	const struct drawable *drawable = caster->drawable;
	int count = caster->vertex_count;
	mat4 matrix = GLM_MAT4_IDENTITY_INIT;

	if (drawable->skin < 0) {
		instance_drawable_matrix(instance, drawable, matrix);
	}
	caster->too_short = false;
	for (int i = 0; i < caster->vertex_count; i++) {
		float p[3], posed[3], near, far;

		drawable_position(drawable, caster->vertex[i], p);
		for (int axis = 0; axis < 3; axis++) {
			posed[axis] = matrix[0][axis] * p[0] +
				matrix[1][axis] * p[1] +
				matrix[2][axis] * p[2] + matrix[3][axis];
		}
		caster->too_short |= !find_extent(light, posed, &near, &far);
		move(posed, light->towards, near, caster->position[i]);
		move(posed, light->towards, far, caster->position[i + count]);
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

/* Lit triangles close the volume at its beginning. */
static uint16_t *add_front_cap(
	const struct shadow_caster *caster, uint16_t *next)
{
	for (int t = 0; t < caster->corner_count / 3; t++) {
		const uint16_t *corner = caster->corner + t * 3;

		if (caster->lit[t]) {
			next = triangle_list_add(
				next, corner[0], corner[1], corner[2]);
		}
	}
	return next;
}

/* The same triangles, reversed, close it at its end. */
static uint16_t *add_back_cap(const struct shadow_caster *caster, uint16_t *next)
{
	uint32_t away = (uint32_t)caster->vertex_count;

	for (int t = 0; t < caster->corner_count / 3; t++) {
		const uint16_t *corner = caster->corner + t * 3;

		if (caster->lit[t]) {
			next = triangle_list_add(next, corner[0] + away,
				corner[2] + away, corner[1] + away);
		}
	}
	return next;
}

/* A quad for every edge between a lit and an unlit triangle. */
static uint16_t *add_sides(const struct shadow_caster *caster, uint16_t *next)
{
	uint32_t away = (uint32_t)caster->vertex_count;

	for (int i = 0; i < caster->edge_count; i++) {
		const struct shadow_edge *edge = &caster->edge[i];
		bool left = caster->lit[edge->left];
		bool right = edge->right >= 0 && caster->lit[edge->right];
		uint32_t a = left ? edge->a : edge->b;
		uint32_t b = left ? edge->b : edge->a;

		if (left != right) {
			next = triangle_list_add(next, b, a, a + away);
			next = triangle_list_add(next, b, a + away, b + away);
		}
	}
	return next;
}

static float plane_distance(const float plane[4], const float from[3])
{
	return glm_vec3_dot((float *)plane, (float *)from) + plane[3];
}

/* The volume is beyond the near plane and ends below the ground. */
static bool allows_depth_pass(
	const struct shadow_caster *caster, const struct shadow_light *light)
{
	const float *plane = light->near_plane;
	float nearest = 1.0f;

	for (int i = 0; i < 2 * caster->vertex_count; i++) {
		float distance = plane_distance(plane, caster->position[i]);

		nearest = distance < nearest ? distance : nearest;
	}
	return nearest > 0.0f && !caster->too_short;
}

static void add_to_box(struct bounds *box, const struct shadow_caster *caster)
{
	for (int i = 0; i < 2 * caster->vertex_count; i++) {
		bounds_add(box, caster->position[i]);
	}
}

/* All of the box is beyond the near plane, so the eye is outside of it. */
static bool is_box_seen(const struct bounds *box, const float near_plane[4])
{
	bool seen = !bounds_is_empty(box);

	for (int i = 0; i < 8; i++) {
		const float corner[3] = {
			i & 1 ? box->high[0] : box->low[0],
			i & 2 ? box->high[1] : box->low[1],
			i & 4 ? box->high[2] : box->low[2],
		};

		seen = seen && plane_distance(near_plane, corner) > 0.0f;
	}
	return seen;
}

void shadow_volume_update(struct shadow_volume *volume,
	const struct instance *instance, const struct shadow_light *light)
{
	volume->depth_pass = light->ground && light->towards[1] > 0.0f;
	volume->box = bounds_empty();
	for (int i = 0; i < volume->caster_count; i++) {
		struct shadow_caster *caster = &volume->caster[i];
		uint16_t *sides_end, *end;

		caster->index_count = 0;
		caster->back_cap_count = 0;
		if (caster->drawable->hidden) {
			continue;
		}
		move_vertices(caster, instance, light);
		for (int t = 0; t < caster->corner_count / 3; t++) {
			caster->lit[t] = faces(
				caster, caster->corner + t * 3, light->towards);
		}
		sides_end =
			add_sides(caster, add_front_cap(caster, caster->index));
		end = add_back_cap(caster, sides_end);
		caster->index_count = (int)(end - caster->index);
		caster->back_cap_count = (int)(end - sides_end);
		volume->depth_pass &= allows_depth_pass(caster, light);
		add_to_box(&volume->box, caster);
	}
	volume->box_seen = is_box_seen(&volume->box, light->near_plane);
}

/* With depth-pass counting the ground hides all back caps. */
static void draw_volumes(const struct shadow_volume *volume, const struct gl *gl)
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

/* Covers the whole picture. */
static void draw_picture(const struct gl *gl)
{
	static const int16_t corner[4][2] = {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}};

	gl->MatrixMode(GL_PROJECTION);
	gl->PushMatrix();
	gl->LoadIdentity();
	gl->MatrixMode(GL_MODELVIEW);
	gl->PushMatrix();
	gl->LoadIdentity();
	gl->Disable(GL_CULL_FACE);
	gl->VertexPointer(2, GL_SHORT, 0, corner);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
	gl->MatrixMode(GL_PROJECTION);
	gl->PopMatrix();
	gl->MatrixMode(GL_MODELVIEW);
	gl->PopMatrix();
}

/* Covers the pixels of the box once: those of its faces towards the eye. */
static void draw_box(const struct gl *gl, const struct bounds *box)
{
	static const uint16_t index[36] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6,
		0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5,
		3, 7, 5};
	float corner[8][3];

	for (int i = 0; i < 8; i++) {
		for (int axis = 0; axis < 3; axis++) {
			corner[i][axis] = i >> axis & 1 ? box->high[axis]
							: box->low[axis];
		}
	}
	gl->Enable(GL_CULL_FACE);
	gl->VertexPointer(3, GL_FLOAT, 0, corner);
	gl->DrawElements(GL_TRIANGLES, 36, GL_UNSIGNED_SHORT, index);
	gl->Disable(GL_CULL_FACE);
}

/*
 * Blends a dark colour over all pixels whose stencil is not 0, once: among the
 * pixels that may have been counted, which lie in the volumes' box.
 */
static void darken(
	const struct shadow_volume *volume, const struct gl *gl, float strength)
{
	gl->StencilFunc(GL_NOTEQUAL, 0, 255);
	gl->StencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
	gl->Disable(GL_DEPTH_TEST);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	gl->Color4x(FX16_ONE / 16, FX16_ONE / 16, FX16_ONE / 12,
		fx16_from_float(strength));
	if (volume->box_seen) {
		draw_box(gl, &volume->box);
	} else {
		draw_picture(gl);
	}
	gl->Disable(GL_BLEND);
	gl->Enable(GL_DEPTH_TEST);
}

/*
 * Counts the volumes that the ground's pixels are in. Depth-pass counts front
 * faces before the ground up and back faces before it down. Depth-fail counts
 * back faces behind the ground up and front faces behind it down; it is also
 * right for an eye inside a volume, whose front it misses. Counting up comes
 * first, because GL ES 1.1's stencil saturates at 0.
 */
static void count_volumes(
	const struct shadow_volume *volume, const struct gl *gl)
{
	bool pass = volume->depth_pass;

	gl->CullFace(pass ? GL_BACK : GL_FRONT);
	gl->StencilOp(
		GL_KEEP, pass ? GL_KEEP : GL_INCR, pass ? GL_INCR : GL_KEEP);
	draw_volumes(volume, gl);
	gl->CullFace(pass ? GL_FRONT : GL_BACK);
	gl->StencilOp(
		GL_KEEP, pass ? GL_KEEP : GL_DECR, pass ? GL_DECR : GL_KEEP);
	draw_volumes(volume, gl);
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
	count_volumes(volume, gl);
	gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
	gl->Disable(GL_CULL_FACE);
	darken(volume, gl, strength);
	gl->DepthMask(GL_TRUE);
	gl->Disable(GL_STENCIL_TEST);
}
