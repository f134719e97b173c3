#include "app/scene/draw.h"

#include "app/scene/matrix_gl.h"
#include "platform/base/fixed.h"
#include "platform/base/scalar.h"

/* A faint highlight that tightens as the surface gets smoother. */
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

static void set_alpha(const struct gl *gl, const struct model_material *m)
{
	if (m->alpha == MODEL_MASK) {
		gl->Enable(GL_ALPHA_TEST);
		gl->AlphaFuncx(GL_GEQUAL, fx16_from_float(m->alpha_cutoff));
	} else {
		gl->Disable(GL_ALPHA_TEST);
	}
	if (m->alpha == MODEL_BLEND) {
		gl->Enable(GL_BLEND);
		gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	} else {
		gl->Disable(GL_BLEND);
	}
	gl->DepthMask(m->alpha != MODEL_BLEND);
}

static void set_material(const struct gl *gl, const struct model_material *m,
	const struct texture_set *textures)
{
	set_light(gl, m);
	set_alpha(gl, m);
	if (m->texture >= 0) {
		texture_bind(textures, gl, m->texture);
		gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
	} else {
		gl->Disable(GL_TEXTURE_2D);
	}
}

static void enable_array(const struct gl *gl, GLenum array, const void *data)
{
	if (data) {
		gl->EnableClientState(array);
	} else {
		gl->DisableClientState(array);
	}
}

static void draw_batch(const struct gl *gl, const struct batch *batch,
	bool textured, enum draw_pass pass)
{
	bool shaded = pass == DRAW_SHADED;
	const void *texcoord = textured && shaded ? batch->texcoord : NULL;
	const void *color = shaded ? batch->color : NULL;
	const void *normal = shaded ? batch->normal : NULL;

	enable_array(gl, GL_VERTEX_ARRAY, batch->position);
	enable_array(gl, GL_NORMAL_ARRAY, normal);
	enable_array(gl, GL_TEXTURE_COORD_ARRAY, texcoord);
	enable_array(gl, GL_COLOR_ARRAY, color);
	gl->VertexPointer(3, GL_FLOAT, 0, batch->position);
	if (normal) {
		gl->NormalPointer(GL_FLOAT, 0, normal);
	}
	if (texcoord) {
		gl->TexCoordPointer(2, GL_FLOAT, 0, texcoord);
	}
	if (color) {
		gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, color);
	}
	if (batch->index) {
		gl->DrawElements(GL_TRIANGLES, batch->index_count,
			GL_UNSIGNED_SHORT, batch->index);
	} else {
		gl->DrawArrays(GL_TRIANGLES, 0, batch->vertex_count);
	}
}

static void draw_drawable(const struct gl *gl, const struct instance *instance,
	const struct drawable *drawable, const struct texture_set *textures,
	enum draw_pass pass)
{
	const struct model_material *material =
		&instance->model->material[drawable->primitive->material];
	bool textured = material->texture >= 0 && drawable->primitive->texcoord;

	if (pass == DRAW_SHADED) {
		set_material(gl, material, textures);
		gl->Color4x(drawable->color[0], drawable->color[1],
			drawable->color[2], drawable->color[3]);
		if (!textured) {
			gl->Disable(GL_TEXTURE_2D);
		}
	}
	if (material->double_sided || pass == DRAW_SHAPE) {
		gl->Disable(GL_CULL_FACE);
	} else {
		gl->Enable(GL_CULL_FACE);
	}
	for (int i = 0; i < drawable->batch_count; i++) {
		draw_batch(gl, &drawable->batch[i], textured, pass);
	}
}

/* By its node's matrix if rigid; skinned vertices are in place already. */
static void place_and_draw(const struct gl *gl, const struct instance *instance,
	const struct drawable *drawable, const struct texture_set *textures,
	enum draw_pass pass)
{
	mat4 matrix;

	if (drawable->skin >= 0) {
		draw_drawable(gl, instance, drawable, textures, pass);
		return;
	}
	instance_drawable_matrix(instance, drawable, matrix);
	gl->PushMatrix();
	matrix_gl_multiply(gl, (const vec4 *)matrix);
	gl->FrontFace(matrix_mirrors((const vec4 *)matrix) ? GL_CW : GL_CCW);
	draw_drawable(gl, instance, drawable, textures, pass);
	gl->FrontFace(GL_CCW);
	gl->PopMatrix();
}

static bool is_blended(
	const struct instance *instance, const struct drawable *drawable)
{
	return instance->model->material[drawable->primitive->material].alpha ==
		MODEL_BLEND;
}

void draw_instance(const struct gl *gl, const struct instance *instance,
	const struct texture_set *textures, enum draw_pass pass)
{
	for (int blended = 0; blended <= 1; blended++) {
		for (int i = 0; i < instance->drawable_count; i++) {
			const struct drawable *drawable = &instance->drawable[i];

			if (!drawable->hidden &&
				is_blended(instance, drawable) == blended) {
				place_and_draw(
					gl, instance, drawable, textures, pass);
			}
		}
	}
}

void draw_node(const struct gl *gl, const struct instance *instance,
	const struct texture_set *textures, int node, enum draw_pass pass)
{
	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];

		if (drawable->node == node && !drawable->hidden) {
			fx16_t scale =
				fx16_from_float(1.0f / drawable->vertex_scale);

			gl->PushMatrix();
			gl->Scalex(scale, scale, scale);
			draw_drawable(gl, instance, drawable, textures, pass);
			gl->PopMatrix();
		}
	}
}

/* What the steps of a walk need. */
struct walk {
	const struct gl *gl;
	const struct instance *instance;
	const struct texture_set *textures;
	enum draw_pass pass;
};

static void walk_push(void *user)
{
	((struct walk *)user)->gl->PushMatrix();
}

static void walk_pop(void *user)
{
	((struct walk *)user)->gl->PopMatrix();
}

static void walk_translate(void *user, const float offset[3])
{
	((struct walk *)user)
		->gl->Translatex(fx16_from_float(offset[0]),
			fx16_from_float(offset[1]), fx16_from_float(offset[2]));
}

static void walk_rotate(void *user, float angle_rad, const float axis[3])
{
	((struct walk *)user)
		->gl->Rotatex(fx16_from_float(angle_rad * (180.0f / SCALAR_PI)),
			fx16_from_float(axis[0]), fx16_from_float(axis[1]),
			fx16_from_float(axis[2]));
}

static void walk_scale(void *user, const float factor[3])
{
	((struct walk *)user)
		->gl->Scalex(fx16_from_float(factor[0]),
			fx16_from_float(factor[1]), fx16_from_float(factor[2]));
}

static void walk_draw(void *user, int part)
{
	struct walk *walk = user;

	draw_node(walk->gl, walk->instance, walk->textures, part, walk->pass);
}

void draw_hierarchy(const struct gl *gl, const struct hierarchy *hierarchy,
	const struct instance *instance, const struct texture_set *textures,
	enum draw_pass pass)
{
	struct walk walk = {gl, instance, textures, pass};
	const struct pivot_visitor visitor = {
		.user = &walk,
		.push = walk_push,
		.translate = walk_translate,
		.rotate = walk_rotate,
		.scale = walk_scale,
		.draw = walk_draw,
		.pop = walk_pop,
	};

	hierarchy_walk(hierarchy, &visitor);
}
