/*
 * Decoding of PNG and JPEG images in memory into the pixels of a model. The
 * content decides which of the two an image is.
 */
#ifndef APP_MODEL_IMAGE_IMAGE_H
#define APP_MODEL_IMAGE_IMAGE_H

#include "app/model/model.h"

enum {
	IMAGE_SIDE_MAX = 4096, /* pixels of a file's image */
	IMAGE_SIDE_USED = 1024 /* the largest side that textures have */
};

/*
 * Decodes an image into *out; the arena owns rgba, and name stays as it is. An
 * image is halved while both its sides are at least twice IMAGE_SIDE_USED: one
 * of 4096 x 4096 pixels takes 4 MiB instead of 64. It ignores colour profiles,
 * as glTF 2.0 (3.9.2) requires, and converts grey, palette and 16-bit images to
 * 8-bit RGBA. A damaged JPEG that can still be decoded causes a warning.
 *
 * Returns 0, or -errno after one error that begins with where ("fox.gltf:
 * /images/0"): -EINVAL for a broken image, -ENOTSUP for another format, -EFBIG
 * beyond IMAGE_SIDE_MAX, -ENOMEM. After success, the arena's budget has lost
 * image_held_bytes(), too.
 */
int image_decode(const uint8_t *data, size_t size, const char *where,
	const struct log *log, struct arena *arena, struct model_image *out);

/*
 * What an image takes from the budget until its model is loaded: a byte for
 * each pixel of the file, less those of rgba. So the budget also bounds the
 * time that small files can ask for, 256 MiB about a minute on the board.
 */
size_t image_held_bytes(const struct model_image *image);

#endif
