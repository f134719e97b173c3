/*
 * DirectX .x files: text and binary, plain and compressed, 32 and 64-bit
 * floats, versions 03.02 and 03.03.
 *
 * Frames become nodes, meshes primitives (one for each material), SkinWeights
 * skins and AnimationSets clips. The file is left-handed with row vectors; the
 * model is right-handed with column vectors, by negating z (xfile_convert.h).
 * Type names are taken without regard to case; templates and objects of other
 * types are skipped.
 *
 *	xfile.c            header, then the steps below
 *	xfile_inflate.c    compressed body -> plain body
 *	xfile_text.c       text   -> tokens
 *	xfile_binary.c     binary -> tokens
 *	xfile_reader.c     tokens -> numbers, strings, data objects
 *	xfile_parse.c      data objects -> struct xfile_scene, and for its parts
 *	xfile_mesh.c xfile_skin.c xfile_animation.c
 *	xfile_build.c      struct xfile_scene -> struct model, and for its parts
 *	xfile_build_mesh.c xfile_build_material.c xfile_build_clip.c
 */
#ifndef APP_MODEL_XFILE_XFILE_H
#define APP_MODEL_XFILE_XFILE_H

#include "app/model/model_loader.h"

/* Whether these are the first bytes of a .x file; 4 of them are enough. */
bool xfile_recognise(const uint8_t *data, size_t size);

/*
 * Sentences name the file, the line (text) or byte (binary) and the reason:
 * -EINVAL for a malformed file, -ENOTSUP for another version. Textures are
 * looked for beside the model; one that is missing, or of a kind that limber
 * cannot read, costs a warning only.
 */
int xfile_load(const struct model_source *source, const struct log *log,
	struct model **out);

/* What such a file holds that is easy to get wrong. */
int xfile_examine(const struct model_source *source,
	const struct examiner *examiner, const struct log *log);

#endif
