/* Names of a model in a character file. */
#ifndef APP_CHARACTER_SKETCH_SKETCH_NAMES_H
#define APP_CHARACTER_SKETCH_SKETCH_NAMES_H

#include "app/model/model.h"

#include <stdio.h>

/* Writes a name, in quotes if it has blanks or commas. */
void sketch_write_name(FILE *out, const char *name);

/* Whether a character file can hold the name, and a terminal show it. */
bool sketch_is_usable(const char *name);

/* Whether it is so short that it can stand in the heading of a section. */
bool sketch_fits_heading(const char *name);

/*
 * Returns [node_count] from the arena: whether a file can hold a node's name,
 * and no earlier node has it. NULL without memory.
 */
bool *sketch_find_named_nodes(const struct model *model, struct arena *arena);

/*
 * Writes the name of a clip, or its number if a file cannot hold the name or an
 * earlier clip has it.
 */
void sketch_write_clip(FILE *out, const struct model *model, int clip);

/* The same for a morph target. */
void sketch_write_target(FILE *out, const struct model_mesh *mesh, int target);

/*
 * Writes the name of a section about a clip: that of the clip, or "clip 3" for
 * one without a usable or with a long name, unless a clip is called that.
 */
void sketch_write_heading(FILE *out, const struct model *model, int clip);

#endif
