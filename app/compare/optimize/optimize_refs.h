/*
 * The numbers by which the parts of a glTF file refer to each other.
 *
 * One function knows where they stand, and both the search for unused parts and
 * their renumbering use it.
 */
#ifndef APP_COMPARE_OPTIMIZE_OPTIMIZE_REFS_H
#define APP_COMPARE_OPTIMIZE_OPTIMIZE_REFS_H

#include <stdbool.h>

#include <jansson.h>

enum optimize_part {
	OPTIMIZE_NODES,
	OPTIMIZE_MESHES,
	OPTIMIZE_SKINS,
	OPTIMIZE_CAMERAS,
	OPTIMIZE_MATERIALS,
	OPTIMIZE_TEXTURES,
	OPTIMIZE_IMAGES,
	OPTIMIZE_SAMPLERS,
	OPTIMIZE_PARTS,
	OPTIMIZE_SCENES = OPTIMIZE_PARTS
};

/* The name of the root object's array of each part, and of the scenes. */
extern const char *const optimize_part_name[OPTIMIZE_PARTS + 1];

/* Returns the number to write instead of index. */
typedef int (*optimize_ref)(void *context, enum optimize_part part, int index);

/* Calls ref for each number in an element of the array of this part. */
void optimize_refs_of(enum optimize_part part, json_t *element,
	optimize_ref ref, void *context);

/*
 * Removes from the whole document the extensions whose references are unknown,
 * and their names from extensionsUsed. Calls removed for each name there.
 */
void optimize_strip_extensions(json_t *root,
	void (*removed)(void *context, const char *name), void *context);

/* Whether string ends with end. */
bool optimize_ends_with(const char *string, const char *end);

#endif
