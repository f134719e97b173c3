/*
 * The glTF 2.0 loader, for .glb and for .gltf with embedded or separate data.
 */
#ifndef APP_MODEL_GLTF_GLTF_H
#define APP_MODEL_GLTF_GLTF_H

#include "app/model/examine/examine.h"
#include "app/model/model_loader.h"

/* Whether data begins with the magic number of a .glb or with a JSON object. */
bool gltf_recognise(const uint8_t *data, size_t size);

/*
 * See struct model_format. Messages read "FILE: /json/path: REASON". Returns
 * -ENOTSUP if the file requires an extension that README.md does not list as
 * supported or ignored. README.md also lists what else the loader ignores.
 */
int gltf_load(const struct model_source *source, const struct log *log,
	struct model **out);

/* See struct model_format. */
int gltf_examine(const struct model_source *source,
	const struct examiner *examiner, const struct log *log);

#endif
