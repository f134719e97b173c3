/*
 * Pictures from memory into the model's pixels: PNG and JPEG, told apart by
 * their content.
 */
#ifndef APP_MODEL_IMAGE_IMAGE_H
#define APP_MODEL_IMAGE_IMAGE_H

#include "app/model/model.h"

enum {
	IMAGE_SIDE_MAX = 4096 /* pixels; 64 MiB when square */
};

/*
 * Decodes a picture into width, height, opaque and rgba, which the arena owns;
 * leaves name alone. Colour space information is ignored, as glTF 2.0 (3.9.2)
 * demands: the values are taken as they are. Grey, palette and 16-bit pictures
 * are converted. A JPEG that is damaged but readable gives a warning.
 *
 * 0, or -errno after one sentence that begins with where ("fox.gltf:
 * /images/0"): -EINVAL for a broken picture, -ENOTSUP for another format,
 * -EFBIG beyond IMAGE_SIDE_MAX, -ENOMEM.
 */
int image_decode(const uint8_t *data, size_t size, const char *where,
	const struct log *log, struct arena *arena, struct model_image *out);

/*
 * Only the size of a picture, with the same errors; what image_decode() will
 * take from its arena is width * height * 4.
 */
int image_measure(const uint8_t *data, size_t size, const char *where,
	const struct log *log, int *width, int *height);

#endif
