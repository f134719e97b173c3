#include "app/scene/draw/bump.h"

#include "app/anim/math/vec.h"
#include "app/model/model_alpha.h"
#include "app/scene/stage/light.h"

#include <cglm/cglm.h>

#include <errno.h>
#include <string.h>

enum {
	/* A lost context may report errors without end. */
	ERRORS_MAX = 16
};

bool bump_is_mapped(
	const struct model *model, const struct model_primitive *primitive)
{
	const struct model_material *material =
		&model->material[primitive->material];

	return material->normal_texture >= 0 &&
		model_alpha_of(model, primitive) == MODEL_OPAQUE &&
		!material->unlit && primitive->normal && primitive->tangent &&
		primitive->texcoord;
}

static bool model_is_mapped(const struct model *model)
{
	for (int m = 0; m < model->mesh_count; m++) {
		const struct model_mesh *mesh = &model->mesh[m];

		for (int p = 0; p < mesh->primitive_count; p++) {
			if (bump_is_mapped(model, &mesh->primitive[p])) {
				return true;
			}
		}
	}
	return false;
}

static void clear_errors(const struct gl *gl)
{
	for (int i = 0; i < ERRORS_MAX; i++) {
		if (gl->GetError() == GL_NO_ERROR) {
			return;
		}
	}
}

bool bump_is_supported(
	const struct model *model, const struct gl *gl, const struct log *log)
{
	bool supported;

	if (!model_is_mapped(model)) {
		return false;
	}
	clear_errors(gl);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB);
	supported = gl->GetError() == GL_NO_ERROR;
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
	clear_errors(gl);
	if (!supported) {
		log_warning(log,
			"%s: this GL driver cannot draw the model's normal maps because it has no DOT3 texture combiner: choose another driver with --gl",
			model->path);
	}
	return supported;
}

/* Twice the area of a triangle on the surface, and on the texture. */
static void measure_triangle(const struct model_primitive *primitive,
	const uint32_t *corner, float *surface, float *texture)
{
	const float *s = primitive->texcoord[corner[0]];
	const float *t = primitive->texcoord[corner[1]];
	const float *u = primitive->texcoord[corner[2]];
	float a[3], b[3], normal[3];

	vec_subtract(primitive->position[corner[1]],
		primitive->position[corner[0]], a);
	vec_subtract(primitive->position[corner[2]],
		primitive->position[corner[0]], b);
	vec_cross(a, b, normal);
	*surface += vec_length(normal);
	*texture += scalar_abs(
		(t[0] - s[0]) * (u[1] - s[1]) - (u[0] - s[0]) * (t[1] - s[1]));
}

static float find_texels(
	const struct model *model, const struct model_primitive *primitive)
{
	int texture = model->material[primitive->material].normal_texture;
	const struct model_image *image =
		&model->image[model->texture[texture].image];
	float surface = 0.0f, mapped = 0.0f;

	for (int i = 0; i + 2 < primitive->index_count; i += 3) {
		measure_triangle(
			primitive, primitive->index + i, &surface, &mapped);
	}
	mapped *= (float)image->width * (float)image->height;
	return surface > 0.0f ? scalar_sqrt(mapped / surface) : 0.0f;
}

int bump_init(struct drawable *drawable, const struct model *model,
	struct arena *arena)
{
	const struct model_primitive *primitive = drawable->primitive;
	size_t count = (size_t)primitive->vertex_count;

	if (!bump_is_mapped(model, primitive) || drawable->batch[0].source) {
		return 0;
	}
	drawable->bump_texels = find_texels(model, primitive);
	if (drawable->fixed) {
		drawable->light =
			arena_alloc(arena, count, sizeof(*drawable->light));
		return drawable->light ? 0 : -ENOMEM;
	}
	drawable->tangent = arena_alloc(arena, count, sizeof(float[3]));
	drawable->bitangent = arena_alloc(arena, count, sizeof(float[3]));
	drawable->light = arena_alloc(arena, count, sizeof(*drawable->light));
	if (!drawable->tangent || !drawable->bitangent || !drawable->light) {
		return -ENOMEM;
	}
	for (size_t v = 0; v < count; v++) {
		memcpy(drawable->tangent[v], primitive->tangent[v],
			sizeof(float[3]));
	}
	if (drawable->skin >= 0) {
		return drawable->morphed
			? 0
			: skin_stream_add_tangents(
				  &drawable->stream, primitive, arena);
	}
	drawable->base_tangent = (const float(*)[3])drawable->tangent;
	if (drawable->morphed) {
		drawable->tangent = arena_alloc(arena, count, sizeof(float[3]));
	}
	return drawable->tangent ? 0 : -ENOMEM;
}

/*
 * Multiplies the direction by the inverse of the matrix, up to a positive
 * scale. The rows of the inverse are cross products of the matrix's columns
 * divided by the determinant.
 */
