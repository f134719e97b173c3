#include "app/scene/draw/draw.h"

#include "app/anim/math/matrix.h"
#include "app/scene/draw/bump.h"
#include "app/scene/draw/draw_batch.h"
#include "app/scene/draw/emission.h"
#include "app/scene/draw/matrix_gl.h"
#include "platform/base/fixed.h"
#include "platform/base/scalar.h"

#include <cglm/cglm.h>

/* A fainter shadow is not seen, and must not keep others from a pixel. */
static const float least_shadow = 1.0f / 255;

/* Smoother surfaces get a stronger and narrower highlight. */
static void set_highlight(const struct gl *gl, float roughness)
{
	float gloss = 1.0f - scalar_clamp(roughness, 0.0f, 1.0f);
	GLfixed strength = fx16_from_float(0.5f * gloss * gloss);
	GLfixed specular[4] = {strength, strength, strength, FX16_ONE};

	gl->Materialxv(GL_FRONT_AND_BACK, GL_SPECULAR, specular);
	gl->Materialx(GL_FRONT_AND_BACK, GL_SHININESS,
		fx16_from_float(4.0f + 60.0f * gloss));
}

static void set_light(const struct gl *gl, const struct model_material *m)
{
	if (m->unlit) {
		gl->Disable(GL_LIGHTING);
		return;
	}
	gl->Enable(GL_LIGHTING);
	gl->Enable(GL_COLOR_MATERIAL);
	gl->Enable(GL_NORMALIZE);
	gl->LightModelx(GL_LIGHT_MODEL_TWO_SIDE, m->double_sided);
	set_highlight(gl, m->roughness);
}

static void set_alpha(const struct gl *gl, enum model_alpha alpha, float cutoff)
{
	if (alpha == MODEL_MASK) {
		gl->Enable(GL_ALPHA_TEST);
		gl->AlphaFuncx(GL_GEQUAL, fx16_from_float(cutoff));
	} else {
		gl->Disable(GL_ALPHA_TEST);
	}
	if (alpha == MODEL_BLEND) {
		gl->Enable(GL_BLEND);
		gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	} else {
		gl->Disable(GL_BLEND);
	}
	gl->DepthMask(alpha != MODEL_BLEND);
}

static void set_material(const struct gl *gl, const struct model_material *m,
	const struct texture_set *textures)
{
	set_light(gl, m);
	if (m->texture >= 0) {
		texture_bind(textures, gl, m->texture);
		gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
	} else {
		gl->Disable(GL_TEXTURE_2D);
	}
}

static const struct model_material *material_of(
	const struct instance *instance, const struct drawable *drawable)
{
	return &instance->model->material[drawable->primitive->material];
}

static bool is_textured(
	const struct instance *instance, const struct drawable *drawable)
{
	return material_of(instance, drawable)->texture >= 0 &&
		drawable->primitive->texcoord;
}

static void set_surface(const struct gl *gl, const struct instance *instance,
	const struct drawable *drawable, const struct texture_set *textures)
{
	const struct model_material *material = material_of(instance, drawable);

	set_alpha(gl, drawable->alpha, material->alpha_cutoff);
	set_material(gl, material, textures);
	gl->Color4x(drawable->color[0], drawable->color[1], drawable->color[2],
		drawable->color[3]);
	if (!is_textured(instance, drawable)) {
		gl->Disable(GL_TEXTURE_2D);
	}
}

/* Which triangles are drawn, by what glow.h tells of them. */
enum part {
	PART_ALL,
	PART_DARK,
	PART_SHINING,
};

/* Returns a list of the part's triangles; it may be empty. */
static struct batch_lod list_part(const struct drawable *drawable,
	const struct batch *batch, enum part part)
{
	const struct batch_lod *list = drawable_shaded(drawable, batch);
	struct batch_lod out = {.index = batch->index,
		.index_count =
			batch->index ? batch->index_count : batch->vertex_count,
		.glow_from = batch->glow_from,
		.flat = batch->source && batch->index};

	if (list) {
		out = *list;
	}
	if (part == PART_DARK) {
		out.index_count = out.glow_from;
	} else if (part == PART_SHINING && out.index) {
		out.index += out.glow_from;
		out.index_count -= out.glow_from;
	}
	return out;
}

