#include "app/model/gltf/gltf_internal.h"

#include "platform/base/scalar.h"

#include <errno.h>
#include <math.h>
#include <string.h>

/*
 * Reads KHR_texture_transform: scale, then rotation, then offset. v runs down,
 * so the rotation is counter-clockwise in the image.
 */
static int read_uv_transform(const struct gltf_at *at, struct gltf_uv *out)
{
	float offset[2] = {0, 0};
	float scale[2] = {1, 1};
	float angle_rad = 0;
	int64_t set = out->set;
	int error = gltf_maybe_floats(at, "offset", offset, 2);

	if (!error) {
		error = gltf_maybe_floats(at, "scale", scale, 2);
	}
	if (!error) {
		error = gltf_maybe_number(at, "rotation", &angle_rad);
	}
	if (!error) {
		error = gltf_maybe_integer(at, "texCoord", 0, INT32_MAX, &set);
	}
	if (error) {
		return error;
	}
	*out = (struct gltf_uv){
		.set = (int)set,
		.transformed = true,
		.row = {{cosf(angle_rad) * scale[0], sinf(angle_rad) * scale[1],
				offset[0]},
			{-sinf(angle_rad) * scale[0],
				cosf(angle_rad) * scale[1], offset[1]}},
	};
	return 0;
}

/*
 * Reads a textureInfo: the texture, -1 without one, and the transform of its
 * coordinates.
 */
static int read_texture_info(const struct gltf_at *parent, const char *key,
	int *texture, struct gltf_uv *uv)
{
	struct gltf_at at, extensions, transform;
	int index = 0;
	int64_t set = 0;
	int error = gltf_object(parent, key, &at);

	*texture = -1;
	if (error || !at.json) {
		return error;
	}
	error = gltf_require(&at, "index");
	if (!error) {
		error = gltf_maybe_root_index(
			&at, "index", "textures", "texture", &index);
	}
	if (!error) {
		error = gltf_maybe_integer(&at, "texCoord", 0, INT32_MAX, &set);
	}
	if (!error) {
		error = gltf_object(&at, "extensions", &extensions);
	}
	if (!error) {
		error = gltf_object(
			&extensions, "KHR_texture_transform", &transform);
	}
	if (!error) {
		error = gltf_use_texture(at.gltf, index, texture);
	}
	*uv = (struct gltf_uv){
		.set = (int)set,
		.row = {{1, 0, 0}, {0, 1, 0}},
	};
	return error || !transform.json ? error
					: read_uv_transform(&transform, uv);
}

static int read_alpha(const struct gltf_at *at, struct model_material *out)
{
	static const char *const names[] = {
		[MODEL_OPAQUE] = "OPAQUE",
		[MODEL_MASK] = "MASK",
		[MODEL_BLEND] = "BLEND",
	};
	int choice = MODEL_OPAQUE;
	int error = gltf_maybe_choice(
		at, "alphaMode", names, ARRAY_COUNT(names), &choice);

	if (error) {
		return error;
	}
	out->alpha = (enum model_alpha)choice;
	return gltf_maybe_number(at, "alphaCutoff", &out->alpha_cutoff);
}

/*
 * Compares floats instead of bytes: a transform without effect, which some
 * exporters write, has a -0 where a texture without a transform has 0.
 */
static bool is_same_uv(const struct gltf_uv *a, const struct gltf_uv *b)
{
	bool same = a->set == b->set;

	for (int i = 0; i < 6; i++) {
		same = same && a->row[i / 3][i % 3] == b->row[i / 3][i % 3];
	}
	return same;
}

/*
 * Reads the textures of base colour and normals. A vertex has one pair of
 * texture coordinates: those of the base colour, else of the normal map, else
 * of the emissive texture. A texture that needs others is dropped.
 */
static int read_textures(const struct gltf_at *at, const struct gltf_at *pbr,
	const char *base, struct model_material *out, struct gltf_uv *uv)
{
	struct gltf_uv normal_uv = {0};
	int error = read_texture_info(pbr, base, &out->texture, uv);

	if (!error) {
		error = read_texture_info(
			at, "normalTexture", &out->normal_texture, &normal_uv);
	}
	if (error || out->normal_texture < 0) {
		return error;
	}
	if (out->texture < 0) {
		*uv = normal_uv;
	} else if (!is_same_uv(uv, &normal_uv)) {
		gltf_warn(at,
			"limber ignores normalTexture, because its coordinates differ from those of %s",
			base);
		out->normal_texture = -1;
	}
	return 0;
}

/*
 * Reads the emissive texture if its coordinates are those of the textures that
 * were read before. If it cannot be used, the material emits no light, since
 * without the texture the whole surface would shine.
 */
static int read_emissive_texture(const struct gltf_at *at,
	struct model_material *out, struct gltf_uv *uv)
{
	struct gltf_uv own_uv = {0};
	struct gltf_at texture;
	bool alone = out->texture < 0 && out->normal_texture < 0;
	int error = gltf_object(at, "emissiveTexture", &texture);

	if (!error) {
		error = read_texture_info(
			at, "emissiveTexture", &out->emissive_texture, &own_uv);
	}
	if (error || !texture.json) {
		return error;
	}
	if (out->emissive_texture < 0) {
		memset(out->emissive, 0, sizeof(out->emissive));
	} else if (alone) {
		*uv = own_uv;
	} else if (!is_same_uv(uv, &own_uv)) {
		gltf_warn(at,
			"limber ignores emissiveTexture, because its coordinates differ from those of the other textures");
		memset(out->emissive, 0, sizeof(out->emissive));
		out->emissive_texture = -1;
	}
	return 0;
}

/*
 * Reads the light that a material emits, KHR_materials_emissive_strength
 * included. GL cannot draw light brighter than white, so it is clamped to 1.
 */
