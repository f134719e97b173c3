/*
 * Levels of detail that were made in advance: the file NAME.levels beside the
 * model NAME.glb. Making levels takes a third of a second on the board for
 * 4,000 triangles, reading them a few milliseconds.
 *
 * The file has numbers of 32 bits, least significant byte first: FORMAT, the
 * hash of the model, the number of primitives; for each primitive the number of
 * lists; for each list its error (a float), its kind, its number of indices and
 * the indices, of 16 bits unless the primitive has more than 65,536 vertices.
 * The kind is 1 for shadows. It is 2 in a primitive without normals: then
 * places in the primitive's index (model_lod.corner) are written instead of
 * indices, of 16 bits unless that is longer than 65,536. Lists of an odd number
 * of short numbers end with a zero.
 */
#ifndef APP_MODEL_LEVELS_LEVELS_FILE_H
#define APP_MODEL_LEVELS_LEVELS_FILE_H

#include "app/model/model.h"
#include "platform/base/log.h"

#include <stdio.h>

/*
 * Makes the levels of a loaded model (levels.h) and writes them. Returns 0 or
 * -ENOMEM; the caller checks the stream for errors of writing.
 */
int levels_write(struct model *model, FILE *out);

/*
 * Gives a loaded model the levels of a file's bytes. Returns 0, or leaves the
 * levels unchanged and returns -EINVAL if the bytes are damaged or belong to
 * other vertices, targets, triangles or lists of the file, -ENOMEM without
 * memory or if the model's budget is exceeded.
 */
int levels_read(struct model *model, const uint8_t *data, size_t size);

/*
 * Prepares a loaded model for drawing. It drops parts without triangles
 * (split_drop_unused()) and gives the others levels: it reads the file beside
 * the model or, if there is none, makes them. If the file does not fit the
 * model, it logs a warning and makes the levels. Returns 0, or -ENOMEM after an
 * error on the log.
 */
int levels_prepare(struct model *model, const struct log *log);

#endif
