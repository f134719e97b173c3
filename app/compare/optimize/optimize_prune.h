/*
 * Removes unused parts of a glTF file.
 */
#ifndef APP_COMPARE_OPTIMIZE_OPTIMIZE_PRUNE_H
#define APP_COMPARE_OPTIMIZE_OPTIMIZE_PRUNE_H

#include <jansson.h>

/*
 * Removes nodes that no scene, skin, camera or level of detail needs, meshes,
 * skins and materials that no node needs, textures, images and samplers that no
 * material needs, texture coordinates and tangents that no texture needs, and
 * channels of removed nodes; then renumbers the rest. A clip that moves a node
 * keeps its duration: the node of its last channel stays. A file without scenes
 * keeps all nodes. Returns 0 or -ENOMEM.
 */
int optimize_prune(json_t *root);

#endif