static void to_local(const vec4 *matrix, const float world[3], float out[3])
{
	vec3 column[3], row[3], light = {world[0], world[1], world[2]};
	float determinant;

	for (int i = 0; i < 3; i++) {
		/* Unit columns keep products of tiny scales from underflow. */
		vec3 c = {matrix[i][0], matrix[i][1], matrix[i][2]};
		float length = vec_length(c);

		glm_vec3_scale(
			c, length > 0.0f ? 1.0f / length : 0.0f, column[i]);
	}
	for (int i = 0; i < 3; i++) {
		glm_vec3_cross(column[(i + 1) % 3], column[(i + 2) % 3], row[i]);
	}
	determinant = glm_vec3_dot(column[0], row[0]);
	for (int i = 0; i < 3; i++) {
		float along = glm_vec3_dot(row[i], light);

		out[i] = determinant < 0.0f ? -along : along;
	}
}

static void normalize(float v[3])
{
	float length = vec_length(v);

	for (int i = 0; i < 3; i++) {
		v[i] = length > 0.0f ? v[i] / length : 0.0f;
	}
}

void bump_encode(const float light[3], const float tangent[3],
	const float bitangent[3], const float normal[3], uint8_t out[4])
{
	const float local[3] = {vec_dot(light, tangent),
		vec_dot(light, bitangent), vec_dot(light, normal)};
	/* 0 where the surface faces away by a seventh of a radian or more. */
	float fade = scalar_clamp(1.0f + 7.0f * local[2], 0.0f, 1.0f);

	for (int i = 0; i < 3; i++) {
		out[i] = (uint8_t)scalar_clamp(
			128.0f + 127.5f * fade * local[i], 0.0f, 255.0f);
	}
	out[3] = 255;
}

/* The direction to the light in the space of the drawable's vertices. */
static void find_light(const struct instance *instance,
	const struct drawable *drawable, float out[3])
{
	if (drawable->skin >= 0) {
		memcpy(out, instance->towards_light, 3 * sizeof(*out));
	} else {
		to_local((const vec4 *)instance->world[drawable->node],
			instance->towards_light, out);
	}
	normalize(out);
}

static void unpack(const struct fixed_vector *v, float out[3])
{
	float x = v->x, y = v->y, z = v->z;
	float length2 = x * x + y * y + z * z;
	float scale = length2 > 0.0f ? 1.0f / scalar_sqrt(length2) : 0.0f;

	out[0] = x * scale;
	out[1] = y * scale;
	out[2] = z * scale;
}

static void encode_fixed(struct drawable *drawable, const float light[3])
{
	const struct drawable_fixed *fixed = drawable->fixed;
	int count = drawable->skin < 0
		? drawable->primitive->vertex_count
		: fixed_skin_posed_count(&fixed->skin, drawable->posed_lod);

	for (int v = 0; v < count; v++) {
		uint32_t from = fixed->order ? fixed->order[v] : (uint32_t)v;
		float normal[3], tangent[3], bitangent[3];

		unpack(&fixed->normal[v], normal);
		unpack(&fixed->tangent[v], tangent);
		glm_vec3_cross(normal, tangent, bitangent);
		glm_vec3_scale(bitangent, drawable->primitive->tangent[from][3],
			bitangent);
		bump_encode(
			light, tangent, bitangent, normal, drawable->light[v]);
	}
}

void bump_update(const struct instance *instance, struct drawable *drawable)
{
	int count = drawable->primitive->vertex_count;
	float light[3];

	find_light(instance, drawable, light);
	if (drawable->fixed) {
		encode_fixed(drawable, light);
		return;
	}
	instance->kernel->bitangents(count, (const float(*)[3])drawable->normal,
		(const float(*)[3])drawable->tangent,
		(const float(*)[4])drawable->primitive->tangent,
		drawable->bitangent);
	for (int v = 0; v < count; v++) {
		bump_encode(light, drawable->tangent[v], drawable->bitangent[v],
			drawable->normal[v], drawable->light[v]);
	}
}

void bump_begin_dot3_pass(const struct gl *gl)
{
	gl->Disable(GL_LIGHTING);
	gl->Disable(GL_BLEND);
	gl->Disable(GL_ALPHA_TEST);
	gl->DepthMask(GL_TRUE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_TEXTURE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_OPERAND0_RGB, GL_SRC_COLOR);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_PRIMARY_COLOR);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_OPERAND1_RGB, GL_SRC_COLOR);
}

void bump_begin_color_pass(const struct gl *gl)
{
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
	gl->DepthFunc(GL_EQUAL);
	gl->DepthMask(GL_FALSE);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_DST_COLOR, GL_ZERO);
	light_select(gl, LIGHT_KEY_COLOR);
}

void bump_begin_remaining_pass(const struct gl *gl)
{
	gl->BlendFunc(GL_ONE, GL_ONE);
	light_select(gl, LIGHT_REMAINDER);
}

void bump_end(const struct gl *gl)
{
	light_select(gl, LIGHT_ALL);
	gl->Disable(GL_BLEND);
	gl->DepthMask(GL_TRUE);
	gl->DepthFunc(GL_LESS);
}
