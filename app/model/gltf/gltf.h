/*
 * glTF 2.0, as .glb or as .gltf with its data inside or beside it.
 */
#ifndef APP_MODEL_GLTF_GLTF_H
#define APP_MODEL_GLTF_GLTF_H

#include "app/model/examine/examine.h"
#include "app/model/model_loader.h"

/* True for the magic of a .glb, or where a JSON object begins. */
bool gltf_recognise(const uint8_t *data, size_t size);

/*
 * Sentences read "FILE: /json/path: REASON". Required extensions that limber
 * knows: KHR_materials_unlit, KHR_mesh_quantization, KHR_texture_transform;
 * another one is -ENOTSUP. See README.md for what is left out.
 */
int gltf_load(const struct model_source *source, const struct log *log,
	struct model **out);

/* What such a file holds that is easy to get wrong. */
int gltf_examine(const struct model_source *source,
	const struct examiner *examiner, const struct log *log);

#endif
