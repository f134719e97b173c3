/*
 * Which vertices of two instances are the same vertex of the file.
 *
 * A large primitive is divided when it is loaded, by the places of its vertices
 * (model/split/split.h). Rounded places divide it differently, so that the
 * instances number its vertices differently.
 */
#ifndef APP_COMPARE_OPTIMIZE_OPTIMIZE_MATCH_H
#define APP_COMPARE_OPTIMIZE_OPTIMIZE_MATCH_H

#include "app/scene/instance/instance.h"

/*
 * Writes the number of wanted's vertex to source[v] for each vertex v of found,
 * both as posed_vertices.h numbers them. Returns 0, -ENOMEM, or -EINVAL if the
 * files of both have not the same primitives with as many vertices.
 */
int optimize_match(const struct instance *wanted, const struct instance *found,
	int *source);

#endif
