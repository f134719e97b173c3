/*
 * A glTF file as JSON and numbers, for code that rewrites the file.
 *
 * Unlike a struct model, a document keeps everything that the file has: names,
 * extras, other scenes, extensions. A document owns its bytes and its JSON,
 * which the caller may change. Loaders do not use documents.
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
	int rows;      /* components of a matrix's column; 0: no matrix */
	int component; /* glTF's componentType */
	bool normalized;
	size_t bytes; /* bytes that the elements take in the file, aligned to 4
			 bytes as attributes are */
};

/*
 * Reads a file that begins like glTF, and checks its buffers and accessors. The
 * source's bytes must outlive the document, which the caller releases with
 * gltf_document_close(). Returns 0, or -errno after logging an error. It logs
 * no warnings, since loading the file's model has logged them.
 */
int gltf_document_open(const struct model_source *source, const struct log *log,
	struct gltf_document **out);

/* Releases a document; NULL is allowed. */
void gltf_document_close(struct gltf_document *document);

/* The root object, which the document owns. */
json_t *gltf_document_json(const struct gltf_document *document);

/*
 * Returns the bytes of the file, of its buffers in other files, and of the
 * image files that were read so far.
 */
size_t gltf_document_bytes(const struct gltf_document *document);

int gltf_document_array_count(const struct gltf_document *document);

/*
 * Returns how an accessor is stored. index is its number, below
 * gltf_document_array_count().
 */
struct gltf_document_array gltf_document_array(
	const struct gltf_document *document, int index);

/*
 * Writes count * width components as they are stored: normalised integers keep
 * their values of -127..127 and so on. Returns 0, or -EINVAL after logging an
 * error about a float that is not finite or larger than MODEL_NUMBER_MAX.
 */
int gltf_document_floats(
	const struct gltf_document *document, int index, float *out);

/* The same of an array of unsigned integers that are not normalised. */
void gltf_document_uints(
	const struct gltf_document *document, int index, uint32_t *out);

/*
 * Sets *data and *size to the bytes of an image, from its buffer view or its
 * URI. The document owns the bytes. Returns 0, or -errno after logging a
 * warning and no error, since limber plays a model whose unused images are
 * missing.
 */
int gltf_document_image(struct gltf_document *document, int image,
	const uint8_t **data, size_t *size);

#endif
