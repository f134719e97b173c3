/* A binary glTF file as limber exports it, taken apart again. */
#ifndef TESTS_SUPPORT_MODEL_WRITTEN_GLB_H
#define TESTS_SUPPORT_MODEL_WRITTEN_GLB_H

#include "app/compare/export/glb.h"

struct written_glb {
	uint8_t *data;         /* the whole file */
	json_t *root;          /* its JSON */
	const uint8_t *binary; /* the content of its binary chunk, in data */
};

/* Writes glb into memory, which ends glb. Its JSON must be below 64 KiB. */
struct written_glb written_glb_take(struct glb *glb);

void written_glb_release(struct written_glb *written);

/*
 * Fails the test unless the file's member of that name, as compact JSON with '
 * in place of ", is as wanted; "" stands for no such member.
 */
void written_glb_expect(const struct written_glb *written, const char *name,
	const char *wanted);

#endif