static void draw_shaded(const struct gl *gl, const struct instance *instance,
	const struct drawable *drawable, const struct batch *batch,
	enum emission emission, enum part part)
{
	const struct batch_lod list = list_part(drawable, batch, part);
	bool textured = is_textured(instance, drawable);

	if (list.index_count == 0) {
		return;
	}
	if (list.flat) {
		gl->ShadeModel(GL_FLAT);
	}
	draw_batch(gl, batch,
		&(struct draw_arrays){
			.lit = true,
			.both_units = emission == EMISSION_BY_TEXTURE,
			.texcoord = textured ? batch->texcoord : NULL,
			.color = batch->color,
			.list = &list,
		});
	if (list.flat) {
		gl->ShadeModel(GL_SMOOTH);
	}
}

/* Draws all triangles, or those of a shadow or of edges, in one colour. */
static void draw_flat(const struct gl *gl, const struct drawable *drawable,
	const struct batch *batch, bool edges, bool textured)
{
	draw_batch(gl, batch,
		&(struct draw_arrays){
			.texcoord = textured ? batch->texcoord : NULL,
			.edges = edges,
			.list = edges ? drawable_shaded(drawable, batch)
				      : drawable_shadow(drawable, batch),
		});
}

void draw_set_shadow_color(const struct gl *gl, float strength)
{
	gl->Color4x(FX16_ONE / 16, FX16_ONE / 16, FX16_ONE / 12,
		fx16_from_float(strength));
}

/* Draws a shadow, and only where the texture has at least this alpha. */
static void draw_textured_shadow(const struct gl *gl,
	const struct instance *instance, const struct drawable *drawable,
	const struct texture_set *textures, GLfixed least)
{
	bool textured = is_textured(instance, drawable);

	if (textured) {
		texture_bind(
			textures, gl, material_of(instance, drawable)->texture);
		gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
		gl->Enable(GL_ALPHA_TEST);
		gl->AlphaFuncx(GL_GEQUAL, least);
	}
	for (int i = 0; i < drawable->batch_count; i++) {
		draw_flat(gl, drawable, &drawable->batch[i], false, textured);
	}
	gl->Disable(GL_ALPHA_TEST);
	gl->Disable(GL_TEXTURE_2D);
}

/*
 * Draws shadows of masked materials with the holes that their texture has, and
 * of blended ones as faint as their surface. The alpha that is tested is the
 * texel's times the shadow's. Returns false if the surface is opaque.
 */
static bool draw_partial_shadow(const struct gl *gl,
	const struct instance *instance, const struct drawable *drawable,
	const struct texture_set *textures)
{
	const struct model_material *material = material_of(instance, drawable);

	if (drawable->alpha == MODEL_BLEND) {
		draw_set_shadow_color(
			gl, drawable->mean_alpha * DRAW_SHADOW_ALPHA);
		draw_textured_shadow(gl, instance, drawable, textures,
			fx16_from_float(least_shadow));
		draw_set_shadow_color(gl, DRAW_SHADOW_ALPHA);
		return true;
	}
	if (drawable->alpha == MODEL_MASK && is_textured(instance, drawable)) {
		/* Above 0, as the surface is seen. */
		float cutoff = material->alpha_cutoff / material->base_color[3];

		draw_textured_shadow(gl, instance, drawable, textures,
			fx16_from_float(cutoff * DRAW_SHADOW_ALPHA));
		return true;
	}
	return false;
}

static void draw_all_shaded(const struct gl *gl, const struct instance *instance,
	const struct drawable *drawable, enum emission emission, enum part part)
{
	for (int i = 0; i < drawable->batch_count; i++) {
		draw_shaded(gl, instance, drawable, &drawable->batch[i],
			emission, part);
	}
}

/*
 * Draws front faces before back faces, which they hide most of; blended ones
 * after them, through which they are seen. Light of two sides is for back faces
 * alone.
 */
static void draw_two_sided(const struct gl *gl, const struct instance *instance,
	const struct drawable *drawable, enum emission emission, enum part part)
{
	bool blended = drawable->alpha == MODEL_BLEND;

	gl->Enable(GL_CULL_FACE);
	for (int turn = 0; turn < 2; turn++) {
		bool back = (turn == 0) == blended;

		gl->LightModelx(GL_LIGHT_MODEL_TWO_SIDE, back);
		gl->CullFace(back ? GL_FRONT : GL_BACK);
		draw_all_shaded(gl, instance, drawable, emission, part);
	}
	gl->CullFace(GL_BACK);
}