static int read_emission(const struct gltf_at *at,
	const struct gltf_at *extensions, struct model_material *out,
	struct gltf_uv *uv)
{
	struct gltf_at stronger;
	float strength = 1.0f;
	int error = gltf_maybe_floats(at, "emissiveFactor", out->emissive, 3);

	if (!error) {
		error = gltf_object(extensions,
			"KHR_materials_emissive_strength", &stronger);
	}
	if (!error) {
		error = gltf_maybe_number(
			&stronger, "emissiveStrength", &strength);
	}
	for (int i = 0; !error && i < 3; i++) {
		out->emissive[i] =
			scalar_clamp(out->emissive[i] * strength, 0.0f, 1.0f);
	}
	return error || !model_material_emits(out)
		? error
		: read_emissive_texture(at, out, uv);
}

/* Whether blending would show an alpha that an opaque material ignores. */
static bool ignores_alpha(
	const struct model *model, const struct model_material *material)
{
	return material->alpha == MODEL_OPAQUE && material->texture >= 0 &&
		!model->image[model->texture[material->texture].image].opaque;
}

/*
 * Reads KHR_materials_transmission: what is behind shows through, as through a
 * blended surface. A texture would say where; without it, nothing is blended.
 */
static int read_transmission(
	const struct gltf_at *extensions, struct model_material *out)
{
	/* Of clear glass, the gloss and a little of the colour remain. */
	static const float most = 0.75f;
	struct gltf_at at, texture;
	float factor = 0.0f;
	int error = gltf_object(extensions, "KHR_materials_transmission", &at);

	if (!error) {
		error = gltf_maybe_number(&at, "transmissionFactor", &factor);
	}
	if (!error) {
		error = gltf_object(&at, "transmissionTexture", &texture);
	}
	if (error || texture.json || factor <= 0.0f || out->alpha == MODEL_MASK ||
		ignores_alpha(extensions->gltf->model, out)) {
		return error;
	}
	out->base_color[3] =
		(out->alpha == MODEL_OPAQUE ? 1.0f : out->base_color[3]) *
		(1.0f - most * scalar_clamp(factor, 0.0f, 1.0f));
	out->alpha = MODEL_BLEND;
	return 0;
}

/*
 * Reads KHR_materials_pbrSpecularGlossiness, which the extension's
 * specification wants preferred to pbrMetallicRoughness. Its diffuse colour
 * becomes the base colour.
 */
static int read_glossiness(const struct gltf_at *material,
	const struct gltf_at *at, struct model_material *out, struct gltf_uv *uv)
{
	float gloss = 1.0f;
	int error = gltf_maybe_floats(at, "diffuseFactor", out->base_color, 4);

	if (!error) {
		error = gltf_maybe_number(at, "glossinessFactor", &gloss);
	}
	out->roughness = 1.0f - gloss;
	return error ? error
		     : read_textures(material, at, "diffuseTexture", out, uv);
}

static int read_roughness(const struct gltf_at *at, const struct gltf_at *pbr,
	struct model_material *out, struct gltf_uv *uv)
{
	int error =
		gltf_maybe_floats(pbr, "baseColorFactor", out->base_color, 4);

	if (!error) {
		error = gltf_maybe_number(
			pbr, "roughnessFactor", &out->roughness);
	}
	return error ? error
		     : read_textures(at, pbr, "baseColorTexture", out, uv);
}

static int read_material(const struct gltf_at *at)
{
	struct model_material *out = &at->gltf->model->material[at->index];
	struct gltf_uv *uv = &at->gltf->uv[at->index];
	struct gltf_at pbr, extensions, glossiness;
	int error;

	*out = model_plain_material;
	error = gltf_name(at, &out->name);
	if (!error) {
		error = gltf_object(at, "pbrMetallicRoughness", &pbr);
	}
	if (!error) {
		error = read_alpha(at, out);
	}
	if (!error) {
		error = gltf_maybe_bool(at, "doubleSided", &out->double_sided);
	}
	if (!error) {
		error = gltf_object(at, "extensions", &extensions);
	}
	if (!error) {
		error = gltf_object(&extensions,
			"KHR_materials_pbrSpecularGlossiness", &glossiness);
	}
	if (error) {
		return error;
	}
	out->unlit = json_object_get(extensions.json, "KHR_materials_unlit");
	error = glossiness.json ? read_glossiness(at, &glossiness, out, uv)
				: read_roughness(at, &pbr, out, uv);
	if (!error) {
		error = read_transmission(&extensions, out);
	}
	return error ? error : read_emission(at, &extensions, out, uv);
}

/* Allocates one material more than the file has, for the default material. */
static int allocate(struct gltf *gltf, int material_count)
{
	struct model *model = gltf->model;
	model->material = GLTF_KEEP(
		&gltf->root, struct model_material, (size_t)material_count + 1);
	gltf->uv = GLTF_SCRATCH(
		&gltf->root, struct gltf_uv, (size_t)material_count + 1);
	return model->material && gltf->uv ? 0 : -ENOMEM;
}

int gltf_read_materials(struct gltf *gltf)
{
	struct gltf_at array;
	int count;
	int error = gltf_array(&gltf->root, "materials", &array, &count);

	if (!error) {
		error = allocate(gltf, count);
	}
	if (!error) {
		error = gltf_prepare_textures(gltf);
	}
	if (!error) {
		error = gltf_for_each(&array, count, read_material);
	}
	gltf->model->material_count = error ? 0 : count;
	return error;
}

int gltf_default_material(struct gltf *gltf)
{
	struct model *model = gltf->model;

	if (gltf->default_material < 0) {
		gltf->default_material = model->material_count++;
		model->material[gltf->default_material] = model_plain_material;
	}
	return gltf->default_material;
}
