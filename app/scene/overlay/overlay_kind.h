/*
 * The overlays that can be chosen, and the text that chooses them (--show).
 */
#ifndef APP_SCENE_OVERLAY_OVERLAY_KIND_H
#define APP_SCENE_OVERLAY_OVERLAY_KIND_H

#include <stdbool.h>

enum overlay_kind {
	OVERLAY_SKELETON,  /* the bones, over the skin */
	OVERLAY_WEIGHTS,   /* the weights of the chosen joint, as heat */
	OVERLAY_WIREFRAME, /* the triangles' edges */
	OVERLAY_KEYS,      /* key frames, as onion skins */
	OVERLAY_PIVOTS,    /* the nodes' frames, with their axes */
	OVERLAY_CURVE,     /* the interpolation with its running point */
	OVERLAY_LAYERS,    /* the layers' weights, and a mask as heat */
	OVERLAY_KINDS
};

enum {
	OVERLAY_NAME_BYTES = 64
};

/* A bit 1 << kind for each overlay; all zero: none. */
struct overlay_choice {
	unsigned kinds;
	char joint[OVERLAY_NAME_BYTES]; /* "": the overlay chooses one */
};

/* Returns the name of an overlay, such as "skeleton". */
const char *overlay_kind_name(enum overlay_kind kind);

/*
 * Parses names separated by commas, "all" or "none". "weights:NAME" chooses the
 * joint, the part or the morph target NAME. Returns false for anything else.
 */
bool overlay_choice_parse(const char *text, struct overlay_choice *out);

#endif
