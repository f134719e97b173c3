#include "app/scene/draw/emission.h"

#include "app/model/color.h"
#include "platform/base/scalar.h"

/* Of a stage's lights together, sRGB-encoded; they are at most 1. */
static const float medium_light = 0.6f, least_light = 0.38f;

/* What 8 bits round to white. */
static const float white = 254.5f / 255.0f;

static const struct model_material *material_of(
	const struct model *model, const struct model_primitive *primitive)
{
	return &model->material[primitive->material];
}

/* Whether light and emission are multiplied by the same texture, or by none. */
static bool share_texture(
	const struct model *model, const struct model_primitive *primitive)
{
	const struct model_material *material = material_of(model, primitive);

	return material->texture == material->emissive_texture ||
		(!primitive->texcoord && material->emissive_texture < 0);
}

/* Units do not multiply a texture by a colour to add it to another texture. */
static bool is_white(
	const struct model *model, const struct model_primitive *primitive)
{
	float color[3];

	emission_color(model, primitive, color);
	return color[0] >= white && color[1] >= white && color[2] >= white;
}

enum emission emission_of(const struct model *model,
	const struct model_primitive *primitive, bool two_units)
{
	const struct model_material *material = material_of(model, primitive);

	if (!model_material_emits(material) ||
		(material->emissive_texture >= 0 && !primitive->texcoord)) {
		return EMISSION_NONE;
	}
	if (share_texture(model, primitive)) {
		return EMISSION_WITH_LIGHT;
	}
	if (two_units && material->emissive_texture < 0) {
		return EMISSION_OVER_TEXTURE;
	}
	return two_units && material->texture >= 0 && is_white(model, primitive)
		? EMISSION_BY_TEXTURE
		: EMISSION_ADDED;
}

/* Whether what the surface reflects is known but for a shared texture. */
static bool has_one_color(
	const struct model *model, const struct model_primitive *primitive)
{
	return !primitive->color &&
		(material_of(model, primitive)->texture < 0 ||
			share_texture(model, primitive));
}

/* What is added to an encoded base colour, both of one channel. */
static float find_addend(float base, float emitted)
{
	float lit = base * color_decode_srgb(medium_light);
	float encoded_base = color_encode_srgb(base);
	float medium =
		color_encode_srgb(lit + emitted) - encoded_base * medium_light;
	float least = color_encode_srgb(emitted) - encoded_base * least_light;

	return scalar_clamp(scalar_max(medium, least), 0.0f, 1.0f);
}

void emission_color(const struct model *model,
	const struct model_primitive *primitive, float out[3])
{
	const struct model_material *material = material_of(model, primitive);
	bool known = has_one_color(model, primitive);
	float shown[3];

	model_material_shown(material, shown);
	out[0] = out[1] = out[2] = 0.0f;
	for (int i = 0; model_material_emits(material) && i < 3; i++) {
		out[i] = find_addend(known ? color_decode_srgb(shown[i]) : 0.0f,
			material->emissive[i]);
	}
}

void emission_begin_light(const struct gl *gl, const struct drawable *drawable)
{
	gl->Materialxv(GL_FRONT_AND_BACK, GL_EMISSION, drawable->emission);
}

void emission_end_light(const struct gl *gl)
{
	static const GLfixed black[4] = {0, 0, 0, FX16_ONE};

	gl->Materialxv(GL_FRONT_AND_BACK, GL_EMISSION, black);
}

static void set_environment(const struct gl *gl, GLenum name, GLenum value)
{
	gl->TexEnvx(GL_TEXTURE_ENV, name, (GLfixed)value);
}

/* GL wants a texture where an environment does something, even by a constant. */
void emission_begin_unit(const struct gl *gl, const struct model *model,
	const struct drawable *drawable, const struct texture_set *textures)
{
	const struct model_material *material =
		material_of(model, drawable->primitive);
	const bool by_texture = material->emissive_texture >= 0;

	gl->ActiveTexture(GL_TEXTURE1);
	texture_bind(textures, gl,
		by_texture ? material->emissive_texture : material->texture);
	set_environment(gl, GL_TEXTURE_ENV_MODE, GL_COMBINE);
	set_environment(gl, GL_COMBINE_RGB, GL_ADD);
	set_environment(gl, GL_SRC0_RGB, GL_PREVIOUS);
	set_environment(gl, GL_SRC1_RGB, by_texture ? GL_TEXTURE : GL_CONSTANT);
	set_environment(gl, GL_COMBINE_ALPHA, GL_REPLACE);
	set_environment(gl, GL_SRC0_ALPHA, GL_PREVIOUS);
	gl->TexEnvxv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, drawable->emission);
	gl->ActiveTexture(GL_TEXTURE0);
}

void emission_end_unit(const struct gl *gl)
{
	gl->ActiveTexture(GL_TEXTURE1);
	gl->Disable(GL_TEXTURE_2D);
	gl->ActiveTexture(GL_TEXTURE0);
	gl->ClientActiveTexture(GL_TEXTURE1);
	gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->ClientActiveTexture(GL_TEXTURE0);
}

/*
 * What blended surfaces show has no depth of its own; masked ones have holes.
 * Nothing of opaque ones lies before what they show. That LEQUAL writes the
 * same depths again is what the driver soft has functions for.
 */
static void set_blending(const struct gl *gl, enum model_alpha alpha)
{
	gl->Enable(GL_BLEND);
	gl->DepthMask(alpha == MODEL_OPAQUE);
	gl->BlendFunc(alpha == MODEL_BLEND ? GL_SRC_ALPHA : GL_ONE, GL_ONE);
	gl->DepthFunc(alpha == MODEL_OPAQUE    ? GL_LEQUAL
			: alpha == MODEL_BLEND ? GL_LESS
					       : GL_EQUAL);
}

bool emission_pass_is_textured(
	const struct model *model, const struct drawable *drawable)
{
	const struct model_material *material =
		material_of(model, drawable->primitive);

	return material->emissive_texture >= 0 ||
		(drawable->alpha == MODEL_BLEND && material->texture >= 0 &&
			drawable->primitive->texcoord);
}

void emission_begin_pass(const struct gl *gl, const struct model *model,
	const struct drawable *drawable, const struct texture_set *textures)
{
	const struct model_material *material =
		material_of(model, drawable->primitive);
	const fx16_t *color = drawable->emission;

	gl->Disable(GL_LIGHTING);
	gl->Disable(GL_ALPHA_TEST);
	set_blending(gl, drawable->alpha);
	if (material->emissive_texture >= 0) {
		texture_bind(textures, gl, material->emissive_texture);
		set_environment(gl, GL_TEXTURE_ENV_MODE, GL_MODULATE);
	} else if (emission_pass_is_textured(model, drawable)) {
		/* From one color to the same, by the texture's; alpha by its alpha. */
		texture_bind(textures, gl, material->texture);
		set_environment(gl, GL_TEXTURE_ENV_MODE, GL_BLEND);
		gl->TexEnvxv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
	} else {
		gl->Disable(GL_TEXTURE_2D);
	}
	gl->Color4x(color[0], color[1], color[2], drawable->color[3]);
}

void emission_end_pass(const struct gl *gl)
{
	gl->Disable(GL_BLEND);
	gl->DepthMask(GL_TRUE);
	gl->DepthFunc(GL_LESS);
}