static void draw_sides(const struct gl *gl, const struct instance *instance,
	const struct drawable *drawable, enum emission emission, enum part part)
{
	if (material_of(instance, drawable)->double_sided) {
		draw_two_sided(gl, instance, drawable, emission, part);
	} else {
		draw_all_shaded(gl, instance, drawable, emission, part);
	}
}

/* Draws the surface with all light but that of a pass of its own. */
static void draw_lit(const struct gl *gl, const struct instance *instance,
	const struct drawable *drawable, const struct texture_set *textures,
	enum emission emission)
{
	if (emission == EMISSION_OVER_TEXTURE ||
		emission == EMISSION_BY_TEXTURE) {
		draw_sides(gl, instance, drawable, EMISSION_NONE, PART_DARK);
		emission_begin_unit(gl, instance->model, drawable, textures);
		draw_sides(gl, instance, drawable, emission, PART_SHINING);
		emission_end_unit(gl);
	} else if (emission == EMISSION_WITH_LIGHT) {
		emission_begin_light(gl, drawable);
		draw_sides(gl, instance, drawable, emission, PART_ALL);
		emission_end_light(gl);
	} else {
		draw_sides(gl, instance, drawable, emission, PART_ALL);
	}
}

/* Adds the light that both sides emit, if both are drawn. */
static void draw_emission(const struct gl *gl, const struct instance *instance,
	const struct drawable *drawable, const struct texture_set *textures)
{
	const struct model_material *material = material_of(instance, drawable);
	bool textured = emission_pass_is_textured(instance->model, drawable);

	if (material->double_sided) {
		gl->Disable(GL_CULL_FACE);
	}
	emission_begin_pass(gl, instance->model, drawable, textures);
	for (int i = 0; i < drawable->batch_count; i++) {
		const struct batch *batch = &drawable->batch[i];
		const struct batch_lod list =
			list_part(drawable, batch, PART_SHINING);

		if (list.index_count > 0) {
			draw_batch(gl, batch,
				&(struct draw_arrays){
					.texcoord = textured ? batch->texcoord
							     : NULL,
					.list = &list,
				});
		}
	}
	emission_end_pass(gl);
}

static void draw_drawable(const struct gl *gl, const struct instance *instance,
	const struct drawable *drawable, const struct texture_set *textures,
	enum draw_pass pass)
{
	const struct model_material *material = material_of(instance, drawable);
	enum emission emission = emission_of(
		instance->model, drawable->primitive, textures->two_units);
	bool edges = pass == DRAW_EDGES;

	if (pass == DRAW_SHADOW && drawable->unseen) {
		return;
	}
	/*
	 * Shadows are culled too: the triangles that face the light cover the
	 * whole silhouette.
	 */
	if (material->double_sided) {
		gl->Disable(GL_CULL_FACE);
	} else {
		gl->Enable(GL_CULL_FACE);
	}
	if (pass == DRAW_SHADED) {
		set_surface(gl, instance, drawable, textures);
		draw_lit(gl, instance, drawable, textures, emission);
		if (emission == EMISSION_ADDED) {
			draw_emission(gl, instance, drawable, textures);
		}
		return;
	}
	if (pass == DRAW_SHADOW && drawable->alpha != MODEL_OPAQUE &&
		draw_partial_shadow(gl, instance, drawable, textures)) {
		return;
	}
	for (int i = 0; i < drawable->batch_count; i++) {
		draw_flat(gl, drawable, &drawable->batch[i], edges, false);
	}
}

/* Draws back faces without bumps: their normals point the other way. */
static void draw_back(const struct gl *gl, const struct instance *instance,
	const struct drawable *drawable, const struct texture_set *textures)
{
	set_surface(gl, instance, drawable, textures);
	gl->CullFace(GL_FRONT);
	draw_shaded(gl, instance, drawable, drawable->batch, EMISSION_NONE,
		PART_ALL);
	gl->CullFace(GL_BACK);
}

