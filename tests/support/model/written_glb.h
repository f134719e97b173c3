/* A binary glTF file as limber exports it, taken apart again. */
#ifndef TESTS_SUPPORT_MODEL_WRITTEN_GLB_H
#define TESTS_SUPPORT_MODEL_WRITTEN_GLB_H

#include "app/compare/export/glb.h"

struct written_glb {
	uint8_t *data;
	json_t *root;          /* its JSON */
	const uint8_t *binary; /* the begin of its binary chunk */
};

/* Writes and ends the file, whose JSON is below 64 KiB. */
struct written_glb written_glb_take(struct glb *glb);

void written_glb_release(struct written_glb *written);

/* The JSON of the member, with ' for ", is that; "": there is none. */
void written_glb_expect(const struct written_glb *written, const char *name,
	const char *wanted);

#endif
