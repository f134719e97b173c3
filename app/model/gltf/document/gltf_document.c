#include "app/model/gltf/document/gltf_document.h"

#include "app/model/gltf/gltf_internal.h"

#include <errno.h>
#include <stdlib.h>

struct gltf_document {
	struct gltf gltf;
	struct model_source source;
	struct log log;
	int image_count;
	struct document_image {
		bool read; /* the members below are set */
		int error; /* result of reading the image */
		struct model_file file;
		const uint8_t *data;
		size_t size;
	} * image; /* [image_count] */
};

static int prepare_images(struct gltf_document *document)
{
	struct gltf_at array;
	int error = gltf_array(
		&document->gltf.root, "images", &array, &document->image_count);

	if (!error) {
		document->image = GLTF_SCRATCH(
			&array, struct document_image, document->image_count);
		error = document->image ? 0 : -ENOMEM;
	}
	if (error) {
		document->image_count = 0;
	}
	return error;
}

int gltf_document_open(const struct model_source *source, const struct log *log,
	struct gltf_document **out)
{
	struct gltf_document *document = calloc(1, sizeof(*document));
	int error;

	*out = NULL;
	if (!document) {
		log_error(log, "%s: there is not enough memory to read it",
			source->name);
		return -ENOMEM;
	}
	document->source = *source;
	document->log = *log;
	document->log.threshold = LOG_ERROR;
	error = gltf_read_document(
		&document->gltf, &document->source, &document->log);
	document->log.threshold = log->threshold;
	if (!error) {
		error = prepare_images(document);
	}
	if (error) {
		gltf_document_close(document);
		return error;
	}
	*out = document;
	return 0;
}

void gltf_document_close(struct gltf_document *document)
{
	if (document) {
		struct model *model = document->gltf.model;

		for (int i = 0; i < document->image_count; i++) {
			model_file_release(&document->image[i].file);
		}
		gltf_release(&document->gltf);
		model_destroy(model);
		free(document);
	}
}

json_t *gltf_document_json(const struct gltf_document *document)
{
	return document->gltf.json;
}

size_t gltf_document_bytes(const struct gltf_document *document)
{
	size_t bytes = document->source.size;

	for (int i = 0; i < document->gltf.buffer_count; i++) {
		bytes += document->gltf.buffer[i].file.size;
	}
	for (int i = 0; i < document->image_count; i++) {
		bytes += document->image[i].file.size;
	}
	return bytes;
}

int gltf_document_array_count(const struct gltf_document *document)
{
	return document->gltf.accessor_count;
}

static size_t stored_bytes(const struct gltf_accessor *accessor)
{
	size_t element = gltf_element_bytes(accessor);
	/* Attributes are aligned to 4 bytes. */
	size_t aligned =
		accessor->width > 1 ? (element + 3) & ~(size_t)3 : element;
	size_t sparse = accessor->sparse_count > 0 ? element +
			gltf_component_bytes(accessor->sparse_index.component)
						   : 0;

	return (accessor->base.data ? (size_t)accessor->count * aligned : 0) +
		(size_t)accessor->sparse_count * sparse;
}

struct gltf_document_array gltf_document_array(
	const struct gltf_document *document, int index)
{
	const struct gltf_accessor *accessor = &document->gltf.accessor[index];

	return (struct gltf_document_array){
		.count = accessor->count,
		.width = accessor->width,
		.rows = accessor->rows < accessor->width ? accessor->rows : 0,
		.component = (int)accessor->base.component,
		.normalized = accessor->normalized,
		.bytes = stored_bytes(accessor),
	};
}

int gltf_document_floats(
	const struct gltf_document *document, int index, float *out)
{
	struct gltf_accessor raw = document->gltf.accessor[index];
	struct gltf *gltf = (struct gltf *)&document->gltf;
	struct gltf_at array = gltf_member(&gltf->root, "accessors");
	struct gltf_at at = gltf_element(&array, index);

	raw.normalized = false;
	return gltf_unpack_floats(&at, &raw, out);
}

void gltf_document_uints(
	const struct gltf_document *document, int index, uint32_t *out)
{
	gltf_unpack_uints(&document->gltf.accessor[index], out);
}

static int read_image(
	struct gltf_document *document, int image, struct document_image *out)
{
	struct gltf *gltf = &document->gltf;
	struct gltf_at array = gltf_member(&gltf->root, "images");
	struct gltf_at at, uri_at;
	const char *uri = NULL;
	int view = -1;
	int error = gltf_item(&array, image, &at);

	if (!error) {
		error = gltf_maybe_index(&at, "bufferView", gltf->view_count,
			"bufferView", &view);
	}
	if (!error) {
		error = gltf_maybe_string(&at, "uri", &uri);
	}
	if (error) {
		return error;
	}
	if (view >= 0) {
		out->data = gltf->view[view].data;
		out->size = gltf->view[view].size;
		return 0;
	}
	if (!uri) {
		return gltf_fail(
			&at, -EINVAL, "has neither a uri nor a bufferView");
	}
	uri_at = gltf_member(&at, "uri");
	return gltf_read_uri(&uri_at, uri, &out->file, &out->data, &out->size);
}

static void write_warning(void *user, enum log_level level, const char *sentence)
{
	log_write(
		user, level == LOG_ERROR ? LOG_WARNING : level, "%s", sentence);
}

int gltf_document_image(struct gltf_document *document, int image,
	const uint8_t **data, size_t *size)
{
	struct document_image *out = &document->image[image];
	const struct log *log = document->gltf.log;
	const struct log lenient = {
		.write = write_warning,
		.user = (void *)log,
		.threshold = log->threshold,
	};

	if (!out->read) {
		document->gltf.log = &lenient;
		out->error = read_image(document, image, out);
		document->gltf.log = log;
		out->read = true;
	}
	*data = out->data;
	*size = out->size;
	return out->error;
}
