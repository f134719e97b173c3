/*
 * A glTF file as JSON and numbers, for code that rewrites the file.
 *
 * Unlike a struct model, a document keeps everything that the file holds:
 * names, extras, other scenes, extensions. A document owns its JSON, which its
 * user may change, and its bytes. Loaders do not use it.
 */
#ifndef APP_MODEL_GLTF_DOCUMENT_GLTF_DOCUMENT_H
#define APP_MODEL_GLTF_DOCUMENT_GLTF_DOCUMENT_H

#include "app/model/model_file.h"

#include <jansson.h>

struct gltf_document;

/* The numbers of an accessor, and how the file stores them. */
struct gltf_document_array {
	int count;     /* elements */
	int width;     /* components of an element */
	int component; /* glTF's componentType */
	bool normalized;
	size_t bytes; /* in the file, without what lies between elements */
};

/*
 * Reads a file that begins like glTF, and checks its buffers and accessors. The
 * source's bytes must outlive the document, which the caller releases with
 * gltf_document_close(). Returns 0, or -errno after logging an error. What
 * loading the file's model warns of is not said again.
 */
int gltf_document_open(const struct model_source *source, const struct log *log,
	struct gltf_document **out);

/* NULL is fine. */
void gltf_document_close(struct gltf_document *document);

/* The root object, which the document owns. */
json_t *gltf_document_json(const struct gltf_document *document);

/* The bytes of the file, of its buffers and of the images read so far. */
size_t gltf_document_bytes(const struct gltf_document *document);

int gltf_document_array_count(const struct gltf_document *document);

/* index is an accessor's number, below gltf_document_array_count(). */
struct gltf_document_array gltf_document_array(
	const struct gltf_document *document, int index);

/*
 * Writes count * width components as they are stored: normalised integers keep
 * their values of -127..127 and so on. Returns 0, or -EINVAL after logging an
 * error about a float that is not finite.
 */
int gltf_document_floats(
	const struct gltf_document *document, int index, float *out);

/* The same of an array of unsigned integers that are not normalised. */
void gltf_document_uints(
	const struct gltf_document *document, int index, uint32_t *out);

/*
 * The bytes of an image, from its buffer view or its URI. The document owns
 * them. Returns 0, or -errno after logging a warning: limber plays a model
 * whose unused images are missing.
 */
int gltf_document_image(struct gltf_document *document, int image,
	const uint8_t **data, size_t *size);

#endif