/* Draws the three passes that bump.h describes. */
static void draw_bump_mapped(const struct gl *gl,
	const struct instance *instance, const struct drawable *drawable,
	const struct texture_set *textures)
{
	const struct model_material *material = material_of(instance, drawable);
	const struct batch *batch = drawable->batch;
	enum emission emission =
		emission_of(instance->model, drawable->primitive, false);

	gl->Enable(GL_CULL_FACE);
	texture_bind(textures, gl, material->normal_texture);
	bump_begin_dot3_pass(gl);
	draw_batch(gl, batch,
		&(struct draw_arrays){
			.texcoord = batch->texcoord,
			.color = (const uint8_t(*)[4])drawable->light,
			.list = drawable_shaded(drawable, batch),
		});
	set_surface(gl, instance, drawable, textures);
	bump_begin_color_pass(gl);
	draw_shaded(gl, instance, drawable, batch, EMISSION_NONE, PART_ALL);
	bump_begin_remaining_pass(gl);
	if (emission == EMISSION_WITH_LIGHT) {
		emission_begin_light(gl, drawable);
	}
	draw_shaded(gl, instance, drawable, batch, EMISSION_NONE, PART_ALL);
	bump_end(gl);
	if (material->double_sided) {
		draw_back(gl, instance, drawable, textures);
	}
	if (emission == EMISSION_WITH_LIGHT) {
		emission_end_light(gl);
	} else if (emission == EMISSION_ADDED) {
		draw_emission(gl, instance, drawable, textures);
	}
}

/* The model-view matrix takes the arrays to eye space. */
static void draw_in_place(const struct gl *gl, const struct instance *instance,
	const struct drawable *drawable, const struct texture_set *textures,
	enum draw_pass pass)
{
	if (pass == DRAW_SHADED && instance->normal_mapping &&
		textures->normal_mapping && drawable->bumped) {
		draw_bump_mapped(gl, instance, drawable, textures);
	} else {
		draw_drawable(gl, instance, drawable, textures, pass);
	}
}

/*
 * Multiplies the model-view matrix by the given one and by the arrays' scale
 * and offset, so that it takes the arrays' units, not drawable_position()'s. GL
 * ES 1.1 matrices have 16 fractional bits: the scale of fixed-point arrays is
 * therefore split into a power of two and a factor near 1.
 */
static void multiply_matrix(
	const struct drawable *drawable, mat4 matrix, const struct gl *gl)
{
	const struct fixed_placement *placement;
	float scale;

	if (!drawable->fixed) {
		matrix_gl_multiply(gl, (const vec4 *)matrix);
		return;
	}
	placement = &drawable->fixed->placement;
	scale = placement->scale * 32768.0f;
	matrix_apply(matrix, placement->offset, matrix[3]);
	for (int column = 0; column < 3; column++) {
		glm_vec3_scale(matrix[column], scale, matrix[column]);
	}
	matrix_gl_multiply(gl, (const vec4 *)matrix);
	gl->Scalex(FX16_ONE / 32768, FX16_ONE / 32768, FX16_ONE / 32768);
}

/* Skinned vertices are in scene units; others need their node's matrix. */
void draw_instance_part(const struct gl *gl, const struct instance *instance,
	const struct drawable *drawable, const struct texture_set *textures,
	enum draw_pass pass)
{
	mat4 matrix = GLM_MAT4_IDENTITY_INIT;
	bool mirrored = drawable->mirrored;

	if (drawable->skin < 0) {
		instance_drawable_matrix(instance, drawable, matrix);
		mirrored = matrix_determinant((const mat4 *)&matrix) < 0.0f;
	}
	gl->FrontFace(mirrored ? GL_CW : GL_CCW);
	if (drawable->skin >= 0 && !drawable->fixed) {
		draw_in_place(gl, instance, drawable, textures, pass);
		gl->FrontFace(GL_CCW);
		return;
	}
	gl->PushMatrix();
	multiply_matrix(drawable, matrix, gl);
	draw_in_place(gl, instance, drawable, textures, pass);
	gl->FrontFace(GL_CCW);
	gl->PopMatrix();
}

void draw_instance(const struct gl *gl, const struct instance *instance,
	const struct texture_set *textures, enum draw_pass pass)
{
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];

		if (!drawable->hidden && drawable->alpha != MODEL_BLEND) {
			draw_instance_part(
				gl, instance, drawable, textures, pass);
		}
	}
	for (int i = 0; i < instance->blended_count; i++) {
		const struct drawable *drawable =
			&instance->drawable[instance->blended[i].drawable];

		if (!drawable->hidden) {
			draw_instance_part(
				gl, instance, drawable, textures, pass);
		}
	}
}
