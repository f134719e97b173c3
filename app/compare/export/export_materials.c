#include "app/compare/export/export_bake.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

#include <png.h>

/* The values of glTF's samplers, which are OpenGL's constants. */
enum {
	FILTER_NEAREST = 9728,
	FILTER_LINEAR = 9729,
	FILTER_LINEAR_MIPMAP_LINEAR = 9987,
	WRAP_REPEAT = 10497,
	WRAP_CLAMP_TO_EDGE = 33071,
	WRAP_MIRRORED_REPEAT = 33648
};

static json_t *texture_json(int texture)
{
	return json_pack("{s:i}", "index", texture);
}

static void add_emission(json_t *json, const struct model_material *material)
{
	if (!model_material_emits(material)) {
		return;
	}
	json_object_set_new(
		json, "emissiveFactor", glb_floats(material->emissive, 3));
	if (material->emissive_texture >= 0) {
		json_object_set_new(json, "emissiveTexture",
			texture_json(material->emissive_texture));
	}
}

static json_t *material_json(const struct model_material *material)
{
	static const char *const alpha[] = {
		[MODEL_OPAQUE] = "OPAQUE",
		[MODEL_MASK] = "MASK",
		[MODEL_BLEND] = "BLEND",
	};
	json_t *surface = json_pack("{s:o, s:f, s:f}", "baseColorFactor",
		glb_floats(material->base_color, 4), "metallicFactor", 0.0,
		"roughnessFactor", (double)material->roughness);
	json_t *json = json_pack("{s:s, s:o, s:s, s:b}", "name", material->name,
		"pbrMetallicRoughness", surface, "alphaMode",
		alpha[material->alpha], "doubleSided", material->double_sided);

	if (json && material->texture >= 0) {
		json_object_set_new(surface, "baseColorTexture",
			texture_json(material->texture));
	}
	if (json && material->alpha == MODEL_MASK) {
		json_object_set_new(json, "alphaCutoff",
			json_real((double)material->alpha_cutoff));
	}
	if (json) {
		add_emission(json, material);
	}
	if (json && material->unlit) {
		json_object_set_new(json, "extensions",
			json_pack("{s:{}}", "KHR_materials_unlit"));
	}
	return json;
}

static json_t *sampler_json(const struct model_texture *texture)
{
	static const int wrap[] = {
		[MODEL_REPEAT] = WRAP_REPEAT,
		[MODEL_CLAMP] = WRAP_CLAMP_TO_EDGE,
		[MODEL_MIRROR] = WRAP_MIRRORED_REPEAT,
	};
	int min_filter =
		texture->mipmap ? FILTER_LINEAR_MIPMAP_LINEAR : FILTER_LINEAR;

	return json_pack("{s:i, s:i, s:i, s:i}", "magFilter",
		texture->nearest ? FILTER_NEAREST : FILTER_LINEAR, "minFilter",
		min_filter, "wrapS", wrap[texture->wrap_s], "wrapT",
		wrap[texture->wrap_t]);
}

/* Adds an image as PNG. Returns the index of its buffer view, or -1. */
static int add_png(struct glb *glb, const struct model_image *image)
{
	png_image png = {
		.version = PNG_IMAGE_VERSION,
		.width = (png_uint_32)image->width,
		.height = (png_uint_32)image->height,
		.format = PNG_FORMAT_RGBA,
	};
	png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
	void *data = malloc(size);
	int view = -1;

	if (data &&
		png_image_write_to_memory(
			&png, data, &size, 0, image->rgba, 0, NULL)) {
		view = glb_add_view(glb, data, size);
	} else {
		glb->error = glb->error ? glb->error : -ENOMEM;
	}
	png_image_free(&png);
	free(data);
	return view;
}

/*
 * An image that the loaded model takes from the exported one: its name is its index
 * there. A transparent pixel leaves every material the alpha mode that it has.
 */
static json_t *shared_image(struct glb *glb, int index)
{
	uint8_t transparent[4] = {0};
	const struct model_image pixel = {
		.width = 1, .height = 1, .rgba = transparent};
	char name[16];

	snprintf(name, sizeof(name), "%d", index);
	return json_pack("{s:s, s:i, s:s}", "name", name, "bufferView",
		add_png(glb, &pixel), "mimeType", "image/png");
}

static json_t *whole_image(struct glb *glb, const struct model_image *image)
{
	return json_pack("{s:i, s:s}", "bufferView", add_png(glb, image),
		"mimeType", "image/png");
}

static void export_textures(struct glb *glb, const struct model *model)
{
	json_t *textures = json_array(), *samplers = json_array();
	json_t *images = json_array();

	for (int i = 0; i < model->texture_count; i++) {
		json_array_append_new(
			samplers, sampler_json(&model->texture[i]));
		json_array_append_new(textures,
			json_pack("{s:i, s:i}", "sampler", i, "source",
				model->texture[i].image));
	}
	for (int i = 0; i < model->image_count; i++) {
		json_array_append_new(images,
			glb->shares_images ? shared_image(glb, i)
					   : whole_image(glb, &model->image[i]));
	}
	glb_set(glb, "textures", textures);
	glb_set(glb, "samplers", samplers);
	glb_set(glb, "images", images);
}

void export_materials(struct glb *glb, const struct model *model)
{
	json_t *materials = json_array();

	for (int i = 0; i < model->material_count; i++) {
		if (model->material[i].unlit) {
			glb_use_extension(glb, "KHR_materials_unlit");
		}
		json_array_append_new(
			materials, material_json(&model->material[i]));
	}
	glb_set(glb, "materials", materials);
	if (model->texture_count > 0) {
		export_textures(glb, model);
	}
}
