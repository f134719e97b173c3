/*
 * The loader of DirectX .x files: text and binary, plain and compressed, with
 * 32-bit and 64-bit floats, versions 03.02 and 03.03.
 *
 * A Frame becomes a node, a Mesh one primitive for each material, SkinWeights a
 * skin, an AnimationSet a clip. The file is left-handed with row vectors, so
 * the loader negates z and transposes matrices (xfile_convert.h). Type names
 * match in upper or lower case. Templates and unknown objects are skipped.
 *
 *	xfile.c            reads the header and runs the steps below
 *	xfile_inflate.c    compressed body -> plain body
 *	xfile_text.c       text   -> tokens
 *	xfile_binary.c     binary -> tokens
 *	xfile_reader.c     tokens -> numbers, strings, data objects
 *	xfile_parse.c      data objects -> struct xfile_scene, with
 *	                   xfile_mesh.c xfile_decl_data.c xfile_skin.c
 *	                   xfile_material.c xfile_animation.c
 *	xfile_build.c      struct xfile_scene -> struct model, with
 *	                   xfile_build_mesh.c xfile_build_skin.c
 *	                   xfile_build_material.c xfile_build_clip.c
 */
#ifndef APP_MODEL_XFILE_XFILE_H
#define APP_MODEL_XFILE_XFILE_H

#include "app/model/model_loader.h"

/* Whether data begins with the magic number "xof ". */
bool xfile_recognise(const uint8_t *data, size_t size);

/*
 * See struct model_format. Messages name the file, the line (text) or byte
 * (binary) and the reason. Textures must lie in the model's folder; one that is
 * missing or cannot be decoded only causes a warning.
 */
int xfile_load(const struct model_source *source, const struct log *log,
	struct model **out);

/* See struct model_format. */
int xfile_examine(const struct model_source *source,
	const struct examiner *examiner, const struct log *log);

#endif
