/*
 * The indices by which the parts of a glTF file refer to each other.
 *
 * One function knows where these indices are. The search for unused parts uses
 * it, and so does renumbering.
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

/* The member of the root object that is the array of each part. */
extern const char *const optimize_part_name[OPTIMIZE_PARTS + 1];

/* Called with a reference; returns the index to write instead of index. */
typedef int (*optimize_ref)(void *context, enum optimize_part part, int index);

/*
 * Calls ref for each reference to a part in element, which is an element of the
 * array of this part.
 */
void optimize_refs_of(enum optimize_part part, json_t *element,
	optimize_ref ref, void *context);

/*
 * Removes all extensions that limber does not know, since they may refer to
 * parts by index, and their names from extensionsUsed. Calls removed for each
 * name.
 */
void optimize_strip_extensions(json_t *root,
	void (*removed)(void *context, const char *name), void *context);

/* Whether string ends with end. */
bool optimize_ends_with(const char *string, const char *end);

/*
 * Finds the nodes that keep their keys though no vertex may follow them: those
 * that another program shows or reads, because they have a mesh (of lines,
 * say), a camera, extensions such as a light, or extras, and those whose name
 * occurs in the text named, which may be NULL. Returns an array of all nodes,
 * which the caller frees, or NULL without memory.
 */
bool *optimize_find_needed(const json_t *root, const char *named);

#endif
